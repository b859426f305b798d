"""A text of a failsafe shows a number in the unit of its quantity, and says no other behind it."""

from dataclasses import replace
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.model.units.unit import NUMBER, Unit
from codegen.model.vehicle import Quantity
from codegen.project.systems import read_systems
from codegen.resolve.failsafes.shown_unit import other_unit

BOAT = Path(__file__).resolve().parents[2] / "examples" / "boat" / "specs" / "codegen.yaml"


@pytest.fixture(scope="module")
def quantity() -> Quantity:
    (system,) = read_systems(str(BOAT), Report())
    return next(each for part in system.components.values() for each in part.quantities.values() if each.unit.name)


@pytest.mark.parametrize(
    ("unit", "behind", "expected"),
    [
        ("m", " m", None),
        ("m", " metres.", None),
        ("m", "m, and falls", None),
        ("m", " cm", "cm"),
        ("m", " feet.", "feet"),
        ("m", "mm", "mm"),
        ("m", ", min 3 m", None),
        ("m", " s to go", None),
        ("m", "", None),
        ("degC", " C", None),
        ("degC", " \u00b0C", None),
        ("degC", " K", "K"),
        ("degC", " F", "F"),
        ("s", " min left", "min"),
        ("", " %", None),
        ("%", " %", None),
        ("V", "V]", None),
    ],
)
def test_a_unit_of_another_scale_is_found(quantity: Quantity, unit: str, behind: str, expected: str | None) -> None:
    """A word that is a unit of something else is left alone, as is what stands behind a number without a unit."""
    shown = replace(quantity, unit=Unit.parse(unit) or NUMBER)
    assert other_unit(shown, behind) == expected
