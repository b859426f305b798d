"""Changes of commands and modes: each attribute of them is told, and what breaks whom."""

import shutil
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from test_every_attribute_of_a_system import mutants, said_once, siblings_of

from codegen.diagnostics import Report
from codegen.diff.change import Change, Weight
from codegen.diff.report.review import review
from codegen.diff.system.system import compare_systems
from codegen.model.command import Command
from codegen.model.system import System
from codegen.model.units.unit import unit_named
from codegen.project.systems import read_systems

SPECS = Path(__file__).resolve().parents[1] / "projects" / "commanded" / "specs"
FOUND_BY = {"Command.name", "Mode.number", "CommandParam.number"}


@pytest.fixture(scope="module")
def boat() -> System:
    return read_systems(str(SPECS / "codegen.yaml"), Report())[0]


def test_each_attribute_of_a_command_and_of_a_mode_is_told(boat: System, monkeypatch: pytest.MonkeyPatch) -> None:
    """One that is missed would be a change that nobody reviews."""
    program = boat.program
    assert program is not None
    tried = set()
    said_once(boat, monkeypatch)
    siblings = siblings_of(boat)
    for kind in ("commands", "modes"):
        for place, record in enumerate(getattr(program, kind)):
            for name, changed in mutants(record, siblings, set()):
                each = (*getattr(program, kind)[:place], changed, *getattr(program, kind)[place + 1 :])
                other = replace(boat, program=replace(program, **{kind: each}))
                tried.add(name)
                assert compare_systems((boat,), (other,)).changes, name
    assert tried >= FOUND_BY | {
        "Command.params",
        "AffineMap.factor",
        "CommandParam.default",
        "Mode.base",
        "Mode.name",
    }


EDITS = [
    ("commands.yaml", "min: 0, max: 60", "min: 0, max: 30", {"command-range-changed"}),
    ("commands.yaml", "max: 100, default: 50", "max: 100, default: null", {"command-range-changed", "command-unit-changed"}),
    ("commands.yaml", "unchanged: [-1], ", "", {"command-unit-changed"}),
    ("commands.yaml", "unchanged: [-1, -2, NaN]", "unchanged: [-1, NaN]", {"command-unit-changed"}),
    ("commands.yaml", "max: 100, default: 50", "max: 100", {"command-range-changed"}),
    ("commands.yaml", "name: duration, unit: s", "name: duration, unit: min", {"command-unit-changed", "command-range-changed", "command-changed"}),
    ("commands.yaml", "unit: km/h, default: 3.6, max: 36", "unit: m/s, default: 1, max: 10", {"command-changed"}),
    ("commands.yaml", "unit: km/h, default: 3.6, max: 36", "unit: m/s, default: 1, max: 36", {"command-range-changed", "command-changed"}),
    ("commands.yaml", "unit: km/h, default: 3.6, max: 36", "unit: km/h, default: 3.60, max: 36.0", set()),
    ("commands.yaml", "max: 500, scaled: 1e4", "max: 500, scaled: 1e3", {"command-unit-changed"}),
    ("commands.yaml", "allowed: armed", "allowed: always", {"command-changed"}),
    ("commands.yaml", "allowed: armed", "allowed: disarmed", {"command-changed!"}),
    ("commands.yaml", "    from: ground_station\n", "", {"command-changed"}),
    ("commands.yaml", "    method: pump\n", "    method: pump\n    from: ground_station\n", {"command-changed!"}),
    ("commands.yaml", "method: sound_horn", "method: honk", {"command-changed"}),
    ("commands.yaml", "MAV_CMD_USER_3", "MAV_CMD_WAYPOINT_USER_5", {"command-removed", "command-added"}),
    ("vehicle.yaml", "  11: {name: RTL", "  12: {name: RTL", {"mode-removed", "mode-added"}),
    ("vehicle.yaml", "name: RTL", "name: RETURN", {"mode-changed"}),
    ("vehicle.yaml", "It comes back., base: [guided]", "It comes back.", {"mode-changed"}),
]  # fmt: skip
BREAKING = {"command-removed", "command-unit-changed", "mode-removed"}


def edited(boat: System, folder: Path, *edits: tuple[str, str, str]) -> tuple[Change, ...]:
    """The changes after edits ``(file, old, new)`` of a copy of the project."""
    shutil.copytree(SPECS, folder / "specs", dirs_exist_ok=True)
    for file, old, new in edits:
        path = folder / "specs" / file
        assert old in path.read_text()
        path.write_text(path.read_text().replace(old, new, 1))
    (changed,) = read_systems(str(folder / "specs" / "codegen.yaml"), Report())
    return compare_systems((boat,), (changed,)).changes


@pytest.mark.parametrize(("file", "old", "new", "rules"), EDITS)
def test_an_edit_has_its_weight(boat: System, tmp_path: Path, file: str, old: str, new: str, rules: set[str]) -> None:
    """A command that a ground station can no longer give, or not then, breaks it; another limit does not."""
    changes = edited(boat, tmp_path, (file, old, new))
    assert {change.rule.id for change in changes} == {rule.removesuffix("!") for rule in rules}
    breaking = BREAKING | {rule.removesuffix("!") for rule in rules if rule.endswith("!")}
    assert all(bool(change.breaks) is (change.rule.id in breaking) for change in changes)


def judged(old: System, new: System) -> dict[str, Change]:
    """The findings of a comparison by rule and subject, those left out that follow from one of the dialect."""
    return {
        f"{group.first.rule.id} {group.subject}": group.first
        for group in review("", "", compare_systems((old,), (new,))).groups
    }


def with_commands(boat: System, edit: Callable[[Command], Command]) -> System:
    """The boat, each of its commands edited, and the dialect with the numbers and names that they have then."""
    program, enums = boat.program, boat.dialect.enums
    assert program is not None
    edited = {command.name: edit(command) for command in program.commands}
    entries = tuple(
        entry._replace(name=edited[entry.name].name, value=edited[entry.name].number) if entry.name in edited else entry
        for entry in enums["MAV_CMD"].entries
    )
    dialect = replace(boat.dialect, enums={**enums, "MAV_CMD": replace(enums["MAV_CMD"], entries=entries)})
    return replace(boat, dialect=dialect, program=replace(program, commands=tuple(edited.values())))


HORN, LIGHTS = "MAV_CMD_USER_3", "MAV_CMD_USER_2"


def test_numbers_that_change_places_are_silent_breaks(boat: System) -> None:
    """Who sends the number of the horn sets the lights: nothing refuses it. It is told once for each of the two."""
    numbers = {each.name: each.number for each in boat.program.commands if each.name in (HORN, LIGHTS)}
    other = {HORN: numbers[LIGHTS], LIGHTS: numbers[HORN]}
    found = judged(boat, with_commands(boat, lambda each: replace(each, number=other.get(each.name, each.number))))
    assert {name: change.weight for name, change in found.items() if name.startswith("enum")} == {
        f"enum-entry-value-changed MAV_CMD.{name}": Weight.SILENT for name in (HORN, LIGHTS)
    }
    assert not [change for change in found.values() if change.rule.id.startswith("command")]


def test_a_number_of_its_own_is_a_break_of_who_sends_the_old_one(boat: System) -> None:
    """Without a word of the dialect, too: the old number is refused, and the report says which one it is now."""
    program = boat.program
    other = tuple(replace(each, number=31999) if each.name == HORN else each for each in program.commands)
    found = judged(boat, replace(boat, program=replace(program, commands=other)))
    assert {name: change.weight for name, change in found.items()} == {
        f"command-removed {HORN}": Weight.BREAKING,
        f"command-added {HORN}": Weight.HARMLESS,
    }
    assert "it is 31999 now" in found[f"command-removed {HORN}"].effect


def test_methods_that_change_places_are_silent_breaks_and_an_unknown_one_is_a_question(boat: System) -> None:
    """The number is as before, and another deed is done; the name of a method may be nothing but a name."""

    def method(names: dict[str, str]) -> System:
        return with_commands(
            boat, lambda each: replace(each, spec=replace(each.spec, method=names.get(each.name, each.spec.method)))
        )

    swapped = judged(boat, method({HORN: "set_lights", LIGHTS: "sound_horn"}))
    assert {name: change.weight for name, change in swapped.items()} == {
        f"command-changed {name}": Weight.SILENT for name in (HORN, LIGHTS)
    }
    (renamed,) = judged(boat, method({HORN: "honk"})).values()
    assert renamed.doubt == "whether honk() does what sound_horn() did"


def test_another_name_of_a_number_breaks_nobody(boat: System) -> None:
    """The vehicle does what it did: whoever sends the number gets that, whatever the words of the name."""

    def called(command: Command, **more: object) -> Command:
        return replace(command, name="MAV_CMD_ANCHOR", **more) if command.name == HORN else command

    (change,) = judged(boat, with_commands(boat, called)).values()
    assert (change.rule.id, change.weight) == ("enum-entry-renamed", Weight.HARMLESS)
    assert change.effect == "the vehicle does the same for its number"
    program = boat.program
    same_dialect = replace(boat, program=replace(program, commands=tuple(map(called, program.commands))))
    (change,) = judged(boat, same_dialect).values()
    assert (change.old, change.new, change.weight) == (f"called {HORN}", "called MAV_CMD_ANCHOR", Weight.HARMLESS)
    other = with_commands(boat, lambda each: called(each, spec=replace(each.spec, method="drop")))
    assert not all(change.weight.is_harmless for change in judged(boat, other).values())


QUESTIONS = [
    ("commands.yaml", "min: 0, max: 60", "min: 0, max: 30", "whether duration is sent that is refused now"),
    ("commands.yaml", "min: 0, max: 60", "min: 5, max: 60", "whether duration is sent that is refused now"),
    ("commands.yaml", "min: 0, max: 60", "min: 0, max: 90", ""),
    ("commands.yaml", "max: 100, default: 50", "max: 100, default: 60", "whether who sends NaN for power means the other value"),
    ("commands.yaml", "max: 100, default: 50", "max: 100", "whether who sends NaN for power means the other value"),
    ("commands.yaml", "name: level, min", "name: level, default: 0, min", ""),
    ("commands.yaml", "unit: km/h, default: 3.6, max: 36", "unit: m/s, default: 1, max: 10", "whether go_to() takes speed in m/s"),
    ("commands.yaml", "name: level", "name: brightness", ""),
    ("vehicle.yaml", "name: RTL", "name: GO_RTL", ""),
    ("vehicle.yaml", "name: RTL", "name: ANCHOR", "whether ANCHOR is another name of RTL"),
    ("vehicle.yaml", "It comes back., base: [guided]", "It comes back.", "whether stations are to be told of other flags in this mode"),
]  # fmt: skip


@pytest.mark.parametrize(("file", "old", "new", "doubt"), QUESTIONS)
def test_what_a_person_is_asked(boat: System, tmp_path: Path, file: str, old: str, new: str, doubt: str) -> None:
    """Who may be refused, or get something else; names, and what is taken beside, ask nothing."""
    assert doubt in {change.doubt for change in edited(boat, tmp_path, (file, old, new)) if not change.breaks}
    assert doubt or all(change.weight.is_harmless for change in edited(boat, tmp_path, (file, old, new)))


def test_arguments_and_modes_that_change_places(boat: System, tmp_path: Path) -> None:
    """Names of arguments in another order may be another order; a mode's number that had another name is another mode."""
    exchanged = ("commands.yaml", "3: {name: level, min: -0.5, max: 0.1}\n      1: {name: lamps,"), "lamps, level"
    (file, old), order = exchanged
    new = old.replace("level", "x").replace("lamps", "level").replace("name: x", "name: lamps")
    (change,) = [each for each in edited(boat, tmp_path, (file, old, new)) if each.rule.id == "command-changed"]
    assert change.doubt == f"whether what is sent as before is meant in the order {order}"
    swapped = (
        ("vehicle.yaml", "11: {name: RTL", "15: {name: RTL"),
        ("vehicle.yaml", "15: {name: GUIDED", "11: {name: GUIDED"),
    )
    modes = [each for each in edited(boat, tmp_path, *swapped) if each.rule.id == "mode-changed"]
    assert {change.subject: change.weight for change in modes} == {"mode 11": Weight.SILENT, "mode 15": Weight.SILENT}


def test_what_reads_alike_is_told_as_it_is_compared(boat: System) -> None:
    """No report says that 0 to 60 s was 0 to 60 s before."""
    milli = replace(unit_named("ms"))

    def other(command: Command) -> Command:
        params = tuple(
            replace(param, wire_unit=milli) if param.name == "duration" else param for param in command.params
        )
        return replace(command, params=params)

    for change in compare_systems((boat,), (with_commands(boat, other),)).changes:
        assert change.old != change.new, change


def test_what_the_dialect_says_of_an_answered_command_concerns_the_project(boat: System) -> None:
    """Whether it has a location decides how a station sends its parameters."""
    enum = boat.dialect.enums["MAV_CMD"]
    for name, count in ((HORN, 1), ("MAV_CMD_REQUEST_MESSAGE", 1), ("MAV_CMD_NAV_LAND", 0)):
        entries = tuple(
            each._replace(traits=(("hasLocation", "maybe"),)) if each.name == name else each for each in enum.entries
        )
        dialect = replace(boat.dialect, enums={**boat.dialect.enums, "MAV_CMD": replace(enum, entries=entries)})
        found = compare_systems((boat,), (replace(boat, dialect=dialect),))
        assert (len(found.changes), len(found.elsewhere)) == (count, 1 - count)
