"""Faults of what an ADC measures: factors of the wrong dimension, channels that are never read, numbers that overflow.

The cases are written as those of ``test_broken_tables``.
"""

import pytest
from test_broken_tables import Case, check_place, name_of

STATE = "state.yaml"
CURRENT = "        adc: battery_current\n        multiplier: BATT_AMP_PERVLT\n        offset: BATT_AMP_OFFSET\n"
CHARGE = "        integral_of: current\n        restarts_with"
LEFT = "        left_of: BATT_CAPACITY\n        after: consumed\n"
LOST = "        left_of: §BATT_CAPA\n        after: consumed\n        requirement: FR-00077.6"
TIME = "        lasts: left\n        at: current\n        over: 30 s\n"
PIN = "    pin: BATT_VOLT_PIN\n"
SET = "        set_at: {BATT_MONITOR: 29}\n"
FOR = "        set_stale_after: 5 s\n"


def measured(lines: str) -> str:
    """The current of the rover, measured as these lines say."""
    return "        adc: battery_current\n" + "".join(f"        {line}\n" for line in lines.split("; "))


CASES = [
    Case("unit-mismatch", STATE, CURRENT, measured("multiplier: §17"), "17 makes no current of a voltage: it is in no"),
    Case("unit-mismatch", STATE, CURRENT, measured("multiplier: §17 V/A"), "give it a unit per volt, such as mA/V"),
    Case("unit-mismatch", STATE, CURRENT, measured("multiplier: 17 A/V; offset: §2 A"), "but a voltage is needed"),
    Case("bad-amount", STATE, CURRENT, measured("multiplier: §17 amps"), "neither a parameter nor an amount"),
    Case("unknown-parameter", STATE, CURRENT, measured("multiplier: 17 A/V; offset: §BATT_OFFS"), "no parameter"),
    Case("bad-quantity", STATE, CURRENT, "        offset: §0.3 V\n", "needs both adc and multiplier", is_alone=False),
    Case("bad-quantity", STATE, SET, SET.replace("29", "7").replace("{", "§{"), "BATT_MONITOR is never 7, so code"),
    Case("bad-quantity", STATE, SET, SET.replace("29", "0").replace("{", "§{"), "BATT_MONITOR is never 0, so code"),
    Case("unknown-parameter", STATE, SET, SET.replace("MONITOR", "MONITR").replace("{", "§{"), "BATT_MONITOR"),
    Case(
        "bad-quantity", STATE, SET, SET.replace("29", "29, BATT_CAPACITY: 1").replace("{", "§{"), "one parameter, not 2"
    ),
    Case(
        "bad-quantity",
        STATE,
        SET,
        SET.replace("BATT_MONITOR: 29", "BATT_LOW_VOLT: 11").replace("{", "§{"),
        "reboot: true",
    ),
    Case("bad-quantity", STATE, SET + FOR, SET.replace("{", "§{"), "needs set_stale_after"),
    Case("bad-quantity", STATE, SET + FOR, FOR.replace("5", "§5"), "so set_stale_after says nothing"),
    Case("bad-quantity", STATE, CURRENT, CURRENT + SET.replace("{", "§{") + FOR, "reads voltage before current"),
    Case(
        "reading-beyond-limits",
        STATE,
        CURRENT,
        measured("max: §50; multiplier: 17 A/V"),
        "battery.current is 0 to 56100 mA",
        is_alone=False,
    ),
    Case(
        "bad-integral",
        STATE,
        CHARGE,
        CHARGE.replace("current", "§temperature"),
        "temperature is not measured, by an ADC or another sensor",
        is_alone=False,
    ),
    Case("bad-integral", STATE, CHARGE, CHARGE.replace("current", "§voltag"), "no quantity voltag", is_alone=False),
    Case(
        "bad-integral",
        STATE,
        CHARGE,
        CHARGE.replace("current", "§voltage"),
        "voltage over time makes no charge",
        is_alone=False,
    ),
    Case(
        "bad-integral",
        STATE,
        CHARGE,
        CHARGE.replace("integral_of: current", "times: §voltage"),
        "says nothing without integral_of",
        is_alone=False,
    ),
    Case("bad-remainder", STATE, LEFT, "        left_of: §BATT_CAPACITY\n", "has both left_of and after"),
    Case("bad-remainder", STATE, LEFT, LEFT.replace("consumed", "§energy"), "energy is no integral"),
    Case(
        "bad-remainder",
        STATE,
        LEFT,
        LEFT.replace("BATT_CAPACITY", "§BATT_LOW_VOLT"),
        "BATT_LOW_VOLT is a voltage, and consumed is a charge",
    ),
    Case("bad-remainder", STATE, TIME, "        lasts: §left\n", "has lasts, at and over"),
    Case("unknown-parameter", STATE, LEFT, LEFT.replace("BATT_CAPACITY", "§BATT_CAPA"), "BATT_CAPA"),
    Case(
        "unknown-parameter",
        STATE,
        f"{LEFT}        restarts_with: swaps\n        requirement: FR-00077.6",
        LOST,
        "BATT_CAPA",
    ),
    Case("bad-adc", "board.yaml", PIN, PIN + "    when: §{BATT_MONITOR: 7}\n", "BATT_MONITOR is never 7"),
    Case("bad-adc", "board.yaml", PIN, PIN + "    when: §{BATT_REPORT: 1}\n", "looked at when the board starts"),
    Case("unknown-parameter", "board.yaml", PIN, PIN + "    when: §{BATT_MONITR: 3}\n", "BATT_MONITOR", is_alone=False),
]


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)
