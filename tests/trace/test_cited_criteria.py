"""Tests are evidence only for what the specification names: no suite cites a criterion that nobody wrote down.

The checks of the main loop, the storage and the services are the same in every project. They once carried the numbers
of one project's documents, so that in another one they "showed" whatever stood under the same number.
"""

import ast
import re
import shutil
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.model.spec.access import AccessSpec
from codegen.model.spec.board import AdcSpec
from codegen.model.spec.command import CommandSpec
from codegen.model.spec.population import PopulationSpec
from codegen.model.spec.program import ArmingSpec, ControlSpec, FailsafeSpec, ServicesSpec, StorageSpec
from codegen.model.spec.receiver import ReceiverSpec
from codegen.model.spec.spec import GenerationsSpec
from codegen.model.spec.state import ComponentSpec, QuantitySpec
from codegen.model.spec.watchdog import WatchdogSpec
from codegen.model.system import System
from codegen.project.systems import read_systems
from codegen.targets.receiver.suite import shown_by_receiver_tests
from codegen.targets.suite.program_checks import checked_aspects
from codegen.trace import generated_tests

ROOT = Path(__file__).resolve().parents[2]
PROJECTS = [
    ROOT,
    *(ROOT / "tests" / "projects" / name for name in ("boat", "radio_rover", "two_batteries", "commanded")),
]
SECTIONS = {
    "access": AccessSpec,
    "control": ControlSpec,
    "storage": StorageSpec,
    "arming": ArmingSpec,
    "services": ServicesSpec,
    "failsafe": FailsafeSpec,
    "generations": GenerationsSpec,
    "message": PopulationSpec,
    "component": ComponentSpec,
    "quantity": QuantitySpec,
    "reading": AdcSpec,
    "receiver": ReceiverSpec,
    "command": CommandSpec,
    "watchdog": WatchdogSpec,
}
OF_THE_BEHAVIOUR = {
    "component": {"robustness", "scenarios", "steady"},
    "quantity": {
        "calibration",
        "invalid_after",
        "multiplier",
        "rounding",
        "set_stale_after",
        "restarting_stale_after",
        "stale_after",
        "warn_above",
    },
    "reading": {"reference", "samples", "read_limit", "failure", "absence", "when"},
}
"""Aspects that test_frames.py and test_behaviour.py cite."""
OF_THEIR_OWN = {
    *("failsafe.below", "failsafe.above", "failsafe.silent"),
    *("streams.rate", "streams.fixed", "command.done", "mode.change"),
}
"""Aspects that the ``requirement`` of a level, a stream, a command or a mode asks for."""


def _systems(folder: Path) -> tuple[System, ...]:
    report = Report()
    systems = read_systems(str(folder / "specs" / "codegen.yaml"), report)
    assert not report.has_errors
    return tuple(systems)


def _written(folder: Path) -> set[str]:
    """Every citation that stands in the files of a specification."""
    texts = [path.read_text() for path in (folder / "specs").rglob("*.yaml") if path.name != "trace.lock.yaml"]
    return {found for text in texts for found in re.findall(r"[\w-]+\.\d+|N?FR-[\w-]+", text)}


@pytest.mark.parametrize("folder", PROJECTS, ids=lambda folder: folder.name)
def test_what_tests_cite_is_there_and_was_named(folder: Path) -> None:
    """Each criterion that a generated test shows is one of a document, and stands in a table of the project."""
    written = _written(folder)
    for system in _systems(folder):
        criteria = {
            name
            for each in system.requirements.values()
            for name in (each.id, *(f"{each.id}.{criterion.number}" for criterion in each.criteria))
        }
        cited = {test.criterion for test in generated_tests.tests_of(system)}
        assert cited
        assert cited - criteria == set()
        assert cited - written == set()


def test_a_section_that_names_no_aspect_gets_no_evidence(tmp_path: Path) -> None:
    """The first criteria of a document that the loop and the services cite are not what tests of the loop show."""
    shutil.copytree(PROJECTS[2] / "specs", tmp_path / "specs")
    table = tmp_path / "specs" / "vehicle.yaml"
    text = table.read_text().replace("links: 50 Hz}", "links: 50 Hz, requirement: FR-1.1}")
    text = text.replace("{fastest: 5 Hz}", "{fastest: 5 Hz, requirement: FR-1}")
    table.write_text(text)
    (system,) = _systems(tmp_path)
    streams = {str(stream.citation) for stream in system.streams.values() if stream.citation}
    assert set(_shown_by_the_program(system)) <= streams
    table.write_text(text.replace("requirement: FR-1.1}", "requirement: FR-1.1, criteria: {grid: FR-1.3}}"))
    (system,) = _systems(tmp_path)
    (cases,) = (cases for criterion, cases in _shown_by_the_program(system).items() if criterion not in streams)
    assert {case.split("-")[2] for case in cases} == {
        "control_keeps_its_grid",
        "jitter_is_no_drift",
        "jobs_are_due_as_stated",
        "faults_do_not_stop_the_loop",
        "day_across_the_wrap",
        "an_interrupt_ends_one_pass",
    }


def _shown_by_the_program(system: System) -> dict[str, tuple[str, ...]]:
    tests = generated_tests.tests_of(system)
    return {test.criterion: test.cases for test in tests if test.file.endswith("test_program.py")}


def test_templates_know_no_document() -> None:
    """No script of the suites, and no module that lists its checks, has the number of a document in its code."""
    for path in [*(ROOT / "templates" / "tests").rglob("*.py"), ROOT / "codegen" / "targets" / "suite" / "criteria.py"]:
        constants = [node.value for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.Constant)]
        cited = [each for each in constants if isinstance(each, str) and re.fullmatch(r"N?FR-\d+(\.\d+)?", each)]
        assert cited == [], path


def test_each_aspect_is_shown_by_a_check() -> None:
    """An aspect that no check knows would take a criterion, and no test would carry it; and the other way round."""
    known = {f"{section}.{aspect}" for section, spec in SECTIONS.items() for aspect in spec.ASPECTS}
    receiver = {f"receiver.{aspect}" for aspects in shown_by_receiver_tests().values() for aspect in aspects}
    behaviour = {f"{section}.{aspect}" for section, aspects in OF_THE_BEHAVIOUR.items() for aspect in aspects}
    of_pairs = {each for each in checked_aspects() if each.startswith("pair.")}
    named = {f"pair.{aspect}" for spec in (FailsafeSpec, ArmingSpec) for aspect in spec.ASPECTS}
    assert of_pairs - named == {"pair.first", "pair.second"}, "checks that are for failsafes of two levels alone"
    shown = (checked_aspects() - of_pairs) | receiver
    assert shown - known == OF_THEIR_OWN
    assert known - shown - behaviour == set()
