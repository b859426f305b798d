"""Which tests `make generator-mutation` runs for a fault: those that reach its line, in an order that finds it soon."""

import pytest
from generator_mutation import chosen_tests
from mutants import Mutant, mutants_of
from reached import Reached

FILE = "codegen/resolve/a.py"
TEXT = """\
from typing import TYPE_CHECKING, Final

if TYPE_CHECKING:
    LIMIT: "Final[1]" = 1


@dataclass(frozen=True)
class Pair:
    low: int = 0


def within(value,
           low=1):
    if (value is not None
            and value < 7):
        return low
    return [
        value
        + 2
    ]
"""


def fault(old: str) -> Mutant:
    (found,) = [mutant for mutant in mutants_of(FILE, TEXT) if mutant.old == old]
    return found


def reaching(*lines: int, seconds: float = 1.0) -> Reached:
    return Reached(True, seconds, {FILE: list(lines)})


def test_what_no_program_sees_is_no_fault() -> None:
    """Neither annotations, nor decorators, nor what only type checkers see."""
    assert not [mutant for mutant in mutants_of(FILE, TEXT) if mutant.line < 9]
    assert [mutant.old for mutant in mutants_of(FILE, TEXT) if mutant.line == 9] == ["0"]


@pytest.mark.parametrize(("old", "line"), [("7", 14), ("2", 17), ("+", 17), ("<", 14)])
def test_a_statement_of_several_lines_is_reached_as_a_whole(old: str, line: int) -> None:
    """Coverage has the line of its beginning, or any other; the lines of its body are those of other statements."""
    suites = {"tests/resolve/test_a.py": reaching(line), "tests/resolve/test_b.py": reaching(16, 12)}
    assert chosen_tests(fault(old), TEXT, "resolve", suites, 100) == (["tests/resolve/test_a.py"], 0)


def test_who_reaches_most_of_the_module_comes_first() -> None:
    """Whoever is about it tries its branches; others only pass through."""
    suites = {"tests/resolve/test_a.py": reaching(14), "tests/cli/test_c.py": reaching(14, 16, 17, seconds=9)}
    assert chosen_tests(fault("7"), TEXT, "resolve", suites, 60)[0] == [
        "tests/cli/test_c.py",
        "tests/resolve/test_a.py",
    ]


def test_the_nearest_tests_come_first_then_the_quickest_while_there_is_time() -> None:
    suites = {
        "tests/cli/test_c.py": reaching(14, seconds=1),
        "tests/broken/test_b.py": reaching(14, seconds=30),
        "tests/resolve/test_slow.py": reaching(14, seconds=20),
        "tests/resolve/test_quick.py": reaching(14, seconds=2),
        "tests/sim/test_s.py": reaching(14, seconds=60),
    }
    nearest = ["tests/resolve/test_quick.py", "tests/resolve/test_slow.py", "tests/broken/test_b.py"]
    assert chosen_tests(fault("7"), TEXT, "resolve", suites, 60) == ([*nearest, "tests/cli/test_c.py"], 1)
