"""Text without its markup, each character still at its place."""

from cProfile import Profile
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from codegen.load.expression import expression_before
from codegen.load.prose import CodeBlock, Passage, PassageKind, read_prose

TEXT = """\
# A *heading*

One `code span` and **strong**, 3 * 4, `a*b`, _it_, a\\_b
[a `link`](https://example.org/a_(b) "title") [PR #17](https://example.org/x/pull/17), https://example.org/#5.

> - quoted \\* item
>   goes on

| Field\\[0] | Value |
| --- | --- |
| `a` | (x \\* 2) \\| y |
Text below.

\tindented code

1. one
   ```c
   int a;
   ```
"""


def parts() -> list[Passage | CodeBlock]:
    return list(read_prose(TEXT, "/a/b.md").parts)


def test_passages_are_what_readers_see() -> None:
    assert [(part.kind, part.text) for part in parts() if isinstance(part, Passage)] == [
        (PassageKind.HEADING, "A heading"),
        (PassageKind.TEXT, "One code span and strong, 3 * 4, a*b, _it_, a_b a link ,"),
        (PassageKind.ITEM, "quoted * item goes on"),
        (PassageKind.ROW, "| Field[0] | Value |"),
        (PassageKind.ROW, "| a | (x * 2) | y |"),
        (PassageKind.ROW, "Text below."),
        (PassageKind.ITEM, "one"),
    ]


def test_code_knows_its_language_and_lines() -> None:
    codes = [part for part in parts() if isinstance(part, CodeBlock)]
    assert [(code.language, code.text, code.place[1:]) for code in codes] == [
        ("", "indented code", (14, 2)),
        ("c", "int a;", (18, 4)),
    ]


def test_each_character_stands_where_the_place_says() -> None:
    lines = TEXT.split("\n")
    for part in parts():
        for offset, character in enumerate(part.text if isinstance(part, Passage) else ""):
            place = part.place_at(offset)  # type: ignore[union-attr]
            line = lines[place.line - 1]
            assert character == (line[place.column - 1] if place.column <= len(line) else " ")


@given(st.text(alphabet="ab1 `*_\\[]()|\n#>-<&.\t\u00e9\u2028\r", max_size=120))
@settings(max_examples=150)
def test_any_text_is_read_with_places_inside_of_it(text: str) -> None:
    lines = read_prose(text, "/a").parts
    count = len(text.replace("\r\n", "\n").replace("\r", "\n").split("\n"))
    for part in lines:
        if isinstance(part, Passage):
            for offset in range(len(part.text)):
                assert 1 <= part.place_at(offset).line <= count


WORDS = (
    "BATTERY_STATUS", "MAVLink", "(#148)", "41 bytes", "at 2 Hz", "= 82 bytes/s", "|", "\n", "\n\n", "```c\n",
    "```xml\n", "```\n", '<message id="1" name="X">', '<field type="uint8_t" name="a"/>', "</message>", "as u16",
    "(x * 2)", "let a = ", "voltages[0]", "temperature", ": ", "- ", "INT16_MAX", "unknown", "3 * 4 = 13", "limit",
    "65 V", "more than", "allow", "CRC_EXTRA 03", "\u0663", "\u00b2",
    "will not be truncated", "uint16_t a[3];", "// message #147", "\t",
    "\0", "\udc80", "1e9", "((", "--- | ---",
)  # fmt: skip


@given(text=st.lists(st.sampled_from(WORDS), max_size=60).map(" ".join))
@settings(max_examples=100)
def test_no_document_stops_the_check(check: Any, text: str) -> None:
    for finding in check(text):
        assert finding.fingerprint
        assert finding.place.line <= text.count("\n") + 1


@pytest.mark.parametrize(
    "unit",
    [
        "BATTERY_STATUS is 41 bytes at 2 Hz = 82 bytes/s, ", "= 1 ", "(1+", "1 + 2 = 4, ", "[", "`a", "[a](", "\\",
        "*a", "BATTERY_STATUS allow more than 65V ", "|a|b\n",
        "```c\n// message #147\nuint8_t id;\n```\nBATTERY_STATUS\n\n",
        "`voltages`, ", "BATTERY_STATUS `voltages` ", "`battery_statux` BATTERY_STATUS. ", "BATTERY_STATUS id 5, ",
        "BATTERY_STATUZ sends BATTERY_STATUS ", "BATTERY_STATUS.voltages 5 (X), ", "- `voltages`\n",
        "| `voltages` | 1 |\n",
    ],
)  # fmt: skip
@pytest.mark.timeout(40)
def test_a_hostile_text_costs_what_it_is_long(check: Any, unit: str) -> None:
    """One of twice the length takes twice the calls, not four times as many; a search that backtracks for ever is cut."""
    shorter, longer = (calls_of(check, unit * (length // len(unit))) for length in (2_500, 5_000))
    assert longer < 3 * shorter


def calls_of(check: Any, text: str) -> int:
    """Return how many functions are called to check a text."""
    counted = Profile()
    with counted:
        check(text)
    return sum(entry.callcount for entry in counted.getstats())


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("a: 1 + 2", 3), ("(1 + 2) * 3", 9), ("2 ** 10", 1024), ("10^3 / 4", 250), ("-3 + 5", 2), ("0x10 + 1", 17),
        ("1", None), ("a + 1", None), ("5 ^ 3", None), ("1 / 0", None), ("0-255", None), ("1 +", None), ("2^99", None),
        ("f(2) + 1", None), ("3 % 2 + 1", None), ("__import__ + 1", None), ("1 + 2 | 3", None),
    ],
)  # fmt: skip
def test_arithmetic_is_worked_out_or_left_alone(text: str, value: Any) -> None:
    found = expression_before(text, len(text))
    assert (None if found is None else found.value) == value
