"""Documents of the project against its tables and the dialect: the shipped document, with one thing changed."""

from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.importing.drift import drift
from codegen.importing.stated import stated_fields
from codegen.model.system import System
from codegen.project.systems import read_system

DOCUMENT = Path(__file__).parents[2] / "specs" / "requirements" / "FR-00068-battery-status-telemetry.md"


def test_the_shipped_document_has_not_drifted(system: System) -> None:
    stated = stated_fields(DOCUMENT.read_text(), str(DOCUMENT))
    assert [*stated.findings, *drift(stated, [system])] == []


@pytest.mark.parametrize(
    ("old", "new", "finding"),
    [
        ("| cdegC |", "| degC |", "62:27: error document-unit: BATTERY_STATUS.temperature is in cdegC"),
        ("int16_t | cdegC", "uint16_t | cdegC", "62:17: error document-type: BATTERY_STATUS.temperature is int16_t"),
        ("| uint16_t[10] |", "| uint16_t[9] |", "63:14: error document-type: BATTERY_STATUS.voltages is uint16_t[10]"),
        ("| 32767 |", "| 0 |", "62:68: error document-unknown: BATTERY_STATUS.temperature is unknown when it is INT16_MAX"),
        ("split: true}` |", "split: false}` |", "63:34: error document-drift: BATTERY_STATUS.voltages is "),
        ("max: 100}` | -1 | FR-00077; est", "max: 99}` | -1 | FR-00077; est", "67:36: error document-drift: BATTERY_"),
        ("| custom_mode | uint32_t | `{state: vehicle.mode}` | |\n", "", "87:1: warning document-row-missing: the table leaves out HEARTBEAT.custom_mode"),
        ("| autopilot |", "| autopilt |", "90:3: error document-field: HEARTBEAT has no field autopilt"),
        ("`{state: vehicle.mode}`", "-1 or the mode", "92:28: error document-ambiguous"),
        ("`{state: vehicle.mode}`", "`{stat: vehicle.mode}`", "92:30: error unknown-key"),
        ("| --- | --- | --- | --- |\n| type", "| --- | --- | --- |\n| type", "88:1: error table-delimiter"),
        ("| temperature | int16_t | cdegC |", "| temperature | int16_t |", "62:1: warning table-cell-missing"),
        ("| cdegC |", "| 0.1 \u00b0C |", "62:27: error document-unit: BATTERY_STATUS.temperature is in cdegC"),
        ("| temperature |", "| type | uint8_t | | of the pack | | |\n| temperature |", "62:22: error document-prose: 'of the pack'"),
    ],
)  # fmt: skip
def test_drift_is_found_by_line(system: System, old: str, new: str, finding: str) -> None:
    """The document changes and the table does not; each finding names the line of the document."""
    text = DOCUMENT.read_text()
    assert text.count(old) >= 1
    stated = stated_fields(text.replace(old, new, 1), str(DOCUMENT))
    report = Report()
    report.extend([*stated.findings, *drift(stated, [system])])
    found = [f"{one.place.line}:{one.place.column}: {one.rule.severity} {one.rule.id}: {one.message}" for one in report]
    assert any(line.startswith(finding) for line in found), found


BOAT = Path(__file__).parents[1] / "projects" / "boat" / "specs"


@pytest.mark.parametrize(
    ("old", "new", "findings"),
    [
        ("| 50 cm |", "| 500 mm |", []),
        ("| 50 cm |", "| 51 cm |", ["min_distance is {constant: 51 cm} here, but {constant: 0.5 m} in the population table"]),
        ("| 8 deg |", "| 8.5 deg |", ["horizontal_fov is {constant: 8.5 deg} here, but", "vertical_fov is {constant: 8.5 deg}"]),
    ],
)  # fmt: skip
def test_an_amount_in_another_unit_is_the_same(old: str, new: str, findings: list[str]) -> None:
    """The sent values are compared, and not how they are written: the table of the boat has 0.5 m."""
    system = read_system(str(BOAT / "codegen.yaml"), Report())
    assert system is not None
    (path,) = (BOAT / "requirements").iterdir()
    text = path.read_text()
    assert old in text
    report = Report()
    stated = stated_fields(text.replace(old, new), str(path))
    report.extend([*stated.findings, *drift(stated, [system])])
    found = [one.message for one in report]
    assert len(found) == len(findings), found
    assert all(wanted in one for wanted, one in zip(findings, found, strict=True)), found


@pytest.mark.parametrize("unit", ["centidegrees Celsius", "0.01 \u00b0C", "1/100 degC", "0,01 \u00b0C"])
def test_a_unit_in_words_or_as_a_step_is_the_same(system: System, unit: str) -> None:
    """Who writes for readers writes 0.01 \u00b0C for cdegC; it was an error."""
    text = DOCUMENT.read_text().replace("| cdegC |", f"| {unit} |", 1)
    assert [*drift(stated_fields(text, str(DOCUMENT)), [system])] == []


def test_a_table_of_most_fields_with_other_headings_is_told(system: System) -> None:
    """It is compared with nothing, and nothing said so: the drift of a table that was translated went unnoticed."""
    rows = "".join(f"| {name} | 0 |\n" for name in ("type", "autopilot", "base_mode", "custom_mode"))
    for text, told in (
        (f"HEARTBEAT:\n\n| Feld | Wert |\n| --- | --- |\n{rows}", [3]),
        (f"HEARTBEAT:\n\n| Feld | Wert |\n| --- | --- |\n{rows[:20]}", []),
        (f"For example of HEARTBEAT:\n\n| Feld | Wert |\n| --- | --- |\n{rows}", [3]),
        (f"An example of HEARTBEAT:\n\n| Feld | Wert |\n| --- | --- |\n{rows}", []),
        (f"RADIO_STATUS:\n\n| Feld | Wert |\n| --- | --- |\n{rows}", []),
    ):
        found = drift(stated_fields(text, "/a.md"), [system])
        assert [one.place.line for one in found if one.rule.id == "document-table-unread"] == told, text
