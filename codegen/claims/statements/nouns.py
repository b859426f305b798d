"""Claims about fields by other words than their names: "its accelerations are in m/s", "a text of 54 characters"."""

import re
from collections.abc import Iterator

from codegen.claims.parts.sentence import StatedType
from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import TYPE, UNIT, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.quantities import quantities
from codegen.claims.statements.scaling.field_units import has_unit
from codegen.claims.statements.scaling.own_units import is_told_behind
from codegen.claims.statements.subjects import subjects
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_IN = pattern(
    r"(?P<noun>(?:[a-zP][a-zP-]{0,24} ){0,3}[a-zP][a-zP-]{1,24})(?: values?| fields?)?(?: (?:is|are|comes?|given"
    r"|reported|measured|sent|stored|all|always|expressed))*(?: in (?:whole |plain )?| (?:is|are) (?:whole |plain "
    r"|an? T (?:in|of) )?"
    r"| whole | as an? T (?:in|of) )U(?=\s*(?:[,.;:)(]|$|(?:and|as|with|or"
    r"|but|from|at|since|relative)\b))"
)
_VERB = pattern(r"\b(?:is|are|comes?|given|reported|measured|sent|stored|expressed|always|all)\b")
_NOT = pattern(
    r"\bnot\b|n't\b|\bwe\b|\bour\b|\bmy\b|\bshow|display|\bplot|\blogs?\b|convert|divid|multipl|\binto\b|\bwas\b"
    r"|\bwere\b|\bwould\b|\bif\b|\bwhen\b|\bapp\b|\bscreen|\bpage\b"
    r"|\bprint|\bstor|round|\bwant|\bneed|\bset\b|\bparam|\bfile\b|\btable\b|\bours\b|\bcsv\b|\binput|\bunlike"
    r"|\bsensor'?s?\b|\bdriver|\bdevice|\bgauge|\byour|\bthey\b|\bwhere everything|\bwrong|\bcolumn|\bdisplayed"
    r"|\bgraph|\bchart|\bsetting|\blimit|\bthreshold|\bkeep|\bask|\bthink|\?"
)
OF_ELSE = pattern(
    r"\b(?:bus|can|gateway|controllers?|adapter|bridge|receivers?|module|protocol|autopilots?|vendors?|sentences?|register|frames?"
    r"|chip|node|logger|radio|api|ros) (?:itself |frames? |bus |only |also )*(?:reports?|sends?|gives?|delivers?"
    r"|uses?|has|have"
    r"|counts?|speaks?|keeps?|prints?|carr(?:y|ies)|comes?)\b"
)
"""Another thing that the sentence is about, and what that does."""
IDLE = frozenset((
    "the", "a", "an", "its", "all", "both", "is", "are", "of", "this", "that", "and", "field", "fields", "value",
    "values", "everything", "to", "for", "from", "here", "whole", "plain",
     "it", "they", "numbers", "number", "data", "given", "in", "with", "every", "each", "as",
    "only", "time", "come", "comes", "sent", "reported", "measured", "stored", "expressed", "always",
))  # fmt: skip
_MOST_WORDS = 3
"""The last words before a unit that can be the name of a field: "the current ground speed"."""
_MANY = 6
"""Messages of a document with which a word for a thing may be one of any of them."""
_TEXT = pattern(
    r"(?P<lead>\b(?:[a-zPF]{1,24} ){0,6})N (?P<what>characters|chars|letters)\b(?! (?:per|a second|each|of"
    r"|in a line|wide))",
    needs="characters|chars|letters",
)
_OF_SEVERAL = pattern(r"N(?:,|,? (?:and|or)) $")
"""Before the last of several lengths, as of texts that somebody has tried: "texts of 1, 50 and 120 characters"."""
_LIMIT = pattern(
    r"\b(?:up to|at most|of|to|at|maximum|max|exactly|has|have|holds?|takes?|are|limited|limit|fits?|only|after|than)\b"
)
_SUBJECT = pattern(r"\b(?:names?|texts?|strings?|labels?|identifiers?|ids?|messages?|field|values?|P|F|length|M)\b")
_ARRAY = pattern(r"\b(?:up to|an? array of|holds?|carries|list of|at most|has|with) T")


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every such statement of a part."""
    if span.kind is PassageKind.ROW or (span.is_code and not span.is_comment):
        return
    yield from _units(reading, span)
    yield from _texts(reading, span)
    yield from _arrays(reading, span)


def _units(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    for found in _IN.finditer(span.text):
        low, high = span.bounds(found.start())
        if (
            _is_note(span, found)
            or _NOT.search(span.text, low, high)
            or "F" in span.text[low : found.start()]
            or OF_ELSE.search(span.text, low, high)
        ):
            continue
        noun = span.source_text(found.start("noun"), found.end("noun")).lower()
        words = [word for word in pattern(r"[a-z]+").findall(noun) if word not in IDLE]
        messages, is_sure = subjects(reading, span, found.start())
        unit = span.sentence.term(found.end() - 1).value
        if not words or not is_sure or not isinstance(unit, Unit):
            continue
        if len(span.topic.document) > _MANY and not any(span.named(0, len(span.text))):
            continue
        fields: list[WireField] = []
        for count in range(min(len(words), _MOST_WORDS), 0, -1):
            words = words[-count:]
            fields = [field for field in messages[0].fields if _is_called(field, words) and _is_kin(field, unit, words)]
            if fields:
                break
        called = [field for message in messages for field in message.fields if _is_called(field, words)]
        if not fields and any(name == messages[0].name for _, name in span.named(0, found.start())):
            fields = called = quantities(messages[:1], words[-1], unit)
        if not fields or any(has_unit(field, unit) for field in called):
            continue
        first = fields[0]
        if is_told_behind(span, found.end() - 1, first):
            continue
        written = span.sentence.term(found.end() - 1).written
        text = f"{messages[0].name}.{first.name} is in {first.definition.units}, not {written}"
        yield reading.found(
            as_sure(UNIT, is_sure=False),
            span.place(found.end() - 1),
            f"{messages[0].name}.{first.name} in {written}",
            text,
        )


def _is_note(span: Span, found: "re.Match[str]") -> bool:
    """Return whether a sentence without a verb notes something of nothing that is named: "Angles in degrees."."""
    is_verbless = _VERB.search(found[0]) is None and span.kind is PassageKind.TEXT
    return is_verbless and not any(span.named(0, found.start()))


def _is_called(field: WireField, words: list[str]) -> bool:
    """Return whether all words occur in the name or in the first sentence of the description of a field."""
    text = field.definition.description.lower().partition(".")[0]
    tokens = pattern(r"[a-z]+").findall(field.name.lower().replace("_", " ")) + pattern(r"[a-z]+").findall(text)
    return all(any(is_like(word, token) for token in tokens) for word in words)


def _is_kin(field: WireField, unit: Unit, words: list[str]) -> bool:
    """Return whether a unit has the dimension of a field's, or all words occur in the field's name."""
    own = Unit.parse(field.definition.units)
    tokens = pattern(r"[a-z]+").findall(field.name.lower().replace("_", " "))
    return own is not None and (
        own.dimension == unit.dimension or all(any(is_like(word, token) for token in tokens) for word in words)
    )


def is_like(word: str, token: str) -> bool:
    """Return whether two words are forms of one."""
    stem = _ENDING.sub("", word)
    return len(word) > 2 and _ENDING.sub("", token) == stem


_ENDING = pattern(r"(?:ies|y|es|e|s)$")


def _texts(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "Names of up to 12 characters" of a message with one field of characters."""
    for found in _TEXT.finditer(span.text):
        low, _high = span.bounds(found.start())
        lead = span.source_text(low, span.text.index("N", found.start())).lower()
        if (
            not _LIMIT.search(lead)
            or _OF_SEVERAL.search(span.text, low, span.text.index("N", found.start()))
            or not _SUBJECT.search(span.text[low : found.end()])
            or re.search(
                r"\bnot\b|n't|\bour\b|\blonger than\b|\bmore than\b|\bfirst\b|\blast\b|\babout\b|\bshorter\b"
                r"|\bscreen|\bline\b|\bdisplay|\bless\b|\bonly\b",
                lead,
            )
        ):
            continue
        messages, is_sure = subjects(reading, span, found.start())
        if len(span.topic.document) > _MANY and not any(span.named(0, len(span.text))):
            continue
        offset = span.text.index("N", found.start())
        value = number(span.sentence.term(offset))
        fields = [
            (message, field)
            for message in messages
            for field in message.fields
            if field.type.name == "char" and field.is_array
        ]
        if (
            not fields
            or not is_sure
            or value in {field.count for _, field in fields} | {field.count - 1 for _, field in fields}
        ):
            continue
        message, field = fields[0]
        called = [
            field
            for _, field in fields
            if any(
                is_like(word, token) for word in re.findall("[a-z]+", lead) for token in field.name.lower().split("_")
            )
        ]
        if len(fields) > 1:
            if len(called) != 1:
                continue
            field = called[0]
        yield _length(reading, span, offset, message, field)


def _arrays(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "Up to 64 floats" of a message with one array of them."""
    for found in _ARRAY.finditer(span.text):
        offset = found.end() - 1
        stated = span.sentence.term(offset).value
        low, high = span.bounds(found.start())
        messages, is_sure = subjects(reading, span, found.start())
        if (
            not isinstance(stated, StatedType)
            or stated.length is None
            or not is_sure
            or pattern(r"[FC]").search(span.text[low:high])
            or pattern(r"\bP\b").search(span.text[low:high])
        ):
            continue
        fields = [field for field in messages[0].fields if field.is_array and 8 * field.type.size == stated.bits]
        if (
            len(fields) == 1
            and fields[0].count != stated.length
            and not pattern(r"\bour\b|\bwe\b|\bnot\b").search(span.text[low:high])
        ):
            yield _length(reading, span, offset, messages[0], fields[0])


def _length(reading: Reading, span: Span, offset: int, message: WireMessage, field: WireField) -> Diagnostic:
    written = span.sentence.term(offset).written
    text = f"{message.name}.{field.name} has {field.count} elements, not {written}"
    return reading.found(
        as_sure(TYPE, is_sure=False), span.place(offset), f"{message.name}.{field.name} {written}", text
    )
