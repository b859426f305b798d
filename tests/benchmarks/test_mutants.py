"""The faults that `make mutation` puts into the firmware: each is one, stands where it says, and leaves a module."""

import ast

import pytest
from mutants import Mutant, mutants_of

TEXT = """\
def limited(value, low=0):
    \"\"\"Return 1 if it is above 2.\"\"\"
    if value is not None and not value < low + 3:
        report("two \u00b5", value)
        return -1
    return value % 7
"""
FAULTS = {
    ("0", "1"),
    ("value is not None and not value < low + 3", "not (value is not None and not value < low + 3)"),
    ("is not", "is"),
    ("and", "or"),
    ("not ", ""),
    ("<", "<="),
    ("+", "-"),
    ("3", "4"),
    ('report("two \u00b5", value)', "pass"),
    ("-1", "None"),
    ("-", ""),
    ("1", "2"),
    ("value % 7", "None"),
    ("%", "+"),
    ("7", "8"),
}


def test_each_kind_is_found() -> None:
    assert {(mutant.old, mutant.new) for mutant in mutants_of("a.py", TEXT)} == FAULTS


@pytest.mark.parametrize("mutant", mutants_of("a.py", TEXT), ids=lambda mutant: f"{mutant.old} to {mutant.new}")
def test_a_fault_changes_one_place(mutant: Mutant) -> None:
    text = mutant.applied(TEXT)
    assert ast.dump(ast.parse(text)) != ast.dump(ast.parse(TEXT))
    assert text[: mutant.start] == TEXT[: mutant.start]
    assert text[mutant.start + len(mutant.new) :] == TEXT[mutant.end :]
    assert TEXT.splitlines()[mutant.line - 1].strip() in mutant.shown(TEXT)


def test_none_in_place_of_false_is_a_fault_only_where_it_can_be_told() -> None:
    """Who asks ``if`` cannot tell them apart; a number is another thing."""

    def returned(result: str, value: str) -> set[str]:
        text = f"def f(){result}:\n    return {value}\n"
        return {mutant.new for mutant in mutants_of("a.py", text)}

    assert returned(" -> bool", "False") == {"True"}
    assert returned(" -> bool", "True") == {"False", "None"}
    assert returned("", "False") == returned(" -> bool | None", "False") == {"True", "None"}
    assert returned(" -> int", "0") == returned(" -> bool", "0") == {"1", "None"}
    assert returned("", "None") == set()
    inner = "def f() -> bool:\n    def g():\n        return False\n    return False\n"
    assert sum(mutant.new == "None" for mutant in mutants_of("a.py", inner)) == 1
