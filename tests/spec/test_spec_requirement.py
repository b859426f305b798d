"""Requirement documents: id, metadata, links and numbered criteria with their lines, and what can be wrong there."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from codegen.decode.requirement import check_unique, decode_requirement
from codegen.diagnostics import Report
from codegen.load.markdown import parse_markdown
from codegen.model.spec.spec import Requirement
from codegen.source import Place

FILE = "/specs/requirements/FR-00001.md"
GOOD = """\
# FR-00068 | Battery `telemetry`

## Metadata

- Type: Functional Requirement
- Status: Approved
- Aliases: FR-zxxlp, FR-0a

## Links

- Decided in: [ADR-97ebh-architecture](../ADR-97ebh-architecture.md)
- Needs:
  - FR-00069, NFR-00060
  - FR-00069 again

## Acceptance Criteria

Some words first.

> 7. a quotation

1. [ ] The message is *sent* at
   `2 Hz`.
2. [x] Unknown values:
   - current
   - charge

### For receivers

 3. It is ~shown~.

## Notes

1. not a criterion
"""


def decoded(text: str) -> tuple[Requirement | None, list[tuple[str, int, int]]]:
    report = Report()
    requirement = decode_requirement(parse_markdown(text, FILE), report)
    return requirement, [(d.rule.id, d.place.line, d.place.column) for d in report]


def document(body: str, heading: str = "# FR-00001 | Title", status: str = "- Status: Draft\n") -> str:
    """A document whose body begins in line 7."""
    return f"{heading}\n\n## Metadata\n\n{status or chr(10)}\n{body}"


def test_a_document_is_read_with_its_places() -> None:
    requirement, findings = decoded(GOOD)
    assert findings == []
    assert requirement is not None
    assert requirement.id == "FR-00068"
    assert requirement.title == "Battery telemetry"
    assert requirement.status == "Approved"
    assert requirement.aliases == ("FR-zxxlp", "FR-0a")
    assert requirement.links == ("ADR-97ebh", "FR-00069", "NFR-00060")
    assert [(c.number, c.text, c.place) for c in requirement.criteria] == [
        (1, "The message is sent at 2 Hz.", Place(FILE, 22, 1)),
        (2, "Unknown values: - current - charge", Place(FILE, 24, 1)),
        (3, "It is ~shown~.", Place(FILE, 30, 2)),
    ]
    assert requirement.place == Place(FILE, 1, 1)
    assert requirement.at("status") == Place(FILE, 6, 1)
    assert requirement.at("aliases[1]") == Place(FILE, 7, 1)


def test_line_ends_do_not_shift_the_lines() -> None:
    requirement, _ = decoded(GOOD.replace("\n", "\r\n"))
    assert requirement is not None
    assert [c.place.line for c in requirement.criteria] == [22, 24, 30]


def test_a_decision_lends_its_numbered_items_as_criteria() -> None:
    body = "## Decision\n\n- why\n\n1. a\n2. b\n"
    requirement, findings = decoded(document(body, "# ADR-1a | T"))
    assert findings == []
    assert requirement is not None
    assert [c.text for c in requirement.criteria] == ["a", "b"]
    requirement, _ = decoded(document(body + "\n## Acceptance Criteria\n\n1. c\n", "# ADR-1a | T"))
    assert requirement is not None
    assert [c.text for c in requirement.criteria] == ["c"]
    assert decoded(document("", "# ADR-1a | T"))[1] == []


CRITERIA = "## Acceptance Criteria\n\n"
BROKEN = [
    ("", [("requirement-title", 1, 1)]),
    ("text only\n", [("requirement-title", 1, 1)]),
    ("> # FR-00001 | quoted\n", [("requirement-title", 1, 1)]),
    (document(f"{CRITERIA}1. a\n", "# A title without id"), [("requirement-title", 1, 1)]),
    (document(f"{CRITERIA}1. a\n", "# fr-00001 | Title"), [("requirement-title", 1, 1)]),
    (document(f"{CRITERIA}1. a\n", "# FR-00001 |"), [("requirement-title", 1, 1)]),
    (document(f"{CRITERIA}1. a\n\n# FR-2 | Second\n"), [("requirement-title", 11, 1)]),
    (document(f"{CRITERIA}1. a\n", status=""), [("requirement-status", 1, 1)]),
    (document(f"{CRITERIA}1. a\n", status="- Status:\n"), [("requirement-status", 1, 1)]),
    (document(f"{CRITERIA}1. a\n", status="- Status: A\n- Status: B\n"), [("requirement-metadata", 6, 1)]),
    (document(f"{CRITERIA}1. a\n", status="- Status: A\n- Aliases: FR-1, xy\n"), [("requirement-metadata", 6, 1)]),
    (document(f"{CRITERIA}1. a\n", status="- Status: A\n- Aliasses: FR-1\n"), [("metadata-spelling", 6, 1)]),
    (document(""), [("requirement-without-criteria", 1, 1)]),
    (document("", "# NFR-1 | Title"), [("requirement-without-criteria", 1, 1)]),
    (document(f"{CRITERIA}Words only.\n"), [("requirement-without-criteria", 1, 1)]),
    (document("", "# REQ-2 | Title"), [("document-without-criteria", 1, 1)]),
    (document("## Acceptance Criterias\n\n1. a\n", "# REQ-2 | Title"), [("section-spelling", 7, 1)]),
    (
        document("## Acceptance Criterion:\n\n1. a\n"),
        [("requirement-without-criteria", 1, 1), ("section-spelling", 7, 1)],
    ),
    (document("## Words\n\n### Acceptance criteria\n\n1. a\n", "# REQ-2 | T"), [("section-spelling", 9, 1)]),
    (document("## Decisions\n\n1. a\n", "# ADR-2 | Title"), [("section-spelling", 7, 1)]),
    (
        document(f"{CRITERIA}1. a\n\n## Link\n\n- FR-2\n\n## What the host cannot show\n"),
        [("section-spelling", 11, 1), ("section-spelling", 15, 1)],
    ),
    (document(f"{CRITERIA}- a\n- b\n"), [("criterion-number", 9, 1), ("criterion-number", 10, 1)]),
    (document(f"{CRITERIA}0. a\n1. b\n"), [("criterion-number", 9, 1)]),
    (document(f"{CRITERIA}1. a\n1. b\n"), [("criterion-number", 10, 1)]),
    (document(f"{CRITERIA}1. a\n2. b\n4. c\n5. d\n"), [("criterion-number", 11, 1)]),
    (document(f"{CRITERIA}1. a\n- b\n"), [("criterion-number", 10, 1)]),
    (document(f"{CRITERIA}1. a\n\n### More\n\n  1. b\n"), [("criterion-number", 13, 3)]),
    (document(f"{CRITERIA}1. a\n\nExcept on Sundays.\n\n2. b\n"), [("text-outside-criteria", 11, 1)]),
    (document(f"{CRITERIA}1. a\n\nAll of this.\n\n    v = 1\n"), [("text-outside-criteria", 11, 1)]),
    (document(f"{CRITERIA}1. a\n\n  > 7 m\n"), [("text-outside-criteria", 11, 3)]),
    (
        document(f"{CRITERIA}1. a\n\n```text\nv = 1\n```\n\n2. b\n\n|a|\n|-|\n"),
        [("text-outside-criteria", 11, 1), ("text-outside-criteria", 17, 1)],
    ),
    (document(f"{CRITERIA}1. a\n\n<p>Not on Sundays</p>\n"), [("text-outside-criteria", 11, 1)]),
    (document(f"{CRITERIA}1.\n2. <!-- b -->\n"), [("criterion-text", 9, 1), ("criterion-text", 10, 1)]),
]


@pytest.mark.parametrize(("text", "expected"), BROKEN, ids=range(len(BROKEN)))
def test_each_mistake_has_its_rule_and_place(text: str, expected: list[tuple[str, int, int]]) -> None:
    """The numbers compared are the written ones; Markdown itself would count on from the first."""
    assert decoded(text)[1] == expected


@pytest.mark.parametrize(
    "heading", ["### Links", "## Lines", "## Decisions", "## Acceptance", "> ## Metadat", "- ## Link"]
)
def test_headings_that_mean_something_else(heading: str) -> None:
    """Below another heading a section may have any name, if the document has the one that is read."""
    body = f"## Links\n\n- FR-2\n\n{CRITERIA}1. a\n\n## Words\n\n{heading}\n\n- b\n"
    assert decoded(document(body))[1] == []


INSIDE = [
    (
        "The limits are:\n   - below 1.5 m: stop\n   * below 3 m: warn",
        "The limits are: - below 1.5 m: stop - below 3 m: warn",
    ),
    ("The formula is:\n\n   ```text\n   v = a *  b\n   ```\n", "The formula is: v = a * b"),
    ("The formula is:\n\n       v = *a*\n", "The formula is: v = *a*"),
    ("Steps:\n   1. open\n   2) close\n      - wide", "Steps: 1. open 2. close - wide"),
    ("A quote:\n   > the depth is\n   > `5 m`\n   >\n   > - [ ] or 6", "A quote: the depth is 5 m - or 6"),
    ("One.\n\n   Except on *Sundays*.", "One. Except on Sundays."),
    ("One.\nExcept on Sundays.", "One. Except on Sundays."),
    ("One.\n\n   <p>Not &lt; <b>2</b></p><!-- looked at -->\n", "One. Not < 2"),
    ("[x] - [ ] One.\n   - [x] Two.", "- [ ] One. - Two."),
    ("- [ ] One.\n   - [x] Two.", "- One. - Two."),
    ("At most:\n\n   | a | b |\n   |---|---|\n   | 1 | 2 |", "At most: | a | b | |---|---| | 1 | 2 |"),
]


@pytest.mark.parametrize(("written", "text"), INSIDE)
def test_all_that_is_in_an_item_is_the_text_of_its_criterion(written: str, text: str) -> None:
    """By CommonMark: a limit in a list inside is as much asked for as one in the first paragraph."""
    body = f"{CRITERIA}Words, then:\n\n1. {written}\n\n<!-- a comment -->\n\n2. b\n\n### Notes\n\nNot a criterion.\n"
    requirement, findings = decoded(document(body))
    assert findings == []
    assert requirement is not None
    assert [each.text for each in requirement.criteria] == [text, "b"]


def test_what_lists_inside_say_of_other_criteria_and_of_the_bench_counts() -> None:
    """A dependency in a list inside, the items of a limit."""
    limits = "## What a host cannot show\n\n- Criterion 2: it is\n  - loud\n"
    body = f"{CRITERIA}1. a\n2. b\n   - (depends on criterion 1)\n\n{limits}"
    requirement, findings = decoded(document(body))
    assert findings == []
    assert requirement is not None
    assert requirement.criteria[1].depends_on == ("FR-00001.1",)
    assert [limit.text for limit in requirement.host_limits] == ["it is - loud"]


@pytest.mark.parametrize("between", ["<!-- 2 and 3 are gone -->", "### Later"])
def test_a_gap_begins_a_list_of_its_own(between: str) -> None:
    """Numbers are not used again, and pages show what is written only where a list begins with it."""
    requirement, findings = decoded(document(f"{CRITERIA}1. a\n\n{between}\n\n4. b\n5. c\n"))
    assert findings == []
    assert requirement is not None
    assert [(each.number, each.text) for each in requirement.criteria] == [(1, "a"), (4, "b"), (5, "c")]


def test_criteria_keep_their_written_numbers() -> None:
    """References by number stay right where a number is missing or doubled."""
    requirement, _ = decoded(document(f"{CRITERIA}1. a\n1. b\n4. c\n"))
    assert requirement is not None
    assert [(c.number, c.text) for c in requirement.criteria] == [(1, "a"), (4, "c")]


def test_none_is_no_alias() -> None:
    requirement, findings = decoded(document(f"{CRITERIA}1. a\n", status="- Status: A\n- Aliases: None\n"))
    assert findings == []
    assert requirement is not None
    assert requirement.aliases == ()


def test_ids_and_aliases_belong_to_one_document() -> None:
    """The later document is reported, with the place of the earlier."""
    first = decode_requirement(parse_markdown(GOOD, "/r/a.md"), Report())
    second = decode_requirement(parse_markdown(GOOD.replace("FR-0a", "FR-0b"), "/r/b.md"), Report())
    alias = GOOD.replace("# FR-00068", "# FR-0a").replace("FR-zxxlp, FR-0a", "FR-9, FR-9")
    third = decode_requirement(parse_markdown(alias, "/r/c.md"), Report())
    assert first
    assert second
    assert third
    report = Report()
    check_unique([first, second, third], report)
    assert [(d.rule.id, d.place, [place for place, _ in d.related]) for d in report] == [
        ("requirement-duplicate", Place("/r/b.md", 1, 1), [Place("/r/a.md", 1, 1)]),
        ("requirement-duplicate", Place("/r/b.md", 7, 1), [Place("/r/a.md", 7, 1)]),
        ("requirement-duplicate", Place("/r/c.md", 1, 1), [Place("/r/a.md", 7, 1)]),
        ("requirement-duplicate", Place("/r/c.md", 7, 1), [Place("/r/c.md", 7, 1)]),
    ]


PIECES = (
    "# ", "## ", "FR-1 | x", "Metadata", "Acceptance Criteria", "Links", "\n", "\n\n", "- ", "1. ", "2) ", "   ", "> ",
    "Status: ", "Aliases: ", ", ", "[ ] ", "[a](b)", "`", "*", "<b>", "&amp;", "\t", "\r", "\0", "![x](", "===", "|",
)  # fmt: skip


@settings(max_examples=400)
@given(st.text() | st.lists(st.sampled_from(PIECES), max_size=40).map("".join))
def test_no_text_raises(text: str) -> None:
    requirement, findings = decoded(text)
    assert requirement is not None or findings
    assert all(1 <= line <= text.count("\n") + text.count("\r") + 1 for _, line, _ in findings)


def test_a_bullet_among_criteria_may_belong_to_the_one_before() -> None:
    """Its hint has the next number, and how it becomes text of the last one."""
    report = Report()
    body = "## Acceptance Criteria\n\n1. One.\n2. Two.\n\n- Three.\n"
    decode_requirement(parse_markdown(document(body), FILE), report)
    (found,) = [each for each in report if each.message == "the criterion is a bullet"]
    assert found.hint == "number it: 3. Or indent it as the text of criterion 2 is, if it belongs to that"
