"""The ports of templates/firmware/program under both interpreters: the checks of ports_checks.py, over true sockets."""

import socket
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from firmware_runs import failed_checks


def serve(echo: socket.socket, other: socket.socket) -> None:
    """Answer until the first socket gets b"end"."""
    threading.Thread(target=serve_other, args=(other,), daemon=True).start()
    while True:
        data, sender = echo.recvfrom(2000)
        if data == b"end":
            other.sendto(b"end", other.getsockname())
            return
        if data == b"tell the other":
            other.sendto(b"from the other", sender)
        else:
            echo.sendto(data.upper(), sender)


def serve_other(other: socket.socket) -> None:
    while True:
        data, sender = other.recvfrom(2000)
        if data == b"end":
            return
        if not data.startswith(b"s"):
            other.sendto(b"other: " + data, sender)


@pytest.fixture
def peers() -> Iterator[tuple[int, int]]:
    """The UDP ports of two who answer on this computer."""
    with socket.socket(type=socket.SOCK_DGRAM) as echo, socket.socket(type=socket.SOCK_DGRAM) as other:
        for each in (echo, other):
            each.bind(("127.0.0.1", 0))
        thread = threading.Thread(target=serve, args=(echo, other))
        thread.start()
        yield echo.getsockname()[1], other.getsockname()[1]
        echo.sendto(b"end", echo.getsockname())
        thread.join()


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_ports(interpreter: str, peers: tuple[int, int], tmp_path: Path) -> None:
    """Frames stay whole and in order; nothing blocks, raises or, in the steady path, allocates."""
    assert failed_checks(interpreter, "ports_checks.py", f"{tmp_path} {peers[0]} {peers[1]}") == ""
