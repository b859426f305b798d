"""Ground stations over TCP: those that connect to the vehicle, and those that it connects to."""

import json
import shutil
import socket
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from ground_link import GroundLink
from in_process import build
from programs import BIN, Program, wait_until
from test_mavproxy import mavproxy
from test_mavsdk import STATION, Station

pytestmark = pytest.mark.timeout(150)

SPECS = Path(__file__).resolve().parents[1] / "projects" / "networked" / "specs"
PARAMETER = "MAST_SPEED"


def free_tcp_port() -> int:
    """A TCP port of this host that nobody uses at the moment."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project, built."""
    folder = tmp_path_factory.mktemp("networked")
    shutil.copytree(SPECS, folder / "specs")
    build(folder)
    return folder


class Mast(Program):
    """The simulator; stations connect to its port `stations`, and it connects to `base`."""

    def __init__(self, project: Path, *options: str) -> None:
        self.stations, self.base = free_tcp_port(), free_tcp_port()
        links = ["--link", f"stations={self.stations}", "--link", f"base=127.0.0.1:{self.base}"]
        target = ["--duration", "forever", "--out", "udp:127.0.0.1:9", *links]
        super().__init__("codegen sim", [str(BIN / "codegen"), "sim", *target, *options], project)

    def is_listening(self) -> bool:
        """Return whether somebody could connect."""
        with socket.socket() as probe:
            return probe.connect_ex(("127.0.0.1", self.stations)) == 0


@pytest.fixture
def mast(project: Path) -> Iterator[Mast]:
    """The mast in real time, which listens."""
    with Mast(project) as program:
        wait_until(program.is_listening, "the mast listens")
        yield program


def is_answered(link: GroundLink) -> None:
    """Let a link hear HEARTBEATs, and read a parameter."""
    link.wait_for("HEARTBEAT")
    link.send.heartbeat_send(6, 8, 0, 0, 0)
    assert link.parameter(PARAMETER).param_value == 40


@pytest.mark.parametrize("runtime", ["micropython", "cpython"])
def test_pymavlink_at_both_ends(project: Path, runtime: str) -> None:
    """Two stations connect, one waits to be connected to; what one sets the others hear of."""
    with Mast(project, "--runtime", runtime) as mast, GroundLink(f"tcpin:127.0.0.1:{mast.base}") as base:
        wait_until(mast.is_listening, "the mast listens")
        with (
            GroundLink(f"tcp:127.0.0.1:{mast.stations}") as one,
            GroundLink(f"tcp:127.0.0.1:{mast.stations}", 254) as two,
        ):
            for link in (base, one, two):
                is_answered(link)
            at = two.take_in()
            assert one.set_parameter(PARAMETER, 50).param_value == 50
            assert two.wait_for("PARAM_VALUE", at).param_value == 50
            for link in (base, one, two):
                sequence = [each.get_seq() for each in link.heard[-20:]]
                assert sequence == [(sequence[0] + index) & 0xFF for index in range(len(sequence))]


def test_who_is_not_listed_is_told_and_not_obeyed(mast: Mast) -> None:
    """The policy of a link counts over TCP as over everything else."""
    with GroundLink(f"tcp:127.0.0.1:{mast.stations}", 9) as stranger:
        stranger.wait_for("HEARTBEAT")
        stranger.send.param_request_read_send(1, 1, PARAMETER.encode(), -1)
        for _ in range(4):
            stranger.wait_for("HEARTBEAT")
        assert stranger.since(0, "PARAM_VALUE") == []


def test_a_station_comes_again(mast: Mast) -> None:
    """In the middle of a frame, with garbage before it: whoever connects next is served."""
    for end in (b"", b"\xfd\x09\x00\x00", b"\xfd\xff" * 600):
        with GroundLink(f"tcp:127.0.0.1:{mast.stations}") as link:
            is_answered(link)
            link.write(end)
    with GroundLink(f"tcp:127.0.0.1:{mast.stations}") as link:
        link.write(b"\xfd\x20\x00\x00\x00\xff\xbe\x4c\x00\x00")
        is_answered(link)


def test_the_base_comes_later_and_again(mast: Mast) -> None:
    """It is not there when the mast starts, and goes away in between."""
    mast.wait_for("base has a socket that fails")
    for _ in range(2):
        with GroundLink(f"tcpin:127.0.0.1:{mast.base}") as base:
            is_answered(base)


def test_a_reader_that_stands_still_holds_nobody_up(mast: Mast) -> None:
    """Its buffers fill up; the others get what is theirs, and it is closed."""
    with socket.socket() as stuck, GroundLink(f"tcp:127.0.0.1:{mast.stations}") as link:
        stuck.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1)
        stuck.connect(("127.0.0.1", mast.stations))
        is_answered(link)
        until = time.monotonic() + 8
        while time.monotonic() < until:
            is_answered(link)
        stuck.settimeout(1)
        while stuck.recv(65536):
            pass


@pytest.mark.parametrize("kind", ["tcp", "tcpin"])
def test_mavproxy(mast: Mast, tmp_path: Path, kind: str) -> None:
    """It shows the mast's parameters and sets one, whoever has connected to whom."""
    port = mast.stations if kind == "tcp" else mast.base
    with mavproxy(port, tmp_path, kind=kind) as program:
        program.wait_for("Received 1 parameters|Detected vehicle")
        program.repeat(f"param show {PARAMETER}", rf"{PARAMETER}\s+40\.0")
        program.say(f"param set {PARAMETER} 60")
        program.repeat(f"param show {PARAMETER}", rf"{PARAMETER}\s+60\.0")


@pytest.mark.parametrize("kind", ["tcpout", "tcpin"])
def test_mavsdk(mast: Mast, tmp_path: Path, kind: str) -> None:
    """It finds the mast and reads a parameter, whoever has connected to whom."""
    where = f"{kind}://127.0.0.1:{mast.stations if kind == 'tcpout' else mast.base}"
    with Program("MAVSDK", [sys.executable, str(STATION), where], tmp_path) as program:
        found = json.loads(program.wait_for(r"=system= (\{.*\})")[1])
        assert found["number"] == 1
        assert Station(program).do("param.get_param_int", PARAMETER) == 40
