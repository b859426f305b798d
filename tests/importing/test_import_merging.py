"""Merging touches nothing but the place where an answer is missing."""

from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.importing.answer import Sources
from codegen.importing.comparison import compare
from codegen.importing.document import find_fields
from codegen.importing.existing import table_of
from codegen.importing.merging import Merged, merge
from codegen.importing.proposal import propose

DOCUMENT = """BATTERY_STATUS:

- `id`: 0
- `type`: 1
- `temperature`: INT16_MAX
- `voltages`: unknown
- `battery_remaining`: -1
- `mode`: 0
"""


def merged(table: str, sources: Sources) -> tuple[Merged | None, list[str]]:
    report = Report()
    found = find_fields(DOCUMENT, "/doc.md", None, sources.dialect, report)
    assert found is not None
    existing = table_of(table, "/t.yaml", found.message, report)
    assert existing is not None
    rows = compare(propose(found.lists, found.message, sources, report), existing.answers, sources)
    result = merge(table, "/t.yaml", found.message, rows, "FR-1", report)
    return result, [f"{finding.rule.id}:{finding.place.line}" for finding in report]


TABLE = """# a comment of people
message: BATTERY_STATUS   # odd   spacing stays
requirement: 'FR-1'
fields:
  # about the number
  id: {constant: 0}

  voltages:
    state: battery.voltage

    split: true
    note: >-
      several
      lines
  # about the charge
  battery_remaining:   {state: battery.remaining,
      min: 0}
overlay: x.xml
"""


def test_missing_answers_are_put_where_they_belong(plain: Sources) -> None:
    result, findings = merged(TABLE, plain)
    assert result is not None
    assert findings == []
    assert result.added == ("type", "temperature", "mode")
    assert result.text == TABLE.replace(
        "  id: {constant: 0}\n",
        "  id: {constant: 0}\n  type: {enum: MAV_BATTERY_TYPE_LIPO}  # FR-1 line 4\n  temperature: unknown  # FR-1 line 5\n",
    ).replace("      min: 0}\n", "      min: 0}\n  mode: {enum: MAV_BATTERY_MODE_UNKNOWN}  # FR-1 line 8\n")


@pytest.mark.parametrize("end", ["\n", "\r\n", ""])
def test_the_ends_of_lines_stay(plain: Sources, end: str) -> None:
    newline = end or "\n"
    table = (
        newline.join(["message: BATTERY_STATUS", "requirement: FR-1", "fields:", "    battery_remaining: unknown"])
        + end
    )
    result, _ = merged(table, plain)
    assert result is not None
    lines = result.text.split(newline)
    assert lines[3].startswith("    id: {constant: 0}  # FR-1 line 3")
    assert lines[7] == "    battery_remaining: unknown"
    assert lines[8].startswith("    mode: ")
    removed = [line for line in lines if "# FR-1 line" not in line]
    assert newline.join(removed).rstrip() == table.rstrip()
    assert ("\r" in result.text) == ("\r" in end)
    assert result.text.count("\n") == result.text.count(newline)


def test_a_comment_above_the_first_field_stays_with_it(plain: Sources) -> None:
    table = "message: BATTERY_STATUS\nrequirement: FR-1\nfields:\n  # about all\n  voltages: unknown\n"
    result, _ = merged(table, plain)
    assert result is not None
    assert "unknown  # FR-1 line 5\n  # about all\n  voltages" in result.text


def test_nothing_is_added_twice(plain: Sources) -> None:
    once, _ = merged(TABLE, plain)
    assert once is not None
    again, _ = merged(once.text, plain)
    assert again == Merged(once.text, ())


def test_elements_that_are_missing_are_added(plain: Sources) -> None:
    table = "message: BATTERY_STATUS\nrequirement: FR-1\nfields:\n  voltages[1..9]: unknown\n"
    result, _ = merged(table, plain)
    assert result is not None
    assert "voltages" not in result.added, "the document answers for all of them, the table for some: that differs"


@pytest.mark.parametrize(
    "fields",
    ["fields: {id: {constant: 0}}\n", "fields: {\n  id: {constant: 0},\n  voltages: unknown\n}\n"],
)
def test_a_table_in_another_form_is_left_alone(plain: Sources, fields: str) -> None:
    result, findings = merged(f"message: BATTERY_STATUS\nrequirement: FR-1\n{fields}", plain)
    assert result is None
    assert [finding.split(":")[0] for finding in findings] == ["merge-form"]


def test_the_shipped_tables_take_back_what_is_removed(sources: Sources) -> None:
    """Every field of a real table that a document mentions is found missing, and put back at its place."""
    path = Path(__file__).parents[2] / "specs" / "messages" / "battery_status.yaml"
    text = path.read_text()
    for field in ("id", "type", "temperature", "battery_remaining"):
        line = next(line for line in text.splitlines(keepends=True) if line.startswith(f"  {field}: "))
        result, _ = merged(text.replace(line, ""), sources)
        assert result is not None
        assert result.added == (field,)
        lines = result.text.splitlines(keepends=True)
        assert lines[: text[: text.index(line)].count("\n")] == text[: text.index(line)].splitlines(keepends=True)
        assert [one for one in lines if "# FR-1" not in one] == text.replace(line, "").splitlines(keepends=True)
