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


def test_a_function_of_the_module_itself_that_is_only_asked_whether_it_is_true() -> None:
    """Each way to ask for more makes None another answer than False: to keep it, return it, compare it, hand it on."""

    def returned(use: str, name: str = "_f") -> set[str]:
        text = f"def {name}():\n    return False\n\n\n{use.replace('F', name)}\n"
        return {mutant.new for mutant in mutants_of("a.py", text) if mutant.line == 2}

    for asked in ("if F(): a()", "while not F(): a()", "b = 1 if a or F() else 2", "b = not (F() if a else a)"):
        assert returned(asked) == {"True"}, asked
    for asked in ("[a for a in b if F() and a]", "assert x.F(1)", "if F() and not self.F(): a()"):
        assert returned(asked) == {"True"}, asked
    for kept in ("b = F()", "return_(F())", "if F() is False: a()", "b = F() or a", "if a(F): a()", "b = not a(F())"):
        assert returned(kept) == {"True", "None"}, kept
    assert returned("if F(): b = F") == {"True", "None"}
    assert returned("if F(): a()", "f") == {"True", "None"}, "others may ask, too"
    assert returned("a()") == {"True", "None"}, "nobody in this module asks"
