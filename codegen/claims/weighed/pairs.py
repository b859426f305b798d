"""Names of fields, each with what stands in its reach: pairs of which some are statements, and most are none."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.parts.sentence import NamedField, Term
from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.statements.fields import Said, number, said_of_fields
from codegen.claims.statements.subjects import About, about
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField
from codegen.pattern import pattern

_SHORT = 4
"""The least length of an everyday word that may be the name of a field without anything that says so, in letters."""
_OF_A_DEVICE = pattern(r"\b(?:sensor|device|driver|receiver)s $")
"""Before a name of what something else has: "the sensor's heading"."""
_KEYS = frozenset(("type", "name", "id", "length", "size", "offset", "count"))
_COLON = pattern(r"[\"']? ?:")
ATOMS = "UTLNS"
"""The letters of the terms that something is said by: units, types, numbers, names of numbers."""


@dataclass(frozen=True, slots=True)
class Pair:
    """A name of a field and a term in its reach, by their offsets, in a piece of a text between ``low`` and ``high``.

    ``side`` is where the name stands: before the term, behind it, or in the sentence before. ``several`` is how many
    names the term may be said of together, ``is_loose`` that only their name ties the field to its message,
    ``is_word`` that nothing says that the name is one.
    """

    span: Span
    name: int
    one: About
    at: int
    low: int
    high: int
    side: str
    several: int
    is_loose: bool
    is_word: bool

    @property
    def fields(self) -> tuple[WireField, ...]:
        """The fields that may be meant."""
        return (self.one.field, *self.one.others)

    @property
    def term(self) -> Term:
        """The term."""
        return self.span.sentence.term(self.at)

    @property
    def named(self) -> Term:
        """The name of the field."""
        return self.span.sentence.term(self.name)

    @property
    def sentence(self) -> str:
        """The short text of the sentence, the row or the line."""
        return self.span.text[self.low : self.high]

    @property
    def gap(self) -> str:
        """The short text between the name and the term."""
        return self.span.text[min(self.name, self.at) + 1 : max(self.name, self.at)]

    def before(self, characters: int) -> str:
        """The last characters of the sentence before the term."""
        return self.span.text[max(self.low, self.at - characters) : self.at]

    def behind(self, characters: int) -> str:
        """The first characters behind the term."""
        return self.span.text[self.at + 1 : self.at + 1 + characters]


def is_line(span: Span) -> bool:
    """Return whether all of a part belongs together: a row of a table, or a line of code."""
    return span.kind is PassageKind.ROW or span.is_code


def bounds(span: Span, offset: int) -> tuple[int, int]:
    """Return the bounds of the row, the line or the sentence around an offset."""
    return (0, len(span.text)) if is_line(span) else span.bounds(offset)


def pairs(reading: Reading, span: Span) -> Iterator[Pair]:
    """Yield the pairs of a part: each term with the last names before it, and with the first one behind it."""
    said = {name: each for each in said_of_fields(span) for name in each.names}
    terms = span.sentence.within(0, len(span.text), "FP")
    names = [at for at, term in terms if at in said or _is_name(span, term)]
    names = [at for at in names if not (is_data(span) and _is_key(span, at))]
    names = [at for at in names if not _OF_A_DEVICE.search(span.text, max(at - 12, 0), at)]
    known: dict[int, tuple[About, bool] | None] = {}
    for at, _ in span.sentence.within(0, len(span.text), ATOMS) if names else ():
        low, high = bounds(span, at)
        for name, side, several in _in_reach(span, names, said, (low, high), at):
            if name not in known:
                known[name] = field_at(reading, span, name)
            if (found := known[name]) is not None:
                yield Pair(span, name, found[0], at, low, high, side, several, found[1], name not in said)


def _is_key(span: Span, at: int) -> bool:
    """Return whether a name is the key of a value in data that describe another field: "lat: {type: int32}"."""
    written = span.sentence.term(at).written
    return written in _KEYS and _COLON.match(span.text, at + 1) is not None


def _is_name(span: Span, term: Term) -> bool:
    """Return whether an everyday word that is the name of a field may be one here."""
    return term.letter == "P" and not span.is_code and len(term.written) >= _SHORT


def _in_reach(
    span: Span, names: list[int], said: dict[int, Said], sentence: tuple[int, int], at: int
) -> Iterator[tuple[int, str, int]]:
    """Yield the names that a term may be said of, with their side and how many they are together."""
    low, high = sentence
    before = [name for name in names if low <= name < at]
    behind = next((name for name in names if at < name < high), None)
    if before:
        last = said.get(before[-1])
        group = [name for name in before if last is not None and said.get(name) is last] or before[-1:]
        yield from ((name, "before", len(group)) for name in group)
    if behind is not None:
        yield behind, "behind", 1
    if not before and behind is None and not is_line(span):
        start, _ = span.bounds(max(low - 2, 0))
        earlier = [name for name in names if start <= name < low]
        yield from ((name, "sentence before", 1) for name in earlier[-1:])


def whole_number(term: Term) -> int | None:
    """Return the whole number that a term is."""
    value = number(term)
    return int(value) if isinstance(value, int | Fraction) and value == int(value) else None


def field_at(reading: Reading, span: Span, offset: int) -> tuple[About, bool] | None:
    """Return the field whose name stands at an offset, and whether nothing but the name ties it to its message."""
    found = about(reading, span, offset)
    if found is not None:
        return found, False
    value = span.sentence.term(offset).value
    assert isinstance(value, NamedField)
    holders = [reading.messages[name] for name in dict.fromkeys(name for _, name in reading.sightings)]
    fields = [(message, field) for message in holders if (field := message.field(value.name)) is not None]
    if not fields:
        return None
    message, first = fields[0]
    return About(message, first, tuple(field for _, field in fields), is_sure=False), True
