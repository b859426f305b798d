"""Any state of a battery, through the firmware's builder and a frame, is what the receiver says."""

from collections.abc import Callable
from pathlib import Path

import pytest
from projects import HERE, run


@pytest.mark.parametrize(
    ("project", "messages"),
    [("shipped", {"BATTERY_STATUS"}), ("two_packs", {"BATTERY_STATUS", "BATTERY_STATUS_V2", "SMART_BATTERY_INFO"})],
)
def test_any_state_comes_back(project: str, messages: set[str], generated: Callable[[str], Path]) -> None:
    """Within one unit of the wire, limits of the tables kept; unknown is unknown; FR-00075.7."""
    printed = run("cpython", HERE / "round_trip.py", [], str(generated(project)))
    assert messages <= set(printed.split())
