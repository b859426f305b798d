"""The checks of a program share a process: one that ends it, or hangs, fails, and hides none of the others."""

import json
import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import whole_program

GENERATED = Path(__file__).resolve().parents[2] / "generated"
ODD = """
def passes():
    pass


def fails():
    raise ValueError("wrong")


def ends():
    raise SystemExit(3)


def hangs():
    import select

    while True:
        select.poll().poll(1000)


def ends_in_company():
    import program_bench

    if getattr(program_bench, "was_here", False):
        raise SystemExit(3)


def takes_long():
    import select

    select.poll().poll(2200)


def takes_as_long():
    takes_long()


def is_here():
    import program_bench

    program_bench.was_here = True


CHECKS = ((passes,), (fails,), (ends,), (hangs,), (is_here,), (ends_in_company,), (takes_long,), (takes_as_long,))
"""


@pytest.fixture(scope="module")
def tests(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The suite of the rover with a script of odd checks, and one that cannot be imported."""
    folder = whole_program(GENERATED, tmp_path_factory.mktemp("grouped"))
    (folder / "tests" / "odd_checks.py").write_text(ODD)
    (folder / "tests" / "broken_checks.py").write_text("import no_such_module\n")
    return folder / "tests"


def outcomes(tests: Path, interpreter: str, *asked: str, most_hanging: int = 3) -> dict[str, str | None]:
    """Return the suite's outcomes of checks, each with its script, which have four seconds each."""
    script = "import grouped, json, sys\ngrouped.MOST_HANGING = int(sys.argv[2])\n"
    script += "pairs = [tuple(each.split()) for each in sys.argv[3:]]\n"
    script += "print(json.dumps(grouped.outcomes(sys.argv[1], pairs, 4)))"
    command = [sys.executable, "-c", script, interpreter, str(most_hanging), *asked]
    done = subprocess.run(command, cwd=tests, capture_output=True, text=True, check=True)
    found: dict[str, str | None] = json.loads(done.stdout)
    return found


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_each_has_its_own_outcome(tests: Path, interpreter: str) -> None:
    """One that ends the process, one that hangs, a script that cannot be imported: the others are run all the same."""
    names = ("odd passes", "odd fails", "odd ends", "odd hangs", "broken first", "loop control_keeps_its_grid")
    found = outcomes(tests, interpreter, *names)
    assert set(found) == set(names)
    assert found["odd passes"] is None
    assert found["odd fails"] == "ValueError: wrong"
    assert str(found["odd ends"]).startswith(f"{interpreter} ended with 3")
    assert found["odd hangs"] == "does not end within 4 s"
    assert "no_such_module" in str(found["broken first"])
    assert found["loop control_keeps_its_grid"] is None


def test_what_ends_the_process_is_run_alone(tests: Path) -> None:
    """It may be what an earlier check has left: alone it says what it finds."""
    found = outcomes(tests, "micropython", "odd is_here", "odd ends_in_company", "odd fails")
    assert found == {"odd is_here": None, "odd ends_in_company": None, "odd fails": "ValueError: wrong"}


def test_where_many_hang_the_others_are_told_apart(tests: Path) -> None:
    """A program that stands still would take a minute for each check: they fail, and say that they were not run."""
    found = outcomes(tests, "micropython", "odd hangs", "odd passes", most_hanging=1)
    assert found == {"odd hangs": "does not end within 4 s", "odd passes": "not run: 1 others do not end"}


def test_many_checks_have_the_time(tests: Path) -> None:
    """The limit is for each: a large specification has long ones, and all together may take minutes."""
    found = outcomes(tests, "cpython", "odd takes_long", "odd takes_as_long", "odd passes")
    assert set(found.values()) == {None}
