"""Parameters of commands: units and numbers in their reach, compared with what the command says of that parameter."""

from collections.abc import Iterator

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import PARAMETER
from codegen.claims.statements.meaning import meaning
from codegen.claims.statements.nouns import is_like
from codegen.claims.statements.scaling.field_units import is_same_unit
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.parameter_places import ParameterPlace, parameter_places
from codegen.claims.weighed.entities.statement import Statement, piece, whole
from codegen.model.dialect.dialect import CommandParameter
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_PAIR = pattern(r"(?<![\w.])(?P<value>-?\d{1,5}) ?(?:[:=]|for|means) ?(?P<words>[a-z][a-z _-]{1,40})")
_WORD = pattern(r"[a-z]{2,}")
_IDLE = frozenset(("the", "for", "is", "of", "to", "in", "and", "or", "on", "if", "as", "by", "at", "it"))
_LINK = pattern(r"^[\s,:=(]*(?:for|means|is|to)?\b")
"""Between a value and the words for it."""
_LEAST = 2


def of_parameters(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield what is said of the parameters of the command that a part names, or that was named last."""
    for place in parameter_places(reading, span):
        yield from _in_reach(reading, span, place)
        yield from _of_label(span, place)


def _in_reach(reading: Reading, span: Span, place: ParameterPlace) -> Iterator[Statement]:
    command, own, start, end, more = place.command, place.parameter, place.start, place.end, place.traits
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
    said = _content(pattern(r"[,;.|(]").split(words)[0])
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


_STOP = pattern(r"[.;,|(:]| - | \u2013 |\b(?:of|which|that|where|if|when|in|from|must|not|and|or|is|are|as)\b")
_LEADING = pattern(r"^[\s,:=(|-]*(?:(?:is|are|holds?|has|means|gives|sets|for|the|an?|to|its|takes)\b[\s,:=(-]*)*")
_SEVERAL = pattern(r"param(?:eter)?s N (?:to|and|-) ?N")
_NO_LABEL = frozenset(
    ("value", "number", "unused", "empty", "reserved", "zero", "same", "param", "params", "the", "all")
)
_FULL, _PARTLY = 1.0, 0.5


def _of_label(span: Span, place: ParameterPlace) -> Iterator[Statement]:
    """The name that the first words about a parameter give it: where another one is called so, and this one is not."""
    low, high = piece(span, place.mark)
    linked = _INTO.search(span.text, max(low, place.mark - _FAR), place.mark) if "numbered" in place.traits else None
    if linked is not None:
        text = span.source_text(low, linked.start()).lower()
        words = _WORD.findall(_BEFORE.split(text)[-1])[-_MOST_WORDS:]
    else:
        text = _LEADING.sub("", span.source_text(place.start, place.end).lower())
        words = _WORD.findall(_STOP.split(text)[0])[:_MOST_WORDS]
    said = [word for word in words if word not in _IDLE and word not in _NO_LABEL and len(word) > 2]
    if not said or _SEVERAL.match(span.text, place.mark) or _is_own_unit(span, place):
        return
    shares = {each.number: _share(said, each) for each in place.command.parameters}
    own, most = shares[place.parameter.number], max(shares.values())
    meant = [each for each in place.command.parameters if shares[each.number] == most]
    if most < _PARTLY or (own < most and (own or len(meant) > 1)):
        return
    other = meant[0]
    label = dict(other.attributes).get("label", "") or " ".join(said)
    found = traits(
        all_words=most >= _FULL,
        one_word=len(said) == 1,
        of_the_label=set(said) <= set(_WORD.findall(label.lower())),
        own_has_no_label=not dict(place.parameter.attributes).get("label"),
        near=place.start - place.mark < _NEAR,
        words_before=linked is not None,
    )
    name = place.command.name
    yield Statement(
        "parameter label",
        PARAMETER,
        span,
        place.mark,
        low,
        high,
        name,
        f"param{place.parameter.number}",
        own >= most,
        f"{name}: {label} is param {other.number}, not {place.parameter.number}",
        name,
        (*place.traits, *found),
    )


def _is_own_unit(span: Span, place: ParameterPlace) -> bool:
    """Return whether the first word about a parameter is its unit: "param1: seconds" is not the one called Second."""
    link = _LINK_TO.match(span.text, place.start, place.end)
    stated = span.sentence.terms.get(link.end()) if link is not None else None
    unit = stated.value if stated is not None and stated.letter == "U" else None
    own = Unit.parse(dict(place.parameter.attributes).get("units"))
    return own is not None and isinstance(unit, Unit) and is_same_unit(unit, own)


_LINK_TO = pattern(r"[\s,:=(|-]*(?:(?:is|are|in|the|holds?|means|takes)\b ?)*")
_INTO = pattern(r"\b(?:is|are|goes|comes|in|into|to|as|by|with)(?: (?:to|in|into|the|of))* $|= ?$")
"""Between the words for a parameter and its number, where the number comes last: "the mode goes to param 7"."""
_BEFORE = pattern(r"[.;,|(:)]|\b(?:and|or|where|which|that|is|are|send|sends|put|set|with)\b")
_MOST_WORDS = 6
_NEAR, _FAR = 8, 20


def _share(said: list[str], parameter: CommandParameter) -> float:
    """Return the share of some words that are in the label of a parameter, which count more, or its description."""
    label = _WORD.findall(dict(parameter.attributes).get("label", "").lower())
    told = [*label, *_WORD.findall(parameter.description.lower())]
    of_label, of_both = (
        sum(any(is_like(word, token) for token in tokens) for word in said) for tokens in (label, told)
    )
    return (of_both + of_label / 2) / len(said)
