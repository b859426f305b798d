"""Fields of messages by name: what they carry, what they refuse, and what they say then.

The message of these checks is made up, so that it has a field of every kind; what it has to do stands beside it.
"""

from invented import Invented, Tiny, Wire, error_of
from mavlink import Link
from program_bench import main

NAN, INFINITY = float("nan"), float("inf")
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


CHECKS = (
    (values_go_in_and_come_out,),
    (nothing_is_known_at_first,),
    (what_cannot_be_carried_is_refused,),
    (names_that_are_none,),
    (live_values_are_those_of_the_fields,),
    (names_are_found_when_they_are_used,),
    (people_read_messages,),
)

if __name__ == "__main__":
    main(CHECKS)
