"""`make generator-mutation` runs for a fault the tests that reach its line, in an order that finds it soon."""

from pathlib import Path
from queue import Queue

import generator_mutation
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
    assert chosen_tests(fault(old), TEXT, suites, 100) == (["tests/resolve/test_a.py"], 0)


def test_who_reaches_what_others_do_not_comes_first() -> None:
    """Whoever is about it tries its branches; others only pass through."""
    suites = {f"tests/spec/test_{number}.py": reaching(14) for number in range(3)}
    suites["tests/resolve/test_c.py"] = reaching(14, 16, 17, seconds=9)
    assert chosen_tests(fault("7"), TEXT, suites, 60)[0] == ["tests/resolve/test_c.py", *list(suites)[:3]]


def test_those_of_the_stage_come_first_and_then_the_quickest_while_there_is_time() -> None:
    suites = {
        "tests/broken/test_b.py": reaching(14, seconds=10),
        "tests/broken/test_slow.py": reaching(14, seconds=20),
        "tests/resolve/test_slow.py": reaching(14, seconds=35),
        "tests/sim/test_s.py": reaching(17, seconds=1),
    }
    chosen = ["tests/resolve/test_slow.py", "tests/broken/test_b.py"]
    assert chosen_tests(fault("7"), TEXT, suites, 60) == (chosen, 1)


@pytest.fixture
def runs(monkeypatch: pytest.MonkeyPatch) -> list[tuple[bool, list[str]]]:
    """Return the list of runs: whether the fault is in, and the tests. test_a fails with it, test_b always."""
    seen: list[tuple[bool, list[str]]] = []

    def failed(copy: Path, tests: list[str], _: float) -> str | None:
        has_fault = (copy / FILE).read_text() != TEXT
        seen.append((has_fault, tests))
        for name in tests:
            if "test_b" in name or ("test_a" in name and has_fault):
                return f"{name.split('::')[0]}::test_1"
        return None

    monkeypatch.setattr(generator_mutation, "_failed", failed)
    return seen


@pytest.mark.parametrize(
    ("tests", "by"),
    [(["test_a.py"], "test_a.py::test_1"), (["test_b.py", "test_c.py"], None), (["test_c.py"] * 5, None)],
)
def test_what_fails_without_the_fault_too_has_not_noticed_it(
    runs: list[tuple[bool, list[str]]], tmp_path: Path, tests: list[str], by: str | None
) -> None:
    path = tmp_path / FILE
    path.parent.mkdir(parents=True)
    path.write_text(TEXT)
    copies: Queue[Path] = Queue()
    copies.put(tmp_path)
    suites = {name: reaching(14) for name in tests}
    assert generator_mutation._noticed_by(fault("7"), TEXT, tests, suites, copies) == by
    assert path.read_text() == TEXT
    assert copies.get_nowait() == tmp_path
    assert [name for has_fault, batch in runs if has_fault for name in batch] == tests
    if by:
        assert runs[-1] == (False, [by])


def test_tests_that_all_fail_say_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    """Where no file of tests passes in a copy, nothing is counted, and nothing stored."""
    monkeypatch.setattr(generator_mutation, "reached", lambda *_: {"tests/a.py": Reached(False, 1.0, {})})
    monkeypatch.setattr("sys.argv", ["generator_mutation.py", "--folders", "diff", "--store"])
    monkeypatch.setattr(generator_mutation.resource, "setrlimit", lambda *_: None)
    with pytest.raises(SystemExit, match="every file of tests fails in a copy"):
        generator_mutation.main()
