"""Signatures are those of pymavlink, and nothing that was changed, repeated or made without the key is accepted."""

import itertools
import random
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pymavlink_oracle as oracle
import pytest
from firmware_runs import Exercise, as_json
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common

KEY = bytes(range(7, 39))
OTHER_KEY = KEY[:-1] + b"\0"
EPOCH = 1420070400  # 2015-01-01
TICKS = 100000  # of a timestamp in a second
MINUTE = 60 * TICKS
NOW = EPOCH + 400_000_000  # a clock's reading in 2027, and the same as a timestamp
STAMP = 400_000_000 * TICKS
NAMES = ("HEARTBEAT", "SYS_STATUS", "BATTERY_STATUS", "STATUSTEXT", "TUNNEL", "WHEEL_DISTANCE", "RADIO_STATUS")
# Zeros behind a frame: what pretends to announce more is found out.
END = bytes(300)
FUZZ = settings(max_examples=200, suppress_health_check=[HealthCheck.function_scoped_fixture])


def signer(timestamp: int = STAMP, key: bytes = KEY, link: int = 0, system: int = oracle.SYSTEM) -> Any:
    """A MAVLink object of pymavlink that signs and that checks what it receives."""
    side = common.MAVLink(None, srcSystem=system, srcComponent=oracle.COMPONENT)
    oracle.prepare_signing(side, key, timestamp, link)
    return side


def packed(side: Any, name: str, values: dict[str, Any]) -> bytes:
    """The next frame of a MAVLink object of pymavlink."""
    message_type = common.mavlink_map[oracle.BY_NAME[name].id]
    frame = bytes(message_type(**{field: values[field] for field in message_type.fieldnames}).pack(side))
    side.seq = (side.seq + 1) % 256
    return frame


def heartbeat(side: Any, mode: int = 7) -> bytes:
    """The next frame of a MAVLink object of pymavlink, a HEARTBEAT."""
    values = {"type": 1, "autopilot": 2, "base_mode": 3, "custom_mode": mode, "system_status": 4, "mavlink_version": 3}
    return packed(side, "HEARTBEAT", values)


def timestamp_of(frame: bytes) -> int:
    return int.from_bytes(frame[-12:-6], "little")


class Clock:
    """A clock that stands where it was put."""

    def __init__(self, now: float) -> None:
        self.now = now

    def __call__(self) -> float:
        return self.now

    def stamp(self, signing: Any, now: float) -> int:
        """The timestamp that a frame gets at a time."""
        self.now = now
        frame = bytearray(30)
        signing.sign(frame)
        return timestamp_of(frame)


class Receiving:
    """A link that judges signatures, at a time that the test sets."""

    def __init__(self, firmware: SimpleNamespace, timestamp: int = 0, **options: Any) -> None:
        self.now: float = NOW
        self.signing = firmware.signing.Signing(KEY, timestamp=timestamp, clock=lambda: self.now, **options)
        classes = [type(name, (firmware.message.Message,), oracle.describe(name)) for name in NAMES]
        self.link = firmware.mavlink.Link(None, messages=classes, signing=self.signing)

    def hears(self, data: bytes) -> int:
        """Return the number of messages that come of it."""
        return len(list(self.link.feed(data + END)))


def test_frames_of_pymavlink_are_accepted(exercise: Exercise) -> None:
    """Random messages of every kind on two links of a system; the same values come out, all of them signed."""
    chance = random.Random(11)
    sides = [signer(), signer(link=200)]
    pieces, expected = [], []
    for _ in range(200):
        name = chance.choice(NAMES)
        values = oracle.random_values(oracle.describe(name), chance)
        pieces.append(packed(chance.choice(sides), name, values).hex())
        expected.append([[name, oracle.payload(name, values).hex()]])
    classes = [oracle.describe(name) for name in NAMES]
    results = exercise("judge", key=KEY.hex(), timestamp=0, clock=NOW, classes=classes, pieces=pieces)
    assert [messages for messages, *_ in results] == expected
    assert results[-1][1] == [200, 200, 0, 0, 0, 0]
    assert results[-1][2] == max(side.signing.timestamp for side in sides) - 1


def test_pymavlink_accepts_our_frames(exercise: Exercise) -> None:
    """Random messages, byte for byte those of pymavlink with the same timestamp, under a clock that jumps about."""
    chance = random.Random(12)
    descriptions = [oracle.describe(name) for name in NAMES]
    cases, all_values = [], []
    for _ in range(200):
        index = chance.randrange(len(NAMES))
        values = oracle.random_values(descriptions[index], chance)
        now = NOW + chance.choice([0, 0, 0.25, -100, 5])
        cases.append([index, chance.randrange(256), now, {field: as_json(value) for field, value in values.items()}])
        all_values.append(values)
    source = {"system": oracle.SYSTEM, "component": oracle.COMPONENT}
    options = {"key": KEY.hex(), "link": 9, "timestamp": 0, "clock": NOW}
    frames = exercise("sign", **options, **source, classes=descriptions, cases=cases)
    judge = signer()
    stamps = []
    for frame, (index, sequence, *_), values in zip(map(bytes.fromhex, frames), cases, all_values, strict=True):
        (heard,) = judge.parse_buffer(frame)
        assert heard.get_signed()
        assert heard.get_link_id() == 9
        twin = signer(timestamp=timestamp_of(frame), link=9)
        twin.seq = sequence
        assert frame == packed(twin, NAMES[index], values)
        stamps.append(timestamp_of(frame))
    assert (judge.signing.goodsig_count, judge.signing.badsig_count) == (200, 0)
    assert stamps == sorted(set(stamps))
    assert STAMP <= stamps[0] <= stamps[-1] < STAMP + 5 * TICKS + 300


def test_every_flipped_bit_is_noticed(exercise: Exercise) -> None:
    """Whichever bit of a frame is wrong: no message comes of it, and the true frame is accepted afterwards."""
    frame = heartbeat(signer())
    pieces = []
    for place in range(len(frame)):
        for bit in range(8):
            wrong = bytearray(frame)
            wrong[place] ^= 1 << bit
            pieces.append((bytes(wrong) + END).hex())
    pieces.append(frame.hex())
    classes = [oracle.describe("HEARTBEAT")]
    results = exercise("judge", key=KEY.hex(), timestamp=0, clock=NOW, classes=classes, pieces=pieces)
    assert all(messages == [] for messages, *_ in results[:-1])
    assert len(results[-1][0]) == 1
    # The checksum covers what stands in front of it, the signature itself is what is refused.
    assert [counted[2] for _, counted, _ in results][-1] == 13 * 8


def test_signature_covers_the_whole_frame(firmware: SimpleNamespace) -> None:
    """Key, header, payload, checksum, link and timestamp: with any byte changed, whatever the checksum says."""
    frame = heartbeat(signer())
    for place in range(len(frame)):
        for change in (0x01, 0x80, 0xFF):
            wrong = bytearray(frame)
            wrong[place] ^= change
            receiving = Receiving(firmware)
            assert not receiving.signing.accepts(wrong), place
            assert receiving.signing.accepts(frame)


def test_changed_payload_with_a_new_checksum_is_refused(exercise: Exercise) -> None:
    """Whoever changes a frame can put the checksum right, but not the signature."""
    frame = heartbeat(signer())
    payload = bytearray(frame[10:-15])
    payload[0] ^= 1
    forged = bytearray(oracle.raw_frame(0, bytes(payload), extra=50, flags=1, tail=frame[-13:]))
    forged[4] = frame[4]
    body = bytes(forged[1:-15])
    forged[-15:-13] = oracle.x25crc(body + b"\x32").crc.to_bytes(2, "little")
    pieces = [(bytes(forged) + END).hex()]
    classes = [oracle.describe("HEARTBEAT")]
    for key in (KEY, OTHER_KEY):
        results = exercise("judge", key=key.hex(), timestamp=0, clock=NOW, classes=classes, pieces=pieces)
        assert results == [[[], [0, 0, 1, 0, 0, 0], 0]]


def test_wrong_key_is_refused_on_both_sides(exercise: Exercise) -> None:
    """Keys that differ in one byte only do not understand each other."""
    classes = [oracle.describe("HEARTBEAT")]
    pieces = [heartbeat(signer(key=OTHER_KEY)).hex()]
    results = exercise("judge", key=KEY.hex(), timestamp=0, clock=NOW, classes=classes, pieces=pieces)
    assert results == [[[], [0, 0, 1, 0, 0, 0], 0]]
    options = {"key": OTHER_KEY.hex(), "link": 0, "timestamp": 0, "clock": NOW, "system": 1, "component": 1}
    (frame,) = exercise("sign", **options, classes=classes, cases=[[0, 0, NOW, {}]])
    judge = signer()
    with pytest.raises(common.MAVError, match="Invalid signature"):
        judge.parse_buffer(bytes.fromhex(frame))


def test_replayed_and_older_frames_are_refused(exercise: Exercise) -> None:
    """Each sender on each link has to go on; what another one has sent does not count."""
    side, link, system = signer(), signer(link=1), signer(system=9)
    first, second, third = heartbeat(side), heartbeat(side), heartbeat(side)
    pieces = [second, second, first, heartbeat(link), heartbeat(system), third, third]
    accepted = [1, 0, 0, 1, 1, 1, 0]
    classes = [oracle.describe("HEARTBEAT")]
    results = exercise(
        "judge", key=KEY.hex(), timestamp=0, clock=NOW, classes=classes, pieces=[piece.hex() for piece in pieces]
    )
    assert [len(messages) for messages, *_ in results] == accepted
    assert results[-1][1] == [4, 4, 3, 0, 0, 0]


def test_first_frame_may_be_a_minute_old(exercise: Exercise) -> None:
    """By the clock or, where that is behind, by what was signed or received last; later frames may lag more."""
    classes = [oracle.describe("HEARTBEAT")]

    def accepted(clock: float, timestamp: int, *stamps: int) -> list[int]:
        # Another system each time: each is a first frame.
        pieces = [heartbeat(signer(stamp, system=number + 1)).hex() for number, stamp in enumerate(stamps)]
        results = exercise("judge", key=KEY.hex(), timestamp=timestamp, clock=clock, classes=classes, pieces=pieces)
        return [len(messages) for messages, *_ in results]

    assert accepted(NOW, 0, STAMP - MINUTE, STAMP - MINUTE - 1, STAMP) == [1, 0, 1]
    assert accepted(0, STAMP, STAMP - MINUTE, STAMP - MINUTE - 1) == [1, 0]
    # A frame from the future carries our time along with it.
    assert accepted(NOW, 0, STAMP + 2 * MINUTE, STAMP + MINUTE, STAMP + MINUTE - 1, STAMP) == [1, 1, 0, 0]


def test_first_frame_is_not_older_for_a_clock_that_jumped_back(firmware: SimpleNamespace) -> None:
    """Whoever can set our clock back, as a false GPS can, must not make old frames young."""
    receiving = Receiving(firmware)
    assert receiving.hears(heartbeat(signer(STAMP + 10))) == 1
    receiving.now -= 3600
    assert receiving.hears(heartbeat(signer(STAMP + 9 - MINUTE, link=1))) == 0
    assert receiving.hears(heartbeat(signer(STAMP + 10 - MINUTE, link=2))) == 1


def test_frames_that_were_refused_leave_no_trace(firmware: SimpleNamespace) -> None:
    """A forged frame with a time far ahead must not shut out the true sender."""
    receiving = Receiving(firmware)
    wrong = bytearray(heartbeat(signer(timestamp=2**48 - 2)))
    wrong[-1] ^= 1
    assert receiving.hears(bytes(wrong)) == 0
    damaged = bytearray(heartbeat(signer(timestamp=2**48 - 2)))
    damaged[12] ^= 1
    assert receiving.hears(bytes(damaged)) == 0
    assert receiving.link.refused == 1
    assert receiving.link.crc_errors > 0
    assert receiving.signing.timestamp == 0
    assert receiving.hears(heartbeat(signer())) == 1


def test_senders_are_limited(firmware: SimpleNamespace) -> None:
    """The table of senders does not fill the memory; those that are in it go on."""
    receiving = Receiving(firmware, streams=2)
    sides = [signer(), signer(link=1), signer(system=3)]
    assert [receiving.hears(heartbeat(side)) for side in sides] == [1, 1, 0]
    assert [receiving.hears(heartbeat(side)) for side in sides] == [1, 1, 0]
    assert receiving.link.refused == 2
    many = Receiving(firmware)
    assert sum(many.hears(heartbeat(signer(system=number))) for number in range(1, 30)) == 16


def test_unsigned_frames_are_refused_but_those_of_radios(firmware: SimpleNamespace) -> None:
    """RADIO_STATUS comes from the radio, which has no key; MAVLink 1 has no signatures; `unsigned` says otherwise."""
    unsigned = oracle.raw_frame(0, b"\x01" * 9, extra=50)
    unsigned_1 = oracle.raw_frame_1(0, b"\x01" * 9, extra=50)
    radio = oracle.raw_frame(109, b"\x01" * 9, extra=185)
    radio_1 = oracle.raw_frame_1(109, b"\x01" * 9, extra=185)
    receiving = Receiving(firmware)
    assert [receiving.hears(frame) for frame in (unsigned, unsigned_1, radio, radio_1)] == [0, 0, 1, 1]
    assert (receiving.link.refused, receiving.link.received, receiving.link.signed) == (2, 2, 0)
    assert receiving.hears(oracle.raw_frame(109, b"\x01" * 9, extra=185, flags=1, tail=bytes(13))) == 0
    open_minded = Receiving(firmware, unsigned=(0,))
    assert [open_minded.hears(frame) for frame in (unsigned, unsigned_1, radio)] == [1, 1, 0]
    strict = Receiving(firmware, unsigned=())
    assert [strict.hears(frame) for frame in (unsigned, unsigned_1, radio)] == [0, 0, 0]


def test_refused_frame_leaves_a_message_object_as_it_was(firmware: SimpleNamespace) -> None:
    """An object that is used again holds the last genuine message."""
    once = type("Heartbeat", (firmware.message.Message,), oracle.describe("HEARTBEAT"))(live=("custom_mode",))
    signing = firmware.signing.Signing(KEY, clock=lambda: NOW)
    link = firmware.mavlink.Link(None, messages=[once], signing=signing)
    assert list(link.feed(heartbeat(signer(), mode=5))) == [once]
    before = bytes(once._image), list(once.live)
    assert list(once.live) == [5]
    for frame in (heartbeat(signer(key=OTHER_KEY), mode=6), oracle.raw_frame(0, b"\x06" * 9, extra=50)):
        assert list(link.feed(frame)) == []
    assert (bytes(once._image), list(once.live)) == before


def test_link_without_a_key_takes_signed_frames(firmware: SimpleNamespace) -> None:
    """Signatures that nobody can check are no reason to be deaf; nor do unknown messages need one."""
    classes = [type("Heartbeat", (firmware.message.Message,), oracle.describe("HEARTBEAT"))]
    link = firmware.mavlink.Link(None, messages=classes)
    assert len(list(link.feed(heartbeat(signer(key=OTHER_KEY))))) == 1
    assert (link.received, link.signed, link.refused) == (1, 1, 0)
    receiving = Receiving(firmware)
    assert receiving.hears(oracle.frame("VIBRATION", dict.fromkeys(oracle.BY_NAME["VIBRATION"].fieldnames, 0), 1)) == 0
    assert receiving.link.unknown > 0
    assert receiving.link.refused == 0


@FUZZ
@given(
    start=st.integers(0, STAMP * 2),
    readings=st.lists(
        st.integers(0, NOW) | st.floats(NOW - 1, NOW + 1) | st.sampled_from([0, NOW]), min_size=2, max_size=30
    ),
)
def test_timestamps_never_repeat(firmware: SimpleNamespace, start: int, readings: list[float]) -> None:
    """The clock may stand, jump or run: each is newer than all before, and none is older than `timestamp`."""
    clock = Clock(readings[0])
    signing = firmware.signing.Signing(KEY, timestamp=start, clock=clock)
    stamps = [start] + [clock.stamp(signing, now) for now in readings for _ in range(2)]
    assert all(before < after for before, after in itertools.pairwise(stamps))
    assert signing.timestamp == stamps[-1]


def test_clock_that_was_never_set_goes_on_from_the_timestamp(firmware: SimpleNamespace) -> None:
    """A board without a battery for its clock begins at 0, or in 1970: the time since its start is added."""
    for start in (0.0, 5.0, EPOCH, EPOCH + 10.5):
        clock = Clock(start)
        signing = firmware.signing.Signing(KEY, timestamp=STAMP, clock=clock)
        stamps = [clock.stamp(signing, start + passed) - STAMP for passed in (0, 10, 70)]
        assert stamps[0] == 1
        assert abs(stamps[1] - 10 * TICKS) <= 1
        assert abs(stamps[2] - 70 * TICKS) <= 1


def test_own_time_goes_on_from_what_was_received(firmware: SimpleNamespace) -> None:
    """Otherwise whoever sent that frame, or has heard it, would refuse ours; the clock counts on from there."""
    receiving = Receiving(firmware)
    frame = heartbeat(signer(STAMP + 500 * TICKS))
    assert receiving.hears(frame) == 1
    own = bytearray(30)
    receiving.signing.sign(own)
    assert timestamp_of(own) == STAMP + 500 * TICKS + 1
    receiving.now += 2
    receiving.signing.sign(own)
    assert timestamp_of(own) - STAMP in (502 * TICKS, 502 * TICKS + 1)


def test_link_signs_what_it_sends(firmware: SimpleNamespace) -> None:
    """Several frames over a stream; pymavlink with the key accepts each, sequence numbers go on."""
    sent = bytearray()
    stream = SimpleNamespace(write=lambda frame: sent.extend(frame) or len(frame))
    signing = firmware.signing.Signing(KEY, 3, clock=lambda: NOW)
    link = firmware.mavlink.Link(stream, 7, 180, signing=signing, longest=54)
    messages = [type(name, (firmware.message.Message,), oracle.describe(name))() for name in NAMES[:3]]
    for message in messages * 100:
        assert link.send(message) > 12 + 13
    judge = signer()
    heard = judge.parse_buffer(bytes(sent))
    assert [message.get_type() for message in heard] == list(NAMES[:3]) * 100
    assert [message.get_seq() for message in heard] == [number % 256 for number in range(300)]
    assert all(message.get_signed() and message.get_link_id() == 3 for message in heard)
    assert link.tx_errors == 0
    tunnel = type("Tunnel", (firmware.message.Message,), oracle.describe("TUNNEL"))()
    before = signing.timestamp
    with pytest.raises(ValueError, match="too short"):
        link.encode(tunnel)
    assert signing.timestamp == before


def test_impossible_signing_is_refused(firmware: SimpleNamespace) -> None:
    """A short key would sign, and nobody would understand it."""
    for key in (b"", KEY[:31], KEY + b"\0"):
        with pytest.raises(ValueError, match="32 bytes"):
            firmware.signing.Signing(key)
    for link in (-1, 256):
        with pytest.raises(ValueError, match="0 to 255"):
            firmware.signing.Signing(KEY, link)
    with pytest.raises(ValueError, match="MAVLink 1 has no signatures"):
        firmware.mavlink.Link(None, version=1, signing=firmware.signing.Signing(KEY))


@pytest.mark.parametrize(
    ("timestamp", "saved_at", "loaded_at", "expected"),
    [
        pytest.param(0, NOW, NOW + 5, STAMP + MINUTE, id="reset-after-5-seconds"),
        pytest.param(0, NOW, NOW + 100, STAMP + 100 * TICKS, id="long-switched-off"),
        pytest.param(0, NOW, 0, STAMP + MINUTE, id="clock-lost"),
        pytest.param(STAMP, 3, 0, STAMP + MINUTE, id="clock-never-set"),
        pytest.param(STAMP + 7 * MINUTE, NOW, NOW, STAMP + 8 * MINUTE, id="ahead-of-the-clock"),
    ],
)
def test_saved_state_goes_on_a_minute_later(
    exercise: Exercise, tmp_path: Path, timestamp: int, saved_at: float, loaded_at: float, expected: int
) -> None:
    """Key and link come back, no timestamp does; a file with any byte changed, cut or grown is damaged."""
    path = tmp_path / "signing.bin"
    times = {"timestamp": timestamp, "saved_at": saved_at, "loaded_at": loaded_at}
    key, link, stamp, undetected = exercise("keep", key=KEY.hex(), link=77, path=str(path), **times)
    assert (key, link) == (KEY.hex(), 77)
    assert expected <= stamp <= expected + 1
    # One more error than damaged files: there is none of another name.
    assert undetected == 1
    assert [found.name for found in tmp_path.iterdir()] == ["signing.bin"]


def test_saved_state_is_never_behind_what_was_signed(firmware: SimpleNamespace, tmp_path: Path) -> None:
    """The clock was set back before save(): the frames of before must not be signed a second time."""
    path = str(tmp_path / "signing.bin")
    clock = Clock(NOW)
    signing = firmware.signing.Signing(KEY, clock=clock)
    last = clock.stamp(signing, NOW)
    clock.now = NOW - 3600
    signing.save(path)
    assert firmware.signing.load(path, clock=clock).timestamp == last + MINUTE


def test_loaded_state_takes_options(firmware: SimpleNamespace, tmp_path: Path) -> None:
    """The options that are not in the file are given again: ids without signature, senders, the clock."""
    path = str(tmp_path / "signing.bin")
    firmware.signing.Signing(KEY, 5, clock=lambda: NOW).save(path)
    loaded = firmware.signing.load(path, unsigned=(), streams=1, clock=lambda: NOW)
    assert (loaded.unsigned, loaded.timestamp) == ((), STAMP + MINUTE)
    frames = [bytearray(heartbeat(signer(STAMP + 2 * MINUTE, link=link))) for link in (1, 2)]
    assert [loaded.accepts(frame) for frame in frames] == [True, False]


@FUZZ
@given(noise=st.lists(st.binary(max_size=30) | st.sampled_from([b"\xfd", b"\xfd\x09\x01\x00"]), max_size=6))
def test_genuine_frame_is_found_among_garbage(firmware: SimpleNamespace, noise: list[bytes]) -> None:
    """Signing changes nothing about finding frames, and no garbage is ever accepted."""
    receiving = Receiving(firmware)
    frame = heartbeat(signer())
    count = receiving.hears(b"".join(noise) + frame)
    assert count == 1
    assert receiving.link.signed == count
