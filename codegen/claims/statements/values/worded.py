"""Values of enums in clauses that have a word of another entry: "when armed, `base_mode` has bit 64 set".

``entries`` reads a value and the words beside it. Here a whole clause is what tells of the value, and one word that
only one entry has in its name is enough, where the entry with that value has none of the clause's words.
"""

from collections.abc import Collection, Iterator

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, DENIED, MISTAKEN, OWN, PAST, REPLACED, SHOWN, SUPPOSED, words
from codegen.claims.rules import ENTRY_VALUE, as_sure
from codegen.claims.statements.fields import number, said_of_fields
from codegen.claims.statements.meaning import meaning
from codegen.claims.statements.subjects import About, about
from codegen.diagnostics import Diagnostic
from codegen.pattern import pattern
from codegen.source import Place

_RULED_OUT = words(
    DENIED, REPLACED, PAST, OWN[:3], MISTAKEN, ASKED, SHOWN, SUPPOSED,
    r"\bunless\b", r"\bother\b", r"\bversion\b", r"\buntil\b", r"\bbefore\b", r"\bafter\b", r"\bthan\b", r"\bcheck\b",
    r"\btest\b", r"\bexcept\b", r"\bignor", r"\bonly\b", r"\bcan(?:not)?\b",
)  # fmt: skip
_IS_VALUE = pattern(
    r"(?:[FP] ?(?:[:=|]|(?:is|has|to|of|with|becomes?|shall|must|be|have|will|set|the|value|bit) ?)*"
    r"|\b(?:bit|value) )N(?![\w.]\d| ?(?:bytes?|bits|hz|%|[-+*/]|to N|or N|and N))"
)


def check(reading: Reading, span: Span, known: Collection[Place]) -> Iterator[Diagnostic]:
    """Every such value of a sentence or a row with one field and one number, but for those ``known`` to be wrong."""
    if span.is_code:
        return
    for said in said_of_fields(span):
        one = about(reading, span, said.names[-1])
        low, high = _clause(span, said.start, said.until)
        numbers = [*span.sentence.within(low, high, "NQSVUT")]
        if one is None or len(numbers) != 1 or len([*span.sentence.within(low, high, "FM")]) > _MOST:
            continue
        at, term = numbers[0]
        if term.letter != "N" or span.place(at) in known or not _IS_VALUE.search(span.text, low, at + 1):
            continue
        yield from _compared(reading, span, one, at, (low, high))


_MOST = 2
"""A clause with more names tells of more than one thing."""


def _clause(span: Span, start: int, until: int) -> tuple[int, int]:
    """The cell, or the sentence around a name, up to a colon behind it."""
    low, high = span.bounds(start)
    low = max(low, span.text.rfind("|", low, start) + 1)
    ends = (span.text.find(mark, until, high) for mark in "|:")
    return low, min((end for end in ends if end >= 0), default=high)


def _compared(reading: Reading, span: Span, one: About, at: int, bounds: tuple[int, int]) -> Iterator[Diagnostic]:
    enum = reading.enums.get(one.field.definition.enum or "")
    value = number(span.sentence.term(at))
    low, high = bounds
    if enum is None or value is None or value != int(value) or _RULED_OUT.search(span.text, low, high):
        return
    told = "".join(
        span.text[offset] if offset not in span.sentence.terms or span.text[offset] == "N" else _written(span, offset)
        for offset in range(low, high)
    )
    is_bit = span.text[max(at - 4, 0) : at] == "bit "
    values = {int(value), 1 << int(value)} if is_bit and 0 <= value < _BITS else {int(value)}
    meant = [meaning(enum).marked_otherwise(each, told) for each in values]
    if meant and None not in meant and meant[0] is not None and meant[0].value not in values:
        written = span.sentence.term(at).written
        text = f"{one.name}: {meant[0].name} is {meant[0].value}, not {written}"
        yield reading.found(as_sure(ENTRY_VALUE, is_sure=False), span.place(at), f"{one.name} {written} worded", text)


_BITS = 64


def _written(span: Span, offset: int) -> str:
    """The words of a term; nothing of a name, which says nothing of a value."""
    term = span.sentence.terms[offset]
    return term.written.lower() if term.letter in "PU" else " "
