"""Units of the dialects and of the tables, and the exact maps between them."""

import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from functools import cache

from codegen.frozen import dataclass
from codegen.model.units.affine import AffineMap
from codegen.model.units.unit_table import BASES, ONLY_WITH_PREFIX, PREFIXES, SHOWN, SYMBOLS, ZEROS

Dimension = tuple[tuple[str, int], ...]
"""The base units that a unit is made of with their powers, by name: m/s/s is (("m", 1), ("s", -2))."""


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit: one of it is ``scale * pi ** pi`` of the base units of its dimension, exactly; its 0 is at ``zero``.

    1 mV is 1/1000 V, 1 rad is 180/pi deg (so ``pi`` is -1), and 0 degC is 273.15 K. Only units of one dimension
    convert into each other.
    """

    name: str
    dimension: Dimension
    scale: Fraction
    pi: int = 0
    zero: Fraction = Fraction(0)

    def __hash__(self) -> int:
        """Return a hash without the fractions, which take long and hardly tell units of one name apart."""
        return hash((self.name, self.dimension))

    @staticmethod
    def parse(text: str | None) -> "Unit | None":
        """The unit that a dialect or a table spells so; None for text that is none.

        Known are the symbols with their prefixes and what is made of them: ``m/s/s``, ``cm^3/min``, ``kg*m/s^2``,
        ``1/s``, from left to right. What follows says what was done to the number, as in the dialects: ``degE7`` is
        degrees times 10 ** 7, ``m/sE3`` and ``m/s*1000`` metres per second times 1000, ``deg/2`` degrees divided by 2.
        """
        return None if not text else _parsed(text)

    @property
    def kind(self) -> str:
        """Return what it measures, in a word: voltage, speed; else its dimension in base units."""
        return _kinds().get(self.dimension) or _spelled(self.dimension)

    @property
    def a_kind(self) -> str:
        """Return the kind with its article: "a length", "an angle"."""
        return f"{'an' if self.kind[:1] in 'aeio' else 'a'} {self.kind}"

    def times(self, other: "Unit") -> "Unit":
        """Return the product with another unit, whether the names of both can be parsed or not: steps of a sensor's."""
        powers = dict(self.dimension)
        for base, power in other.dimension:
            powers[base] = powers.get(base, 0) + power
        dimension = tuple(sorted((base, power) for base, power in powers.items() if power))
        name = "*".join(each.name for each in (self, other) if each.name)
        return Unit(name, dimension, self.scale * other.scale, self.pi + other.pi)


NUMBER = Unit("", (), Fraction(1))
"""The unit of pure numbers, in fields and quantities that state none."""


@cache
def conversion(unit: Unit, other: Unit) -> AffineMap | None:
    """Return what turns a value in ``unit`` into one in ``other``; None across dimensions."""
    if unit.dimension != other.dimension:
        return None
    return AffineMap(unit.scale / other.scale, unit.pi - other.pi, (unit.zero - other.zero) / other.scale)


def ratio(unit: Unit, other: Unit) -> Fraction | None:
    """The factor from ``unit`` to ``other``; None across dimensions, and where pi or an offset lies between them."""
    found = conversion(unit, other)
    return None if found is None else found.ratio


def unit_named(name: str) -> Unit:
    """A unit that the generator itself names."""
    unit = Unit.parse(name)
    assert unit is not None, name
    return unit


def shown_units() -> Iterable[Unit]:
    """The units that values are shown in, the preferred ones first."""
    return (unit_named(name) for name in SHOWN)


@cache
def symbols() -> Mapping[str, tuple[str, str]]:
    """Prefix and symbol by the name that both make, mV; every name once, so none can be read in two ways."""
    names: dict[str, tuple[str, str]] = {name: ("", name) for name in SYMBOLS if name not in ONLY_WITH_PREFIX}
    for name, (_, _, prefixes) in SYMBOLS.items():
        for prefix in prefixes.split():
            assert prefix + name not in names, f"{prefix}{name} is two units"
            names[prefix + name] = (prefix, name)
    return names


# A symbol, its power, and what the number was multiplied with (E7).
_PART = re.compile(r"(?P<symbol>[A-Za-z%]{1,12}?)(?:\^(?P<power>-?[1-9]))?(?:E(?P<tens>[0-9]))?")
_NUMBER = re.compile(r"[0-9]{1,9}(?:\.[0-9]{1,9})?")
_MOST_PARTS = 8


@cache
def _parsed(text: str) -> Unit | None:
    """The unit of a spelling, its parts multiplied from left to right."""
    if text.isalpha() and text not in symbols():
        return None  # at once: documents are full of words
    first, *rest = re.split(r"([*/])", text, maxsplit=2 * _MOST_PARTS)
    pieces = [("*", first), *zip(rest[::2], rest[1::2], strict=True)]
    if first == "1" and rest[:1] == ["/"]:
        del pieces[0]  # 1/s
    powers: dict[str, int] = {}
    scale, pi, zero, parts = Fraction(1), 0, Fraction(0), 0
    for sign, piece in pieces:
        direction = 1 if sign == "*" else -1
        if _NUMBER.fullmatch(piece) and parts:
            number = Fraction(piece)  # the unit is as much smaller as the number is larger
            if not number:
                return None
            scale /= number**direction
            continue
        found = _part(piece)
        if found is None:
            return None
        unit, power, tens = found
        power *= direction
        parts += 1
        scale *= unit.scale**power / 10**tens  # the number is larger, on whichever side of a stroke that is said
        pi += unit.pi * power
        zero = unit.zero if parts == 1 and power == 1 else Fraction(0)  # in a compound a degree is a difference
        for base, exponent in unit.dimension:
            powers[base] = powers.get(base, 0) + exponent * power
    dimension = tuple(sorted((base, power) for base, power in powers.items() if power))
    return Unit(text, dimension, scale, pi, zero) if parts else None


def _part(text: str) -> tuple[Unit, int, int] | None:
    """A symbol with its prefix, its power, and the power of 10 that the number was multiplied with."""
    match = _PART.fullmatch(text)
    if match is None or match["symbol"] not in symbols():
        return None
    prefix, name = symbols()[match["symbol"]]
    amount, of, _ = SYMBOLS[name]
    base = Unit(name, ((name, 1),), Fraction(1)) if name in BASES else unit_named(of)
    scale = base.scale * Fraction(amount.removesuffix("/pi")) * Fraction(PREFIXES[prefix])
    unit = Unit(
        text,
        base.dimension,
        scale,
        base.pi - amount.endswith("/pi"),
        Fraction(ZEROS.get(name, "0")),
    )
    return unit, int(match["power"] or 1), int(match["tens"] or 0)


@cache
def _kinds() -> Mapping[Dimension, str]:
    """The word for each dimension that has one."""
    return {(): "number"} | {unit_named(name).dimension: kind for name, kind in SHOWN.items()}


def _spelled(dimension: Dimension) -> str:
    """The base units of a dimension: kg*m/s^2."""
    above = [f"{base}^{power}" if power > 1 else base for base, power in dimension if power > 0]
    below = [f"/{base}^{-power}" if power < -1 else f"/{base}" for base, power in dimension if power < 0]
    return f"{'*'.join(above) or '1'}{''.join(below)}"


# As long as any quantity of a vehicle needs, and short enough to compute with. A digit does not begin a unit by itself.
_AMOUNT = re.compile(
    r"\s*([-+]?(?:[0-9]{1,20}(?:\.[0-9]{0,20})?|\.[0-9]{1,20})(?:[eE][-+]?[0-9]{1,2})?)(?:\s+|(?![0-9.]))(\S{1,60})\s*"
)


@dataclass(frozen=True, slots=True)
class Measure:
    """A number with its unit, such as 3.3 V."""

    value: Fraction
    unit: Unit

    def in_unit(self, unit: Unit) -> Fraction | None:
        """The number in ``unit``; None across dimensions, and where it is irrational."""
        found = conversion(self.unit, unit)
        return None if found is None else found.exact(self.value)


def read_measure(text: str) -> Measure | None:
    """``"3.3 V"`` as a measure; None if it is not a number followed by a known unit."""
    match = _AMOUNT.fullmatch(text)
    unit = Unit.parse(match[2]) if match else None
    return None if match is None or unit is None else Measure(Fraction(match[1]), unit)


def beyond_decimals(value: Fraction) -> int:
    """Return the denominator without what a decimal can write: 1 where there is an exact one."""
    rest = value.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    return rest


def decimal(value: Fraction) -> str:
    """An exact decimal where there is one, such as 0.0001; else a fraction, such as 1/3."""
    if value.denominator == 1:
        return str(value.numerator)
    if beyond_decimals(value) != 1:
        return str(value)
    places = 0
    while (value * 10**places).denominator != 1:
        places += 1
    digits = str(abs(int(value * 10**places))).rjust(places + 1, "0")
    return f"{'-' if value < 0 else ''}{digits[:-places]}.{digits[-places:]}"


def shortly(value: Fraction) -> str:
    """The same; a fraction of long numbers, which comes of one in place of pi, to nine digits."""
    text = decimal(value)
    return f"{float(value):.9g}" if "/" in text and len(text) > LONGEST_FRACTION else text


LONGEST_FRACTION = 12
"""So many characters of a fraction are read as one."""


def map_words(found: AffineMap) -> str:
    """``* 9/5 + 273.15``, ``* 1/180 * pi``."""
    words = [] if found.factor == 1 else [f"* {decimal(found.factor)}"]
    if found.pi:
        words.append(f"{'*' if found.pi > 0 else '/'} pi{'' if abs(found.pi) == 1 else f'^{abs(found.pi)}'}")
    if found.offset:
        words.append(f"{'+' if found.offset > 0 else '-'} {decimal(abs(found.offset))}")
    return " ".join(words) or "* 1"
