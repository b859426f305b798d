"""What a vehicle does by itself: where another thing is done for the same event, or nothing, a person is asked."""

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.diff.change import Change, Weight
from codegen.diff.report.review import fails, review
from codegen.diff.system.system import Comparison, compare_systems
from codegen.model.system import System
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[1] / "projects" / "watched_boat" / "specs"
VEHICLE = "vehicle.yaml"
HOT = "whether what is watched for and done at hot is meant"

Compare = Callable[..., tuple[Change, ...]]


def systems(folder: Path) -> tuple[System, ...]:
    """The systems of a project, which has nothing that is reported."""
    report = Report()
    found = read_systems(str(folder / "codegen.yaml"), report)
    assert not report.has_errors, list(report)
    return found


@pytest.fixture(scope="module")
def boat() -> tuple[System, ...]:
    return systems(SPECS)


@pytest.fixture
def compare(boat: tuple[System, ...], tmp_path: Path) -> Compare:
    """The changes of edits ``(file, old, new)``; the other way round with ``back``."""

    def changes(*edits: tuple[str, str, str], back: bool = False) -> tuple[Change, ...]:
        specs = Path(shutil.copytree(SPECS, tmp_path / "specs", dirs_exist_ok=True))
        for file, old, new in edits:
            text = (specs / file).read_text()
            assert text.count(old) >= 1, f"{old!r} is not in {file}"
            (specs / file).write_text(text.replace(old, new, 1))
        sides = (systems(specs), boat) if back else (boat, systems(specs))
        return compare_systems(*sides).changes

    return changes


ECHO = SPECS.joinpath(VEHICLE).read_text().partition("  echo:\n")[2].partition("  ground_station:\n")[0]
QUESTIONS: dict[str, tuple[str, str, str]] = {
    "removed": (f"  echo:\n{ECHO}", "", "whether nothing is to watch sounder.depth so any more"),
    "level removed": (
        "      gone: {after: 60 s, requirement: FR-201.4}\n",
        "",
        "whether what is watched for and done at gone is meant",
    ),
    "text only": ("        action: stop\n", "", HOT),
    "another action": ("        action: stop\n", "        action: slow\n", HOT),
    "threshold": ("above: 100 degC", "above: 110 degC", HOT),
    "time": ("after: 500 ms", "after: 900 ms", HOT),
    "condition dropped": ("        or: [{watches: motor.current, above: 40 A, after: 500 ms}]\n", "", HOT),
    "hysteresis": ("hysteresis: 5 degC", "hysteresis: 6 degC", HOT),
    "latched": (
        "    latch: false\n    over: Ground station is heard again\n",
        "",
        "whether a level is to stay until the next start",
    ),
    "looks": ("    when: always\n", "", "whether it is to look while the vehicle is armed"),
    "arming": ("    arming: false\n", "", "whether the vehicle may be armed then"),
    "to arm": ("    to_arm: [{below: DEPTH_ARM}]\n", "", "whether the vehicle may be armed then"),
    "switch": (
        "    enabled_by: FS_GCS_ENABLE\n",
        "",
        "whether who has switched it off, or not, means this one",
    ),
    "level told": ("    level: level\n", "", "whether who is told of it is told there"),
    "disarm": ("call: stop, disarm: true", "call: stop", "whether stop need not disarm the vehicle"),
    "mode": ("call: slow, mode: 5", "call: slow, mode: 6", "whether slow is to report this mode"),
    "force": ("force: 21196", "force: 2", "whether who arms by force sends this number"),
    "storage": ("parameters.1]", "parameters.2]", "whether what is stored on boards may be lost"),
    "silence": (
        "services: {fastest: 10 Hz}",
        "services: {fastest: 10 Hz, silence: 3 s}",
        "whether stations that are silent for so long are gone",
    ),
    "fastest": ("fastest: 10 Hz", "fastest: 5 Hz", "whether what is asked for is sent often enough"),
}


@pytest.mark.parametrize("name", QUESTIONS)
def test_another_thing_for_the_same_event_is_a_question(name: str, compare: Compare) -> None:
    """It fails by default, and stands in the headline."""
    old, new, doubt = QUESTIONS[name]
    found = compare((VEHICLE, old, new))
    assert doubt in "; ".join(change.doubt for change in found)
    told = review("", "", Comparison(found))
    assert "a person" in told.head_line
    assert fails(told, ["person"])


HARMLESS = {
    "title": ("    watches: motor.temperature\n", "    watches: motor.temperature\n    title: The motor\n"),
    "text": ('text: "No echo for 5 s"', 'text: "No echo any more"'),
    "over": ("over: Ground station is heard again", "over: Ground station is back"),
    "doc": ("doc: Stop the screw.", "doc: Stops the screw."),
    "criterion": ("shallow: {below: SHALLOW, action: stop, after: 1 s, requirement: FR-201.2}",
                  "shallow: {below: SHALLOW, action: stop, after: 1 s, requirement: FR-201.1}"),
    "faster": ("fastest: 10 Hz", "fastest: 20 Hz"),
    "same amount": ("above: 100 degC", "above: 373.15 K"),
}  # fmt: skip


@pytest.mark.parametrize("name", HARMLESS)
def test_what_does_the_same_asks_nothing(name: str, compare: Compare) -> None:
    """Names, texts and reasons, and the same amount in another unit."""
    found = compare((VEHICLE, *HARMLESS[name]))
    assert all(change.weight.is_harmless for change in found), found


def test_how_a_quantity_is_kept_is_no_other_threshold(compare: Compare) -> None:
    """A limit in whole steps is another number then, and the same temperature."""
    text = (SPECS / "state.yaml").read_text()
    line = next(one for one in text.splitlines() if one.strip().startswith("temperature:"))
    assert "stored: cdegC" in line
    found = compare(("state.yaml", line, line.replace("cdegC", "mdegC")))
    assert found
    assert not [change for change in found if change.rule.id == "failsafe-changed"]


@pytest.mark.parametrize("name", ["removed", "level removed", "condition dropped"])
def test_what_comes_asks_nothing(name: str, compare: Compare) -> None:
    """A failsafe or a level more takes nothing from anybody; a condition more of a level that there is, does."""
    old, new, _ = QUESTIONS[name]
    found = [change for change in compare((VEHICLE, old, new), back=True) if change.rule.id == "failsafe-changed"]
    assert found
    assert bool([change for change in found if change.doubt]) is (name == "condition dropped")


def test_numbers_of_actions_that_change_places_are_silent(compare: Compare) -> None:
    """The number is stored on boards as the value of a parameter: another thing is done for it, and nothing tells."""
    swapped = (
        (VEHICLE, "value: 1, call: slow, mode: 5, doc: Go on slowly.", "value: 1, call: stop, disarm: true, doc: S."),
        (VEHICLE, "value: 2, call: stop, disarm: true, doc: Stop the screw.", "value: 2, call: slow, mode: 5, doc: G."),
    )
    found = [change for change in compare(*swapped) if change.subject.startswith("failsafe action")]
    told = {change.subject: change.weight for change in found if change.rule.id == "failsafe-changed"}
    assert told == {"failsafe action 1": Weight.SILENT, "failsafe action 2": Weight.SILENT}
    assert "where 1 is stored for slow, stop is done" in found[0].effect


def test_another_order_of_severity_is_asked_once(boat: tuple[System, ...]) -> None:
    """Where both are asked for, the other one is done."""
    program = boat[0].program
    assert program is not None
    other = replace(boat[0], program=replace(program, priority=program.priority[::-1]))
    found = [change for change in compare_systems(boat, (other,)).changes if change.doubt]
    assert [change.doubt for change in found] == ["whether slow is to come before stop"]


def test_a_program_that_hears_or_says_less_is_asked_about(boat: tuple[System, ...]) -> None:
    """Who sends what is not heard any more, or waits for what is not sent, may not notice."""
    program = boat[0].program
    assert program is not None
    less = {
        "services": f"whether anybody still sends {program.services[-1].name}",
        "sent": f"whether anybody waits for {program.sent[-1]}",
    }
    for part, doubt in less.items():
        other = replace(boat[0], program=replace(program, **{part: getattr(program, part)[:-1]}))
        for sides, expected in (((boat, (other,)), [doubt]), (((other,), boat), [])):
            assert [change.doubt for change in compare_systems(*sides).changes if change.doubt] == expected


def test_a_watchdog_that_waits_longer_is_asked_about() -> None:
    """Or one that is gone; one that is quicker than it was, and a new one, asks nothing."""
    rover = read_systems(str(SPECS.parents[3] / "specs" / "codegen.yaml"), Report())[0]
    program = rover.program
    assert program is not None
    assert program.watchdog is not None
    longer = replace(program.watchdog, timeout_ms=program.watchdog.timeout_ms + 1)
    for watchdog in (longer, None):
        other = replace(rover, program=replace(program, watchdog=watchdog))
        there, back = (compare_systems(*sides).changes for sides in (((rover,), (other,)), ((other,), (rover,))))
        assert [each.doubt for each in there if each.doubt] == ["whether a loop may stand still for so long"]
        assert not [each.doubt for each in back if each.doubt]
