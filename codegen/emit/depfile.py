"""The prerequisites of a target as a depfile, which make includes and ninja reads."""

import re
from collections.abc import Iterable

_SPECIAL = re.compile(r"(\\*)([ #:])")
_LINE_BREAKS = "\n\r\v\f"


def depfile_text(target: str, prerequisites: Iterable[str]) -> str:
    """One rule without a recipe, and an empty rule for each prerequisite, so that make goes on when one is removed.

    Blanks, ``#`` and colons are escaped with a backslash (those before them are doubled), ``$`` is doubled. Make takes
    ``a=b`` at the begin of a line, or right behind the target, for a variable: such paths come last and have no rule
    of their own. A path that cannot be written, since it has a line break or ends in a backslash, is left out.
    """
    names = sorted({name for name in prerequisites if is_writable(name)}, key=lambda name: ("=" in name, name))
    lines = [" \\\n  ".join([f"{_escaped(target)}:", *map(_escaped, names)])]
    lines.extend(f"{_escaped(name)}:" for name in names if "=" not in name and name != target)
    return "\n".join(lines) + "\n"


def is_writable(name: str) -> bool:
    """Return whether make and ninja have a way of writing a path."""
    return not any(one in name for one in _LINE_BREAKS) and not name.endswith("\\")


def _escaped(name: str) -> str:
    return _SPECIAL.sub(r"\1\1\\\2", name.replace("$", "$$"))
