"""Short names for arguments that nobody gives by name, for MicroPython keeps the name of each argument.

Functions share them with each other and with what is private to modules: every one of them may have a ``_0``.
"""

import ast
from collections.abc import Collection, Iterable, Iterator, Mapping
from itertools import count
from symtable import Function, SymbolTable, symtable

from codegen.emit.private_names import Module, docstrings, read_module, walked, words
from codegen.emit.renaming import renamed
from codegen.frozen import dataclass

_FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


@dataclass(frozen=True, slots=True)
class _Outer:
    """A function that is in no other one: its first and its last line, and new names in it."""

    first: int
    last: int
    names: Mapping[str, str]


def with_short_arguments(texts: Mapping[str, str], others: Iterable[str]) -> dict[str, str]:
    """Return modules, by their names, whose arguments have short names; ``others`` are the program's other modules.

    An argument that is given by name anywhere in the program keeps its name.
    """
    every = (*texts.values(), *others)
    given = {name for text in every for name in _given(text)}
    if any(_gives_by_text(text) for text in every):
        given |= {name for text in every for name in _texts(text) if name.isidentifier()}
    return {name: _written(text, given) for name, text in texts.items()}


def _written(text: str, given: Collection[str]) -> str:
    names_of = {
        line: outer.names for outer in _outer_functions(text, given) for line in range(outer.first, outer.last + 1)
    }
    return renamed(text, lambda line: names_of.get(line, {}), attributes=False)


def _given(text: str) -> Iterator[str]:
    """Yield the names that calls in a module give to arguments; by ``**`` it may give what its texts have."""
    module = _read(text)
    if module is None:
        yield from words(text)
        return
    yield from (node.arg for node in module.nodes if isinstance(node, ast.keyword) and node.arg)
    if _gives_by_text(text):
        yield from (word for each in _texts(text) for word in words(each))


def _gives_by_text(text: str) -> bool:
    module = _read(text)
    return module is not None and any(isinstance(node, ast.keyword) and node.arg is None for node in module.nodes)


def _texts(text: str) -> Iterator[str]:
    module = _read(text)
    nodes = module.nodes if module is not None else ()
    docs = docstrings(nodes)
    for node in nodes:
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docs:
            yield node.value


def _read(text: str) -> Module | None:
    """Return a module, None of a text that is none, or one for a newer Python."""
    try:
        return read_module(text)
    except SyntaxError:
        return None


def _outer_functions(text: str, given: Collection[str]) -> Iterator[_Outer]:
    module = read_module(text)
    nodes = {(node.name, node.lineno): node for node in module.nodes if isinstance(node, _FUNCTIONS)}
    for table in _outer_tables(symtable(text, "module", "exec")):
        node = nodes.get((table.get_name(), table.get_lineno()))
        names = sorted(_arguments(node).difference(given, _fixed(node, table))) if node is not None else []
        if node is not None and names:
            taken = {each for inner in _within(table) for each in inner.get_identifiers()}
            free = (f"_{number}" for number in count() if f"_{number}" not in taken)
            yield _Outer(node.lineno, node.end_lineno or node.lineno, dict(zip(names, free, strict=False)))


def _outer_tables(table: SymbolTable) -> Iterator[Function]:
    for inner in table.get_children():
        if isinstance(inner, Function):
            yield inner
        elif inner.get_type() == "class":
            yield from _outer_tables(inner)


def _within(table: SymbolTable) -> Iterator[SymbolTable]:
    yield table
    for inner in table.get_children():
        yield from _within(inner)


def _arguments(function: ast.AST) -> set[str]:
    """Return the names of arguments that can be given by their places, but for self."""
    found = (node.args for node in walked(function) if isinstance(node, (*_FUNCTIONS, ast.Lambda)))
    return {each.arg for args in found for each in (*args.posonlyargs, *args.args)} - {"self"}


def _fixed(function: ast.FunctionDef | ast.AsyncFunctionDef, table: Function) -> set[str]:
    """Return the names in a function that are not its own alone."""
    found = set[str]()
    for inner in _within(table):
        is_class = inner.get_type() == "class"
        found.update(each.get_name() for each in inner.get_symbols() if is_class or each.is_global())
    outside = (*function.decorator_list, *function.args.defaults, *filter(None, function.args.kw_defaults))
    found.update(node.id for each in outside for node in walked(each) if isinstance(node, ast.Name))
    for text in (node for node in walked(function) if isinstance(node, ast.JoinedStr)):
        parts = (node.value for node in walked(text) if isinstance(node, ast.Constant))
        found.update(word for part in parts if isinstance(part, str) for word in words(part))
    return found
