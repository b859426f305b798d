"""Rules have ids of their own and say what to do."""

import importlib
import pkgutil
import re

import codegen
from codegen.catalogue import rule_catalogue
from codegen.diagnostics import Rule


def test_ids_are_unique():
    """Two rules with one id would explain each other."""
    found: dict[str, Rule] = {}
    for info in pkgutil.walk_packages(codegen.__path__, "codegen."):
        if info.name == "codegen.__main__":
            continue
        for value in vars(importlib.import_module(info.name)).values():
            if isinstance(value, Rule):
                assert found.setdefault(value.id, value) is value or found[value.id] == value, value.id
    assert found.keys() == rule_catalogue().keys()
    assert len(found) > 40


def test_ids_and_explanations_read_well():
    """Kebab-case ids; an explanation is one sentence or more."""
    for rule in rule_catalogue().values():
        assert re.fullmatch(r"[a-z]+(-[a-z0-9]+)+", rule.id), rule.id
        assert rule.explanation.endswith("."), rule.id
        assert len(rule.explanation) > 30, rule.id
