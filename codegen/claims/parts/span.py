"""A part of a document in which statements stand: its terms, and the messages that it may be about."""

import re
from bisect import bisect_left
from collections.abc import Callable, Iterator
from functools import lru_cache

from codegen.claims.parts.sentence import NamedField, Sentence
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.once import once
from codegen.pattern import pattern
from codegen.source import Place

DATA = ("json", "json5", "jsonc", "yaml", "yml", "toml")
_BREAK = pattern(
    r"(?<!\be\.g)(?<!\bi\.e)(?<!\bca)(?<!\bno)(?<!\bapprox)(?<!\bmax)(?<!\bmin)(?<!\bresp)(?<!\bincl)[.!?;](?=\s|$)"
)
_GOES_ON = pattern(r"\s*(?:it|its|they|their|that|this|the unit|unit|units|unknown|the value|in U|U\b|[NS] )\b")
_DEFINED = pattern(r"[FP](?:,? (?:and )?[FP])* : ")
"""A definition list, which is a paragraph for Markdown."""
_COMPARED = pattern(
    r"\b(?:unlike|as in|like in|as with|as for|like|than in|compared (?:to|with)|in contrast to|instead of|not in"
    r"|(?:unlike|not|than|instead of|besides) the [TU] (?:of|in|from)"
    r"|here,? (?:but |and |while |whereas )?(?:[a-z]+ |[NTU] ){0,3}in) (?:the )?$|\((?:but |while )?in (?:the )?$"
)
_WINDOW = 400
"""The greatest distance from a place to either end of its sentence, in characters."""


@lru_cache(maxsize=16)
def _ends(text: str) -> tuple[int, ...]:
    """Return the offsets at which the sentences of a text end."""
    return tuple(found.start() for found in _BREAK.finditer(text))


@dataclass(frozen=True, slots=True)
class Topic:
    """The messages that the surroundings of a part name, each group with the nearest one first."""

    above: tuple[WireMessage, ...]
    headings: tuple[WireMessage, ...]
    earlier: tuple[WireMessage, ...]
    document: tuple[WireMessage, ...]

    @property
    def around(self) -> tuple[WireMessage, ...]:
        """Return the messages of all groups, each once, the nearest first."""
        found = (*self.above, *self.headings, *self.earlier)
        return tuple({message.name: message for message in reversed(found)}.values())[::-1]


@dataclass(frozen=True, slots=True)
class Span:
    """A passage, a line of code or a block of data: its terms, and the messages that it may be about.

    ``kind`` is that of a passage; ``language`` is that of a block of code, else empty.
    """

    sentence: Sentence
    kind: PassageKind
    topic: Topic
    place_at: Callable[[int], Place]
    language: str = ""
    is_code: bool = False
    is_comment: bool = False
    heads: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """The short text with the terms as capital letters."""
        return self.sentence.marked

    def place(self, offset: int) -> Place:
        """The place of a character of the short text."""
        return self.place_at(self.sentence.source(offset))

    def bounds(self, offset: int) -> tuple[int, int]:
        """The sentence around a character of the short text; not farther than a window."""
        ends = _ends(self.text)
        place = bisect_left(ends, offset)
        low = ends[place - 1] + 1 if place else 0
        high = ends[place] if place < len(ends) else len(self.text)
        return max(low, offset - _WINDOW), min(high, offset + _WINDOW)

    def end_of(self, offset: int) -> int:
        """Return the offset at which a statement ends: that of its sentence, or of the sentences that continue it."""
        _, high = self.bounds(offset)
        is_row = self.kind is PassageKind.ROW or self.is_code
        if not is_row and self._has_other_subject(offset):
            return high
        if is_row or self.kind is PassageKind.ITEM or _DEFINED.match(self.text):
            return len(self.text)
        while high < len(self.text) and _GOES_ON.match(self.text, high + 1):
            _, high = self.bounds(high + 1)
        return high

    def _has_other_subject(self, offset: int) -> bool:
        """Return whether the sentence around a name has another field as its subject, which later pronouns mean."""
        low, _ = self.bounds(offset)
        first = next((at for at, _ in self.sentence.within(low, offset, "F")), None)
        is_same = first is None or re.fullmatch(
            r"[F ,/&+]|F(?:(?:, | and | or | to | ?[/&+] ?)F)*", self.text[first:offset]
        )
        return not is_same and pattern(r"[^a-zA-Z]*(?:the )?F").match(self.text[low:offset]) is not None

    def source_text(self, low: int, high: int) -> str:
        """The words of the source that a part of the short text stands for."""
        terms = self.sentence.terms
        return "".join(terms[at].written if at in terms else self.text[at] for at in range(low, high))

    def named(self, low: int, high: int) -> Iterator[tuple[int, str]]:
        """The messages that are named between two characters, with their offsets; none of a comparison."""
        return (each for each in _named(self.sentence) if low <= each[0] < high)


@once
def _named(sentence: Sentence) -> tuple[tuple[int, str], ...]:
    """The messages that a text names, with their offsets; none of a comparison."""
    found = []
    for offset, term in sentence.within(0, len(sentence.marked), "MF"):
        value = term.value
        name = value.message if isinstance(value, NamedField) else value
        if isinstance(name, str) and not is_compared(sentence.marked, offset):
            found.append((offset, name))
    return tuple(found)


def is_compared(text: str, offset: int) -> bool:
    """Return whether the words before a name, in small letters, only compare with it: "unlike NAME"."""
    return _COMPARED.search(text, max(offset - _LEAD, 0), offset) is not None


_LEAD = 24
"""Characters before a name in which such words stand."""


def is_data(span: Span) -> bool:
    """Return whether a part is a block of JSON or YAML."""
    return span.language in DATA


def head_of(span: Span, offset: int) -> str:
    """The heading of the column in which a character of a row stands."""
    column = span.text.count("|", 0, offset) - span.text.lstrip().startswith("|")
    return span.heads[column] if column < len(span.heads) else ""
