"""Facts about amounts: units, factors between them, and ranges."""

import random
from collections.abc import Mapping
from fractions import Fraction

from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit
from phrasing.filling import HALF, Fact, Maker, Words, both, of_field

_RUST = {"float": "f32", "double": "f64", "char": "u8"}
OTHER_UNITS = {
    "cm/s": ["m/s", "mm/s"], "m/s": ["cm/s", "km/h"], "mV": ["V", "cV"], "cA": ["mA", "A"], "cdegC": ["degC"],
    "mm": ["cm", "m"], "cm": ["mm", "m"], "m": ["cm", "mm"], "degE7": ["degE5", "deg"], "rad": ["deg", "mrad"],
    "rad/s": ["deg/s", "mrad/s"], "deg": ["rad", "cdeg"], "cdeg": ["deg", "mrad"], "ms": ["us", "s"],
    "us": ["ms", "ns"], "hPa": ["Pa", "kPa"], "degC": ["cdegC", "K"], "mAh": ["Ah", "cAh"], "hJ": ["J", "kJ"],
    "mG": ["G", "m/s/s"], "dm": ["m", "cm"], "deg/s": ["rad/s", "cdeg/s"], "s": ["ms", "min"],
}  # fmt: skip


_SPELLED = {
    "mV": "millivolts", "cm": "centimetres", "mm": "millimeters", "ms": "milliseconds", "us": "microseconds",
    "V": "volts", "deg": "degrees", "rad": "radians", "cdeg": "centidegrees", "rad/s": "radians per second",
    "m": "metres", "m/s": "metres per second", "cm/s": "centimetres per second", "degC": "degrees Celsius",
    "cA": "centiamps", "A": "amperes", "mA": "milliamps",
}  # fmt: skip


def _unit(chance: random.Random) -> Fact | None:
    found = of_field(chance, lambda field: (field.definition.units or "") in OTHER_UNITS and field.multiplier == 1)
    if found is None:
        return None
    _, field, words = found
    own = field.definition.units or ""
    pair = own, chance.choice(OTHER_UNITS[own])
    is_spelled = chance.random() < HALF
    right, wrong = (_SPELLED.get(unit, unit) if is_spelled else unit for unit in pair)
    rust = _RUST.get(field.type.name) or field.type.name.replace("uint", "u").replace("int", "i").removesuffix("_t")
    return both(words, right, wrong, rt=rust, n=field.name.replace("_", " "))


_PLAIN = {
    "mV": ("V", 1000), "cA": ("A", 100), "cdegC": ("degC", 100), "mm": ("m", 1000), "cm/s": ("m/s", 100),
    "cm": ("m", 100), "cdeg": ("deg", 100), "degE7": ("deg", 10**7), "ms": ("s", 1000), "hJ": ("kJ", 10),
    "dm": ("m", 10), "mG": ("G", 1000), "mrad/s": ("rad/s", 1000),
}  # fmt: skip


_ALSO = {"V": "volts", "A": "amps", "m": "metres", "deg": "degrees", "s": "seconds"}


_LARGE = 10**6


def _scaled(chance: random.Random) -> tuple[WireField, Words, str, int] | None:
    found = of_field(
        chance,
        lambda field: (field.definition.units or "") in _PLAIN and field.type.is_integer and field.multiplier == 1,
    )
    if found is None:
        return None
    _, field, words = found
    plain, factor = _PLAIN[field.definition.units or ""]
    return field, words, plain, factor


def _encoded(chance: random.Random) -> Fact | None:
    found = _scaled(chance)
    if found is None:
        return None
    field, words, plain, factor = found
    if field.is_array:
        return None
    steps = chance.randrange(11, 120)
    encoded = steps * factor // 10
    if not 0 < encoded <= field.type.maximum or factor == 10:
        return None
    shown = f"{Fraction(encoded, factor).__float__():g} {chance.choice([plain, _ALSO.get(plain, plain)])}"
    return both(words, encoded, chance.choice([encoded * 10, max(encoded // 10, 1), encoded * 100]), q=shown)


def _is_bounded_by_its_type(field: WireField) -> bool:
    """Return whether a field is one short whole number of which the dialect states no other range."""
    return (
        field.type.is_integer
        and field.type.size in (1, 2)
        and not field.definition.enum
        and not field.definition.maximum
        and not field.is_array
    )


def _maximum(chance: random.Random) -> Fact | None:
    found = of_field(chance, _is_bounded_by_its_type)
    if found is None:
        return None
    _, field, words = found
    top = field.type.maximum
    wrong = {127: 255, 255: 127, 32767: 65535, 65535: 32767}[top]
    unit = field.definition.units or ""
    if unit in _PLAIN and chance.random() < HALF:
        plain, factor = _PLAIN[unit]
        return both(words, *(f"{float(Fraction(value, factor)):g} {plain}" for value in (top, wrong)))
    unit = unit if Unit.parse(unit) and chance.random() < HALF else ""
    return both(words, *(f"{value} {unit}".strip() for value in (top, wrong)))


def _range(chance: random.Random) -> Fact | None:
    found = of_field(chance, _is_bounded_by_its_type)
    if found is None:
        return None
    _, field, words = found
    top = field.type.maximum
    return both(words, top, {127: 255, 255: 256, 32767: 65535, 65535: 65536}[top], lo=str(field.type.minimum))


def _scaling(chance: random.Random) -> Fact | None:
    found = _scaled(chance)
    if found is None:
        return None
    _, words, plain, factor = found
    return both(words, factor, factor * 10 if factor < _LARGE else factor // 100, w=plain)


MAKERS: Mapping[str, Maker] = {
    "unit": _unit,
    "encoded": _encoded,
    "maximum": _maximum,
    "range": _range,
    "scaling": _scaling,
}
"""By the kind of phrasing that each fills."""
