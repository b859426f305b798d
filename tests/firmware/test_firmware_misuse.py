"""Machine code checks no bounds: whatever a user can get wrong is caught before it, or does no harm."""

from array import array
from types import SimpleNamespace

import pymavlink_oracle as oracle
import pytest
from firmware_runs import Exercise


def heartbeat(firmware: SimpleNamespace) -> type:
    return type("Heartbeat", (firmware.message.Message,), oracle.describe("HEARTBEAT"))


@pytest.mark.parametrize("wrong", [5, None, b"", bytearray(1), array("i", [1])])
def test_another_live_array_is_refused(firmware: SimpleNamespace, wrong: object) -> None:
    """A number in its place would be taken for an address, a short array would be read beyond its end."""
    message = heartbeat(firmware)(live=("custom_mode", "type"))
    message.live[0] = 7
    link = firmware.mavlink.Link(None)
    before = bytes(link.encode(message))
    with pytest.raises(AttributeError, match="live"):
        message.live = wrong
    assert bytes(link.encode(message)) == before
    receiving = firmware.mavlink.Link(None, messages=[message])
    assert list(receiving.feed(before)) == [message]
    assert message.get("custom_mode") == 7


def test_data_that_shrink_are_at_their_end(firmware: SimpleNamespace) -> None:
    """The caller's bytearray is read while receive() is called; what is gone is not read."""
    frame = oracle.raw_frame(0, b"\x01" * 9, extra=50)
    link = firmware.mavlink.Link(None, messages=[heartbeat(firmware)])
    data = bytearray(frame + bytes(2000))
    link.put(data)
    assert link.receive() is not None
    data[:] = bytes(10)
    assert link.receive() is None
    assert len(list(link.feed(bytes(5000) + frame))) == 1


@pytest.mark.parametrize("wrong", [5, "text", [1, 2], array("H", [1, 2]), 1.5])
def test_what_is_no_bytes_is_refused_and_forgotten(firmware: SimpleNamespace, wrong: object) -> None:
    link = firmware.mavlink.Link(None, messages=[heartbeat(firmware)])
    with pytest.raises(TypeError, match="what arrives is bytes"):
        link.feed(wrong)
    assert len(list(link.feed(oracle.raw_frame(0, b"\x01" * 9, extra=50)))) == 1


def test_version_and_signing_are_set_once(firmware: SimpleNamespace) -> None:
    """To set them later would change half of what they stand for."""
    link = firmware.mavlink.Link(None)
    for name, value in (("version", 1), ("signing", firmware.signing.Signing(bytes(32)))):
        with pytest.raises(AttributeError):
            setattr(link, name, value)
    assert (link.version, link.signing) == (2, None)
    assert firmware.mavlink.Link(None, version=1).version == 1


def test_senders_are_kept_over_a_reset(firmware: SimpleNamespace, tmp_path) -> None:
    """A frame accepted before save() is not accepted again after load()."""
    key, path = bytes(range(32)), str(tmp_path / "signing.bin")
    now = 1_800_000_000
    sender = firmware.mavlink.Link(None, 7, signing=firmware.signing.Signing(key, 3, clock=lambda: now))
    frame = bytes(sender.encode(heartbeat(firmware)()))
    first = firmware.signing.Signing(key, clock=lambda: now)
    assert first.accepts(frame)
    first.save(path)
    assert not firmware.signing.load(path, clock=lambda: now).accepts(frame)
    again = bytes(sender.encode(heartbeat(firmware)()))
    assert firmware.signing.load(path, clock=lambda: now).accepts(again)


def test_misuse_does_no_harm_in_machine_code(exercise: Exercise) -> None:
    """The same on MicroPython, where it would end in a fault, or send what lies behind a buffer."""
    classes = [oracle.describe("HEARTBEAT")]
    frame = oracle.raw_frame(0, b"\x01" * 9, extra=50).hex()
    assert exercise("misuse", classes=classes, frame=frame) == {"same": True, "received": [1, 0, 1], "refused": 4}
