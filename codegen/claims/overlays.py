"""Passages that say of which overlay they speak: their claims are compared with the dialect that has that one."""

import re
from collections.abc import Collection, Iterable

from codegen.load.prose import Prose


def lines_about(prose: Prose, overlays: Iterable[str], others: Collection[str]) -> dict[str, frozenset[int]]:
    """By overlay of ``others`` the lines of the passages that name it, and no further one.

    ``overlays`` are those in use. Who names several says nothing about one of them: that is compared as all the rest.
    """
    found: dict[str, set[int]] = {}
    names = sorted({*overlays, *others}, key=len, reverse=True)
    if not others:
        return {}
    pattern = re.compile(rf"(?<![\w./-])(?:{'|'.join(re.escape(name) for name in names)})(?![\w/-])")
    for passage in prose.passages:
        named = set(pattern.findall(passage.text))
        if len(named) == 1 and named <= set(others):
            found.setdefault(named.pop(), set()).update(place.line for _, place in passage.anchors)
    return {name: frozenset(lines) for name, lines in found.items()}
