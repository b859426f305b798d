"""Rules have ids of their own, say what to do, and are reported by something."""

import importlib
import pkgutil
import re
from functools import cache
from pathlib import Path

import pytest
from rule_reach import Constant, reported, sources

import codegen
from codegen.diagnostics import Rule
from codegen.findings.catalogue import rule_catalogue


@cache
def declared() -> dict[Constant, Rule]:
    """Every rule by the module and the name of the constant that declares it."""
    found: dict[int, tuple[Constant, Rule]] = {}
    for info in pkgutil.walk_packages(codegen.__path__, "codegen."):
        if info.name == "codegen.__main__":
            continue
        module = importlib.import_module(info.name)
        for name, value in vars(module).items():
            if isinstance(value, Rule) and re.search(rf"^{name}\b.* = ", sources()[info.name], re.MULTILINE):
                found[id(value)] = (info.name, name), value
    return dict(found.values())


TESTS = Path(__file__).resolve().parents[1]


def test_ids_are_unique():
    """Two rules with one id would explain each other."""
    ids = [rule.id for rule in declared().values()]
    assert len(set(ids)) == len(ids) > 300
    assert set(ids) == rule_catalogue().keys()


def test_ids_and_explanations_read_well():
    """Kebab-case ids; an explanation is one sentence or more."""
    for rule in rule_catalogue().values():
        assert re.fullmatch(r"[a-z]+(-[a-z0-9]+)+", rule.id), rule.id
        assert rule.explanation.endswith("."), rule.id
        assert len(rule.explanation) > 30, rule.id


DEAD = 'from codegen.diagnostics import Rule\nRULE = Rule("dead", "It says nothing.")\n'
IN_A_CHECK = f"{DEAD}def check(system):\n    yield from _found()\n\n\ndef _found():\n    return RULE\n"
UNREPORTED = {
    "codegen.rules.only_declared": DEAD,
    "codegen.rules.in_no_check": f"{DEAD}def found(system):\n    yield Diagnostic(place, RULE)\n",
    "codegen.rules.never_called": f"{DEAD}def check(system):\n    yield from ()\n\n\ndef _gone():\n    return RULE\n",
    "codegen.elsewhere": IN_A_CHECK,
}
"""Modules that declare a rule which no command reports, in each way in which that happens."""


@pytest.fixture(scope="module")
def loaded() -> set[Constant]:
    """The constants that what runs loads, with some further modules that nothing else knows."""
    return reported({**sources(), **UNREPORTED, "codegen.rules.in_a_check": IN_A_CHECK})


def test_what_can_be_explained_can_be_reported(loaded: set[Constant]):
    """A rule that nothing reports promises a check that is not made."""
    assert not {rule.id for constant, rule in declared().items() if constant not in loaded}


def test_a_rule_that_nothing_reports_is_noticed(loaded: set[Constant]):
    """The look at the source tells rules that are reported from others."""
    assert not loaded & {(name, "RULE") for name in UNREPORTED}
    assert ("codegen.rules.in_a_check", "RULE") in loaded


def test_each_rule_is_named_by_a_test():
    """A rule that no test names has been reported to nobody."""
    tests = "\n".join(path.read_text() for path in TESTS.rglob("*.py"))
    assert not rule_catalogue().keys() - set(re.findall(r"[\w-]+", tests))
