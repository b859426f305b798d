"""Any state of a battery, through the firmware's builder and a frame, is what the receiver says."""

from collections.abc import Callable
from pathlib import Path

import pytest
from projects import HERE, run

STATUS = ("BATTERY_STATUS", "BATTERY_STATUS_V2")


@pytest.mark.requirement("FR-00075.1", "FR-00075.7", "FR-00075.9")
@pytest.mark.parametrize(
    ("project", "messages"),
    [
        pytest.param(
            "shipped",
            {*STATUS, "SMART_BATTERY_INFO", "BATTERY_INFO", "BATTERY_CELL_VOLTAGES"},
            marks=pytest.mark.draft("battery_cell_voltages_rfc_0018"),
        ),
        ("two_packs", {*STATUS, "SMART_BATTERY_INFO"}),
    ],
)
def test_any_state_comes_back(project: str, messages: set[str], generated: Callable[[str], Path]) -> None:
    """Within one unit of the wire, limits of the tables kept; unknown is unknown."""
    printed = run("cpython", HERE / "round_trip.py", [], str(generated(project)))
    assert messages <= set(printed.split())
