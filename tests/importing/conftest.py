"""The dialect and the project that documents are held against, and documents of a few lines."""

from collections.abc import Callable
from pathlib import Path

import pytest
from one_path import folder_at_one_path, place_of_projects  # noqa: F401  fixtures

from codegen.commands.codec import read_codec_dialect
from codegen.diagnostics import Report
from codegen.importing.answer import Reading, Sources, Target
from codegen.importing.of_system import sources_of
from codegen.importing.value import read_value
from codegen.load.markdown_table import Cell, parse_tables
from codegen.model.system import System
from codegen.project.systems import read_systems

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="session")
def system() -> System:
    """The shipped project."""
    return read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())[0]


@pytest.fixture(scope="session")
def sources(system: System) -> Sources:
    """Return the sources of values of the shipped project, for a message that each battery has."""
    return sources_of(system.dialect, system, "battery")


@pytest.fixture(scope="session")
def plain() -> Sources:
    """The dialect common as it is shipped, and no project."""
    dialect = read_codec_dialect("common", Report())
    assert dialect is not None
    return Sources(dialect)


def cell_of(text: str) -> Cell:
    """The cell that a document has with ``text`` in its second column."""
    found = parse_tables(f"| Field | Value |\n| --- | --- |\n| x | {text} |\n", "doc.md")
    return found.tables[0].rows[0].cells[1]


def target_in(sources: Sources, name: str) -> Target:
    """``BATTERY_STATUS.voltages[0]`` and the like."""
    message_name, _, label = name.partition(".")
    field_name, _, index = label.partition("[")
    message = sources.dialect.messages[message_name]
    field = message.field(field_name)
    assert field is not None
    return Target(message, field, int(index[:-1]) if index else 0, 1 if index else field.count)


@pytest.fixture
def read() -> Callable[[str, str, Sources], tuple[Reading, list[str]]]:
    """Reads a cell for a field: the reading, and ``rule: message`` of each finding."""

    def reading(text: str, name: str, sources: Sources) -> tuple[Reading, list[str]]:
        report = Report()
        found = read_value(cell_of(text), target_in(sources, name), sources, report)
        return found, [f"{finding.rule.id}: {finding.message}" for finding in report]

    return reading
