"""Fields are read and written strictly, and alike on both interpreters."""

import keyword
import math
import re
from pathlib import Path
from types import SimpleNamespace

import pytest
from firmware_runs import Exercise

from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path

INTEGERS = {"b": (-128, 127), "B": (0, 255), "h": (-32768, 32767), "H": (0, 65535), "i": (-(2**31), 2**31 - 1)}
INTEGERS |= {"I": (0, 2**32 - 1), "q": (-(2**63), 2**63 - 1), "Q": (0, 2**64 - 1)}


def test_values_that_a_field_cannot_carry_are_refused(exercise: Exercise) -> None:
    """MicroPython's struct wraps and makes infinities where CPython's raises: set() raises ValueError on both."""
    refused: list[tuple[object, object]] = []
    taken: list[tuple[object, object]] = []
    for code, (low, high) in INTEGERS.items():
        taken += [(code, low), (code, high), (code, True)]
        refused += [(code, low - 1), (code, high + 1), (f"2{code}", [0, high + 1])]
        refused += [(code, {"float": text}) for text in ("nan", "inf", "1.0", "0.5")]
        refused += [
            (code, "1"),
            (code, None),
            (f"2{code}", [1]),
            (f"2{code}", [1, 2, 3]),
        ]
    taken += [(code, {"float": text}) for code in "fd" for text in ("nan", "inf", "-inf", "3.4e38")]
    taken += [("d", {"float": "1e39"}), ("f", 7), ("f", False)]
    refused += [
        ("f", {"float": "1e39"}),
        ("2f", [0, {"float": "-1e39"}]),
        ("f", 10**39),
    ]
    refused += [("f", "1"), ("f", None), ("3f", [1, 2]), ("d", 10**400)]
    taken += [
        ("4s", "four"),
        ("4s", ""),
        ("4s", {"hex": "ff00ff00"}),
        ("s", "x"),
    ]
    refused += [
        ("4s", "fives"),
        ("4s", "é"),
        ("4s", {"hex": "0102030405"}),
        ("4s", 4),
    ]
    refused += [("s", "xy")]
    for cases, expected in ((refused, ["ValueError", True]), (taken, [None, True])):
        results = exercise("refusals", cases=cases)
        assert [case for case, result in zip(cases, results, strict=True) if result != expected] == []


@pytest.fixture
def message(firmware: SimpleNamespace) -> object:
    """A message with a scalar, an array, text, and fields called like attributes of Message."""
    fields = "id:B cells:3H=65535 text:6s wire:2B level:f get:H"
    return type("Sample", (firmware.message.Message,), {"NAME": "SAMPLE", "LENGTH": 21, "FIELDS": fields})()


def test_fields_read_as_attributes(message: SimpleNamespace) -> None:
    """Scalar, tuple, text; a name that Message uses itself is reached through get()."""
    assert message.names() == ["id", "cells", "text", "wire", "level", "get"]
    message.set("id", 3)
    message.set("cells", (1, 2, 65534))
    message.set("text", "low")
    message.set("wire", b"\x01\x02")
    message.set("level", math.nan)
    message.set("get", 7)
    assert (message.id, message.cells, message.text) == (3, (1, 2, 65534), "low")
    assert (message.get("wire"), message.get("get")) == ((1, 2), 7)
    assert message.wire == bytes.fromhex("03 0100 0200 feff 6c6f77000000 0102 0000c07f 0700")
    assert math.isnan(message.level)


def test_attributes_write_fields(message: SimpleNamespace) -> None:
    """An assigned value goes out as set() has it, or is refused; a name that is no field is not kept silently."""
    message.id = 3
    message.cells = [1, None, 65534]
    message.text = "low"
    assert message.wire[:13] == bytes.fromhex("03 0100 ffff feff 6c6f77000000")
    with pytest.raises(ValueError, match=r"SAMPLE\.id cannot carry 256"):
        message.id = 256
    with pytest.raises(ValueError, match=r"SAMPLE\.id cannot carry 2\.5"):
        message.id = 2.5
    for name in ("voltage", "live", "source_system", "_image"):
        with pytest.raises(AttributeError, match=name):
            setattr(message, name, 1)
    assert message.id == 3


def test_text_ends_at_the_first_nul(message: SimpleNamespace) -> None:
    """The bytes behind a NUL are not text, a full field has none, a shorter text leaves nothing of a longer one."""
    message.set("text", "sixsix")
    assert message.text == "sixsix"
    message.set("text", b"ab\0cd")
    assert message.text == "ab"
    message.set("text", "")
    assert message.text == ""
    assert message.wire[7:13] == bytes(6)


def test_text_that_is_not_ascii_comes_as_bytes(message: SimpleNamespace) -> None:
    """The interpreters differ in what they take for UTF-8; bytes leave the choice to the reader."""
    message.set("text", b"\xc3\xa9\0x")
    assert message.text == b"\xc3\xa9"


def test_unknown_names(message: SimpleNamespace) -> None:
    """A missing attribute is an AttributeError, as hasattr() wants it, a missing field a KeyError."""
    assert not hasattr(message, "voltage")
    for reach in (message.get, message.raw, lambda name: message.set(name, 1)):
        with pytest.raises(KeyError):
            reach("voltage")
    with pytest.raises(ValueError, match=r"SAMPLE\.id cannot carry 256"):
        message.set("id", 256)


def field_names() -> list[str]:
    """The names of all fields of all messages of all dialects that pymavlink ships, and those that collide anyway."""
    found = {"self", "wire", "ID", "NAME", "update", "live", "source_system", "get", "from", "class", "None"}
    for dialect in shipped_dialect_names(DISK):
        path = shipped_dialect_path(dialect, DISK)
        assert path is not None
        found |= set(re.findall(r'<field\b[^>]* name="(\w+)"', Path(path).read_text(encoding="utf-8")))
    return sorted(found)


def test_each_field_of_each_dialect_is_an_attribute(firmware: SimpleNamespace, exercise: Exercise) -> None:
    """Under its name, or with "_" behind it where the name is something else, as docs/codec.md says."""
    names = field_names()
    own = {*dir(firmware.message.Message), "wire", "live"}
    assert len(names) > 1000
    cases = [(name, f"{name}_" if name in own or keyword.iskeyword(name) or name == "self" else name) for name in names]
    assert exercise("attributes", cases=cases) == [[513, "000102", 770, "000203"]] * len(cases)
    refused = sorted(own & set(names))
    assert {"wire", "live", "ID", "update", "source_system"} <= set(refused)
    told = exercise("attributes", cases=[(name, name) for name in refused])
    assert [wire for _, wire in told] == ["000000"] * len(refused)
    for name, (error, _) in zip(refused, told, strict=True):
        # What is a property MicroPython refuses by itself, in words of its own.
        assert error == f"SAMPLE.{name} is no field: the field is {name}_" or (
            name == "source_system" and exercise.interpreter == "micropython" and name in error
        )


def test_what_is_no_field_is_told_with_the_nearest(message: SimpleNamespace) -> None:
    """The error names the message and what was meant, if anything is near."""
    writing = (lambda name: message.set(name, 1), lambda name: message.update(**{name: 1}))
    for reach in (message.get, message.raw, *writing):
        with pytest.raises(KeyError, match=r"SAMPLE has no field cels; did you mean cells\?"):
            reach("cels")
        with pytest.raises(KeyError, match=r"SAMPLE has no field nope'$"):
            reach("nope")
    with pytest.raises(KeyError, match=r"SAMPLE has no field cels; did you mean cells\?"):
        type(message)(live=("cels[0]",))
    with pytest.raises(KeyError, match="SAMPLE has no field 5"):
        message.get(5)
    for reach in (lambda name: getattr(message, name), lambda name: setattr(message, name, 1)):
        with pytest.raises(AttributeError, match=r"^SAMPLE has no field levl; did you mean level\?$"):
            reach("levl")
        with pytest.raises(AttributeError, match=r"^SAMPLE has no field nope$"):
            reach("nope")


def test_values_of_the_wrong_kind_are_refused_in_words(message: SimpleNamespace, exercise: Exercise) -> None:
    """Text for numbers and the like: no error of Python's own, which would not name the field; nothing is written."""
    for name, value, words in (
        ("id", [1], r"cannot carry \[1\]"),
        ("id", "1", "cannot carry '1'"),
        ("id", b"1", "cannot carry b'1'"),
        ("id", 1j, "cannot carry 1j"),
        ("cells", 5, "is an array and cannot be 5"),
        ("cells", "abc", "cannot carry 'a'"),
        ("cells", {}, "takes 3 values, not 0"),
        ("cells", [[1], 2, 3], r"cannot carry \[1\]"),
        ("text", 5, "cannot carry 5: neither text nor bytes"),
        ("text", ["a"], r"cannot carry \['a'\]: neither text nor bytes"),
        ("text", "Gruß", "cannot carry 'Gruß': text is ASCII"),
        ("text", "seventh", "takes up to 6 characters, not 7"),
        ("level", "high", "cannot carry 'high'"),
    ):
        before = bytes(message.wire)
        with pytest.raises(ValueError, match=rf"^SAMPLE\.{name} {words}"):
            message.set(name, value)
        assert message.wire == before
    message.set("cells", b"abc")
    assert message.cells == (97, 98, 99)
    refused = exercise("refusals", cases=[("3H=65535", "abc"), ("3H=65535", {"hex": "616263"}), ("3H", "abc")])
    assert refused == [["ValueError", True], [None, True], ["ValueError", True]]


def test_one_live_field_needs_no_tuple(message: SimpleNamespace) -> None:
    """A text is a name, and not the names that its letters would be."""
    live = type(message)(live="id")
    live.live[0] = 7
    assert live.id == 7
    with pytest.raises(KeyError, match="SAMPLE has no field ids; did you mean id"):
        type(message)(live="ids")


def test_update_writes_several_fields(message: SimpleNamespace) -> None:
    """It returns the message, to be sent in the same line; a value that is refused is told with its field."""
    assert message.update(id=9, text="on") is message
    assert (message.id, message.text) == (9, "on")
    with pytest.raises(ValueError, match=r"SAMPLE\.cells takes 3 values, not 2"):
        message.update(cells=(1, 2))


def test_update_that_is_refused_changes_nothing(message: SimpleNamespace) -> None:
    """Whatever comes before the value that is refused, and the first elements of its array, stay as they were."""
    live = type(message)(live=("id", "cells[0]"))
    for sample in (message, live):
        sample.update(id=9, cells=[7, 8, None], text="on", level=1.5)
        before = bytes(sample.wire), list(sample.live)
        for refused in (
            {"id": 1, "text": "off", "cells": [1, 2, 65536]},
            {"id": 1, "cells": [1, None, 2.5]},
            {"cells": [1, None, 3], "text": "too long"},
            {"id": 1, "cells": None, "level": "high"},
        ):
            with pytest.raises(ValueError, match=r"SAMPLE\.(cells cannot carry|text takes|level cannot carry)"):
                sample.update(**refused)
            assert (bytes(sample.wire), list(sample.live)) == before
        with pytest.raises(KeyError, match="voltage"):
            sample.update(id=1, voltage=1)
        with pytest.raises(ValueError, match=r"SAMPLE\.cells cannot carry 65536"):
            sample.set("cells", [1, None, 65536])
        assert (bytes(sample.wire), list(sample.live)) == before
    assert list(live.live) == [9, 7]


def test_message_shows_its_fields(message: SimpleNamespace) -> None:
    """Whoever prints a message sees what the fields say, not what is on the wire."""
    message.update(id=9, text="on", level=1.5)
    shown = "SAMPLE(id=9, cells=(None, None, None), text='on', wire=(0, 0), level=1.5, get=0)"
    assert repr(message) == shown


def test_messages_do_not_share_payloads(message: SimpleNamespace) -> None:
    """Each instance has a payload of its own, zero at first."""
    other = type(message)()
    message.set("id", 1)
    assert (other.id, other.source_system, other.source_component, other.source_sequence) == (0, 0, 0, 0)


def test_derived_classes_have_fields_of_their_own(message: SimpleNamespace) -> None:
    """The layout is kept with a class: one that derives from it and says otherwise must not get that."""
    assert message.names()
    longer = type("Longer", (type(message),), {"FIELDS": "id:H", "LENGTH": 2})()
    assert longer.update(id=256).names() == ["id"]
    assert longer.wire == b"\x00\x01"
    assert type(message)().update(id=255).wire[:2] == b"\xff\xff"
