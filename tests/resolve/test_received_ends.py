"""Received numbers that a quantity cannot keep, its steps being fine, are an error unless somebody states an end."""

import math
import shutil
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.project.systems import read_systems
from codegen.resolve.dialect.special_numbers import is_among

SPECS = Path(__file__).resolve().parents[1] / "projects" / "received" / "specs"
FIRST = "      left: {doc: Left wheel., unit: m}\n"
CLIMB, TURN = "HIGH_LATENCY2", "OBSTACLE_DISTANCE"


@pytest.mark.parametrize(
    ("message", "field", "quantity", "table", "ends"),
    [
        (CLIMB, "altitude", "unit: m, stored: um", "", "um ends at 1073.742 m"),
        (CLIMB, "altitude", "unit: m, stored: um", ", min: -100", "um ends at 1073.742 m"),
        (CLIMB, "altitude", "unit: m, stored: um, max: 1000", "", "um ends at -1073.742 m"),
        (CLIMB, "altitude", "unit: m, stored: um", ", min: -100, max: 1000", ""),
        (CLIMB, "altitude", "unit: m, stored: um, min: -100, max: 1000", "", ""),
        (CLIMB, "altitude", "unit: m, stored: mm", "", ""),
        (TURN, "increment_f", "unit: deg, stored: degE7", "", "degE7 ends at 107.3742 deg"),
        (TURN, "increment_f", "unit: deg, stored: degE7", ", min: -90, max: 90", ""),
        (TURN, "increment_f", "unit: deg, stored: cdeg", "", ""),
        (TURN, "increment_f", "unit: deg", "", ""),
    ],
)
def test_it_is_said_where_a_word_ends(
    message: str, field: str, quantity: str, table: str, ends: str, tmp_path: Path
) -> None:
    """A height froze at 1073 m, an angle beyond 107 degrees was left out, and nobody was told."""
    specs = Path(shutil.copytree(SPECS, tmp_path / "specs"))
    state = specs / "state.yaml"
    state.write_text(state.read_text().replace(FIRST, f"      near: {{doc: d, {quantity}}}\n{FIRST}"))
    text = f"receive: {message}\nrequirement: FR-1.8\nfields:\n  {field}: {{state: wheels.near{table}}}\n"
    (specs / "receives" / "more.yaml").write_text(text)
    report = Report()
    read_systems(str(specs / "codegen.yaml"), report)
    found = [each for each in report if each.rule.id == "cannot-receive"]
    assert [each.message.rpartition("in ")[2] for each in found] == [ends] * bool(ends)
    assert all("coarser steps" in str(each.hint) for each in found)


def test_nan_is_among_numbers_that_have_it() -> None:
    """It equals nothing, itself included: NaN as a value that leaves things as they are would never be one."""
    assert is_among(math.nan, (0, math.nan))
    assert not is_among(math.nan, (0, 1))
    assert is_among(1, (math.nan, 1))
    assert not is_among(2, (math.nan, 1))
