"""The number of instances of a component as an answer, in every stage."""

from pathlib import Path

import pytest
from edited_project import edited, system_of

from codegen.diagnostics import Report
from codegen.diff.system.system import compare_systems
from codegen.importing.comparison import Verdict, compare
from codegen.importing.document import find_fields
from codegen.importing.of_system import answers_of, sources_of
from codegen.importing.proposal import propose
from codegen.model.answers.answer import Answer
from codegen.model.spec.receiver import RolesSpec
from codegen.model.system import System
from codegen.project.systems import read_system
from codegen.source import Place
from codegen.targets.receiver.readings import readings_of
from codegen.targets.suite.expected import expected_fields

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "three_cameras" / "specs"
TABLE, BOARD = "messages/video_stream_information.yaml", "board.yaml"
COUNT = "count: {state: camera.instances,"


@pytest.fixture(scope="module")
def system() -> System:
    """The project as it is."""
    return system_of(PROJECT, Report())


def count_of(system: System) -> Answer:
    return next(answer for answer in system.messages[0].answers if answer.covers.field.name == "count")


@pytest.mark.parametrize("instance", [0, 1, 2])
def test_each_message_says_the_same(instance: int, system: System) -> None:
    """Of every instance, whatever the state is; its number is another one."""
    known = {"camera.running": 0, "camera.bitrate": None}
    fields = expected_fields(system.messages[0], known, instance)
    assert (fields["count"], fields["stream_id"]) == (3, instance + 1)


def test_it_is_told_in_words_and_read_back(system: System) -> None:
    """Documents name component and number; for a receiver it is a fact of the field."""
    answer = count_of(system)
    assert (answer.words().source, answer.words().conversion) == ("how many of camera there are", "= 3")
    assert answer.used_bytes(1, 200) == (1, 1)
    readings = {
        one.name: one
        for one in readings_of(
            system.messages[0], system.components["camera"], RolesSpec(place=Place("")), system.dialect
        )
    }
    assert readings["count"].expression == 'get("count")'


def test_one_instance_less_changes_what_is_sent(system: System, folder: Path) -> None:
    """A reviewer of board.yaml is told what goes out now."""
    fewer = edited(folder, (BOARD, "    - {doc: Down., facts: {view: down}}\n", ""))[0]
    told = {(change.rule.id, change.old, change.new) for change in compare_systems((system,), (fewer,)).changes}
    assert ("population-constant-changed", "value 3", "value 2") in told


@pytest.mark.parametrize(
    ("old", "new", "rule", "says"),
    [
        ("framerate: {constant: 25}", "framerate: {state: camera.instances}", "bad-source", "framerate cannot carry"),
        ("name: {board: camera.view}", "name: {state: camera.instances}", "bad-source", "name cannot carry"),
        ("type: {enum: VIDEO_STREAM_TYPE_RTSP}", "type: {state: camera.instances}", "bad-source", "type cannot carry"),
        (COUNT, "count: {state: lens.instances,", "unknown-quantity", "lens.instances"),
        (COUNT, f"{COUNT} max: 2,", "pointless-key", "max says nothing"),
    ],
)
def test_what_cannot_be(old: str, new: str, rule: str, says: str, folder: Path) -> None:
    """Fields with a unit or an enum, texts, components that are none, and keys that shape a value."""
    path = folder / TABLE
    path.write_text(path.read_text().replace(old, new))
    report = Report()
    read_system(str(folder / "codegen.yaml"), report)
    (finding,) = report
    assert finding.rule.id == rule
    assert says in finding.message


@pytest.mark.parametrize(
    ("said", "verdict"), [("3", Verdict.EQUAL), ("2", Verdict.DIFFERENT), ("`{state: camera.instances}`", Verdict.SAME)]
)
def test_a_document_says_the_same(said: str, verdict: Verdict, system: System) -> None:
    """A number in a document is held against the number that goes out."""
    message, sources = system.messages[0], sources_of(system.dialect, system, "camera")
    text = f"VIDEO_STREAM_INFORMATION\n\n- `count`: {said}\n- `rotation`: 0\n"
    found = find_fields(text, "/doc.md", message.name, system.dialect, Report())
    assert found is not None
    made = propose(found.lists, found.message, sources, Report())
    rows = {row.target.label: row.verdict for row in compare(made, answers_of(message), sources)}
    assert rows["count"] is verdict


def test_a_quantity_of_that_name_comes_first(folder: Path) -> None:
    """A component may keep a number of its own under that name."""
    quantity = "    quantities:\n      instances: {doc: Of its own., min: 0, max: 9, initial: 5}\n"
    system = edited(folder, ("state.yaml", "    quantities:\n", quantity))[0]
    assert [one.path for one in count_of(system).quantities] == ["camera.instances"]
