"""Units of dialects and of what is kept, read anew: a wrong factor of the generator would judge itself otherwise."""

import math
import re

_ONES = {
    "m": 1, "g": 0.001, "s": 1, "min": 60, "h": 3600, "A": 1, "C": 1, "Ah": 3600, "V": 1, "W": 1, "J": 1, "Wh": 3600,
    "N": 1, "Hz": 1, "Pa": 1, "bar": 100000, "Ohm": 1, "T": 1, "gauss": 0.0001, "l": 0.001, "L": 0.001, "K": 1,
    "degC": 1, "rad": 1, "deg": math.pi / 180, "rev": 2 * math.pi, "rpm": math.pi / 30, "kn": 1852 / 3600, "G": 9.80665,
    "%": 1, "dB": 1, "dBm": 1, "bits": 1, "bytes": 8, "B": 8, "pix": 1,
}  # fmt: skip
_PREFIXES = {
    "n": 1e-9, "u": 1e-6, "m": 1e-3, "c": 1e-2, "d": 0.1, "da": 10, "h": 100, "k": 1000, "M": 1e6, "G": 1e9,
    "Ki": 1 << 10, "Mi": 1 << 20, "Gi": 1 << 30,
}  # fmt: skip
_NUMBER = re.compile(r"\d+(?:\.\d+)?")
_PART = re.compile(r"(?P<name>[A-Za-z%]+?)(?:\^(?P<power>-?\d))?(?:E(?P<tens>\d+))?")
_CELSIUS = re.compile(r"[a-z]{0,2}degC(E\d+)?")


def one(text):
    """Return what 1 in a unit such as cdeg, degE7, m/s*5 is, in that of its dimension; None if it is strange."""
    size = 1.0
    parts = re.findall("([*/]?)([^*/]+)", text)
    for sign, part in parts[1:] if text.startswith("1/") else parts:
        sign = -1 if sign == "/" else 1  # noqa: PLW2901  as a power
        if _NUMBER.fullmatch(part):  # the number was multiplied, or divided, so that one of them is so much less
            size /= float(part) ** sign
            continue
        match = _PART.fullmatch(part)
        known = None if match is None else _named(match["name"])
        if known is None:
            return None
        size *= (known ** int(match["power"] or 1)) ** sign / 10 ** int(match["tens"] or 0)
    return size


def zero(text):
    """Return where the scale of a unit begins, in that of its dimension: only degrees Celsius begin elsewhere."""
    return 273.15 if _CELSIUS.fullmatch(text) else 0


def _named(name):
    """Return the size of a name with its prefix, or None."""
    if name in _ONES:
        return _ONES[name]
    for prefix, times in _PREFIXES.items():
        if name.startswith(prefix) and name[len(prefix) :] in _ONES:
            return times * _ONES[name[len(prefix) :]]
    return None
