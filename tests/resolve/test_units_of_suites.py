"""The units of the generated suite, which it reads anew, are those of the generator: each spelling, and each scale."""

import math
import runpy
from pathlib import Path

import pytest
from stated_units import STATED

from codegen.model.units.unit import Unit, symbols
from codegen.model.units.unit_table import SCALED, SHOWN

SUITE = runpy.run_path(str(Path(__file__).resolve().parents[2] / "templates" / "tests" / "units.py"))
MADE = ("1/K", "m*m^-3", "m/sE3", "m/s*2.5", "degE2/s^2", "cm^2E1", "degCE2", "cdegC/min", "deg/2", "GiB/s", "kg*m/s^2")
BY_DIMENSION: dict[object, list[Unit]] = {}
for _name in sorted({*STATED, *symbols(), *SHOWN, *SCALED, *MADE}):
    _unit = Unit.parse(_name)
    assert _unit is not None, _name
    BY_DIMENSION.setdefault(_unit.dimension, []).append(_unit)


@pytest.mark.parametrize("units", BY_DIMENSION.values(), ids=[units[0].kind for units in BY_DIMENSION.values()])
def test_units_of_one_dimension_have_the_sizes_that_the_generator_knows(units: list[Unit]) -> None:
    """Of a unit that the suite did not know it would compare nothing, and of another size it would be red."""
    first, *others = units
    assert None not in map(SUITE["one"], (unit.name for unit in units))
    for unit in others:
        expected = float(unit.scale / first.scale) * math.pi ** (unit.pi - first.pi)
        assert math.isclose(SUITE["one"](unit.name) / SUITE["one"](first.name), expected, rel_tol=1e-13), unit.name


def test_scales_begin_where_the_generator_has_their_zero() -> None:
    """Degrees Celsius have another zero than kelvin, with each prefix, and none as a difference."""
    units = [unit for found in BY_DIMENSION.values() for unit in found]
    assert {unit.name: SUITE["zero"](unit.name) for unit in units} == {unit.name: float(unit.zero) for unit in units}


@pytest.mark.parametrize("text", ["furlong", "m/furlong", "m^"])
def test_what_is_no_unit_is_none(text: str) -> None:
    assert SUITE["one"](text) is None
