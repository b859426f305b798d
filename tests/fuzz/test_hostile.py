"""A sample of the hostile bytes that `make fuzz` lets arrive, and what it says where something is wrong."""

import random
from pathlib import Path

import hostile
import measure
import pytest
from pymavlink.dialects.v20 import common
from whole_program import whole_program

FRAME = bytes(common.MAVLink_ping_message(1, 7, 0, 0).pack(common.MAVLink(None, srcSystem=255)))
KNOWN = {4: 237}


def test_nothing_is_wrong(tmp_path: Path) -> None:
    """Every receiver finds exactly the frames that are right, and raises nothing."""
    found = list(hostile.outcomes(2, 40_000, measure.ROOT / "generated", tmp_path))
    assert len(found) == len(hostile.FORMS) * (1 + len(hostile.PORTS))
    assert [faults for _, faults in found] == [[]] * len(found)


CHANGES = [
    ("receiver.py", "self._state[0] = self._state[3] + 1", "pass", "bytes", "PINGs are answered"),
    ("receiver.py", "self._state[0] = self._state[3] + 1", "pass", "datagrams", "PINGs are answered"),
    ("inbox.py", "_WORK = const(256)", "_WORK = const(4096)", "bytes", "bytes were looked at in one pass"),
    ("services.py", "def _answer_ping(self, message):", "def _answer_ping(self, message, _):", "bytes", "exceptions: "),
]
"""A file of the firmware, what is changed in it, the port at which the bytes arrive, and what is said of that."""


@pytest.mark.parametrize(("file", "old", "new", "port", "said"), CHANGES)
def test_what_is_wrong_is_found(tmp_path: Path, file: str, old: str, new: str, port: str, said: str) -> None:
    """Frames that are lost, too much work for a pass, exceptions."""
    whole_program(measure.ROOT / "generated", tmp_path)
    text = (tmp_path / "firmware" / file).read_text()
    assert text.count(old) == 1
    (tmp_path / "firmware" / file).write_text(text.replace(old, new))
    faults = hostile.rover_faults(tmp_path, hostile.drawn(2, 40_000), tmp_path, "machine code", port)
    assert any(said in fault for fault in faults), faults


def test_the_search_finds_what_is_right() -> None:
    """Behind false starts, and not where a checksum is wrong or the end is missing."""
    assert list(hostile.frames_in(b"\xfd\xff\x00" + FRAME + b"\xfe" + FRAME, KNOWN)) == [FRAME, FRAME]
    assert not list(hostile.frames_in(FRAME[:-1], KNOWN))
    assert not list(hostile.frames_in(FRAME[:-1] + bytes((FRAME[-1] ^ 1,)), KNOWN))
    assert not list(hostile.frames_in(FRAME, {0: 50}))


def test_the_bytes_are_hostile() -> None:
    """Most of them are no frame, and none restarts the vehicle."""
    stream = hostile.drawn(3, 50_000)
    assert stream == hostile.drawn(3, 50_000)
    data = b"".join(stream.pieces)
    found = list(hostile.frames_in(data, {number: kind.crc_extra for number, kind in common.mavlink_map.items()}))
    assert 0.2 * len(data) < sum(map(len, found)) < 0.8 * len(data)
    lot = random.Random(1)
    sender = common.MAVLink(None)
    frames = [hostile._frame(lot, sender) for _ in range(3000)]
    restart = hostile.REBOOT.to_bytes(2, "little")
    assert not any(frame[0] == 0xFD and frame[7:10] == b"\x4c\0\0" and frame[38:40] == restart for frame in frames)
