"""Short names for what is private to generated modules, for the table of names takes much of a board's heap.

All modules share them: each has a ``_0``, a ``_1`` and so on of its own. Two names of one scope never become one.
"""

import ast
import re
from collections.abc import Iterable, Iterator, Mapping
from io import StringIO
from itertools import count

from codegen.emit.private_names import Module, constant_of, private_names, read_module, words
from codegen.emit.renaming import renamed
from codegen.frozen import dataclass

TABLE = "short_names.txt"
"""The file beside compiled modules that says what their short names stand for."""

_IN_FUNCTION = re.compile(r'( *File "(\w+)", line \d+, in )(\w+)')


@dataclass(frozen=True, slots=True)
class Shortened:
    """The texts of modules, and what their short names stand for, both by the names of the modules."""

    texts: Mapping[str, str]
    names: Mapping[str, Mapping[str, str]]


def shortened(texts: Mapping[str, str], others: Iterable[str]) -> Shortened:
    """Return modules, by their names, with short names; ``others`` are the texts of the program's other modules.

    Only names are others than before: what is written again from a syntax tree compiles to other instructions.
    """
    others = list(others)
    modules = {name: read_module(text) for name, text in texts.items()}
    taken = {word for text in (*texts.values(), *others) for word in words(text)}
    chosen = _chosen(private_names(modules, others), taken)
    found = {
        name: dict(sorted((chosen[each], each) for each in module.names if each in chosen))
        for name, module in modules.items()
    }
    return Shortened(
        {
            name: renamed(_without_const(texts[name], module), lambda _: chosen, attributes=True)
            for name, module in modules.items()
        },
        found,
    )


def table_of(names: Mapping[str, Mapping[str, str]]) -> str:
    """Return the text of the file of names: a line for each module, ``vehicle _0=_act _1=_check``."""
    return "".join(
        f"{' '.join((module, *(f'{short}={name}' for short, name in stands_for.items())))}\n"
        for module, stands_for in sorted(names.items())
        if stands_for
    )


def read_table(text: str) -> dict[str, dict[str, str]]:
    """Return what short names stand for, by modules, of the text of the file of names."""
    rows = (line.split() for line in text.splitlines())
    return {row[0]: dict(pair.split("=") for pair in row[1:]) for row in rows if row}


def readable(line: str, names: Mapping[str, Mapping[str, str]]) -> str:
    """Return a line of a traceback with the name of its function; every other line as it is."""
    found = _IN_FUNCTION.fullmatch(line)
    return f"{found[1]}{names.get(found[2], {}).get(found[3], found[3])}" if found else line


def _chosen(scopes: Mapping[str, frozenset[str]], taken: set[str]) -> dict[str, str]:
    """Return a short name for each name; two that are in one scope have different ones.

    What is in many scopes comes first: it finds the fewest names that are free in all of them.
    """
    chosen: dict[str, str] = {}
    used: dict[str, set[str]] = {}
    for name in sorted(scopes, key=lambda name: (-len(scopes[name]), name)):
        within = set[str]().union(*(used.get(scope, set()) for scope in scopes[name]))
        short = next(each for each in _numbered() if each not in within and each not in taken)
        chosen[name] = short
        for scope in scopes[name]:
            used.setdefault(scope, set()).add(short)
    return chosen


def _numbered() -> Iterator[str]:
    return (f"_{number}" for number in count())


def _without_const(text: str, module: Module) -> str:
    """Leave out the import of const() where the compiler puts all its numbers in place: nobody calls it."""
    asked = sum(isinstance(node, ast.Name) and node.id == "const" for node in module.nodes)
    if asked != sum(constant_of(node) is not None for node in module.nodes):
        return text
    lines = list(StringIO(text))
    for node in module.tree.body:
        if isinstance(node, ast.ImportFrom) and node.module == "micropython":
            left = [each.name for each in node.names if each.name != "const"]
            written = [f"from micropython import {', '.join(left)}\n"] if left else ["\n"]
            lines[node.lineno - 1 : node.end_lineno] = written + ["\n"] * ((node.end_lineno or 0) - node.lineno)
    return "".join(lines)
