"""Fingerprints of findings, which stay the same wherever their lines move to: waivers name them."""

import hashlib
import os

from codegen.pattern import pattern

LENGTH = 12
"""Hex digits of a fingerprint: 48 bits, more than any project has findings for."""

_MARKUP = pattern(r"[*`~\\]")
_UNDERSCORES = pattern(r"(?<!\w)_+|_+(?!\w)")  # those within a name stay
_HEXADECIMAL = pattern(r"0[xX][0-9a-fA-F]+")


def fingerprint(rule_id: str, file: str, text: str) -> str:
    """The fingerprint of what a rule finds in ``text``, the words that the finding is about.

    Of ``file`` only the name counts, so that a folder can be renamed; lines do not count at all. ``text`` is taken
    without marks of emphasis and code, with single spaces and with hexadecimal numbers in lower case. The same words
    found twice in one file have one fingerprint: whoever waives a claim waives it wherever the file repeats it.
    """
    stated = f"{rule_id}\n{os.path.basename(file)}\n{normalised(text)}"
    return hashlib.sha256(stated.encode("utf-8", "surrogatepass")).hexdigest()[:LENGTH]


def normalised(text: str) -> str:
    """``text`` as a fingerprint takes it."""
    bare = _UNDERSCORES.sub("", _MARKUP.sub("", text))
    return " ".join(_HEXADECIMAL.sub(lambda found: found[0].lower(), bare).split())
