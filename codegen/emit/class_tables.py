"""Lets classes do without what MicroPython notes in each, two names that nothing generated asks for.

A table of names has room for 2, 4, 6, 8 ... of them, and is never made smaller: these two go before others come.
"""

import ast
from io import StringIO

from codegen.emit.private_names import read_module


def with_small_classes(text: str) -> str:
    """Return the text of a module whose classes have the names alone that stand in them."""
    lines = list(StringIO(text))
    classes = (node for node in read_module(text).nodes if isinstance(node, ast.ClassDef))
    for node in sorted(classes, key=lambda each: -each.lineno):
        body = node.body[0]
        first = min(each.lineno for each in (body, *getattr(body, "decorator_list", ())))
        if first > node.lineno:
            lines.insert(first - 1, f"{' ' * body.col_offset}del __module__, __qualname__\n")
    return "".join(lines)
