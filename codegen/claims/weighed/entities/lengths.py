"""Numbers of elements in a sentence that names no field: of an array of the message, or of its numbered fields."""

from collections.abc import Iterator

from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.rules import TYPE
from codegen.claims.statements.nouns import is_like
from codegen.claims.statements.subjects import subjects
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import Statement, piece, whole
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import WireMessage
from codegen.once import once
from codegen.pattern import pattern

_NOUN = pattern(
    r" (?:more |single |float |char |byte |numbered )?(?P<noun>elements?|entries|values|items|slots|characters?|chars"
    r"|letters|cells|places|samples|points|floats|doubles|distances|bins|sectors|channels|cores|components|numbers"
    r"|motors|servos|outputs|satellites|readings|slices|heights|temperatures|currents|rpms?|angles|axes)\b"
)
_TEXT = ("char", "letter")
_PART = pattern(
    r"\b(?:first|last|lower|upper|only|some|least|more|less|fewer|about|other|remaining|own|our|often|used|uses"
    r"|not|never|usually|rest|each|per|every|another|under|over|below|above|than|or)\b[^.;N]{0,16}$"
)
_ALL = pattern(
    r"\b(?:up to|at most|exactly|all|of|has|have|room for|longer than|exceed\w*|full|whole|array of|carr(?:y|ies)"
    r"|holds?|takes?|limit\w*|max\w*|chunks of|in)\b[^.;N]{0,10}$"
)
_MINE = pattern(r"\b(?:we|our|my|us|sensor|device|driver|vehicle|log|file|screen|display|line|buffer)\b")
_WORD = pattern(r"[a-z]{3,}")
_DIGITS = pattern(r"^(?P<stem>[a-z_]+?)_?(?P<number>\d+)(?P<end>[a-z_]*)$")
_LEAST = 3


@dataclass(frozen=True, slots=True)
class _Array:
    """Elements that a number may count: of an array, or fields that differ in their number alone."""

    name: str
    words: frozenset[str]
    counts: tuple[int, ...]
    is_text: bool
    is_numbered: bool


def lengths(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield numbers of elements that no array of the message has."""
    if is_data(span) or (span.is_code and not span.is_comment):
        return
    for at, _ in span.sentence.within(0, len(span.text), "N"):
        noun = _NOUN.match(span.text, at + 1)
        value = whole(span, at) if noun is not None else None
        if noun is None or value is None or value < _LEAST:
            continue
        low, high = piece(span, at)
        if any(span.sentence.within(low, high, "F")):
            continue
        messages, is_sure = subjects(reading, span, at)
        if messages:
            is_alone = len(messages) == 1
            yield from _of_message(span, at, (low, high), value, noun["noun"], messages[0], is_sure and is_alone)


def _of_message(
    span: Span, at: int, bounds: tuple[int, int], value: int, noun: str, message: WireMessage, is_sure: bool
) -> Iterator[Statement]:
    low, high = bounds
    is_text = noun.startswith(_TEXT)
    arrays = [each for each in _arrays(message) if each.is_text == is_text or each.is_numbered]
    arrays = [each for each in arrays if not each.is_numbered or _is_noun_of(noun, each)]
    if not arrays:
        return
    is_right = any(value in each.counts for each in arrays)
    around = frozenset(_WORD.findall(span.text[low:high].lower()))
    scores = {each.name: sum(any(is_like(word, token) for token in each.words) for word in around) for each in arrays}
    best = max(arrays, key=lambda each: scores[each.name])
    before = span.text[max(low, at - 40) : at]
    named = [name for _, name in span.named(low, high)]
    found = traits(
        sure=is_sure,
        message_here=message.name in named,
        only_one=len(arrays) == 1,
        numbered=best.is_numbered,
        text=is_text,
        noun_of_it=_is_noun_of(noun, best),
        words_of_it=scores[best.name] > 0,
        several_words_of_it=scores[best.name] > 1,
        all_of_them=_ALL.search(before),
        part_of_them=_PART.search(before),
        fewer=value < best.counts[0],
        near_it=abs(value - best.counts[0]) <= _NEAR,
        many=value > _MANY,
        somebodys=_MINE.search(span.text, low, high),
        bytes="bytes" in span.text[low:high],
    )
    text = f"{message.name}.{best.name} has {best.counts[0]} elements, not {span.sentence.term(at).written}"
    if best.is_numbered:
        text = f"{message.name} has {best.counts[0]} fields such as {best.name}, not {span.sentence.term(at).written}"
    yield Statement(
        "length of none", TYPE, span, at, low, high, message.name, best.name, is_right, text, message.name, found
    )


_NEAR, _MANY = 2, 8


def _is_noun_of(noun: str, array: _Array) -> bool:
    """Return whether a word for elements is one of the name or the description: "channels" of ``chan1_raw``."""
    return any(is_like(noun, token) or (len(token) > _SHORT and noun.startswith(token)) for token in array.words)


_SHORT = 3


@once
def _arrays(message: WireMessage) -> tuple[_Array, ...]:
    """The arrays of a message, and its numbered fields."""
    found, numbered = [], dict[tuple[str, str], list[str]]()
    for field in message.fields:
        words = frozenset(
            _WORD.findall(f"{field.name.lower()} {field.definition.description.lower()}".replace("_", " "))
        )
        if field.is_array:
            is_text = field.type.name == "char"
            counts: tuple[int, ...] = (field.count, field.count - 1) if is_text else (field.count,)
            found.append(_Array(field.name, words, counts, is_text, is_numbered=False))
        elif (each := _DIGITS.match(field.name)) is not None:
            numbered.setdefault((each["stem"], each["end"]), []).append(field.name)
    for (stem, _), names in numbered.items():
        if len(names) >= _LEAST:
            base = sum(not field.definition.is_extension for field in message.fields if field.name in names)
            counts = tuple({len(names): 0, base: 0, len(names) - base: 0})
            found.append(_Array(names[-1], frozenset(_WORD.findall(stem)), counts, is_text=False, is_numbered=True))
    return tuple(found)
