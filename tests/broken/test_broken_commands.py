"""Commands and modes with a fault: each is reported at its line and column, and alone.

A case changes one file of the commanded boat: ``old`` becomes ``new``, in which ``§`` marks the place.
"""

import shutil
from pathlib import Path

import pytest
from test_broken_tables import ROOT, Case, name_of

from codegen.cli import main
from codegen.diagnostics import MOST

COMMANDS, VEHICLE, STATE = "commands.yaml", "vehicle.yaml", "state.yaml"
HORN = "  MAV_CMD_USER_3: {doc: Sounds the horn., method: sound_horn, requirement: FR-301.2}"
DURATION = "1: {name: duration, unit: s, min: 0, max: 60}"
LAMPS = "1: {name: lamps, whole: true, min: 0, max: 3}"
ANGLE = "1: {name: angle, unit: rad}"


def horn(text: str) -> str:
    """The horn's command with something more, or otherwise."""
    return HORN.replace("requirement: FR-301.2", text)


NORTH = "6: {name: north, min: -500, max: 500, scaled: 1e4}"
CASES = [
    Case("unknown-enum-entry", COMMANDS, "  MAV_CMD_USER_1:", "  §MAV_CMD_USR_1:", "did you mean MAV_CMD_USER_1"),
    Case("built-in-command", COMMANDS, HORN, HORN.replace("  MAV_CMD_USER_3", "  §MAV_CMD_COMPONENT_ARM_DISARM"), "arming in vehicle.yaml says how"),
    Case("built-in-command", COMMANDS, HORN, HORN.replace("  MAV_CMD_USER_3", "  §MAV_CMD_DO_SET_MODE"), "modes in vehicle.yaml declares them"),
    Case("built-in-command", COMMANDS, HORN, HORN.replace("  MAV_CMD_USER_3", "  §MAV_CMD_REQUEST_MESSAGE"), "every program answers it"),
    Case("bad-command", COMMANDS, "method: sound_horn", "method: §Horn", "Horn cannot be the name of a method"),
    Case("bad-command", COMMANDS, "method: sound_horn", "method: §class", "class cannot be the name of a method"),
    Case("bad-command", COMMANDS, "method: sound_horn", "method: §arm", "arm cannot be the name of a method"),
    Case("bad-command", COMMANDS, "method: sound_horn", "method: §pump_progress", "pump_progress cannot be"),
    Case("bad-command", COMMANDS, "method: sound_horn", "method: §pump", "takes long for one command"),
    Case("bad-command", VEHICLE, "modes:", "actions: [{value: 1, call: go_to, doc: Go.}]\nmodes:", "what a failsafe calls", at=f"{COMMANDS}:21:13", is_alone=False),
    Case("bad-command", VEHICLE, "arming: {force: 21196}\n", "", "nothing can be armed", at=f"{COMMANDS}:24:14", is_alone=False),
    Case("unknown-key", COMMANDS, HORN, horn("§lang: true"), "did you mean long"),
    Case("unknown-choice", COMMANDS, HORN, horn("allowed: §sometimes")),
    Case("unknown-requirement", COMMANDS, HORN, horn("requirement: §FR-301.20")),
    Case("unknown-aspect", COMMANDS, HORN, horn("criteria: {refusals: §FR-301.4}"), "did you mean refusal"),
    Case("bad-command-parameter", COMMANDS, DURATION, "§8: {name: duration}", "parameters 1 to 7"),
    Case("bad-command-parameter", COMMANDS, DURATION, "§one: {name: duration}", "parameters 1 to 7"),
    Case("bad-command-parameter", COMMANDS, "name: duration", "name: §power", "power cannot be the name", at=f"{COMMANDS}:9:17"),
    Case("bad-command-parameter", COMMANDS, "name: duration", "name: §how long", "how long cannot be the name"),
    Case("bad-command-parameter", COMMANDS, "name: duration", "name: §self", "self cannot be the name"),
    Case("bad-command-parameter", COMMANDS, "min: 0, max: 60", "min: §61, max: 60", "smallest is above its largest"),
    Case("bad-command-parameter", COMMANDS, ANGLE, "1: {name: angle, unit: deg, max: §361}", "beyond what the dialect allows for MAV_CMD_CONDITION_YAW 1: 360"),
    Case("bad-command-parameter", COMMANDS, ANGLE, "1: {name: angle, unit: rad, min: §-0.1}", "0 on the wire"),
    Case("bad-command-parameter", COMMANDS, "max: 100, default: 50", "max: 100, default: §5", "no value that it accepts"),
    Case("bad-command-parameter", COMMANDS, HORN, HORN.replace("§", "") + "\n  MAV_CMD_SPATIAL_USER_1: {doc: d., method: sweep, params: {1: {name: far, default: §1e39}}}", "the default of far is no value that it accepts"),
    Case("bad-command-parameter", COMMANDS, ANGLE, "1: {name: angle, unit: deg, default: §500}", "the default of angle is no value that it accepts"),
    Case("bad-command-parameter", COMMANDS, ANGLE, "1: {name: angle, unit: rad, default: §-0.1}", "the default of angle is no value that it accepts"),
    Case("bad-command-parameter", COMMANDS, ANGLE, "1: {name: angle, unit: deg, max: §361}", "entry: MAV_CMD_CONDITION_YAW, param: 1, set: {maxValue: 361}"),
    Case("missing-value", COMMANDS, "max: 100, default: 50", "§max: , default: 50", "max has no value"),
    Case("missing-value", COMMANDS, "max: 100, default: 50", "max: 100, §default: ", "default has no value"),
    Case("special-value", COMMANDS, LAMPS, "1: {name: lamps, unchanged: §[never]}", "never is no limit of a type"),
    Case("special-value", COMMANDS, LAMPS, "1: {name: lamps, default: 1, unchanged: §[NaN]}", "leave out one of both"),
    Case("bad-command-parameter", COMMANDS, LAMPS, "1: {name: lamps, whole: true, default: §0.5}", "no value that it accepts"),
    Case("bad-command-parameter", COMMANDS, "2: {name: options}", "2: {name: options, default: §4}", "no value that it accepts"),
    Case("bad-command-parameter", COMMANDS, "2: {name: options}", "2: {name: options, enum: §MAV_STATE}", "of MAV_DO_REPOSITION_FLAGS in the dialect"),
    Case("unknown-enum-entry", COMMANDS, LAMPS, "1: {name: lamps, enum: §MAV_STAT}", "did you mean MAV_STATE"),
    Case("bad-command-parameter", COMMANDS, LAMPS, "§1: {name: lamps, whole: true, min: 0.1, max: 0.9}", "no value"),
    Case("bad-command-parameter", COMMANDS, LAMPS, "§1: {name: lamps, enum: MAV_STATE, min: 20}", "no value"),
    Case("unknown-unit", COMMANDS, "name: duration, unit: s", "name: duration, unit: §seconds", "did you mean s"),
    Case("unit-mismatch", COMMANDS, "unit: km/h", "unit: §m", "is in m/s, and m is not"),
    Case("bad-command-frame", COMMANDS, "    frames: [MAV_FRAME_GLOBAL_RELATIVE_ALT_INT]\n", "", "the altitude altitude of MAV_CMD_DO_SET_HOME has no frame", at=f"{COMMANDS}:57:7"),
    Case("bad-command-frame", COMMANDS, "[MAV_FRAME_GLOBAL_RELATIVE_ALT_INT]", "§[MAV_FRAME_GLOBAL, MAV_FRAME_GLOBAL_RELATIVE_ALT]", "is given in MAV_FRAME_GLOBAL and MAV_FRAME_GLOBAL_RELATIVE_ALT"),
    Case("bad-command-frame", COMMANDS, "[MAV_FRAME_GLOBAL_RELATIVE_ALT_INT]", "§[MAV_FRAME_LOCAL_NED]", "has latitude and longitude"),
    Case("unscaled-parameter", COMMANDS, NORTH, "§6: {name: north, min: -500, max: 500}", "MAV_CMD_NAV_LAND_LOCAL 6 is a position ('X-axis position') to the dialect"),
    Case("unscaled-parameter", COMMANDS, NORTH, "§6: {name: north, min: -500, max: 500}", "write scaled: 1e4; scaled: 1 where"),
    Case("unscaled-parameter", COMMANDS, "-1, max: 1, scaled: 1e7,", "-1, max: 1,", "'scaled by 1e7' to the dialect, and flap would get", at=f"{COMMANDS}:106:14"),
    Case("unscaled-parameter", COMMANDS, "[MAV_FRAME_LOCAL_NED]", "[MAV_FRAME_LOCAL_NED, MAV_FRAME_GLOBAL]", "a position in global and local frames", at=f"{COMMANDS}:99:7", is_alone=False),
    Case("unscaled-parameter", COMMANDS, "    frames: [MAV_FRAME_LOCAL_NED]\n", "", "a position in any frames", at=f"{COMMANDS}:98:7", is_alone=False),
    Case("bad-command-parameter", COMMANDS, "lat, unit: degE7}\n      6: {name: lon, unit: deg}", "lat, unit: degE7, scaled: §1e7}\n      6: {name: lon, unit: deg}", "is a latitude, of which COMMAND_INT has 1e-7 degrees"),
    Case("bad-command-parameter", COMMANDS, LAMPS, "1: {name: lamps, scaled: §1e7}", "multiplies parameters 5 and 6 alone"),
    Case("bad-command-parameter", COMMANDS, NORTH, "6: {name: north, scaled: §2.5}", "multiplied by a whole number, not by 2.5"),
    Case("unknown-enum-entry", COMMANDS, "[MAV_FRAME_GLOBAL_RELATIVE_ALT_INT]", "§[MAV_FRAME_GLOBAL_RELATIVE]", "did you mean MAV_FRAME_GLOBAL_RELATIVE_ALT"),
    Case("no-program-for-commands", VEHICLE, None, "", "no program", at=f"{COMMANDS}:1:1"),
    Case("bad-mode", VEHICLE, "  11: {name: RTL", "  §31: {name: RTL", "31 is not a mode"),
    Case("bad-mode", VEHICLE, "  11: {name: RTL", "  §eleven: {name: RTL", "eleven is not a mode"),
    Case("bad-mode", VEHICLE, "name: RTL", "name: §GUIDED", "name of another mode", at=f"{VEHICLE}:10:14"),
    Case("bad-mode", VEHICLE, "base: [steered]", "base: [§stered]", "did you mean steered"),
    Case("bad-mode", VEHICLE, "base: [steered]", "base: [§armed]", "no boolean that a mode can set"),
    Case("bad-mode", VEHICLE, "base: [steered]", "base: [§mode]", "no boolean that a mode can set"),
    Case("bad-mode", VEHICLE, "modes:", "actions: [{value: 1, call: drift, doc: Drift., mode: §12}]\nmodes:", "mode 12, which is not declared", is_alone=False),
    Case("bad-mode", STATE, "max: 30, initial: 4", "max: 30, initial: §5", "begins as 5"),
    Case("bad-mode", STATE, "      mode: {doc: Number of the mode., min: 0, max: 30, initial: 4}\n", "", "no number mode to be set", is_alone=False),
    Case("bad-mode", STATE, "mode: {doc: Number of the mode., min: 0, max: 30, initial: 4}", "mode: {doc: Whether it stays., boolean: true, initial: true}", "no number mode to be set", at=f"{VEHICLE}:7:3", is_alone=False),
]  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, and there is nothing else."""
    shutil.copytree(ROOT / "tests" / "projects" / "commanded" / "specs", tmp_path / "specs")
    path = tmp_path / "specs" / case.file
    wanted = f"specs/{case.at}: " if case.at else ""
    if case.old is None:
        path.unlink()
    else:
        text = path.read_text()
        assert case.old in text
        text = text.replace(case.old, case.new, 1)
        before, mark, _ = text.partition("§")
        if mark and not case.at:
            wanted = f"specs/{case.file}:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}: "
        path.write_text(text.replace("§", ""))
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 1
    printed = capsys.readouterr().out
    errors = [line for line in printed.splitlines() if ": error " in line]
    found = [line for line in errors if f" error {case.rule}: " in line]
    assert any(line.startswith(wanted) for line in found), errors
    assert len(errors) == 1 or not case.is_alone, errors
    assert case.says in printed


def test_a_mode_that_no_command_can_change_to(tmp_path, monkeypatch, capsys):
    """MAV_CMD_DO_SET_MODE has its number in a float: 16777217 would be another mode."""
    shutil.copytree(ROOT / "tests" / "projects" / "commanded" / "specs", tmp_path / "specs")
    for name, old, new in (
        (VEHICLE, "  11: {name: RTL", "  16777217: {name: RTL"),
        (STATE, "max: 30", "max: 20000000"),
    ):
        path = tmp_path / "specs" / name
        path.write_text(path.read_text().replace(old, new))
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 1
    printed = capsys.readouterr().out
    assert (
        "error bad-mode: MAV_CMD_DO_SET_MODE cannot change to 16777217: its float of 32 bits makes 16777216" in printed
    )
    assert "hint: take 16777216, or a number up to 16777216" in printed


def test_a_command_that_programs_answer_otherwise_only(tmp_path, monkeypatch, capsys):
    """Without modes MAV_CMD_DO_SET_MODE is the project's own, and COMMAND_CANCEL may be missing."""
    shutil.copytree(ROOT / "tests" / "projects" / "commanded" / "specs", tmp_path / "specs")
    vehicle, commands, project = (tmp_path / "specs" / name for name in (VEHICLE, COMMANDS, "codegen.yaml"))
    vehicle.write_text(vehicle.read_text().partition("modes:")[0])
    commands.write_text(commands.read_text().replace("MAV_CMD_USER_3", "MAV_CMD_DO_SET_MODE"))
    project.write_text(project.read_text().replace("overlays", "# overlays"))
    monkeypatch.chdir(tmp_path)
    assert main(["build"]) == 0, capsys.readouterr().out
    built = {path.name for path in Path("generated/firmware").iterdir()}
    assert {"own_commands.py", "long_commands.py"} <= built
    assert not {"mode_service.py", "command_cancel.py"} & built


def test_of_thousands_of_unknown_commands_those_that_are_shown_have_a_hint(tmp_path, monkeypatch, capsys):
    """The nearest names of so many commands are looked for as often as somebody reads them."""
    shutil.copytree(ROOT / "tests" / "projects" / "commanded" / "specs", tmp_path / "specs")
    commands = tmp_path / "specs" / COMMANDS
    unknown = "".join(f"  MAV_CMD_USER_1{n}: {{method: m{n}, doc: d, allowed: always}}\n" for n in range(2000))
    commands.write_text(commands.read_text().replace("commands:\n", f"commands:\n{unknown}", 1))
    asked = []
    monkeypatch.setattr("codegen.resolve.commands.commands.did_you_mean", lambda name, _: asked.append(name) or "x")
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 1
    assert 0 < len(asked) <= MOST
    out = capsys.readouterr().out
    assert out.count(" error unknown-enum-entry: MAV_CMD has no entry MAV_CMD_USER_1") == MOST
    assert out.count("\n  hint: x\n") == MOST


@pytest.mark.parametrize(
    ("params", "says"),
    [
        ("2: {name: power}, 1: {name: duration, unit: s}", "pump is given power here, and duration in s for"),
        ("1: {name: duration, unit: min}", "pump is given duration in min here, and duration in s for MAV_CMD_USER_1"),
        ("1: {name: time, unit: s}", "pump is given time in s here"),
        ("3: {name: duration, unit: s, max: 5}, 2: {name: power, unit: '%'}", None),
        ("1: {name: duration, unit: s}", None),
    ],
)
def test_a_method_is_given_the_same_arguments_for_each_command(params, says, tmp_path, monkeypatch, capsys):
    """A method of two commands does not know which of them it does: another order would swap its arguments."""
    shutil.copytree(ROOT / "tests" / "projects" / "commanded" / "specs", tmp_path / "specs")
    commands = tmp_path / "specs" / COMMANDS
    entry = f"  MAV_CMD_WAYPOINT_USER_5: {{doc: D., method: pump, requirement: FR-301.2, long: true, params: {{{params}}}}}\n"
    commands.write_text(commands.read_text() + entry)
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == (1 if says else 0)
    out = capsys.readouterr().out
    assert ("error bad-command: " in out) == (says is not None), out
    assert says is None or says in out, out
