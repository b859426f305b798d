"""Statements about messages, fields and entries, read wherever they stand: sentences, items, rows, comments, data.

``terms`` makes a short text of each part in which names, types, units and numbers are single letters; ``spans`` says
which messages a part may be about; the other modules each know what is said of one kind of thing and compare it.
"""

from collections.abc import Iterator

from codegen.claims.reading import Reading
from codegen.claims.statements import entries, facts, messages, nouns, sizes, tables, types, units, unknown
from codegen.claims.statements.spans import spans
from codegen.diagnostics import Diagnostic


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every statement of a document that the dialect contradicts."""
    parts = spans(reading)
    for span in parts:
        for each in (types, units, unknown, facts, messages, sizes, nouns):
            yield from each.check(reading, span)
        yield from types.sized(reading, span)
    yield from tables.check(reading, parts)
    yield from entries.check(reading, parts)
    yield from entries.constants(reading, parts)
