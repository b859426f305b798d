# Generated from templates/tests/program/field_checks.py: do not edit.
# Inputs: bc2557cb0bdbb763
"""Fields of messages by name, and links by themselves: what they carry, what they refuse, and what they say then.

The message of these checks is made up, so that it has a field of every kind; what it has to do stands beside it.
"""

from mavlink import Link
from message import Message
from program_bench import main
from receiver import Receiver
from sender import Sender

NAN, INFINITY = float("nan"), float("inf")


class Invented(Message):
    """A message with fields of every kind, and every way to state what is unknown."""

    NAME = "INVENTED"
    ID = 201
    CRC_EXTRA = 7
    BASE_LENGTH = 62
    LENGTH = 93
    FIELDS = (
        "wide:q=-1 exact:d big:I=4294967295 real:f=nan ratio:2f=nan many:2I parts:3H=65535 first:3h=32767: "
        "mixed:3B=255,,0 small:b=-1 flag:B wire:B word:4s name:4s=0 late:2b letter:s row:12B "
        "under:h over:H deep:i high:I"
    )
    DEFAULTS = {"flag": 3}  # noqa: RUF012  as in messages.py


NAMES = ["wide", "exact", "big", "real", "ratio", "many", "parts", "first"]
NAMES += ["mixed", "small", "flag", "wire", "word", "name", "late", "letter", "row", "under", "over", "deep", "high"]
SIZES = (8, 8, 4, 4, 8, 8, 6, 6, 3, 1, 1, 1, 4, 4, 2, 1, 12, 2, 2, 4, 4)  # bytes of these

NEW = bytes(Invented().wire)

# A field, a value that it takes, what get() says then, and raw(), where that is something else.
TAKEN = (
    ("wide", -(1 << 63), -(1 << 63)),
    ("wide", (1 << 63) - 1, (1 << 63) - 1),
    ("wide", None, None, -1),
    ("wide", -1, None, -1),
    ("exact", 0.25, 0.25),
    ("exact", 1 << 53, float(1 << 53)),
    ("exact", -INFINITY, -INFINITY),
    ("big", 0, 0),
    ("big", True, 1),
    ("big", 4294967294, 4294967294),
    ("big", None, None, 4294967295),
    ("real", 1.5, 1.5),
    ("real", -3, -3.0),
    ("real", True, 1.0),
    ("real", INFINITY, INFINITY),
    ("ratio", [0.5, None], (0.5, None)),
    ("ratio", (None, 2), (None, 2.0)),
    ("many", (0, 4294967295), (0, 4294967295)),
    ("parts", [1, None, 65534], (1, None, 65534), (1, 65535, 65534)),
    ("parts", None, (None, None, None), (65535, 65535, 65535)),
    ("parts", b"\x05\x06\x07", (5, 6, 7)),
    ("first", [5, 32767, -32768], (5, 32767, -32768)),
    ("first", [32767, 1, 2], None, (32767, 1, 2)),
    ("first", None, None, (32767, 0, 0)),
    ("mixed", [1, 255, 2], (1, 255, 2)),
    ("mixed", [None, 4, None], (None, 4, None), (255, 4, 0)),
    ("mixed", None, (None, 0, None), (255, 0, 0)),
    ("small", -128, -128),
    ("small", 127, 127),
    ("small", None, None, -1),
    ("flag", 255, 255),
    ("word", "", ""),
    ("word", "abcd", "abcd"),
    ("word", b"a\0bc", "a"),
    ("word", bytearray(b"\x7fz"), "\x7fz"),
    ("word", b"\x80", b"\x80"),
    ("name", None, ""),
    ("late", [-128, 127], (-128, 127)),
    ("letter", "x", "x"),
    ("under", -32768, -32768),
    ("over", 65535, 65535),
    ("deep", -(1 << 31), -(1 << 31)),
    ("high", (1 << 32) - 1, (1 << 32) - 1),
)
# A field, a value that it does not take, and words of the reason.
REFUSED = (
    ("wide", 1 << 63, "cannot carry 9223372036854775808"),
    ("wide", -(1 << 63) - 1, "cannot carry -9223372036854775809"),
    ("exact", None, "has no value for unknown"),
    ("exact", 10**400, "cannot carry 1"),
    ("exact", "1", "cannot carry '1'"),
    ("big", -1, "cannot carry -1"),
    ("big", 4294967296, "cannot carry 4294967296"),
    ("big", 1.0, "cannot carry 1.0"),
    ("big", "1", "cannot carry '1'"),
    ("big", [1], "cannot carry [1]"),
    ("real", 3.5e38, "cannot carry 3.5"),
    ("real", -3.5e38, "cannot carry -3.5"),
    ("real", 10**400, "cannot carry 1"),
    ("real", [1.0], "cannot carry [1.0]"),
    ("ratio", 5, "is an array and cannot be 5"),
    ("ratio", [1.0], "takes 2 values, not 1"),
    ("ratio", [None, 1.0, 2.0], "takes 2 values, not 3"),
    ("ratio", [None, 1e39], "cannot carry 1"),
    ("ratio", [1.0, "x"], "cannot carry 'x'"),
    ("many", None, "has no value for unknown"),
    ("many", [None, 1], "cannot carry None"),
    ("many", [1, -1], "cannot carry -1"),
    ("parts", [1, 2], "takes 3 values, not 2"),
    ("parts", [1, 2, 65536], "cannot carry 65536"),
    ("parts", [None, -1, 2], "cannot carry -1"),
    ("parts", [None, 1, 2.0], "cannot carry 2.0"),
    ("parts", "abc", "cannot carry 'a'"),
    ("first", [None, 1, 2], "cannot carry None"),
    ("mixed", [1, None, 1], "cannot carry None"),
    ("mixed", [None, 256, None], "cannot carry 256"),
    ("small", -129, "cannot carry -129"),
    ("small", 128, "cannot carry 128"),
    ("flag", None, "has no value for unknown"),
    ("flag", 256, "cannot carry 256"),
    ("word", None, "has no value for unknown"),
    ("word", "abcde", "takes up to 4 characters, not 5"),
    ("word", b"12345", "takes up to 4 characters, not 5"),
    ("word", "\xe9", "text is ASCII"),
    ("word", 5, "neither text nor bytes"),
    ("late", [1, 2, 3], "takes 2 values, not 3"),
    ("letter", "xy", "takes up to 1 characters, not 2"),
)
LIVE = ("big", "small", "parts[1]", "mixed", "late[0]", "row[10]", "under", "over", "deep", "high")
STARTS = [-1, -1, 65535, 255, 0, 0, 0, 0, 0, 0, 0, 0]  # what these are at first: uint32 as int32, as they are kept


def error_of(kind, function, *arguments, **values):
    """Return the text of the error of a kind that a call raises."""
    try:
        function(*arguments, **values)
    except kind as error:
        return error.args[0]
    raise AssertionError((arguments, values, "is accepted"))


def values_go_in_and_come_out():
    """A value that a field can carry comes back, by its name and as an attribute; one that means unknown is None."""
    for live in ((), LIVE):
        for number, (name, value, told, *raw) in enumerate(TAKEN):
            for how in (number % 3,) if live else (0, 1, 2):
                message = Invented(live)
                if how == 0:
                    message.set(name, value)
                elif how == 1:
                    more = {} if name == "late" else {"late_": [3, 4]}
                    assert message.update(**dict(more, **{name: value})) is message
                    assert not more or message.late == (3, 4)
                else:
                    setattr(message, name + "_", value)
                assert message.get(name) == told == getattr(message, name + "_"), (name, value, message.get(name))
                found = message.raw(name)
                assert found == (raw[0] if raw else told) or told is None or None in told, (name, value, found)
                assert [each for each in changed(message) if each not in (name, "late")] == [], (name, value)
    assert Invented().names() == NAMES


def changed(message):
    """Return the names of the fields whose bytes are not those of a new message, which stand in a row."""
    found, at, payload = [], 0, bytes(message.wire)
    for name, size in zip(NAMES, SIZES):  # noqa: B905  MicroPython's takes nothing else
        if payload[at : at + size] != NEW[at : at + size]:
            found.append(name)
        at += size
    return found


def nothing_is_known_at_first():
    """All is unknown that can be, and else 0, or what the dialect has for it; without that all is 0."""
    expected = {"real": None, "ratio": (None, None), "parts": (None,) * 3, "mixed": (None, 0, None), "flag": 3}
    expected.update({"exact": 0.0, "many": (0, 0), "wire": 0, "word": "", "name": "", "late": (0, 0)})
    expected.update({"letter": "", "row": (0,) * 12, "under": 0, "over": 0, "deep": 0, "high": 0})
    for name in NAMES:
        assert Invented().raw(name) is not None, name
    for live in ((), LIVE):
        message = Invented(live)
        assert {name: message.get(name) for name in NAMES} == {name: expected.get(name) for name in NAMES}
        assert list(message.live) == STARTS[: len(message.live)]
        assert len(message.live) == (len(STARTS) if live else 0)
        message = Invented(live, unknown=False)
        assert bytes(message.wire) == bytes(Invented.LENGTH)
        assert list(message.live) == [0] * len(message.live)


def what_cannot_be_carried_is_refused():
    """ValueError with the name and the reason, and the field keeps what it had; so do all others of an update."""
    for name, value, words in REFUSED:
        other = {"flag_" if name != "flag" else "small": 5}
        message = Invented()
        before = bytes(message.wire)
        for told in (
            error_of(ValueError, message.set, name, value),
            error_of(ValueError, message.update, **{name: value}),
            error_of(ValueError, message.update, **dict(other, **{name: value})),
            error_of(ValueError, setattr, message, name + "_", value),
        ):
            assert told.startswith(f"INVENTED.{name} ") and words in told, (name, value, told)  # noqa: PT018
            assert bytes(message.wire) == before, (name, value)


def names_that_are_none():
    """KeyError, or AttributeError where it is one, with the field that may be meant; nothing is written."""
    message = Invented()
    before = bytes(message.wire)
    hint = "INVENTED has no field bigg; did you mean big?"
    for kind, call, arguments, values in (
        (KeyError, message.get, ("bigg",), {}),
        (KeyError, message.raw, ("bigg",), {}),
        (KeyError, message.set, ("bigg", 1), {}),
        (KeyError, message.update, (), {"bigg": 1}),
        (KeyError, message.update, (), {"flag": 1, "bigg": 1}),
        (AttributeError, getattr, (message, "bigg"), {}),
        (AttributeError, setattr, (message, "bigg", 1), {}),
        (KeyError, Invented, (("flag", "bigg"),), {}),
    ):
        assert error_of(kind, call, *arguments, **values) == hint, (call, arguments, values)
    assert error_of(AttributeError, setattr, message, "wire", 1) == "INVENTED.wire is no field: the field is wire_"
    assert error_of(AttributeError, setattr, message, "NAME", 1) == "INVENTED.NAME is no field"
    assert error_of(AttributeError, setattr, message, "live", 1) == "INVENTED.live is no field"
    assert bytes(message.wire) == before
    for name in ("real", "wide", "exact", "word", "ratio"):
        told = error_of(ValueError, Invented, (name,))
        assert told == f"INVENTED.{name} is no whole number of up to 32 bits", told
    for name, element in (
        ("parts", "3"),
        ("parts", "x"),
        ("parts", "-1"),
        ("big", "0"),
        ("late", "2"),
        ("parts", ""),
        ("row", "12"),
    ):
        assert error_of(ValueError, Invented, f"{name}[{element}]") == f"INVENTED.{name} has no element {element}"
    assert error_of(ValueError, Invented, ("parts[1",)) == "INVENTED.parts has no element 1"
    assert list(Invented("parts[2]").live) == [65535]


def live_values_are_those_of_the_fields():
    """Numbers that are written into `live` are read by name, and the other way round; each element has its own."""
    message = Invented(LIVE)
    message.live[0], message.live[1], message.live[2], message.live[6] = -2, -128, 7, -3
    message.live[3], message.live[4], message.live[5] = 1, 2, 3
    assert (message.big, message.small, message.parts, message.late) == (4294967294, -128, (None, 7, None), (-3, 0))
    assert (message.mixed, message.raw("mixed"), message.raw("parts")) == ((1, 2, 3), (1, 2, 3), (65535, 7, 65535))
    message.update(big=5, parts=[1, 2, 3], late=[-1, -2])
    message.set("small", None)
    message.mixed = (4, 5, 6)
    assert list(message.live)[:7] == [5, -1, 2, 4, 5, 6, -1]
    assert (message.parts, message.late) == ((1, 2, 3), (-1, -2))
    for at, value in enumerate((250, -2, 65534, -7, -9), 7):
        message.live[at] = value
    assert (message.row, message.under, message.over) == ((0,) * 10 + (250, 0), -2, 65534)
    assert (message.deep, message.high) == (-7, (1 << 32) - 9)
    message.update(row=range(12), under=-5, over=6, deep=-(1 << 31), high=(1 << 32) - 1)
    assert list(message.live)[7:] == [10, -5, 6, -(1 << 31), -1]


def names_are_found_when_they_are_used():
    """The first one of a program, whatever it is for, loads what knows them."""
    import message as module  # noqa: PLC0415  as it is before

    for use in (
        lambda one: one.get("a"),
        lambda one: one.raw("a"),
        lambda one: one.a,
        lambda one: one.names()[0],
        lambda one: one.set("a", 0),
        lambda one: one.update(a=0).a,
        lambda one: setattr(one, "a", 0),
    ):
        module._fields = None
        assert use(Tiny(unknown=False)) in (0, "a", None)


class Tiny(Message):
    """A message that is read at a glance."""

    NAME = "TINY"
    ID = 202
    LENGTH = BASE_LENGTH = 8
    FIELDS = "a:B b:2h=-1 c:3s"


def people_read_messages():
    """Name and fields in their order; who has sent it."""
    message = Tiny(unknown=False).update(a=200, b=[2, None], c="ab")
    assert repr(message) == "TINY(a=200, b=(2, None), c='ab')", repr(message)
    wire = Wire()
    link = Link(wire, 201, 7, 2, (Tiny,))
    link.sequence = 255
    found = []
    for _ in range(2):
        link.send(message)
        found += list(link.feed(wire.frames[-1]))
    assert [(each.source_sequence, each.source_system, each.source_component) for each in found] == [
        (255, 201, 7),
        (0, 201, 7),
    ]
    assert [bytes(each.wire) for each in found] == [bytes(message.wire)] * 2
    assert link.sequence == 1


class Wire:
    """A stream that keeps frames; `takes` is what its next writes say, or raise."""

    def __init__(self, *takes):
        self.takes = list(takes)
        self.frames = []

    def write(self, frame):
        """Take all, or what is told."""
        self.frames.append(bytes(frame))
        told = self.takes.pop(0) if self.takes else len(frame)
        if isinstance(told, Exception):
            raise told
        return told


def links_that_cannot_be():
    """ValueError for ids, versions and lengths that MAVLink does not have; the first and the last that it has are."""
    source, versions = "a source has a system id and a component id from 1 to 255", "MAVLink has the versions 1 and 2"
    length = "a payload has 1 to 255 bytes"
    for given, reason in (
        ((0, 1, 2), source),
        ((256, 1, 2), source),
        ((1, 0, 2), source),
        ((1, 256, 2), source),
        ((1, 1, 0), versions),
        ((1, 1, 3), versions),
        ((1, 1, 2, (), 0), length),
        ((1, 1, 2, (), 256), length),
        ((1, 1, 1, (), 255, Stamp()), "MAVLink 1 has no signatures"),
    ):
        assert error_of(ValueError, Link, Wire(), *given) == reason, given
    message = Tiny(unknown=False).update(a=1)
    for system, component, version, longest in ((1, 255, 1, 8), (255, 1, 2, 255), (255, 255, 2, 8), (1, 1, 1, 255)):
        link = Link(Wire(), system, component, version, (), longest)
        assert (link.version, link.signing, link.sequence, link.tx_errors) == (version, None, 0, 0)
        frame = bytes(link.encode(message))
        at = 5 if version == 2 else 3
        assert tuple(frame[at : at + 2]) == (system, component)
        assert frame[0] == (0xFD if version == 2 else 0xFE)
        assert len(frame) == (12 + 1 if version == 2 else 8 + 8), frame
    plain = Sender(Wire())
    assert (plain.version, tuple(bytes(plain.encode(message))[5:7])) == (2, (1, 1))
    assert Link(Wire(), 1, 1, 2, (), 1).version == 2
    few = Link(Wire(), 1, 1, 2, (), 8, None, ((0, 1), (8, 8)))
    for text in ("", "a", "ab", "abc", "a"):
        frame = few.encode(Tiny(unknown=False).update(a=1, c=text))
        assert len(frame) == 12 + (5 + len(text) if text else 1), bytes(frame)
    assert error_of(ValueError, Receiver, (), None, 279) == "a frame has up to 280 bytes"
    assert Receiver((), None, 280).received == 0
    assert error_of(ValueError, Link(Wire(), 1, 1, 2, (), 7).encode, Tiny(unknown=False).update(c="abc"))


def what_a_stream_does_not_take_is_counted():
    """A part of a frame, nothing, None and an OSError; the number of the next frame goes on all the same."""
    wire = Wire(5, 0, None, OSError(5), 14, 13)
    link = Link(wire)
    message = Tiny(unknown=False).update(a=1)
    found = []
    for sequence in range(7):
        assert link.sequence == sequence
        found.append((link.send(message), link.tx_errors))
    assert found == [(5, 1), (0, 2), (0, 3), (0, 4), (14, 5), (13, 5), (13, 5)], found
    assert [frame[4] for frame in wire.frames] == list(range(7))
    link.sequence = 256 + 7
    assert link.sequence == 7
    wire.takes.append(ValueError("broken"))
    assert error_of(ValueError, link.send, message) == "broken"


def what_arrives_is_bytes():
    """Any kind of bytes, None for none; what is left of earlier ones comes first, and no byte is lost."""
    frames = b""
    for number in range(40):
        wire = Wire()
        Link(wire).send(Tiny(unknown=False).update(a=number + 1, c="abc"))
        frames += wire.frames[0]
    for kind in (bytes, bytearray, memoryview):
        for piece in (3, 100, 300, 700):
            link = Link(Wire(), 1, 1, 2, (Tiny,))
            found = []
            for at in range(0, len(frames), piece):
                arrived = link.feed(kind(frames[at : at + piece]))
                if at // piece % 3 > 0:  # else they come with the next call
                    found += [message.a for message in arrived]
            found += [message.a for message in link.feed(None)]
            assert found == list(range(1, 41)), (kind, piece, found)
            assert (link.received, link.signed, link.refused, link.crc_errors) == (40, 0, 0, 0)
    for wrong in ("text", 5, [1]):
        assert error_of(TypeError, link.feed, wrong) == "what arrives is bytes, a bytearray or a memoryview"
    link = Link(Wire(), 1, 1, 2, (Tiny,))
    link.put(frames[:-1])
    count = 0
    while link.receive() is not None:
        count += 1
    assert count == 39, count
    link.give_up()
    assert link.receive() is None
    assert [message.a for message in link.feed(frames[-1:] + frames[:20])] == [1]
    assert link.crc_errors == 0
    link.give_up()  # nothing is begun
    assert [message.a for message in link.feed(frames[:20])] == [1]
    link = Link(Wire(), 1, 1, 2, (Tiny,))
    data = bytearray(frames + frames)
    link.put(data)
    data[len(frames) :] = b""  # the caller may make them shorter
    assert [message.a for message in link.feed(None)] == list(range(1, 41))
    assert [message.a for message in link.feed(frames)] == list(range(1, 41))


def messages_are_made_for_those_that_are_expected():
    """For each frame with an id that none is for yet one that a function makes; others go on as they are."""
    wire, made = Wire(), []
    Link(wire).send(Tiny(unknown=False).update(a=5))
    Link(wire).send(Invented(unknown=False).update(flag=6))
    kept = Invented(unknown=False)
    link = Link(Wire(), 1, 1, 2, (kept,))

    def make(number):
        made.append(Tiny(unknown=False))
        assert number == Tiny.ID
        return made[-1]

    link.expect((Invented.ID, Tiny.ID), make)
    for count in (1, 2):
        found = list(link.feed(wire.frames[0] + wire.frames[1]))
        assert len(made) == count
        assert found[0] is made[-1]
        assert found[1] is kept
        assert (found[0].a, found[1].flag) == (5, 6)


class Stamp:
    """A signature of the same thirteen bytes for each frame; `asked` are those that it was asked about."""

    unsigned = (Invented.ID,)

    def __init__(self, key=1):
        self.key = key
        self.asked = []

    def sign(self, frame):
        """Put the bytes at the end of a frame."""
        frame[-13:] = bytes([self.key] * 13)

    def accepts(self, frame):
        """Return whether they are its own."""
        self.asked.append(bytes(frame))
        return bytes(frame[-13:]) == bytes([self.key] * 13)


def signatures_are_made_and_judged():
    """A link that signs takes signed frames that it accepts, unsigned ones of a few messages, and counts the others."""
    own, other = Stamp(), Stamp(2)
    link = Link(Wire(), 1, 1, 2, (Tiny, Invented(unknown=False)), 255, own)
    assert link.signing is own
    message, free = Tiny(unknown=False).update(a=9, c="abc"), Invented(unknown=False).update(wide=3)
    frames = {}
    for name, signing in (("own", own), ("other", other), ("none", None)):
        wire = Wire()
        sender = Link(wire, 7, 8, 2, (), 255, signing)
        sender.send(message)
        sender.send(free)
        frames[name] = wire.frames
        extra = 13 if signing else 0
        assert [frame[2] for frame in wire.frames] == [1 if signing else 0] * 2
        assert [len(frame) for frame in wire.frames] == [20 + extra, 13 + extra]
    found = [(type(each), each.source_system) for each in link.feed(frames["own"][0] + frames["own"][1])]
    assert found == [(Tiny, 7), (Invented, 7)]
    assert own.asked == frames["own"]
    assert (link.received, link.signed, link.refused) == (2, 2, 0)
    assert list(link.feed(frames["other"][0])) == []
    assert list(link.feed(frames["none"][0])) == []
    assert (link.received, link.signed, link.refused) == (2, 2, 2)
    assert [type(each) for each in link.feed(frames["none"][1])] == [Invented]
    assert (link.received, link.signed, link.refused, link.crc_errors) == (3, 2, 2, 0)
    damaged = bytearray(frames["own"][0])
    damaged[12] ^= 1
    assert list(link.feed(damaged + bytes(300))) == []
    assert (link.received, link.refused, link.crc_errors) == (3, 2, 1)
    open_link = Link(Wire(), 1, 1, 2, (Tiny,))
    assert [each.a for each in open_link.feed(frames["own"][0] + frames["other"][0])] == [9, 9]
    assert (open_link.received, open_link.signed, open_link.refused) == (2, 2, 0)


CHECKS = (
    (values_go_in_and_come_out,),
    (nothing_is_known_at_first,),
    (what_cannot_be_carried_is_refused,),
    (names_that_are_none,),
    (live_values_are_those_of_the_fields,),
    (names_are_found_when_they_are_used,),
    (people_read_messages,),
    (links_that_cannot_be,),
    (what_a_stream_does_not_take_is_counted,),
    (what_arrives_is_bytes,),
    (messages_are_made_for_those_that_are_expected,),
    (signatures_are_made_and_judged,),
)

if __name__ == "__main__":
    main(CHECKS)
