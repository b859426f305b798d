"""Amounts beside the numbers that stand for them on the wire: "12.6 V is sent as 12600", "`alt` = 1500 means 1.5 m"."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, DENIED, MISTAKEN, OWN, PAST, PROPOSED, REPLACED, words
from codegen.claims.rules import SCALING, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.quantities import measuring
from codegen.claims.statements.scaling.field_units import on_the_wire
from codegen.claims.statements.subjects import About, about, subjects
from codegen.claims.unknown_value import unknown_values
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.literals import same_number
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_LINKS = frozenset((
    "is", "are", "sent", "send", "sends", "as", "in", "of", "on", "the", "wire", "for", "means", "meaning", "mean",
    "becomes", "become", "a", "an", "stands", "stand", "encoded", "encode", "coded", "if", "reads", "read", "that",
    "to", "put", "write", "written", "into", "with", "goes", "go", "out", "equals", "equal", "so", "value", "values",
    "gives", "give", "corresponds", "then", "field", "number", "raw", "has", "have", "shows", "represented",
    "reported", "received", "transmitted", "be", "must", "will", "it", "which", "and", "comes", "arrives", "appears",
    "there", "i", "e", "ie", "eg", "exactly", "by", "this", "say", "integer", "holds", "hold", "carries", "carry",
    "x", "would", "should", "sensor", "transmitter", "then", "with",
    "count", "counts", "payload", "message", "stored", "found", "set", "use", "fill", "produces",
    "produce", "carried", "display", "when", "results", "reading",
    "yields", "turns", "nothing", "than", "from", "therefore", "thus", "hence", "visible", "seen", "up", "turned",
))  # fmt: skip
_NOUNS = pattern(r"\b(?:height|altitude|speed|current|temperature|angle|heading|pressure|distance|humidity)\b")
_COMPARED = pattern(
    r"(?:\b(?:above|below|over|under|than|least|most|within|until|after|before|about|roughly|between|beyond|to|every"
    r"|near|nearly|around|up to|from|by|per|each|and|or)|[<>~\u00b1+*/x\u00d7-]|\.\.|N[UM]?) ?$"
)
_BEHIND = pattern(
    r" ?(?:[-+*/\u00d7]|bits?\b|and Q|, Q|\.\.|to N|bytes?\b|octets?\b|times\b|hz\b|or (?:more|less)|%|\u00b1|and N"
    r"|U\b)"
)
_INTERVAL = "interval"
_FAR = 70


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every amount with one number that is tied to it."""
    for at, term in span.sentence.within(0, len(span.text), "Q"):
        value = term.value
        if isinstance(value, tuple) and isinstance(value[1], Unit) and value[0]:  # none is none in all units
            yield from _amount(reading, span, at, value[0], value[1])
    yield from _intervals(reading, span)


_INTERVAL_IS = pattern(
    r"(?P<name>F)(?: (?:of|in) M)?(?: (?:will|then|has|to|must|should|be|is|reads?|=|shows?|carries|holds?"
    r"|field))* ?(?:=|:)? ?(?P<value>N)"
    r"(?=\s*(?:[.,;)]|$|us\b|U))"
)


def _intervals(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "At 5 Hz `interval_us` is 200000", with other words between."""
    for found in _INTERVAL_IS.finditer(span.text):
        low, high = _bounds(span, found.start())
        rates = [term.value for _, term in span.sentence.within(low, high, "Q")]
        hertz = [
            each for each in rates if isinstance(each, tuple) and isinstance(each[1], Unit) and each[1].name == "Hz"
        ]
        one, value = about(reading, span, found.start("name")), number(span.sentence.term(found.start("value")))
        if one is None or len(hertz) != 1 or _INTERVAL not in one.field.name or not hertz[0][0]:
            continue
        own = _in_own(one.field, hertz[0][0], hertz[0][1])
        if own is None or value is None or isinstance(value, float) or abs(own - value) <= own / 100 or value <= 0:
            continue
        written = span.sentence.term(found.start("value")).written
        text = f"{float(hertz[0][0]):g} Hz is {float(own):.10g} in {one.name} ({one.field.unit_text}), not {written}"
        rule = as_sure(SCALING, is_sure=one.is_sure)
        yield reading.found(rule, span.place(found.start("value")), f"{one.name} {written} for {hertz[0][0]} Hz", text)


def _amount(reading: Reading, span: Span, at: int, amount: Fraction, unit: Unit) -> Iterator[Diagnostic]:
    text = span.text
    low, high = _bounds(span, at)
    if _RULED_OUT.search(text, low, min(at + _BEHIND_AMOUNT, len(text))):
        return
    for offset, term in span.sentence.within(low, high, "N"):
        start, end = sorted((at, offset))
        value = number(term)
        if value is None or isinstance(value, float) or not _is_together(span, low, start, end):
            continue
        if _COMPARED.search(text[low:offset].removesuffix("(")) and not text[low:offset].rstrip().endswith(" to"):
            continue
        if _BEHIND.match(text, offset + 1) or _is_parameter(text, low, offset):
            continue
        one = _field(reading, span, (start, end), (low, high), unit)
        if one is None and at < offset and _SENT_AS.fullmatch(text, start + 1, end):
            one = _unnamed(reading, span, (low, high), unit)
        if value < 0 < amount and _AGAINST.match(text, at + 1):
            value = -value
        if one is None or _is_right(one, value, amount, unit, span.sentence.term(at).written):
            continue
        own = _in_own(one.field, amount, unit)
        if (
            own is None
            or _is_taken(one.field, own)
            or _is_taken(one.field, Fraction(value))
            or _are_ends(span, (start, end), (low, high), amount, own)
        ):
            continue
        written = span.sentence.term(at).written
        stated = f"{one.name} {term.written} for {written}"
        what = f"{written} is {float(own):.10g} in {one.name} ({one.field.unit_text}), not {term.written}"
        yield reading.found(as_sure(SCALING, is_sure=one.is_sure), span.place(offset), stated, what)
        return


_RANGE = pattern(r"N (?:up )?to ")
_EXAMPLE = pattern(r"(?: [a-z]+){0,4}: F = ")
"""Between an amount with its circumstances and its field: "12.5 m/s to the north: `vx` = 1250"."""
_SENT_AS = pattern(
    r" ?(?:(?:is|are|would be|gets|has to be|must be|then|thus|therefore) )*(?:sent|coded|encoded|transmitted|written"
    r"|stored"
    r"|packed|comes?|comes out|goes out|goes|arrives?|travels?|appears?|represented|reported) (?:as|like"
    r"|in the form of)"
    r" (?:an?|the)? ?(?:value |number |integer )*"
    r"| (?:reads?|shows up as|turns up as|is visible as|is seen as) (?:an? |the )?"
)
"""Between an amount and its number, where no field is named."""


def _unnamed(reading: Reading, span: Span, bounds: tuple[int, int], unit: Unit) -> About | None:
    """The fields that an amount without a name may be one of: those of the message that measure the same."""
    if any(span.sentence.within(*bounds, "FC")):
        return None
    messages, is_sure = subjects(reading, span, bounds[0])
    fields = [field for field in measuring(messages[:1], unit) if field.type.is_integer]
    if not fields or not is_sure:
        return None
    text = span.source_text(max(bounds[0] - _FAR, 0), bounds[1]).lower()
    fields.sort(key=lambda field: not any(len(word) > 2 and word in text for word in field.name.lower().split("_")))
    return About(messages[0], fields[0], tuple(fields[1:]), is_sure=False)


_RULED_OUT = words(
    DENIED[:2], REPLACED[:1], PAST, OWN[:2], MISTAKEN, PROPOSED, ASKED,
    r"\bdivid", r"\bmultipl", r"\blimit", r"\bthreshold", r"\bresolution\b", r"\bsteps?\b", r"\baccura", r"\btoleran",
    r"\bfactor\b", r"\bwarn", r"\balarm",
)  # fmt: skip
_AGAINST = pattern(
    r"[ ,]*(?:[a-z]+ ){0,3}(?:south|west|down|below|beneath|under|left|back|behind|aft|astern|port|revers|charg|descen"
    r"|sink|brak|lower)"
)
"""Behind an amount whose sign is told in words: "15.23 m to the south" is negative."""
_BEHIND_AMOUNT = 60
"""The number of characters behind an amount in which a word can still rule it out as a statement."""


def _bounds(span: Span, at: int) -> tuple[int, int]:
    """The sentence around an amount; the whole of an item, a row or a line."""
    if span.kind is PassageKind.ROW or span.is_code:
        return 0, len(span.text)
    return span.bounds(at)


_PARAMETER = pattern(r"\b(?:param\w*|ids?|messages?|msg|command|section|version|channel|index|no|item|row) ?$|# ?$")


def _is_parameter(text: str, low: int, offset: int) -> bool:
    """Return whether a number is the number of a parameter of a command, an id or the like."""
    return _PARAMETER.search(text[low:offset]) is not None


def _is_together(span: Span, low: int, start: int, end: int) -> bool:
    """Return whether an amount and a number belong together, and the amount is not the first side of a mapping."""
    if end - start > _FAR or (span.kind is PassageKind.ROW and not any(span.sentence.within(low, start, "FP"))):
        return False
    return _is_tied(span, start, end) or _EXAMPLE.fullmatch(span.text, start + 1, end) is not None


def _are_ends(span: Span, ends: tuple[int, int], bounds: tuple[int, int], amount: Fraction, own: Fraction) -> bool:
    """Return whether a number and an amount are the ends of a range: "2 to 100 %" of what is in percent, or "0 to 10000
    means 0 to 100 %".
    """
    if _RANGE.fullmatch(span.text, *ends) is None:
        return False
    return own == amount or any(number(term) == own for _, term in span.sentence.within(*bounds, "N"))


def _is_tied(span: Span, start: int, end: int) -> bool:
    """Return whether only words that tie an amount to its number stand between them."""
    gap = span.text[start + 1 : end]
    if span.kind is PassageKind.ROW and pattern(r"\s*\|\s*").fullmatch(gap):
        return span.text.count("N") == 1 and span.text.count("Q") == 1
    if pattern(r"[QNUSTVC;|]|\.\s").search(gap):
        return False
    if gap == " (":
        return pattern(r"[:=] $").search(span.text[:start]) is not None and span.text[end + 1 : end + 2] == ")"
    names = pattern(r"[a-z]+").findall(_NOUNS.sub("", gap))
    return all(word in _LINKS for word in names) and pattern(r"[a-z=:\u2192#/*]|->|, ").search(gap) is not None


def _field(reading: Reading, span: Span, inner: tuple[int, int], outer: tuple[int, int], unit: Unit) -> About | None:
    """The field that an amount and its number are about: between them, behind them, or before them."""
    start, end = inner
    low, high = outer
    between = [at for at, _ in span.sentence.within(start, end, "FP")]
    behind = [at for at, _ in span.sentence.within(end, high, "F")]
    before = [at for at, _ in span.sentence.within(low, start, "FP")][::-1]
    tied = [at for at in behind[:1] if not pattern(r"[;Q]|, (?!in )|\band\b").search(span.text[end + 1 : at])]
    for at in (*between[:1], *tied, *(before[:1] if not between and not tied else ())):
        one = about(reading, span, at)
        if one is not None and _in_own(one.field, Fraction(1), unit) is not None:
            return one
    return None


def _in_own(field: WireField, amount: Fraction, unit: Unit) -> Fraction | None:
    """The number on the wire of an amount; None where the unit is not one of the field's."""
    own = Unit.parse(field.definition.units)
    if own is None or not field.type.is_integer or not unit.dimension:
        return None
    if _INTERVAL in field.name and unit.dimension == (("s", -1),) and own.dimension == (("s", 1),) and amount:
        return 1 / (amount * unit.scale) / own.scale
    return on_the_wire(field, amount, unit, own)


def _is_taken(field: WireField, value: Fraction) -> bool:
    """Return whether a number stands for unknown in a field, so that another one is sent for its amount."""
    known = unknown_values(field)
    return known is not None and any(same_number(float(value), each) for each in known[0])


_ROUNDED = 100
"""An amount of so many digits may be rounded to the last of them."""


def _is_right(one: About, value: int | Fraction, amount: Fraction, unit: Unit, written: str) -> bool:
    """Return whether a number is an amount, as exactly as it is written, in the unit of any field that may be meant."""
    places = len(pattern(r"[^\d]").split(written.partition(".")[2])[0]) if "." in written else 0
    for field in (one.field, *one.others):
        own, next_one = _in_own(field, amount, unit), _in_own(field, amount + Fraction(1, 10**places), unit)
        if own is None or next_one is None:
            return True
        is_rounded = places or own % 1 or amount >= _ROUNDED
        if abs(own - value) <= max(abs(next_one - own) / 2 if is_rounded else Fraction(1, 2), Fraction(1, 2)):
            return True
    return False
