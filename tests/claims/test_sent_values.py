"""Numbers that a project always sends, in the sentences of its documents: another one than its table has is told."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from codegen.claims.own.sent_values import check
from codegen.claims.reading import Reading, read_document
from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.project.systems import read_systems

HEAD = "# DISTANCE_SENSOR\n\n"


@pytest.fixture(scope="module")
def system() -> System:
    """The boat of the examples: min_distance is 0.3 m, id is 1, type is MAV_DISTANCE_SENSOR_ULTRASOUND, covariance unknown."""
    return read_systems(str(Path(__file__).parents[2] / "examples" / "boat" / "specs" / "codegen.yaml"), Report())[0]


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("1. `min_distance` is 30 cm and `max_distance` 50 m.", []),
        ("1. `min_distance` is 300 mm; `id` is 1.", []),
        ("1. `min_distance` is 20 cm.", ["min_distance is always 30 cm, not 20 cm"]),
        ("1. `min_distance` is 30 mm.", ["min_distance is always 30 cm, not 30 mm"]),
        ("1. `min_distance` is 30 cm and `max_distance` 40 m.", ["max_distance is always 5000 cm, not 40 m"]),
        ("- `id`: 2", ["id is always 1, not 2"]),
        ("`type` shall be 0.", ["type is always 1, not 0"]),
        ("`covariance` = 4", ["covariance is always 255 cm^2, not 4"]),
        ("`current_distance` is 20 cm.", []),
        ("`min_distance` is 20 cm if the water is salt.", []),
        ("`min_distance` was 20 cm. `id` is 2 or 3.", []),
        ("`min_distance` is 20 to 40 cm, `id` is 8 bits long.", []),
        ("## Example\n\n`min_distance` is 20 cm.", []),
        ("`min_distance` is 0,3 m.", []),
    ],
)
def test_what_is_always_sent_is_compared(
    read: Callable[[str], Reading], system: System, text: str, told: list[str]
) -> None:
    """The tables of documents were compared, and no sentence: claim-sent-value."""
    reference = replace(read("").reference, dialect=system.dialect, systems=(system,))
    found = check(read_document(HEAD + text, "/documents/notes.md", reference))
    assert [each.message.removeprefix("DISTANCE_SENSOR.") for each in found] == told
