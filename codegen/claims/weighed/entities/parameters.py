"""Parameters of commands: units and numbers in their reach, compared with what the command says of that parameter."""

import re
from collections.abc import Iterator, Mapping

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import PARAMETER
from codegen.claims.statements.fields import number
from codegen.claims.statements.meaning import meaning
from codegen.claims.statements.scaling.field_units import is_same_unit
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import Statement, piece, whole
from codegen.model.dialect.dialect import CommandParameter, EnumEntry
from codegen.model.units.unit import Unit
from codegen.once import once
from codegen.pattern import pattern

_PARAM = pattern(
    r"\bparam(?:eter)? ?(?:no\.? |number |#)?(?P<spaced>N)|\bparam(?P<joined>[1-7])\b|\bp(?P<short>[1-7])\b"
)
_PAIR = pattern(r"(?<![\w.])(?P<value>-?\d{1,5}) ?(?:[:=]|for|means) ?(?P<words>[a-z][a-z _-]{1,40})")
_WORD = pattern(r"[a-z]{2,}")
_IDLE = frozenset(("the", "for", "is", "of", "to", "in", "and", "or", "on", "if", "as", "by", "at", "it"))
_LINK = pattern(r"^[\s,:=(]*(?:for|means|is|to)?\b")
"""Between a value and the words for it."""
_LEAST = 2


def of_parameters(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield what is said of the parameters of the command that a part names, or that was named last."""
    commands = _commands(reading)
    marks = list(_PARAM.finditer(span.text))
    if not marks:
        return
    named = [
        (at, str(term.value)) for at, term in span.sentence.within(0, len(span.text), "V") if term.value in commands
    ]
    for index, found in enumerate(marks):
        before = [name for at, name in named if at < found.start()]
        name = before[-1] if before else named[0][1] if named else None
        value = (
            number(span.sentence.term(found.start("spaced")))
            if found["spaced"]
            else int(found["joined"] or found["short"])
        )
        command = commands.get(name or "")
        own = next((each for each in command.parameters if each.number == str(value)), None) if command else None
        if command is None or own is None:
            continue
        _, high = piece(span, found.start())
        following = marks[index + 1].start() if index + 1 < len(marks) else high
        end = min(high, following)
        bar = span.text.find(" | ", found.end(), end)
        more = traits(
            before=bool(before), several=len(marks) > 1, several_commands=len({each for _, each in named}) > 1
        )
        yield from _in_reach(reading, span, command, own, (found.end(), end if bar < 0 else bar), more)


@once
def _commands(reading: Reading) -> Mapping[str, EnumEntry]:
    enum = reading.enums.get("MAV_CMD")
    return {entry.name: entry for entry in enum.entries} if enum is not None else {}


def _in_reach(
    reading: Reading,
    span: Span,
    command: EnumEntry,
    own: CommandParameter,
    reach: tuple[int, int],
    more: tuple[str, ...],
) -> Iterator[Statement]:
    start, end = reach
    given = dict(own.attributes)
    units = Unit.parse(given.get("units"))
    label = f"{command.name}: param {own.number} ({given.get('label', '')})"

    def told(kind: str, at: int, text: str, found: tuple[str, ...], *, is_right: bool) -> Statement:
        low, high = piece(span, at)
        names = command.name, f"param{own.number}"
        return Statement(kind, PARAMETER, span, at, low, high, *names, is_right, text, "", (*more, *found))

    for at, term in span.sentence.within(start, end, "UQ"):
        unit = term.value[1] if isinstance(term.value, tuple) else term.value
        if units is not None and isinstance(unit, Unit) and unit.dimension:
            found = traits(alike=unit.dimension == units.dimension, amount=term.letter == "Q", near=at - start < 30)
            text = f"{label} is in {given['units']}, not {term.written}"
            yield told("parameter unit", at, text, found, is_right=is_same_unit(unit, units))
    numbers = [at for at, _ in span.sentence.within(start, end, "N")]
    for index, at in enumerate(numbers):
        value = whole(span, at)
        until = numbers[index + 1] if index + 1 < len(numbers) else end
        words = _LINK.sub("", span.source_text(at + 1, until).lower()).strip(" ,;.|")
        said = _meant(reading, own, value, words) if value is not None else None
        if said is not None:
            is_right, true = said
            text = f"{label}: {true} for {words}, not {span.sentence.term(at).written}"
            found = traits(near=at - start < 12, several_values=len(numbers) > 1, negative=(value or 0) < 0)
            yield told("parameter value", at, text, found, is_right=is_right)


def _meant(reading: Reading, own: CommandParameter, value: int, words: str) -> tuple[bool, str] | None:
    """Return whether words beside a number mean what is told of it, and the number that they mean; None if neither."""
    enum = reading.enums.get(dict(own.attributes).get("enum", ""))
    if enum is not None:
        if meaning(enum).is_named(value, words):
            return True, str(value)
        entry = meaning(enum).meant_otherwise(value, words)
        return (False, f"{entry.value} is {entry.name}") if entry is not None else None
    pairs = {int(found["value"]): _content(found["words"]) for found in _PAIR.finditer(own.description.lower())}
    said = _content(re.split(r"[,;.|(]", words)[0])
    if len(pairs) < _LEAST or not said:
        return None
    scores = {each: len(said & content) - len(content - said) / 10 for each, content in pairs.items() if said & content}
    best = max(scores, key=lambda each: scores[each], default=None)
    if best is None or (value in scores and scores[value] >= scores[best]):
        return (True, str(value)) if best is not None else None
    return False, str(best)


def _content(text: str) -> frozenset[str]:
    joined = text.replace("counter clockwise", "counterclockwise").replace("counter-clockwise", "counterclockwise")
    return frozenset(_WORD.findall(joined)) - _IDLE
