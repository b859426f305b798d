"""The comparison itself: generates a codec, runs the cases of a dialect with it on MicroPython, sums up what differs.

Of the codec nothing is used but the generator; conform.py is what runs on MicroPython.
"""

import json
import os
import subprocess
import sys
from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from conformance_cases import write_cases
from conformance_oracle import Dialect, Message

from codegen.commands.codec import codec_files
from codegen.diagnostics import Report

FORMS = ("viper", "plain")
CONFORM = Path(__file__).with_name("conform.py")
MICROPYTHON = Path(sys.executable).with_name("micropython")
MICROPYTHON32 = MICROPYTHON.with_name("micropython32")  # benchmarks/micropython32
SINGLE_FLOATS = Path(__file__).with_name("single_floats")  # what stands in for floats of 32 bits


@dataclass
class Outcome:
    """The outcome of comparing a dialect, all forms of the frames together."""

    counts: dict[str, int] = field(default_factory=dict)
    differences: list[str] = field(default_factory=list)
    different: int = 0

    def add(self, form: str, result: dict[str, Any]) -> None:
        """Add what one run of conform.py printed."""
        for kind, number in result["counts"].items():
            self.counts[kind] = self.counts.get(kind, 0) + number
        self.differences += [f"{form}: {difference}" for difference in result["differences"]]
        self.different += result["different"]


def generate(dialect: str, folder: Path, *, machine_code: bool) -> list[str]:
    """Write the codec with all messages of a dialect; the answer are the errors, if there are any."""
    report = Report()
    files = codec_files(dialect, ["all"], report, machine_code=machine_code)
    for path, text in files.items():
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    if files and not report.has_errors:
        return []
    return [f"{found.rule.id}: {found.message}" for found in report] or ["the codec is empty"]


def compare(
    dialect: Dialect,
    folder: Path,
    messages: Collection[Message],
    rounds: int,
    forms: Collection[str] = FORMS,
    seed: int = 1,
    interpreter: Path = MICROPYTHON,
    modules: Sequence[Path] = (),
) -> Outcome:
    """Compare messages of a dialect, of which the codec has all, with pymavlink; the frames in each of `forms`.

    In `modules` the interpreter looks for modules before all else.
    """
    outcome = Outcome()
    cases = folder / f"{dialect.name}.cases"
    write_cases(cases, dialect, messages, seed, rounds)
    for form in forms:
        codec = folder / form / dialect.name
        errors = generate(dialect.name, codec, machine_code=form == "viper")
        if errors:
            outcome.differences += errors
            outcome.different += len(errors)
            continue
        result = run_cases(codec, cases, interpreter, modules)
        assert result["form"] == form
        outcome.add(form, result)
    cases.unlink()
    return outcome


def run_cases(
    codec: Path, cases: Path, interpreter: Path = MICROPYTHON, modules: Sequence[Path] = ()
) -> dict[str, Any]:
    """Run the cases on MicroPython with the codec of a folder."""
    done = subprocess.run(
        [str(interpreter), "-X", "heapsize=256m", str(CONFORM), str(cases)],
        env=os.environ | {"MICROPYPATH": os.pathsep.join(map(str, (*modules, codec)))},
        capture_output=True,
        text=True,
        check=False,
        timeout=600,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    result: dict[str, Any] = json.loads(done.stdout)
    return result
