# ruff: noqa: S603, T201  it runs the generated suite, and prints what that took
"""Runs the main part of a generated suite, and says how much processor time it took, on one core as on several.

`make suite` runs the rover's; NFR-00062 asks for less than 5 s. `--program boat` takes examples/boat, `--whole` all of
the suite, with what simulates minutes and days.
"""

import argparse
import os
import resource
import subprocess
import sys

from mutation import PROGRAMS
from results import ROOT

UNUSED = (
    "debugging", "doctest", "faulthandler", "logging", "pastebin", "recwarn", "setuponly", "stepwise",
    "threadexception", "unittest", "unraisableexception", "warnings",
)  # fmt: skip
"""Parts of pytest that watch each test for what no suite does, which is a fifth of what a thousand tests take."""


def main() -> int:
    """Run, say what it took; return how pytest ended."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", choices=PROGRAMS, default="rover")
    parser.add_argument("--whole", action="store_true")
    arguments = parser.parse_args()
    # The suite needs no plugin: importing those that are installed would take a second. Settings name one of them.
    options = ["-p", "pytest_timeout", *(f"-pno:{name}" for name in UNUSED)]
    command = [sys.executable, "-m", "pytest", *options, os.path.join(*PROGRAMS[arguments.program], "tests")]
    command += [] if arguments.whole else ["-m", "not days"]
    done = subprocess.run(command, cwd=ROOT, env={**os.environ, "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}, check=False)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    part = "the whole suite" if arguments.whole else "the main part of the suite"
    print(f"{arguments.program}: {part} took {used.ru_utime + used.ru_stime:.1f} s of processor time")
    return done.returncode


if __name__ == "__main__":
    sys.exit(main())
