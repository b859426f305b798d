"""Check values of the battery messages: those of the shipped dialects, the RFC's draft and upstream's present state."""

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest

from codegen.decode.dialect_files import decode_dialect_files
from codegen.diagnostics import Report
from codegen.load.shipped import shipped_dialect_path
from codegen.model.dialect import Dialect
from codegen.resolve.dialect import resolve_dialect
from codegen.resolve.wire import crc_mcrf4xx

OVERLAY = Path(__file__).parents[2] / "specs" / "dialects" / "battery_v2.xml"

V2_FIELDS = """
<field type="uint8_t" name="id" instance="true"/>
<field type="int16_t" name="temperature" units="cdegC" invalid="INT16_MAX"/>
<field type="float" name="voltage" units="V" invalid="NaN"/>
<field type="float" name="current" units="A" invalid="NaN"/>
<field type="float" name="capacity_consumed" units="Ah" invalid="NaN"/>
<field type="float" name="capacity_remaining" units="Ah" invalid="NaN"/>
<field type="uint8_t" name="percent_remaining" units="%" invalid="UINT8_MAX"/>
<field type="uint32_t" name="status_flags" display="bitmask"/>
"""

BATTERY_INFO = """
<field type="uint8_t" name="id" instance="true"/>
<field type="uint8_t" name="battery_function"/>
<field type="uint8_t" name="type"/>
<field type="uint8_t" name="state_of_health" units="%" invalid="UINT8_MAX"/>
<field type="uint8_t" name="cells_in_series" invalid="0"/>
<field type="uint16_t" name="cycle_count" invalid="UINT16_MAX"/>
<field type="uint16_t" name="weight" units="g" invalid="0"/>
<field type="float" name="discharge_minimum_voltage" units="V" invalid="0"/>
<field type="float" name="charging_minimum_voltage" units="V" invalid="0"/>
<field type="float" name="resting_minimum_voltage" units="V" invalid="0"/>
<field type="float" name="charging_maximum_voltage" units="V" invalid="0"/>
<field type="float" name="charging_maximum_current" units="A" invalid="0"/>
<field type="float" name="nominal_voltage" units="V" invalid="0"/>
<field type="float" name="discharge_maximum_current" units="A" invalid="0"/>
<field type="float" name="discharge_maximum_burst_current" units="A" invalid="0"/>
<field type="float" name="design_capacity" units="Ah" invalid="0"/>
<field type="float" name="full_charge_capacity" units="Ah" invalid="NaN"/>
<field type="char[9]" name="manufacture_date" invalid="[0]"/>
<field type="char[32]" name="serial_number" invalid="[0]"/>
<field type="char[50]" name="name" invalid="[0]"/>
"""


def message(number: int, name: str, fields: str) -> str:
    return f'<mavlink><messages><message id="{number}" name="{name}">{fields}</message></messages></mavlink>'


@pytest.fixture(scope="module")
def common_with_v2() -> Dialect:
    report = Report()
    path = shipped_dialect_path("common")
    assert path is not None
    files = decode_dialect_files(path, report)
    dialect = resolve_dialect("common", files + decode_dialect_files(str(OVERLAY), report, known=files), (), report)
    assert list(report) == []
    return dialect


@pytest.mark.parametrize(
    ("name", "number", "crc_extra", "base_length", "length"),
    [
        ("SYS_STATUS", 1, 124, 31, 43),
        ("BATTERY_STATUS", 147, 154, 36, 54),
        ("SMART_BATTERY_INFO", 370, 75, 87, 109),
        ("BATTERY_STATUS_V2", 369, 145, 27, 27),
    ],
)
def test_known_messages(
    name: str, number: int, crc_extra: int, base_length: int, length: int, common_with_v2: Dialect
) -> None:
    """The layouts that receivers in the field expect; the overlay's is upstream's of 2026-05."""
    found = common_with_v2.messages[name]
    assert (found.id, found.crc_extra, found.base_length, found.length) == (number, crc_extra, base_length, length)


def test_overlay_has_upstreams_flags(common_with_v2: Dialect) -> None:
    """20 flags, one bit each; EXTENDED is the topmost bit and no longer all of them."""
    flags = common_with_v2.enums["MAV_BATTERY_STATUS_FLAGS"]
    assert flags.is_bitmask
    assert [entry.value for entry in flags.entries] == [*(1 << bit for bit in range(19)), 1 << 31]
    extended = flags.entry("MAV_BATTERY_STATUS_FLAGS_EXTENDED")
    assert extended is not None
    assert extended.value == 2147483648


def test_the_rfcs_draft_of_v2_is_another_message(read: Callable[..., SimpleNamespace]) -> None:
    """percent_remaining in place of state_of_charge: same id, other CRC_EXTRA, so receivers drop it."""
    found = read(message(369, "BATTERY_STATUS_V2", V2_FIELDS))
    assert found.found == []
    draft = found.dialect.messages["BATTERY_STATUS_V2"]
    assert (draft.crc_extra, draft.length) == (151, 24)


def test_battery_info(read: Callable[..., SimpleNamespace]) -> None:
    """BATTERY_INFO as upstream has it: 26, 140 bytes."""
    found = read(message(372, "BATTERY_INFO", BATTERY_INFO))
    assert found.found == []
    info = found.dialect.messages["BATTERY_INFO"]
    assert (info.crc_extra, info.base_length, info.length) == (26, 140, 140)


def test_the_rfcs_cell_voltages_cannot_be_sent(read: Callable[..., SimpleNamespace]) -> None:
    """2 + 2 + 252 bytes are 256, one more than the length byte of a frame can say."""
    fields = (
        '<field type="uint16_t" name="id"/><field type="uint16_t" name="index"/>'
        '<field type="uint16_t[126]" name="voltages"/>'
    )
    found = read(message(371, "BATTERY_CELL_VOLTAGES", fields))
    assert found.found == ["1:20 message-payload"]
    assert "256 bytes" in next(iter(found.report)).message


def test_a_full_payload_is_no_error(read: Callable[..., SimpleNamespace]) -> None:
    """255 bytes is the limit, not beyond it."""
    found = read(message(1, "FULL", '<field type="uint8_t[255]" name="data"/>'))
    assert found.found == []
    assert found.dialect.messages["FULL"].length == 255


def test_crc_check_value() -> None:
    """The check value that catalogues give for CRC-16/MCRF4XX, whole and in two parts."""
    assert crc_mcrf4xx(b"123456789") == 0x6F91
    assert crc_mcrf4xx(b"6789", crc_mcrf4xx(b"12345")) == 0x6F91


@pytest.mark.parametrize(
    ("message_name", "field"),
    [
        ("BATTERY_STATUS", "fault_bitmask"),
        ("SYS_STATUS", "onboard_control_sensors_present"),
        ("SYS_STATUS", "onboard_control_sensors_health_extended"),
        ("HEARTBEAT", "base_mode"),
        ("BATTERY_STATUS_V2", "status_flags"),
    ],
)
def test_fields_with_a_bitmask_enum_are_bitmasks(message_name: str, field: str, common_with_v2: Dialect) -> None:
    """Most of them lack display="bitmask" in the XML, and no correction is needed for that."""
    found = common_with_v2.messages[message_name].field(field)
    assert found is not None
    assert found.definition.is_bitmask


def test_fields_with_another_enum_are_not_bitmasks(common_with_v2: Dialect) -> None:
    """The bitmask comes from the enum of the very field."""
    found = common_with_v2.messages["BATTERY_STATUS"].field("charge_state")
    assert found is not None
    assert not found.definition.is_bitmask
