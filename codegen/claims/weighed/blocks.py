"""The lists, tables and blocks of code of a document, which have a number each."""

from collections.abc import Iterable, Iterator

from codegen.claims.parts.span import Span
from codegen.load.prose import PassageKind


def numbered_blocks(parts: Iterable[Span]) -> Iterator[tuple[int, Span]]:
    """Yield each part with the number of the block that it is in: a heading or a text begins the next one."""
    block, last = 0, None
    for span in parts:
        is_text = span.kind is PassageKind.TEXT and not span.is_code
        block += span.kind is PassageKind.HEADING or (is_text and last is not PassageKind.TEXT)
        last = span.kind
        yield block, span
