"""A cell of a document is an answer where it says one thing, and a finding where it does not."""

from collections.abc import Callable
from fractions import Fraction

import pytest

from codegen.diagnostics import Report
from codegen.importing.answer import Reading, Sources, Target
from codegen.importing.value import read_value
from codegen.load.expression import Product, read_product
from codegen.load.markdown_table import Cell
from codegen.source import Place

Read = Callable[[str, str, Sources], tuple[Reading, list[str]]]


@pytest.mark.parametrize(
    ("text", "field", "answer"),
    [
        ("0 (the only pack)", "id", "{state: battery.instance}"),
        ("2", "id", "{constant: 2}"),
        ("1 (MAV_BATTERY_FUNCTION_ALL)", "battery_function", "{enum: MAV_BATTERY_FUNCTION_ALL}"),
        ("MAV_BATTERY_FUNCTION_ALL (1)", "battery_function", "{enum: MAV_BATTERY_FUNCTION_ALL}"),
        ("`MAV_BATTERY_FUNCTION_ALL`", "battery_function", "{enum: MAV_BATTERY_FUNCTION_ALL}"),
        ("MAV_BATTERY_FUNCTION_ALL = 1", "battery_function", "{enum: MAV_BATTERY_FUNCTION_ALL}"),
        ("1", "battery_function", "{enum: MAV_BATTERY_FUNCTION_ALL}"),
        ("0", "fault_bitmask", "{flags: []}"),
        ("3", "fault_bitmask", "{flags: [MAV_BATTERY_FAULT_DEEP_DISCHARGE, MAV_BATTERY_FAULT_SPIKES]}"),
        ("INT16_MAX", "temperature", "unknown"),
        ("`INT16_MAX` (no sensor)", "temperature", "unknown"),
        ("32767", "temperature", "unknown"),
        ("0x7FFF", "temperature", "unknown"),
        ("i16::MAX", "temperature", "unknown"),
        ("unknown", "temperature", "unknown"),
        ("unknown (INT16_MAX)", "temperature", "unknown"),
        ("n/a", "temperature", "unknown"),
        ("-1 (unknown)", "energy_consumed", "unknown"),
        ("\u22121", "energy_consumed", "unknown"),
        ("UINT16_MAX", "voltages[1]", "unknown"),
        ("25 degC", "temperature", "{constant: 25 degC}"),
        ("2500", "temperature", "{constant: 2500}"),
        ("0 degC (frozen)", "temperature", "{constant: 0 degC}"),
        ("25 (degC)", "temperature", "{constant: 25 degC}"),
        ("2500 (25 degC)", "temperature", "{constant: 2500}"),
        ("25 degC (2500)", "temperature", "{constant: 25 degC}"),
        ("255 (0xFF)", "temperature", "{constant: 255}"),
        ("2500 (at most 2600)", "temperature", "{constant: 2500}"),
        ("5 (A)", "current_battery", "{constant: 5 A}"),
        ("12: volts", "voltages[0]", "{constant: 12 V}"),
        ("12 - volts at the start", "voltages[0]", "{constant: 12 V}"),
        ("1, A", "current_battery", "{constant: 1 A}"),
        ("2500, min of both", "temperature", "{constant: 2500}"),
        ("2500, as in section 3", "temperature", "{constant: 2500}"),
        ("2500; since FR-3 v2.1", "temperature", "{constant: 2500}"),
        ("100 - 0x64", "temperature", "{constant: 100}"),
        (r"(BatteryState.voltage \* 1000) as u16", "voltages[0]", "{state: battery.voltage}"),
        ("`state.battery.voltage * 1000`", "voltages", "{state: battery.voltage, split: true}"),
        ("battery.voltage", "voltages[0]", "{state: battery.voltage}"),
        ("`(int16_t)(battery.current * 100)`", "current_battery", "{state: battery.current}"),
        ("round(100 * battery.temperature) (from the pack)", "temperature", "{state: battery.temperature}"),
        ("battery.voltage (mV)", "voltages[0]", "{state: battery.voltage}"),
        ("battery.voltage (in V)", "voltages[0]", "{state: battery.voltage}"),
        ("battery.voltage (x 1000)", "voltages[0]", "{state: battery.voltage}"),
        ("battery.voltage (UINT16_MAX if unknown)", "voltages[1]", "{state: battery.voltage}"),
        ("battery.voltage (unknown after 2 s)", "voltages[1]", "{state: battery.voltage}"),
        ("BATT_CAPACITY", "current_consumed", "{parameter: BATT_CAPACITY}"),
        ("2500[^1]", "temperature", "{constant: 2500}"),
        ("2500 - not battery.like", "temperature", "{constant: 2500}"),
        ("not available", "temperature", "unknown"),
        ("N/A", "temperature", "unknown"),
        ("1 (all)", "battery_function", "{enum: MAV_BATTERY_FUNCTION_ALL}"),
        ("[0, 0, 0, 0]", "voltages_ext", "unknown"),
        ("`{state: battery.remaining, min: 0, max: 100}`", "battery_remaining", None),
        ("`{flags: [MAV_BATTERY_FAULT_SPIKES if battery.hot]}`", "fault_bitmask", None),
    ],
)
def test_what_says_one_thing_is_an_answer(read: Read, sources: Sources, text: str, field: str, answer: str) -> None:
    reading, findings = read(text, f"BATTERY_STATUS.{field}", sources)
    assert reading.answer == (answer or text.strip("`"))
    assert [finding for finding in findings if not finding.startswith("document-cast")] == []


@pytest.mark.parametrize(
    ("text", "field", "finding"),
    [
        ("2 (MAV_BATTERY_FUNCTION_ALL)", "battery_function", "document-entry: 2 stands beside MAV_BATTERY_FUNCTION_ALL, which is 1"),
        ("MAV_BATTERY_FUNCTION_ALL (2)", "battery_function", "document-entry: 2 stands beside MAV_BATTERY_FUNCTION_ALL, which is 1"),
        ("1 (MAV_BATTERY_TYPE_LIPO)", "battery_function", "document-entry: MAV_BATTERY_TYPE_LIPO is an entry of MAV_BATTERY_TYPE, but the enum of BATTERY_STATUS.battery_function is MAV_BATTERY_FUNCTION"),
        ("MAV_BATTERY_TYPE_LIPOO", "type", "document-entry: MAV_BATTERY_TYPE has no entry MAV_BATTERY_TYPE_LIPOO"),
        ("99", "type", "document-entry: MAV_BATTERY_TYPE has no entry 99 for BATTERY_STATUS.type"),
        ("-1 (unknown)", "temperature", "document-sentinel: BATTERY_STATUS.temperature is unknown when it is INT16_MAX, not -1"),
        ("-1", "temperature", "document-sentinel: BATTERY_STATUS.temperature is unknown when it is INT16_MAX, not -1"),
        ("UINT32_MAX", "energy_consumed", "document-sentinel: BATTERY_STATUS.energy_consumed is unknown when it is -1, not UINT32_MAX"),
        ("unknown (32767)", "energy_consumed", "document-sentinel: BATTERY_STATUS.energy_consumed is unknown when it is -1, not 32767"),
        ("unknown", "mode", "document-sentinel: BATTERY_STATUS.mode has no value for unknown in the dialect; the document says unknown"),
        ("70000", "voltages[1]", "document-range: 70000 is nothing that BATTERY_STATUS.voltages[1] can carry (uint16_t)"),
        ("12.5", "battery_remaining", "document-range: 12.5 is nothing that BATTERY_STATUS.battery_remaining can carry (int8_t)"),
        ("5 V", "current_battery", "document-range: 5 V is nothing that BATTERY_STATUS.current_battery can carry (int16_t, cA)"),
        ("5 (V)", "current_battery", "document-range: 5 V is nothing that BATTERY_STATUS.current_battery can carry"),
        ("50 %", "voltages[0]", "document-range: 50 % is nothing that BATTERY_STATUS.voltages[0] can carry (uint16_t, mV)"),
        ("5.5 mV", "voltages[0]", "document-range: 5.5 mV is nothing that BATTERY_STATUS.voltages[0] can carry"),
        ("70 V", "voltages[0]", "document-range: 70 V is nothing that BATTERY_STATUS.voltages[0] can carry"),
        ("`{constant: 5 V}`", "current_battery", "document-range: 5 V is nothing that BATTERY_STATUS.current_battery can carry"),
        ("2500 (2600)", "temperature", "document-prose: '2500 (2600)' does not say"),
        ("2500 (26 degC)", "temperature", "document-prose: '2500 (26 degC)' does not say"),
        ("25 degC (26)", "temperature", "document-prose: '25 degC (26)' does not say"),
        ("10 - battery.temperature", "temperature", "document-prose: '10 - battery.temperature' does not say"),
        ("BATT_CAPACITY - battery.consumed", "current_consumed", "document-prose"),
        ("100 - BATT_CAPACITY", "current_consumed", "document-prose"),
        ("battery.voltage (kV)", "voltages[0]", "document-prose"),
        ("battery.voltage (x 10)", "voltages[0]", "document-factor: battery.voltage (V) times 10 is not in mV"),
        ("battery.voltage (divided by 10)", "voltages[0]", "document-factor: battery.voltage (V) times 0.1 is not in mV"),
        ("battery.voltage (offset 20)", "voltages[0]", "document-prose"),
        ("battery.current (negated)", "current_battery", "document-prose"),
        ("battery.voltage (0 if unknown)", "voltages[1]", "document-prose"),
        ("2 (all)", "battery_function", "document-entry: 2 stands beside MAV_BATTERY_FUNCTION_ALL, which is 1"),
        ("[0, 0, 0, 1]", "voltages_ext", "document-prose"),
        ("2500 (to be confirmed)", "temperature", "document-ambiguous: '2500 (to be confirmed)' leaves open"),
        ("2500 (TBD)", "temperature", "document-ambiguous: '2500 (TBD)' leaves open"),
        ("25 degC (tbc)", "temperature", "document-ambiguous: '25 degC (tbc)' leaves open"),
        ("battery.voltage (?)", "voltages[0]", "document-ambiguous: 'battery.voltage (?)' leaves open"),
        ("battery.volts * 1000", "voltages[0]", "document-quantity: the state has no quantity battery.volts"),
        ("battery.voltage * 100", "voltages[0]", "document-factor: battery.voltage (V) times 100 is not in mV"),
        ("battery.current * 1000", "voltages[0]", "document-factor: battery.current (A) times 1000 is not in mV"),
        ("-1 or estimate", "current_battery", "document-ambiguous: '-1 or estimate' leaves open what goes into BATTERY_STATUS.current_battery"),
        ("TBD", "current_battery", "document-ambiguous: 'TBD' leaves open what goes into BATTERY_STATUS.current_battery"),
        ("?", "current_battery", "document-ambiguous: '?' leaves open what goes into BATTERY_STATUS.current_battery"),
        ("what the pack has", "voltages[0]", "document-prose: 'what the pack has' does not say what goes into BATTERY_STATUS.voltages[0]"),
        ("12,6 V", "voltages[0]", "document-prose: '12,6 V' does not say what goes into"),
        ("3,5", "temperature", "document-prose: '3,5' does not say"),
        ("1,500", "temperature", "document-prose: '1,500' does not say"),
        ("10 - 20", "temperature", "document-prose: '10 - 20' does not say"),
        ("10; 20", "temperature", "document-prose: '10; 20' does not say"),
        ("10, later 20", "temperature", "document-prose: '10, later 20' does not say"),
        ("0: not used, 1: charging", "temperature", "document-prose: '0: not used, 1: charging' does not say"),
        ("UINT16_MAX, 0 when full", "voltages[1]", "document-prose: 'UINT16_MAX, 0 when full' does not say"),
        ("10<br>20", "temperature", "document-prose: '10 20' does not say"),
        ("![5](x.png)", "temperature", "document-prose: '![5]' does not say"),
        ("10<sup>2</sup>", "temperature", "document-prose: '10^2' does not say"),
        ("10<sub>2</sub>", "temperature", "document-prose: '10_2' does not say"),
        ('<span style="text-decoration:line-through">10</span>', "temperature", "document-prose: '~~10' does not say"),
        ("1<span style='vertical-align:super'>0</span>", "temperature", "document-prose: '1~~0' does not say"),
        ("", "voltages[0]", "document-empty: nothing is said about the value of BATTERY_STATUS.voltages[0]"),
        ("`{sate: battery.voltage}`", "voltages[0]", "unknown-key: unknown key 'sate'"),
        ("`{state: battery.voltage`", "voltages[0]", "yaml-syntax"),
        ("`{state: battery.voltage, spli: true}`", "voltages", "unknown-key: unknown key 'spli'"),
        ("`{enum: MAV_BATTERY_MODE_UNKNOWM}`", "mode", "document-entry: MAV_BATTERY_MODE has no entry MAV_BATTERY_MODE_UNKNOWM"),
        ("`{flags: [A if battery.hot]}`", "fault_bitmask", "document-entry: MAV_BATTERY_FAULT has no entry A"),
        ("`{enum: MAV_BATTERY_MODE_UNKNOWN}`", "temperature", "document-entry: BATTERY_STATUS.temperature has no enum"),
    ],
)  # fmt: skip
def test_what_does_not_is_a_finding(read: Read, sources: Sources, text: str, field: str, finding: str) -> None:
    reading, findings = read(text, f"BATTERY_STATUS.{field}", sources)
    assert reading.answer is None
    assert any(found.startswith(finding) for found in findings), findings


def test_a_proposal_names_the_quantity_that_the_words_suggest(read: Read, sources: Sources) -> None:
    assert read("pack voltage in mV", "BATTERY_STATUS.voltages[0]", sources)[0].proposal == "{state: battery.voltage}"
    assert read("estimate, or -1", "BATTERY_STATUS.battery_remaining", sources)[0].proposal == "unknown"
    assert read("the weather", "BATTERY_STATUS.type", sources)[0].proposal is None


def test_a_decimal_comma_is_told_with_the_number_that_may_be_meant(sources: Sources) -> None:
    """The number before the comma went out: 54 steps of 1e-7 degrees for 54,3 degrees."""
    report = Report()
    field = sources.dialect.messages["GPS_RAW_INT"].field("lat")
    assert field is not None
    target = Target(sources.dialect.messages["GPS_RAW_INT"], field, 0, 1)
    read_value(Cell("54,3 deg", (), "54,3 deg", Place("a.md", 1, 1)), target, sources, report)
    (finding,) = report
    assert finding.hint == "write a decimal point: 54.3, or a whole number without a comma: 543"


def test_a_cast_that_ends_at_the_sentinel_is_told(read: Read, plain: Sources) -> None:
    reading, findings = read("(Pack.voltage * 1000) as u16", "BATTERY_STATUS.voltages[0]", plain)
    assert reading.answer == "{state: pack.voltage}"
    assert findings == [
        "document-cast: a cast to uint16_t ends at 65535 (UINT16_MAX), which means unknown in voltages[0]"
    ]
    _, findings = read("(Pack.charge * 1000) as u16", "BATTERY_STATUS.current_consumed", plain)
    assert findings == ["document-cast: the document casts to uint16_t, but BATTERY_STATUS.current_consumed is int32_t"]


def test_without_a_project_the_factor_has_to_be_that_of_some_unit(read: Read, plain: Sources) -> None:
    assert read("pack.voltage * 1000", "BATTERY_STATUS.voltages[0]", plain)[0].answer == "{state: pack.voltage}"
    reading, findings = read("pack.voltage * 999", "BATTERY_STATUS.voltages[0]", plain)
    assert reading.answer is None
    assert findings[0].startswith("document-factor: pack.voltage times 999 is in mV for no unit")


@pytest.mark.parametrize("text", ["NaN", "nan (not measured)", "unknown"])
def test_nan_is_a_sentinel_like_any_other(read: Read, sources: Sources, text: str) -> None:
    assert read(text, "BATTERY_STATUS_V2.voltage", sources)[0].answer == "unknown"


@pytest.mark.parametrize(
    "text", ["(" * 500, "a." * 300, "1" * 400, "`" * 99, "((a.b" + ")" * 60, "-" * 200, "(1 (2 (3"]
)
def test_nonsense_is_a_finding_and_no_fault(read: Read, sources: Sources, text: str) -> None:
    reading, findings = read(text, "BATTERY_STATUS.voltages[0]", sources)
    assert reading.answer is None
    assert findings


@pytest.mark.parametrize(
    ("text", "product"),
    [
        ("a.b", Product("a.b", Fraction(1))),
        ("1000 * a.b / 4", Product("a.b", Fraction(250))),
        ("(a.b * 2.5) / (2 * 5)", Product("a.b", Fraction(1, 4))),
        ("PackState.cell_voltage as i16", Product("pack.cell_voltage", Fraction(1), "int16_t")),
        ("float(self.pack->volts)", Product("pack.volts", Fraction(1), "float")),
        ("a.b * c.d", None),
        ("4 / a.b", None),
        ("a.b / 0", None),
        ("a.b as text", None),
        ("a.b 2", None),
        ("2 * 3", None),
        ("voltage", None),
        ("(a.b", None),
    ],
)
def test_products_are_exact_and_of_one_quantity(text: str, product: Product | None) -> None:
    assert read_product(text) == product
