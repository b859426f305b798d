"""The module of the user's code, as far as it lies in the folder of the project, and its class."""

import os
from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, did_you_mean
from codegen.model.system import System
from codegen.source import Place

RULE = Rule(
    "unfit-code",
    "The module that code in vehicle.yaml names is no Python, has no class of that name, or one that is not derived "
    "from Vehicle. The board would find that out when it starts: it runs without your code, says so, and cannot be "
    "armed. Correct the module, or name the class that is meant.",
    remedy="write class NAME(Vehicle) in the module, or name another one: code in vehicle.yaml",
)


def check(system: System) -> Iterator[Diagnostic]:
    """The module of the program; one that is not in the project can lie on the board, and deploying asks for it."""
    program = system.program
    module = system.spec.user_modules.get(program.module) if program else None
    if program is None or module is None:
        return
    file, name = os.path.basename(module.path), program.class_name
    named = program.spec.code.at("class") if program.spec.code else program.spec.place
    if module.fault is not None:
        line, what = module.fault
        hint = f"python -m py_compile {file} says more"
        yield Diagnostic(Place(module.path, line), RULE, f"{file} is no Python: {what}", hint)
    elif module.names is not None and name not in module.names:
        hint = did_you_mean(name, module.classes) or f"write class {name}(Vehicle) in {file}"
        related = ((Place(module.path), "the module is here"),)
        yield Diagnostic(named, RULE, f"{file} has no class {name}", hint, related)
    elif name in module.shapes and not module.shapes[name].is_open:  # then it has no base but those of the module
        place = Place(module.path, module.shapes[name].line)
        message = f"{name} is not derived from Vehicle"
        yield Diagnostic(place, RULE, message, f"from vehicle import Vehicle, and class {name}(Vehicle)")
