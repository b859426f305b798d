"""A sample of the inputs that `make fuzz` draws by the thousand, and the judge of what codegen does with them."""

import os
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest
from fuzz import run_on
from fuzzing.case import Case, drawn, store, stored
from fuzzing.judge import HIDDEN, judged
from fuzzing.samples import kinds, samples

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
PROJECT = {"specs/codegen.yaml": b"project: p\ndialect: common\n"}


@pytest.mark.long
def test_no_input_of_a_sample_does_harm(tmp_path: Path) -> None:
    """Any seed holds; another one would draw others."""
    command = [sys.executable, "benchmarks/fuzz.py", "--seed", "5", "--count", "25", "--small", "--out", str(tmp_path)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.stdout.startswith("seed 5: 25 inputs in "), done.stdout + done.stderr
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("name", ["minimal", "dialect minimal"])
def test_samples_are_right(name: str, tmp_path: Path) -> None:
    """Before there is a fault in them."""
    sample = next(each for each in samples() if each.name == name)
    codec = ("codec", "--dialect", "minimal.xml", "--messages", "all", "--out", "made")
    outcome = judged(Case("0-0", "table", codec if name != "minimal" else ("build",), sample.files), tmp_path, main)
    assert (outcome.code, outcome.faults) == (0, ())


def test_every_kind_of_file_is_among_them() -> None:
    expected = {"state", "board", "parameters", "streams", "vehicle", "commands", "receiver", "scenarios", "waivers"}
    expected |= {"table", "reception", "board model", "driver", "requirement", "dialect", "dialect alone"}
    assert kinds().keys() == {*expected, "corrections", "lock", "project file", "program"}


def test_a_seed_draws_the_same_again(tmp_path: Path) -> None:
    """And what is stored is the same, too."""
    for number in range(30):
        case = drawn(7, number)
        assert case == drawn(7, number)
        store(case, tmp_path / str(number))
        assert stored(tmp_path / str(number)) == case
    assert len({drawn(7, number).command for number in range(60)}) > 5


def says(text: str, code: int) -> Callable[[list[str]], int]:
    """Something in place of codegen that prints a text and ends with a code."""

    def run(_: list[str]) -> int:
        sys.stdout.write(f"{text}\n")
        return code

    return run


def does(action: Callable[[], object], code: int = 0) -> Callable[[list[str]], int]:
    """Something in place of codegen that does one thing."""

    def run(_: list[str]) -> int:
        action()
        return code

    return run


def hang() -> None:
    while True:
        pass


FINDING = "specs/codegen.yaml:1:1: error some-rule: wrong"
WRONG: dict[str, tuple[Callable[[list[str]], int], str]] = {
    "an error of its own": (says("", 3), "it ends with 3"),
    "a traceback": (says(f"{FINDING}\nTraceback (most recent call last):", 1), "it ends with 1"),
    "an exception": (does(lambda: 1 // 0), "it raises ZeroDivisionError"),
    "an exit": (does(lambda: sys.exit(4)), "it raises SystemExit"),
    "too long": (does(hang), "it takes more than 0.2 s"),
    "no finding": (says("wrong", 1), "it ends with 1 without an error at a place"),
    "a warning alone": (says("specs/codegen.yaml:1:1: warning some-rule: odd", 2), "it ends with 2 without an error"),
    "a place elsewhere": (says("/etc/passwd:1:1: error some-rule: wrong", 1), "outside of the project"),
    "a place above": (says("../other:1:1: error some-rule: wrong", 1), "outside of the project"),
    "a line that is not there": (says("specs/codegen.yaml:9:1: error some-rule: x", 1), "it has 3 lines"),
    "a column that is not there": (
        says("specs/codegen.yaml:1:99: error some-rule: x", 1),
        "the line has 10 characters",
    ),
    "a quotation": (says(f"{FINDING}: {HIDDEN}", 1), "it quotes a file outside"),
    "reading outside": (does(lambda: Path("../secret").read_text()), "it reads "),
    "listing outside": (does(lambda: os.listdir("/etc")), "it reads /etc"),
    "writing outside": (does(lambda: Path("../made").write_text("x")), "it writes "),
    "a folder outside": (does(lambda: os.mkdir("../folder")), "it writes "),
    "a changed input": (does(lambda: Path("specs/codegen.yaml").write_text("")), "specs/codegen.yaml is not as it was"),
    "a changed file of somebody": (does(lambda: Path("generated/kept.txt").unlink()), "generated/kept.txt is not as"),
    "output after an error": (
        lambda _: (Path("generated/new.py").touch(), says(FINDING, 1)([]))[1],
        "generated/new.py was written in spite of errors",
    ),
    "a program": (does(lambda: subprocess.run(["true"], check=True)), "it starts subprocess.Popen"),
    "a module that is none": (
        does(lambda: (Path("manifest.json").write_text("{}"), Path("a.py").write_text("def"))),
        "a.py: SyntaxError",
    ),
}


@pytest.mark.parametrize("what", WRONG)
def test_the_judge_sees(what: str, tmp_path: Path) -> None:
    """Each thing that must not happen."""
    codegen, said = WRONG[what]
    command = ("build",) if what == "a module that is none" else ("check",)
    started = time.process_time()
    outcome = judged(Case("0-0", "project file", command, PROJECT), tmp_path, codegen, longest_s=0.2)
    assert any(said in fault for fault in outcome.faults), outcome.faults
    assert time.process_time() - started < 5
    assert not any(tmp_path.iterdir())


def test_the_judge_passes_what_is_right(tmp_path: Path) -> None:
    assert not judged(Case("0-0", "project file", ("check",), PROJECT), tmp_path, says(FINDING, 1)).faults


def test_an_input_is_tried_again_by_one_command(tmp_path: Path) -> None:
    """It says what codegen said."""
    store(Case("1-2", "project file", ("check",), {"specs/codegen.yaml": b"project: [\n"}), tmp_path / "1-2")
    command = [sys.executable, "benchmarks/fuzz.py", "--again", str(tmp_path / "1-2")]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("codegen check: ")
    assert "specs/codegen.yaml:2:1: error yaml-syntax: " in done.stdout


def test_a_run_goes_on_where_the_stored_one_ended() -> None:
    """Protects the number of inputs on docs/quality.md: none is counted twice, none is left out between two runs."""
    before = {"inputs": 40, "faults": 1, "codes": {"0": 30, "2": 10}, "kinds": {"state": 40}}
    further = {"inputs": 20, "faults": 2, "codes": {"0": 5, "1": 15}, "kinds": {"lock": 12, "state": 8}}
    assert run_on(before, 0, further) == further
    assert run_on(before, 40, further) == {
        "inputs": 60,
        "faults": 3,
        "codes": {"0": 35, "1": 15, "2": 10},
        "kinds": {"lock": 12, "state": 48},
    }
    for known in (before, {}):
        with pytest.raises(SystemExit, match="--first begins behind them"):
            run_on(known, 39, further)
