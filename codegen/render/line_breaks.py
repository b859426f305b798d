"""Adds line breaks to the long names of a page: between their words, never inside of one."""

import re

_CODE = r"<!--.*?-->|<(?P<kept>style|script|title|svg|pre)\b.*?</(?P=kept)>|<[^>]*>"
_PARTS = re.compile(rf"(?P<code>{_CODE})|[^<]+", re.DOTALL)
"""Matches markup and elements to be left as they are (``code``), or else a run of text."""
_WORD = re.compile(r"[^\s&]{9,}")
_AFTER = re.compile(r"(?<=[\w\]])(::|[_/:=,]+|[.](?!\d)|(?<=[a-z])(?=[A-Z][a-z]))(?=[\w\[])")
_HYPHENED = re.compile(r"[^\W_]{1,24}-\d+(?:\.\d+)*(?![^\W_])|(?<![\w-])--[a-z][a-z-]{1,20}")


def with_line_breaks(page: str) -> str:
    """Return a page of HTML whose long words may break behind ``_``, ``/``, ``:`` and dots, in any column.

    What has a number behind a hyphen (``FR-00068.3``, ``0-254``) and options (``--format``) stay whole, which browsers
    would break there. Drawings, scripts and what is preformatted stay as they are, as do attributes. A break adds
    nothing to what is copied, found or read aloud.
    """
    return _PARTS.sub(lambda part: part[0] if part["code"] else _text(part[0]), page)


def _text(text: str) -> str:
    broken = _WORD.sub(lambda word: _AFTER.sub(r"\1<wbr>", word[0]), text)
    return _HYPHENED.sub(r'<span class="whole">\g<0></span>', broken) if "-" in broken else broken
