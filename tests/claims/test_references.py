"""References to criteria in a project's own documents: what no document has is told, and nothing else."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from codegen.claims.own.references import check
from codegen.claims.reading import Reading, read_document
from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.project.systems import read_systems


@pytest.fixture(scope="module")
def system() -> System:
    """The boat of the examples: FR-1 has three criteria."""
    return read_systems(str(Path(__file__).parents[2] / "examples" / "boat" / "specs" / "codegen.yaml"), Report())[0]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("It is there (FR-1.3).", []),
        ("It is there (see FR-1.9).", ["FR-1 has no criterion 9"]),
        ("| a | FR-1.0 |\n| - | - |\n| b | FR-1.1 |", ["FR-1 has no criterion 0"]),
        ("FR-1.9 was removed; FR-77.1 is of another project, FR-1.2.7 no criterion.", []),
        ("The file FR-1.9-notes.md and x/FR-1.9 are none.", []),
        ("```\nFR-1.9\n```", []),
    ],
)
def test_a_criterion_that_is_not_there_is_told(
    read: Callable[[str], Reading], system: System, text: str, told: list[str]
) -> None:
    reference = replace(read("").reference, systems=(system,))
    found = check(read_document(text, "/documents/notes.md", reference))
    assert [each.message for each in found] == told
