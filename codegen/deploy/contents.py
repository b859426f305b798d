"""Modules of the user that belong to a program: its code, its sources, and what these import of the project."""

import os
from collections.abc import Iterable, Iterator, Mapping

from codegen.deploy.findings import NAME_TWICE
from codegen.deploy.imports import imports_of
from codegen.deploy.plan import MAIN
from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.load.files import DISK
from codegen.model.system import System
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class Contents:
    """The files of a board by path, compiled, and the texts of their modules: generated ones, and the user's own.

    ``folder`` is that of the project, in which the user's own lie.
    """

    files: Mapping[str, str | bytes]
    made: Mapping[str, str]
    own: Mapping[str, str]
    folder: str


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


def missing_modules(system: System, names: Iterable[str]) -> list[tuple[Place, str]]:
    """The modules of sources that are not among ``names``, which can be imported, with the places that name them."""
    there = set(names)
    sources = system.sources.values()
    return [
        (each.polling.spec.at("class"), each.imported)
        for each in sources
        if each.imported and each.imported.partition(".")[0] not in there
    ]


def module_names(paths: Iterable[str]) -> frozenset[str]:
    """The first names by which the modules at some ``paths`` are imported: of modules, and of folders."""
    tops = ((path.partition("/")[0], "/" in path) for path in paths)
    return frozenset(
        top if is_folder else top.rpartition(".")[0] if top.endswith((".py", ".mpy")) else top
        for top, is_folder in tops
        if is_folder or "." not in top or top.endswith((".py", ".mpy"))
    )


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
    """The first names of all that a module imports, anywhere in it."""
    return list(dict.fromkeys(each.module.partition(".")[0] for each in imports_of(text)))
