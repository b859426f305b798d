"""Writes other names into the text of a module, and nothing else: what is made of a tree compiles differently."""

from collections.abc import Callable, Mapping
from io import StringIO
from itertools import accumulate
from re import Match
from token import NAME, STRING
from tokenize import generate_tokens

from codegen.emit.private_names import WORD


def renamed(text: str, names_at: Callable[[tuple[int, int]], Mapping[str, str]], *, attributes: bool) -> str:
    """Return a text with other names; ``names_at`` has those for a place: a line from 1, a column from 0.

    ``attributes`` are names, too, or stay as they are. No string has a name that changes, but where an f-string has an
    expression.
    """
    starts = [0, *accumulate(map(len, StringIO(text)))]
    pieces, end, before = [], 0, ""
    for token in generate_tokens(StringIO(text).readline):
        new = token.string
        if token.type == NAME and (attributes or before != "."):
            new = names_at(token.start).get(new, new)
        elif token.type == STRING and "f" in new.partition(new[-1])[0].lower():
            new = _formatted(new, names_at(token.start), attributes=attributes)
        before = token.string
        if new != token.string:
            start = starts[token.start[0] - 1] + token.start[1]
            pieces += [text[end:start], new]
            end = starts[token.end[0] - 1] + token.end[1]
    return "".join([*pieces, text[end:]])


def _formatted(text: str, names: Mapping[str, str], *, attributes: bool) -> str:
    def new(word: Match[str]) -> str:
        is_attribute = text[word.start() - 1 : word.start()] == "."
        return names.get(word[0], word[0]) if attributes or not is_attribute else word[0]

    return WORD.sub(new, text)
