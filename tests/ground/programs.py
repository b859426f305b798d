"""The programs that take part in a test: the simulator and the ground stations, heard from and ended for certain."""

import os
import re
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from types import TracebackType
from typing import Self

import pytest

BIN = Path(sys.executable).parent
PATIENCE_S = 30.0
"""The longest wait for anything. It takes a second at most; a busy computer may need more."""
_GRACE_S = 5.0


def wait_until(condition: Callable[[], bool], what: str, seconds: float = PATIENCE_S) -> None:
    """Return as soon as the condition holds; the test fails if it does not."""
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            pytest.fail(f"in vain: {what}")
        time.sleep(0.001)


class Program:
    """A process, everything that it wrote, and a line to its standard input. It ends with the block at the latest."""

    def __init__(self, name: str, command: list[str], folder: Path, **environment: str) -> None:
        self.name = name
        self.written = ""
        variables = {name: value for name, value in os.environ.items() if not name.startswith(("CODEGEN_", "MAVLINK"))}
        self._news = threading.Condition()
        self._process = subprocess.Popen(
            command,
            cwd=folder,
            env={**variables, "PYTHONUNBUFFERED": "1", "COLUMNS": "200", **environment},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, fault: BaseException | None, place: TracebackType | None
    ) -> None:
        self.end()
        sys.stdout.write(f"---- {self.name} wrote:\n{self.written}\n")  # pytest shows it when the test fails

    @property
    def pid(self) -> int:
        """The number of its process."""
        return self._process.pid

    @property
    def position(self) -> int:
        """Return the position at which its further output begins."""
        with self._news:
            return len(self.written)

    def wait_for(self, pattern: str, since: int = 0, seconds: float = PATIENCE_S) -> re.Match[str]:
        """Return the first match in what it wrote since a position; the test fails if none comes."""
        deadline = time.monotonic() + seconds
        with self._news:
            while True:
                found = re.compile(pattern).search(self.written, since)
                if found:
                    return found
                if not self._reader.is_alive() or time.monotonic() > deadline:
                    pytest.fail(f"{self.name} did not write {pattern!r}, but:\n{self.written[since:]}")
                self._news.wait(0.1)

    def say(self, line: str) -> int:
        """Type a line; return the position from which its effects are found."""
        position = self.position
        assert self._process.stdin is not None
        self._process.stdin.write(f"{line}\n".encode())
        self._process.stdin.flush()
        return position

    def repeat(self, line: str, pattern: str) -> re.Match[str]:
        """Type a line again and again until what it brings is as the pattern says."""
        position = self.position
        deadline = time.monotonic() + PATIENCE_S
        while True:
            self.say(line)
            with self._news:
                found = self._news.wait_for(lambda: re.compile(pattern).search(self.written, position), 1.0)
            if found:
                return found
            if time.monotonic() > deadline:
                pytest.fail(f"{line!r} did not bring {pattern!r}, but:\n{self.written[position:]}")

    def wait(self, seconds: float = PATIENCE_S) -> int:
        """Return its exit code once it has ended by itself."""
        try:
            code = self._process.wait(seconds)
        except subprocess.TimeoutExpired:
            pytest.fail(f"{self.name} does not end; it wrote:\n{self.written}")
        self._reader.join(_GRACE_S)
        return code

    def end(self) -> None:
        """Ask it to end, and kill it if it does not."""
        assert self._process.stdin is not None
        with suppress(BrokenPipeError):
            self._process.stdin.close()
        if self._process.poll() is None:
            self._process.send_signal(signal.SIGTERM)
            with suppress(subprocess.TimeoutExpired):
                self._process.wait(_GRACE_S)
        with suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()
        self._reader.join(_GRACE_S)
        assert self._process.stdout is not None
        self._process.stdout.close()

    def _read(self) -> None:
        assert self._process.stdout is not None
        while data := os.read(self._process.stdout.fileno(), 65536):
            with self._news:
                self.written += data.decode("utf-8", "replace")
                self._news.notify_all()
        with self._news:
            self._news.notify_all()
