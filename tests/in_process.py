"""Commands of codegen in the process of the tests: one of their own would import everything and read the dialect anew.

A build takes a third of the time. What is about the start or the end of a process, its signals, its pipes or its cache
runs a process.
"""

import subprocess
from contextlib import chdir, redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path

from codegen.cli import main


def codegen(folder: Path, *arguments: str) -> "subprocess.CompletedProcess[str]":
    """Run a command in a folder; return how it ended, as of a process."""
    with chdir(folder), redirect_stdout(StringIO()) as said, redirect_stderr(StringIO()) as told:
        code = main([*arguments])
    return subprocess.CompletedProcess(["codegen", *arguments], code, said.getvalue(), told.getvalue())


def build(folder: Path) -> None:
    """Build the project in a folder, which has to succeed."""
    done = codegen(folder, "build")
    assert done.returncode == 0, done.stdout + done.stderr
