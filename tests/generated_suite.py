"""The generated suite of a project, run as its user runs it: pytest in a process of its own.

Most of what such a process takes is to import pytest and pymavlink's generator. One that has them is forked for each
suite. The examples' suites, those of docs and of the wheel are run by `python -m pytest`, and import all themselves.
"""

import atexit
import json
import os
import subprocess
import sys
import tempfile
from functools import cache
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType

from suite import UNUSED

ALONE = {
    **os.environ,
    "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1",
    "PYTEST_ADDOPTS": " ".join(
        ("--capture=no", "--assert=plain", "-p no:cacheprovider", *(f"-p no:{name}" for name in UNUSED))
    ),
}
"""The suite needs no plugin, and importing those of this environment takes longer than most parts of it.

Nor are asserts rewritten: each of these suites is compiled once, run once, and thrown away.
"""


def run_suite(
    folder: Path, *tests: str, options: tuple[str, ...] = (), micropython: Path | None = None
) -> "subprocess.CompletedProcess[str]":
    """Run tests of a suite, with another MicroPython than theirs if that is given; paths are relative to ``folder``."""
    environment = {**ALONE, "MICROPYTHON": str(micropython)} if micropython else ALONE
    arguments = ["-q", *options, *tests]
    with tempfile.NamedTemporaryFile("r") as printed:
        asked = {"arguments": arguments, "folder": str(folder), "environment": environment, "printed": printed.name}
        process = _forking()
        assert process.stdin is not None
        assert process.stdout is not None
        try:
            process.stdin.write(json.dumps(asked) + "\n")
            process.stdin.flush()
            code = int(process.stdout.readline())
        except BaseException:  # what it answers later would be taken for an answer to what is asked next
            _forking.cache_clear()
            process.kill()
            raise
        return subprocess.CompletedProcess(["pytest", *arguments], code, printed.read(), "")


@cache
def _forking() -> "subprocess.Popen[str]":
    """Return the process that forks for each suite of this process of tests; it ends with its input."""
    command = [sys.executable, str(Path(__file__).with_name("forked_suites.py"))]
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    atexit.register(process.communicate)
    return process


DAYS = "day_across_the_wrap or heap_is_constant_over_a_day"
COMMON = (
    f"{DAYS} or storage or parameter or service or loop or steady or arming or link or stream or health"
    " or watchdog or micropython-station or micropython-stop"
)
"""The scripts of the program that are about modules that every project has alike."""


def suite_is_green(folder: Path, *tests: str, only: str = "") -> None:
    """All tests of a suite pass, or those that the expression ``only`` selects, of which there are some."""
    done = run_suite(folder, *tests, options=("-k", only))
    assert done.returncode == 0, done.stdout[-3000:]


@cache
def scripts_of(tests: Path) -> ModuleType:
    """Return the module with which a suite runs its scripts, from its folder: three times as fast as pytest."""
    spec = spec_from_file_location("scripts_of_a_suite", tests / "interpreters.py")
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module
