"""Every message of every shipped dialect is laid out as in the modules that mavgen generated from it."""

import importlib
import inspect
from collections.abc import Callable
from types import ModuleType

import pytest
from pymavlink.generator import mavparse

from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_names
from codegen.model.dialect.dialect import Dialect, WireMessage

Shipped = Callable[[str], tuple[Dialect, Report]]


def oracle(name: str) -> ModuleType:
    return importlib.import_module(f"pymavlink.dialects.v20.{name}")


def struct_format(message: WireMessage) -> str:
    # pymavlink packs a single char as "c"; an "s" of one byte is the same on the wire.
    codes = []
    for field in message.fields:
        code = "c" if field.type.code == "s" and not field.is_array else field.type.code
        codes.append(f"{field.count if field.is_array and (field.count > 1 or code == 's') else ''}{code}")
    return "<" + "".join(codes)


def test_that_every_shipped_dialect_is_compared() -> None:
    """The list below covers all XML files of the package, so a new one cannot be missed."""
    assert {"all", "ardupilotmega", "common", "minimal", "standard", "storm32", "test"} <= set(
        shipped_dialect_names(DISK)
    )
    assert len(shipped_dialect_names(DISK)) >= 19


@pytest.mark.parametrize("name", shipped_dialect_names(DISK))
def test_every_message_is_laid_out_as_mavgen_lays_it_out(name: str, shipped: Shipped) -> None:
    """Ids, CRC_EXTRA, wire order, types, array lengths, payload length, units, enums and instance fields."""
    dialect, report = shipped(name)
    assert list(report) == []
    theirs = oracle(name).mavlink_map
    assert {message.id: message.name for message in dialect.messages.values()} == {
        number: message.msgname for number, message in theirs.items()
    }
    for message in dialect.messages.values():
        expected = theirs[message.id]
        fields = message.fields
        assert message.crc_extra == expected.crc_extra, message.name
        assert [field.name for field in fields] == expected.ordered_fieldnames, message.name
        assert [field.name for field in message.definition.fields] == expected.fieldnames, message.name
        assert struct_format(message) == expected.unpacker.format, message.name
        assert message.length == expected.unpacker.size, message.name
        assert [f.count if f.is_array else 0 for f in fields] == expected.array_lengths, message.name
        stated = message.definition.fields
        assert {f.name: f.units for f in stated if f.units} == expected.fieldunits_by_name, message.name
        assert {f.name: f.enum for f in stated if f.enum} == expected.fieldenums_by_name, message.name
        instances = [f for f in fields if f.definition.is_instance]
        assert [f.name for f in instances] == ([expected.instance_field] if expected.instance_field else [])
        assert [f.offset for f in instances] == ([expected.instance_offset] if instances else [])


@pytest.mark.parametrize("name", shipped_dialect_names(DISK))
def test_base_length_and_offsets_are_those_of_mavgens_parser(name: str, shipped: Shipped) -> None:
    """The generated Python does not keep the length without extensions, so mavgen's parser of the XML is asked."""
    dialect, _ = shipped(name)
    parsed = [m for file in dialect.files for m in mavparse.MAVXML(file, mavparse.PROTOCOL_2_0).message]
    assert len(parsed) == len(dialect.messages)
    for expected in parsed:
        message = dialect.messages[expected.name]
        assert (message.base_length, message.length) == (expected.wire_min_length, expected.wire_length), message.name
        assert {field.name: field.offset for field in message.fields} == expected.field_offsets, message.name


@pytest.mark.parametrize("name", shipped_dialect_names(DISK))
def test_enums_have_the_entries_of_mavgen(name: str, shipped: Shipped) -> None:
    """Names and values of all entries over all included files; mavgen adds an end marker of its own."""
    dialect, _ = shipped(name)
    theirs = {
        enum: {entry.name: value for value, entry in entries.items() if not entry.name.endswith("_ENUM_END")}
        for enum, entries in oracle(name).enums.items()
    }
    ours = {enum.name: {entry.name: entry.value for entry in enum.entries} for enum in dialect.enums.values()}
    assert ours == theirs


@pytest.mark.parametrize("name", shipped_dialect_names(DISK))
def test_version_is_the_one_that_mavgen_writes_into_heartbeats(name: str, shipped: Shipped) -> None:
    """The HEARTBEAT of a dialect has it: storm32 states version 1, yet sends the 3 of minimal.xml."""
    dialect, _ = shipped(name)
    if "HEARTBEAT" in dialect.messages:
        parameters = inspect.signature(oracle(name).MAVLink.heartbeat_encode).parameters
        assert dialect.version == parameters["mavlink_version"].default


def test_a_dialect_file_of_its_own_has_its_own_version(shipped: Shipped) -> None:
    """test.xml and csAirLink.xml include nothing and have no HEARTBEAT; icarous.xml states no version: mavgen's 2."""
    assert {name: shipped(name)[0].version for name in ("test", "csAirLink", "icarous")} == {
        "test": 3,
        "csAirLink": 3,
        "icarous": 2,
    }
