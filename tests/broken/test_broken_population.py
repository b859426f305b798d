"""Mistakes in cells, pages, limits that booleans follow, and messages about one of several are reported.

The cases are written as those of ``test_broken_tables``.
"""

import pytest
from test_broken_tables import BATTERY as STATUS
from test_broken_tables import SYS, Case, about_their_drafts, check_place, name_of

CELLS = "messages/battery_cell_voltages.yaml"
OVER = "at_least: discharge_maximum_burst_current"
EXTENDED = "voltages_ext: {each: battery.cells, from: 10,"
WHOLE = "{each: battery.cells, state: battery.voltage, split: true,"

FAULTS = "fault_bitmask:\n    flags:\n      - MAV"
CHARGING, UNDEFINED = "MAV_BATTERY_CHARGE_STATE_CHARGING", "MAV_BATTERY_CHARGE_STATE_UNDEFINED"
STATE_OF_CHARGE = f"one_of:\n      - {CHARGING} if battery.charging\n      - {UNDEFINED}"

CASES = [
    Case("bad-elements", "state.yaml", "elements: cells", "elements: §cell", "did you mean cells"),
    Case("bad-elements", "state.yaml", "elements: cells", "elements: §chemistry", "not a whole number"),
    Case("bad-elements", "state.yaml", "elements: cells", "elements: cells\n        initial: §3", "no initial"),
    Case("not-an-enum-field", STATUS, FAULTS, FAULTS.replace("flags", "one_of").replace("- ", "§- "), "is a bitmask"),
    Case("bad-choice", STATUS, STATE_OF_CHARGE, f"one_of: §[{UNDEFINED}]", "entries with conditions"),
    Case(
        "bad-choice",
        STATUS,
        STATE_OF_CHARGE,
        f"one_of: §[{UNDEFINED}, {CHARGING} if battery.charging]",
        "behind them one",
    ),
    Case("bad-choice", STATUS, STATE_OF_CHARGE, f"one_of: §[{CHARGING}, {UNDEFINED}]", "entries with conditions"),
    Case(
        "unknown-enum-entry",
        STATUS,
        STATE_OF_CHARGE,
        f"one_of: §[{CHARGING}S if battery.charging, {UNDEFINED}]",
        CHARGING,
    ),
    Case(
        "unknown-quantity",
        STATUS,
        STATE_OF_CHARGE,
        f"one_of: §[{CHARGING} if battery.chargin, {UNDEFINED}]",
        "charging",
    ),
    Case(
        "not-a-boolean",
        STATUS,
        STATE_OF_CHARGE,
        f"one_of: §[{CHARGING} if battery.current, {UNDEFINED}]",
        "not a boolean",
    ),
    Case(
        "not-a-boolean",
        STATUS,
        STATE_OF_CHARGE,
        f"one_of: §[{CHARGING} if not battery.charging, {UNDEFINED}]",
        "cannot be set while battery.charging is false",
    ),
    Case("bad-following", "state.yaml", "follows: current", "follows: §curent", "did you mean current"),
    Case("bad-following", "state.yaml", "follows: current", "follows: §cells", "not a single number"),
    Case("bad-following", "state.yaml", "follows: current", "follows: §monitored", "not a single number"),
    Case(
        "bad-following",
        "state.yaml",
        "        below: 0\n",
        "        below: 0\n        at_least: §1\n",
        "the other limit",
    ),
    Case("bad-following", "state.yaml", "        below: 0\n", "", "no limit"),
    Case("bad-following", "state.yaml", "        below: 0\n", "        below: §0.0001\n", "whole number"),
    Case("bad-following", "state.yaml", OVER, "at_least: §discharge_maximum_curent", "discharge_maximum_current"),
    Case("bad-following", "state.yaml", OVER, "at_least: §chemistry", "which is no amount in A"),
    Case("bad-following", "state.yaml", OVER, "at_least: §weight", "has 250 g, which is no amount in A"),
    Case("bad-extreme", "state.yaml", "lowest_of: cells", "lowest_of: §cell", "did you mean cells", is_alone=False),
    Case("bad-extreme", "state.yaml", "lowest_of: cells", "lowest_of: §voltage", "no list", is_alone=False),
    Case(
        "bad-extreme",
        "state.yaml",
        "        stored: mV\n        lowest_of: cells",
        "        stored: cV\n        lowest_of: §cells",
        "kept in mV, not cV",
        is_alone=False,
    ),
    Case(
        "bad-quantity",
        "state.yaml",
        "lowest_of: cells",
        "lowest_of: §cells\n        boolean: true",
        "cannot have",
        is_alone=False,
    ),
    Case(
        "bad-quantity", "state.yaml", "follows: current", "initial: true\n        follows: §current", "without initial"
    ),
    Case("bad-source", STATUS, WHOLE, "{state: §battery.cells, split: true,", "each: battery.cells"),
    Case("bad-each", STATUS, WHOLE, "{each: battery.cells, state: §battery.voltage,", "split: true"),
    Case("bad-each", STATUS, WHOLE, "{each: §battery.voltage, state: battery.voltage, split: true,", "one value"),
    Case("bad-each", STATUS, EXTENDED, "voltages_ext: {each: battery.cells, from: 9,", "from: 10"),
    Case("bad-each", STATUS, EXTENDED, "voltages_ext: {each: battery.cells, from: §-1,", "from is -1"),
    Case("pointless-key", SYS, "load: {state: vehicle.load}", "load: {state: vehicle.load, from: §2}", "without each"),
    Case("pointless-key", STATUS, EXTENDED, "voltages_ext: {each: battery.cells, split: §true, from: 10,", "split"),
    Case(
        "beyond-field",
        SYS,
        "voltage_battery: {state: battery.voltage}",
        "voltage_battery: {parameter: §BATT_LOW_VOLT}",
        "voltage_battery (uint16_t) ends at 65.53",
    ),
    Case("bad-pages", CELLS, "pages: battery.cells", "pages: §battery.voltage", "one value"),
    Case("bad-pages", CELLS, "pages: battery.cells\n", "", "no pages"),
    Case("bad-pages", CELLS, "{page: true, note", "{constant: 0, note", "tell the pages apart"),
    Case("bad-pages", CELLS, "voltages: {each: battery.cells}", "voltages: {unknown: true}", "no field takes"),
    Case("bad-each", CELLS, "voltages: {each: battery.cells}", "voltages: {each: battery.cells, from: §1}", "on pages"),
    Case("unclear-instance", SYS, "represents: {battery: {parameter: BATT_SYS_STATUS}}\n", "", "first: true"),
    Case(
        "bad-representation", SYS, "{parameter: BATT_SYS_STATUS}", "{parameter: §BATT_LOW_TIMER}", "number of a battery"
    ),
    Case(
        "bad-representation",
        "parameters.yaml",
        "    min: 1\n    max: 16\n",
        "    min: 0\n    max: 16\n",
        "from 1 on",
        at="messages/sys_status.yaml:5:35",
    ),
    Case("bad-representation", SYS, "{parameter: BATT_SYS_STATUS}", "{lowest: §healthy}", "single number"),
    Case("bad-representation", SYS, "{parameter: BATT_SYS_STATUS}", "{lowest: §remainin}", "did you mean remaining"),
    Case("bad-representation", SYS, "{battery: {parameter", "{batery: §{parameter", "mean battery", is_alone=False),
    Case("one-of-keys", SYS, "{parameter: BATT_SYS_STATUS}", "{first: true, §lowest: remaining}"),
    Case("bad-constant", SYS, "errors_comm: {constant: 0}", "errors_comm: {board: §unique_id}", "a text"),
    Case(
        "unit-mismatch", SYS, "{state: vehicle.load}", "{parameter: §BATT_SYS_STATUS}", "hint: parameters.yaml can say"
    ),
]


@pytest.mark.parametrize("case", about_their_drafts(CASES), ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)
