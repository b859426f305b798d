"""Types in the reach of a field's name."""

from collections.abc import Iterator

from codegen.claims.layout import typed
from codegen.claims.parts.sentence import StatedType
from codegen.claims.rules import TYPE
from codegen.claims.statements.types import ends_other, has_type
from codegen.claims.weighed.comparison import Comparison, traits
from codegen.claims.weighed.pairs import Pair
from codegen.pattern import pattern

_CAST = pattern(r"::|\)[ (]")
_CASTING = pattern(r" as $|::<$|_cast<$")
_LISTED = pattern(r"[,(]\s*$")
_NAMED = pattern(r"(?:\[\])?\s+[A-Za-z_]")
_ENDED = pattern(r"\s*(?:[,.;:)\]|]|$|\*/)")
_NEXT = pattern(r" ?F|(?: \w+){0,2} F")
_ANOTHER = pattern(
    r"\b(?:and|with|without|but|while|where|whereas) (?:the|its|their|two|three|all|other)\b|; (?:the|its|their)\b"
)
_OF_ELSE = pattern(r"\b(?:payload|message|frame|variable|struct|local)\b")
_OWN_TYPES = ("python", "py", "ts", "typescript", "js", "javascript", "tsx", "kotlin", "java", "swift")
"""Languages whose types are not those of the wire."""
_AROUND = 200


def of_type(pair: Pair) -> Iterator[Comparison]:
    """Yield what a type says of a field."""
    stated, field = pair.term.value, pair.one.field
    if not isinstance(stated, StatedType) or (pair.term.written.lower().startswith("float") and field.definition.enum):
        return
    if _is_cast(pair) or _is_of_another(pair):
        return
    if any(has_type(each, stated) for each in pair.fields):
        yield Comparison("type", TYPE, is_right=True)
        return
    if stated.length is not None and not field.is_array:
        return  # so many fields, or another thing
    text = f"{pair.one.name} is {typed(field.definition)}, not {pair.term.written}"
    yield Comparison("type", TYPE, is_right=False, text=text, traits=_traits(pair, stated))


def _is_cast(pair: Pair) -> bool:
    """Return whether code converts something to a type."""
    if not pair.span.is_code or pair.span.is_comment:
        return pair.behind(2) == "::"
    before = pair.before(8)
    is_in_parentheses = before.endswith("(") and pair.behind(1) == ")"
    return is_in_parentheses or _CAST.match(pair.behind(3)) is not None or _CASTING.search(before) is not None


def _is_of_another(pair: Pair) -> bool:
    """Return whether a type in code is of another name: "(long a, float b)", "// `a` comes first, see `b` uint8_t"."""
    if not pair.span.is_code:
        return False
    if pair.span.is_comment:
        return ends_other(pair.span, (pair.name,), pair.at)
    return _LISTED.search(pair.before(8)) is not None and _NAMED.match(pair.behind(8)) is not None


def _traits(pair: Pair, stated: StatedType) -> tuple[str, ...]:
    sentence, at = pair.span.sentence, pair.at
    others = [term for offset, term in sentence.within(pair.low, pair.high, "T") if offset != at]
    around = [term for offset, term in sentence.within(max(at - _AROUND, 0), at + _AROUND, "T") if offset != at]
    return traits(
        another_type=others,
        own_type=any(_is_own(pair, term.value) for term in others),
        own_type_around=any(_is_own(pair, term.value) for term in around),
        in_words=stated.name is None,
        array=stated.length is not None,
        ended=_ENDED.match(pair.span.text, at + 1),
        before_a_name=_NEXT.match(pair.span.text, at + 1),
        of_another=_ANOTHER.search(pair.gap),
        of_else=_OF_ELSE.search(pair.gap),
        own_language=pair.span.language in _OWN_TYPES,
    )


def _is_own(pair: Pair, value: object) -> bool:
    return isinstance(value, StatedType) and any(has_type(each, value) for each in pair.fields)
