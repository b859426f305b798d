"""Every finding says what to do: whoever reads it has written what it is about, and should not have to guess."""

import ast
import importlib
import inspect
import pkgutil
import re
from functools import cache
from types import ModuleType

import pytest
from hint_reach import HINTS, Reported, reports
from rule_reach import nodes_of, sources, tree_of

import codegen
from codegen.claims.reading import Reading
from codegen.decode.scalar import Mismatch
from codegen.deploy.findings import BoardFaultError
from codegen.derivations.surroundings import Surroundings
from codegen.diagnostics import Diagnostic, Report, Rule
from codegen.diff.change import ChangeRule
from codegen.findings.catalogue import rule_catalogue
from codegen.findings.text import finding_text
from codegen.resolve.dialect.sentinel import Problem
from codegen.resolve.scenarios.values import ScenarioValues
from codegen.source import Place

MODULES = [info.name for info in pkgutil.walk_packages(codegen.__path__, "codegen.") if info.name != "codegen.__main__"]
METHODS = (Report.add, Surroundings.bad, ScenarioValues.say, Reading.found, BoardFaultError.__init__)
RECORDS = (Diagnostic, Mismatch, Problem)
LONGEST = 100


@cache
def reported(name: str) -> list[Reported]:
    """What a module reports: a change that ``codegen diff`` tells is no mistake, and says what it reaches instead."""
    found = reports(tree_of(sources()[name]), importlib.import_module(name))
    return [each for each in found if not isinstance(each.rule, ChangeRule)]


def test_each_finding_has_a_hint_or_a_rule_with_a_remedy() -> None:
    """Where a hint may be missing, or cannot be seen to be there, the rule says what to do."""
    lacking = [
        (name, each.line, each.rule.id)
        for name in MODULES
        for each in reported(name)
        if not each.is_hinted and not each.rule.remedy
    ]
    assert lacking == []


def test_no_finding_falls_back_on_a_rule_that_is_for_many() -> None:
    """A quantity can be wrong in so many ways that one remedy helps with none: who names no rule states a hint."""
    bare = [
        (name, node.lineno)
        for name in MODULES
        for node in nodes_of(tree_of(sources()[name]))
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "bad"
        if len(node.args) == 2 and not isinstance(node.args[1], ast.Starred)
        if all(keyword.arg != "hint" for keyword in node.keywords)
    ]
    assert bare == []


def test_each_rule_is_looked_at() -> None:
    """The look at the source finds the rules: all but changes are reported somewhere."""
    rules = {rule.id for rule in rule_catalogue().values() if not isinstance(rule, ChangeRule)}
    assert len(rules) > 300
    assert not rules - {each.rule.id for name in MODULES for each in reported(name)}


def test_remedies_read_like_hints() -> None:
    """Short, in small letters, without a full stop."""
    for rule in rule_catalogue().values():
        if rule.remedy:
            assert len(rule.remedy) <= LONGEST, rule.id
            assert re.match(r"[a-z]", rule.remedy), rule.id
            assert not rule.remedy.endswith((".", "!")) or rule.remedy.endswith("..."), rule.id


def test_the_hint_of_a_finding_comes_before_the_remedy_of_its_rule() -> None:
    """What is said of the single finding is nearer to it."""
    rule = Rule("some-rule", "It is wrong.", remedy="turn it round")
    place = Place("a.yaml")
    assert "hint: turn it round" in finding_text(Diagnostic(place, rule, "no"))
    assert "hint: leave it out" in finding_text(Diagnostic(place, rule, "no", "leave it out"))
    assert "hint" not in finding_text(Diagnostic(place, Rule("other-rule", "It is wrong."), "no"))


def test_hints_stand_where_they_are_looked_for() -> None:
    """The positions of hints are those of the signatures; of methods without self."""
    found = {each.__qualname__: list(inspect.signature(each).parameters).index("hint") - 1 for each in METHODS}
    found |= {each.__name__: list(each.__annotations__).index("hint") for each in RECORDS}
    assert {name.removesuffix(".__init__"): position for name, position in found.items()} == HINTS


SOURCE = """
def found(place: str, doubtful: str | None, report) -> None:
    {}
"""
RULE = Rule("some-rule", "It is wrong.")


@pytest.mark.parametrize(
    ("statement", "hints"),
    [
        ("report.add(RULE, place, 'no')", [False]),
        ("report.add(RULE, place, 'no', None)", [False]),
        ("report.add(RULE, place, 'no', doubtful)", [False]),
        ("report.add(RULE, place, 'no', did_you_mean('a', []))", [False]),
        ("report.add(RULE, *place)", [False]),
        ("yield Diagnostic(place, RULE, 'no')", [False]),
        ("raise BoardFaultError(RULE, 'no')", [False]),
        ("elsewhere(RULE, place, 'no', 'do')", [False]),
        ("rule = RULE", [False]),
        ("hint = None if doubtful else 'do'; report.add(RULE, place, 'no', hint)", [False]),
        ("report.add(RULE, place, 'no', 'do')", [True]),
        ("report.add(RULE, place, 'no', hint=f'do {place}')", [True]),
        ("report.add(RULE if place else RULE, place, 'no', doubtful or 'do')", [True, True]),
        ("hint = 'a' if doubtful else 'b'; report.add(RULE, place, 'no', hint)", [True]),
        ("raise BoardFaultError(RULE, 'no', 'do')", [True]),
        ("around.bad('key', 'no', RULE, shortened(place))", [True]),
    ],
)
def test_hints_are_told_from_what_may_be_none(statement: str, hints: list[bool]) -> None:
    """So that the tests above are some."""
    names = {"RULE": RULE, "did_you_mean": _doubtful, "shortened": _sure}
    found = list(reports(ast.parse(SOURCE.format(statement)), names))
    assert [each.is_hinted for each in found] == hints
    assert all(each.rule is RULE for each in found)


def test_a_rule_that_is_imported_late_is_seen() -> None:
    """Some modules import in a function, for speed."""
    text = (
        "def late(report):\n    from codegen.load.text import FILE_NOT_FOUND\n    report.add(FILE_NOT_FOUND, 1, 'no')\n"
    )
    (found,) = reports(ast.parse(text), ModuleType("late"))
    assert (found.rule.id, found.line, found.is_hinted) == ("file-not-found", 3, False)


def _doubtful(_: str) -> str | None:
    return None


def _sure(text: str) -> str:
    return text
