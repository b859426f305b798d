"""Ground stations that sign, and some that do not, against a vehicle whose Wi-Fi is signed."""

import hashlib
import shutil
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from ground_link import GroundLink
from in_process import build
from programs import BIN, Program
from pymavlink.dialects.v20 import common
from test_mavproxy import mavproxy

from codegen.sim.address import free_port

pytestmark = pytest.mark.timeout(150)

SPECS = Path(__file__).resolve().parents[1] / "projects" / "guarded" / "specs"
WORDS = "open_sesame"
KEY = hashlib.sha256(WORDS.encode()).digest()
"""As MAVProxy makes it of the words."""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project, built, with a flash that has the key."""
    folder = tmp_path_factory.mktemp("guarded")
    shutil.copytree(SPECS, folder / "specs")
    (folder / "specs" / "scenarios.yaml").write_text("scenarios:\n  nominal: {doc: Nothing happens., duration: 60 s}\n")
    build(folder)
    (folder / "flash").mkdir()
    (folder / "flash" / "signing.key").write_text(KEY.hex() + "\n")
    return folder


def gate(project: Path, port: int) -> Program:
    """Return the simulator, with what is in the flash."""
    target = ["--duration", "forever", "--out", f"udp:127.0.0.1:{port}", "--flash", "flash"]
    return Program("codegen sim", [str(BIN / "codegen"), "sim", *target], project)


@pytest.fixture(scope="module")
def running(project: Path, link_shared: GroundLink) -> Iterator[Program]:
    """The gate, which the link hears."""
    with gate(project, link_shared.port) as program:
        link_shared.wait_for("HEARTBEAT", 0)
        yield program


def is_answered(link: GroundLink) -> bool:
    """Return whether a PARAM_REQUEST_READ is, within a second of HEARTBEATs."""
    position = link.take_in()
    link.send.param_request_read_send(1, 1, b"GATE_SPEED", -1)
    for _ in range(3):
        position_of_beat = link.take_in()
        link.wait_for("HEARTBEAT", position_of_beat)
    return any(message.get_type() == "PARAM_VALUE" for message in link.heard[position:])


def sign(link: GroundLink, key: bytes | None, timestamp: int | None = None) -> None:
    """Let a link sign from now on, with a key of its own, and take every frame."""
    signing = link.send.signing
    signing.secret_key = key
    signing.sign_outgoing = key is not None
    signing.link_id = 3
    signing.timestamp = timestamp or int((time.time() - 1420070400) * 100000)
    signing.allow_unsigned_callback = lambda _mav, _message: True
    signing.stream_timestamps = {}


@pytest.mark.usefixtures("running")
def test_pymavlink_signs_both_ways(link_shared: GroundLink) -> None:
    """It is obeyed with the key alone; and it accepts each frame of the vehicle, which is signed."""
    sign(link_shared, None)
    assert not is_answered(link_shared)
    sign(link_shared, bytes(32))
    link_shared.send.signing.secret_key = bytes(32)
    sign(link_shared, KEY)
    link_shared.send.signing.allow_unsigned_callback = lambda _mav, _message: False
    position = link_shared.take_in()
    assert is_answered(link_shared)
    heard = link_shared.heard[position:]
    assert heard
    assert all(message.get_signed() for message in heard)


@pytest.mark.usefixtures("running")
def test_what_was_recorded_is_not_obeyed_again(link_shared: GroundLink, project: Path) -> None:
    """Not by the same vehicle, and not by the next one that starts with the same flash."""
    sign(link_shared, KEY)
    assert is_answered(link_shared)
    arm = link_shared.send.command_long_encode(1, 1, common.MAV_CMD_COMPONENT_ARM_DISARM, 0, 0, 21196, 0, 0, 0, 0, 0)
    recorded = bytes(arm.pack(link_shared.send))

    def answers() -> int:
        return sum(message.get_type() == "COMMAND_ACK" for message in link_shared.heard)

    before = answers()
    for _ in range(2):
        link_shared.write(recorded)
        for _ in range(3):
            link_shared.wait_for("HEARTBEAT")
    assert answers() == before + 1
    state = project / "flash" / "signing.key.wifi"
    kept = state.stat().st_mtime_ns if state.exists() else 0
    deadline = time.monotonic() + 60
    while not state.exists() or state.stat().st_mtime_ns == kept:
        assert time.monotonic() < deadline
        time.sleep(0.1)
    shutil.copytree(project, project.parent / "again")
    with GroundLink() as other, gate(project.parent / "again", other.port):
        other.wait_for("HEARTBEAT", 0)
        other.write(recorded)
        for _ in range(4):
            other.wait_for("HEARTBEAT")
        assert not [each for each in other.heard if each.get_type() == "COMMAND_ACK"]


def test_mavproxy_signs(project: Path, tmp_path: Path) -> None:
    """It gets the parameters once it has the key, and not before."""
    port = free_port()
    shutil.copytree(project, tmp_path / "project")
    with mavproxy(port, tmp_path) as station, gate(tmp_path / "project", port):
        station.wait_for("Detected vehicle 1:1")
        time.sleep(3)
        assert "parameters" not in station.written.partition("Detected vehicle")[2]
        station.say(f"signing key {WORDS}")
        station.repeat("param fetch", r"Received \d+ parameters")
