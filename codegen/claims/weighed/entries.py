"""Numbers beside words for entries of a field's enum."""

from collections.abc import Iterator

from codegen.claims.reading import Reading
from codegen.claims.rules import ENTRY_VALUE
from codegen.claims.statements.meaning import meaning
from codegen.claims.weighed.clauses import clause
from codegen.claims.weighed.comparison import Comparison, traits
from codegen.claims.weighed.pairs import Pair
from codegen.model.dialect.dialect import EnumDefinition, EnumEntry
from codegen.pattern import pattern

_NO_VALUE = pattern(
    r"(?:\b(?:than|above|below|over|under|least|most|about|until|version|param|except|but|not) |[<>\u2264\u2265+*/x-] ?"
    r"|\.\.|\[)$"
)
_ONE_OF_SEVERAL = pattern(r"N,? (?:and|or) $")
_AND_MORE = pattern(r",? (?:and|or) N")
_BIT = pattern(r"\bbits? (?:number )?$")
_BITS = 63
_SAID = "PUVTC"
"""The letters of terms whose words tell of an entry."""


def of_entry(reading: Reading, pair: Pair, value: int) -> Iterator[Comparison]:
    """Yield what the words of the clause of a number say of it: behind it, before it, or all of them."""
    enum = reading.enums.get(pair.one.field.definition.enum or "")
    if enum is None or _NO_VALUE.search(pair.before(14)):
        return
    if _ONE_OF_SEVERAL.search(pair.before(8)) or _AND_MORE.match(pair.behind(8)):
        return  # "3 and 4 for taking off and landing": which is which, only the order tells
    low, high = clause(pair.span.text, pair.at, pair.low, pair.high)
    is_bit = _BIT.search(pair.before(12)) is not None and 0 <= value < _BITS
    sides = {"words behind": (pair.at + 1, high), "words before": (low, pair.at), "words around": (low, high)}
    for side, (start, end) in sides.items():
        words = _words(pair, start, end)
        if is_bit and (_meant(enum, 1 << value, words) is None or meaning(enum).is_named(1 << value, words)):
            return
        entry = _meant(enum, value, words)
        if entry is not None and "FLAG" in enum.name and value & entry.value:
            return  # a sum of flags with that one
        if entry is not None:
            text = f"{pair.one.name}: {entry.name} is {entry.value}, not {pair.term.written}"
            found = traits(
                by_its_name=meaning(enum).meant_otherwise(value, words) is not None,
                bit=is_bit,
                flags="FLAG" in enum.name,
                entries=any(pair.span.sentence.within(low, high, "V")),
                several=len([*pair.span.sentence.within(low, high, "NQ")]) > 1,
            )
            yield Comparison("enum", ENTRY_VALUE, is_right=False, text=text, traits=(side, *found))
            return
        if meaning(enum).is_named(value, words):
            yield Comparison("enum", ENTRY_VALUE, is_right=True)
            return


def _meant(enum: EnumDefinition, value: int, words: str) -> EnumEntry | None:
    return meaning(enum).meant_otherwise(value, words) or meaning(enum).marked_otherwise(value, words)


def _words(pair: Pair, low: int, high: int) -> str:
    terms, text = pair.span.sentence.terms, pair.span.text
    return "".join(
        text[at] if at not in terms else f" {terms[at].written} " if terms[at].letter in _SAID else " "
        for at in range(low, high)
    )
