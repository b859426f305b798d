"""Checks of the resolved system: one module each, a pure function from the system to its findings.

A module with a function ``check`` that lies here is run; nothing lists it.
"""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic
from codegen.model.system import System
from codegen.rules.checks import checks_in


def check_system(system: System) -> Iterator[Diagnostic]:
    """Yield what the rules find, in the order of their names."""
    for check in checks_in(__name__):
        yield from check(system)
