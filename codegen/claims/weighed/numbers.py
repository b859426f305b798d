"""Numbers in the reach of a field's name: elements, values for unknown, factors, values of an enum."""

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.reading import Reading
from codegen.claims.rules import SCALING, SENTINEL, TYPE
from codegen.claims.statements.fields import number
from codegen.claims.statements.scaling.factors import has_scale
from codegen.claims.statements.scaling.field_units import described_units, shown_units
from codegen.claims.statements.unknown import is_unknown
from codegen.claims.unknown_value import unknown_values
from codegen.claims.weighed.clauses import clause
from codegen.claims.weighed.comparison import Comparison, traits
from codegen.claims.weighed.encoded import of_encoded
from codegen.claims.weighed.entries import of_entry
from codegen.claims.weighed.limits import of_limit
from codegen.claims.weighed.pairs import Pair, is_line
from codegen.claims.weighed.places import of_place
from codegen.claims.weighed.specials import of_special
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

Number = int | float | Fraction

_NOUN = pattern(
    r" (?P<noun>elements?|entries|values|items|slots|characters?|chars|letters|cells|places|samples|points|floats"
    r"|bytes?|octets?|distances|bins|sectors|channels|cores|doubles|components|numbers|more cells)\b"
)
_MUST_NOT = pattern(r"\b(?:never|do not|don't|must not|should not)\b[a-zFPM ]{0,30}[=:]* ?$")
_ROW_BEGINS = pattern(r"[\s|]*")
_COLUMN_ENDS = pattern(r"\s*\|")


def of_number(reading: Reading, pair: Pair) -> Iterator[Comparison]:
    """Yield what a number says of a field."""
    value = number(pair.term)
    if value is None or _is_none(pair):
        return
    counted = _NOUN.match(pair.span.text, pair.at + 1)
    if counted is not None and pair.term.letter == "N" and value > 1:
        yield from _length(pair, value, counted["noun"])
    if counted is None:
        yield from _sentinel(pair, value)
        yield from of_special(pair, value)
    if pair.term.letter == "N" and value >= _LEAST and str(value).strip("0") == "1":
        yield from _factor(pair, value)
    if pair.term.letter == "N" and value == int(value) and pair.one.field.definition.enum:
        yield from of_entry(reading, pair, int(value))
    if pair.term.letter == "N":
        yield from of_limit(pair)
        yield from of_encoded(pair)
        yield from of_place(pair)


_LEAST = 10
"""The least power of ten that is a factor."""


def _is_none(pair: Pair) -> bool:
    """Return whether a number is part of a name, the number of a row, or what must not be sent."""
    text, at = pair.span.text, pair.at
    if at > 1 and text[at - 1] in "-." and text[at - 2].isalnum():
        return True
    if pair.span.kind is PassageKind.ROW and _ROW_BEGINS.fullmatch(text, 0, at) and _COLUMN_ENDS.match(text, at + 1):
        return True
    return _MUST_NOT.search(pair.before(50)) is not None


_UP_TO = pattern(r"(?:up to|at most|exactly|all|of|has|have|room for|longer than|exceed the|\() ?$")
_OF_MESSAGE = pattern(r"\b(?:payload|message|frame|packet|header|total)\b|M")
_LESS = pattern(
    r"\b(?:first|last|lower|upper|only|some|least|more|less|fewer|about|other|remaining|own|our|often|used|uses"
    r"|not|never|usually)\b"
)


_REST = pattern(r"\b(?:others?|rest|remaining|remainder)\b|\bare used\b")
"""Behind elements that are used, and not all that there are."""
_MORE_THAN = pattern(r"\b(?:below|above|over|under|than|least|about|only) $")


def _length(pair: Pair, value: Number, noun: str) -> Iterator[Comparison]:
    """A number of elements of an array, or of bytes of any field."""
    field, is_bytes = pair.one.field, noun.startswith(("byte", "octet"))
    is_text = noun.startswith(("char", "letter"))
    if (not field.is_array and not is_bytes) or _REST.search(pair.span.text, pair.at, pair.at + 60):
        return

    def fits(one: WireField) -> bool:
        is_text_without_end = is_text and one.type.name == "char" and value == one.count - 1
        return value == one.count or is_text_without_end or (is_bytes and value in (one.size, one.type.size))

    if any(fits(each) for each in pair.fields):
        yield Comparison("length", TYPE, is_right=True)
        return
    own = f"{field.size} bytes" if is_bytes else f"{field.count} elements"
    near = [number(term) for _, term in pair.span.sentence.within(pair.low, pair.high, "N")]
    found = traits(
        bytes=is_bytes,
        characters=is_text,
        array=field.is_array,
        text=field.type.name == "char",
        fewer=value < field.count,
        up_to=_UP_TO.search(pair.before(16)),
        of_message=_OF_MESSAGE.search(pair.before(30)),
        part_of_it=_LESS.search(pair.gap),
        own_length=field.count in near,
        more_than=_MORE_THAN.search(pair.before(24)),
    )
    text = f"{pair.one.name} has {own}, not {pair.term.written}"
    yield Comparison("length", TYPE, is_right=False, text=text, traits=found)


ABSENT = pattern(
    r"\b(?:unknown|unavailable|invalid|undefined|absent|missing|unset|unspecified|unused|empty|nothing|none|nobody"
    r"|without|no|not|never|cannot|lacks?|lost|fail\w*|sentinel|ignor\w*|disabled?|n/a|nor|unmeasured|until|unchanged"
    r"|alone)\b|n't\b"
)
"""Any word that denies something, or says that it is not there."""
_CLEAR = pattern(
    r"\b(?:unknown|unavailable|invalid|unset|sentinel|no data|n't know"
    r"|not (?:known|available|measured|valid|provided|configured|set|used|present|fitted))\b"
)
_NO_VALUE = pattern(r"(?: ?(?:[-+*/%]|\.\.|to N)|\.\d)")
_NO_VALUE_BEFORE = pattern(
    r"(?:[<>*/+]|\.\.|N to|\bparam|\bbit|\bversion|#|\bid) ?$|\b(?:in|at|into|from) (?!value)[a-z]{3,} $"
)
_GIVEN = pattern(r"(?:=|is|send|sends|sent as|set to|use|write|as|to|==|with|of|be|reports?) ?$")
_THEN = pattern(r" ?(?:if|when|for|means|=|where|without|stands|marks|\()")
_COMPARED = pattern(r"(?:==|!=|===) ?$")
_NOT_IT = pattern(
    r"\b(?:never|do not|don't|must not|should not|rather than|instead of|other than|not)\b[a-zFPM ]{0,25}[=:]* ?$"
)
_LIMITS = frozenset((-1, 127, 255, 32767, 65535, 2147483647, 4294967295, -32768, -128))
"""Numbers at which types end, and -1."""
_AROUND = 200
_MANY = 2


def _sentinel(pair: Pair, value: Number) -> Iterator[Comparison]:
    """A value in a sentence with any word of absence, of a field that has one for unknown."""
    known = unknown_values(pair.one.field)
    if known is None or not ABSENT.search(pair.sentence):
        return
    if _NO_VALUE.match(pair.behind(16)) or _NO_VALUE_BEFORE.search(pair.before(16)):
        return
    if _is_unknown(pair, value):
        yield Comparison("sentinel", SENTINEL, is_right=True)
        return
    text = f"{pair.one.name} is unknown when it is {known[1]}, not {pair.term.written}"
    yield Comparison("sentinel", SENTINEL, is_right=False, text=text, traits=_of_sentinel(pair, value, known[1]))


def _of_sentinel(pair: Pair, value: Number, known: str) -> tuple[str, ...]:
    low, high = clause(pair.span.text, pair.at, pair.low, pair.high)
    here, is_name = pair.span.text[low:high], pair.term.letter == "S"
    others = [found for _, found in _numbers(pair, pair.low, pair.high)]
    around = [found for _, found in _numbers(pair, max(pair.at - _AROUND, 0), pair.at + _AROUND)]
    of_type = pair.one.field
    return traits(
        own_value=any(_is_unknown(pair, other) for other in others),
        own_value_around=any(_is_unknown(pair, other) for other in around),
        own_value_named=known.lower() in pair.sentence,
        other_numbers=others,
        many_numbers=len(others) > _MANY,
        limit=is_name or value in _LIMITS,
        zero=value == 0,
        named=is_name,
        enum=of_type.definition.enum,
        told_by_attribute=of_type.sentinel is not None,
        zero_is_unknown=any(0 in (unknown_values(each) or ([], ""))[0] for each in pair.fields),
        absent_in_clause=ABSENT.search(here),
        clear_in_clause=_CLEAR.search(here),
        clear=_CLEAR.search(pair.sentence),
        given=_GIVEN.search(pair.before(16)),
        then=_THEN.match(pair.behind(12)),
        element=pair.before(1) == "[",
        tested=_COMPARED.search(pair.before(16)),
        not_it=_NOT_IT.search(pair.before(40)),
    )


def _numbers(pair: Pair, low: int, high: int) -> Iterator[tuple[int, Number]]:
    for offset, term in pair.span.sentence.within(low, high, "NS"):
        value = number(term)
        if offset != pair.at and value is not None:
            yield offset, value


def _is_unknown(pair: Pair, value: Number) -> bool:
    return any(map(partial(is_unknown, value=float(value)), pair.fields))


_FACTOR = pattern(
    r"(?:\bdivid\w*(?: it| them)? by|\bmultipl\w*(?: it| them)? (?:by|with)|[*/\u00d7x\u00f7]|\btimes"
    r"|\bfactor(?: of)?|\bscaled? (?:by|with)) ?$"
)
_HAS_SCALE = pattern(r".*E\d|[mcdu](?:deg|degC|m|m/s|V|A|Ah|rad|rad/s|s|%|gauss|Pa|W|T|G)|.*\*\d+")
_ASSIGNED = pattern(r"=[^=]*[a-z]")
"""Between a field and a factor of what it is filled with: in whatever unit that is."""
_UNIT_BEHIND = pattern(r"[^.;]{0,13}U")


def _factor(pair: Pair, value: Number) -> Iterator[Comparison]:
    """A power of ten behind a sign or a word for a factor."""
    found = _FACTOR.search(pair.before(24))
    if found is None or (is_line(pair.span) and _ASSIGNED.search(pair.gap)):
        return
    field, is_right = pair.one.field, any(has_scale(each, value) for each in pair.fields)
    is_scaled = _HAS_SCALE.fullmatch(field.definition.units or "") is not None or bool(described_units(field))
    if is_scaled and is_right:
        yield Comparison("factor", SCALING, is_right=True)
        return
    if not is_scaled and is_right and Unit.parse(field.definition.units) is None:
        return
    shown = f"{found[0].strip()} {pair.term.written}"
    unit = f"is in {shown_units(field)}" if shown_units(field) else "has no unit"
    there = traits(sign=not pattern("[a-z]").search(found[0]), unit_behind=_UNIT_BEHIND.match(pair.behind(14)))
    text = f"{pair.one.name} {unit}, which {shown} does not agree with"
    yield Comparison("factor" if is_scaled else "factor of none", SCALING, is_right=False, text=text, traits=there)
