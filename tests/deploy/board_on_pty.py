"""The stand-in of tests/deploy/standin on a pseudo terminal, with a flash that survives its ends."""

import json
import os
import pty
import select
import subprocess
import sys
import threading
import tty
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

MICROPYTHON = Path(sys.executable).parent / "micropython"
PROGRAM = Path(__file__).parent / "standin" / "board.py"
BLOCK = 4096


class Board:
    """A board that has power: ``port`` is its terminal."""

    def __init__(self, image: Path, blocks: int = 256, **settings: Any) -> None:
        if not image.exists():
            image.write_bytes(b"\xff" * (BLOCK * blocks))
        self._master, self._slave = pty.openpty()
        tty.setraw(self._slave)
        self.port = os.ttyname(self._slave)
        command = [MICROPYTHON, "-X", "heapsize=1m", PROGRAM, image, json.dumps(settings)]
        self._process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=self._master, stderr=subprocess.PIPE)
        assert self._process.stderr is not None
        os.read(self._process.stderr.fileno(), 1)  # it is there
        self._wake = os.pipe()
        self._cable = threading.Thread(target=self._carry, daemon=True)
        self._cable.start()

    def _carry(self) -> None:
        """Carry the computer's output to the interpreter, and end with the cable."""
        assert self._process.stdin is not None
        with suppress(OSError):
            while self._wake[0] not in (ready := select.select([self._master, self._wake[0]], [], [], 0.05)[0]):
                if self._process.poll() is not None:
                    break
                if ready:
                    os.write(self._process.stdin.fileno(), os.read(self._master, 65536))
        os.close(self._master)

    def cut(self) -> None:
        """Take the power away, and the cable with it."""
        self._process.kill()
        self._process.wait()
        os.write(self._wake[1], b"!")
        self._cable.join()

    def close(self) -> None:
        self.cut()
        for file in (self._slave, *self._wake):
            os.close(file)
        for stream in (self._process.stdin, self._process.stderr):
            assert stream is not None
            with suppress(OSError):
                stream.close()


@contextmanager
def powered(image: Path, **settings: Any) -> Iterator[Board]:
    board = Board(image, **settings)
    try:
        yield board
    finally:
        board.close()
