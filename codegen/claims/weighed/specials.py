"""Numbers in the reach of a field beside words that its description has for another one: "zero for end of log"."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.parts.span import is_data
from codegen.claims.rules import SENTINEL
from codegen.claims.statements.fields import number
from codegen.claims.statements.values.special import Special, content, is_value, specials
from codegen.claims.weighed.clauses import clause
from codegen.claims.weighed.comparison import Comparison, traits
from codegen.claims.weighed.pairs import Pair
from codegen.pattern import pattern

_NO_VALUE = pattern(r" ?(?:[-+*/%U]|\.\.|to N|hz\b|bytes?\b|times\b|elements\b|N\b)")
_NO_VALUE_BEFORE = pattern(
    r"(?:[<>*/+#\[]|\.\.|N to|\b(?:param|bit|version|id|than|above|below|over|under|least|most|about|until|every)) ?$"
)
_LEAST = 3
"""The least length of a word that tells a meaning."""


def of_special(pair: Pair, value: int | float | Fraction) -> Iterator[Comparison]:
    """Yield what a number would mean, where the field has another one for that."""
    field = pair.one.field
    if field.definition.enum or _NO_VALUE.match(pair.behind(12)) or _NO_VALUE_BEFORE.search(pair.before(12)):
        return
    known = specials(field.definition.description)
    if not known:
        return
    low, high = clause(pair.span.text, pair.at, pair.low, pair.high)
    if is_data(pair.span) or (pair.span.is_code and not pair.span.is_comment):
        return
    own = content(field.name.replace("_", " "))
    near, said = (content(pair.span.source_text(*bounds)) - own for bounds in ((low, high), (pair.low, pair.high)))
    scores = {each: len((_long(each) - own) & near) + len((_long(each) - own) & said) / 2 for each in known}
    best = max(known, key=lambda each: scores[each])
    if not scores[best] or sum(score == scores[best] for score in scores.values()) > 1:
        return
    words = _long(best) - own
    others = {float(other) for other in _values(pair)}
    if best.value in others or not (words & near or words <= said):
        return  # the right value stands there as well, or nothing near the number says what it means
    of_others = {each.value for other in pair.fields for each in specials(other.definition.description)}
    is_right = is_value(best, float(value))
    found = traits(
        all_words=words <= near,
        several_words=len(words & near) > 1,
        in_clause=words & near,
        one_word_in_all=len(words) == 1,
        value_of_another=float(value) in of_others,
        zero=value == 0,
        small=0 < float(value) < _SMALL,
        several_numbers=others,
        few_known=len(known) == 1,
    )
    text = f'{pair.one.name}: for "{best.told}" it is {best.written}, not {pair.term.written}'
    yield Comparison("special", SENTINEL, is_right, text, found)


_SMALL = 10


def _long(special: Special) -> frozenset[str]:
    return frozenset(word for word in special.words if len(word) >= _LEAST)


def _values(pair: Pair) -> Iterator[int | float | Fraction]:
    """Yield the other numbers of the sentence."""
    for offset, term in pair.span.sentence.within(pair.low, pair.high, "NS"):
        value = number(term)
        if offset != pair.at and value is not None:
            yield value
