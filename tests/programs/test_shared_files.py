"""What the programs of a project have alike lies once, in the common folder; what only some have does not."""

import json
import shutil
from pathlib import Path

import pytest
from as_written import compiled_as_written
from in_process import codegen as run
from whole_program import module_folders, whole_program

from codegen.commands.build import compile_firmware, render_systems, stale_firmware
from codegen.commands.trace import shared_modules
from codegen.diagnostics import Report
from codegen.emit.mpy import BYTECODE
from codegen.model.program_folders import program_folders
from codegen.project.systems import folders_of, read_systems
from codegen.targets.firmware import render_firmware
from codegen.targets.origin import Origin, headed, united
from codegen.targets.shared_files import laid_out

ROOT = Path(__file__).resolve().parents[2]
FRAMES = "firmware/frames_viper.py"
"""What a program without machine code does not have."""
COMMANDS = """commands:
  MAV_CMD_USER_1:
    doc: Runs the bilge pump.
    method: pump
    params: {1: {name: duration, unit: s, min: 0, max: 60}}
"""
RECEIVED = """receive: GPS_RAW_INT
requirement: FR-1.2
fields:
  satellites_visible: {state: gps.satellites}
"""


def test_what_all_programs_have_alike_is_common() -> None:
    """Not what one lacks or has otherwise, nor tests and data, nor what lies in other folders."""
    shareable = {"firmware/words.py": "w", "mocks/machine.py": "m", "tests/runner.py": "r"}
    tests = {"tests/test_program.py": "t", "tests/conftest.py": "c", "tests/cases.json": "j"}
    same = {**shareable, **tests, "receiver/view.py": "v", "docs/a.html": "a"}
    three = {"": {**same, "firmware/own.py": "o", "firmware/state.py": "1"}}
    three["two"] = {**same, "firmware/own.py": "o", "firmware/state.py": "1"}
    three["three"] = {**same, "firmware/state.py": "2"}
    found = laid_out(three)
    common = {path for path in found.files if path.startswith("common/")}
    assert common == {f"common/{path}" for path in shareable}
    assert found.shared["firmware/words.py"] == found.shared["two/firmware/words.py"] == "common/firmware/words.py"
    for name, files in three.items():
        kept = {f"{name}/{path}".removeprefix("/") for path in files} - found.shared.keys()
        assert kept <= found.files.keys()
    assert len(found.files) == 3 + sum(map(len, three.values())) - 3 * 3


def test_a_project_with_one_program_has_no_common_folder() -> None:
    """Its files are where they were rendered; those of a common folder are left over from more programs."""
    files = {"firmware/words.py": "w", "docs/a.html": "a"}
    found = laid_out({"": files})
    assert (found.files, found.shared) == (files, {})
    assert "common/firmware/words.py".startswith(found.vacated)
    assert not "docs/a.html".startswith(found.vacated)


def test_headers_of_a_common_file_name_all_sources() -> None:
    """Files that differ in nothing but their headers are one; others are not."""
    names = tuple(f"specs/{'long_' * 6}{number}.yaml" for number in range(5))
    first, second = Origin(names[:4], "0" * 16), Origin(names[2:], "1" * 16)
    both = united([headed("a = 1\n", first), headed("a = 1\n", second)])
    assert both is not None
    assert [name for name in names if both.count(name) == 1] == list(names)
    assert both.endswith(": do not edit.\n# Inputs: " + both.split("Inputs: ")[1][:16] + "\na = 1\n")
    assert united([headed("a = 1\n", first), headed("a = 2\n", second)]) is None
    assert united([headed("a = 1\n", first), "a = 1\n"]) is None
    assert united([both, headed("a = 1\n", first)]) is not None


def test_a_program_looks_into_its_own_folder_first(tmp_path: Path) -> None:
    """A file of that name in the common folder is another's."""
    folders = program_folders(str(tmp_path), "pack")
    assert folders.of("firmware", "mocks") == tuple(
        str(tmp_path / name) for name in ("pack/firmware", "common/firmware", "pack/mocks", "common/mocks")
    )
    (tmp_path / "common" / "mocks").mkdir(parents=True)
    (tmp_path / "common" / "mocks" / "sim.py").touch()
    assert folders.find("mocks", "sim.py") == str(tmp_path / "common" / "mocks" / "sim.py")
    (tmp_path / "pack" / "mocks").mkdir(parents=True)
    (tmp_path / "pack" / "mocks" / "sim.py").touch()
    assert folders.find("mocks", "sim.py") == str(tmp_path / "pack" / "mocks" / "sim.py")
    assert folders.find("mocks", "other.py") is None


@pytest.mark.parametrize("program", ["", "smart_battery"])
def test_both_folders_together_are_the_program(program: str, tmp_path: Path) -> None:
    """No module is missing, none is of another program alone, and no name is in both folders."""
    systems = read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())
    system = next(each for each in systems if each.spec.program == program)
    own, common = module_folders(ROOT / "generated", "firmware", program=program)
    there = [{path.name for path in folder.glob("*.py")} for folder in (own, common)]
    assert not there[0] & there[1]
    rendered = {path.removeprefix("firmware/") for path in render_firmware(system)}
    assert there[0] | there[1] == rendered
    together = whole_program(ROOT / "generated", tmp_path, program) / "firmware"
    assert {path.name for path in together.glob("*.py")} == rendered
    assert stale_firmware(system) == []
    compiled = compile_firmware(system, BYTECODE, Report()).keys() - {"main.py", "short_names.txt"}
    assert {name.removesuffix(".mpy") for name in compiled if not name.startswith("part_")} == {
        name.removesuffix(".py") for name in rendered if not name.endswith("_viper.py")
    } - {"main"}


def test_a_module_that_is_stale_in_the_common_folder_is_told(built: Path) -> None:
    """By each program."""
    path = built / "generated" / "common" / "firmware" / "storage.py"
    path.write_text(path.read_text() + "# changed\n")
    systems = read_systems(str(built / "specs" / "codegen.yaml"), Report())
    assert [stale_firmware(system) for system in systems] == [["storage.py"], ["storage.py"]]
    own = built / "generated" / "firmware" / "state.py"
    own.write_text(own.read_text().replace("# Inputs: ", "# Inputs: 0"))
    assert stale_firmware(systems[0]) == ["state.py", "storage.py"]
    assert folders_of(systems[1]).find("firmware", "storage.py") == str(path)


def texts(folder: Path) -> dict[str, bytes]:
    """The files of the output."""
    paths = (path for path in folder.rglob("*") if path.is_file() and ".codegen" not in path.parts)
    return {str(path.relative_to(folder)): path.read_bytes() for path in paths}


def test_a_file_that_moves_leaves_nothing_behind(built: Path) -> None:
    """It would still be imported: the build removes it without --clean, out of the common folder and back."""
    output, settings = built / "generated", built / "specs" / "smart_battery" / "codegen.yaml"
    before, stated = texts(output), settings.read_text()
    assert f"common/{FRAMES}" in before
    settings.write_text(f"{stated}machine_code: false\n")
    checked = run(built, "build", "--check")
    assert f"common/{FRAMES}:1:1: error stale-output: it is no longer generated" in checked.stdout.replace(
        f"{output}/", ""
    )
    done = run(built, "build")
    assert (done.returncode, done.stdout) == (0, "")
    after = texts(output)
    assert not any(path.startswith("smart_battery/firmware/") and path.endswith("_viper.py") for path in after)
    assert FRAMES in after
    assert {f"common/{FRAMES}", f"smart_battery/{FRAMES}"}.isdisjoint(after)
    settings.write_text(stated)
    assert run(built, "build").returncode == 0
    back = texts(output)
    assert FRAMES not in back
    assert {path: text for path, text in back.items() if before.get(path) != text} == {}
    assert run(built, "build", "--check").returncode == 0


def test_what_was_edited_by_hand_is_not_removed(built: Path) -> None:
    """It stays, and is reported."""
    output, settings = built / "generated", built / "specs" / "smart_battery" / "codegen.yaml"
    stated = settings.read_text()
    settings.write_text(f"{stated}machine_code: false\n")
    run(built, "build")
    edited = output / FRAMES
    edited.write_text(edited.read_text() + "# by hand\n")
    settings.write_text(stated)
    done = run(built, "build")
    assert f"{FRAMES}:1:1: warning no-longer-generated: " in done.stdout.replace("generated/", "")
    assert edited.exists()
    assert run(built, "build", "--clean", "--force").returncode == 0
    assert not edited.exists()


def test_a_part_of_the_specification_that_goes_leaves_no_module_and_no_check(tmp_path: Path) -> None:
    """Of the project's own program and of a further one: the suite would run them, and the firmware import them."""
    assert run(tmp_path, "init", "--from", "boat").returncode == 0
    specs, output = tmp_path / "specs", tmp_path / "generated"
    with (specs / "codegen.yaml").open("a") as file:
        file.write("programs: {sail: sail/codegen.yaml}\n")
    (specs / "sail" / "receives").mkdir(parents=True)
    (specs / "sail" / "codegen.yaml").write_text("base: ..\nproject: sail\ncomponent_id: MAV_COMP_ID_USER1\n")
    assert run(tmp_path, "build").returncode == 0
    before = texts(output)
    (specs / "commands.yaml").write_text(COMMANDS)
    (specs / "sail" / "receives" / "gps_raw_int.yaml").write_text(RECEIVED)
    with compiled_as_written():
        done = run(tmp_path, "build", "--mpy", "bytecode")
    assert done.returncode == 0, done.stdout
    boards = tmp_path / "build" / "bytecode"
    more = texts(output).keys() - before.keys()
    assert {path.rpartition("/")[2] for path in more} >= {"own_commands.py", "command_checks.py", "command_facts.py"}
    assert (boards / "own_commands.mpy").exists()
    (specs / "commands.yaml").unlink()
    shutil.rmtree(specs / "sail" / "receives")
    assert run(tmp_path, "build", "--check").returncode == 1
    with compiled_as_written():
        done = run(tmp_path, "build", "--mpy", "bytecode")
    assert (done.returncode, done.stdout) == (0, "")
    assert texts(output) == before
    assert not (boards / "own_commands.mpy").exists()


def test_a_project_that_loses_its_further_program_loses_the_common_folder(built: Path) -> None:
    """All that the program shared is its own again; what the other one had is reported, as any file is."""
    settings = built / "specs" / "codegen.yaml"
    text = settings.read_text()
    settings.write_text(text[: text.index("# Further programs")])
    scenarios = built / "specs" / "scenarios.yaml"
    scenarios.unlink()
    done = run(built, "build")
    output = built / "generated"
    assert (output / FRAMES).is_file(), done.stdout
    assert not (output / "common").exists()
    assert "smart_battery/firmware/main.py:1:1: warning no-longer-generated" in done.stdout
    assert "common" not in (output / "tests" / "interpreters.py").read_text()


def test_trace_names_a_shared_module_once(built: Path) -> None:
    """Where it lies."""
    systems = read_systems(str(built / "specs" / "codegen.yaml"), Report())
    shared = shared_modules(systems)
    assert shared == {path: place for path, place in render_systems(systems).shared.items() if "firmware/" in path}
    told = json.loads(run(built, "trace", "--format", "needs", "--fail-on", "none").stdout)
    assert "common/firmware/storage.py" in json.dumps(told)
    assert "smart_battery/firmware/storage.py" not in json.dumps(told)
