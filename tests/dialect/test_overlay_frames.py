"""Messages that overlays add: the generated codec sends, byte for byte, what pymavlink makes of the same XML."""

from functools import cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from overlay_codec import codec, oracle, overlaid

from codegen.model.dialect.dialect import Dialect, Kind, WireField

UPSTREAM, INFO, DRAFT = "battery_upstream.xml", "battery_info_upstream.xml", "battery_rfc_0018.xml"
CELLS, FAULTS = "battery_cell_voltages_rfc_0018.xml", "battery_cell_faults_rfc_0018.xml"
CHOICES = {
    "upstream": ((UPSTREAM, INFO, "protocol_version.xml"), False),
    "draft-as-it-is": ((DRAFT,), False),
    "draft-corrected": ((DRAFT, CELLS), True),
    "upstream-with-cells": ((UPSTREAM, CELLS), True),
    "faults-corrected": ((FAULTS,), True),
}
MESSAGES = [
    # choice, message, id, CRC_EXTRA (None: stated nowhere), payload
    ("upstream", "BATTERY_STATUS_V2", 369, 145, 27),
    ("upstream", "BATTERY_INFO", 372, 26, 140),
    ("upstream", "PROTOCOL_VERSION", 300, 217, 22),
    ("draft-as-it-is", "BATTERY_STATUS_V2", 369, 151, 24),
    ("draft-corrected", "BATTERY_STATUS_V2", 369, 151, 24),
    ("draft-corrected", "BATTERY_CELL_VOLTAGES", 54371, None, 28),
    ("upstream-with-cells", "BATTERY_STATUS_V2", 369, 145, 27),
    ("upstream-with-cells", "BATTERY_CELL_VOLTAGES", 54371, None, 28),
    ("faults-corrected", "BATTERY_CELL_VOLTAGES", 54372, None, 10),
]
SOURCE = (1, 180)


@cache
def made(choice: str) -> tuple[Dialect, Any]:
    """The dialect of a choice of overlays, ours and pymavlink's."""
    overlays, is_corrected = CHOICES[choice]
    dialect, _ = overlaid(*overlays, is_corrected=is_corrected)
    return dialect, oracle(*overlays, is_corrected=is_corrected)


@pytest.mark.requirement("FR-00072.1")
@pytest.mark.parametrize(("choice", "name", "number", "crc_extra", "length"), MESSAGES)
def test_layout(choice: str, name: str, number: int, crc_extra: int | None, length: int) -> None:
    """Id, CRC_EXTRA and length are those that the documents state, and those of mavgen after the corrections."""
    dialect, theirs = made(choice)
    found, expected = dialect.messages[name], getattr(theirs, f"MAVLink_{name.lower()}_message")
    assert (found.id, found.length) == (number, length)
    assert crc_extra in (None, found.crc_extra)
    assert (found.id, found.crc_extra, found.length) == (expected.id, expected.crc_extra, expected.unpacker.size)
    assert [field.name for field in found.fields] == expected.ordered_fieldnames


def value_of(field: WireField) -> st.SearchStrategy[Any]:
    """Any value that the wire carries: both ends, sentinels and NaN among them."""
    kind = field.type.kind
    if kind is Kind.CHAR:
        return st.text(st.characters(min_codepoint=1, max_codepoint=127), max_size=field.count)
    if kind is Kind.FLOAT:
        one: st.SearchStrategy[Any] = st.floats(width=32)
    else:
        one = st.integers(field.type.minimum, field.type.maximum) | st.just(0)
    return st.lists(one, min_size=field.count, max_size=field.count) if field.is_array else one


def sent(modules: SimpleNamespace, name: str, values: dict[str, Any]) -> bytes:
    """The frame that the codec's link sends."""
    frames: list[bytes] = []
    stream = SimpleNamespace(write=lambda data: frames.append(bytes(data)) or len(data))
    message = next(kind for kind in modules.messages.ALL if name == kind.NAME)()
    modules.mavlink.Link(stream, *SOURCE).send(message.update(**values))
    return frames[0]


@pytest.mark.parametrize(("choice", "name"), [entry[:2] for entry in MESSAGES])
def test_frames_are_those_of_pymavlink(choice: str, name: str, tmp_path: Path) -> None:
    """For any values of the fields, after the corrections of types and ids; all these ids go out in MAVLink 2 only."""
    dialect, theirs = made(choice)
    message = dialect.messages[name]
    kind = getattr(theirs, f"MAVLink_{name.lower()}_message")
    texts = {field.name for field in message.fields if field.type.kind is Kind.CHAR}
    with codec(dialect, tmp_path) as modules:

        @settings(max_examples=150, deadline=None)
        @given(st.fixed_dictionaries({field.name: value_of(field) for field in message.fields}))
        def compare(values: dict[str, Any]) -> None:
            expected = kind(**{key: value.encode() if key in texts else value for key, value in values.items()})
            assert sent(modules, name, values) == bytes(expected.pack(theirs.MAVLink(None, *SOURCE)))

        compare()


@pytest.mark.parametrize("choice", CHOICES)
def test_flags_of_pymavlink_are_ours(choice: str) -> None:
    """Names and values of the overlays' bitmask, as corrected: what a receiver built from the same XML calls them."""
    dialect, theirs = made(choice)
    if "MAV_BATTERY_STATUS_FLAGS" in dialect.enums:
        entries = theirs.enums["MAV_BATTERY_STATUS_FLAGS"]
        expected = {entry.name: value for value, entry in entries.items() if not entry.name.endswith("_ENUM_END")}
        assert {entry.name: entry.value for entry in dialect.enums["MAV_BATTERY_STATUS_FLAGS"].entries} == expected
