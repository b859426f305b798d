"""Every unit that a shipped dialect uses is known to the generator, as what it is."""

from fractions import Fraction
from functools import cache
from pathlib import Path

import pymavlink
import pytest
from lxml import etree
from stated_units import STATED

from codegen.model.units.affine import AffineMap
from codegen.model.units.unit import Unit, conversion, unit_named

FOLDER = Path(pymavlink.__file__).parent
SCHEMA = FOLDER / "generator" / "mavschema.xsd"
XSD = "{http://www.w3.org/2001/XMLSchema}"
TEMPERATURES = {"K": 0, "degC": Fraction("273.15"), "cdegC": Fraction("273.15")}


@cache
def used_units() -> frozenset[str]:
    """All that stand in the XML of any dialect: of fields, and of parameters of commands."""
    paths = sorted(FOLDER.glob("**/*.xml"))
    assert len(paths) > 30
    return frozenset(unit for path in paths for unit in etree.parse(path).xpath("//@units"))


def allowed_units() -> frozenset[str]:
    """Those that a dialect may use by the schema."""
    schema = etree.parse(SCHEMA)
    found = schema.iterfind(f".//{XSD}simpleType[@name='SI_Unit']//{XSD}enumeration")
    return frozenset(each.get("value") for each in found)


def test_the_table_has_every_unit() -> None:
    """Of all dialects and of their schema; a release with a new one fails here."""
    assert len(used_units()) > 60
    assert used_units() | allowed_units() == STATED.keys()


@pytest.mark.parametrize("name", STATED)
def test_what_a_unit_is(name: str) -> None:
    """Its dimension, and its factor to a unit of the definition, to the last digit."""
    factor, pi, of, kind = STATED[name]
    unit = unit_named(name)
    assert unit.kind == kind
    found = conversion(unit, unit_named(of))
    assert found == AffineMap(factor, pi, TEMPERATURES.get(name, Fraction(0)))


@pytest.mark.parametrize("name", STATED)
def test_what_converts_into_what(name: str) -> None:
    """Units of one kind, and no others; the factors of all pairs follow from the table."""
    factor, pi, _, kind = STATED[name]
    for other, (other_factor, other_pi, _, other_kind) in STATED.items():
        found = conversion(unit_named(name), unit_named(other))
        assert (found is not None) == (kind == other_kind), other
        if found is not None:
            assert (found.factor, found.pi) == (factor / other_factor, pi - other_pi)
            offset = (TEMPERATURES.get(name, 0) - TEMPERATURES.get(other, 0)) / other_factor
            assert found.offset == offset


@pytest.mark.parametrize(
    ("amount", "of"),
    [("V*A", "W"), ("W*s", "J"), ("A*h", "Ah"), ("V*s/m^2", "T"), ("N/m^2", "Pa"), ("J/s", "W"), ("kg*m/s^2", "N")],
)
def test_derived_units_are_made_of_the_base_units(amount: str, of: str) -> None:
    """The definitions of the derived units of the SI."""
    assert conversion(unit_named(amount), unit_named(of)) == AffineMap(Fraction(1))


def test_no_unit_that_is_none() -> None:
    """A number of the schema's factors is no unit."""
    assert [text for text in ("1E-2", "2E-3", "360/255", "invalid", "") if Unit.parse(text)] == []
