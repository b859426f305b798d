# ruff: noqa: S603  it runs what it is given
"""Runs a command as a group of processes of its own: whatever it has started ends with it, or once it is out of time.

A suite runs interpreters. A fault may let one hang, which would go on beside all that is measured later where only the
suite itself was ended.
"""

import os
import signal
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path


def outcome(
    command: Sequence[str], folder: Path, longest_s: float | None = None, environment: Mapping[str, str] | None = None
) -> subprocess.CompletedProcess[str] | None:
    """Run a command in a folder; return its exit code and output, or None where it takes longer than ``longest_s``.

    What it has started has ended by then, but for what began a session of its own. The output goes through a file: a
    pipe would be open as long as anybody has it who was left behind.
    """
    with tempfile.TemporaryFile("w+", encoding="utf-8") as output:
        with subprocess.Popen(
            command, cwd=folder, env=environment, stdout=output, stderr=subprocess.DEVNULL, start_new_session=True
        ) as running:
            try:
                code = running.wait(longest_s)
            except subprocess.TimeoutExpired:
                return None
            finally:
                with suppress(ProcessLookupError):  # nobody is left
                    os.killpg(running.pid, signal.SIGKILL)
        output.seek(0)
        return subprocess.CompletedProcess(command, code, output.read())
