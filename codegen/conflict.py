"""Conflicts that git has left open in a text: both sides between lines of <<<<<<<, ======= and >>>>>>>."""

import re

from codegen.pattern import pattern

_CONFLICT = pattern(
    r"^<<<<<<< [^\n]*\n(?P<ours>.*?)(?:^\|{7}[^\n]*\n.*?)?^={7}\r?\n(?P<theirs>.*?)^>{7} [^\n]*\n?",
    re.MULTILINE | re.DOTALL,
    needs="<<<<<<< ",
)


def line_of_conflict(text: str) -> int | None:
    """Return the line, from 1 on, at which the first conflict begins; None where there is none."""
    found = _CONFLICT.search(text)
    return text.count("\n", 0, found.start()) + 1 if found else None


def sides_of_conflicts(text: str) -> tuple[str, str]:
    """Return a text with our side of each conflict, and with theirs."""
    return _CONFLICT.sub(r"\g<ours>", text), _CONFLICT.sub(r"\g<theirs>", text)
