"""Frames that go out are byte for byte what pymavlink sends."""

import random
from types import SimpleNamespace

import pymavlink_oracle as oracle
import pytest
from firmware_runs import Exercise, as_json, as_read


def names_of(version: int) -> list[str]:
    return [name for name in oracle.NAMES if version == 2 or oracle.BY_NAME[name].id <= 255]


@pytest.mark.parametrize("version", [1, 2])
def test_frames_are_those_of_pymavlink(exercise: Exercise, version: int) -> None:
    """Random values through set(), encode() and raw(), plain and machine code, all truncated lengths that occur."""
    chance = random.Random(version)
    names = names_of(version)
    descriptions = [oracle.describe(name) for name in names]
    cases, expected, read = [], [], []
    for _ in range(1500):
        index = chance.randrange(len(names))
        values = oracle.random_values(descriptions[index], chance)
        sequence = chance.randrange(256)
        cases.append([index, sequence, {field: as_json(value) for field, value in values.items()}])
        expected.append(oracle.frame(names[index], values, sequence, version).hex())
        read.append({field: as_read(value) for field, value in values.items()})
    results = exercise(
        "sent_frames",
        classes=descriptions,
        version=version,
        system=oracle.SYSTEM,
        component=oracle.COMPONENT,
        cases=cases,
    )
    assert set(results) == exercise.forms
    for frames in results.values():
        assert [found for found, _ in frames] == expected
        assert [values for _, values in frames] == read


FAR = oracle.described("FAR", "one:1H", 0xABCDEF)


def test_ids_have_three_bytes(exercise: Exercise) -> None:
    """No message of the common dialect has an id above 65535, nor an array of one element; both are legal."""
    arguments = {"classes": [FAR], "version": 2, "system": oracle.SYSTEM, "component": oracle.COMPONENT}
    results = exercise("sent_frames", **arguments, cases=[[0, 9, {"one": [0x1234]}]])
    frame = oracle.raw_frame(0xABCDEF, b"\x34\x12", extra=7)
    for frames in results.values():
        assert frames == [[frame.hex(), {"one": [0x1234]}]]
    for reuse in (False, True):
        for answer in exercise("decode", classes=[FAR], pieces=[frame.hex()], reuse=reuse, size=560).values():
            assert answer["messages"] == [["FAR", "3412", [oracle.SYSTEM, oracle.COMPONENT, 9]]]


def test_pymavlink_reads_our_stream(firmware: SimpleNamespace) -> None:
    """A receiver finds the values, the source, and sequence numbers that go on and wrap."""
    description = oracle.describe("BATTERY_STATUS")
    message = type("BatteryStatus", (firmware.message.Message,), description)()
    sent = bytearray()
    stream = SimpleNamespace(write=lambda frame: sent.extend(frame) or len(frame))
    link = firmware.mavlink.Link(stream, system_id=7, component_id=180)
    for turn in range(300):
        message.set("voltages", [11000 + turn] + [65535] * 9)
        message.set("current_battery", -turn)
        assert link.send(message) == len(link.encode(message))
    found = oracle.parse(bytes(sent))
    assert [heard.voltages[0] for heard in found] == [11000 + turn for turn in range(300)]
    assert [heard.current_battery for heard in found] == [-turn for turn in range(300)]
    assert [heard.get_seq() for heard in found] == [turn % 256 for turn in range(300)]
    assert {(heard.get_srcSystem(), heard.get_srcComponent()) for heard in found} == {(7, 180)}


def test_encode_keeps_the_sequence_and_the_buffer(firmware: SimpleNamespace) -> None:
    """encode() may be called to look; the next frame is written over the last, nothing of which shines through."""
    link = firmware.mavlink.Link(None)
    full = type("Full", (firmware.message.Message,), {"ID": 1, "LENGTH": 200})(unknown=False)
    full.wire[:] = b"\xff" * 200
    short = type("Short", (firmware.message.Message,), {"ID": 2, "LENGTH": 20})(unknown=False)
    fresh = bytes(firmware.mavlink.Link(None).encode(short))
    first = link.encode(full)
    assert isinstance(first, memoryview)
    assert bytes(link.encode(full)) == bytes(first)
    assert bytes(link.encode(short)) == fresh
    assert link.sequence == 0


def test_sequence_can_be_set_and_wraps(firmware: SimpleNamespace) -> None:
    """A link that goes on where another one stopped; a number beyond one byte wraps as the sequence itself does."""
    link = firmware.mavlink.Link(SimpleNamespace(write=len))
    message = type("Short", (firmware.message.Message,), {"LENGTH": 4})(unknown=False)
    for number, expected in ((255, 255), (256, 0), (-1, 255)):
        link.sequence = number
        assert link.sequence == expected
        assert link.encode(message)[4] == expected
        link.send(message)
        assert link.sequence == (expected + 1) & 0xFF


@pytest.mark.parametrize("taken", [None, 0, 5, OSError(5)])
def test_stream_that_does_not_take_the_frame_is_counted(firmware: SimpleNamespace, taken: object) -> None:
    """A full or broken stream never stops the loop; the sequence goes on, so that the receiver sees the loss."""

    def write(_frame: memoryview) -> object:
        if isinstance(taken, OSError):
            raise taken
        return taken

    link = firmware.mavlink.Link(SimpleNamespace(write=write))
    message = type("Short", (firmware.message.Message,), {"LENGTH": 4})(unknown=False)
    assert link.send(message) == (taken if isinstance(taken, int) else 0)
    assert (link.tx_errors, link.sequence) == (1, 1)


@pytest.mark.parametrize(
    "arguments",
    [
        {"system_id": 0},
        {"system_id": 256},
        {"component_id": 0},
        {"component_id": 256},
        {"version": 3},
        {"longest": 0},
        {"longest": 256},
    ],
)
def test_impossible_links_are_refused(firmware: SimpleNamespace, arguments: dict[str, int]) -> None:
    """0 is a broadcast address and never a source; a byte holds no more than 255."""
    with pytest.raises(ValueError, match=r"255|versions"):
        firmware.mavlink.Link(None, **arguments)


def test_messages_that_do_not_fit_are_refused(firmware: SimpleNamespace) -> None:
    """Machine code checks no bounds, so encode() does; MAVLink 1 has one byte for the id."""
    above = type("Above", (firmware.message.Message,), {"NAME": "ABOVE", "ID": 256, "LENGTH": 4, "BASE_LENGTH": 4})(
        unknown=False
    )
    firmware.mavlink.Link(None).encode(above)
    far = type("Far", (firmware.message.Message,), {"NAME": "FAR", "ID": 65536, "LENGTH": 4, "BASE_LENGTH": 4})(
        unknown=False
    )
    for message in (above, far):
        with pytest.raises(ValueError, match="MAVLink 1 has no message ids above 255"):
            firmware.mavlink.Link(None, version=1).encode(message)
    firmware.mavlink.Link(None, longest=4).encode(above)
    low = type("Low", (firmware.message.Message,), {"ID": 255, "LENGTH": 5, "BASE_LENGTH": 4})(unknown=False)
    assert firmware.mavlink.Link(None, version=1, longest=4).encode(low)[1] == 4
    for version, message in ((1, low), (2, above)):
        link = firmware.mavlink.Link(None, version=version, longest=3)
        before = bytes(link._frame)
        with pytest.raises(ValueError, match="too short for this message"):
            link.encode(message)
        assert bytes(link._frame) == before


def test_a_sender_alone_sends_what_a_link_sends(firmware: SimpleNamespace) -> None:
    """A board that only sends does without receiver.py."""
    message = type("Short", (firmware.message.Message,), {"ID": 7, "LENGTH": 4, "FIELDS": "a:I"})().update(a=0x1234567)
    frames: list[bytes] = []
    for kind in (firmware.sender.Sender, firmware.mavlink.Link):
        link = kind(SimpleNamespace(write=lambda frame: frames.append(bytes(frame)) or len(frame)), 3, 4)
        assert link.send(message) == len(frames[-1])
    assert frames[0] == frames[1]
