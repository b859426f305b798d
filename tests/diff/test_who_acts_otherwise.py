"""Whatever lets the vehicle act otherwise, or tells another number, is no harmless news."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.diff.change import Change, Weight
from codegen.diff.report.review import review
from codegen.diff.system.system import compare_systems
from codegen.model.system import System
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[2]
ROVER, BOAT, SENSORS, COMMANDED = "", "watched_boat", "sensors", "commanded"
STORED = "where no value is stored"


def systems(specs: Path) -> tuple[System, ...]:
    """The systems of a project, which has no error."""
    report = Report()
    found = read_systems(str(specs / "codegen.yaml"), report)
    assert not report.has_errors, list(report)
    return found


def compared(tmp_path: Path, project: str, *edits: tuple[str, str, str], back: bool = False) -> list[Change]:
    """The findings of edits ``(file, old, new)`` of a copy of a project, what follows from another one left out."""
    home = ROOT / "tests" / "projects" / project if project else ROOT
    specs = Path(shutil.copytree(home / "specs", tmp_path / "specs"))
    before = systems(specs)
    for file, old, new in edits:
        text = (specs / file).read_text()
        assert old in text, f"{old!r} is not in {file}"
        (specs / file).write_text(text.replace(old, new, 1))
    sides = (systems(specs), before) if back else (before, systems(specs))
    return [group.first for group in review("", "", compare_systems(*sides)).groups]


QUESTIONS = {
    "point of a curve": ("radio_rover", "board.yaml", "3.9 V: 80", "3.9 V: 82", "whether it still gives"),
    "represented instance": (
        *(ROVER, "messages/sys_status.yaml", "{battery: {parameter: BATT_SYS_STATUS}}", "{battery: {first: true}}"),
        "whether receivers are to be told of another battery, the first",
    ),
    "rounding": (
        *(ROVER, "messages/sys_status.yaml", "voltage_battery: {", "voltage_battery: {rounding: down, "),
        "whether receivers are to get other numbers for the same amount",
    ),
    "action by default": (
        *(BOAT, "parameters.yaml", "does., type: uint8, default: 1", "does., type: uint8, default: 2"),
        f"whether another value is meant for the warm action of the failsafe of motor.temperature, {STORED}",
    ),
    "threshold by default": (
        *(BOAT, "parameters.yaml", "unit: m, default: 1.5", "unit: m, default: 1.2"),
        f"whether another value is meant for the shallow threshold of the failsafe of sounder.depth, {STORED}",
    ),
    "least to arm by default": (
        *(BOAT, "parameters.yaml", "unit: m, default: 2", "unit: m, default: 1"),
        f"whether another value is meant for the least sounder.depth to arm with, {STORED}",
    ),
    "switch by default": (
        *(BOAT, "parameters.yaml", "watched., type: uint8, default: 1", "watched., type: uint8, default: 0"),
        f"whether another value is meant for whether the failsafe of the ground station is on, {STORED}",
    ),
    "age": (
        *(BOAT, "state.yaml", "max: 100, stale_after: 3 s", "max: 100, stale_after: 9 s"),
        "whether it is to be unknown just then, which failsafe depth, failsafe echo may wait for",
    ),
    "failures": (SENSORS, "state.yaml", "invalid_after: 3", "invalid_after: 30", "whether it is to be unknown"),
    "warning": (ROVER, "state.yaml", "warn_above: 4.3333", "warn_above: 4.2", "whether the warning is to be given"),
    "silence of a sensor": (
        *(SENSORS, "board.yaml", "driver: nmea,", "driver: nmea, silence: 9 s,"),
        "whether it has failed when it is silent for so long",
    ),
    "armed or not": (
        *(COMMANDED, "commands.yaml", "    allowed: disarmed\n", ""),
        "whether the vehicle may do it while it is armed",
    ),
    "sender": (COMMANDED, "commands.yaml", "    from: ground_station\n", "", "whether others than before may give it"),
    "long": (COMMANDED, "commands.yaml", "    long: true\n", "", "whether who gives it counts on its taking long"),
    "sender of a message": (
        *("received", "receives/rc_channels_override.yaml", "from: ground_station", "from: any"),
        "whether what others send, or send otherwise, is to be obeyed",
    ),
    "condition of a message": (
        *("received", "receives/gps_input.yaml", "where: {gps_id: 0}\n", ""),
        "whether what others send, or send otherwise, is to be obeyed",
    ),
    "loop": (BOAT, "vehicle.yaml", "rate: 50 Hz, links: 50 Hz", "rate: 25 Hz, links: 25 Hz", "whether code that"),
    "board": (BOAT, "board.yaml", "board: pico_2_w", "board: pico_w", "whether what is connected was changed with it"),
    "network": (
        *("guarded", "board.yaml", "credentials: wifi.json", "credentials: net.json"),
        "whether net.json is on boards, for the same network",
    ),
    "receiver trusts": (ROVER, "receiver.yaml", "stale_after: 10 s", "stale_after: 20 s", "whether nothing is to"),
    "receiver averages": (ROVER, "receiver.yaml", "rate_over: 30 s", "rate_over: 60 s", "how long something lasts"),
    "role": (ROVER, "receiver.yaml", "counted_anew: true", "counted_anew: false", "how long something lasts"),
    "used": (
        *("power_monitor", "parameters.yaml", "max: 10, step: 0.001, reboot: true", "max: 10, step: 0.001"),
        "whether who sets it counts on its being used at once",
    ),
    "step": (BOAT, "parameters.yaml", "step: 0.5, req", "step: 1, req", "between the steps"),
}  # fmt: skip


@pytest.mark.parametrize("name", QUESTIONS)
def test_it_is_a_question(name: str, tmp_path: Path) -> None:
    """Each edit is one of a project, and fails unless a person has said that it is meant."""
    project, file, old, new, said = QUESTIONS[name]
    found = compared(tmp_path, project, (file, old, new))
    asked = [change for change in found if said in change.doubt]
    assert asked, [(change.rule.id, change.doubt) for change in found]
    assert all(change.weight is Weight.PERSON for change in asked)


HARMLESS = {
    "where a curve is kept": ("radio_rover", "board.yaml", "3.9 V: 80", "3900 mV: 80"),
    "how often it is warned": (ROVER, "state.yaml", "warn_every: 10 s", "warn_every: 20 s"),
    "shorter checks": (BOAT, "vehicle.yaml", "rate: 50 Hz, links: 50 Hz", "rate: 50 Hz, links: 50 Hz, checks: 20 Hz"),
    "time of a link": (
        *("networked", "board.yaml", "timeout: 6 s, requirement: FR-701.3", "timeout: 7 s, requirement: FR-701.3"),
    ),
    "finer steps": (BOAT, "parameters.yaml", "step: 0.5, req", "step: 0.25, req"),
}  # fmt: skip


@pytest.mark.parametrize("name", HARMLESS)
def test_the_same_deed_asks_nothing(name: str, tmp_path: Path) -> None:
    """The same amount in other words, and what neither a number nor a deed depends on."""
    project, *edit = HARMLESS[name]
    found = compared(tmp_path, project, (edit[0], edit[1], edit[2]))
    assert all(change.weight.is_harmless for change in found), [(change.rule.id, change.doubt) for change in found]


def test_what_was_told_of_each_and_is_told_of_one_breaks() -> None:
    """Of the other instances nobody hears anything more; the other way round somebody has to tell them apart."""
    rover = systems(ROOT / "specs")[0]
    message = next(each for each in rover.messages if each.component is not None and each.component.instances > 1)
    single = tuple(replace(each, component=None) if each is message else each for each in rover.messages)
    other = replace(rover, messages=single)
    for sides, weight, said in (
        ((rover, other), Weight.BREAKING, "receivers hear nothing of any other battery"),
        ((other, rover), Weight.PERSON, "whether receivers tell the instances apart"),
    ):
        found = compare_systems(*((side,) for side in sides)).changes
        (change,) = [each for each in found if each.rule.id == "message-instances-changed"]
        assert (change.weight, change.effect or change.doubt) == (weight, said)
