"""Claims about the parameters of commands, by their number: "param 2 of NAME is the interval in us"."""

import re
from collections.abc import Iterator, Mapping, Sequence

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, DENIED, MISTAKEN, OWN, PAST, PROPOSED, REPLACED, words
from codegen.claims.rules import PARAMETER, as_sure
from codegen.claims.statements.fields import number
from codegen.claims.statements.scaling.field_units import is_same_unit
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import CommandParameter, EnumEntry
from codegen.model.units.unit import Unit
from codegen.once import once
from codegen.pattern import pattern

_NUMBERED = pattern(
    r"\b(?:param(?:eter)?s?) ?(?:no\.? |number |#)?(?P<spaced>N)|\bparam(?P<joined>[1-7])\b|\bp(?P<short>[1-7])\b"
)
_LINK = r"(?:is|are|=|:|\||holds?|carries|has|means|gives|sets|takes|tells|stands for|to|for|\(|-|\u2013|\u2014)"
_BEHIND = pattern(
    rf"\)? ?(?:of V ?|in V ?)?,? ?{_LINK}[ |]*(?:[NQ], )?(?:the |an? |its )?(?P<what>[a-zPU][a-zPU /'-]{{2,40}})"
)
_BEFORE = pattern(
    r"(?:the |an? |with |: ?)(?P<what>[a-zPU][a-zPU /'-]{2,40}?)(?: \(U\)| in U)?(?: (?:is|goes|stands|belongs"
    r"|comes|sits))?"
    r" (?:in|into|as|by) (?:the )?$"
)
_STOPS = pattern(
    r"\b(?:in|of|as|and|or|where|which|that|if|when|from|with|for|must|not|is|are|goes|to|here)\b|[,.;:|()]"
)
_RULED_OUT = words(ASKED, DENIED, MISTAKEN, OWN, PAST, PROPOSED, REPLACED)
_IDLE = frozenset(("the", "a", "an", "of", "in", "to", "for", "value", "number", "id", "desired", "target", "is", "on"))
_FAR = 90


def check(reading: Reading, parts: Sequence[Span]) -> Iterator[Diagnostic]:
    """Every parameter by number of the command that a part, the heading or the text before it is about."""
    around: str | None = None
    for span in parts:
        named = [name for name in commands_in(reading, span) if name]
        if not span.is_code or span.is_comment:
            yield from _numbered(reading, span, around if not set(named) else None)
        if span.kind is PassageKind.HEADING:
            around = named[0] if len(set(named)) == 1 else None
        elif named:
            around = named[-1] if len(set(named)) == 1 else None


def commands_in(reading: Reading, span: Span) -> list[str]:
    """Return the commands that a part names, in order; in a heading also without "MAV_CMD_", as in "NAV_DELAY (93)".

    A name in capitals that is none of the dialect's is empty there: what follows is about no command that stands above.
    """
    commands, is_heading = _commands(reading), span.kind is PassageKind.HEADING
    named = (term for _, term in span.sentence.within(0, len(span.text), "VC" if is_heading else "V"))
    whole = [(name, f"MAV_CMD_{name}" if is_heading else name) for name in (str(term.value) for term in named)]
    found = [next((each for each in names if each in commands), "") for names in whole]
    return found if is_heading else [name for name in found if name]


def _numbered(reading: Reading, span: Span, around: str | None) -> Iterator[Diagnostic]:
    for found in _NUMBERED.finditer(span.text):
        command = _command(reading, span, found.start(), around)
        at = _number_at(span, found)
        low, high = span.bounds(found.start())
        if command is None or at is None or _RULED_OUT.search(span.text, low, high):
            continue
        behind = _BEHIND.match(span.text, found.end(), min(high, found.end() + _FAR))
        before = _BEFORE.search(span.text, max(low, found.start() - _FAR), found.start())
        said = behind or before
        if said is not None:
            yield from _said(reading, span, found, said, command, at)
        amount = _AMOUNT.match(span.text, found.end(), high)
        if amount is not None:
            own = next((each for each in command.parameters if each.number == str(at)), None)
            yield from _amount(reading, span, amount, command, own) if own is not None else ()


def _number_at(span: Span, found: "re.Match[str]") -> int | None:
    """The number of a parameter, from 1 to 7."""
    value = (
        number(span.sentence.term(found.start("spaced"))) if found["spaced"] else int(found["joined"] or found["short"])
    )
    return int(value) if value is not None and value in range(1, 8) else None


def _command(reading: Reading, span: Span, offset: int, around: str | None) -> EnumEntry | None:
    """The command that a parameter is one of: the nearest before it, or the only one of the part or the document."""
    commands = _commands(reading)
    low, high = span.bounds(offset)
    own = [(at, str(term.value)) for at, term in span.sentence.within(low, high, "V") if str(term.value) in commands]
    names = [name for at, name in own if at < offset][-1:] or [name for _, name in own][:1]
    inside = {str(term.value) for _, term in span.sentence.within(0, len(span.text), "V")} & set(commands)
    if not names and len(inside) == 1:
        names = list(inside)
    return commands.get(names[0]) if names else commands.get(around or "")


@once
def _commands(reading: Reading) -> Mapping[str, EnumEntry]:
    enum = reading.enums.get("MAV_CMD")
    return {entry.name: entry for entry in enum.entries} if enum is not None else {}


def _said(
    reading: Reading, span: Span, found: "re.Match[str]", said: "re.Match[str]", command: EnumEntry, at: int
) -> Iterator[Diagnostic]:
    text = span.source_text(*said.span("what")).lower()
    what = _content(_STOPS.split(text)[0] if said.start() >= found.end() else _STOPS.split(text)[-1])
    own = next((each for each in command.parameters if each.number == str(at)), None)
    if not what or own is None:
        return
    if _is_named(own, what):
        yield from _unit(reading, span, said, command, own)
        return
    meant = [each for each in command.parameters if each is not own and _label(each) and set(_label(each)) == set(what)]
    if len(meant) == 1 and not set(what) <= {*_label(own), *_content(own.description.lower())}:
        name = dict(meant[0].attributes).get("label", "")
        text = f"{command.name}: {name} is param {meant[0].number}, not {at}"
        place, claim = span.place(found.start()), f"{command.name} param {at} {' '.join(what)}"
        yield reading.found(as_sure(PARAMETER, is_sure=True), place, claim, text)


def _unit(
    reading: Reading, span: Span, said: "re.Match[str]", command: EnumEntry, own: CommandParameter
) -> Iterator[Diagnostic]:
    """The unit that is said of a parameter."""
    low, high = said.start("what"), min(said.end() + 24, span.bounds(said.start())[1])
    stated = re.compile(
        r"(?:\b(?:in|unit:?) |[(,\[] ?)(?P<unit>U)(?=\s*(?:[,.;)\]|]|$|and\b|as\b|from\b|in\b))"
    ).search(span.text, low, high)
    units = Unit.parse(dict(own.attributes).get("units"))
    unit = span.sentence.term(stated.start("unit")).value if stated is not None else None
    if stated is None or units is None or not isinstance(unit, Unit) or is_same_unit(unit, units) or not unit.dimension:
        return
    written = span.sentence.term(stated.start("unit")).written
    name = dict(own.attributes).get("label", "")
    text = f"{command.name}: param {own.number} ({name}) is in {dict(own.attributes)['units']}, not {written}"
    yield reading.found(PARAMETER, span.place(stated.start("unit")), f"{command.name} {own.number} {written}", text)


_AMOUNT = pattern(r"\)? ?(?:=|is|:|to|of|set to)? ?(?:N ?\(?(?P<unit>U)\)?|(?P<amount>Q))(?=\s*(?:[,.;)|]|$|and\b))")
"""A parameter with its value and the unit of it."""


def _amount(
    reading: Reading, span: Span, found: "re.Match[str]", command: EnumEntry, own: CommandParameter
) -> Iterator[Diagnostic]:
    """ "param2 = 1200 (cm/s)" of a parameter in m/s."""
    at = found.start("unit") if found["unit"] else found.start("amount")
    value = span.sentence.term(at).value
    unit = value[1] if isinstance(value, tuple) else value
    units = Unit.parse(dict(own.attributes).get("units"))
    if units is None or not isinstance(unit, Unit) or is_same_unit(unit, units) or not unit.dimension:
        return
    written = span.sentence.term(at).written
    name = dict(own.attributes).get("label", "")
    text = f"{command.name}: param {own.number} ({name}) is in {dict(own.attributes)['units']}, not {written}"
    yield reading.found(
        as_sure(PARAMETER, is_sure=False), span.place(at), f"{command.name} {own.number} {written}", text
    )


def _content(text: str) -> list[str]:
    return [word for word in pattern(r"[a-z0-9]+").findall(text) if word not in _IDLE]


def _label(parameter: CommandParameter) -> list[str]:
    return _content(dict(parameter.attributes).get("label", "").lower())


def _is_named(parameter: CommandParameter, what: list[str]) -> bool:
    """Return whether words are among those of a parameter's label, or the label's among them."""
    label = _label(parameter)
    return bool(label) and (set(what) >= set(label) or set(what) <= set(label))
