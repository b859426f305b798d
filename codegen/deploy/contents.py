"""Modules of the user that belong to a program: its code, its sources, and what these import of the project."""

import ast
import os
from collections.abc import Iterable, Iterator, Mapping

from codegen.deploy.findings import NAME_TWICE
from codegen.deploy.plan import MAIN
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.system import System
from codegen.source import Place


def own_modules(system: System, folder: str, generated: Iterable[str], report: Report) -> dict[str, str]:
    """The texts of the modules in ``folder`` that the program imports, by their paths on the board.

    ``generated`` are the names of the files that codegen makes: one that is the user's, too, is a finding.
    """
    made = {name.partition(".")[0] for name in generated}
    files: dict[str, str] = {}
    waiting = list(_first(system, "main" in made))
    for name in waiting:  # it grows while modules are read that import others
        for path in _files_of(name, folder):
            absolute = os.path.join(folder, path)
            if path.removesuffix(".py") in made:
                report.add(NAME_TWICE, Place(absolute), f"{path} is a generated module, too", "rename yours")
                continue
            text = DISK.read_text(absolute, report)
            if text is not None:
                files[path.replace(os.sep, "/")] = text
                waiting += [each for each in _imported(text) if each not in waiting]
    return files


def missing_modules(system: System, files: Mapping[str, object], on_board: Iterable[str]) -> list[tuple[Place, str]]:
    """The modules of sources that are neither among ``files`` nor on the board, with the places that name them."""
    there = {path.partition("/")[0].partition(".")[0] for path in (*files, *(_in_library(path) for path in on_board))}
    sources = system.sources.values()
    return [
        (each.polling.spec.at("class"), each.imported)
        for each in sources
        if each.imported and each.imported.partition(".")[0] not in there
    ]


def _in_library(path: str) -> str:
    return path.removeprefix("lib/")


def _first(system: System, has_main: bool) -> Iterator[str]:
    """Yield what the generated modules import of the user's; without a program the user's own main.py."""
    if system.program is not None:
        yield system.program.module
    if not has_main:
        yield MAIN.removesuffix(".py")
    for source in system.sources.values():
        if source.imported:
            yield source.imported.partition(".")[0]
        for text in source.own_modules.values():
            yield from _imported(text)


def _files_of(name: str, folder: str) -> Iterator[str]:
    """The paths below ``folder`` of a module, or of all modules of a package."""
    package = os.path.join(folder, name)
    if os.path.isfile(os.path.join(package, "__init__.py")):
        for parent, below, names in os.walk(package):
            below[:] = sorted(each for each in below if each != "__pycache__")
            yield from (
                os.path.relpath(os.path.join(parent, each), folder) for each in sorted(names) if each[-3:] == ".py"
            )
    elif os.path.isfile(f"{package}.py"):
        yield f"{name}.py"


def _imported(text: str) -> list[str]:
    """The first names of all that a module imports, anywhere in it; nothing of one that Python cannot read."""
    try:
        tree = ast.parse(text)
    except SyntaxError:  # MicroPython's compiler says what is wrong with it
        return []
    names: list[str] = []
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names += [alias.name.partition(".")[0] for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            names.append(node.module.partition(".")[0])
    return list(dict.fromkeys(names))
