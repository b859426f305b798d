"""Ways, frames, corners and levels in a sentence, of a field that it names or that its words mean."""

from collections.abc import Iterator, Mapping
from functools import cache

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import SENSE
from codegen.claims.statements.senses.stated import told_of
from codegen.claims.statements.senses.words import Sense, levels, loose_signs, signs
from codegen.claims.statements.subjects import subjects
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import Statement, piece
from codegen.claims.weighed.pairs import field_at
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.once import once
from codegen.pattern import pattern

_FURTHER: Mapping[str, Mapping[str, str]] = {
    "axes": {
        "NED": r"\bned\b",
        "ENU": r"\benu\b",
        "FRD": r"\bfrd\b",
        "FLU": r"\bflu\b",
        "body": r"\bbody(?:[- ]frame)?\b",
    },
    "corner": {
        "south-west": r"\bs\.?w\.? corner|\bsouth[- ]?west",
        "north-west": r"\bn\.?w\.? corner|\bnorth[- ]?west",
        "south-east": r"\bs\.?e\.? corner|\bsouth[- ]?east",
        "north-east": r"\bn\.?e\.? corner|\bnorth[- ]?east",
    },
    "edge": {"top": r"\btop\b|\bupper edge\b", "bottom": r"\bbottom\b|\blower edge\b"},
    "time": {
        "boot": r"\b(?:since|after|from) (?:system |the |last |its )*boot\b|\bsince (?:power|start)",
        "epoch": r"\bunix\b|\bepoch\b|\bsince 1970\b",
    },
    "turn": {
        "signed": r"-?180 ?(?:to|\.\.+|-|,) ?\+?180|-pi ?(?:to|\.\.+) ?\+?pi",
        "full": r"\b0 ?(?:to|\.\.+|-) ?(?:360|359|two pi|2 ?pi)",
    },
    "unit of one": {
        "one": r"\b0(?:\.0)? ?(?:to|\.\.+|-) ?1(?:\.0)?\b",
        "hundred": r"\b0 ?(?:to|\.\.+|-) ?100\b|\bpercent\b",
    },
}
_SAID = {
    axis: pattern("|".join(f"(?P<p{n}>{each})" for n, each in enumerate(poles.values())))
    for axis, poles in _FURTHER.items()
}
_NEEDED = (
    "positive", "negative", "plus", "minus", "clockwise", "count", "ned", "enu", "frd", "flu", "body", "corner",
    "top", "bottom", "boot", "unix", "epoch", " pi", "N to N", "N..", "N-N", "N, N", "msl", "sea", "ellips",
    "wgs", "home", "ground", "terrain", "first", "based", "start", "remaining", "used", "in use", "north",
    "airspeed", "whole", "total", "per", "y z", "y, z", "comes", "blow", "hae",
)  # fmt: skip
"""Words one of which is in every part that tells of a way, a frame or a level."""
_FAR = 400


def ways(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield each way, frame or level that a sentence tells, where a field that may be meant has another one."""
    axes, text = _axes(reading), span.text
    if not axes or not any(word in text for word in _NEEDED):
        return
    done: set[int] = set()
    for start in _starts(span):
        low, high = piece(span, start)
        if low in done:
            continue
        done.add(low)
        pieces = [
            span.sentence.terms[at].written if at in span.sentence.terms else span.text[at] for at in range(low, high)
        ]
        words = "".join(pieces).lower()
        strict = {(each.axis, each.pole) for each in signs(words)}
        found = [*signs(words), *levels(words), *loose_signs(words), *_further(words)]
        poles = {axis: {each.pole for each in found if each.axis == axis} for axis in {each.axis for each in found}}
        if axes.isdisjoint(poles):
            continue
        names = [at for at, _ in span.sentence.within(low, high, "FP")]
        for sense in {(each.axis, each.pole): each for each in reversed(found)}.values():
            at = low + _piece(pieces, sense.start)
            for one, others, tie in _fields(reading, span, names, at, sense):
                own = _told(*one).get(sense.axis)
                if own is None:
                    continue
                is_right = own.pole == sense.pole or any(
                    (other := _told(one[0], each).get(sense.axis)) is not None and other.pole == sense.pole
                    for each in others
                )
                name = f"{one[0].name}.{one[1].name}"
                text = f'{name}: the dialect says "{own.words}", not "{sense.words}"'
                more = traits(
                    strict=(sense.axis, sense.pole) in strict,
                    both_ways=len(poles[sense.axis]) > 1,
                    several_fields_named=len(names) > 1,
                    of_another_field=any(
                        (each := _told(one[0], field).get(sense.axis)) is not None and each.pole == sense.pole
                        for field in one[0].fields
                    ),
                )
                yield Statement(
                    "way",
                    SENSE,
                    span,
                    at,
                    low,
                    high,
                    one[0].name,
                    one[1].name,
                    is_right,
                    text,
                    sense.axis,
                    (f"of {sense.axis}", *tie, *more),
                )


def _starts(span: Span) -> Iterator[int]:
    """Yield an offset in each sentence of a part."""
    at = 0
    while at < len(span.text):
        yield at
        _, high = piece(span, at)
        at = max(high + 1, at + 1)


def _fields(
    reading: Reading, span: Span, names: list[int], at: int, sense: Sense
) -> Iterator[tuple[tuple[WireMessage, WireField], tuple[WireField, ...], tuple[str, ...]]]:
    """Yield the fields that may be meant with others of the same name: the nearest named, or one of the message."""
    before = [name for name in names if name < at][-1:]
    behind = [name for name in names if name > at][:1]
    for name in (*before, *behind):
        found = field_at(reading, span, name)
        if found is not None and abs(name - at) < _FAR:
            one, is_loose = found
            tie = traits(
                named_before=name < at,
                named_behind=name > at,
                loose=is_loose,
                sure=one.is_sure,
                near=abs(name - at) < 30,
                word=span.text[name] == "P",
                between_names=any(letter in span.text[min(name, at) + 1 : max(name, at)] for letter in "FPM"),
            )
            yield (one.message, one.field), one.others, tie
    if not names:
        messages, is_sure = subjects(reading, span, at)
        for message in messages[:1]:
            known = [field for field in message.fields if sense.axis in _told(message, field)]
            if known and len({_told(message, field)[sense.axis].pole for field in known}) == 1:
                yield (message, known[0]), (), ("not named", *traits(sure=is_sure, only=len(known) == 1))


@once
def _axes(reading: Reading) -> frozenset[str]:
    """The axes that descriptions tell of in the messages that the document names."""
    names = dict.fromkeys(name for _, name in reading.sightings)
    fields = [(reading.messages[name], field) for name in names for field in reading.messages[name].fields]
    return frozenset(axis for message, field in fields for axis in _told(message, field))


def _told(message: WireMessage, field: WireField) -> Mapping[str, Sense]:
    return {**_described(field), **told_of(message, field)}


@cache
def _described(field: WireField) -> Mapping[str, Sense]:
    found: dict[str, list[Sense]] = {}
    for each in _further(field.definition.description.lower()):
        found.setdefault(each.axis, []).append(each)
    return {axis: those[0] for axis, those in found.items() if len({each.pole for each in those}) == 1}


def _further(text: str) -> Iterator[Sense]:
    """Yield the frames, corners and ranges that a text in small letters names."""
    for axis, form in _SAID.items():
        for found in form.finditer(text):
            pole = next(name for n, name in enumerate(_FURTHER[axis]) if found[f"p{n}"])
            yield Sense(axis, pole, found[0], *found.span())


def _piece(pieces: list[str], offset: int) -> int:
    """The number of the piece in which a character stands."""
    end = 0
    for place, each in enumerate(pieces):
        end += len(each)
        if offset < end:
            return place
    return max(len(pieces) - 1, 0)
