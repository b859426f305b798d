"""Checks are found, not listed: each module of a package that has a function ``check`` is one."""

import pkgutil
from collections.abc import Callable, Iterator
from functools import cache
from importlib import import_module
from typing import Any

from codegen.diagnostics import Diagnostic


@cache
def checks_in(package: str) -> tuple[Callable[[Any], Iterator[Diagnostic]], ...]:
    """The functions ``check`` of a package, in the order of its modules' names; these are imported only now."""
    names = sorted(info.name for info in pkgutil.iter_modules(import_module(package).__path__))
    modules = [import_module(f"{package}.{name}") for name in names]
    return tuple(module.check for module in modules if hasattr(module, "check"))
