"""Writes other names into the text of a module, and nothing else: what is made of a tree compiles differently."""

import re
from collections.abc import Callable, Mapping
from re import Match

from codegen.emit.private_names import WORD

_TOKEN = re.compile(
    r"""
    (?P<prefix>[rRbBuUfF]{0,2})(?:\"{3}(?:[^\\]|\\.)*?\"{3}|'{3}(?:[^\\]|\\.)*?'{3}|"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*')
    |\#[^\n]*
    |0[xXbBoO]\w+|(?:\d[\d_]*\.?[\d_]*|\.\d[\d_]*)(?:[eE][-+]?[\d_]+)?
    |(?P<dot>\.\s*)?(?P<name>[^\W\d]\w*)
    """,
    re.DOTALL | re.VERBOSE,
)
"""A string, a comment, a number, or a name with the dot before that of an attribute; nothing else has letters."""


def renamed(text: str, names_at: Callable[[int], Mapping[str, str]], *, attributes: bool) -> str:
    """Return a text with other names; ``names_at`` has those for a line, from 1.

    ``attributes`` are names, too, or stay as they are. No string has a name that changes, but where an f-string has an
    expression.
    """
    line, counted = 1, 0

    def new(token: Match[str]) -> str:
        nonlocal line, counted
        prefix, dot, name = token.groups()
        is_formatted = prefix and "f" in prefix.lower()
        if not is_formatted and (name is None or (dot and not attributes)):
            return token[0]
        line += text.count("\n", counted, token.start())
        counted = token.start()
        if is_formatted:
            return _formatted(token[0], names_at(line), attributes=attributes)
        return f"{dot or ''}{names_at(line).get(name, name)}"

    return _TOKEN.sub(new, text)


def _formatted(text: str, names: Mapping[str, str], *, attributes: bool) -> str:
    def new(word: Match[str]) -> str:
        is_attribute = text[word.start() - 1 : word.start()] == "."
        return names.get(word[0], word[0]) if attributes or not is_attribute else word[0]

    return WORD.sub(new, text)
