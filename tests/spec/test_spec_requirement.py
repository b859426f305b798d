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

1. [ ] The message is *sent* at
   `2 Hz`.
2. [x] Unknown values:
   - current
   - charge

> 7. a quotation

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
        (1, "The message is sent at 2 Hz.", Place(FILE, 20, 1)),
        (2, "Unknown values:", Place(FILE, 22, 1)),
        (3, "It is ~shown~.", Place(FILE, 30, 2)),
    ]
    assert requirement.place == Place(FILE, 1, 1)
    assert requirement.at("status") == Place(FILE, 6, 1)
    assert requirement.at("aliases[1]") == Place(FILE, 7, 1)


def test_line_ends_do_not_shift_the_lines() -> None:
    requirement, _ = decoded(GOOD.replace("\n", "\r\n"))
    assert requirement is not None
    assert [c.place.line for c in requirement.criteria] == [20, 22, 30]


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
    (document(f"{CRITERIA}- a\n- b\n"), [("criterion-number", 9, 1), ("criterion-number", 10, 1)]),
    (document(f"{CRITERIA}0. a\n1. b\n"), [("criterion-number", 9, 1)]),
    (document(f"{CRITERIA}1. a\n1. b\n"), [("criterion-number", 10, 1)]),
    (document(f"{CRITERIA}1. a\n2. b\n4. c\n5. d\n"), [("criterion-number", 11, 1)]),
    (document(f"{CRITERIA}1. a\n\nText.\n\n  3. b\n"), [("criterion-number", 13, 3)]),
    (document(f"{CRITERIA}1. a\n- b\n"), [("criterion-number", 10, 1)]),
]


@pytest.mark.parametrize(("text", "expected"), BROKEN, ids=range(len(BROKEN)))
def test_each_mistake_has_its_rule_and_place(text: str, expected: list[tuple[str, int, int]]) -> None:
    """The numbers compared are the written ones; Markdown itself would count on from the first."""
    assert decoded(text)[1] == expected


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
