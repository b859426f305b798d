"""The symbols that units are written with: each one by those before it, and the prefixes that it may have."""

PREFIXES = {
    "": "1",
    "n": "1/1000000000",
    "u": "1/1000000",
    "m": "1/1000",
    "c": "1/100",
    "d": "1/10",
    "da": "10",
    "h": "100",
    "k": "1000",
    "M": "1000000",
    "G": "1000000000",
    "Ki": "1024",
    "Mi": "1048576",
    "Gi": "1073741824",
}
"""The factors of prefixes."""

BASES = {
    "m": "length",
    "g": "mass",
    "s": "time",
    "A": "current",
    "K": "temperature",
    "deg": "angle",
    "bits": "data",
    "%": "ratio",
    "pix": "pixels",
    "dB": "level",
    "dBm": "power level",
}
"""The unit of each dimension that is not made of others, and what it measures.

An angle is a dimension, so that a rotation is not a frequency. Shares are one, too: a number without a unit is not
taken for percent. dB and dBm are logarithms of ratios and of powers, which no factor leads to.
"""

SYMBOLS: dict[str, tuple[str, str, str]] = {
    # symbol: (how much, of what, prefixes that occur with it)
    "m": ("1", "m", "k da d c m u n"),
    "g": ("1", "g", "k m u"),
    "s": ("1", "s", "d c m u n"),
    "A": ("1", "A", "k d c m u"),
    "K": ("1", "K", "d c m"),
    "degC": ("1", "K", "d c m"),
    "deg": ("1", "deg", "d c m u"),
    "bits": ("1", "bits", "k M"),
    "%": ("1", "%", "d c m"),
    "pix": ("1", "pix", "d c"),
    "dB": ("1", "dB", "d c"),
    "dBm": ("1", "dBm", "d c"),
    "min": ("60", "s", ""),
    "h": ("3600", "s", ""),
    "Hz": ("1", "1/s", "k M G d c m"),
    "rad": ("180/pi", "deg", "m u"),
    "rev": ("360", "deg", ""),
    "rpm": ("1", "rev/min", "d c"),
    "kn": ("463/900", "m/s", ""),
    "G": ("9.80665", "m/s^2", "c m u"),
    "N": ("1", "kg*m/s^2", "k m"),
    "J": ("1", "N*m", "k h m"),
    "W": ("1", "J/s", "k d c m"),
    "Wh": ("3600", "J", "k m"),
    "C": ("1", "A*s", "m"),
    "Ah": ("3600", "C", "c m"),
    "V": ("1", "W/A", "k d c m u"),
    "Ohm": ("1", "V/A", "k M m u"),
    "Pa": ("1", "N/m^2", "M k h d c m"),
    "bar": ("100000", "Pa", "d c m"),
    "T": ("1", "V*s/m^2", "m u n"),
    "gauss": ("1/10000", "T", "m u"),
    "l": ("1/1000", "m^3", "d c m"),
    "L": ("1", "l", "d c m"),
    "bytes": ("8", "bits", "k M"),
    "B": ("1", "bytes", "Ki Mi Gi"),
}
"""G is the standard gravity of the fields in mG (a gauss has its name in full), rev a turn, kn a knot: 1852 m/h."""

ZEROS = {"degC": "273.15"}
"""The zero of a unit's scale, in the base unit."""

ONLY_WITH_PREFIX = frozenset({"B"})
"""Units that the dialects write only with a prefix, in KiB and MiB."""

SHOWN = {
    "V": "voltage",
    "V/s": "voltage per time",
    "A": "current",
    "Ah": "charge",
    "J": "energy",
    "W": "power",
    "Ohm": "resistance",
    "degC": "temperature",
    "K": "temperature",
    "%": "ratio",
    "s": "time",
    "Hz": "frequency",
    "m": "length",
    "m/s": "speed",
    "m/s/s": "acceleration",
    "deg": "angle",
    "rad": "angle",
    "deg/s": "rotation",
    "rad/s": "rotation",
    "rpm": "rotation",
    "Pa": "pressure",
    "gauss": "magnetic field",
    "kg": "mass",
    "N": "force",
    "l": "volume",
    "cm^3/min": "flow",
    "g/min": "mass flow",
    "m^2": "area",
    "bytes": "data",
    "bytes/s": "data rate",
    "pix": "pixels",
    "dB": "level",
    "dBm": "power level",
}
"""The dimension of a unit, in a word, by units that values are shown in, the preferred ones first."""

WORDS = {
    "volt": "V",
    "amp": "A",
    "ampere": "A",
    "watt": "W",
    "joule": "J",
    "ohm": "Ohm",
    "celsius": "degC",
    "degree celsius": "degC",
    "degrees celsius": "degC",
    "gauss": "gauss",
    "ampere hour": "Ah",
    "amp hour": "Ah",
    "watt hour": "Wh",
    "celcius": "degC",
    "centigrade": "degC",
    "kelvin": "K",
    "degree": "deg",
    "radian": "rad",
    "second": "s",
    "sec": "s",
    "msec": "ms",
    "usec": "us",
    "minute": "min",
    "hour": "h",
    "hr": "h",
    "hertz": "Hz",
    "metre": "m",
    "meter": "m",
    "kph": "km/h",
    "kmh": "km/h",
    "knot": "kn",
    "kt": "kn",
    "kts": "kn",
    "percent": "%",
    "pct": "%",
    "gram": "g",
    "litre": "l",
    "liter": "l",
    "pascal": "Pa",
    "newton": "N",
    "tesla": "T",
    "coulomb": "C",
    "byte": "bytes",
    "bit": "bits",
    "kbit": "kbits",
    "pixel": "pix",
    "px": "pix",
    "mps": "m/s",
    "revolution": "rev",
    "turn": "rev",
    "\u00b0": "deg",
    "\u00b0c": "degC",
    "\u00b5s": "us",
    "\u03a9": "Ohm",
}
"""Words that people write for a unit, in small letters and without a plural, with the dialects' spelling."""

SCALED = (
    *("degE7", "degE5", "deg/2", "m/s*5", "km/h", "mm/h", "dm/s", "cm/s", "mm/s", "mrad/s", "cdeg/s", "ddeg/s"),
    *("m^3", "cm^3", "cm^2", "l/min", "l/h", "L/h", "bits/s", "KiB/s", "MiB/s", "m/s^2", "deg/s/s", "rad/s/s"),
    *("1/s", "kg/m^3"),
)
"""Compounds and scaled units that occur, for hints."""

PREFIX_WORDS = {
    "nano": "n",
    "micro": "u",
    "milli": "m",
    "centi": "c",
    "deci": "d",
    "hecto": "h",
    "kilo": "k",
    "mega": "M",
    "giga": "G",
}
"""Prefixes that people write before such a word."""
