"""The modules of the user's code, as far as they lie in the folder of the project: classes, and what they set."""

import os
from collections.abc import Iterable

from codegen.diagnostics import Report
from codegen.load.defined_names import DefinedNames, defined_names
from codegen.load.files import Files
from codegen.load.state_stores import state_stores
from codegen.model.spec.driver import DriverModule, StateStore
from codegen.model.spec.source import SourceSpec
from codegen.source import Place


def driver_module(path: str, text: str) -> DriverModule:
    """Return what a module defines that is a file of the project."""
    found: DefinedNames = defined_names(text)
    return DriverModule(path, None if found.is_open else found.names, found.classes, found.shapes, found.fault)


def user_modules(
    sources: Iterable[SourceSpec], app: str | None, specification: str, files: Files
) -> dict[str, DriverModule]:
    """Return by their names the module ``app``, and those of sensors that say ``class: MODULE.CLASS``.

    ``specification`` is the folder of the specification, and that of the project is the one above. One that is not
    there is left out: it can lie on the board, and deploying tells where it does not. Their texts change nothing of
    what is generated, so that they are no inputs of it.
    """
    found = {}
    for name in sorted(_named(sources, app)):
        read = _read(name, specification, files)
        if read is not None:
            found[name] = driver_module(*read)
    return found


def stores_of(
    sources: Iterable[SourceSpec], app: str | None, specification: str, files: Files
) -> tuple[StateStore, ...]:
    """Return what the module ``app``, those of sensors, and what these import in the project's folder set in the state.

    The specification is that of :func:`user_modules`.
    """
    waiting = sorted(_named(sources, app))
    seen: set[str] = set()
    found: list[StateStore] = []
    for name in waiting:  # it grows
        read = None if name in seen else _read(name, specification, files)
        seen.add(name)
        if read is None:
            continue
        path, text = read
        stores = state_stores(text)
        found += [
            StateStore(each.component, each.attribute, Place(path, each.line, each.column)) for each in stores.stored
        ]
        waiting += sorted(stores.imported - seen)
    return tuple(found)


def _named(sources: Iterable[SourceSpec], app: str | None) -> set[str]:
    """Return the names of the module ``app``, and of those in which classes of the user read sensors."""
    return {app or "", *(getattr(source, "class_name", "").rpartition(".")[0] for source in sources)} - {""}


def _read(name: str, specification: str, files: Files) -> tuple[str, str] | None:
    """Return path and text of a module that lies in the folder of the project; None of another one."""
    below = os.path.join(os.path.dirname(specification), *name.split("."))
    path = next((each for each in (f"{below}.py", os.path.join(below, "__init__.py")) if files.is_file(each)), None)
    if path is None or files.is_in_tree(path) != files.is_in_tree(specification):
        return None
    data = files.read_bytes(path, Report())
    return None if data is None else (path, data.decode("utf-8-sig", "replace"))  # Python says what is wrong with it
