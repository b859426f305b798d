"""``rounding`` in a table that has nothing to round is told, and one that has is not."""

import shutil
from pathlib import Path

import pytest
from edited_project import edited

PROJECTS = Path(__file__).resolve().parents[1] / "projects"


def told(project: str, tmp_path: Path, *changes: tuple[str, str, str]) -> list[str]:
    """What the rule says of a project with changes."""
    folder = Path(shutil.copytree(PROJECTS / project / "specs", tmp_path / "specs"))
    return [found.message for found in edited(folder, *changes)[1] if found.rule.id == "idle-rounding"]


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (("parameters.yaml", "step: 0.05", "step: 0.05"), []),
        (
            (
                "messages/smart_battery_info.yaml",
                "{parameter: BATT_CAPACITY, max",
                "{parameter: BATT_CAPACITY, rounding: up, max",
            ),
            ["SMART_BATTERY_INFO.capacity_full: each step of BATT_CAPACITY is a whole number there"],
        ),
        (
            ("state.yaml", "stored: d%,", 'stored: "%",'),
            ["BATTERY_STATUS.battery_remaining: each step of pack.charge is a whole number there"],
        ),
    ],
)
def test_what_is_sent(change: tuple[str, str, str], says: list[str], tmp_path: Path) -> None:
    """Steps of a tenth of a percent are rounded, whole ones are not; nor are capacities in steps of 50 mAh."""
    assert [text.removeprefix("nothing is rounded in ") for text in told("two_batteries", tmp_path, change)] == says


def test_what_is_received(tmp_path: Path) -> None:
    """A float that is kept as one, and microseconds in microseconds; centidegrees in degrees are rounded."""
    changes = (
        ("receives/gps_input.yaml", "{state: fix.hdop, ", "{state: fix.hdop, rounding: up, "),
        ("receives/gps_input.yaml", "{state: fix.yaw", "{rounding: down, state: fix.yaw"),
        ("receives/rc_channels_override.yaml", "chan1_raw: {", "chan1_raw: {rounding: down, "),
    )
    assert told("received", tmp_path, *changes) == [
        "nothing is rounded of GPS_INPUT.hdop: it is kept as a float",
        "nothing is rounded of RC_CHANNELS_OVERRIDE.chan1_raw: it is a whole number of the steps that are kept",
    ]
