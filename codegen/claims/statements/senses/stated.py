"""Compares what a part says of the way in which a field counts with the field's description."""

from collections.abc import Iterator

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, DENIED, MISTAKEN, OWN, PAST, PROPOSED, REPLACED, SUPPOSED, words
from codegen.claims.rules import SENSE
from codegen.claims.statements.fields import Said, each_about, number, said_of_fields
from codegen.claims.statements.senses.words import Sense, has_other_way, levels, signs, told
from codegen.claims.statements.subjects import subjects
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.pattern import pattern

_FAR = 140
"""The greatest distance of such words from the name of their field."""
_RULED_OUT = words(
    DENIED, REPLACED, PAST, MISTAKEN, OWN[:3], PROPOSED, SUPPOSED[:1], ASKED,
    r"\bflip", r"\bnegat(?:e|ed|es|ing)\b", r"\binvert", r"\brevers", r"\bturn(?:s|ed)? (?:the sign|round|around)",
    r"\bso that\b", r"\bif you\b", r"\bconvert", r"\bsubtract", r"\badd(?:s|ed|ing)?\b", r"\bwhereas\b", r"\bwhile\b",
    r"\bdiffer", r"\beither\b", r"\bminus the\b", r"\bsign of\b", r"\bthan\b", r"\bros\b", r"\bmapped\b",
)  # fmt: skip
_DOWN = pattern(r"(?:v|a|af|v_)?z\b")
_OF_MAVLINK = pattern(r"\bmavlink (?:wants|has|uses|is|expects|counts)\b", needs="mavlink")
_VALUE = pattern(r"Q (?:above |over )?$|\b(?:Q|N) [a-z]+ (?:above |over )?$")
"""Before words that belong to one value: "you are at 488 m above sea level"."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every way of counting that a part gives a field, where the field's description gives another."""
    found_at: set[int] = set()
    for said in said_of_fields(span):
        until = min(said.until, said.end + _FAR)
        fields = [one for at, one in each_about(reading, said) if at in said.names]
        for at, sense in _senses(span, said.end, until) if fields else ():
            low, _ = span.bounds(said.start)
            if _RULED_OUT.search(span.text, max(low, said.before), at + len(sense.words) + 1):
                continue
            if (
                _VALUE.search(span.text, max(at - _FAR, 0), at)
                or _is_left_side(span, said)
                or _is_turned(span, said.end, at)
            ):
                continue
            found_at.add(at)
            of_each = [(one, told_of(one.message, one.field).get(sense.axis)) for one in fields]
            known = [(one, each) for one, each in of_each if each is not None]
            if not known or not all(_is_other(each, sense) for _, each in known):
                continue
            one, first = known[0]
            if all(_is_other(told_of(one.message, field).get(sense.axis), sense) for field in one.others):
                yield _finding(reading, span, at, one.name, sense, first)
    if span.kind is not PassageKind.ROW and (not span.is_code or _OF_MAVLINK.search(span.text)):
        yield from _unnamed(reading, span, found_at)


def _is_turned(span: Span, low: int, high: int) -> bool:
    """Return whether a negative factor stands before words that tell of what it is applied to."""
    return any((number(term) or 0) < 0 for _, term in span.sentence.within(low, high, "N"))


def _is_left_side(span: Span, said: Said) -> bool:
    """Return whether a row maps something else to a field, and the field's name stands there again."""
    if span.kind is not PassageKind.ROW:
        return False
    names = {span.sentence.term(at).written for at in said.names}
    return any(term.written in names for _, term in span.sentence.within(said.end, len(span.text), "FP"))


def _unnamed(reading: Reading, span: Span, done: set[int]) -> Iterator[Diagnostic]:
    """ "clockwise is +1000", where one field of the message counts turns."""
    for at, sense in _senses(span, 0, len(span.text)):
        low, high = span.bounds(at)
        names = "C" if sense.axis == "quaternion" else "FPC"  # whose own letters are names of fields
        if at in done or sense.axis not in _ALONE or any(span.sentence.within(low, high, names)):
            continue
        messages, is_sure = subjects(reading, span, at)
        known = [
            (field, each)
            for field in (messages[0].fields if messages and is_sure else ())
            if (each := told_of(messages[0], field).get(sense.axis)) is not None
        ]
        is_wrong = bool(known) and all(_is_other(each, sense) for _, each in known)
        if is_wrong and not _RULED_OUT.search(span.text, low, high):
            yield _finding(reading, span, at, f"{messages[0].name}.{known[0][0].name}", sense, known[0][1])


_ALONE = ("vertical", "rotation", "wind", "flow", "line", "quaternion")
"""Axes that are told of a message without the name of a field."""


def _senses(span: Span, low: int, high: int) -> Iterator[tuple[int, Sense]]:
    """Yield what a piece of a part says with the offset of the words; nothing of an axis of which it says both."""
    pieces = [
        span.sentence.terms[at].written if at in span.sentence.terms else span.text[at] for at in range(low, high)
    ]
    text = "".join(pieces).lower()
    found = [*signs(text), *levels(text)]
    for axis in dict.fromkeys(sense.axis for sense in found):
        each = [sense for sense in found if sense.axis == axis]
        sense = min(each, key=lambda one: one.start)
        if len({one.pole for one in each}) == 1 and not has_other_way(sense, text):
            yield low + _piece(pieces, sense.start), sense


def _piece(pieces: list[str], offset: int) -> int:
    """The number of the piece in which a character stands."""
    end = 0
    for place, piece in enumerate(pieces):
        end += len(piece)
        if offset < end:
            return place
    return max(len(pieces) - 1, 0)


def told_of(message: WireMessage, field: WireField) -> dict[str, Sense]:
    """Return what a field's description says by axis; in NED z points down unless it says something else."""
    found = dict(told(field.definition.description))
    if "vertical" not in found and "NED" in message.name.split("_") and _DOWN.fullmatch(field.name):
        found["vertical"] = Sense("vertical", "-", "positive down (NED)", 0, 0)
    return found


def _is_other(known: Sense | None, sense: Sense) -> bool:
    return known is not None and known.pole != sense.pole


def _finding(reading: Reading, span: Span, at: int, name: str, sense: Sense, known: Sense) -> Diagnostic:
    text = f'{name}: the dialect says "{known.words}", not "{sense.words}"'
    return reading.found(SENSE, span.place(at), f"{name} {sense.words}", text)
