"""Every way to write ``invalid``, and what is said about those that mean nothing."""

import math
import struct
from collections.abc import Callable

import pytest
from hypothesis import given
from hypothesis import strategies as st

from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_names
from codegen.model.dialect.dialect import (
    Dialect,
    EnumDefinition,
    EnumEntry,
    FieldDefinition,
    Kind,
    Sentinel,
    SentinelForm,
)
from codegen.resolve.dialect.sentinel import sentinel_of
from codegen.resolve.dialect.wire import WIRE_TYPES
from codegen.source import Place

HERE = Place("/d.xml", 7, 3)
STATES = EnumDefinition(
    "STATE", (EnumEntry("STATE_UNDEFINED", 5, "", HERE), EnumEntry("STATE_BIG", 300, "", HERE)), False, "", HERE
)
VALUE, EACH, FIRST, POSITIONS = SentinelForm.VALUE, SentinelForm.EACH, SentinelForm.FIRST, SentinelForm.POSITIONS


def sentinel(
    text: str, type_name: str, length: int | None = None, enum: EnumDefinition | None = None
) -> tuple[Sentinel | None, Report]:
    report = Report()
    field = FieldDefinition("f", type_name, length, False, HERE, invalid=text)
    return sentinel_of(field, WIRE_TYPES[type_name], enum, HERE, report), report


@pytest.mark.parametrize(
    ("text", "type_name", "length", "form", "values"),
    [
        ("0", "uint8_t", None, VALUE, (0,)),
        ("-1", "int16_t", None, VALUE, (-1,)),
        ("+7", "int8_t", None, VALUE, (7,)),
        (" 36100 ", "uint16_t", None, VALUE, (36100,)),
        ("0xFFFF", "uint16_t", None, VALUE, (65535,)),
        ("0xffff", "float", None, VALUE, (65535.0,)),
        ("UINT8_MAX", "uint8_t", None, VALUE, (255,)),
        ("INT8_MAX", "int8_t", None, VALUE, (127,)),
        ("INT16_MAX", "int16_t", None, VALUE, (32767,)),
        ("INT32_MIN", "int32_t", None, VALUE, (-(2**31),)),
        ("UINT16_MIN", "uint16_t", None, VALUE, (0,)),
        ("UINT64_MAX", "uint64_t", None, VALUE, (2**64 - 1,)),
        ("UINT16_MAX", "float", None, VALUE, (65535.0,)),
        ("UINT32_MAX", "float", None, VALUE, (4294967296.0,)),  # the wire's precision leaves no odd number there
        ("INT16_MAX", "uint16_t", None, VALUE, (32767,)),
        ("-1.0", "float", None, VALUE, (-1.0,)),
        ("-1.0", "int8_t", None, VALUE, (-1,)),
        ("1e3", "uint16_t", None, VALUE, (1000,)),
        ("0.1", "float", None, VALUE, (struct.unpack("<f", struct.pack("<f", 0.1))[0],)),
        ("0.1", "double", None, VALUE, (0.1,)),
        ("STATE_UNDEFINED", "uint8_t", None, VALUE, (5,)),
        ("0", "uint8_t_mavlink_version", None, VALUE, (0,)),
        ("0", "char", 9, VALUE, (0,) * 9),
        ("[0]", "char", 9, EACH, (0,) * 9),
        ("[UINT16_MAX]", "uint16_t", 3, EACH, (65535,) * 3),
        ("[ 0 ]", "float", 4, EACH, (0.0,) * 4),
        ("[STATE_UNDEFINED]", "uint8_t", 2, EACH, (5, 5)),
        ("[0:]", "int32_t", 3, FIRST, (0, None, None)),
        ("[UINT8_MAX:]", "uint8_t", 1, FIRST, (255,)),
        ("[1,,3]", "uint8_t", 3, POSITIONS, (1, None, 3)),
        ("[1,2]", "uint8_t", 3, POSITIONS, (1, 2, None)),
        ("[1,]", "uint8_t", 3, POSITIONS, (1, None, None)),
        ("[1,]", "uint8_t", 1, POSITIONS, (1,)),
        ("[,-1]", "int8_t", 2, POSITIONS, (None, -1)),
        ("[1,,3,]", "uint8_t", 5, POSITIONS, (1, None, 3, None, None)),
    ],
)
def test_forms(
    text: str, type_name: str, length: int | None, form: SentinelForm, values: tuple[int | float | None, ...]
) -> None:
    """All forms of the wire facts; numbers keep the kind of the field, so float fields have floats."""
    found, report = sentinel(text, type_name, length, STATES)
    assert list(report) == []
    assert found == Sentinel(form, values, text.strip(), HERE)
    is_float = WIRE_TYPES[type_name].kind is Kind.FLOAT
    assert all(isinstance(value, float if is_float else int) for value in found.values if value is not None)


@pytest.mark.parametrize("text", ["NaN", "NAN", "nan"])
@pytest.mark.parametrize("type_name", ["float", "double"])
def test_not_a_number(text: str, type_name: str) -> None:
    """NaN is written in several ways and is never equal to itself, so it needs a test of its own."""
    found, report = sentinel(text, type_name)
    assert list(report) == []
    assert found is not None
    assert math.isnan(found.values[0] or 0)
    first, _ = sentinel(f"[{text}:]", type_name, 2)
    assert first is not None
    assert (math.isnan(first.values[0] or 0), first.values[1]) == (True, None)


@pytest.mark.parametrize("text", ["", "  "])
def test_an_empty_attribute_is_no_sentinel(text: str) -> None:
    """A correction takes a wrong sentinel away by setting it to the empty text."""
    assert sentinel(text, "uint8_t")[0] is None
    assert list(sentinel(text, "uint8_t")[1]) == []


@pytest.mark.parametrize(
    ("text", "type_name", "length", "rule"),
    [
        ("256", "uint8_t", None, "sentinel-range"),
        ("-1", "uint16_t", None, "sentinel-range"),
        ("UINT16_MAX", "int16_t", None, "sentinel-range"),
        ("0.5", "int32_t", None, "sentinel-range"),
        ("NaN", "int32_t", None, "sentinel-range"),
        ("1e39", "float", None, "sentinel-range"),
        ("1e999", "double", None, "sentinel-range"),
        ("1e999", "uint64_t", None, "sentinel-range"),
        ("STATE_BIG", "uint8_t", None, "sentinel-range"),
        ("256", "char", 9, "sentinel-range"),
        ("[1,256]", "uint8_t", 2, "sentinel-range"),
        ("UINT16_MAXX", "uint16_t", None, "sentinel-text"),
        ("inf", "float", None, "sentinel-text"),
        ("-1 or estimate", "int8_t", None, "sentinel-text"),
        ("٣", "uint8_t", None, "sentinel-text"),
        ("9" * 5000, "uint8_t", None, "sentinel-text"),
        ("1e" + "9" * 50, "double", None, "sentinel-text"),
        ("[0]", "uint8_t", None, "sentinel-text"),
        ("[0", "uint8_t", 2, "sentinel-text"),
        ("0]", "uint8_t", 2, "sentinel-text"),
        ("[", "uint8_t", 2, "sentinel-text"),
        ("]", "uint8_t", 2, "sentinel-text"),
        ("[]", "uint8_t", 2, "sentinel-text"),
        ("[:]", "uint8_t", 2, "sentinel-text"),
        ("[,]", "uint8_t", 2, "sentinel-text"),
        ("[[0]]", "uint8_t", 2, "sentinel-text"),
        ("[0:1]", "uint8_t", 2, "sentinel-text"),
        ("[1,2,3]", "uint8_t", 2, "sentinel-text"),
    ],
)
def test_what_cannot_be_a_sentinel(text: str, type_name: str, length: int | None, rule: str) -> None:
    """Out of range, or not readable: one finding at the field, and no sentinel rather than a guess."""
    found, report = sentinel(text, type_name, length, STATES)
    assert found is None
    assert [(one.rule.id, one.place) for one in report] == [(rule, HERE)]


def test_a_misspelt_name_gets_a_suggestion() -> None:
    """The names of the limits and of the enum's entries are what can be meant."""
    hints = [next(iter(sentinel(text, "uint8_t", None, STATES)[1])).hint for text in ("UINT8_MX", "STATE_UNDEFIND")]
    assert "UINT8_MAX" in (hints[0] or "")
    assert "STATE_UNDEFINED" in (hints[1] or "")


@pytest.mark.parametrize("name", shipped_dialect_names(DISK))
def test_every_shipped_sentinel_can_be_read(name: str, shipped: Callable[[str], tuple[Dialect, Report]]) -> None:
    """322 attributes in pymavlink 2.4.50; each field that has one has its sentinel, and the type can carry it."""
    dialect, report = shipped(name)
    assert [one for one in report if one.rule.id.startswith("sentinel")] == []
    for message in dialect.messages.values():
        for field in message.fields:
            assert (field.sentinel is None) == (field.definition.invalid is None), (message.name, field.name)
            if field.sentinel is not None:
                assert len(field.sentinel.values) == field.count
                known = [value for value in field.sentinel.values if value is not None]
                code = "B" if field.type.code == "s" else field.type.code
                unpacked = struct.unpack(f"<{len(known)}{code}", struct.pack(f"<{len(known)}{code}", *known))
                assert [repr(value) for value in unpacked] == [repr(value) for value in known]


SCRAPS = st.sampled_from(
    ["[", "]", ":", ",", "0", "1", "-", ".", "e", "x", "NaN", "UINT8_MAX", "STATE_BIG", " ", "9" * 30]
)


@given(
    text=st.one_of(st.text(), st.lists(SCRAPS, max_size=12).map("".join)),
    type_name=st.sampled_from(sorted(WIRE_TYPES)),
    length=st.one_of(st.none(), st.integers(1, 255)),
    enum=st.sampled_from([None, STATES]),
)
def test_no_text_raises(text: str, type_name: str, length: int | None, enum: EnumDefinition | None) -> None:
    """Whatever is written there: a sentinel that the field can carry, a finding, or nothing for an empty text."""
    found, report = sentinel(text, type_name, length, enum)
    findings = list(report)
    if found is None:
        assert bool(findings) == bool(text.strip())
    else:
        assert findings == []
        assert len(found.values) == (1 if length is None else length)
        assert any(value is not None for value in found.values)
