"""Leaves out what extends the sign of a word: boards read words of 32 bits with their signs, hosts of 64 without.

Machine code for both has ``(word ^ sign) - sign``, which on a board changes nothing, and takes room and time.
"""

import re

_OF_HOSTS = ("x64",)
_EXTENDED = re.compile(r"\((\w+\[(?:[^][\n]|\[[^][\n]*\])*\]) \^ sign\) - sign\b")


def with_signs_of_words(text: str, architecture: str) -> str:
    """Return the text of a generated module for an architecture of mpy-cross."""
    return text if architecture in _OF_HOSTS else _EXTENDED.sub(r"\1", text)
