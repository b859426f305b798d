"""A sentence as a short text with its terms, and what terms stand for."""

from bisect import bisect_left
from collections.abc import Collection, Iterator, Mapping

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import EnumDefinition, WireMessage


@dataclass(frozen=True, slots=True)
class Term:
    """One term: its letter, what it stands for, its text, and where it stands in the source text."""

    letter: str
    value: object
    written: str
    start: int
    end: int
    is_quoted: bool = False


@dataclass(frozen=True, slots=True)
class NamedField:
    """A name of a field, and the message that is named with it, ``MESSAGE.field``."""

    name: str
    message: str | None = None
    elements: int | None = None


@dataclass(frozen=True, slots=True)
class StatedType:
    """A type: ``bits`` and ``sign`` (u, i, f, or None where it is not said), ``name`` as in XML, ``length``."""

    name: str | None
    bits: int
    sign: str | None
    length: int | None = None


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """The names that are terms in a document."""

    messages: Mapping[str, WireMessage]
    enums: Mapping[str, EnumDefinition]
    entries: Collection[str]
    fields: frozenset[str]


@dataclass(frozen=True, slots=True)
class Sentence:
    """A text with its terms: ``marked`` is the short text, ``at`` the offset in the source of each character."""

    marked: str
    at: tuple[int, ...]
    terms: Mapping[int, Term]
    offsets: tuple[int, ...]

    def term(self, offset: int) -> Term:
        """The term whose letter stands at an offset of ``marked``."""
        return self.terms[offset]

    def within(self, start: int, end: int, letters: str) -> Iterator[tuple[int, Term]]:
        """The terms with one of some letters between two offsets of ``marked``, each with its offset."""
        marked, offsets = self.marked, self.offsets
        for offset in offsets[bisect_left(offsets, start) : bisect_left(offsets, end)]:
            if marked[offset] in letters:
                yield offset, self.terms[offset]

    def plain(self) -> "Sentence":
        """The same without words that are names of fields: where only messages are spoken of, they are words."""
        if "P" not in self.marked:
            return self
        marked: list[str] = []
        at: list[int] = []
        terms: dict[int, Term] = {}
        for offset, letter in enumerate(self.marked):
            term = self.terms.get(offset)
            if term is not None and letter == "P":
                marked += term.written.lower()
                at += range(term.start, term.start + len(term.written))
                continue
            if term is not None:
                terms[len(marked)] = term
            marked.append(letter)
            at.append(self.at[offset])
        return Sentence("".join(marked), tuple(at), terms, tuple(terms))

    def source(self, offset: int) -> int:
        """The offset in the source of a character of ``marked``."""
        return self.at[min(offset, len(self.at) - 1)] if self.at else 0
