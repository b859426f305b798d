# Generated from templates/tests/units.py: do not edit.
# Inputs: 772156718d23862d
"""Units of dialects and of what is kept, read anew: a wrong factor of the generator would judge itself otherwise."""

import math
import re

_ONES = {
    "m": 1, "s": 1, "min": 60, "h": 3600, "g": 1, "A": 1, "V": 1, "W": 1, "J": 1, "N": 1, "Hz": 1, "Pa": 1,
    "bar": 100000, "rad": 1, "deg": math.pi / 180, "%": 1, "l": 0.001, "Ah": 3600, "Wh": 3600, "G": 1, "gauss": 1,
    "rpm": math.pi / 30, "rev": 2 * math.pi, "degC": 1, "dB": 1, "bytes": 1, "bits": 1, "pix": 1,
}  # fmt: skip
_PREFIXES = {"n": 1e-9, "u": 1e-6, "m": 1e-3, "c": 1e-2, "d": 0.1, "da": 10, "h": 100, "k": 1000, "M": 1e6, "G": 1e9}
_PART = re.compile(r"(?P<name>[A-Za-z%]+?)(?:E(?P<tens>\d+))?(?:\^(?P<power>\d))?")


def one(text):
    """Return what 1 in a unit such as cdeg, degE7, m/s*5 is, in that of its dimension; None if it is strange."""
    size = 1.0
    for sign, part in re.findall("([*/]?)([^*/]+)", text):
        sign = -1 if sign == "/" else 1  # noqa: PLW2901  as a power
        if part.isdigit():  # the number was multiplied, or divided, so that one of them is so much less
            size /= int(part) ** sign
            continue
        match = _PART.fullmatch(part)
        known = None if match is None else _named(match["name"])
        if known is None:
            return None
        size *= (known ** int(match["power"] or 1)) ** sign / 10 ** int(match["tens"] or 0)
    return size


def _named(name):
    """Return the size of a name with its prefix, or None."""
    if name in _ONES:
        return _ONES[name]
    for prefix, times in _PREFIXES.items():
        if name.startswith(prefix) and name[len(prefix) :] in _ONES:
            return times * _ONES[name[len(prefix) :]]
    return None
