"""Counts of what comes back, and what begins anew with them, that cannot be: each fault is reported where it was made.

The cases are written as those of ``test_broken_tables``.
"""

import pytest
from test_broken_tables import Case, check_place, name_of

STATE = "state.yaml"
COUNTS = "counts_returns_of: absent"
CHARGE = "stored: mAh\n        integral_of: current\n        restarts_with: "
NOTHING = "        counts_returns_of: absent\n        back_from: 2.0\n        restarting_stale_after: 5 s\n        initial: 0\n"

CASES = [
    # what is counted
    Case("bad-return", STATE, COUNTS, "counts_returns_of: §absnt", "did you mean absent"),
    Case("bad-return", STATE, COUNTS, "counts_returns_of: §healthy", "healthy is no boolean that follows a limit"),
    Case("bad-return", STATE, COUNTS, "counts_returns_of: §voltage", "voltage is no boolean"),
    Case("bad-return", STATE, COUNTS, "counts_returns_of: §hot", "of what an ADC measures"),
    # what counts
    Case("bad-return", STATE, NOTHING, "        counts_returns_of: §absent\n", "starts unknown"),
    Case("bad-return", STATE, "back_from: 2.0", "back_from: §1.0", "absent is not below a smaller number"),
    Case("bad-return", STATE, "        below: 1.0\n", "        at_least: 1.0\n", "not below a smaller number", at="state.yaml:154:20"),
    Case("unit-mismatch", STATE, "restarting_stale_after: 5 s", "restarting_stale_after: §5 V", "a time is needed"),
    Case("bad-quantity", STATE, "back_from: 2.0", "back_from: §2.0001", "not a whole number of stored units"),
    Case("bad-return", STATE, NOTHING, f"        unit: mAh\n{NOTHING}".replace("of: ", "of: §"), "no pure number"),
    Case(
        "bad-return",
        STATE,
        "      protected:\n",
        "      count:\n        doc: More.\n        initial: 0\n        counts_returns_of: §absent\n      protected:\n",
        "one quantity that counts returns",
    ),
    # what comes before a reading
    Case("bad-preference", STATE, "prefers: cells", "prefers: §cels", "did you mean cells"),
    Case("bad-preference", STATE, "prefers: cells", "prefers: §temperature", "temperature is no list of numbers"),
    Case("bad-preference", STATE, "        stored: mV\n        elements: cells", "        elements: cells", "cells is not stored in mV", is_alone=False),
    # what begins anew
    Case("bad-return", STATE, f"{CHARGE}swaps", f"{CHARGE}§swap", "did you mean swaps"),
    Case("bad-return", STATE, f"{CHARGE}swaps", f"{CHARGE}§left", "left does not count returns"),
    Case("bad-return", STATE, f"{CHARGE}swaps", f"{CHARGE}§swaps\n        min: 1", "cannot be 0"),
    Case("bad-return", STATE, "        trend_of: voltage\n", "        trend_of: voltage\n        restarts_with: §swaps\n", "trend is not what code sets"),
    Case("bad-return", STATE, "        while_known: voltage\n", "        while_known: voltage\n        restarts_with: §swaps\n", "healthy is not what code sets"),
    Case("bad-return", STATE, COUNTS, f"{COUNTS}\n        restarts_with: §swaps", "swaps is not what code sets"),
    Case(
        "bad-return",
        STATE,
        "        adc: battery_voltage\n",
        "        adc: battery_voltage\n        restarts_with: §swaps\n",
        "voltage tells whether it came back",
    ),
]  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)
