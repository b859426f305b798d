"""All statements of a document about other things than fields that it names, each with how many others agree."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence

from codegen.claims.parts.span import Span
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.weighed.blocks import numbered_blocks
from codegen.claims.weighed.entities.described_entries import described_entries
from codegen.claims.weighed.entities.extensions import of_extensions
from codegen.claims.weighed.entities.lengths import lengths
from codegen.claims.weighed.entities.meanings import meant
from codegen.claims.weighed.entities.messages import of_messages
from codegen.claims.weighed.entities.parameters import of_parameters
from codegen.claims.weighed.entities.statement import Statement
from codegen.claims.weighed.entities.strange_messages import strange_messages
from codegen.claims.weighed.entities.unnamed import unnamed
from codegen.claims.weighed.entities.ways import ways

_READ: Sequence[tuple[Callable[[Reading, Span], Iterator[Statement]], str]] = (
    (of_messages, "N"),
    (described_entries, "N"),
    (meant, "N"),
    (of_extensions, "FP"),
    (unnamed, "UTNS"),
    (of_parameters, ""),
    (strange_messages, "C"),
    (lengths, "N"),
    (ways, ""),
)
"""The readers of the statements of a part, each with the letters of which the part has to have one."""


def statements(reading: Reading) -> Iterator[tuple[Statement, int, int]]:
    """Yield what is wrong if it is said, with how many of its kind agree with the dialect, and how many do not.

    Counted are places in the same list, table or block of code, about the same group of things.
    """
    found: list[tuple[int, Statement]] = []
    for block, span in numbered_blocks(spans(reading)):
        found_letters = {term.letter for term in span.sentence.terms.values()}
        for read, letters in _READ:
            if not letters or not found_letters.isdisjoint(letters):
                found.extend((block, each) for each in read(reading, span))
    places: dict[tuple[int, str, str, bool], set[object]] = defaultdict(set)
    for block, each in found:
        places[block, each.kind, each.group, each.is_right].add((id(each.span), each.at))
    for block, each in found:
        if not each.is_right:
            agreeing, differing = (
                places.get((block, each.kind, each.group, is_right), ()) for is_right in (True, False)
            )
            yield each, len(agreeing), len(differing)
