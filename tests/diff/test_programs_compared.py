"""Further programs that are renamed, moved or gone: what changed in one is told, and one that is gone is missed."""

import json
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from in_process import codegen as run

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.project.systems import read_systems

MOTORS = ("MAV_COMP_ID_ONBOARD_COMPUTER", "MAV_COMP_ID_WINCH")


@pytest.fixture(scope="module")
def fleet(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The boat with two further programs: sail, which sends all that the boat does, and buoy with a HEARTBEAT alone."""
    folder = tmp_path_factory.mktemp("fleet") / "old"
    folder.mkdir()
    assert run(folder, "init", "--from", "boat").returncode == 0
    programs = {"sail": "", "buoy": "messages: [HEARTBEAT]\n"}
    listed = ", ".join(f"{name}: {name}/codegen.yaml" for name in programs)
    with (folder / "specs" / "codegen.yaml").open("a") as file:
        file.write(f"programs: {{{listed}}}\n")
    for (name, more), component in zip(programs.items(), MOTORS, strict=True):
        (folder / "specs" / name).mkdir()
        text = f"base: ..\nproject: {name}\ncomponent_id: {component}\n{more}"
        (folder / "specs" / name / "codegen.yaml").write_text(text)
    assert run(folder, "check").returncode == 0
    return folder


@pytest.fixture
def compared(fleet: Path, tmp_path: Path) -> Callable[[Callable[[Path], None]], tuple[int, list[Any]]]:
    """Return what a comparison says of the fleet after an edit of its specs: the exit code, and its changes."""

    def compare(edit: Callable[[Path], None]) -> tuple[int, list[Any]]:
        new = tmp_path / "new"
        shutil.copytree(fleet / "specs", new / "specs")
        edit(new / "specs")
        done = run(tmp_path, "diff", str(fleet), str(new), "--format", "json")
        return done.returncode, json.loads(done.stdout)["changes"]

    return compare


def replaced(path: Path, old: str, new: str) -> None:
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))


def renamed(specs: Path) -> None:
    """The key alone: the folder stays."""
    replaced(specs / "codegen.yaml", "sail: sail/", "yawl: sail/")


def moved(specs: Path) -> None:
    """The key, and the folder with it."""
    replaced(specs / "codegen.yaml", "sail: sail/", "yawl: yawl/")
    (specs / "sail").rename(specs / "yawl")


def another_component(specs: Path) -> None:
    for name in ("sail", "yawl"):
        if (specs / name).exists():
            replaced(specs / name / "codegen.yaml", MOTORS[0], "MAV_COMP_ID_PARACHUTE")


def another_source(specs: Path) -> None:
    for name in ("sail", "yawl"):
        if (specs / name).exists():
            (specs / name / "messages").mkdir()
            table = (specs / "messages" / "attitude.yaml").read_text()
            assert "roll: {state: attitude.roll}" in table
            table = table.replace("roll: {state: attitude.roll}", "roll: {constant: 1}")
            (specs / name / "messages" / "attitude.yaml").write_text(table)


Compare = Callable[[Callable[[Path], None]], tuple[int, list[Any]]]


def told(found: list[Any], rule: str) -> list[tuple[str, str | None, str | None]]:
    """Return subject, old and new of the changes of a rule."""
    return [(change["subject"], change["old"], change["new"]) for change in found if change["rule"] == rule]


@pytest.mark.parametrize("rename", [renamed, moved])
def test_a_rename_alone_breaks_nobody(compared: Compare, rename: Callable[[Path], None]) -> None:
    """It is one change, which tells both names."""
    code, found = compared(rename)
    assert (code, len(found)) == (0, 1), found
    assert told(found, "program-renamed") == [("yawl", "sail", "yawl")]


@pytest.mark.parametrize("rename", [renamed, moved])
def test_what_changed_in_a_renamed_program_is_told(compared: Compare, rename: Callable[[Path], None]) -> None:
    """Another component id, which is matched by the folder or by what is sent, and another source."""

    def edit(specs: Path) -> None:
        rename(specs)
        another_component(specs)
        another_source(specs)

    code, found = compared(edit)
    assert code == 1
    assert told(found, "program-renamed")
    assert [subject for subject, _, _ in told(found, "population-source-changed")] == ["yawl: ATTITUDE.roll"]
    assert [subject for subject, _, _ in told(found, "identity-changed")] == ["yawl"]
    assert not told(found, "program-removed")


def test_programs_that_change_names_are_known_by_their_folders(compared: Compare) -> None:
    """The boards go on as they are."""

    def edit(specs: Path) -> None:
        listed = "sail: sail/codegen.yaml, buoy: buoy/codegen.yaml"
        replaced(specs / "codegen.yaml", listed, "sail: buoy/codegen.yaml, buoy: sail/codegen.yaml")

    code, found = compared(edit)
    assert code == 0, found
    assert sorted(told(found, "program-renamed")) == [("buoy", "sail", "buoy"), ("sail", "buoy", "sail")]


def test_a_program_that_takes_the_name_of_one_that_is_gone_is_not_that_one(compared: Compare) -> None:
    def edit(specs: Path) -> None:
        listed = "sail: sail/codegen.yaml, buoy: buoy/codegen.yaml"
        replaced(specs / "codegen.yaml", listed, "sail: buoy/codegen.yaml")

    code, found = compared(edit)
    assert code == 1
    assert told(found, "program-renamed") == [("sail", "buoy", "sail")]
    assert told(found, "program-removed")


def test_a_program_that_is_gone_is_a_component_that_falls_silent(compared: Compare) -> None:
    """As a message that is no longer sent breaks who shows it."""
    code, found = compared(lambda specs: replaced(specs / "codegen.yaml", ", buoy: buoy/codegen.yaml", ""))
    assert code == 1
    (removed,) = found
    assert told(found, "program-removed") == [("buoy", "a further program, which sends HEARTBEAT", None)]
    assert removed["weight"] == "breaking"
    assert removed["effect"] == "who listens to component 169 hears nothing any more"
    assert removed["breaks"] == ["old_station"]
    assert removed["requirements"] == ["FR-1.1"]


def test_a_renamed_program_is_known_by_its_component(compared: Compare) -> None:
    """Moved, and with few of its messages: those that it sends no more are told."""

    def edit(specs: Path) -> None:
        moved(specs)
        with (specs / "yawl" / "codegen.yaml").open("a") as file:
            file.write("messages: [HEARTBEAT]\n")

    code, found = compared(edit)
    assert code == 1
    assert told(found, "program-renamed") == [("yawl", "sail", "yawl")]
    assert len(told(found, "message-no-longer-sent")) == 3


def test_another_program_in_place_of_one_is_no_rename(compared: Compare) -> None:
    """Of other messages, another component and in another folder: one has gone, and one has come."""

    def edit(specs: Path) -> None:
        replaced(specs / "codegen.yaml", "buoy: buoy/", "lamp: lamp/")
        (specs / "buoy").rename(specs / "lamp")
        replaced(specs / "lamp" / "codegen.yaml", MOTORS[1], "MAV_COMP_ID_PARACHUTE")
        replaced(specs / "lamp" / "codegen.yaml", "[HEARTBEAT]", "[ATTITUDE]")

    code, found = compared(edit)
    assert code == 1
    assert told(found, "program-removed")
    assert told(found, "program-added") == [("lamp", None, "a further program, which sends ATTITUDE")]


def own_parameters(specs: Path) -> None:
    """The same ones, in a file of sail's own."""
    shutil.copy(specs / "parameters.yaml", specs / "sail" / "parameters.yaml")


def slower(path: Path) -> None:
    replaced(path, "default: 5, min: 0, max: 25", "default: 4, min: 0, max: 25")


@pytest.mark.parametrize(
    ("edited", "programs"),
    [("sail/parameters.yaml", {"sail"}), ("parameters.yaml", {"", "buoy"}), ("", {"", "sail", "buoy"})],
)
def test_a_change_reaches_the_files_of_its_programs(
    fleet: Path, tmp_path: Path, edited: str, programs: set[str]
) -> None:
    """A parameter that two files state is one for each of their programs; what all have alike is nobody's alone."""
    for side in ("old", "new"):
        shutil.copytree(fleet / "specs", tmp_path / side / "specs")
        if edited:
            own_parameters(tmp_path / side / "specs")
    slower(tmp_path / "new" / "specs" / (edited or "parameters.yaml"))
    done = run(tmp_path, "diff", "old", "new", "--format", "json")
    changes = [one for one in json.loads(done.stdout)["changes"] if one["rule"] == "parameter-default-changed"]
    assert len(changes) == 1, changes
    named = {"sail", "buoy", "common"}
    reached = {symbol.partition("/")[0] for symbol in changes[0]["symbols"]}
    assert {folder if folder in named else "" for folder in reached} == programs
    suites = {test.split("/")[1] for test in changes[0]["tests"] if test.startswith("generated/")}
    assert {folder if folder in named else "" for folder in suites} == programs


def test_a_change_of_a_renamed_program_reaches_its_files_of_either_version(
    compared: Callable[[Callable[[Path], None]], tuple[int, list[Any]]],
) -> None:
    """The old ones lie in the folder of the old name."""

    def edit(specs: Path) -> None:
        moved(specs)
        shutil.copy(specs / "parameters.yaml", specs / "yawl" / "parameters.yaml")
        slower(specs / "yawl" / "parameters.yaml")

    (change,) = [one for one in compared(edit)[1] if one["rule"] == "parameter-default-changed"]
    assert change["subject"] == "yawl: SR0_EXTRA1"
    folders = {symbol.partition("/")[0] for symbol in change["symbols"]}
    assert {"sail", "yawl"} <= folders
    assert folders <= {"sail", "yawl", "common"}


def test_a_program_sends_its_own_quantities_alone(fleet: Path, tmp_path: Path) -> None:
    """Quantities of one name in two programs feed the fields of each: sail sends another roll, buoy sends none."""
    new = tmp_path / "new"
    shutil.copytree(fleet / "specs", new / "specs")
    another_source(new / "specs")
    systems = read_systems(str(new / "specs" / "codegen.yaml"), Report())
    carried = compare_systems(systems, systems).carried
    assert "ATTITUDE.roll" in carried["attitude.roll"]
    assert "sail: attitude.roll" not in carried
    assert carried["sail: attitude.pitch"] == ("sail: ATTITUDE.pitch",)
    assert "buoy: attitude.pitch" not in carried
