"""Every rule that can be reported, by id: collected from the modules that report them."""

import importlib
import json
import pkgutil
from functools import cache
from types import ModuleType

from codegen.diagnostics import Rule
from codegen.tool.cache import entry, keep, kept
from codegen.tool.digest import tool_digest


@cache
def rule_catalogue(part: str = "codegen") -> dict[str, Rule]:
    """The rules of codegen, or of one of its packages, by id, sorted.

    A module declares a rule as a constant; nothing has to be registered. All modules are imported for it.
    """
    rules: dict[str, Rule] = {}
    for info in pkgutil.walk_packages(importlib.import_module(part).__path__, f"{part}."):
        if info.name != "codegen.__main__":
            rules.update(_rules_of(importlib.import_module(info.name)))
    return dict(sorted(rules.items()))


def rule_ids(part: str = "codegen") -> tuple[str, ...]:
    """The ids of these rules; what an earlier run found out needs no imports."""
    name = entry("rules", tool_digest(), part)
    known = kept(name)
    if known is not None:
        return tuple(json.loads(known))
    found = tuple(rule_catalogue(part))
    keep(name, json.dumps(found).encode())
    return found


def _rules_of(module: ModuleType) -> dict[str, Rule]:
    return {value.id: value for value in vars(module).values() if isinstance(value, Rule)}
