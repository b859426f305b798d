"""The generated suite of a project, run as its user runs it: pytest in a process of its own."""

import os
import subprocess
import sys
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
    command = [sys.executable, "-m", "pytest", "-q", *options, *tests]
    environment = {**ALONE, "MICROPYTHON": str(micropython)} if micropython else ALONE
    return subprocess.run(command, capture_output=True, text=True, cwd=folder, env=environment, check=False)


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
