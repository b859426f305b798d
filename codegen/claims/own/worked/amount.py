"""Numbers of a text, with their units, as worked examples write them."""

from collections.abc import Iterable
from fractions import Fraction
from functools import cache, lru_cache

from codegen.frozen import dataclass
from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import NUMBER, Unit, ratio, unit_named
from codegen.pattern import pattern

_AMOUNT = pattern(
    r"(?<![\w.^/#])(?<!\w-)(?<!\w\[)(?P<number>[-\u2212]?(?:0[xX][0-9a-fA-F]{1,16}|(?:2|10)\^\d{1,2}"
    r"|\d{1,3}(?:,\d{3}){1,4}(?![\d,])|\d{1,18}(?:\.\d{1,15})?))(?![\d^]|\.\d)"
)
_UNIT = pattern(r"(?P<gap>[ \u00a0]?)(?P<unit>%|[A-Za-z\u00b5\u00b0][A-Za-z\u00b0]{0,11}(?:/[A-Za-z]{1,4})?)(?![\w(])")
_NO_AMOUNT = pattern(r"(?:MAVLink|RFC|[Cc]riteri(?:on|a)|[Pp]ages?|[Vv]ersion|[Rr]ow|[Tt]able|[Ff]igure) $")
_BYTES = unit_named("bytes")
_MORE = {
    "byte": _BYTES,
    "KB": Unit("KB", _BYTES.dimension, _BYTES.scale * 1024),
    "days": Unit("days", unit_named("s").dimension, Fraction(86400)),
    "day": Unit("day", unit_named("s").dimension, Fraction(86400)),
}
"""Units that documents write and no field has."""


@dataclass(frozen=True, slots=True)
class Amount:
    """``value`` of ``unit`` (a pure number without one), ``written`` from ``start`` on with ``places`` decimals.

    ``end`` is behind the unit.
    """

    start: int
    end: int
    written: str
    value: Fraction
    places: int
    unit: Unit

    @property
    def is_plain(self) -> bool:
        """Return whether the amount has no unit."""
        return self.unit == NUMBER

    @property
    def last(self) -> Fraction:
        """One more at the last digit that is written."""
        return Fraction(1, 10) ** self.places

    def like(self, unit: Unit) -> bool:
        """Return whether the amount has the dimension of ``unit``."""
        return not self.is_plain and self.unit.dimension == unit.dimension

    def in_unit(self, unit: Unit) -> Fraction | None:
        """The value in another unit; None across dimensions."""
        factor = ratio(self.unit, unit)
        return None if factor is None else self.value * factor

    def shows(self, exact: Fraction) -> bool:
        """Return whether the number is ``exact``, a value in its unit, rounded to the decimals that are written."""
        return exact == self.value or abs(exact - self.value) <= self.last / 2

    def spelled(self, exact: Fraction) -> str:
        """``exact``, a value in its unit, as it should be written."""
        text = str(int(exact)) if exact.denominator == 1 and not self.places else f"{float(exact):.{self.places}f}"
        return f"{text} {self.unit.name}".strip()


@lru_cache(maxsize=4096)
def amounts(text: str, start: int = 0, end: int | None = None) -> tuple[Amount, ...]:
    """The numbers of a part of ``text``, in order; not those in names, ids and references."""
    found = []
    for each in _AMOUNT.finditer(text, start, len(text) if end is None else end):
        if _NO_AMOUNT.search(text, max(start, each.start() - 12), each.start()):
            continue
        unit = _UNIT.match(text, each.end())
        meant = _unit(unit["unit"]) if unit else None
        if meant is None and text[each.end() : each.end() + 1].isalpha():
            continue
        written = each["number"]
        places = len(written.partition(".")[2])
        stop = unit.end() if unit is not None and meant is not None else each.end()
        found.append(Amount(each.start(), stop, written, _number(written), places, meant or NUMBER))
    return tuple(found)


def of_unit(found: Iterable[Amount], unit: Unit) -> tuple[Amount, ...]:
    """Those that measure what ``unit`` does."""
    return tuple(each for each in found if each.like(unit))


@cache
def _unit(written: str) -> Unit | None:
    return _MORE.get(written) or (worded_unit(written) if len(written) > 3 else Unit.parse(written))


def _number(written: str) -> Fraction:
    written = written.replace("\u2212", "-").replace(",", "")
    base, _, power = written.partition("^")
    if power:
        return Fraction(int(base)) ** int(power)
    return Fraction(int(written, 16)) if "x" in written.lower() else Fraction(written)
