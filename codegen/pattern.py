"""Regular expressions that are compiled when a text is first searched in which they may be found.

To compile one takes longer than to search a document with it. Codegen has hundreds of them, most for phrases that are
rare: a run needs few. What they are compiled to is kept for later runs.
"""

import re
from functools import cache, partial
from typing import Any, cast

from codegen.tool.pattern_codes import compiled

_SEARCHES = ("findall", "finditer", "fullmatch", "match", "search")
_ATTRIBUTES = (*_SEARCHES, "flags", "groupindex", "groups", "pattern", "split", "sub", "subn")


@cache
def pattern(expression: str, flags: int = 0, *, needs: str = "") -> "re.Pattern[str]":
    """Return what stands for ``re.compile(expression, flags)``, and compiles it when it is first asked for something.

    A text in which it is found has one of the words that it ``needs``: until a text has one, nothing is compiled. "|"
    stands between them; where flags say that case does not matter, they are in small letters. What is wrong with an
    expression is told late, as ``re.error``. The ``re`` of a match is the compiled pattern, not what this returns.
    """
    return cast("re.Pattern[str]", _Pattern(expression, flags, needs))


class _Pattern:
    """An expression, and once it is compiled, the methods and attributes of what it has become."""

    __slots__ = ("_expression", "_flags", "_words", *_ATTRIBUTES)

    def __init__(self, expression: str, flags: int, needs: str) -> None:
        self._expression = expression
        self._flags = flags
        self._words = needs.split("|") if needs else []

    def __getattr__(self, name: str) -> Any:
        """Return what ``name`` is of the compiled pattern. Python asks here as long as its slot is empty."""
        if name not in _ATTRIBUTES:
            raise AttributeError(name)
        return partial(self._searched, name) if self._words and name in _SEARCHES else getattr(self._compiled(), name)

    def _searched(self, method: str, text: str, *bounds: int) -> Any:
        """Return what a method finds in a text; it is not asked where the text has none of the words."""
        searched = text.casefold() if self._flags & re.IGNORECASE else text
        for word in self._words:
            if word in searched:
                return getattr(self._compiled(), method)(text, *bounds)
        return iter(()) if method == "finditer" else [] if method == "findall" else None

    def _compiled(self) -> "re.Pattern[str]":
        """Return the compiled pattern, of which this one has the attributes from now on."""
        found = compiled(self._expression, self._flags)
        for name in _ATTRIBUTES:
            setattr(self, name, getattr(found, name))
        return found
