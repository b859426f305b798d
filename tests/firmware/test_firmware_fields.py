"""Fields are read and written strictly, and alike on both interpreters."""

import math
from types import SimpleNamespace

import pytest
from firmware_runs import Exercise

INTEGERS = {"b": (-128, 127), "B": (0, 255), "h": (-32768, 32767), "H": (0, 65535), "i": (-(2**31), 2**31 - 1)}
INTEGERS |= {"I": (0, 2**32 - 1), "q": (-(2**63), 2**63 - 1), "Q": (0, 2**64 - 1)}


def test_values_that_a_field_cannot_carry_are_refused(exercise: Exercise) -> None:
    """MicroPython's struct wraps and makes infinities where CPython's raises: set() raises ValueError on both."""
    refused: list[tuple[object, object]] = []
    taken: list[tuple[object, object]] = []
    for code, (low, high) in INTEGERS.items():
        taken += [((code, 8, 0), low), ((code, 8, 0), high), ((code, 8, 0), True)]
        refused += [((code, 8, 0), low - 1), ((code, 8, 0), high + 1), ((code, 8, 2), [0, high + 1])]
        refused += [((code, 8, 0), {"float": text}) for text in ("nan", "inf", "1.0", "0.5")]
        refused += [((code, 8, 0), "1"), ((code, 8, 0), None), ((code, 8, 2), [1]), ((code, 8, 2), [1, 2, 3])]
    taken += [((code, 8, 0), {"float": text}) for code in "fd" for text in ("nan", "inf", "-inf", "3.4e38")]
    taken += [(("d", 8, 0), {"float": "1e39"}), (("f", 8, 0), 7), (("f", 8, 0), False)]
    refused += [(("f", 8, 0), {"float": "1e39"}), (("f", 8, 2), [0, {"float": "-1e39"}]), (("f", 8, 0), 10**39)]
    refused += [(("f", 8, 0), "1"), (("f", 8, 0), None), (("f", 8, 3), [1, 2]), (("d", 8, 0), 10**400)]
    taken += [(("s", 8, 4), "four"), (("s", 8, 4), ""), (("s", 8, 4), {"hex": "ff00ff00"}), (("s", 8, 0), "x")]
    refused += [(("s", 8, 4), "fives"), (("s", 8, 4), "é"), (("s", 8, 4), {"hex": "0102030405"}), (("s", 8, 4), 4)]
    refused += [(("s", 8, 0), "xy")]
    for cases, expected in ((refused, ["ValueError", True]), (taken, [None, True])):
        results = exercise("refusals", cases=cases)
        assert [case for case, result in zip(cases, results, strict=True) if result != expected] == []


@pytest.fixture
def message(firmware: SimpleNamespace) -> object:
    """A message with a scalar, an array, text, and fields called like attributes of Message."""
    fields = {
        "id": ("B", 0, 0),
        "cells": ("H", 1, 3),
        "text": ("s", 7, 6),
        "payload": ("B", 13, 2),
        "level": ("f", 15, 0),
    }
    return type("Sample", (firmware.mavlink.Message,), {"NAME": "SAMPLE", "LENGTH": 19, "FIELDS": fields})()


def test_fields_read_as_attributes(message: SimpleNamespace) -> None:
    """Scalar, tuple, text; a name that Message uses itself is reached through get()."""
    message.set("id", 3)
    message.set("cells", (1, 2, 65535))
    message.set("text", "low")
    message.set("payload", b"\x01\x02")
    message.set("level", math.nan)
    assert (message.id, message.cells, message.text) == (3, (1, 2, 65535), "low")
    assert message.get("payload") == (1, 2)
    assert message.payload == bytes.fromhex("03 0100 0200 ffff 6c6f77000000 0102 0000c07f")
    assert math.isnan(message.level)


def test_text_ends_at_the_first_nul(message: SimpleNamespace) -> None:
    """What follows a NUL is not text, a full field has none, a shorter text leaves nothing of a longer one."""
    message.set("text", "sixsix")
    assert message.text == "sixsix"
    message.set("text", b"ab\0cd")
    assert message.text == "ab"
    message.set("text", "")
    assert message.text == ""
    assert message.payload[7:13] == bytes(6)


def test_text_that_is_not_ascii_comes_as_bytes(message: SimpleNamespace) -> None:
    """The interpreters differ in what they take for UTF-8; bytes leave the choice to the reader."""
    message.set("text", b"\xc3\xa9\0x")
    assert message.text == b"\xc3\xa9"


def test_unknown_names(message: SimpleNamespace) -> None:
    """A missing attribute is an AttributeError, as hasattr() wants it, a missing field a KeyError."""
    assert not hasattr(message, "voltage")
    with pytest.raises(KeyError):
        message.get("voltage")
    with pytest.raises(KeyError):
        message.set("voltage", 1)
    with pytest.raises(ValueError, match=r"SAMPLE\.id cannot carry 256"):
        message.set("id", 256)


def test_messages_do_not_share_payloads(message: SimpleNamespace) -> None:
    """Each instance has a payload of its own, zero at first."""
    other = type(message)()
    message.set("id", 1)
    assert (other.id, other.system_id, other.component_id, other.sequence) == (0, 0, 0, 0)
