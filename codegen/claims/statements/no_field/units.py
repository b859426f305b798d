"""Units that no field of a message has, though some of them measure the same."""

import re
from collections.abc import Iterator

from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import (
    ASKED,
    CHANGED,
    COMPARED,
    CONVERTED,
    DENIED,
    MISTAKEN,
    OWN,
    PAST,
    REPLACED,
    SHOWN,
    SUPPOSED,
    words,
)
from codegen.claims.rules import UNIT, as_sure
from codegen.claims.statements.no_field.messages import meant
from codegen.claims.statements.scaling.field_units import described_units, is_same_unit, of_field
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_NOT = words(
    ASKED, CHANGED, COMPARED, CONVERTED, DENIED, MISTAKEN, OWN, PAST, REPLACED, SHOWN, SUPPOSED,
    r"\bfrom U", r"\bto U", r"\bfor U", r"\bsensor|\bdriver|\bchip\b|\breceiver\b|\bdevice\b", r"\binput\b",
    r"\boutput", r"\bget\b", r"\bturns?\b", r"\bmakes?\b", r"\bgives?\b", r"\btake", r"\bneeds?\b",
    r"\bsteps?\b", r"\btimes\b", r"[*/] ?N", r"N ?[*/]", r"\bcompute", r"\bcalc", r"\bfactor\b", r"\bapp\b",
    r"\berror", r"\bresolution\b", r"\bpublish", r"\bread as\b", r"\bhad been\b", r"\bstyle\b", r"\bnew\b",
    r"\bhowever\b", r"\bkept\b", r"\bkeep", r"\bthe others?\b",
)  # fmt: skip
_BEFORE = pattern(
    r"(?:\b(?:in|is|are|as|has|have|uses?|carries|counts?|unit:?|units?(?: is| are)?|both|all)"
    r"(?: (?:whole|plain|full))?|[(|:,]|T)\s*$"
)
_BEHIND = pattern(r"\s*(?:[,.;:)|]|\*/|$|(?:and|or|in|of|per|from|above|below|relative|to)\b)")
_LEAD = 30
"""Characters before a unit that have to say it of something."""
_COUNTED = ("bytes", "bits")
"""Units that sizes of all kinds are told in."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every unit of a part that is said of something in a message."""
    if span.kind is PassageKind.HEADING or is_data(span) or (span.is_code and not span.is_comment):
        return
    for offset, term in span.sentence.within(0, len(span.text), "U"):
        unit = term.value
        if not isinstance(unit, Unit) or not unit.dimension or unit.name in _COUNTED or not _is_said(span, offset):
            continue
        messages = meant(reading, span, offset)
        if any(_may_have(message, unit) for message in messages):
            continue
        message = next((each for each in messages if _alike(each, unit)), None)
        if message is not None:
            units = ", ".join(f"{each.name} is in {each.definition.units}" for each in _alike(message, unit))
            claim, text = f"{message.name} in {term.written}", f"no field of {message.name} is in {term.written}"
            yield reading.found(as_sure(UNIT, is_sure=False), span.place(offset), claim, f"{text}: {units}")


def _is_said(span: Span, offset: int) -> bool:
    """Return whether the words around a unit say that something is in it."""
    low, high = (0, len(span.text)) if span.kind is PassageKind.ROW else span.bounds(offset)
    if any(span.sentence.within(low, offset, "F")):
        return False  # what is said of a field is compared with that
    if _NOT.search(span.text, low, high) or not _BEHIND.match(span.text, offset + 1):
        return False
    return _BEFORE.search(span.text[max(low, offset - _LEAD) : offset]) is not None


def _may_have(message: WireMessage, unit: Unit) -> bool:
    """Return whether a field of a message has a unit, or may have it by what is written about it."""
    for field in message.fields:
        own, stated = Unit.parse(field.definition.units), of_field(unit, field)
        if any(each.dimension == unit.dimension for each in described_units(field)):
            return True
        if own is None:
            if unit.name and re.search(rf"\b{re.escape(unit.name)}\b", field.definition.description):
                return True
        elif is_same_unit(own, stated) or (field.multiplier != 1 and own.dimension == stated.dimension):
            return True
    return False


def _alike(message: WireMessage, unit: Unit) -> list[WireField]:
    """Return the fields of a message that measure the same as a unit."""
    known = ((field, Unit.parse(field.definition.units)) for field in message.fields)
    return [field for field, own in known if own is not None and own.dimension == of_field(unit, field).dimension]
