"""The parts of a document in which statements stand, each with the messages that it may be about."""

from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache, partial
from itertools import groupby

from codegen.claims.enum_names import entry_values
from codegen.claims.parts.cells import said_before
from codegen.claims.parts.code_spans import code_spans, named_in
from codegen.claims.parts.led import led_by, names_leading
from codegen.claims.parts.pronouns import with_names
from codegen.claims.parts.sentence import Sentence, Term, Vocabulary
from codegen.claims.parts.span import Span, Topic
from codegen.claims.parts.terms import read_sentence
from codegen.claims.reading import Reading
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.model.dialect.dialect import EnumDefinition, WireMessage
from codegen.once import once
from codegen.pattern import pattern

_LONG_NAME = pattern(r"\b[A-Z][A-Z0-9]{1,30}(?:_[A-Z0-9]{1,30}){2}")
_FIRST_NAME = pattern(r"[\s|*-]*(?P<name>[a-z][a-z0-9_]*)(?=\s*(?:$|[|:(=\u2013-]|\[))")
_CELL = pattern(r"(?:^|\|)[\s*-]*([a-z]\w*)(?=[\s|:(=\[,\u2013-]|$)")
_ENOUGH = 3
"""Names that have to begin items or rows before most of them have to be fields."""
_MOST = 20
"""So many messages that are named before a part are remembered."""


@once
def vocabulary(reading: Reading) -> Vocabulary:
    """The names that are terms in a document: fields only of messages that it names."""
    named = {name for _, name in reading.sightings}
    fields = frozenset(field.name for name in named for field in reading.messages[name].fields)
    return _vocabularies(reading.messages)(reading.enums)(fields)


@once
def _vocabularies(
    messages: Mapping[str, WireMessage],
) -> Callable[[Mapping[str, EnumDefinition]], Callable[[frozenset[str]], Vocabulary]]:
    """Return what makes vocabularies with some messages, of enums and fields: the same one of the same."""
    return once(lambda enums: lru_cache(8)(partial(Vocabulary, messages, enums, entry_values(enums))))


@once
def _reader(words: Vocabulary) -> Callable[[str, tuple[tuple[int, int], ...]], Sentence]:
    """Return what reads texts with a vocabulary: texts are repeated, and documents read again."""
    return lru_cache(maxsize=1024)(lambda text, codes: read_sentence(text, 0, len(text), codes, words))


@once
def spans(reading: Reading) -> tuple[Span, ...]:
    """All parts of a document, in order; none of one that names no message."""
    is_about_enums = any(_LONG_NAME.search(part.text) for part in reading.prose.parts)
    return tuple(_spans(reading)) if reading.sightings or is_about_enums else ()


def _spans(reading: Reading) -> Iterator[Span]:
    words = vocabulary(reading)
    headings: list[tuple[int, tuple[WireMessage, ...]]] = []
    earlier: list[WireMessage] = []
    above: tuple[WireMessage, ...] = ()
    heads: tuple[str, ...] = ()
    document = tuple(reading.messages[name] for name in dict.fromkeys(name for _, name in reading.sightings))
    row: tuple[WireMessage, ...] = ()
    previous: PassageKind | None = None
    leading: list[Term] = []
    is_foreign = is_foreign_section = False
    others = _other_lists(reading, words)
    read = _reader(words)
    for part in reading.prose.parts:
        named = _named(reading, part)
        if isinstance(part, Passage) and part.kind is PassageKind.HEADING:
            headings = [each for each in headings if each[0] < part.level]
            headings.append((part.level, named))
            is_foreign = not named and _is_foreign(reading, part)
            is_foreign_section = is_foreign and _NUMBERED.search(part.text) is not None
            earlier, above = [], ()
        elif isinstance(part, Passage) and part.kind is PassageKind.TEXT:
            is_foreign = not named and (
                _is_foreign(reading, part) or (is_foreign and not headings) or is_foreign_section
            )
        is_row = isinstance(part, Passage) and part.kind is PassageKind.ROW
        row = named or (row if is_row and _GOES_ON.match(part.text) else ())
        inside = tuple(message for _, group in reversed(headings) for message in group)
        topic = (
            Topic((), (), (), ())
            if is_foreign or id(part) in others or (not named and _is_foreign_item(reading, part))
            else Topic((row if is_row else ()) or above, inside, tuple(earlier), document)
        )
        if isinstance(part, CodeBlock):
            yield from code_spans(reading, part, topic, words)
            previous = None
        else:
            sentence = read(part.text, part.codes)
            is_head = part.kind is PassageKind.ROW and previous is not PassageKind.ROW
            if is_head:
                heads = tuple(cell.strip() for cell in part.text.strip().strip("|").split("|"))
            yield Span(sentence, part.kind, topic, part.place_at, heads=heads if part.kind is PassageKind.ROW else ())
            for kind, said in _as_meant(part.kind, sentence, () if is_head else heads, leading):
                yield Span(said, kind, topic, part.place_at)
            leading = names_leading(sentence, is_heading=part.kind is PassageKind.HEADING)
            if part.kind in (PassageKind.TEXT, PassageKind.HEADING) and named:
                above = named
            previous = part.kind
        for message in reversed(named):
            if message in earlier:
                earlier.remove(message)
            earlier.insert(0, message)
        del earlier[_MOST:]


def _as_meant(
    kind: PassageKind, sentence: Sentence, heads: tuple[str, ...], leading: list[Term]
) -> Iterator[tuple[PassageKind, Sentence]]:
    """The same text with the names that a reader puts in it: for pronouns, from above it, from another cell."""
    if kind is PassageKind.ROW:
        yield from ((PassageKind.ITEM, said) for said in (said_before(sentence, heads) if heads else ()))
        return
    if (written_out := with_names(sentence)) is not None:
        yield kind, written_out
    if kind is not PassageKind.HEADING and leading:
        yield PassageKind.ITEM, led_by(leading, sentence)


def _other_lists(reading: Reading, words: Vocabulary) -> frozenset[int]:
    """Rows and items of runs of which at most half of the names at the beginning are fields: they list other things."""
    found: set[int] = set()
    for kind, run in groupby(reading.prose.parts, lambda part: getattr(part, "kind", None)):
        if kind in (PassageKind.ROW, PassageKind.ITEM):
            parts = [part for part in run if isinstance(part, Passage)]
            begun = [part for part in parts if _FIRST_NAME.match(part.text)]
            known = sum(not words.fields.isdisjoint(_CELL.findall(part.text)) for part in begun)
            if len(begun) >= _ENOUGH and 2 * known <= len(begun):
                found |= {id(part) for part in parts}
    return frozenset(found)


def _is_foreign(reading: Reading, part: Passage) -> bool:
    """Return whether a heading or a caption is about a message that the dialect does not have."""
    text = part.text.strip()
    found = _CALLED.match(text) if part.kind is PassageKind.HEADING else _CAPTION.search(text)
    name = found["name"] if found is not None else ""
    known = vocabulary(reading)
    return bool(name) and name not in known.messages and name not in known.enums and name not in known.entries


def _is_foreign_item(reading: Reading, part: Passage | CodeBlock) -> bool:
    """Return whether an item is about a message of another kind, such as one of a log: "the log, message `IMU`"."""
    found = _ITEM.search(part.text) if isinstance(part, Passage) and part.kind is PassageKind.ITEM else None
    known = vocabulary(reading)
    return found is not None and found["name"] not in known.messages and found["name"] not in known.enums


_ITEM = pattern(r"\b[Mm]essage (?P<name>[A-Z][A-Z0-9_]{2,})\b(?=[.,;:]|$)")
_GOES_ON = pattern(r"\|\s*\|")
"""A row without a first cell, which goes on with what the row above it is about."""
_NUMBERED = pattern(r"[(#,]\s*(?:id )?#?\d+\b")
"""A heading with an id: its whole section is about a message, and not about a parameter."""
_CALLED = pattern(
    r"(?:\d[\d.]* )?(?:Message |The message )?(?P<name>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+)\b(?=\s*(?:$|[(:,#\u2013-]))"
)
_CAPTION = pattern(r"(?:^|\b[Mm]essage )(?P<name>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+)\b[^.]{0,60}:$")


def _named(reading: Reading, part: Passage | CodeBlock) -> tuple[WireMessage, ...]:
    return reading.named(part) if isinstance(part, Passage) else named_in(reading, part)
