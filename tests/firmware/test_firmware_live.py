"""Live fields: what stands in the array `live` goes out and comes in just as set() and get() would have it."""

import random
import struct
from types import SimpleNamespace
from typing import Any

import pymavlink_oracle as oracle
import pytest
from firmware_runs import Exercise, as_read
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

# Every code twice, in the aligned base fields and at odd places among the extension fields behind the first b; and what
# cannot be live in between.
WORDS = (
    "q:q a:I b:i f:f c:H=65535 d:h=-1 arrays:5H=65535 small:3h cells:2i e:B=255 g:b=-128 text:3s "
    "b1:b i1:i I1:I h1:h H1:H B1:B b2:b i2:3i I2:2I h2:2h H2:2H B2:3B b3:2b"
)
MIXED = oracle.described("MIXED", WORDS, 0x1CE, base_length=55)
LOW = MIXED | {"NAME": "LOW", "ID": 206}
LAYOUT = oracle.layout(MIXED)
MAY_BE_LIVE = [name for name, (code, _, _) in LAYOUT.items() if code in "BHIbhi"]
SETTINGS = settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])


def elements(name: str, description: dict[str, Any] = MIXED) -> list[tuple[str, int]]:
    """(struct code, offset) of each element that a live name stands for."""
    field, _, index = name.partition("[")
    code, offset, count = oracle.layout(description)[field]
    size = struct.calcsize(f"<{code}")
    indices = [int(index[:-1])] if index else range(count or 1)
    return [(code, offset + size * place) for place in indices]


def live_values(names: list[str], wire: bytes, description: dict[str, Any] = MIXED) -> list[int]:
    """Return the numbers of `live` for a payload: each element by its type, a uint32 as the int32 of the same bits."""
    return [
        struct.unpack_from("<" + code.replace("I", "i"), wire, offset)[0]
        for name in names
        for code, offset in elements(name, description)
    ]


def with_live(names: list[str], wire: bytes, values: list[int], description: dict[str, Any] = MIXED) -> bytes:
    """The payload with live values, of which an element takes the lower bytes."""
    changed = bytearray(wire)
    places = [place for name in names for place in elements(name, description)]
    for (code, offset), value in zip(places, values, strict=True):
        size = struct.calcsize(f"<{code}")
        changed[offset : offset + size] = (value & 0xFFFFFFFF).to_bytes(4, "little")[:size]
    return bytes(changed)


def raw_values(wire: bytes, description: dict[str, Any]) -> dict[str, Any]:
    """All fields of a payload as raw() reads them."""
    values = {}
    for name, (code, offset, count) in oracle.layout(description).items():
        found = struct.unpack_from(f"<{count or 1}{code}", wire, offset)
        if code == "s":
            text = found[0].split(b"\0")[0]
            values[name] = as_read(text) if text.isascii() else {"hex": text.hex()}
        else:
            values[name] = as_read(list(found) if count else found[0])
    return values


def edges(code: str) -> list[int]:
    bits = 8 * struct.calcsize(f"<{code}")
    low = -(1 << bits - 1) if code.islower() else 0
    return [low, low + 1, -1 if low else 1, 0, 1 << (bits - 1), low + (1 << bits) - 1]


def message_classes(firmware: SimpleNamespace, description: dict[str, Any] = MIXED) -> Any:
    return type(description["NAME"], (firmware.message.Message,), description)


@st.composite
def field_values(draw: st.DrawFn) -> dict[str, Any]:
    """A value for each whole number, edges often."""
    values: dict[str, Any] = {}
    for name in MAY_BE_LIVE:
        code, _, count = LAYOUT[name]
        low, high = edges(code)[0], edges(code)[-1]
        number = st.sampled_from([edge for edge in edges(code) if low <= edge <= high]) | st.integers(low, high)
        values[name] = draw(st.lists(number, min_size=count, max_size=count) if count else number)
    return values


live_names = st.lists(
    st.sampled_from(MAY_BE_LIVE)
    | st.sampled_from([f"{name}[{index}]" for name in MAY_BE_LIVE for index in range(LAYOUT[name][2])]),
    max_size=8,
    unique=True,
)


@SETTINGS
@given(names=live_names, values=field_values())
def test_live_values_reach_the_frame_as_set_does(
    firmware: SimpleNamespace, names: list[str], values: dict[str, Any]
) -> None:
    """The same values, some through `live` and the others through set(), make the same frame, and are read alike."""
    cls, low = message_classes(firmware), message_classes(firmware, LOW)
    wire = oracle.packed(MIXED, values)
    for kind, version in ((cls, 2), (low, 2), (low, 1)):
        plain, message = kind(unknown=False).update(**values), kind(live=names, unknown=False)
        for name in set(MAY_BE_LIVE) - set(names):
            message.set(name, values[name])
        # What set() has written to single elements of arrays, `live` alone has to bring.
        message.wire[:] = oracle.packed(MIXED, {name: values[name] for name in set(MAY_BE_LIVE) - set(names)})
        for name in (name for name in names if "[" in name):
            for code, offset in elements(name):
                message.wire[offset : offset + struct.calcsize(f"<{code}")] = bytes(struct.calcsize(f"<{code}"))
        for place, value in enumerate(live_values(names, wire)):
            message.live[place] = value
        link = firmware.mavlink.Link(None, version=version)
        expected = bytes(link.encode(plain))
        assert plain.wire == wire
        for name in plain.names():
            assert message.get(name) == plain.get(name)
            assert message.raw(name) == plain.raw(name)
        assert bytes(link.encode(message)) == expected


@SETTINGS
@given(names=live_names, values=field_values())
def test_received_frames_fill_live(firmware: SimpleNamespace, names: list[str], values: dict[str, Any]) -> None:
    """The object's `live` has what was sent, signs extended, whatever stood there; and get() agrees with it."""
    cls = message_classes(firmware)
    plain, target = cls(unknown=False), cls(live=names)
    (heard,) = firmware.receiver.Receiver([target]).feed(
        bytes(firmware.mavlink.Link(None).encode(plain.update(**values)))
    )
    assert heard is target
    assert list(target.live) == live_values(names, oracle.packed(MIXED, values))
    assert target.wire == plain.wire
    for name in plain.names():
        assert target.get(name) == plain.get(name)
    assert target.wire == plain.wire


@SETTINGS
@given(names=live_names, first=field_values(), second=field_values())
def test_set_reaches_live(
    firmware: SimpleNamespace, names: list[str], first: dict[str, Any], second: dict[str, Any]
) -> None:
    """set() of one field changes what `live` holds of that field and nothing else; get() sees both ways of writing."""
    message = message_classes(firmware)(live=names, unknown=False)
    message.update(**first)
    assert list(message.live) == live_values(names, oracle.packed(MIXED, first))
    for name in MAY_BE_LIVE:
        message.set(name, second[name])
        value = second[name]
        assert message.raw(name) == (tuple(value) if isinstance(value, list) else value)
    assert list(message.live) == live_values(names, oracle.packed(MIXED, second))
    with pytest.raises(ValueError, match="cannot carry"):
        message.set("I1", 1 << 32)
    assert list(message.live) == live_values(names, oracle.packed(MIXED, second))


@pytest.mark.parametrize("seed", [1, 2])
def test_live_fields_on_each_interpreter(exercise: Exercise, seed: int) -> None:
    """Random messages in each form: frames, raw(), what arrives; also values that only 32 bits hold, and zeros."""
    chance = random.Random(seed)
    descriptions = [LOW, oracle.describe("BATTERY_STATUS"), oracle.describe("SYS_STATUS")]
    cases, expected = [], []
    for _ in range(400):
        index = chance.randrange(len(descriptions))
        description = descriptions[index]
        layout = oracle.layout(description)
        names = [name for name, (code, _, _) in layout.items() if code in "BHIbhi"]
        names += [f"{name}[{place}]" for name in names for place in range(layout[name][2])]
        names = chance.sample(names, chance.randrange(min(len(names), 14) + 1))
        # The same element twice in `live` has no meaning.
        taken: set[int] = set()
        kept = []
        for name in names:
            places = {offset for _, offset in elements(name, description)}
            if not places & taken:
                kept.append(name)
                taken |= places
        length = description["LENGTH"]
        used = chance.randrange(length + 1)
        wire = chance.randbytes(used) + bytes(length - used)
        values = [
            chance.choice([0, -1, chance.choice(edges(code)), chance.randrange(-(2**31), 2**31)])
            for name in kept
            for code, _ in elements(name, description)
        ]
        values = [(value + 2**31) % 2**32 - 2**31 for value in values]
        cases.append([index, kept, wire.hex(), values])
        expected.append(expectation(description, kept, with_live(kept, wire, values, description)))
    results = exercise("live", classes=descriptions, cases=cases)
    assert set(results) == exercise.forms
    for found in results.values():
        for case, answer, wanted in zip(cases, found, expected, strict=True):
            assert answer == wanted, case


def expectation(description: dict[str, Any], names: list[str], sent: bytes) -> list[Any]:
    """Return the expected answer of exercise.py for a payload that is sent."""
    base = description["BASE_LENGTH"]
    arrived = [sent, sent[:base] + bytes(len(sent) - base)]
    truncated = sent.rstrip(b"\0") or b"\0"
    # Sources and sequence of exercise.py's links: system 1, component 1, the first frame.
    frames = [
        framed(b"\xfd", bytes([len(truncated), 0, 0, 0, 1, 1, description["ID"], 0, 0]) + truncated, description),
        framed(b"\xfe", bytes([base, 0, 1, 1, description["ID"]]) + sent[:base], description),
    ]
    return [
        raw_values(sent, description),
        [frame.hex() for frame in frames],
        [[wire.hex(), live_values(names, wire, description), raw_values(wire, description)] for wire in arrived],
    ]


def framed(magic: bytes, body: bytes, description: dict[str, Any]) -> bytes:
    """The bytes of a frame with its checksum."""
    crc = oracle.x25crc(body + bytes([description["CRC_EXTRA"]])).crc
    return magic + body + crc.to_bytes(2, "little")


def test_live_fields_are_unknown_at_first(firmware: SimpleNamespace) -> None:
    """A builder that never ran sends the dialect's sentinels, not zeros; unknown=False starts with zeros."""
    cls = message_classes(firmware)
    names = ["a", "c", "d", "arrays[4]", "arrays[0]", "small", "e", "g"]
    message = cls(live=names)
    assert list(message.live) == [0, 65535, -1, 65535, 65535, 0, 0, 0, 255, -128]
    assert (message.c, message.d, message.arrays, message.a) == (None, None, (None,) * 5, 0)
    assert bytes(firmware.mavlink.Link(None).encode(message)) == bytes(firmware.mavlink.Link(None).encode(cls()))
    assert list(cls(live=names, unknown=False).live) == [0] * 10
    assert cls(live=names, unknown=False).wire == bytes(MIXED["LENGTH"])
    assert list(cls().live) == []


def test_unknown_is_set_in_live_too(firmware: SimpleNamespace) -> None:
    """set(name, None) and an array with None in it put the sentinels where the next frame takes them from."""
    message = message_classes(firmware)(live=["arrays[1]", "arrays[3]", "d"], unknown=False)
    message.update(arrays=[1, 2, None, None, 5], d=None)
    assert list(message.live) == [2, 65535, -1]
    message.live[0] = 65535
    message.live[2] = -2
    assert (message.arrays, message.d) == ((1, None, None, None, 5), -2)
    assert message.raw("arrays") == (1, 65535, 65535, 65535, 5)


def test_live_value_beyond_its_field_is_cut_as_the_frame_does(firmware: SimpleNamespace) -> None:
    """`live` checks nothing; but what get() and raw() tell is what goes out."""
    message = message_classes(firmware)(live=["B1", "g", "H1", "h1", "I1", "i1"], unknown=False)
    for place, value in enumerate([0x1FE, 0x180, -2, 0x18000, -(2**31), 2**31 - 1]):
        message.live[place] = value
    told = {name: message.raw(name) for name in message.names()}
    assert [told[name] for name in ("B1", "g", "H1", "h1", "I1", "i1")] == [
        254, -128, 65534, -32768, 2**31, 2**31 - 1,
    ]  # fmt: skip
    (heard,) = firmware.receiver.Receiver([type(message)]).feed(bytes(firmware.mavlink.Link(None).encode(message)))
    assert {name: heard.raw(name) for name in heard.names()} == told


@pytest.mark.parametrize(
    ("name", "error", "words"),
    [
        ("f", ValueError, r"MIXED\.f is no whole number of up to 32 bits"),
        ("q", ValueError, r"MIXED\.q is no whole number"),
        ("text", ValueError, r"MIXED\.text is no whole number"),
        ("arrays[5]", ValueError, r"MIXED\.arrays has no element 5"),
        ("arrays[-1]", ValueError, r"MIXED\.arrays has no element -1"),
        ("a[1]", ValueError, r"MIXED\.a has no element 1"),
        ("voltages", KeyError, "voltages"),
        ("voltages[0]", KeyError, "voltages"),
    ],
)
def test_fields_that_cannot_be_live_are_refused(
    firmware: SimpleNamespace, name: str, error: type[Exception], words: str
) -> None:
    """Machine code would write wherever a wrong place says."""
    with pytest.raises(error, match=words):
        message_classes(firmware)(live=("a", name))


def test_messages_do_not_share_live(firmware: SimpleNamespace) -> None:
    """Each object has an array of its own."""
    cls = message_classes(firmware)
    one, two = cls(live=("a",)), cls(live=("a",))
    one.live[0] = 5
    assert (one.a, two.a) == (5, 0)
