"""Imports straight from where names are made: modules that only pass names on take heap, and nobody asks for them."""

import ast
from collections.abc import Iterator, Mapping
from io import StringIO

from codegen.emit.private_names import read_module, walked


def direct(texts: Mapping[str, str]) -> dict[str, str]:
    """Return modules, by their names, that import from others of them past those that consist of one import.

    What is passed by stays as it is, for who imports it from elsewhere.
    """
    trees = {name: read_module(text).tree for name, text in texts.items()}
    passed = {name: source for name, tree in trees.items() if (source := _source(tree)) in trees}
    return {name: _written(text, trees[name], passed) for name, text in texts.items()}


def _source(tree: ast.Module) -> str | None:
    """Return the module from which another one imports, under the same names, all that it consists of."""
    statements = tree.body[1:] if ast.get_docstring(tree) is not None else tree.body
    only = statements[0] if len(statements) == 1 else None
    if isinstance(only, ast.ImportFrom) and all(each.asname is None and each.name != "*" for each in only.names):
        return only.module
    return None


def _written(text: str, tree: ast.Module, passed: Mapping[str, str]) -> str:
    lines = list(StringIO(text))
    for row, old, new in _changes(tree, passed):
        lines[row - 1] = lines[row - 1].replace(old, new, 1)
    return "".join(lines)


def _changes(tree: ast.Module, passed: Mapping[str, str]) -> Iterator[tuple[int, str, str]]:
    """Yield numbers of lines with what is there instead of what."""
    for node in walked(tree):
        if isinstance(node, ast.ImportFrom) and node.module is not None and node.module in passed:
            yield node.lineno, f"from {node.module} ", f"from {_made(node.module, passed)} "
        elif isinstance(node, ast.Import):
            for each in node.names:
                if each.name in passed:
                    old = ast.unparse(each)
                    yield each.lineno, old, f"{_made(each.name, passed)} as {each.asname or each.name}"


def _made(name: str, passed: Mapping[str, str]) -> str:
    return _made(passed[name], passed) if name in passed else name
