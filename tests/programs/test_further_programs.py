"""A further program is built from its base and from what lies in its own folder, together with the project."""

import json
import os
import shutil
from pathlib import Path

import pytest
from as_written import compiled_as_written
from in_process import codegen as run

from codegen.diagnostics import Report, Severity
from codegen.emit import stamp
from codegen.model.system import System
from codegen.project.systems import read_systems

ROOT = Path(__file__).resolve().parents[2]


QUIET = ("battery_status_v2", "battery_info")
"""Tables that a build has warnings about, after which it leaves no stamp."""
NEW_STREAMS = r"^  EXTRA3:\n(    .*\n)+\n|^generations:\n(  .*\n)+"
"""The part of streams.yaml about them."""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A copy of the shipped specification, older than any build."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    for path in (tmp_path / "specs").rglob("*"):
        os.utime(path, (1, 1))
    return tmp_path


def read(folder: Path) -> tuple[System, System]:
    """The systems of the rover and of the battery."""
    report = Report()
    rover, battery = read_systems(str(folder / "specs" / "codegen.yaml"), report)
    assert [finding for finding in report if finding.rule.severity is Severity.ERROR] == []
    return rover, battery


def test_own_files_win_and_the_base_has_the_others(project: Path) -> None:
    """By file name, in the folder itself, in messages and in requirements."""
    rover, battery = read(project)
    assert battery.spec.program == "smart_battery"
    assert battery.spec.path("board.yaml") == str(project / "specs" / "smart_battery" / "board.yaml")
    assert battery.spec.path("state.yaml") == str(project / "specs" / "smart_battery" / "state.yaml")
    assert battery.spec.path("receiver.yaml") == str(project / "specs" / "receiver.yaml")
    assert battery.requirements.keys() == rover.requirements.keys()
    tables = {message.name: message.population.place.file for message in battery.messages}
    assert tables["HEARTBEAT"] == str(project / "specs" / "smart_battery" / "messages" / "heartbeat.yaml")
    assert tables["AUTOPILOT_VERSION"] == str(project / "specs" / "messages" / "autopilot_version.yaml")


def test_only_listed_messages_are_used(project: Path) -> None:
    """SYS_STATUS is the rover's, and a change of its table is none of the battery's inputs."""
    rover, battery = read(project)
    assert "SYS_STATUS" in {message.name for message in rover.messages}
    assert "SYS_STATUS" not in {message.name for message in battery.messages}
    assert str(project / "specs" / "messages" / "sys_status.yaml") not in battery.spec.files
    assert str(project / "specs" / "messages" / "battery_status.yaml") in battery.spec.files


def test_all_messages_without_a_list(project: Path) -> None:
    """A program with the base's streams needs to list nothing."""
    folder = project / "specs" / "smart_battery"
    shutil.rmtree(folder)
    folder.mkdir()
    (folder / "codegen.yaml").write_text("base: ..\nproject: twin\nmachine_code: false\n")
    rover, twin = read_systems(str(project / "specs" / "codegen.yaml"), report := Report())
    assert [finding for finding in report if finding.rule.severity == "error"] == []
    (alike,) = [finding.message for finding in report if finding.rule.id == "one-component"]
    assert alike == "smart_battery is system 1, component 1, as pico-trail is"
    assert [message.name for message in twin.messages] == [message.name for message in rover.messages]
    assert (twin.spec.project.protocol, twin.spec.project.machine_code) == (2, False)
    assert twin.spec.project.component_id == rover.spec.project.component_id


def test_programs_with_ids_of_their_own_are_not_told(project: Path) -> None:
    """And those that are never there together are waived, by the fingerprint of the finding."""
    assert "one-component" not in run(project, "check").stdout
    own = project / "specs" / "smart_battery" / "codegen.yaml"
    own.write_text(own.read_text().replace("component_id: MAV_COMP_ID_BATTERY\n", ""))
    vehicle = own.parent / "vehicle.yaml"
    vehicle.write_text(vehicle.read_text().replace("component_id: COMPID_BATT\n", ""))
    found = json.loads(run(project, "check", "--format", "json").stdout)["findings"]
    (fingerprint,) = [each["fingerprint"] for each in found if each["rule"] == "one-component"]
    waiver = {"id": "W-9", "rule": "one-component", "document": "codegen.yaml", "fingerprint": fingerprint}
    waiver |= {"reason": "One or the other.", "owner": "Ada", "expires": "2099-01-01"}
    (project / "specs" / "waivers.yaml").write_text(json.dumps({"waivers": [waiver]}))
    assert "one-component" not in run(project, "check").stdout


def test_one_build_writes_all_programs(project: Path) -> None:
    """One manifest; the schemas once; headers name the files that were read."""
    assert run(project, "build").returncode == 0
    output = project / "generated"
    listed = json.loads((output / "manifest.json").read_text())["files"]
    assert {"firmware/main.py", "smart_battery/firmware/main.py", "smart_battery/tests/cases.json"} <= listed.keys()
    assert [path for path in listed if "schemas" in path and "smart_battery" in path] == []
    assert not (output / "smart_battery" / "manifest.json").exists()
    board = (output / "smart_battery" / "firmware" / "board.py").read_text()
    assert board.startswith("# Generated from specs/smart_battery/board.yaml, ")
    builders = (output / "smart_battery" / "firmware" / "telemetry.py").read_text()
    assert "specs/messages/battery_status.yaml" in builders[: builders.index("Inputs:")]
    assert "import pack" in (output / "smart_battery" / "firmware" / "main.py").read_text()
    assert run(project, "build", "--check").returncode == 0


@pytest.mark.parametrize(
    "path",
    [
        "specs/smart_battery/vehicle.yaml",
        "specs/smart_battery/messages/heartbeat.yaml",
        "specs/smart_battery/messages/new.yaml",
        "specs/smart_battery/state.yaml",
        "specs/smart_battery/requirements/FR-9.md",
        "generated/smart_battery/firmware/state.py",
    ],
)
def test_a_change_in_the_folder_of_a_program_is_noticed(built: Path, path: str) -> None:
    """A build that seems unchanged is over before anything is read."""
    main = str(built / "specs" / "codegen.yaml")
    if "requirements" in path:
        (built / path).parent.mkdir()
        os.utime(built / "specs" / "smart_battery", (1, 1))
        assert run(built, "build").returncode == 0
    assert stamp.unchanged(main, str(built / "generated")) is not None
    with (built / path).open("a") as file:
        file.write("\n")
    assert stamp.unchanged(main, str(built / "generated")) is None


def test_explain_tells_what_differs(project: Path) -> None:
    """A message of both programs has two stories, a parameter of one has one, and what is the same is told once."""
    both = run(project, "explain", "HEARTBEAT").stdout
    assert both.index("MAV_TYPE_GROUND_ROVER") < both.index("In the program smart_battery:")
    assert both.index("In the program smart_battery:") < both.index("MAV_TYPE_BATTERY")
    own = run(project, "explain", "COMPID_BATT").stdout
    assert own.startswith("In the program smart_battery:\nCOMPID_BATT\n")
    assert "the component id" in own
    assert "In the program" not in run(project, "explain", "AUTOPILOT_VERSION.uid").stdout


def test_explain_tells_only_of_programs_that_have_it(project: Path) -> None:
    """A message or a command that one program has: no story of the dialect in place of those that lack it."""
    specs = project / "specs"
    rover = run(project, "explain", "SYS_STATUS").stdout
    assert rover.startswith("SYS_STATUS (1)")
    assert "In the program" not in rover
    assert rover.endswith("\n\nNo table of smart_battery populates or takes it.\n")
    field = run(project, "explain", "SYS_STATUS.load").stdout
    assert field.endswith("\n\nNo table of smart_battery populates or takes it.\n")
    (specs / "smart_battery" / "commands.yaml").write_text(
        "commands: {MAV_CMD_USER_1: {doc: Blinks., method: blink, requirement: FR-00074.1}}\n"
    )
    battery = run(project, "explain", "MAV_CMD_USER_1").stdout
    assert battery.startswith("In the program smart_battery:\nMAV_CMD_USER_1 (31010)\nBlinks.\n")
    assert battery.endswith("\n\nNot answered by pico-trail.\n")
    assert "UNSUPPORTED" not in battery
    assert "no table populates it" in run(project, "explain", "VFR_HUD").stdout


def test_explain_tells_what_several_programs_have_alike_once(tmp_path: Path) -> None:
    """Whatever another one between them has otherwise."""
    assert run(tmp_path, "init", "--from", "boat").returncode == 0
    specs = tmp_path / "specs"
    with (specs / "codegen.yaml").open("a") as file:
        file.write("programs: {one: one/codegen.yaml, two: two/codegen.yaml, three: three/codegen.yaml}\n")
    parameters = (specs / "parameters.yaml").read_text()
    start = parameters.index("default: ")
    other = parameters[:start] + parameters[start:].replace("default: 5", "default: 4", 1)
    assert other != parameters
    for name in ("one", "two", "three"):
        (specs / name).mkdir()
        (specs / name / "codegen.yaml").write_text(f"base: ..\nproject: {name}\n")
        if name != "two":
            (specs / name / "parameters.yaml").write_text(other)
    told = run(tmp_path, "explain", "SR0_POSITION").stdout
    assert told.count("SR0_POSITION\n") == 3, told
    shared = run(tmp_path, "explain", "attitude.roll").stdout
    assert "In the program" not in shared


def test_explain_of_what_has_errors_tells_these(project: Path) -> None:
    """Not that nothing is called so, nor that it may be meant what was asked for."""
    table = project / "specs" / "messages" / "sys_status.yaml"
    text = table.read_text()
    assert "{state: battery.voltage" in text
    table.write_text(text.replace("{state: battery.voltage", "{state: battery.voltag"))
    done = run(project, "explain", "SYS_STATUS.voltage_battery")
    assert done.returncode == 2
    assert "nothing can be told of SYS_STATUS.voltage_battery: the specification has errors" in done.stdout
    assert "error unknown-quantity: " in done.stdout
    assert "did you mean SYS_STATUS.voltage_battery" not in done.stdout
    table.write_text("message: SYS_STATUS\nfields: [\n")
    lost = run(project, "explain", "SYS_STATUS").stdout
    assert lost.endswith(
        "The specification has errors, and what they concern may be missing here: codegen check tells them.\n"
    )


def test_compiled_modules_of_a_program_lie_below_its_name(project: Path) -> None:
    """build/ARCH for the rover, build/ARCH/smart_battery for the battery."""
    with compiled_as_written():
        done = run(project, "build", "--mpy", "armv6m")
    assert done.returncode == 0, done.stdout
    folder = project / "build" / "armv6m"
    assert (folder / "vehicle.mpy").is_file()
    assert (folder / "smart_battery" / "vehicle.mpy").is_file()
    assert (folder / "smart_battery" / "main.py").is_file()
