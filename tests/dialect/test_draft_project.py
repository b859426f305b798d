"""A project with tables for each layout: the overlays in the project file choose, and the firmware sends that layout.

draft_project/ is the specification without its dialects, which are those of the shipped specification.
"""

import json
import re
import shutil
from pathlib import Path

import pytest
from generated_suite import suite_is_green
from in_process import build, codegen

from codegen.cli import main
from codegen.decode.spec import decode_spec
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.system import System
from codegen.project.systems import read_system

HERE = Path(__file__).parent
DIALECTS = HERE.parents[1] / "specs" / "dialects"
UPSTREAM, DRAFT = "battery_upstream", "battery_rfc_0018"
CELLS, FAULTS = "battery_cell_voltages_rfc_0018", "battery_cell_faults_rfc_0018"


def project(folder: Path, *overlays: str) -> Path:
    """A copy of the project, changed in one line of codegen.yaml; the path of that file."""
    specs = folder / "specs"
    shutil.copytree(HERE / "draft_project", specs)
    shutil.copytree(DIALECTS, specs / "dialects")
    file = specs / "codegen.yaml"
    listed = ", ".join(f"dialects/{name}.xml" for name in overlays)
    file.write_text(re.sub("(?m)^overlays: .*$", f"overlays: [{listed}]", file.read_text()))
    return file


def system(folder: Path, *overlays: str) -> System:
    """The project resolved; nothing is found in it."""
    report = Report()
    found = read_system(str(project(folder, *overlays)), report)
    assert [one.rule.id for one in report] == []
    assert found is not None
    return found


@pytest.mark.requirement("FR-00072.9")
@pytest.mark.parametrize(
    ("overlays", "messages"),
    [
        ((UPSTREAM, CELLS), {"BATTERY_STATUS_V2": (369, 27), "BATTERY_CELL_VOLTAGES": (54371, 28)}),
        ((DRAFT, CELLS), {"BATTERY_STATUS_V2": (369, 24), "BATTERY_CELL_VOLTAGES": (54371, 28)}),
        ((DRAFT, FAULTS), {"BATTERY_STATUS_V2": (369, 24), "BATTERY_CELL_VOLTAGES": (54372, 10)}),
        ((UPSTREAM,), {"BATTERY_STATUS_V2": (369, 27)}),
        ((CELLS,), {"BATTERY_CELL_VOLTAGES": (54371, 28)}),
    ],
)
def test_overlays_choose_tables_and_corrections(
    overlays: tuple[str, ...], messages: dict[str, tuple[int, int]], tmp_path: Path
) -> None:
    """Two tables for one message are no contradiction while one of them is used, and no correction is left over."""
    found = system(tmp_path, *overlays)
    assert {message.name: (message.wire.id, message.wire.length) for message in found.messages} == messages


@pytest.mark.parametrize("overlays", [(UPSTREAM, DRAFT), (CELLS, FAULTS)])
def test_two_tables_in_use_for_one_message(overlays: tuple[str, str], tmp_path: Path) -> None:
    """With both overlays it is open which table counts, and the messages of the XML contradict each other, too."""
    report = Report()
    read_system(str(project(tmp_path, *overlays)), report)
    assert {"duplicate-table", "message-conflict"} <= {one.rule.id for one in report}


def test_files_of_other_overlays_are_known_to_be_unused(tmp_path: Path) -> None:
    """Their tables count as read, so that no file is called misspelt; what they say wrongly is still found."""
    file = project(tmp_path, UPSTREAM)
    table = file.parent / "messages" / "battery_cell_faults.yaml"
    table.write_text(table.read_text().replace("stream: battery", "streams: battery"))
    report = Report()
    spec = decode_spec(str(file), DISK, report)
    assert spec is not None
    assert str(table) in spec.files
    assert [one.rule.id for one in report] == ["unknown-key"]


@pytest.mark.parametrize("overlays", [(UPSTREAM, CELLS), (DRAFT, CELLS), (DRAFT, FAULTS)])
def test_the_firmware_sends_the_chosen_layout(overlays: tuple[str, ...], tmp_path: Path) -> None:
    """The generated suite is green on both interpreters; its oracle is mavgen's dialect of the corrected XML."""
    project(tmp_path, *overlays)
    build(tmp_path)
    suite_is_green(tmp_path, "generated/tests")
    assert "BATTERY_CELL_VOLTAGES" in (tmp_path / "generated" / "tests" / "cases.json").read_text()


CHOICES = {
    "upstream": (UPSTREAM, CELLS),
    "draft": (DRAFT, CELLS),
    "faults": (UPSTREAM, FAULTS),
}
"""Choices of overlays for the shipped specification; benchmarks/alternatives.py runs whole suites with each."""


@pytest.fixture(scope="module", params=CHOICES)
def shipped(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """The shipped specification with the one edit that its project file names, built without a finding."""
    folder = tmp_path_factory.mktemp("shipped")
    shutil.copytree(DIALECTS.parent, folder / "specs")
    file = folder / "specs" / "codegen.yaml"
    text = file.read_text()
    for pair, chosen in zip(((UPSTREAM, DRAFT), (CELLS, FAULTS)), CHOICES[request.param], strict=True):
        text, number = re.subn(f"(?m)^  - dialects/(?:{'|'.join(pair)}).xml$", f"  - dialects/{chosen}.xml", text)
        assert number == 1
    file.write_text(text)
    built = codegen(folder, "build")
    assert (built.returncode, built.stdout) == (0, ""), built.stderr
    return request.param, folder


@pytest.mark.requirement("FR-00072.1", "FR-00072.9", "FR-00076.7", "FR-00076.10")
@pytest.mark.parametrize("program", ["", "smart_battery"])
def test_the_shipped_specification_takes_each_draft(program: str, shipped: tuple[str, Path]) -> None:
    """One line of codegen.yaml: both programs send what the draft says, 24 bytes of status or one bit for each cell."""
    choice, folder = shipped
    generated = folder / "generated" / program
    if choice != "upstream" or not program:
        suite_is_green(generated, "tests/test_frames.py", only="BATTERY_STATUS_V2 or BATTERY_CELL_VOLTAGES")
    sent = (generated / "docs" / "telemetry.md").read_text()
    for message, wanted in (
        ("BATTERY_STATUS_V2 (369)", "24 bytes, CRC_EXTRA 151" if choice == "draft" else "27 bytes, CRC_EXTRA 145"),
        ("BATTERY_CELL_VOLTAGES (54372)", "10 bytes")
        if choice == "faults"
        else ("BATTERY_CELL_VOLTAGES (54371)", "28 bytes"),
    ):
        assert f"Payload {wanted}" in sent.partition(f"## {message}")[2].partition("## ")[0]


def test_each_draft_keeps_the_documents_true(shipped: tuple[str, Path], capsys: pytest.CaptureFixture[str]) -> None:
    """No claim of a requirement document is wrong with one draft and right with another.

    `make test` checks the specification as it is shipped, with upstream's.
    """
    if shipped[0] == "upstream":
        assert (shipped[1] / "specs" / "codegen.yaml").read_text() == (DIALECTS.parent / "codegen.yaml").read_text()
        return
    assert main(["check", "--project", str(shipped[1] / "specs")]) == 0, capsys.readouterr().out


@pytest.mark.requirement("FR-00076.10")
def test_faults_that_nobody_tells_are_not_sent(shipped: tuple[str, Path]) -> None:
    """The draft has no value for unknown: the builder gives nothing until code has set the mask, all of its bits."""
    choice, folder = shipped
    cases = json.loads((folder / "generated" / "tests" / "cases.json").read_text())["messages"]
    about = {each["name"]: each for each in cases if each["name"].startswith("BATTERY_CELL_VOLTAGES.")}
    quantities = {name for each in about.values() for _, name, *_ in each["set"]}
    assert ("cell_faults_number" in quantities) == (choice == "faults")
    if choice == "faults":
        assert about["BATTERY_CELL_VOLTAGES.fault_mask-maximum"]["expect"]["fault_mask"] == 2**64 - 1
        assert about["BATTERY_CELL_VOLTAGES.fault_mask-unknown"]["expect"] == {}
