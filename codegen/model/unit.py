"""Units of the dialects and of the tables, and the exact factors between them."""

import re
from fractions import Fraction

from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Unit:
    """A unit: ``factor`` of them make one base unit of ``dimension`` (1000 for mV), exactly.

    Units convert into each other only within a dimension. Radians and degrees are two dimensions, since the
    factor between them is not rational.
    """

    name: str
    dimension: str
    factor: Fraction

    def to(self, other: "Unit") -> Fraction | None:
        """The number that a value in this unit is multiplied with to be in ``other``; None across dimensions."""
        return other.factor / self.factor if self.dimension == other.dimension else None


NUMBER = Unit("", "number", Fraction(1))
"""The unit of pure numbers, in fields and quantities that state none."""

# dimension: {unit: how many of it make one base unit}
_DIMENSIONS: dict[str, dict[str, str]] = {
    "voltage": {"V": "1", "dV": "10", "cV": "100", "mV": "1000", "uV": "1000000"},
    "voltage per time": {"V/s": "1", "mV/s": "1000"},
    "current": {"A": "1", "dA": "10", "cA": "100", "mA": "1000"},
    "charge": {"Ah": "1", "mAh": "1000", "C": "3600"},
    "energy": {"J": "1", "hJ": "1/100", "kJ": "1/1000", "Wh": "1/3600", "mWh": "1/3.6"},
    "power": {"W": "1", "mW": "1000"},
    "temperature": {"degC": "1", "ddegC": "10", "cdegC": "100"},
    "ratio": {"%": "100", "d%": "1000", "c%": "10000"},
    "time": {"s": "1", "ds": "10", "cs": "100", "ms": "1000", "us": "1000000", "ns": "1000000000", "min": "1/60"},
    "frequency": {"Hz": "1", "kHz": "1/1000", "MHz": "1/1000000", "rpm": "60"},
    "length": {"m": "1", "dm": "10", "cm": "100", "mm": "1000", "dam": "1/10", "km": "1/1000"},
    "speed": {"m/s": "1", "dm/s": "10", "cm/s": "100", "mm/s": "1000", "m/s*5": "5", "km/h": "3.6"},
    "acceleration": {"m/s/s": "1", "mG": "1/0.00980665"},
    "angle in degrees": {
        "deg": "1",
        "ddeg": "10",
        "cdeg": "100",
        "degE5": "100000",
        "degE7": "10000000",
        "deg/2": "1/2",
    },
    "angle in radians": {"rad": "1", "mrad": "1000"},
    "rotation in degrees": {"deg/s": "1", "ddeg/s": "10", "cdeg/s": "100"},
    "rotation in radians": {"rad/s": "1", "mrad/s": "1000"},
    "pressure": {"Pa": "1", "hPa": "1/100", "kPa": "1/1000", "mbar": "1/100"},
    "magnetic field": {"gauss": "1", "mgauss": "1000"},
    "mass": {"kg": "1", "g": "1000", "mg": "1000000"},
    "volume": {"l": "1", "ml": "1000", "cm^3": "1000"},
    "flow": {"cm^3/min": "1", "l/min": "1/1000"},
    "area": {"m^2": "1", "cm^2": "10000"},
    "data": {"bytes": "1", "KiB": "1/1024", "MiB": "1/1048576", "bits": "8"},
    "data rate": {"bytes/s": "1", "KiB/s": "1/1024", "MiB/s": "1/1048576", "bits/s": "8"},
    "pixels": {"pix": "1", "dpix": "10"},
    "level": {"dB": "1"},
    "power level": {"dBm": "1"},
}


def _exact(text: str) -> Fraction:
    numerator, _, denominator = text.partition("/")
    return Fraction(numerator) / Fraction(denominator or "1")


UNITS: dict[str, Unit] = {
    name: Unit(name, dimension, _exact(factor))
    for dimension, units in _DIMENSIONS.items()
    for name, factor in units.items()
}
"""Every unit that is known, by its name in the dialects."""

# As long as any quantity of a vehicle needs, and short enough to compute with.
_AMOUNT = re.compile(r"\s*([-+]?(?:\d{1,20}(?:\.\d{0,20})?|\.\d{1,20})(?:[eE][-+]?\d{1,2})?)\s*(\S+)\s*")


@dataclass(frozen=True, slots=True)
class Measure:
    """A number with its unit, such as 3.3 V."""

    value: Fraction
    unit: Unit

    def in_unit(self, unit: Unit) -> Fraction | None:
        """The number in ``unit``; None across dimensions."""
        factor = self.unit.to(unit)
        return None if factor is None else self.value * factor


def read_measure(text: str) -> Measure | None:
    """``"3.3 V"`` as a measure; None if it is not a number followed by a known unit."""
    match = _AMOUNT.fullmatch(text)
    if match is None or match[2] not in UNITS:
        return None
    return Measure(Fraction(match[1]), UNITS[match[2]])


def decimal(value: Fraction) -> str:
    """An exact decimal where there is one, such as 0.0001; else a fraction, such as 1/3."""
    rest = value.denominator
    for prime in (2, 5):
        while rest % prime == 0:
            rest //= prime
    if rest != 1:
        return str(value)
    places = 0
    while (value * 10**places).denominator != 1:
        places += 1
    digits = str(abs(int(value * 10**places))).rjust(places + 1, "0")
    sign = "-" if value < 0 else ""
    return f"{sign}{digits[:-places]}.{digits[-places:]}" if places else f"{sign}{digits}"
