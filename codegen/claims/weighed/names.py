"""Names in code spans that no message of the document has a field of, and that are like one, or stand among some."""

from collections.abc import Iterator

from codegen.claims.about import Surroundings, message_about, surroundings
from codegen.claims.known_names import is_of_field, near_fields, same_field
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import CONVERTED, DENIED, MISTAKEN, OWN, PAST, PROPOSED, SHOWN, is_aside, words
from codegen.claims.weighed.comparison import traits
from codegen.frozen import dataclass
from codegen.load.prose import Passage, PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.once import once
from codegen.pattern import pattern
from codegen.source import Place

_NAME = pattern(r"(?P<name>[a-z][a-z0-9_]{3,})(?:\[\d*\])?")
_CALLED = pattern(r"\b(?:fields?|extensions?|members?)\W+$")
_CALLED_BEHIND = pattern(r"\W+(?:fields?|of|in the message)\b")
_ELSE = pattern(
    r"\b(?:topic|param\w*|variable|function|macro|attribute|argument|option|setting|file|method|class|constant|signal"
    r"|script|module|column|table|key|command|our|the csv|tool|node|program|package|service|type|log|called|named)s?"
    r"\W+$"
)
_TOLD = pattern(r"`? (?:is|are|has|holds?|counts?|tells?|gives?|goes|carries|shall|must|and|,)")
_PART = pattern(r"`?\W?(?:\.|/|\(|=)")
_IS_ELSE = pattern(
    r"`? is (?:an?|the|our) (?:[a-z]+ )?(?:topic|param|variable|function|macro|option|setting|file|method|class|script)"
)
_LETTER = pattern(r"[a-zA-Z]")
_SENTENCE = {
    "denied": words(DENIED),
    "shown": words(SHOWN),
    "converted": words(CONVERTED),
    "past": words(PAST),
    "proposed": words(PROPOSED),
    "mistaken": words(MISTAKEN),
    "own": words(OWN),
}


@dataclass(frozen=True, slots=True)
class Stranger:
    """A name that its message has no field of: where it stands, and what speaks for a field that is meant."""

    message: WireMessage
    name: str
    place: Place
    traits: frozenset[str]


def strangers(reading: Reading) -> Iterator[Stranger]:
    """Yield the names in code spans that are those of no field of a message that the document names."""
    named = [reading.messages[name] for name in dict.fromkeys(name for _, name in reading.sightings)]
    known = {field.name for message in named for field in message.fields}
    for passage, near in surroundings(reading) if named else ():
        if not isinstance(passage, Passage):
            continue
        for low, high in passage.codes:
            found = _NAME.fullmatch(passage.text[low:high])
            if found is not None and not is_of_field(found["name"], known):
                yield from _stranger(reading, passage, near, (low, high), found["name"], named)


@once
def _elsewhere(reading: Reading) -> frozenset[str]:
    """The names of the fields of all messages that there are."""
    return frozenset(field.name for message in reading.messages.values() for field in message.fields)


def _stranger(
    reading: Reading, passage: Passage, near: Surroundings, span: tuple[int, int], name: str, named: list[WireMessage]
) -> Iterator[Stranger]:
    about = message_about(reading, passage, near, *span)
    alike = [message for message in named if near_fields(name, message)]
    message = about or next(iter(alike), None)
    low, high = span
    if message is None or _IS_ELSE.match(passage.text, high):
        return
    text, sentence = passage.text, passage.text[slice(*passage.sentence(low, high))].lower()
    before, meant = text[max(0, low - 18) : low].lower(), near_fields(name, message)
    others = [text[start:end] for start, end in passage.codes if (start, end) != span]
    fields = {field.name for field in message.fields}
    shared = max((_shared(name, each) for each in fields), default=0.0)
    found = traits(
        about_it=about is not None,
        like_a_field=meant,
        same_in_other_words=same_field(name, message),
        like_one_of_the_document=alike,
        field_of_another_message=name in _elsewhere(reading),
        field_with_an_end=any(name.startswith(f"{each}_") for each in fields),
        of_several_words="_" in name,
        one_letter_more_or_less=any(name in (f"{each}s", each.removesuffix("s")) for each in fields),
        half_of_the_words=shared >= _HALF,
        some_of_the_words=shared > 0,
        beside_several_fields=sum(other in fields for other in others) > 1,
        like_fields_of_several=len(alike) > 1,
        beside_fields=any(other in fields for other in others),
        beside_other_names=any(_NAME.fullmatch(other) and other not in fields for other in others),
        beside_what_it_is_like=any(each in text for each in meant),
        row=passage.kind is PassageKind.ROW,
        item=passage.kind is PassageKind.ITEM,
        first=not _LETTER.search(text[:low]),
        message_in_passage=message in reading.named(passage),
        only_message=len(named) == 1,
        heading=bool(near.headings) and near.headings[0] is message,
        called_a_field=_CALLED.search(before) or _CALLED_BEHIND.match(text[high:]),
        called_something_else=_ELSE.search(before),
        told_of=_TOLD.match(text[high:]),
        part_of_something=_PART.match(text[high : high + 3]),
        aside=is_aside(sentence),
    )
    said = (each for each, form in _SENTENCE.items() if form.search(sentence))
    yield Stranger(message, name, passage.place_at(low), frozenset((*found, *said)))


_HALF = 0.5


def _shared(one: str, other: str) -> float:
    """Return the share of the words of two names that both have."""
    first, second = set(one.split("_")), set(other.split("_"))
    return len(first & second) / len(first | second)
