"""One run of the firmware as a process of its own, from its start to its end or to a reset of the board."""

import json
import os
import selectors
import shutil
import signal
import subprocess
import sys
import time
from collections import deque
from collections.abc import Mapping, Sequence
from contextlib import suppress
from enum import StrEnum
from typing import Any

from codegen.frozen import dataclass

EXIT_RESET = 3
"""Exit code of the process when the firmware restarts the board."""
_GRACE_S = 3.0
_KEPT_LINES = 60


class Runtime(StrEnum):
    """The interpreter that runs the firmware."""

    MICROPYTHON = "micropython"
    CPYTHON = "cpython"


@dataclass(frozen=True, slots=True)
class Console:
    """A line that the program printed."""

    text: str


Item = Mapping[str, Any] | Console
"""A record of the simulation, or a line of the console."""


def find_interpreter(runtime: Runtime) -> str | None:
    """The path of the interpreter: for MicroPython that beside this one, or on PATH; None if it is not installed."""
    if runtime is Runtime.CPYTHON:
        return sys.executable
    beside = os.path.join(os.path.dirname(sys.executable), "micropython")
    return beside if os.access(beside, os.X_OK) else shutil.which("micropython")


class FirmwareProcess:
    """The running firmware. ``paths`` are the folders of its modules; it ends with close() at the latest."""

    def __init__(
        self,
        runtime: Runtime,
        interpreter: str,
        paths: Sequence[str],
        flash: str,
        script: str,
        settings: str,
        *,
        takes_turns: bool = False,
    ) -> None:
        """Start ``script`` in the folder ``flash``; ``settings`` is completed with the files that it speaks over.

        With ``takes_turns`` it lets time pass only as far as give_turn() says.
        """
        command = [interpreter, *(["-X", "heapsize=8m"] if runtime is Runtime.MICROPYTHON else ["-B", "-u"])]
        environment = {
            **os.environ,
            "MICROPYPATH": os.pathsep.join([".frozen", *paths]),
            "PYTHONPATH": os.pathsep.join(paths),
        }
        reading, writing = os.pipe()
        taking: int | None = None
        self._turns: int | None = None
        if takes_turns:
            taking, self._turns = os.pipe()
        given = [writing] if taking is None else [writing, taking]
        try:
            with open(settings, encoding="utf-8") as file:
                values = json.load(file)
            with open(settings, "w", encoding="utf-8") as file:
                turns = None if taking is None else f"/dev/fd/{taking}"
                json.dump({**values, "records": f"/dev/fd/{writing}", "turns": turns}, file)
            self._process = subprocess.Popen(  # noqa: S603 - the interpreter and the script are ours
                [*command, script, settings],
                cwd=flash,
                env=environment,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
                pass_fds=given,
                start_new_session=True,  # Ctrl-C is for codegen, which then ends this process
            )
        except BaseException:
            os.close(reading)
            self._end_turns()
            raise
        finally:
            for stream in given:
                os.close(stream)
        assert self._process.stdout is not None
        assert self._process.stderr is not None
        self._records = reading
        self._errors = self._process.stderr.fileno()
        self._pieces = {reading: b"", self._process.stdout.fileno(): b"", self._errors: b""}
        self._selector = selectors.DefaultSelector()
        for stream in self._pieces:
            os.set_blocking(stream, False)
            self._selector.register(stream, selectors.EVENT_READ)
        self.complaints: deque[str] = deque(maxlen=_KEPT_LINES)
        """The last lines on its stderr."""

    @property
    def is_over(self) -> bool:
        """Return whether everything that it wrote has been read and it has gone."""
        return not self._pieces

    @property
    def streams(self) -> tuple[int, ...]:
        """The numbers of the files that something is to be read from."""
        return tuple(self._pieces)

    def give_turn(self, until_ms: int) -> None:
        """Let its time go on to a time in ms of the scenario."""
        if self._turns is not None:
            with suppress(BrokenPipeError):  # it has ended, which read() will tell
                os.write(self._turns, f"{until_ms}\n".encode())

    def read(self, timeout_s: float) -> list[Item]:
        """Return what it wrote since the last call, waiting for it up to ``timeout_s`` seconds."""
        items: list[Item] = []
        for key, _ in self._selector.select(timeout_s):
            stream = int(key.fd)
            data = self._read_from(stream)
            if data is None:
                continue
            *lines, rest = (self._pieces[stream] + data).split(b"\n")
            self._pieces[stream] = rest
            if not data:
                lines = [rest] if rest else []
                self._selector.unregister(stream)
                del self._pieces[stream]
            items.extend(item for line in lines if (item := self._item(stream, line)) is not None)
        return items

    def wait(self) -> int:
        """Return its exit code; negative for the signal that ended it."""
        with suppress(subprocess.TimeoutExpired):
            return self._process.wait(_GRACE_S)
        self._process.kill()
        return self._process.wait()

    def interrupt(self) -> list[Item]:
        """Ask it to end, and return what it still had to say."""
        self._signal(signal.SIGINT)
        self._end_turns()
        items: list[Item] = []
        deadline = time.monotonic() + _GRACE_S
        while not self.is_over and time.monotonic() < deadline:
            items.extend(self.read(0.1))
        return items

    def close(self) -> None:
        """End it, if it still runs, and let go of its pipes."""
        self._signal(signal.SIGKILL)
        self._process.wait()
        self._selector.close()
        os.close(self._records)
        self._end_turns()
        for stream in (self._process.stdout, self._process.stderr):
            if stream is not None:
                stream.close()

    def _end_turns(self) -> None:
        """Close the pipe of turns, so that a process that waits for one learns that there will be none."""
        if self._turns is not None:
            os.close(self._turns)
            self._turns = None

    def _signal(self, number: int) -> None:
        if self._process.poll() is None:
            with suppress(ProcessLookupError):
                os.kill(self._process.pid, number)

    def _read_from(self, stream: int) -> bytes | None:
        try:
            return os.read(stream, 65536)
        except BlockingIOError:
            return None

    def _item(self, stream: int, line: bytes) -> Item | None:
        text = line.decode("utf-8", "replace").rstrip("\r")
        if stream == self._records:
            with suppress(ValueError):  # the last line of a process that was killed may be cut
                record = json.loads(text)
                return record if isinstance(record, dict) else None
            return None
        if stream == self._errors:
            self.complaints.append(text)
            return None
        return Console(text)
