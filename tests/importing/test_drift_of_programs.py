"""A document has to be true of each program that it is about: of the base's, and of what further programs have otherwise."""

from pathlib import Path

import pytest
from in_process import codegen as run

from codegen.commands.importing import Imported, Wanted, imported
from codegen.diagnostics import Report
from codegen.importing.drift import drift
from codegen.importing.stated import stated_fields
from codegen.project.systems import read_systems

ROLL, PITCH = "roll: {state: attitude.roll}", "roll: {state: attitude.pitch}"
DOCUMENT = """# {id} | How the sails lie

## Metadata

- Type: Functional Requirement
- Status: Draft

## Acceptance Criteria

1. ATTITUDE (30) is sent.

## Field population of ATTITUDE

| Field | Value source |
| --- | --- |
| time_boot_ms | `{{clock: boot}}` |
| roll | attitude.{roll} |
| pitch | attitude.pitch |
| yaw | attitude.yaw |
| rollspeed | attitude.roll_speed |
| pitchspeed | attitude.pitch_speed |
| yawspeed | attitude.yaw_speed |
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """The boat with two further programs, of which sail sends another ATTITUDE; its document says roll is roll."""
    assert run(tmp_path, "init", "--from", "boat").returncode == 0
    specs = tmp_path / "specs"
    with (specs / "codegen.yaml").open("a") as file:
        file.write("programs: {sail: sail/codegen.yaml, buoy: buoy/codegen.yaml}\n")
    for name in ("sail", "buoy"):
        (specs / name / "messages").mkdir(parents=True)
        (specs / name / "codegen.yaml").write_text(f"base: ..\nproject: {name}\n")
    (specs / "requirements" / "FR-9.md").write_text(DOCUMENT.format(id="FR-9", roll="roll"))
    table = specs / "messages" / "attitude.yaml"
    text = table.read_text()
    assert "requirement: FR-1.4" in text
    table.write_text(text.replace("requirement: FR-1.4", "requirement: FR-9.1"))
    other_attitude(specs, "sail", "FR-9.1")
    return specs


def other_attitude(specs: Path, program: str, requirement: str) -> None:
    text = (specs / "messages" / "attitude.yaml").read_text()
    assert ROLL in text
    text = text.replace(ROLL, PITCH).replace("requirement: FR-9.1", f"requirement: {requirement}")
    (specs / program / "messages" / "attitude.yaml").write_text(text)


def own_document(specs: Path, program: str, name: str, roll: str) -> Path:
    folder = specs / program / "requirements"
    folder.mkdir(exist_ok=True)
    path = folder / f"{name}.md"
    path.write_text(DOCUMENT.format(id=name, roll=roll))
    return path


def found(specs: Path, document: Path) -> list[str]:
    """The drift of a document, as ``message (file of the table)``."""
    systems = read_systems(str(specs / "codegen.yaml"), report := Report())
    assert [finding for finding in report if finding.is_error] == []
    stated = stated_fields(document.read_text(), str(document))
    findings = [*stated.findings, *drift(stated, systems)]
    return [f"{one.message} ({Path(one.related[0][0].file).relative_to(specs)})" for one in findings]


OTHERWISE = "ATTITUDE.roll is {state: attitude.roll} here, but {state: attitude.pitch} in the population table"


def test_a_table_of_a_further_program_drifts_from_the_common_document(project: Path) -> None:
    """The base's table and the buoy's, which is the same one, are as the document says."""
    assert found(project, project / "requirements" / "FR-9.md") == [
        f"{OTHERWISE} of sail (sail/messages/attitude.yaml)"
    ]


def test_what_several_programs_have_alike_is_told_once(project: Path) -> None:
    table = project / "messages" / "attitude.yaml"
    table.write_text(table.read_text().replace(ROLL, PITCH))
    assert found(project, project / "requirements" / "FR-9.md") == [
        f"{OTHERWISE} (messages/attitude.yaml)",
        f"{OTHERWISE} of sail (sail/messages/attitude.yaml)",
    ]


@pytest.mark.parametrize(("roll", "drifts"), [("pitch", []), ("roll", [f"{OTHERWISE} of sail"])])
def test_a_document_of_a_program_is_compared_with_its_table(project: Path, roll: str, drifts: list[str]) -> None:
    """Not with the base's: of that a right one would differ, and a wrong one not. The common one is not about sail."""
    other_attitude(project, "sail", "FR-10.1")
    document = own_document(project, "sail", "FR-10", roll)
    assert [one.rpartition(" (")[0] for one in found(project, document)] == drifts
    assert found(project, project / "requirements" / "FR-9.md") == []


def test_a_document_of_a_program_that_no_table_cites_is_about_that_program(project: Path) -> None:
    assert found(project, own_document(project, "sail", "FR-10", "pitch")) == []


def test_a_document_that_a_program_replaces_is_not_about_it(project: Path) -> None:
    """It has a document of the same file name in its own folder."""
    document = own_document(project, "sail", "FR-9", "pitch")
    assert found(project, document) == []
    assert found(project, project / "requirements" / "FR-9.md") == []


def test_an_import_compares_with_the_table_of_the_program(project: Path) -> None:
    other_attitude(project, "sail", "FR-10.1")
    document = own_document(project, "sail", "FR-10", "pitch")
    systems = read_systems(str(project / "codegen.yaml"), Report())
    wanted = Wanted(str(document), None, None, None, None, None, needs_table=True)
    told = imported(wanted, document.read_text(), systems, systems[0].dialect, Report())
    assert isinstance(told, Imported)
    assert told.table is not None
    assert told.table.path == str(project / "sail" / "messages" / "attitude.yaml")
    assert not told.differs
