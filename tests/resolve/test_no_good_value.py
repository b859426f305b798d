"""A failsafe that is up at every value, or that no value ends, is told with the numbers; one step less is none."""

import shutil
from pathlib import Path

import pytest
from edited_project import edited

from codegen.rules import no_good_value, out_of_reach

BOAT = Path(__file__).resolve().parents[1] / "projects" / "watched_boat" / "specs"
"""A depth of 0 to 100 m that a failsafe watches below a parameter, up to 20 m and 0 for off, and brine of 0 to 40 %."""

SHALLOW = "shallow: {below: SHALLOW, action: stop, after: 1 s, requirement: FR-201.2}\n"
ARM = "    to_arm: [{below: DEPTH_ARM}]\n"
DEPTH = "min: 0, max: 100, stale_after: 3 s, requirement: FR-201.2}"
THIN = "{above: 30 %, after: 2 s}"
SLACK = "    hysteresis: 6 %\n"
OVER = "    latch: false\n"

Change = tuple[str, str, str]


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    shutil.copytree(BOAT, tmp_path / "specs")
    return tmp_path / "specs"


def told(folder: Path, *changes: Change) -> list[tuple[str, str]]:
    """Return the ids and messages about reach after changes, which each have a hint."""
    _, found = edited(folder, *changes)
    own = {
        out_of_reach.KNOWN_FOR_EVER,
        no_good_value.RULE,
        no_good_value.BY_DEFAULT,
        out_of_reach.RULE,
        out_of_reach.BY_DEFAULT,
    }
    assert all(each.hint for each in found if each.rule in own)
    return [(each.rule.id, each.message) for each in found if each.rule in own]


def levels(*written: str, last: str = "") -> Change:
    """The levels of the failsafe on the depth, and what stands behind them."""
    lines = "\n".join(f"      {each}" for each in written)
    return "vehicle.yaml", f"      {SHALLOW}", f"{lines}\n{last}"


ALWAYS = [
    ("low: {below: 101 m}", "depth is always up: sounder.depth is always below 101 m, as it goes from 0.3 to 100 m"),
    ("low: {above: 0 m}", "depth is always up: sounder.depth is always above 0 m, as it goes from 0.3 to 100 m"),
    ("low: {above: 0.29 m}", "depth is always up: sounder.depth is always above 0.29 m, as it goes from 0.3 to 100 m"),
    ("low: {above: 0.3 m}", ""),
    ("low: {below: 100 m}", ""),
    (
        "low: {below: 5 m, or: [{above: 4.99 m}]}",
        "depth is always up: sounder.depth is always below 5 m or above 4.99 m, as it goes from 0.3 to 100 m",
    ),
    ("low: {below: 5 m, or: [{above: 5 m}]}", ""),
    ("low: {unknown: true, or: [{below: 5 m}, {above: 50 m}]}", ""),
]


@pytest.mark.parametrize(("level", "message"), ALWAYS, ids=range(len(ALWAYS)))
def test_a_level_that_holds_at_every_value(folder: Path, level: str, message: str) -> None:
    """Alone, or with another condition of it; at the very end of the range there is a good value."""
    change = ("state.yaml", DEPTH, DEPTH.replace("min: 0,", "min: 0.3,"))
    assert told(folder, change, ("vehicle.yaml", ARM, ""), levels(level)) == (
        [("no-good-value", message)] if message else []
    )


def test_levels_that_hold_at_every_value_between_them(folder: Path) -> None:
    message = "depth is always up: sounder.depth is always below 5 m or above 4 m, as it goes from 0 to 100 m"
    assert told(folder, levels("low: {below: 5 m}", "high: {above: 4 m}")) == [("no-good-value", message)]


def test_what_lets_nobody_arm(folder: Path) -> None:
    """What is looked at for arming, alone and with what the levels say; a failsafe with arming: false says nothing."""
    assert told(folder, levels("low: {below: 5 m}"), ("vehicle.yaml", ARM, "    to_arm: [{above: 4 m}]\n")) == [
        (
            "no-good-value",
            "depth never lets the vehicle be armed: sounder.depth is always below 5 m or above 4 m, as it goes from 0 "
            "to 100 m",
        )
    ]
    kept = "    to_arm: [{above: 4 m}]\n"
    assert told(folder, ("vehicle.yaml", kept, f"{kept}    arming: false\n")) == []


def test_the_default_of_a_parameter(folder: Path) -> None:
    """A range with good values is right; its default alone is a warning, and 0 switches the threshold off."""
    small = ("state.yaml", DEPTH, DEPTH.replace("max: 100", "max: 1.49"))
    (folder / "vehicle.yaml").write_text((folder / "vehicle.yaml").read_text().replace(ARM, ""))
    assert told(folder, small) == [
        (
            "no-good-default",
            "depth is always up: sounder.depth is always below 1.5 m (SHALLOW), as it goes from 0 to 1.49 m",
        )
    ]
    assert told(folder, ("state.yaml", "max: 1.49", "max: 1.5")) == []
    smaller = ("state.yaml", "max: 1.5", "max: 1")
    assert told(folder, smaller, ("parameters.yaml", "unit: m, default: 1.5", "unit: m, default: 0")) == []


NEVER_OVER = [
    (
        levels("low: {below: 1.5 m}", last=f"{OVER}    hysteresis: 98.51 m\n"),
        "depth, low, is never over: sounder.depth is always below 100.01 m (1.5 m with a hysteresis of 98.51 m), as it "
        "goes from 0 to 100 m",
    ),
    (levels("low: {below: 1.5 m}", last=f"{OVER}    hysteresis: 98.5 m\n"), ""),
    (
        levels("low: {below: SHALLOW}", last=f"{OVER}    hysteresis: 100 m\n"),
        "depth, low, is never over: sounder.depth is always below 100.01 m (SHALLOW with a hysteresis of 100 m), as it "
        "goes from 0 to 100 m",
    ),
    (
        levels("deep: {above: 40 m, hysteresis: 40.01 m}", last=OVER),
        "depth, deep, is never over: sounder.depth is always above -0.01 m (40 m with a hysteresis of 40.01 m), as it "
        "goes from 0 to 100 m",
    ),
    (levels("deep: {above: 40 m, hysteresis: 40 m}", last=OVER), ""),
    (
        levels("deep: {above: 40 m, hysteresis: 36 m}", last=f"{OVER}    believed_above: 5 m\n"),
        "depth, deep, is never over: sounder.depth is always above 4 m (40 m with a hysteresis of 36 m), as what is "
        "believed of it goes from 5.01 to 100 m",
    ),
    (
        levels("low: {below: 2 m}", "lowest: {below: 1 m, hysteresis: 100 m}", last=OVER),
        "depth, lowest, is never over: sounder.depth is always below 101 m (1 m with a hysteresis of 100 m), as it "
        "goes from 0 to 100 m",
    ),
    (
        ("vehicle.yaml", SLACK, "    hysteresis: 25.1 %\n"),
        "brine, thin, is never over: hold.brine is always below 30.1 % (5 % with a hysteresis of 25.1 %) or above "
        "30 %, as it goes from 0 to 40 %",
    ),
    (("vehicle.yaml", SLACK, "    hysteresis: 25 %\n"), ""),
]


@pytest.mark.parametrize(("change", "message"), NEVER_OVER, ids=range(len(NEVER_OVER)))
def test_a_hysteresis_that_no_value_is_better_by(folder: Path, change: Change, message: str) -> None:
    """On either side, between two sides, above what is not believed; of a parameter whatever it is set to."""
    assert told(folder, change) == ([("no-good-value", message)] if message else [])


def test_a_hysteresis_and_the_default_of_a_parameter(folder: Path) -> None:
    """With a threshold of at most a metre the level is over, with that of the project never: a warning."""
    change = levels("low: {below: SHALLOW}", last=f"{OVER}    hysteresis: 99 m\n")
    assert told(folder, change) == [
        (
            "no-good-default",
            "depth, low, is never over: sounder.depth is always below 100.5 m (SHALLOW with a hysteresis of 99 m), as "
            "it goes from 0 to 100 m",
        )
    ]


BELIEVED = [
    ("low: {below: SHALLOW}", "5 m", "sounder.depth below SHALLOW, 1.5 m by default, never holds"),
    ("low: {below: SHALLOW}", "1.49 m", "sounder.depth below SHALLOW, 1.5 m by default, never holds"),
    ("low: {below: SHALLOW}", "1.48 m", ""),
    ("low: {below: 5 m}", "100 m", "sounder.depth below 5 m never holds"),
    ("deep: {above: 40 m}", "39.99 m", ""),
]


@pytest.mark.parametrize(("level", "believed", "message"), BELIEVED, ids=range(len(BELIEVED)))
def test_what_is_not_believed_cannot_be_bad(folder: Path, level: str, believed: str, message: str) -> None:
    """A threshold below which nothing is believed, whatever it is, or by default."""
    unknown = f": what is not above {believed} counts as unknown (believed_above)"
    found = [("threshold-out-of-reach", f"{message}{unknown}")] if message else []
    assert told(folder, levels(level, last=f"    believed_above: {believed}\n")) == found


@pytest.mark.parametrize("believed", ["40 m", "50 m"])
def test_where_all_that_is_believed_is_bad(folder: Path, believed: str) -> None:
    """What is believed begins at the threshold, or beyond it, where it would hold only further on than it says."""
    change = levels("deep: {above: 40 m}", last=f"    believed_above: {believed}\n")
    reach = f"as what is believed of it goes from {believed[:2]}.01 to 100 m"
    message = f"depth is always up: sounder.depth is always above 40 m, {reach}"
    assert told(folder, change) == [("no-good-value", message)]


@pytest.mark.parametrize("quantity", ["vehicle.load", "motor.level"])
def test_what_the_program_keeps_is_never_unknown(folder: Path, quantity: str) -> None:
    """It has a value from the start on, and nothing takes it away; mode, too, where code does not set it."""
    change = ("vehicle.yaml", "  depth:\n    watches: sounder.depth", f"  depth:\n    watches: {quantity}")
    message = f"{quantity} is never unknown: the program keeps it from the start on"
    found = told(folder, change, ("vehicle.yaml", ARM, ""), levels("lost: {unknown: true}"))
    assert found == [("known-for-ever", message)]
