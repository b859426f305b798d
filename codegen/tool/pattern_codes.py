"""The codes that regular expressions were compiled to, kept between runs: a check after an edit takes a tenth less.

``re`` makes a list of numbers of an expression, for the matcher of the interpreter, which checks such a list before it
takes one. They are kept under the version of Python. How to get and to give them is no public part of ``re``: where
anything is not as in Python 3.11 to 3.14, an expression is compiled as ever.
"""

import re
import sys
from array import array
from functools import cache
from importlib import import_module
from typing import Any, cast

from codegen.tool.cache import cache_folder, entry, keep_object, kept_object

Code = tuple[int, bytes, int, dict[str, int], tuple[str | None, ...]]
"""Flags, numbers of the matcher, number of groups, numbers of groups by name, and names by number."""

FEWEST = 16
"""So many new ones are worth that all are written again."""
MOST = 4000
"""With more, those of former versions of codegen are the most."""

_new: dict[tuple[str, int], Code] = {}


def compiled(expression: str, flags: int) -> "re.Pattern[str]":
    """Return what ``re.compile(expression, flags)`` returns, or raise what it raises."""
    matcher = _matcher() if cache_folder() is not None else None
    if matcher is None:
        return re.compile(expression, flags)
    key = (expression, int(flags))
    code = _kept().get(key)
    try:
        if code is None:
            code = _new[key] = _code_of(expression, int(flags))
        numbers = array("I", code[1]).tolist()
        return cast("re.Pattern[str]", matcher.compile(expression, code[0], numbers, code[2], code[3], code[4]))
    except Exception:  # a wrong expression, or whatever another ``re`` says to what it does not know
        _new.pop(key, None)
        return re.compile(expression, flags)


def keep_new_codes() -> None:
    """Put what was compiled in this run to what is kept, where it is worth it: in place of the entry that was there."""
    if len(_new) >= FEWEST:
        known = _kept()
        keep_object(_name(), {**known, **_new} if len(known) + len(_new) <= MOST else dict(_new))
        _new.clear()
        _kept.cache_clear()


def _code_of(expression: str, flags: int) -> Code:
    parser, compiler = import_module("re._parser"), import_module("re._compiler")
    parsed = parser.parse(expression, flags)
    numbers = array("I", compiler._code(parsed, flags))
    state = parsed.state
    names: list[str | None] = [None] * state.groups
    for name, number in state.groupdict.items():
        names[number] = name
    return flags | state.flags, numbers.tobytes(), state.groups - 1, dict(state.groupdict), tuple(names)


@cache
def _kept() -> dict[tuple[str, int], Code]:
    known = kept_object(_name())
    return known if isinstance(known, dict) else {}


@cache
def _matcher() -> Any:
    """Return the module with the matcher; None where its codes have another form."""
    found = sys.modules.get("_sre")
    return found if getattr(found, "CODESIZE", None) == array("I").itemsize else None


def _name() -> str:
    return entry("patterns", sys.version, str(getattr(_matcher(), "MAGIC", "")))
