"""Faults of what an ADC measures: factors of the wrong dimension, channels that are never read, numbers that overflow.

The cases are written as those of ``test_broken_tables``.
"""

import pytest
from test_broken_tables import Case, check_place, name_of

STATE = "state.yaml"
CURRENT = "        unit: A\n        stored: cA\n"
CHARGE = "        unit: mAh\n        stored: mAh\n        restarts_with: swaps\n"
LEFT = "        unit: mAh\n        stored: mAh\n        min: 0\n"
OF = "        left_of: BATT_CAPACITY\n"
PIN = "    pin: BATT_VOLT_PIN\n"


def measured(lines: str) -> str:
    """The current of the rover, measured as these lines say."""
    return CURRENT + "        adc: battery_voltage\n" + "".join(f"        {line}\n" for line in lines.split("; "))


CASES = [
    Case("unit-mismatch", STATE, CURRENT, measured("multiplier: §17"), "17 makes no current of a voltage: it is in no"),
    Case("unit-mismatch", STATE, CURRENT, measured("multiplier: §17 V/A"), "give it a unit per volt, such as cA/V"),
    Case("unit-mismatch", STATE, CURRENT, measured("multiplier: 17 A/V; offset: §2 A"), "but a voltage is needed"),
    Case("bad-amount", STATE, CURRENT, measured("multiplier: §17 amps"), "neither a parameter nor an amount"),
    Case("unknown-parameter", STATE, CURRENT, measured("multiplier: 17 A/V; offset: §BATT_OFFS"), "no parameter"),
    Case("bad-quantity", STATE, CURRENT, CURRENT + "        offset: §0.3 V\n", "needs both adc and multiplier"),
    Case(
        "reading-beyond-limits",
        STATE,
        CURRENT,
        measured("max: §50; multiplier: 17 A/V"),
        "battery.current is 0 to 5610 cA",
    ),
    Case(
        "bad-integral", STATE, CHARGE, CHARGE + "        integral_of: §current\n", "current is not measured by an ADC"
    ),
    Case("bad-integral", STATE, CHARGE, CHARGE + "        integral_of: §voltag\n", "no quantity voltag"),
    Case(
        "bad-integral", STATE, CHARGE, CHARGE + "        integral_of: §voltage\n", "voltage over time makes no charge"
    ),
    Case("bad-integral", STATE, CHARGE, CHARGE + "        times: §voltage\n", "says nothing without integral_of"),
    Case("bad-remainder", STATE, LEFT, LEFT + "        left_of: §BATT_CAPACITY\n", "has both left_of and after"),
    Case("bad-remainder", STATE, LEFT, LEFT + OF + "        after: §consumed\n", "consumed is no integral"),
    Case("bad-remainder", STATE, LEFT, LEFT + "        lasts: §left\n", "has lasts, at and over"),
    Case("bad-adc", "board.yaml", PIN, PIN + "    when: §{BATT_MONITOR: 7}\n", "BATT_MONITOR is never 7"),
    Case("bad-adc", "board.yaml", PIN, PIN + "    when: §{BATT_REPORT: 1}\n", "looked at when the board starts"),
    Case("unknown-parameter", "board.yaml", PIN, PIN + "    when: §{BATT_MONITR: 3}\n", "BATT_MONITOR", is_alone=False),
]


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)
