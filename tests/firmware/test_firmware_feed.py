"""Frames are decoded however they are cut up, and no bytes whatever stop the receiver."""

import random
from types import SimpleNamespace
from typing import Any

import pymavlink_oracle as oracle
import pytest
from firmware_runs import Exercise
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

KNOWN = oracle.NAMES[:-4]
UNKNOWN = ("VIBRATION", "TUNNEL", "WHEEL_DISTANCE")
FUZZ = settings(max_examples=400, suppress_health_check=[HealthCheck.function_scoped_fixture])


def cut(data: bytes, chance: random.Random, longest: int) -> list[bytes]:
    """The data in pieces of random lengths, empty ones too."""
    pieces = []
    while data:
        size = chance.randrange(longest + 1)
        pieces.append(data[:size])
        data = data[size:]
    return pieces


def receiver(firmware: SimpleNamespace, *names: str) -> Any:
    """A link that decodes the named messages."""
    classes = [type(name, (firmware.message.Message,), oracle.describe(name)) for name in names]
    return firmware.mavlink.Link(None, messages=classes)


def counters(link: Any) -> tuple[int, ...]:
    return link.received, link.signed, link.unknown, link.crc_errors, link.dropped


class Traffic:
    """A random stream: both versions, signed frames, unknown messages, garbage and damaged frames."""

    def __init__(self, seed: int, frames: int) -> None:
        self.chance = random.Random(seed)
        self.stream = bytearray()
        self.messages: list[list[Any]] = []
        self.signed = self.unknown = self.damaged = 0
        for _ in range(frames):
            self.chance.choice([self.add_good, self.add_good, self.add_good, self.add_unknown, self.add_garbage])()
            if self.chance.random() < 0.2:
                self.add_damaged()
        # A piece of garbage that looks like a frame is known to be none when as much has arrived as it announces.
        self.stream += bytes(300)

    def random_frame(self, names: tuple[str, ...]) -> tuple[str, dict[str, Any], int, int, bool, bytes]:
        name = self.chance.choice(names)
        values = oracle.random_values(oracle.describe(name), self.chance)
        sequence = self.chance.randrange(256)
        version = self.chance.choice([1, 2, 2]) if oracle.BY_NAME[name].id <= 255 else 2
        signed = version == 2 and self.chance.random() < 0.3
        return name, values, sequence, version, signed, oracle.frame(name, values, sequence, version, signed)

    def add_good(self) -> None:
        name, values, sequence, version, signed, frame = self.random_frame(KNOWN)
        self.stream += frame
        self.signed += signed
        payload = oracle.payload(name, values, base_only=version == 1)
        self.messages.append([name, payload.hex(), [oracle.SYSTEM, oracle.COMPONENT, sequence]])

    def add_unknown(self) -> None:
        self.stream += self.random_frame(UNKNOWN)[-1]
        self.unknown += 1

    def add_garbage(self) -> None:
        starts = [b"\xfd", b"\xff", b"B", b"\xfe\x09\x01\x01\x01\x00", b"\xfd\xff\x00\x00\x01\x01\x01\x93\x00\x00"]
        self.stream += b"".join(self.chance.choices(starts, k=self.chance.randrange(1, 30)))

    def add_damaged(self) -> None:
        frame = bytearray(b"\xfe\xfe")
        while 0xFD in frame[1:] or 0xFE in frame[1:]:
            *_, version, _, good = self.random_frame(KNOWN)
            frame = bytearray(good)
            frame[6 if version == 1 else 10] ^= 1 << self.chance.randrange(8)
        self.stream += frame
        self.damaged += 1


@pytest.mark.parametrize(("longest", "size"), [(1, 280), (7, 280), (300, 280), (300, 560), (1 << 20, 281)])
@pytest.mark.parametrize("reuse", [False, True], ids=["feed", "put-and-receive"])
def test_every_message_of_a_mixed_stream_is_found(exercise: Exercise, longest: int, size: int, reuse: bool) -> None:
    """Hundreds of frames among garbage full of magic bytes, in pieces from one byte to the whole, in small buffers."""
    traffic = Traffic(seed=longest, frames=500)
    pieces = [piece.hex() for piece in cut(bytes(traffic.stream), traffic.chance, longest)]
    classes = [oracle.describe(name) for name in KNOWN]
    answers = exercise("decode", classes=classes, pieces=pieces, reuse=reuse, size=size)
    assert set(answers) == exercise.forms
    for answer in answers.values():
        assert answer["messages"] == traffic.messages
        counted = answer["counters"]
        assert counted["received"] == len(traffic.messages)
        assert counted["unknown"] >= traffic.unknown
        assert counted["signed"] == traffic.signed
        assert counted["crc_errors"] >= traffic.damaged
        assert counted["dropped"] > 0
        assert counted["refused"] == 0


def test_longest_frames_fill_the_smallest_buffer(exercise: Exercise) -> None:
    """280 bytes, a full payload with a signature, in a buffer of 280: nothing waits for room that never comes."""
    names = ("FILE_TRANSFER_PROTOCOL", "LOGGING_DATA", "TUNNEL")
    frame = oracle.raw_frame(385, b"\x11" * 255, extra=147, flags=1, tail=bytes(13))
    assert len(frame) == 280
    stream = b"\xfd" + frame * 7
    classes = [oracle.describe(name) for name in names]
    for longest in (1, 279, 280, 281, len(stream)):
        pieces = [stream[at : at + longest].hex() for at in range(0, len(stream), longest)] + [bytes(300).hex()]
        for answer in exercise("decode", classes=classes, pieces=pieces, reuse=True, size=280).values():
            assert [name for name, *_ in answer["messages"]] == ["TUNNEL"] * 7


def test_buffer_that_holds_no_frame_is_refused(firmware: SimpleNamespace) -> None:
    """A receiver that waits for more than it can hold would wait forever."""
    firmware.receiver.Receiver(size=280)
    with pytest.raises(ValueError, match="280"):
        firmware.receiver.Receiver(size=279)


def test_clean_stream_has_no_errors(firmware: SimpleNamespace) -> None:
    """Counters stay at zero unless there is a reason."""
    link = receiver(firmware, *KNOWN)
    values = oracle.random_values(oracle.describe("BATTERY_STATUS"), random.Random(3))
    for version, signed in ((1, False), (2, False), (2, True)):
        (message,) = link.feed(oracle.frame("BATTERY_STATUS", values, 77, version, signed))
        assert message.wire == oracle.payload("BATTERY_STATUS", values, base_only=version == 1)
        assert (message.source_system, message.source_component, message.source_sequence) == (
            oracle.SYSTEM,
            oracle.COMPONENT,
            77,
        )
    assert counters(link) == (3, 1, 0, 0, 0)


def test_newer_extensions_are_left_out(firmware: SimpleNamespace) -> None:
    """A sender may know more extension fields: its checksum covers them, our payload keeps its length."""
    link = receiver(firmware, "HEARTBEAT")
    (message,) = link.feed(oracle.raw_frame(0, bytes(range(1, 21)), extra=50))
    assert message.wire == bytes(range(1, 10))
    (message,) = link.feed(oracle.raw_frame(0, bytes(range(1, 256)), extra=50))
    assert message.wire == bytes(range(1, 10))
    assert counters(link) == (2, 0, 0, 0, 0)


def test_frames_need_not_be_truncated(firmware: SimpleNamespace) -> None:
    """A sender may leave the zeros in, and may send an empty payload for all zeros."""
    link = receiver(firmware, "HEARTBEAT")
    for payload in (bytes(9), bytes(1), b""):
        (message,) = link.feed(oracle.raw_frame(0, payload, extra=50))
        assert message.wire == bytes(9)


def test_unknown_incompatible_flags_are_dropped(firmware: SimpleNamespace) -> None:
    """Such a frame means something else; the one after it counts."""
    link = receiver(firmware, "HEARTBEAT")
    frame = oracle.raw_frame(0, bytes(range(1, 10)), extra=50)
    for flags in (0x02, 0x03, 0x80):
        assert len(list(link.feed(oracle.raw_frame(0, bytes(range(1, 10)), extra=50, flags=flags) + frame))) == 1
    assert counters(link) == (3, 0, 0, 0, 3)


def test_frame_behind_a_false_magic_is_not_lost(firmware: SimpleNamespace) -> None:
    """A magic byte in garbage announces a frame that would swallow the true one."""
    frame = oracle.frame("HEARTBEAT", oracle.random_values(oracle.describe("HEARTBEAT"), random.Random(5)), 1)
    for false in (b"\xfd", b"\xfe", b"\xfd\x14\x00\x00", b"\xfe\x09\x00\x01\x01\x00", b"\xfd\xfd\xfe\xfe"):
        link = receiver(firmware, "HEARTBEAT")
        assert len(list(link.feed(false + frame + bytes(280)))) == 1, false.hex()


def test_what_announces_no_known_message_is_not_waited_for(firmware: SimpleNamespace) -> None:
    """The frame behind it is there at once, and not only when as much has arrived as the false one announces."""
    frame = oracle.raw_frame(0, bytes(range(1, 10)), extra=50)
    for false in (b"\xfd\xff\x00", b"\xfe\xff\xff\xff\xff\xff", b"\xfd", b"\xfd\xff\x01\x00\x01\x01\x01\x93\x00\x00"):
        link = receiver(firmware, "HEARTBEAT")
        assert len(list(link.feed(false + frame))) == 1, false.hex()


def test_a_frame_that_never_becomes_whole_is_given_up(firmware: SimpleNamespace) -> None:
    """It announces a message that is known and 255 bytes of it; who waited long enough finds what is behind it."""
    frame = oracle.raw_frame(0, bytes(range(1, 10)), extra=50)
    link = receiver(firmware, "HEARTBEAT")
    link.put(b"\xfd\xff\x00\x00\x01\x01\x01\x00\x00\x00" + frame)
    assert link.receive() is None
    link.give_up()
    assert link.receive().wire == bytes(range(1, 10))
    link.give_up()  # nothing is left
    assert link.receive() is None


def test_frame_in_an_unknown_message_is_not_hidden(firmware: SimpleNamespace) -> None:
    """Nobody can tell such a message from bytes that only look like one; one that is known does hide its content."""
    inner = oracle.raw_frame(0, bytes(range(1, 10)), extra=50)
    for count, link in ((1, receiver(firmware, "HEARTBEAT")), (0, receiver(firmware, "HEARTBEAT", "LOG_DATA"))):
        found = list(link.feed(oracle.raw_frame(120, bytes(7) + inner + bytes(69), extra=134)))
        assert [message.ID for message in found] == ([0] if count else [120])


def test_only_so_many_bytes_are_looked_at(firmware: SimpleNamespace) -> None:
    """A receiver with a limit is given nothing more until it is set anew, and loses nothing."""
    frame = oracle.raw_frame(0, bytes(range(1, 10)), extra=50)
    for noise in (bytes(500), b"\xfe" * 500, b"\xfd\x01\xff" * 170, (b"\xfe\xff\x00\x00\x00\x00" * 80)):
        link = receiver(firmware, "HEARTBEAT")
        link._state[17] = len(noise) + 3 * len(frame) + 280
        link.put(noise + frame * 3 + bytes(280) + b"beyond")
        link._state[16] = 100
        found = turns = 0
        while found < 3:
            link._state[15] = 0
            while link.receive() is not None:
                found += 1
            assert link._state[15] <= 100 + 280
            turns += 1
        assert 5 <= turns < 1000


def test_messages_not_taken_come_later(firmware: SimpleNamespace) -> None:
    """Stopping in the middle of the iterator, or not starting it, loses nothing; feed() may be called meanwhile."""
    frames = [oracle.raw_frame(0, bytes([number]), extra=50) for number in range(1, 7)]
    link = receiver(firmware, "HEARTBEAT")
    link.feed(frames[0])
    found = [next(iter(link.feed(frames[1] + frames[2]))).wire[0]]
    for message in link.feed(frames[3]):
        found.append(message.wire[0])
        if message.wire[0] == 3:
            found += [inner.wire[0] for inner in link.feed(frames[4])]
    assert found == [1, 2, 3, 4, 5]
    assert [message.wire[0] for message in link.feed(frames[5])] == [6]


def test_nothing_is_no_data(firmware: SimpleNamespace) -> None:
    """UART.read() returns None without data; views and arrays of bytes do as well as bytes."""
    link = receiver(firmware, "HEARTBEAT")
    frame = oracle.raw_frame(0, b"\x01", extra=50)
    assert list(link.feed(None)) == []
    assert list(link.feed(b"")) == []
    for data in (frame, bytearray(frame), memoryview(frame)):
        assert len(list(link.feed(data))) == 1


def test_data_put_twice_are_all_there(firmware: SimpleNamespace) -> None:
    """Two interrupts may bring bytes before the loop comes around; a frame may be cut between them."""
    link = receiver(firmware, "HEARTBEAT")
    stream = b"".join(oracle.raw_frame(0, bytes([number]), extra=50) for number in range(1, 201))
    link.put(stream[:1001])
    assert link.receive().wire[0] == 1
    link.put(stream[1001:1500])
    link.put(None)
    link.put(bytearray(stream[1500:1501]))
    link.put(memoryview(stream)[1501:])
    found = [2]
    while link.receive() is not None:
        found.append(found[-1] + 1)
    assert found[:-1] == list(range(2, 201))
    assert link.receive() is None


def test_message_objects_are_used_again(firmware: SimpleNamespace) -> None:
    """An object holds what came last, and of a longer payload nothing is left; a class makes an object for each."""
    description = oracle.describe("HEARTBEAT")
    heartbeat = type("Heartbeat", (firmware.message.Message,), description)
    first = oracle.raw_frame(0, bytes(range(1, 10)), extra=50)
    second = oracle.raw_frame_1(0, b"\x2a" + bytes(8), extra=50)
    once = heartbeat()
    link = firmware.mavlink.Link(None, messages=[once])
    for frame, wire in ((first, bytes(range(1, 10))), (second, b"\x2a" + bytes(8))):
        (message,) = link.feed(frame)
        assert message is once
        assert once.wire == wire
        assert (once.source_system, once.source_component, once.source_sequence) == (42, 190, 9)
    (kept,) = link.feed(oracle.raw_frame(0, b"\x07", extra=50))
    assert kept.wire == b"\x07" + bytes(8)
    other = firmware.mavlink.Link(None, messages=[heartbeat])
    messages = [next(other.feed(frame)) for frame in (first, second)]
    assert messages[0] is not messages[1]
    assert messages[0].wire == bytes(range(1, 10))


def test_damaged_frame_leaves_a_message_object_as_it_was(firmware: SimpleNamespace) -> None:
    """The object with the last message must not come to hold half of one that never was."""
    once = type("Heartbeat", (firmware.message.Message,), oracle.describe("HEARTBEAT"))(live=("custom_mode",))
    link = firmware.mavlink.Link(None, messages=[once])
    assert list(link.feed(oracle.raw_frame(0, bytes(range(1, 10)), extra=50))) == [once]
    before = bytes(once._image), list(once.live)
    assert list(link.feed(oracle.raw_frame(0, bytes(range(11, 20)), extra=51) + bytes(300))) == []
    assert (bytes(once._image), list(once.live)) == before
    assert (link.received, link.crc_errors) == (1, 1)


def test_bytes_done_with_are_not_kept(firmware: SimpleNamespace) -> None:
    """Days of garbage do not fill the memory of a board."""
    link = receiver(firmware, "HEARTBEAT")
    size = len(link._buffer)
    chance = random.Random(8)
    for _ in range(2000):
        list(link.feed(chance.randbytes(100)))
        assert link._arrived == [None]
        assert link._state[1] - link._state[0] < 10 + 255 + 2 + 13
    assert len(link._buffer) == size


magics = st.sampled_from([b"\xfd", b"\xfe", b"\xfd\x01\x00", b"\xfe\x09", b"\xfd\x09\x01\x00\x01\x01\x01\x00\x00\x00"])
noise = st.lists(st.binary(max_size=40) | magics | st.just(oracle.raw_frame(0, b"\x07", extra=50)), max_size=8).map(
    b"".join
)


@FUZZ
@given(data=noise, sizes=st.lists(st.integers(1, 30), min_size=1))
def test_any_bytes_in_any_pieces(firmware: SimpleNamespace, data: bytes, sizes: list[int]) -> None:
    """feed() never raises, and how the bytes are cut up makes no difference."""
    whole, parts = receiver(firmware, "HEARTBEAT"), receiver(firmware, "HEARTBEAT")
    expected = [bytes(message.wire) for message in whole.feed(data)]
    found, at, turn = [], 0, 0
    while at < len(data):
        size = sizes[turn % len(sizes)]
        found += [bytes(message.wire) for message in parts.feed(data[at : at + size])]
        at, turn = at + size, turn + 1
    assert found == expected
    assert counters(parts) == counters(whole)


@FUZZ
@given(data=noise)
def test_true_frame_is_found_behind_any_garbage(firmware: SimpleNamespace, data: bytes) -> None:
    """Nothing in front of a frame hides it."""
    link = receiver(firmware, "HEARTBEAT")
    frame = oracle.raw_frame(0, b"\x2a\x2b\x2c", extra=50)
    found = [bytes(message.wire[:3]) for message in link.feed(data + frame + bytes(300))]
    assert found[-1:] == [b"\x2a\x2b\x2c"]


pieces = st.one_of(
    st.binary(max_size=30) | st.just(bytes(280)),
    magics,
    st.sampled_from([b"\xfd\xff\x00\x00\x00\x01\x01\x00\x00\x00", b"\xfe\x20\x00\x01\x01\x00"]),
    st.builds(oracle.raw_frame, st.just(0), st.binary(min_size=1, max_size=9), st.sampled_from([50, 51])),
    st.builds(oracle.raw_frame_1, st.just(0), st.binary(min_size=9, max_size=9), st.sampled_from([50, 51])),
    # A stray byte that, with the sequence number 0 of what follows, looks like the start of a HEARTBEAT of MAVLink 1.
    st.just(
        b"\xfe" + oracle.frame("HEARTBEAT", oracle.random_values(oracle.describe("HEARTBEAT"), random.Random(5)), 0)
    ),
    # Of a message that nobody knows, with a true frame in it.
    st.builds(
        lambda tail: oracle.raw_frame(70000, oracle.raw_frame(0, b"\x07", extra=50) + tail, 3), st.binary(max_size=9)
    ),
)


def scanned(data: bytes) -> list[bytes]:
    """The frames of HEARTBEAT from left to right: each that pymavlink takes for one, and behind the first byte of all
    else the search goes on."""
    found, at = [], 0
    while at < len(data):
        header = {0xFD: 10, 0xFE: 6}.get(data[at], 0)
        flags = data[at + 2] if header == 10 and at + header <= len(data) else 0
        if header and at + header <= len(data) and flags in (0, 1):
            frame = data[at : at + header + data[at + 1] + 2 + 13 * flags]
            is_known = frame[5:6] == b"\0" if header == 6 else frame[7:10] == b"\0\0\0"
            if is_known and len(frame) == header + data[at + 1] + 2 + 13 * flags and oracle.is_valid(frame):
                found.append(frame)
                at += len(frame)
                continue
        at += 1
    return found


@FUZZ
@given(
    parts=st.lists(pieces, max_size=12), sizes=st.lists(st.integers(1, 400), min_size=1), limit=st.sampled_from([0, 64])
)
def test_exactly_the_valid_frames_are_found(
    firmware: SimpleNamespace, parts: list[bytes], sizes: list[int], limit: int
) -> None:
    """Whatever bytes arrive, in whatever pieces, looked at all at once or a few at a time."""
    data = b"".join(parts)
    link, found, at, turn = receiver(firmware, "HEARTBEAT"), [], 0, 0
    link._state[16] = limit

    def take() -> None:
        while True:
            link._state[15] = 0
            message = link.receive()
            if message is not None:
                found.append((message.source_sequence, bytes(message.wire)))
            elif not limit or link._state[15] < limit:
                return

    while at < len(data):
        size = sizes[turn % len(sizes)]
        link.put(data[at : at + size])
        take()
        at, turn = at + size, turn + 1
    while link._state[0] < link._state[1]:
        link.give_up()
        take()
    expected = []
    for frame in scanned(data):
        header = 10 if frame[0] == 0xFD else 6
        payload = frame[header : header + frame[1]][:9].ljust(9, b"\0")
        expected.append((frame[4 if header == 10 else 2], payload))
    assert found == expected
