"""The modules in which classes of the user read sensors, as far as they lie in the folder of the project."""

import os
from collections.abc import Iterable

from codegen.diagnostics import Report
from codegen.load.defined_names import DefinedNames, defined_names
from codegen.load.files import Files
from codegen.model.spec.driver import DriverModule
from codegen.model.spec.source import SourceSpec


def driver_module(path: str, text: str) -> DriverModule:
    """Return what a module defines that is a file of the project."""
    found: DefinedNames = defined_names(text)
    return DriverModule(path, None if found.is_open else found.names, found.classes, found.shapes, found.fault)


def user_modules(sources: Iterable[SourceSpec], specification: str, files: Files) -> dict[str, DriverModule]:
    """Return by their names the modules of sensors that say ``class: MODULE.CLASS``.

    ``specification`` is the folder of the specification, and that of the project is the one above. One that is not
    there is left out: it can lie on the board, and deploying tells where it does not. Their texts change nothing of
    what is generated, so that they are no inputs of it.
    """
    folder = os.path.dirname(specification)
    names = {getattr(source, "class_name", "").rpartition(".")[0] for source in sources} - {""}
    modules = {}
    for name in sorted(names):
        below = os.path.join(folder, *name.split("."))
        path = next((each for each in (f"{below}.py", os.path.join(below, "__init__.py")) if files.is_file(each)), None)
        is_of_project = path is not None and files.is_in_tree(path) == files.is_in_tree(specification)
        text = files.read_text(path, Report()) if path is not None and is_of_project else None
        if path is not None and text is not None:
            modules[name] = driver_module(path, text)
    return modules
