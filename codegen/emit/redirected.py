"""Imports from where names are once modules are bundled."""

import ast
from collections.abc import Iterator, Mapping
from io import StringIO

from codegen.emit.private_names import read_module, sources_of
from codegen.frozen import dataclass


@dataclass(frozen=True, slots=True)
class Places:
    """The places of modules that are part of bundles, by their names.

    ``bundles`` has the bundle of each, ``names`` what is called how in it, ``numbers`` what has no name there, as it is
    written.
    """

    bundles: Mapping[str, str]
    names: Mapping[str, Mapping[str, str]]
    numbers: Mapping[str, Mapping[str, str]]


def redirected(text: str, places: Places) -> str:
    """Return the text of a module that is part of no bundle with imports from bundles; each line stays where it is."""
    lines = list(StringIO(text))
    for node in read_module(text).nodes:
        if isinstance(node, (ast.Import, ast.ImportFrom)) and any(
            source in places.bundles for source in sources_of(node)
        ):
            first, last = node.lineno - 1, (node.end_lineno or node.lineno) - 1
            before = lines[first].encode()[: node.col_offset].decode()
            after = lines[last].encode()[node.end_col_offset :].decode()
            written = "; ".join(ast.unparse(each) for each in import_from(node, places))
            lines[first : last + 1] = [f"{before}{written}{after}", *["\n"] * (last - first)]
    return "".join(lines)


class Redirection(ast.NodeTransformer):
    """Does the same to a syntax tree."""

    def __init__(self, places: Places) -> None:
        """Take over where modules are."""
        self._places = places

    def visit_Import(self, node: ast.Import) -> list[ast.stmt]:
        return list(import_from(node, self._places))

    def visit_ImportFrom(self, node: ast.ImportFrom) -> list[ast.stmt]:
        return list(import_from(node, self._places))


def import_from(node: ast.Import | ast.ImportFrom, places: Places) -> Iterator[ast.stmt]:
    """Yield the statements that do what an import does."""
    for each, source in zip(node.names, sources_of(node), strict=True):
        name = each.asname or each.name
        wanted = "" if isinstance(node, ast.Import) else each.name
        if wanted in places.numbers.get(source, {}):
            yield from ast.parse(f"{name} = {places.numbers[source][wanted]}").body
        elif source in places.bundles:
            yield import_of(places.bundles[source], places.names[source][wanted] if wanted else "", name)
        else:
            yield type(node)(**{**vars(node), "names": [each]})


def import_of(source: str, wanted: str, name: str) -> ast.stmt:
    """Return the statement that imports a module, or a name from it, and calls it so."""
    asname = None if name == (wanted or source) else name
    if not wanted:
        return ast.Import([ast.alias(source, asname)])
    return ast.ImportFrom(source, [ast.alias(wanted, asname)], 0)
