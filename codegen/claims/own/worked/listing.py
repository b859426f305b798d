"""Numbers of worked examples that nothing computes: they can be changed without any finding."""

import re
from collections.abc import Container, Iterator
from dataclasses import replace

from codegen.claims import check_claims
from codegen.claims.own.worked import check as check_examples
from codegen.claims.own.worked.amount import Amount, amounts
from codegen.claims.own.worked.examples import Examples, read_examples
from codegen.claims.reading import Reading, read_document, read_parts
from codegen.frozen import dataclass
from codegen.load.prose import Passage, PassageKind
from codegen.pattern import pattern
from codegen.source import Place

_EXAMPLE = pattern(r"\bfor example\b|\be\.g\.|\d[^|.;=]{0,60} [=\u2248] [^|.;=]{0,20}\d", re.IGNORECASE)
_CHECKS = (check_examples, check_claims)


@dataclass(frozen=True, slots=True)
class Number:
    """A number of a worked example; ``found`` are the places that are reported for each other number in its place."""

    passage: Passage
    amount: Amount
    found: tuple[tuple[Place, ...], ...]

    @property
    def place(self) -> Place:
        """Return the place of the number in its document."""
        return self.passage.place_at(self.amount.start)

    @property
    def is_computed(self) -> bool:
        """Return whether each change of the number gives a finding."""
        return all(self.found)


def numbers(text: str, reading: Reading) -> Iterator[Number]:
    """Every number of the worked examples of a document, in its order, with what is found for others in its place.

    Those are one more and one less at its last digit. ``text`` is that of the document. The checks of worked examples
    are asked first, all others where these say nothing.
    """
    lines = text.split("\n")
    known = {(each.place, each.message) for check in _CHECKS for each in check(reading)}
    for passage, amount in sorted(_amounts(read_examples(reading)), key=lambda each: each[0].place_at(each[1].start)):
        place = passage.place_at(amount.start)
        line = lines[place.line - 1]
        start, end = place.column - 1, place.column - 1 + len(amount.written)
        if line[start:end] != amount.written:
            continue  # written with an escape
        found = []
        for changed in changed_numbers(amount):
            other = [*lines[: place.line - 1], f"{line[:start]}{changed}{line[end:]}", *lines[place.line :]]
            found.append(_new(_read("\n".join(other), reading, passage, amount, changed), known, place.line))
            if not found[-1]:
                break
        yield Number(passage, amount, tuple(found))


def _read(text: str, reading: Reading, passage: Passage, amount: Amount, changed: str) -> Reading:
    """The document with another number in a passage.

    One that is as long changes nothing but that passage, so that the Markdown need not be read again.
    """
    if len(changed) != len(amount.written) or not any(part is passage for part in reading.prose.parts):
        return read_document(text, reading.prose.path, reading.reference)
    written = passage.text
    other = replace(passage, text=f"{written[: amount.start]}{changed}{written[amount.start + len(changed) :]}")
    parts = tuple(other if part is passage else part for part in reading.prose.parts)
    return read_parts(text, replace(reading.prose, parts=parts), reading.reference)


def _new(reading: Reading, known: Container[tuple[Place, str]], line: int) -> tuple[Place, ...]:
    """Return where a document has findings that are not known: worked examples are about all of it, statements about
    what is below the heading of the line that was changed.
    """
    for check, read in ((check_examples, reading), (check_claims, _section(reading, line))):
        found = [each.place for each in check(read) if (each.place, each.message) not in known]
        if found:
            return tuple(found)
    return ()


def _section(reading: Reading, line: int) -> Reading:
    """Return a document without what stands below other headings than a line does."""
    parts = reading.prose.parts
    headings = {
        at: part.place_at(0).line
        for at, part in enumerate(parts)
        if isinstance(part, Passage) and part.kind is PassageKind.HEADING
    }
    start = max((at for at, above in headings.items() if above <= line), default=0)
    end = min((at for at in headings if at > start), default=len(parts))
    near = tuple(part for at, part in enumerate(parts) if start <= at < end or at in headings)
    return replace(reading, prose=replace(reading.prose, parts=near))


def changed_numbers(amount: Amount) -> tuple[str, ...]:
    """The number with one more and one less at its last digit; of 0 only one more."""
    written = amount.written
    if "x" in written.lower():
        return tuple(f"0x{each:0{len(written) - 2}X}" for each in _beside(int(written, 16)))
    base, power, exponent = written.partition("^")
    if power:
        return tuple(f"{base}^{each}" for each in _beside(int(exponent)))
    sign = "-" if amount.value < 0 else ""
    digits = int(abs(amount.value) / amount.last)
    return tuple(f"{sign}{float(each * amount.last):.{amount.places}f}" for each in _beside(digits))


def _beside(number: int) -> tuple[int, ...]:
    return (number + 1, number - 1) if number else (1,)


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
            yield from ((row.passage, amount) for amount in amounts(row.passage.text))
