"""The clauses of a sentence."""

from codegen.pattern import pattern

_BREAK = pattern(
    r"[,;:()|\u00b7\u2022]|\s[-\u2013\u2014]\s|\.(?=\s|$)|\b(?:but|while|whereas|and|which|because|so that|although)\b"
)


def clause(text: str, at: int, low: int, high: int) -> tuple[int, int]:
    """Return the bounds of the clause around an offset, in a sentence between two."""
    before = max((found.end() for found in _BREAK.finditer(text, low, at)), default=low)
    behind = _BREAK.search(text, at + 1, high)
    return before, behind.start() if behind is not None else high
