"""Every rule that can be reported, by id: collected from the modules that report them."""

import importlib
import pkgutil
from functools import cache
from types import ModuleType

import codegen
from codegen.diagnostics import Rule


@cache
def rule_catalogue() -> dict[str, Rule]:
    """The rules by id, sorted. A module declares a rule as a constant; nothing has to be registered."""
    rules: dict[str, Rule] = {}
    for info in pkgutil.walk_packages(codegen.__path__, "codegen."):
        if info.name != "codegen.__main__":
            rules.update(_rules_of(importlib.import_module(info.name)))
    return dict(sorted(rules.items()))


def _rules_of(module: ModuleType) -> dict[str, Rule]:
    return {value.id: value for value in vars(module).values() if isinstance(value, Rule)}
