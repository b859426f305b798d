"""The dialect's value for "unknown" is None for people, in all forms that FIELDS can state."""

import math
from types import SimpleNamespace
from typing import Any

import pymavlink_oracle as oracle
import pytest
from firmware_runs import Exercise

NAN = {"float": "nan"}
REFUSED = "ValueError"

# Word, what get() and raw() tell of a new message; then the value for set() and what get(), raw() and the wire have.
CASES: list[tuple[str, Any, Any, Any, Any, Any, str]] = [
    # V: a scalar
    ("x:H=65535", None, 65535, None, None, 65535, "ffff"),
    ("x:H=65535", None, 65535, 65534, 65534, 65534, "feff"),
    ("x:H=65535", None, 65535, 65535, None, 65535, "ffff"),
    ("x:H=0", None, 0, None, None, 0, "0000"),
    ("x:b=-1", None, -1, None, None, -1, "ff"),
    ("x:b=127", None, 127, -1, -1, -1, "ff"),
    ("x:i=-1", None, -1, None, None, -1, "ffffffff"),
    ("x:I=4294967295", None, 2**32 - 1, None, None, 2**32 - 1, "ffffffff"),
    ("x:Q=18446744073709551615", None, 2**64 - 1, None, None, 2**64 - 1, "ff" * 8),
    ("x:q=-9223372036854775808", None, -(2**63), None, None, -(2**63), "00" * 7 + "80"),
    ("x:f=nan", None, NAN, None, None, NAN, "0000c07f"),
    ("x:f=nan", None, NAN, NAN, None, NAN, "0000c07f"),
    ("x:f=nan", None, NAN, 1.5, 1.5, 1.5, "0000c03f"),
    ("x:f=nan", None, NAN, 0, 0.0, 0.0, "00000000"),
    ("x:d=nan", None, NAN, None, None, NAN, "000000000000f87f"),
    ("x:f=-1", None, -1.0, None, None, -1.0, "000080bf"),
    ("x:f=-1", None, -1.0, NAN, NAN, NAN, "0000c07f"),
    ("x:f=0", None, 0.0, None, None, 0.0, "00000000"),
    # V: in any element
    ("x:3H=65535", [None] * 3, [65535] * 3, None, [None] * 3, [65535] * 3, "ff" * 6),
    ("x:3H=65535", [None] * 3, [65535] * 3, [1, None, 3], [1, None, 3], [1, 65535, 3], "0100ffff0300"),
    ("x:3H=65535", [None] * 3, [65535] * 3, [65535, 0, None], [None, 0, None], [65535, 0, 65535], "ffff0000ffff"),
    ("x:2H=0", [None] * 2, [0] * 2, [None, 1], [None, 1], [0, 1], "00000100"),
    ("x:2f=nan", [None] * 2, [NAN] * 2, [None, 2], [None, 2.0], [NAN, 2.0], "0000c07f00000040"),
    ("x:1b=-1", [None], [-1], [None], [None], [-1], "ff"),
    # V: in element 0 for the whole array
    ("x:3h=-1:", None, [-1, 0, 0], None, None, [-1, 0, 0], "ffff00000000"),
    ("x:3h=-1:", None, [-1, 0, 0], [-1, 7, 8], None, [-1, 7, 8], "ffff07000800"),
    ("x:3h=-1:", None, [-1, 0, 0], [7, -1, -1], [7, -1, -1], [7, -1, -1], "0700ffffffff"),
    ("x:3h=-1:", None, [-1, 0, 0], [None, 7, 8], REFUSED, None, "55" * 6),
    ("x:3f=nan:", None, [NAN, 0.0, 0.0], None, None, [NAN, 0.0, 0.0], "0000c07f" + "00" * 8),
    ("x:3f=nan:", None, [NAN, 0.0, 0.0], [1, NAN, 0], [1.0, NAN, 0.0], [1.0, NAN, 0.0], "0000803f0000c07f00000000"),
    ("x:2B=0:", None, [0, 0], [5, 0], [5, 0], [5, 0], "0500"),
    # V1,,V3: element by element; elements behind the last are always known
    ("x:3B=1,,3", [None, 0, None], [1, 0, 3], None, [None, 0, None], [1, 0, 3], "010003"),
    ("x:3B=1,,3", [None, 0, None], [1, 0, 3], [3, 1, 1], [3, 1, 1], [3, 1, 1], "030101"),
    ("x:3B=1,,3", [None, 0, None], [1, 0, 3], [None, 9, None], [None, 9, None], [1, 9, 3], "010903"),
    ("x:3B=1,,3", [None, 0, None], [1, 0, 3], [1, None, 3], REFUSED, None, "555555"),
    ("x:3B=255,", [None, 0, 0], [255, 0, 0], [None, 255, 255], [None, 255, 255], [255, 255, 255], "ffffff"),
    ("x:3B=255,", [None, 0, 0], [255, 0, 0], None, [None, 0, 0], [255, 0, 0], "ff0000"),
    ("x:2f=,nan", [0.0, None], [0.0, NAN], [1, None], [1.0, None], [1.0, NAN], "0000803f0000c07f"),
    # text
    ("x:4s=0", "", "", "ab", "ab", "ab", "61620000"),
    ("x:4s=0", "", "", None, "", "", "00000000"),
    # no sentinel: always known, never unknown
    ("x:H", 0, 0, 65535, 65535, 65535, "ffff"),
    ("x:H", 0, 0, None, REFUSED, None, "5555"),
    ("x:2H", [0, 0], [0, 0], [0, None], REFUSED, None, "55555555"),
    ("x:2H", [0, 0], [0, 0], None, REFUSED, None, "55555555"),
    ("x:f", 0.0, 0.0, NAN, NAN, NAN, "0000c07f"),
    ("x:f", 0.0, 0.0, None, REFUSED, None, "55555555"),
    ("x:4s", "", "", None, REFUSED, None, "55555555"),
]


def test_unknown_is_none(exercise: Exercise) -> None:
    """A new message, set() with and without None, get(), raw() and the bytes, for each form of a sentinel."""
    cases = [[oracle.described("CASE", word), "x", value] for word, _, _, value, *_ in CASES]
    results = exercise("unknown", cases=cases)
    for case, found in zip(CASES, results, strict=True):
        _, got, raw, _, *after, wire = case
        expected = [got, raw, *([REFUSED] if after[0] == REFUSED else after), wire]
        assert found == expected, case


def test_fields_beside_stay_as_they_are(firmware: SimpleNamespace) -> None:
    """Sentinels find their own field: those around it, at odd places too, keep what they have."""
    description = oracle.described("ROW", "a:B x:3H=65535 b:B y:3f=nan: c:B z:3b=1,,3 d:B")
    row = type("Row", (firmware.message.Message,), description)
    message = row(unknown=False).update(a=1, b=2, c=3, d=4)
    for name in "xyz":
        message.set(name, None)
    assert [message.get(name) for name in "abcd"] == [1, 2, 3, 4]
    assert message.wire == row().update(a=1, b=2, c=3, d=4).wire
    assert message.wire[:8] == b"\x01" + b"\xff" * 6 + b"\x02"
    assert math.isnan(message.raw("y")[0])
    assert message.raw("z") == (1, 0, 3)


def test_received_sentinels_are_none(firmware: SimpleNamespace) -> None:
    """Sentinels that came over the wire read as those that were set; zeros of a truncated frame are zeros."""
    description = oracle.described("ROW", "x:H=65535 y:f=nan z:2B=0", 0)
    row = type("Row", (firmware.message.Message,), description)
    link = firmware.mavlink.Link(None, messages=[row])
    (message,) = link.feed(oracle.raw_frame(0, bytes.fromhex("ffff 0100807f 07"), extra=7))
    assert (message.x, message.y, message.z) == (None, None, (7, None))
    (message,) = link.feed(oracle.raw_frame(0, b"\x00", extra=7))
    assert (message.x, message.y, message.z) == (0, 0.0, (None, None))


def test_attributes_and_text_of_a_message_tell_none(firmware: SimpleNamespace) -> None:
    """Whoever looks at a message sees None, and the wire value only by raw()."""
    message = type("Row", (firmware.message.Message,), oracle.described("ROW", "x:H=65535 z:2B=9"))()
    assert (message.x, message.z) == (None, (None, None))
    assert repr(message) == "ROW(x=None, z=(None, None))"
    with pytest.raises(ValueError, match=r"ROW\.x cannot carry 65536"):
        message.set("x", 65536)
    assert message.x is None
