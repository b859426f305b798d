"""The imports of a program's modules that lead nowhere on a board."""

import os
from collections.abc import Container, Iterator

from codegen.deploy.built_in import ANYWHERE
from codegen.deploy.contents import Contents, missing_modules, module_names
from codegen.deploy.findings import MISSING_IMPORT, NO_CODE, NO_MODULE, OTHER_BOARD, UNCERTAIN_IMPORT
from codegen.deploy.imports import Import, needed_imports
from codegen.deploy.plan import MAIN
from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.model.system import System
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class Importable:
    """The first names that can be imported on a board beside what is deployed.

    ``is_known``: the board has listed its own modules; without that, ``names`` are those that any MicroPython may have.
    """

    names: frozenset[str]
    is_known: bool


UNKNOWN_BOARD = Importable(ANYWHERE, is_known=False)
"""The names for a board that nobody has asked."""


@dataclass(frozen=True, slots=True)
class _Lost:
    """An import in a module at ``path`` that leads nowhere."""

    path: str
    found: Import


def report_missing(system: System, contents: Contents, board: Importable, place: Place, report: Report) -> None:
    """Report the modules that the program imports and that are nowhere; ``place`` is that of the board."""
    there = board.names | module_names([*contents.made, *contents.own])
    program = system.program
    if program is not None and program.module not in there:
        named = program.spec.code.at("module") if program.spec.code else program.spec.place
        message = f"there is no {program.module}.py: the generated vehicle runs, without code of yours"
        hint = (
            f"write {program.module}.py with a class {program.class_name}(Vehicle), or name yours: code in vehicle.yaml"
        )
        report.add(NO_CODE, named, message, hint)
    for named, module in missing_modules(system, there):
        message = f"there is no {module}.py in the folder of the project, nor on the board"
        report.add(NO_MODULE, named, message, hint=f"put {module}.py there, or mpremote cp {module}.py :")
    for lost in _lost(system, contents, there):
        _report_lost(lost, Place(os.path.join(contents.folder, lost.path)), board, report)
    if board.is_known:
        for path, module in _lacking(contents, there):
            message = f"the MicroPython of this board has no module {module}, which {path} imports"
            report.add(OTHER_BOARD, place, message, "is it the one that you mean?")


def _report_lost(lost: _Lost, file: Place, board: Importable, report: Report) -> None:
    place = Place(file.file, lost.found.line, lost.found.column)
    module = lost.found.module
    where = f"there is no {module}: neither in the folder of the project, nor generated"
    put = f"put it into the folder of the project, or onto the board: mpremote mip install {module.partition('.')[0]}"
    if not board.is_known:
        message = f"{where}, and whether the board has it is not known"
        report.add(UNCERTAIN_IMPORT, place, message, f"{put}; try and except ImportError for what may be missing")
    elif lost.found.is_sure:
        report.add(MISSING_IMPORT, place, f"{where}, nor on the board", put)
    else:
        message = f"{where}, nor on the board; whether this import is run is not known"
        report.add(UNCERTAIN_IMPORT, place, message, f"{put}; try and except ImportError for what may be missing")


def _lost(system: System, contents: Contents, there: frozenset[str]) -> Iterator[_Lost]:
    """Yield the imports that lead nowhere in the modules of the user that the program comes to, each once."""
    drivers = _drivers(system)
    own = {**contents.own, **drivers}

    def is_there(module: str) -> bool:
        first, *below = module.split(".")
        if not below or f"{first}/__init__.py" not in own:
            return first in there
        path = module.replace(".", "/")
        return any(each == f"{path}.py" or each.startswith(f"{path}/") for each in own)

    waiting = [*_begun(system, contents), *((path, True) for path in drivers)]
    known: dict[str, bool] = {}
    lost: dict[tuple[str, str, int, int], _Lost] = {}
    while waiting:
        path, is_sure = waiting.pop()
        if path not in own or known.get(path, False) or (path in known and not is_sure):
            continue
        known[path] = is_sure  # once more where it turns out to be loaded in any case
        package = os.path.dirname(path).replace("/", ".")
        for each in needed_imports(own[path], is_there, package, is_main=path == MAIN):
            sure = each.is_sure and is_sure
            if not is_there(each.module):
                found = Import(each.module, (), each.line, each.column, sure)
                lost[path, each.module, each.line, each.column] = _Lost(path, found)
            waiting += [(below, sure) for below in _loaded(each, own)]
    yield from lost.values()


def _drivers(system: System) -> dict[str, str]:
    """The texts of the project's own drivers, by the paths of their files."""
    return {path: text for source in system.sources.values() for path, text in source.own_modules.items()}


def _begun(system: System, contents: Contents) -> Iterator[tuple[str, bool]]:
    """Yield the paths of the user's modules that generated ones import, and whether these always do."""
    names = [] if system.program is None else [(system.program.module, True)]
    names += [] if MAIN in contents.made else [(MAIN.removesuffix(".py"), True)]
    for source in system.sources.values():
        if source.imported:  # only once the sensor is opened, and without it the program goes on
            names.append((source.imported, False))
    for name, is_sure in names:
        found = Import(name, (), 1, 1, is_sure)
        yield from ((path, is_sure) for path in _loaded(found, contents.own))


def _loaded(found: Import, own: Container[str]) -> Iterator[str]:
    """Yield the paths of the modules that an import loads, packages around them first."""
    parts = found.module.split(".")
    begun = ["/".join(parts[:count]) for count in range(1, len(parts) + 1)]
    names = (*begun, *(f"{begun[-1]}/{each}" for each in found.names))
    yield from (path for name in names for path in (f"{name}/__init__.py", f"{name}.py") if path in own)


def _lacking(contents: Contents, there: frozenset[str]) -> Iterator[tuple[str, str]]:
    """Yield paths of generated modules, each with a module of other MicroPythons that it imports: the first of each."""
    known = set()
    for path, text in contents.made.items():
        found = needed_imports(text, lambda module: module.partition(".")[0] in there) if path.endswith(".py") else []
        for name in (each.module.partition(".")[0] for each in found):
            if name in ANYWHERE - there and name not in known:
                known.add(name)
                yield path, name
