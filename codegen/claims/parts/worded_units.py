"""Units as documents write them in words: "feet", "metres per second squared", "tenths of a degree"."""

import re
from collections.abc import Mapping
from fractions import Fraction
from functools import lru_cache

from codegen.model.units.nearest_unit import worded_unit as unit_of_word
from codegen.model.units.unit import Unit, unit_named
from codegen.model.units.unit_table import PREFIX_WORDS, PREFIXES
from codegen.pattern import pattern


@lru_cache(maxsize=4096)
def worded_unit(written: str) -> Unit | None:
    """Return the unit of a word or a symbol, of those that no dialect uses, too: "feet", "hectometres"."""
    return unit_of_word(written) or _OTHER_UNITS.get(written.lower()) or _SYMBOLS.get(written) or _prefixed(written)


def _times(name: str, factor: Fraction | int, of: str) -> Unit:
    """Return the unit that is so many of another one."""
    other = unit_named(of)
    return Unit(name, other.dimension, other.scale * factor, other.pi, other.zero)


_FOOT = Fraction(3048, 10000)
_OTHER_UNITS: Mapping[str, Unit] = {
    **dict.fromkeys(("feet", "foot", "ft"), _times("ft", _FOOT, "m")),
    **dict.fromkeys(("inches", "inch"), _times("in", _FOOT / 12, "m")),
    **dict.fromkeys(("yard", "yards"), _times("yd", _FOOT * 3, "m")),
    **dict.fromkeys(("fathom", "fathoms"), _times("fathom", _FOOT * 6, "m")),
    **dict.fromkeys(("mile", "miles", "statute miles"), _times("mi", _FOOT * 5280, "m")),
    **dict.fromkeys(("nautical mile", "nautical miles", "nmi"), _times("nmi", 1852, "m")),
    **dict.fromkeys(("mph", "miles per hour"), _times("mph", _FOOT * 5280 / 3600, "m/s")),
    **dict.fromkeys(("ft/s", "fps", "feet per second"), _times("ft/s", _FOOT, "m/s")),
    **dict.fromkeys(("ft/min", "fpm", "feet per minute"), _times("ft/min", _FOOT / 60, "m/s")),
    **dict.fromkeys(("revolutions per minute",), unit_named("rpm")),
    **dict.fromkeys(("per mille", "permille"), unit_named("d%")),
    **dict.fromkeys(("milli-g", "milli g", "millig"), unit_named("mG")),
    **dict.fromkeys(("millibar", "millibars", "mbar"), unit_named("mbar")),
    **dict.fromkeys(("psi",), _times("psi", Fraction("6894.757293168"), "Pa")),
    **dict.fromkeys(("decibel", "decibels"), unit_named("dB")),
    **dict.fromkeys(("arcminute", "arcminutes", "arcmin"), _times("arcmin", Fraction(1, 60), "deg")),
    **dict.fromkeys(("arcsecond", "arcseconds", "arcsec"), _times("arcsec", Fraction(1, 3600), "deg")),
    **dict.fromkeys(("day", "days"), _times("days", 86400, "s")),
    **dict.fromkeys(("week", "weeks"), _times("weeks", 604800, "s")),
    **dict.fromkeys(("bps", "bit/s"), unit_named("bits/s")),
    **dict.fromkeys(("kbps", "kbit/s"), _times("kbit/s", 1000, "bits/s")),
    **dict.fromkeys(("mbps", "mbit/s"), _times("Mbit/s", 1000000, "bits/s")),
    **dict.fromkeys(("kb/s",), _times("kB/s", 1000, "bytes/s")),
    **dict.fromkeys(("fahrenheit", "degrees fahrenheit", "\u00b0f"), Unit(
        "degF", unit_named("K").dimension, Fraction(5, 9), 0, Fraction("459.67") * Fraction(5, 9)
    )),
}  # fmt: skip
_SYMBOLS: Mapping[str, Unit] = {
    "hm": _times("hm", 100, "m"),
    "GB": _times("GB", 10**9, "bytes"),
    "TB": _times("TB", 10**12, "bytes"),
}
"""Symbols in which a capital is another letter."""
_PREFIXES: Mapping[str, Fraction | int] = {
    **{word: Fraction(PREFIXES[symbol]) for word, symbol in PREFIX_WORDS.items()},
    **dict.fromkeys(("deca", "deka"), Fraction(PREFIXES["da"])),
    "pico": Fraction(1, 10**12),
    "tera": 10**12,
    "kibi": 1 << 10,
    "mebi": 1 << 20,
    "gibi": 1 << 30,
    "tebi": 1 << 40,
}
"""The factors of prefixes as words: those of the dialects, and others."""


def _prefixed(written: str) -> Unit | None:
    """Return the unit of a word with any prefix, also one that no dialect has: "decametres", "gibibytes"."""
    folded = written.casefold()
    for prefix, factor in _PREFIXES.items():
        whole = unit_of_word(folded.removeprefix(prefix)) if folded.startswith(prefix) else None
        if whole is not None and len(folded) - len(prefix) >= _SHORTEST and whole.dimension and not whole.zero:
            return Unit(written, whole.dimension, whole.scale * factor, whole.pi)
    return None


_SHORTEST = 3
"""Letters of a word behind a prefix: "megabit" is one, "decide" is not."""


def unit_of_words(written: str) -> Unit | None:
    """Return the unit of words: "centi degrees", "metres per second squared", "deg C"."""
    if (other := _OTHER_UNITS.get(written.lower())) is not None:
        return other
    text = " ".join(written.replace("-", " ").split())
    text = re.sub(rf"\b({'|'.join(_PREFIXES)}) ", r"\1", text)
    text = pattern(r"/(?:sec|second)\b").sub(" per second", text)
    squared = pattern(r" (?:a|per) second (?:squared|per second)$").sub("", text)
    if squared != text:
        inner = worded_unit(squared)
        return Unit.parse(f"{inner.name}/s/s") if inner is not None else None
    return worded_unit(text) or worded_unit(text.replace(" a ", " per ")) or worded_unit(text.lower())


def finer(unit: Unit, parts: int | Fraction) -> Unit:
    """Return the unit of which ``parts`` are one of another."""
    return Unit(f"{unit.name}/{parts}", unit.dimension, unit.scale / Fraction(parts), unit.pi, unit.zero)
