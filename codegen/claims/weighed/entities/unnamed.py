"""Units, types and values for unknown that no field of a message has, where the words around them name no field."""

from collections.abc import Iterator, Sequence
from fractions import Fraction

from codegen.claims.parts.sentence import StatedType
from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.rules import SENTINEL, TYPE, UNIT
from codegen.claims.statements.scaling.field_units import described_units, has_unit, of_field
from codegen.claims.statements.subjects import subjects
from codegen.claims.statements.types import has_type
from codegen.claims.statements.unknown import is_unknown
from codegen.claims.unknown_value import unknown_values
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import Statement, piece
from codegen.claims.weighed.numbers import ABSENT
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.units.unit import Unit
from codegen.once import once
from codegen.pattern import pattern

_WORD = pattern(r"[a-z]{3,}")
_PLACED = pattern(r"(?:\b(?:in|is|are|as|has|have|unit:?|both|all)|[(|:,]|T) ?$")
_ENDED = pattern(r"\s*(?:[,.;:)|]|\*/|$|(?:and|or|in|per|from|above)\b)")
_COUNTED = ("bytes", "bits", "byte", "bit", "Hz")
_STEM = 4
_NEXT_STATE = pattern(r" ?(?:[*/x%+-]|hz\b|bytes?\b|times\b|to N|\.\.|U)")


def unnamed(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield what is said of a message that none of its fields has, and what some field of it has."""
    if span.kind is PassageKind.HEADING or is_data(span) or (span.is_code and not span.is_comment):
        return
    for at, term in span.sentence.within(0, len(span.text), "UTNS"):
        low, high = piece(span, at)
        if any(span.sentence.within(low, at if term.letter in "UT" else high, "F")):
            continue
        if term.letter in "NS" and not ABSENT.search(span.text, low, high):
            continue
        messages, is_sure = subjects(reading, span, at)
        for message in messages[:1]:
            yield from _of_message(span, at, (low, high), message, messages[1:], is_sure=is_sure)


def _of_message(
    span: Span, at: int, bounds: tuple[int, int], message: WireMessage, others: Sequence[WireMessage], *, is_sure: bool
) -> Iterator[Statement]:
    low, high = bounds
    term = span.sentence.term(at)
    kind, fields, is_right = _alike(message, term.letter, term.value)
    if not fields or message.id < 0:
        return
    if is_right:
        yield Statement(f"{kind} of none", UNIT, span, at, low, high, message.name, "", is_right, group=message.name)
        return
    words = frozenset(word[:_STEM] for word in _WORD.findall(span.text[low:high]))
    overlaps = sorted(fields, key=lambda field: -len(words & _stems(field)))
    first = overlaps[0]
    common = len(words & _stems(first))
    shown = {"unit": "in", "type": "of the type", "sentinel": "unknown at"}[kind]
    text = f"no field of {message.name} is {shown} {term.written}: {first.name} is {shown} {_own(first, kind)}"
    rule = {"unit": UNIT, "type": TYPE, "sentinel": SENTINEL}[kind]
    named = [name for _, name in span.named(low, high)]
    found = traits(
        sure=is_sure,
        message_here=message.name in named,
        several_here=len(set(named)) > 1,
        of_another=any(_alike(other, term.letter, term.value)[2] for other in others),
        word_of_field=any(part in span.text[low:high] for part in first.name.lower().split("_") if len(part) > _STEM),
        words_of_description=common > 1,
        no_word_in_common=common == 0,
        one_field=len(fields) == 1,
        few_fields=len(fields) <= 3,
        one_unit=len({field.definition.units for field in fields}) == 1,
        placed=_PLACED.search(span.text, max(low, at - 14), at),
        ended=_ENDED.match(span.text, at + 1),
        everyday_name=any(span.sentence.within(low, high, "P")),
        something_named=any(span.sentence.within(low, high, "CVE")),
        first=not _WORD.search(span.text, low, at),
        number_near=any(span.sentence.within(at - 12, at + 12, "NQ")),
    )
    yield Statement(
        f"{kind} of none", rule, span, at, low, high, message.name, first.name, is_right, text, message.name, found
    )


def _alike(message: WireMessage, letter: str, value: object) -> tuple[str, list[WireField], bool]:
    """Return of what kind a term is, the fields that have such a thing, and whether one has the same."""
    if letter == "U" and isinstance(value, Unit) and value.dimension and value.name not in _COUNTED:
        alike = [field for field, own in _units(message) if own.dimension == of_field(value, field).dimension]
        told = any(each.dimension == value.dimension for field in message.fields for each in described_units(field))
        return "unit", alike, told or any(has_unit(field, value) for field in alike)
    if letter == "T" and isinstance(value, StatedType) and value.name is not None:
        same = [field for field in message.fields if _is_near_type(field, value)]
        return "type", same, any(has_type(field, value) for field in message.fields)
    if letter in "NS" and isinstance(value, int | float | Fraction):
        known = _with_unknown(message)
        return "sentinel", known, any(is_unknown(field, float(value)) for field in known)
    return "unit", [], True


@once
def _with_unknown(message: WireMessage) -> list[WireField]:
    """The fields of a message that have a value for unknown."""
    return [field for field in message.fields if unknown_values(field) is not None]


def _is_near_type(field: WireField, stated: StatedType) -> bool:
    """Return whether a field has a type of another sign or size than a stated one, but of its sort."""
    is_float = field.type.name in ("float", "double")
    return is_float == (stated.sign == "f") and (stated.length is None or field.is_array)


def _own(field: WireField, kind: str) -> str:
    known = unknown_values(field)
    return str({"unit": field.definition.units, "type": field.type.name, "sentinel": known[1] if known else ""}[kind])


@once
def _units(message: WireMessage) -> tuple[tuple[WireField, Unit], ...]:
    pairs = ((field, Unit.parse(field.definition.units)) for field in message.fields)
    return tuple((field, own) for field, own in pairs if own is not None)


@once
def _stems(field: WireField) -> frozenset[str]:
    """The beginnings of the words of a field's name and description."""
    text = f"{field.name} {field.definition.description}".lower().replace("_", " ")
    return frozenset(word[:_STEM] for word in _WORD.findall(text)) - _IDLE


_IDLE = frozenset(
    (
        "the",
        "and",
        "for",
        "this",
        "that",
        "from",
        "with",
        "fiel",
        "valu",
        "not",
        "unkn",
        "are",
        "has",
        "unit",
        "mess",
        "send",
        "sent",
        "vehi",
        "any",
        "all",
        "one",
        "its",
        "when",
        "syst",
        "curr",
        "mavl",
        "set",
    )
)
