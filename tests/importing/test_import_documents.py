"""Whole documents: which message they are about, what becomes of their rows, what they leave out."""

from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.importing.answer import Sources
from codegen.importing.comparison import Verdict, compare
from codegen.importing.document import document_id, find_fields
from codegen.importing.existing import table_of
from codegen.importing.of_system import answers_of, sources_of
from codegen.importing.proposal import Proposal, not_answered_by, propose, report_unmentioned, report_unread
from codegen.importing.table_text import Heading, answer_line, table_text
from codegen.model.system import System

ROOT = Path(__file__).parents[2]

REQUIREMENT = r"""# FR-9 | Pack telemetry

The rover sends BATTERY_STATUS (#147).

## Fields

**Where the values come from:**

| Remarks            | Field             | Source                              |
| ------------------ | ----------------- | ----------------------------------- |
| a single pack      | id                | 0 (first pack)                      |
| all motors         | battery_function  | 1 (MAV_BATTERY_FUNCTION_ALL)        |
|                    | type              | 1 (MAV_BATTERY_TYPE_LIPO)           |
| nothing measures   | temperature       | INT16_MAX                           |
| sum of all cells   | voltages\[0]      | (BatteryState.voltage \* 1000) as u16 |
|                    | voltages\[1-9]    | UINT16_MAX                          |
| see the note       | current_battery   | -1 or a guess                       |
|                    | current_consumed, energy_consumed | -1                  |
"""

DECISION = """# ADR-x1 Telemetry of the pack

## Notes

**BATTERY_STATUS message:**

- One builder makes it.
- Fields:
  - `id`: 0 (first pack)
  - `battery_function`: MAV_BATTERY_FUNCTION_ALL (1)
  - `type` = MAV_BATTERY_TYPE_LIPO (1)
  - **temperature**: INT16_MAX (unknown)
  - `voltages[0]`: what the pack has
  - `voltages[1..9]`: UINT16_MAX (unknown)

**Other things:**

- `id`: something else
"""


def proposal(text: str, sources: Sources, wanted: str | None = None) -> tuple[Proposal | None, list[tuple[str, int]]]:
    report = Report()
    found = find_fields(text, "/doc.md", wanted, sources.dialect, report)
    made = None if found is None else propose(found.lists, found.message, sources, report)
    if made is not None:
        report_unmentioned(not_answered_by(made, []), made.place, report)
    return made, [(finding.rule.id, finding.place.line) for finding in report]


def test_a_table_becomes_a_population_table(sources: Sources) -> None:
    made, findings = proposal(REQUIREMENT, sources)
    assert made is not None
    assert table_text(made, Heading("FR-9", "FR-9", "battery", "EXTRA1", "../s.json")) == (
        """# yaml-language-server: $schema=../s.json
message: BATTERY_STATUS
requirement: FR-9
for_each: battery
stream: EXTRA1
fields:
  id: {state: battery.instance}  # FR-9 line 11
  battery_function: {enum: MAV_BATTERY_FUNCTION_ALL}  # FR-9 line 12
  type: {enum: MAV_BATTERY_TYPE_LIPO}  # FR-9 line 13
  temperature: unknown  # FR-9 line 14
  voltages: {state: battery.voltage, split: true}  # FR-9 lines 15, 16
  # current_battery: unknown  # FR-9 line 17: -1 or a guess
  current_consumed: unknown  # FR-9 line 18
  energy_consumed: unknown  # FR-9 line 18
  # battery_remaining: unknown  # FR-9 does not mention it
  # time_remaining: unknown  # FR-9 does not mention it
  # charge_state: {enum: MAV_BATTERY_CHARGE_STATE_UNDEFINED}  # FR-9 does not mention it
  # voltages_ext: unknown  # FR-9 does not mention it
  # mode: {enum: MAV_BATTERY_MODE_UNKNOWN}  # FR-9 does not mention it
  # fault_bitmask: {flags: []}  # FR-9 does not mention it
"""
    )
    assert findings == [("document-unanswered", 9)] * 6 + [("document-cast", 15), ("document-ambiguous", 17)]


def test_a_list_is_read_like_a_table(sources: Sources) -> None:
    made, findings = proposal(DECISION, sources)
    assert made is not None
    assert [(answer.target.label, answer.reading.answer, answer.lines) for answer in made.answers] == [
        ("id", "{state: battery.instance}", (9,)),
        ("battery_function", "{enum: MAV_BATTERY_FUNCTION_ALL}", (10,)),
        ("type", "{enum: MAV_BATTERY_TYPE_LIPO}", (11,)),
        ("temperature", "unknown", (12,)),
        ("voltages[0]", None, (13,)),
        ("voltages[1..9]", "unknown", (14,)),
    ]
    assert ("document-prose", 13) in findings


@pytest.mark.parametrize(
    ("label", "expected"),
    [("voltages[1..9]", (1, 9)), ("voltages\\[1:9]", (1, 9)), ("voltages[1 - 9]", (1, 9)), ("`voltages[1..9]`", (1, 9)),
     ("BATTERY_STATUS.voltages[2]", (2, 1)), ("voltages", (0, 10)), ("type_", (0, 1))],
)  # fmt: skip
def test_elements_are_written_in_many_ways(plain: Sources, label: str, expected: tuple[int, int]) -> None:
    made, _ = proposal(f"BATTERY_STATUS\n\n|Name|Value|\n|-|-|\n|{label}|unknown|\n", plain, "BATTERY_STATUS")
    assert made is not None
    assert [(answer.target.first, answer.target.count) for answer in made.answers] == [expected]


@pytest.mark.parametrize(
    ("row", "finding"),
    [("| voltage | 1 |", "document-field"), ("| voltages[10] | 1 |", "document-field"),
     ("| voltages[3..2] | 1 |", "document-field"), ("| temperature[0] | 1 |", "document-field"),
     ("| the rest | unknown |", "document-field"), ("| id | 1 |", "document-twice"), ("| id | 0 |", "")],
)  # fmt: skip
def test_rows_that_no_field_has_are_findings(plain: Sources, row: str, finding: str) -> None:
    text = f"BATTERY_STATUS:\n\n| Field | Value |\n| - | - |\n| id | 0 |\n| type | 1 |\n{row}\n"
    _, findings = proposal(text, plain)
    assert [rule for rule, line in findings if line == 7] == ([finding] if finding else [])


def test_several_messages_are_a_question(plain: Sources) -> None:
    text = "## SYS_STATUS\n\n- `load`: 0\n- `errors_comm`: 0\n\n## BATTERY_STATUS\n\n- `id`: 0\n- `type`: 1\n"
    made, findings = proposal(text, plain)
    assert (made, findings) == (None, [("document-message", 3)])
    for name, count in (("SYS_STATUS", 2), ("BATTERY_STATUS", 2)):
        made, _ = proposal(text, plain, name)
        assert made is not None
        assert made.message.name == name
        assert len(made.answers) == count


def test_a_message_that_nobody_names_is_a_question(plain: Sources) -> None:
    text = "- `voltages`: 0\n- `current_consumed`: -1\n- `energy_consumed`: -1\n"
    assert proposal(text, plain) == (None, [("document-message", 1)])
    assert proposal("Nothing at all.\n", plain) == (None, [("document-without-fields", 1)])
    assert proposal(text, plain, "NO_SUCH")[1] == [("document-message", 1)]


def test_a_message_is_named_by_its_number_too(plain: Sources) -> None:
    made, _ = proposal("Message #147:\n\n- `id`: 0\n- `type`: 1\n", plain)
    assert made is not None
    assert made.message.name == "BATTERY_STATUS"


def test_a_list_of_other_things_is_none_of_fields(plain: Sources) -> None:
    """Less than half of the rows are fields: a list that happens to use one of the names."""
    text = "# BATTERY_STATUS\n\n- Status: Draft\n- type: 1\n- Owner: me\n"
    assert proposal(text, plain) == (None, [("document-without-fields", 3)])


def test_an_example_is_no_answer(plain: Sources) -> None:
    text = "# BATTERY_STATUS\n\nAn example frame:\n\n- `id`: 1\n- `type`: 3\n\nWhere values come from:\n\n- `id`: 0\n- `type`: 1\n"
    for wanted in (None, "BATTERY_STATUS"):
        made, findings = proposal(text, plain, wanted)
        assert made is not None
        assert [answer.lines for answer in made.answers] == [(10,), (11,)]
        assert "document-twice" not in [rule for rule, _ in findings]


def test_the_reference_of_a_dialect_is_no_population(plain: Sources) -> None:
    """MAVLink's own pages have a column Values with the enum of a field."""
    text = "BATTERY_STATUS\n\n| Field Name | Type | Units | Values | Description |\n| - | - | - | - | - |\n| id | uint8_t | | | |\n"
    made, findings = proposal(text, plain)
    assert made is not None
    assert [answer.reading.answer for answer in made.answers] == [None]
    assert [answer_line(answer, "a.md") for answer in made.answers] == ["  # id: ...  # a.md line 5"]
    assert ("document-without-values", 3) in findings


def test_lists_end_where_their_item_ends(plain: Sources) -> None:
    text = "SYS_STATUS and BATTERY_STATUS\n\n- SYS_STATUS:\n  - load: 0\n- BATTERY_STATUS:\n  - id: 0\n  - type: 1\n"
    for name, labels in (("SYS_STATUS", ["load"]), ("BATTERY_STATUS", ["id", "type"])):
        made, _ = proposal(text, plain, name)
        assert made is not None
        assert [answer.target.label for answer in made.answers] == labels


def test_an_answer_for_more_elements_than_the_table_has_differs(plain: Sources) -> None:
    text = "BATTERY_STATUS\n\n- `voltages`: unknown\n- `id`: 0\n"
    table = "message: BATTERY_STATUS\nrequirement: FR-1\nfields:\n  voltages[1..9]: unknown\n  id: {constant: 0}\n"
    made, _ = proposal(text, plain)
    assert made is not None
    existing = table_of(table, "/t.yaml", made.message, Report())
    assert existing is not None
    assert [row.verdict for row in compare(made, existing.answers, plain)] == [Verdict.SAME, Verdict.DIFFERENT]


def test_the_nearest_text_that_fits_names_the_message(plain: Sources) -> None:
    """A text that names a message of other fields is passed over."""
    text = "# BATTERY_STATUS\n\nAs in HEARTBEAT:\n\n- `id`: 0\n- `voltages`: unknown\n"
    made, _ = proposal(text, plain)
    assert made is not None
    assert made.message.name == "BATTERY_STATUS"


def test_a_document_is_compared_with_the_table_that_there_is(system: System, sources: Sources) -> None:
    made, _ = proposal(REQUIREMENT, sources)
    assert made is not None
    message = next(one for one in system.messages if one.name == "BATTERY_STATUS")
    rows = {row.target.label: row.verdict for row in compare(made, answers_of(message), sources)}
    assert rows == {
        "id": Verdict.SAME,
        "battery_function": Verdict.SAME,
        "type": Verdict.EQUAL,  # a fact of the board that is LIPO
        "temperature": Verdict.DIFFERENT,
        "voltages": Verdict.DIFFERENT,
        "current_battery": Verdict.UNREAD,
        "current_consumed": Verdict.DIFFERENT,
        "energy_consumed": Verdict.DIFFERENT,
        "battery_remaining": Verdict.ONLY_TABLE,
        "time_remaining": Verdict.ONLY_TABLE,
        "charge_state": Verdict.ONLY_TABLE,
        "voltages_ext": Verdict.ONLY_TABLE,
        "mode": Verdict.ONLY_TABLE,
        "fault_bitmask": Verdict.ONLY_TABLE,
    }


def test_the_shipped_document_says_what_its_table_says(system: System) -> None:
    """The real thing: every row of the requirement, in inline YAML, is the same as in the population table."""
    path = ROOT / "specs" / "requirements" / "FR-00068-battery-status-telemetry.md"
    for message in system.messages:
        report = Report()
        found = find_fields(path.read_text(), str(path), message.name, system.dialect, report)
        if found is not None:
            mine = sources_of(system.dialect, system, message.component.name if message.component else None)
            rows = compare(propose(found.lists, found.message, mine, report), answers_of(message), mine)
            assert {row.verdict for row in rows} <= {Verdict.SAME, Verdict.ONLY_TABLE}
            assert sum(row.verdict is Verdict.SAME for row in rows) >= 6


def test_the_id_is_that_of_the_first_heading() -> None:
    assert document_id("# FR-00068 | Title\n", "x") == "FR-00068"
    assert document_id("text\n\n# ADR-97ebh Title\n", "x") == "ADR-97ebh"
    assert document_id("# Battery\n", "x") is None
    assert document_id("", "x") is None


def test_a_large_document_is_read_in_time(plain: Sources) -> None:
    """A thousand lists and a thousand tables, each with headings and text above it."""
    part = "## BATTERY_STATUS\n\ntext\n\n- `id`: 0\n- `type`: 1\n\n| Field | Value |\n| - | - |\n| id | 0 |\n\n"
    made, _ = proposal(part * 1000, plain)
    assert made is not None
    assert len(made.answers) == 2


def test_two_columns_of_one_meaning(sources: Sources) -> None:
    """Nobody can tell which one holds the answer."""
    text = REQUIREMENT.replace("| Remarks            |", "| Source             |")
    assert ("column-twice", 9) in proposal(text, sources)[1]


@pytest.mark.parametrize("heading", ["Value [A]", "Value (A)", "Value in A", "Value source (A)"])
def test_the_unit_of_a_heading_counts(sources: Sources, heading: str) -> None:
    """5 A went out as 5 cA. What says a unit itself, and what stands for unknown, stays as it is."""
    rows = "| current_battery | 5 |\n| battery_remaining | -1 |\n| temperature | 25 degC (fixed) |\n| type | 1 |\n"
    text = f"## BATTERY_STATUS\n\n| Field | {heading} |\n| --- | --- |\n{rows}"
    found, findings = proposal(text, sources)
    assert found is not None
    assert {answer.target.field.name: answer.reading.answer for answer in found.answers} == {
        "current_battery": "{constant: 5 A}",
        "battery_remaining": "unknown",
        "temperature": "{constant: 25 degC}",
        "type": "{enum: MAV_BATTERY_TYPE_LIPO}",
    }
    assert not [name for name, _ in findings if name != "document-unanswered"]


def test_a_unit_of_a_heading_that_is_the_fields_own_changes_nothing(sources: Sources) -> None:
    text = "## BATTERY_STATUS\n\n| Field | Value [cA] |\n| --- | --- |\n| current_battery | 5 |\n"
    found, _ = proposal(text, sources)
    assert found is not None
    assert found.answers[0].reading.answer == "{constant: 5}"


@pytest.mark.parametrize(
    "heading", ["Value (x 10)", "Value (\u00d710)", "Value [1e-3]", "Value (times 100)", "Value (/ 10)"]
)
def test_a_heading_with_a_factor_is_a_finding(sources: Sources, heading: str) -> None:
    text = f"## BATTERY_STATUS\n\n| Field | {heading} |\n| --- | --- |\n| current_battery | 5 |\n"
    assert ("column-factor", 3) in proposal(text, sources)[1]


@pytest.mark.parametrize("heading", ["Value (FR-3)", "Value (MAVLink 2)", "Value (raw)", "Value"])
def test_other_words_in_a_heading_are_none(sources: Sources, heading: str) -> None:
    text = f"## BATTERY_STATUS\n\n| Field | {heading} |\n| --- | --- |\n| current_battery | 5 |\n"
    found, findings = proposal(text, sources)
    assert found is not None
    assert found.answers[0].reading.answer == "{constant: 5}"
    assert not [name for name, _ in findings if name.startswith("column")]


TABLE = "## BATTERY_STATUS\n\n| Field | Value | Notes |\n| --- | --- | --- |\n"


def test_a_row_without_a_field_is_a_finding(sources: Sources) -> None:
    """Where cells were merged, the second value was left out without a word. A row of remarks alone is none."""
    text = f"{TABLE}| current_battery | 250 cA | |\n| | 300 cA | from v2 |\n| | | of the pack |\n"
    _, findings = proposal(text, sources)
    assert [line for name, line in findings if name == "document-row-unnamed"] == [6]


@pytest.mark.parametrize("note", ["TBD", "?", "tbc.", "to be defined"])
def test_a_note_can_leave_a_value_open(sources: Sources, note: str) -> None:
    found, findings = proposal(f"{TABLE}| current_battery | 250 cA | {note} |\n", sources)
    assert found is not None
    assert found.answers[0].reading.answer is None
    assert ("document-ambiguous", 5) in findings
    found, _ = proposal(f"{TABLE}| current_battery | 250 cA | or so says FR-3 |\n", sources)
    assert found is not None
    assert found.answers[0].reading.answer == "{constant: 250 cA}"


@pytest.mark.parametrize(
    ("header", "count"),
    [("Feld | Wert", 1), ("Element | Battery 0", 1), ("Field | Battery 0", 1), ("Field | Value in V", 0)],
)
def test_a_table_of_fields_that_is_not_read_is_told(sources: Sources, header: str, count: int) -> None:
    rows = "| current_battery | 250 cA |\n| temperature | 25 degC |\n| pack | 3 |\n"
    text = (
        f"{TABLE}| id | 0 | |\n\n| {header} |\n| --- | --- |\n{rows}\n| A | B |\n| --- | --- |\n| id | 1 |\n| x | 2 |\n"
    )
    report = Report()
    found = find_fields(text, "/doc.md", "BATTERY_STATUS", sources.dialect, report)
    assert found is not None
    report_unread(found.others, found.message, report)
    told = [finding.place.line for finding in report if finding.rule.id == "document-table-unread"]
    assert told == [7] * count
