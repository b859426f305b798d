"""Numbers that are said to be several flags of a field together: "`flags` = 514, which is A and B"."""

from collections.abc import Iterator

from codegen.claims.enum_names import flags
from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import ENTRY_VALUE, as_sure
from codegen.claims.statements.fields import number
from codegen.diagnostics import Diagnostic
from codegen.pattern import pattern

_FLAG = r"V(?: ?\(N\))?"
_JOIN = r"(?: ?(?:\||\+|,|&|and|plus|with|or)+ ?)+"
_FLAGS = rf"(?P<flags>{_FLAG}(?:{_JOIN}{_FLAG}){{1,8}})"
_SUM = (
    pattern(rf"(?P<sum>N)(?: ?\(N\))?(?:,? ?(?:=|which is|that is|i\.e\.|is|means|:|\(|for|from))+ ?(?:the )?{_FLAGS}"),
    pattern(rf"{_FLAGS} ?(?:together|in total|,)? ?(?:=|is|are|gives?|makes?|add up to|sum to|i\.e\.) ?(?P<sum>N)\b"),
)
_MORE = pattern(r" ?(?:\||\+|,|&|and|plus|with) ?(?:[A-Z]|others?|more|some|the)|\.\.\.|[ ,]*(?:etc|among)")
_LESS = pattern(r"\b(?:not|except|without|but|minus|unless|instead|if|old|wrong)\b|[-+*|&~/<>] ?$")


_VALUE_OF_FIRST = pattern(r"\bN (?:is|=|means|stands for) ?$")


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every sum of flags that is not the number beside it."""
    for form in _SUM:
        for found in form.finditer(span.text):
            low, _ = span.bounds(found.start())
            before = span.text[max(low, found.start() - 30) : found.start()]
            if _MORE.match(span.text, found.end()) or _LESS.search(before) or "or" in found["flags"]:
                continue
            names = [str(term.value) for _, term in span.sentence.within(*found.span("flags"), "V")]
            by_name = flags(reading.enums)
            value = number(span.sentence.term(found.start("sum")))
            enums = {by_name[name][0].name for name in names if name in by_name}
            if value is None or len(enums) != 1 or any(name not in by_name for name in names):
                continue
            total = 0
            for name in names:
                total |= by_name[name][1]
            if form is _SUM[1] and value == by_name[names[-1]][1] and _VALUE_OF_FIRST.search(before):
                continue  # "1024 is A and B is 32768"
            if total != value:
                written = span.sentence.term(found.start("sum")).written
                text = f"{' | '.join(names)} is {total}, not {written}"
                rule = as_sure(ENTRY_VALUE, is_sure=True)
                yield reading.found(rule, span.place(found.start("sum")), f"{' '.join(names)} {written}", text)
