"""Which numbers of worked examples nothing computes: those that can be changed without any finding."""

import re
from collections.abc import Container, Iterator

from codegen.claims import check_claims
from codegen.claims.reading import Reading, read_document
from codegen.claims.worked import check as check_examples
from codegen.claims.worked.amount import Amount, amounts
from codegen.claims.worked.examples import Examples, read_examples
from codegen.frozen import dataclass
from codegen.load.prose import Passage, PassageKind
from codegen.source import Place

_EXAMPLE = re.compile(r"\bfor example\b|\be\.g\.|\d[^|.;=]{0,60} [=\u2248] [^|.;=]{0,20}\d", re.IGNORECASE)
_CHECKS = (check_examples, check_claims)


@dataclass(frozen=True, slots=True)
class Number:
    """A number of a worked example; ``found`` are the places that are reported when its last digit is another one."""

    passage: Passage
    amount: Amount
    found: tuple[Place, ...]

    @property
    def place(self) -> Place:
        """Where it stands."""
        return self.passage.place_at(self.amount.start)

    @property
    def is_computed(self) -> bool:
        """Whether a change of it is noticed."""
        return bool(self.found)


def numbers(text: str, reading: Reading) -> Iterator[Number]:
    """Every number of the worked examples of a document, in its order, each changed by one in its last digit.

    ``text`` is that of the document. The checks of worked examples are asked first, all others where these say nothing.
    """
    lines = text.split("\n")
    known = {(each.place, each.message) for check in _CHECKS for each in check(reading)}
    for passage, amount in sorted(_amounts(read_examples(reading)), key=lambda each: each[0].place_at(each[1].start)):
        place = passage.place_at(amount.start)
        line = lines[place.line - 1]
        start, end = place.column - 1, place.column - 1 + len(amount.written)
        if line[start:end] != amount.written:
            continue  # written with an escape
        changed = f"{line[:start]}{changed_number(amount)}{line[end:]}"
        other = "\n".join([*lines[: place.line - 1], changed, *lines[place.line :]])
        read = read_document(other, reading.prose.path, reading.reference)
        yield Number(passage, amount, _new(read, known))


def _new(reading: Reading, known: Container[tuple[Place, str]]) -> tuple[Place, ...]:
    """Where a document has findings that are not known."""
    for check in _CHECKS:
        found = [each.place for each in check(reading) if (each.place, each.message) not in known]
        if found:
            return tuple(found)
    return ()


def changed_number(amount: Amount) -> str:
    """The number with one more at its last digit."""
    written = amount.written
    if "x" in written.lower():
        return f"0x{int(written, 16) + 1:0{len(written) - 2}X}"
    base, power, exponent = written.partition("^")
    if power:
        return f"{base}^{int(exponent) + 1}"
    more = amount.value + (amount.last if amount.value >= 0 else -amount.last)
    return f"{float(more):.{amount.places}f}" if amount.places else str(int(more))


def _amounts(examples: Examples) -> Iterator[tuple[Passage, Amount]]:
    """The numbers below headings for examples, and those of sentences elsewhere that give one or have an equation."""
    held = {id(passage) for passage in examples.texts}
    for passage in examples.texts:
        yield from ((passage, amount) for amount in amounts(passage.text))
    held |= {id(row.passage) for table in examples.tables for row in (table.head, *table.rows)}
    for passage in examples.reading.prose.passages:
        if id(passage) not in held and passage.kind is not PassageKind.HEADING:
            spans = dict.fromkeys(passage.sentence(*found.span()) for found in _EXAMPLE.finditer(passage.text))
            yield from ((passage, amount) for span in spans for amount in amounts(passage.text, *span))
    for table in examples.tables:
        for row in (table.head, *table.rows):
            for entry in row.entries:
                yield from ((row.passage, amount) for amount in entry.amounts)
