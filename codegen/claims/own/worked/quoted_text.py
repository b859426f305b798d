"""Lengths of texts that a document quotes, and of messages that carry them."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.own.worked.examples import Examples, Statement
from codegen.claims.own.worked.sizes import is_v1, text_start
from codegen.diagnostics import Diagnostic
from codegen.model.price import HEAD_V2
from codegen.pattern import pattern

_LENGTH = pattern(r"\blength of ", re.IGNORECASE)
_CHARACTERS = pattern(r"\bcharacters\b")
_CARRIED = pattern(r"\bframe with that text\b", re.IGNORECASE)


def check(examples: Examples) -> Iterator[Diagnostic]:
    """ "Length of `text` | 34 characters", and "NAME frame with that text, v2 | 47 bytes" below it."""
    quoted: str | None = None
    for statement in examples.statements:
        value = statement.value.alone
        if value is None:
            continue
        if _LENGTH.search(statement.label.text) and _CHARACTERS.search(statement.value.text):
            quoted = _code(statement)
            if quoted is not None:
                yield from examples.judged(
                    statement.passage, value, [Fraction(len(quoted))], f'the length of "{quoted}"'
                )
        elif quoted is not None and _CARRIED.search(statement.label.text) and not is_v1(statement.label.text):
            named = examples.reading.named(statement.passage)
            start = text_start(named[0]) if len(named) == 1 else None
            if start is not None:
                size = Fraction(HEAD_V2 + start + len(quoted.encode()))
                yield from examples.judged(statement.passage, value, [size], f'{named[0].name} with "{quoted}"')


def _code(statement: Statement) -> str | None:
    """The one code span of a label."""
    end = statement.label.start + len(statement.label.text)
    spans = [statement.passage.text[low:high] for low, high in statement.passage.codes if low < end]
    return spans[0] if len(spans) == 1 else None
