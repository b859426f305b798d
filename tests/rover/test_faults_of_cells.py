"""One cell, or a current, that is beyond what it stands is told by both generations, whatever the whole pack has."""

from types import ModuleType
from typing import Any

import pytest
from pymavlink.dialects.v20 import common
from test_one_picture import Step, told, wire

__all__ = ("wire",)

GOOD: Step = [("cells", [3.9, 3.9, 3.9]), ("current_ma", 20000)]
CASES: dict[str, tuple[Step, str, set[str]]] = {
    "all is well": (GOOD, "", set()),
    "one is empty": ([("cells", [4.2, 4.2, 2.5])], "DEEP_DISCHARGE", {"NOT_READY_TO_USE", "FAULT_UNDER_VOLT"}),
    "one is too full": ([("cells", [4.5, 3.5, 3.5])], "", {"NOT_READY_TO_USE", "FAULT_OVER_VOLT"}),
    "one is unknown": ([("cells", [4.2, None, 2.5])], "DEEP_DISCHARGE", {"NOT_READY_TO_USE", "FAULT_UNDER_VOLT"}),
    "200 A": ([*GOOD, ("current_ma", 200000)], "OVER_CURRENT", {"NOT_READY_TO_USE", "FAULT_OVER_CURRENT"}),
    "one milliampere less than for seconds": ([*GOOD, ("current_ma", 131999)], "", set()),
}
LOOKED_AT = ("NOT_READY_TO_USE", "FAULT_OVER_VOLT", "FAULT_UNDER_VOLT", "FAULT_OVER_CURRENT")


def faults(wire: ModuleType, messages: list[Any]) -> tuple[str, set[str]]:
    """Return the faults that BATTERY_STATUS and BATTERY_STATUS_V2 report."""
    _, old, new = messages
    kinds = ("DEEP_DISCHARGE", "OVER_CURRENT")
    found = [each for each in kinds if old.fault_bitmask & getattr(common, f"MAV_BATTERY_FAULT_{each}")]
    flags = {each for each in LOOKED_AT if new.status_flags & getattr(wire, f"MAV_BATTERY_STATUS_FLAGS_{each}")}
    return "".join(found), flags


@pytest.mark.draft("battery_upstream")
@pytest.mark.requirement("FR-00072.5", "FR-00068.6")
@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_a_cell_or_a_current_beyond_its_limit_is_told(wire: ModuleType, interpreter: str) -> None:
    """And nothing of it once code has set nothing for two seconds, or all is well again."""
    well: Step = [("health", 0), ("failsafe", 0)]
    courses = [[[*well, *GOOD], step, *([[]] * 20), GOOD] for step, _, _ in CASES.values()]
    for (name, (_, old, new)), steps in zip(CASES.items(), told(wire, courses, 3, interpreter), strict=True):
        assert faults(wire, steps[0]) == ("", set()), name
        assert faults(wire, steps[1]) == (old, new), name
        if "current_ma" not in str(CASES[name][0]):
            assert faults(wire, steps[-2]) == ("", set()), name
        assert faults(wire, steps[-1]) == ("", set()), name
