"""Quantities that cannot be kept as the tables ask, or not as the fields need them: each fault is reported at its place.

The cases are written as those of ``test_broken_tables``.
"""

import shutil
from pathlib import Path

import pytest
from test_broken_tables import Case, about_their_drafts, check_place, name_of

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
STATE = "state.yaml"
VOLTAGE = "        stored: mV\n        adc: battery_voltage\n"
CURRENT = "        unit: A\n        stored: mA\n"

CASES = [
    Case("beyond-storage", STATE, VOLTAGE, VOLTAGE + "        max: §1073742\n", "the most that can be compared"),
    Case("beyond-storage", STATE, VOLTAGE, VOLTAGE + "        min: §-2000000\n", "min of voltage is beyond 1073741823"),
    Case(
        "beyond-storage",
        STATE,
        "        unit: degC\n        stored: cdegC\n",
        "        unit: degC\n        stored: cdegC\n        max: §184467440737095517\n",
        "which 64 bits do not hold",
        is_alone=False,
    ),
    Case(
        "bad-quantity",
        STATE,
        VOLTAGE,
        VOLTAGE + "        min: 5\n        max: §4\n",
        "max of voltage is below its min",
        is_alone=False,
    ),
    Case(
        "reading-beyond-limits",
        STATE,
        VOLTAGE,
        VOLTAGE + "        max: §20\n",
        "battery.voltage is 0 to 33000 mV",
        is_alone=False,
    ),
    Case(
        "not-as-kept",
        "smart_battery/state.yaml",
        "        stored: mAh\n        min: 0\n",
        "        stored: mAh\n        min: 0\n        max: 3000000000\n",
        "battery.left is kept in mAh as an integer of 32 bits, and capacity_remaining is float in Ah",
        at="messages/battery_status_v2.yaml:13:31",
    ),
]


@pytest.mark.parametrize("case", about_their_drafts(CASES), ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)


def test_a_quantity_that_is_kept_more_coarsely_than_it_goes_out_is_told(tmp_path, monkeypatch, capsys):
    """Whole milliampere hours in a float field are what somebody wrote, or else a warning with what to write."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    state = tmp_path / "specs" / "state.yaml"
    text = state.read_text()
    assert "        stored: mAh\n        integral_of" in text
    monkeypatch.chdir(tmp_path)
    main(["check"])
    assert "coarse-quantity" not in capsys.readouterr().out
    state.write_text(text.replace("        stored: mAh\n        integral_of", "        integral_of"))
    main(["check"])
    told = capsys.readouterr().out
    assert "specs/state.yaml:59:7: warning coarse-quantity: battery.consumed is kept in whole mAh" in told
    assert "BATTERY_STATUS_V2.capacity_consumed is a float in Ah" in told
    assert "hint: stored: mAh, if whole units are meant" in told
