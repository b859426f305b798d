"""The encoding of parameters: how it is written, what further programs have, and where people read of it."""

import shutil
from pathlib import Path

import pytest
from edited_project import edited

from codegen.diagnostics import Report
from codegen.model.spec.spec import ParameterEncoding
from codegen.project.systems import read_system, read_systems
from codegen.rules.false_capability import check
from codegen.summaries.parameters import encoding_words, type_words
from codegen.targets.documents.files import render_documents

ROOT = Path(__file__).resolve().parents[2]
GUARDED = ROOT / "tests" / "projects" / "guarded" / "specs"


@pytest.fixture
def guarded(tmp_path: Path) -> Path:
    """The specification of a project with bytewise parameters of every type."""
    specs = Path(shutil.copytree(GUARDED, tmp_path / "specs"))
    heartbeat = specs / "messages" / "heartbeat.yaml"  # of what is no autopilot any encoding is right
    heartbeat.write_text(heartbeat.read_text().replace("MAV_AUTOPILOT_GENERIC", "MAV_AUTOPILOT_INVALID"))
    return specs


def test_it_is_c_casts_unless_it_is_written(guarded: Path) -> None:
    system, findings = edited(guarded, ("parameters.yaml", "encoding: bytewise\n", ""))
    assert findings == []
    assert system.program is not None
    assert system.program.encoding is ParameterEncoding.C_CAST
    assert not system.is_bytewise


def test_there_are_two(guarded: Path) -> None:
    """Another word is a finding at its place, with the two."""
    path = guarded / "parameters.yaml"
    path.write_text(path.read_text().replace("encoding: bytewise", "encoding: bytewize"))
    report = Report()
    read_system(str(guarded / "codegen.yaml"), report)
    (found,) = report
    assert (found.place.line, found.place.column) == (1, 11)
    assert "bytewise" in f"{found.message} {found.hint}"


def test_floats_are_sent_alike_in_each(guarded: Path) -> None:
    """Where no parameter has a whole type, the firmware is that of C casts: there is nothing to encode."""
    path = guarded / "parameters.yaml"
    path.write_text("encoding: bytewise\nparameters:\n  ONE: {doc: A., default: 1, min: 0, max: 2, step: 1}\n")
    system, findings = edited(guarded)
    assert findings == []
    assert not system.is_bytewise
    assert encoding_words(system) == ""


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("max: 65535", "max: 65536", "GATE_COUNT has values that uint16 does not carry: it is 0 to 65535"),
        ("min: -128", "min: -129", "GATE_WIND has values that int8 does not carry: it is -128 to 127"),
        ("max: 100, step: 1,", "max: 100, step: 0.5,", "GATE_SPEED has a step of 0.5, which uint8 does not carry"),
        (
            "max: 4294967040",
            "max: 4294967296",
            "GATE_LIFE has values that uint32 does not carry: it is 0 to 4294967295",
        ),
    ],
)
def test_what_the_bytes_of_a_type_do_not_carry_is_refused(guarded: Path, old: str, new: str, message: str) -> None:
    """At the type, in both encodings."""
    for encoding in ("bytewise", "c_cast"):
        path = guarded / "parameters.yaml"
        text = (GUARDED / "parameters.yaml").read_text().replace("encoding: bytewise", f"encoding: {encoding}")
        assert text.count(old) == 1
        path.write_text(text.replace(old, new))
        _, findings = edited(guarded)
        assert [(each.rule.id, each.message) for each in findings] == [("bad-parameter", message)]


def test_it_is_told(guarded: Path) -> None:
    """By explain of each whole parameter, and in the document."""
    system, _ = edited(guarded)
    words = "as the bytes of their types (encoding: bytewise)"
    assert type_words(system.parameters["GATE_SPEED"], system) == f"uint8; whole parameters are sent and taken {words}"
    assert type_words(system.parameters["GATE_FORCE"], system) == "real32"
    assert (
        f"PARAM_VALUE and PARAM_SET carry whole parameters {words}.\n" in render_documents(system)["docs/telemetry.md"]
    )


def test_a_further_program_has_that_of_its_own_parameters(tmp_path: Path) -> None:
    """The rover's AUTOPILOT_VERSION, which the smart battery shares, does not hold of it then."""
    specs = Path(shutil.copytree(ROOT / "specs", tmp_path / "specs"))
    own = specs / "smart_battery" / "parameters.yaml"
    text = own.read_text()
    assert text.count("\nparameters:\n") == 1
    own.write_text(text.replace("\nparameters:\n", "\nencoding: bytewise\nparameters:\n"))
    systems = read_systems(str(specs / "codegen.yaml"), Report())
    assert systems is not None
    rover, battery = systems
    assert (rover.is_bytewise, battery.is_bytewise) == (False, True)
    assert list(check(rover)) == []
    (found,) = check(battery)
    assert found.message.startswith("capabilities says MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST, and parameters are")
    assert found.place.file == str(specs / "messages" / "autopilot_version.yaml")


def test_a_further_program_without_parameters_of_its_own_has_that_of_its_base(tmp_path: Path) -> None:
    specs = Path(shutil.copytree(GUARDED, tmp_path / "specs"))
    project = specs / "codegen.yaml"
    project.write_text(project.read_text() + "programs: {other: other/codegen.yaml}\n")
    (specs / "other").mkdir()
    (specs / "other" / "codegen.yaml").write_text("base: ..\nproject: other\ncomponent_id: MAV_COMP_ID_USER1\n")
    report = Report()
    systems = read_systems(str(specs / "codegen.yaml"), report)
    assert systems is not None, [each.message for each in report]
    assert [system.is_bytewise for system in systems] == [True, True]
