"""Values that a project always sends, in the sentences of its documents: "`min_distance` is 20 cm"."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import isfinite

from codegen.claims.parts.sentence import Term
from codegen.claims.parts.span import Span
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, CONDITIONAL, DENIED, MISTAKEN, PAST, PROPOSED, SUPPOSED, is_aside, words
from codegen.claims.rules import as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.scaling.field_units import on_the_wire
from codegen.claims.statements.subjects import about
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField
from codegen.model.system import System
from codegen.model.units.unit import Unit, decimal
from codegen.pattern import pattern

SENT_VALUE = Rule(
    "claim-sent-value",
    "A document says that a field is a number, and the table of the project always sends another one. Correct the one "
    "that is out of date.",
    remedy="write the number that the table sends, or correct the table",
)

_END = r"(?=[.;)](?:\s|$)|,\s|$| and F\b)"
_IS = pattern(
    r"(?P<name>F)(?: (?:of|in) (?:the )?M)?"
    rf"(?: (?:is|shall be|must be)(?: (?:always|fixed|constant|set to|sent as))?|:| =) (?P<value>[QN]){_END}"
)
_AND = pattern(rf"(?<=[QN] and )(?P<name>F) (?P<value>[QN]){_END}")
_RULED_OUT = words(
    DENIED, PAST, PROPOSED, ASKED, SUPPOSED, CONDITIONAL, MISTAKEN, r"\bexample", r"\be\.g\b", r"\breceiv"
)
_DECIMALS = pattern(r"\.(\d{1,9})")
_EXAMPLE = pattern(r"(?i)\bexamples?\b")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every number that a sentence or an item gives a field of which the tables of the project always send one."""
    systems = reading.reference.systems
    is_example = False
    for span in spans(reading) if systems else ():
        if span.kind is PassageKind.HEADING:
            is_example = _EXAMPLE.search(span.text) is not None
        elif not span.is_code and not span.language and span.kind is not PassageKind.ROW and not is_example:
            yield from _span(reading, span, systems)


def _span(reading: Reading, span: Span, systems: Sequence[System]) -> Iterator[Diagnostic]:
    for found in (each for form in (_IS, _AND) for each in form.finditer(span.text)):
        low, high = span.bounds(found.start())
        sentence = span.text[low:high]
        one = about(reading, span, found.start("name"))
        if one is None or _RULED_OUT.search(span.text, low, high) or is_aside(sentence):
            continue
        own = _sent(one.message.name, one.field, systems)
        term = span.sentence.term(found.start("value"))
        stated = _stated(term, one.field)
        if not own or stated is None or any(abs(stated[0] - each) <= stated[1] for each in own):
            continue
        units = f" {one.field.unit_text}" if one.field.unit_text else ""
        text = f"{one.name} is always {' or '.join(decimal(each) for each in own)}{units}, not {term.written}"
        rule = as_sure(SENT_VALUE, is_sure=one.is_sure and not one.others)
        yield reading.found(rule, span.place(found.start("value")), f"{one.name} {term.written}", text)


def _sent(message: str, field: WireField, systems: Sequence[System]) -> list[Fraction]:
    """Return the numbers on the wire that the tables of a message always send in a field; none if one varies."""
    found: list[Fraction] = []
    for table in (table for system in systems for table in system.tables(message)):
        answers = [each for each in table.answers if each.covers.field.name == field.name]
        values = [value for each in answers for value in (each.always or ("",))]
        if field.is_array or len(values) != 1 or isinstance(values[0], str) or not isfinite(values[0]):
            return []
        found.append(Fraction(values[0]))
    return list(dict.fromkeys(found))


def _stated(term: Term, field: WireField) -> tuple[Fraction, Fraction] | None:
    """Return the number on the wire that a term states for a field, and by how much it may be rounded.

    None where its unit is none of the field's.
    """
    digits = _DECIMALS.search(term.written)
    step = Fraction(1, 10 ** len(digits[1])) if digits is not None else Fraction(0)
    own = Unit.parse(field.definition.units)
    if isinstance(term.value, tuple):
        amount, unit = term.value
        if not isinstance(unit, Unit) or not isinstance(amount, int | Fraction) or own is None:
            return None
        stated, beside = (on_the_wire(field, Fraction(amount) + each, unit, own) for each in (0, step))
        return None if stated is None or beside is None else (stated, abs(beside - stated) / 2)
    value = number(term)
    is_plain = isinstance(value, int | Fraction) or (isinstance(value, float) and isfinite(value))
    return (Fraction(value), step / 2) if value is not None and is_plain and field.multiplier == 1 else None
