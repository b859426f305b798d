"""Puts the names that a module uses most at the begin of its table of names.

In compiled code the number of one of the first 128 names takes a byte, that of each further one two. The table has
names in the order in which the compiler meets them: an expression before everything else, which is never evaluated,
tells it. What is at the top level of a module is freed once it has run.
"""

import ast
from collections import Counter
from collections.abc import Collection, Iterator

from codegen.emit.global_names import seen_in
from codegen.emit.private_names import constant_of, read_module

_SHORT = 127


def with_frequent_names_first(text: str) -> str:
    """Return the text of a module; one with few names stays as it is."""
    module = read_module(text)
    if len(module.names) <= _SHORT:
        return text
    seen = seen_in(module.tree)
    looked_up = seen.used - {constant_of(node) for node in module.nodes} - seen.own
    counted = Counter(name for node in module.nodes for name in _used(node, looked_up))
    if len(counted) <= _SHORT:
        return text
    first = [name for name, _ in counted.most_common(_SHORT)]
    return f"__name__ or {'.'.join(first)}\n{text}"


def _used(node: ast.AST, looked_up: Collection[str]) -> Iterator[str]:
    """Yield the names whose numbers are in the code of a node, functions' own among them."""
    if isinstance(node, ast.Attribute):
        yield node.attr
    elif isinstance(node, ast.Name) and node.id in looked_up:
        yield node.id
    elif isinstance(node, (ast.arg, ast.keyword)) and node.arg:
        yield node.arg
