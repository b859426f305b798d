"""Rows in which a field stands behind what is said of it: "| with unknown track it holds 36100 | `direction` |".

A cell of words is said of the only field of its row. A cell that is data, a name, a type or a unit, stands for the
other side of a mapping and is said of nothing here.
"""

from collections.abc import Iterator

from codegen.claims.parts.led import led_by
from codegen.claims.parts.sentence import Sentence, Term
from codegen.claims.ruled_out import is_own_column
from codegen.pattern import pattern

_ALONE = pattern(r"\s*(?:M ?)?F(?: ?[,/&] ?F| and F)*\s*")
_WORD = pattern(r"[a-z]{2,}")
_FEWEST = 4
"""Words of a cell that is a sentence."""


def said_before(sentence: Sentence, heads: tuple[str, ...]) -> Iterator[Sentence]:
    """Yield the cells of words before the cell of the only field of a row, each with the field's name before it."""
    cells = list(_cells(sentence.marked))
    named = [index for index, (low, high) in enumerate(cells) if _ALONE.fullmatch(sentence.marked, low, high)]
    if len(named) != 1:
        return
    names: list[Term] = [term for _, term in sentence.within(*cells[named[0]], "F")]
    for index, (low, high) in enumerate(cells[: named[0]]):
        text = sentence.marked[low:high]
        is_own = index < len(heads) and is_own_column(heads[index])
        if len(_WORD.findall(text)) >= _FEWEST and not set(text) & set("FME") and not is_own:
            yield led_by(names, part_of(sentence, low, high))


def _cells(text: str) -> Iterator[tuple[int, int]]:
    start = text.index("|") + 1 if text.lstrip().startswith("|") else 0
    for cell in text[start:].rstrip("| ").split("|"):
        yield start, start + len(cell)
        start += len(cell) + 1


def part_of(sentence: Sentence, low: int, high: int) -> Sentence:
    """Return a part of a text as a text of its own."""
    while low < high and sentence.marked[low] == " ":
        low += 1
    terms = {offset - low: term for offset, term in sentence.terms.items() if low <= offset < high}
    return Sentence(sentence.marked[low:high].rstrip(), sentence.at[low:high], terms, tuple(terms))
