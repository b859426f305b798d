"""Check values of the battery messages: those of the shipped dialects, the RFC's draft and upstream's present state."""

from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import pytest
from overlay_codec import overlaid

from codegen.decode.dialect.files import decode_dialect_files
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_path
from codegen.model.dialect.dialect import Dialect
from codegen.resolve.dialect.dialect import resolve_dialect
from codegen.resolve.dialect.wire import crc_mcrf4xx

DIALECTS = Path(__file__).parents[2] / "specs" / "dialects"


def message(number: int, name: str, fields: str) -> str:
    return f'<mavlink><messages><message id="{number}" name="{name}">{fields}</message></messages></mavlink>'


@pytest.fixture(scope="module")
def common_with_v2() -> Dialect:
    report = Report()
    path = shipped_dialect_path("common", DISK)
    assert path is not None
    files = decode_dialect_files(path, DISK, report)
    for name in ("battery_upstream.xml", "battery_info_upstream.xml"):
        files += decode_dialect_files(str(DIALECTS / name), DISK, report, known=files)
    dialect = resolve_dialect("common", files, (), report)
    assert list(report) == []
    return dialect


@pytest.mark.parametrize(
    ("name", "number", "crc_extra", "base_length", "length"),
    [
        ("SYS_STATUS", 1, 124, 31, 43),
        ("BATTERY_STATUS", 147, 154, 36, 54),
        ("SMART_BATTERY_INFO", 370, 75, 87, 109),
        ("BATTERY_STATUS_V2", 369, 145, 27, 27),
        ("BATTERY_INFO", 372, 26, 140, 140),
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


def test_the_rfcs_draft_of_v2_is_another_message() -> None:
    """percent_remaining in place of state_of_charge: same id, other CRC_EXTRA, so receivers drop it."""
    dialect, found = overlaid("battery_rfc_0018.xml", is_corrected=False)
    draft = dialect.messages["BATTERY_STATUS_V2"]
    assert (draft.id, draft.crc_extra, draft.length, found) == (369, 151, 24, [])
    extended = dialect.enums["MAV_BATTERY_STATUS_FLAGS"].entry("MAV_BATTERY_STATUS_FLAGS_EXTENDED")
    assert extended is not None
    assert extended.value == 0xFFFFFFFF


def test_the_rfcs_cell_voltages_cannot_be_sent() -> None:
    """2 + 2 + 252 bytes are 256, one more than the length byte of a frame can say."""
    dialect, found = overlaid("battery_cell_voltages_rfc_0018.xml", is_corrected=False)
    drafted = dialect.messages["BATTERY_CELL_VOLTAGES"]
    assert (drafted.id, drafted.length, found) == (371, 256, ["message-payload"])


def test_the_rfcs_cell_voltages_repaired() -> None:
    """The voltages are last on the wire, so that the zeros of missing cells are cut; the text says 12, too."""
    dialect, found = overlaid("battery_cell_voltages_rfc_0018.xml", is_corrected=True)
    repaired = dialect.messages["BATTERY_CELL_VOLTAGES"]
    assert found == []
    assert [(field.name, field.count) for field in repaired.fields] == [("id", 1), ("index", 1), ("voltages", 12)]
    assert "126" not in repaired.definition.description


def test_the_rfcs_cell_faults_lack_an_id() -> None:
    """A draft without a number is left out until a correction gives it one."""
    dialect, found = overlaid("battery_cell_faults_rfc_0018.xml", is_corrected=False)
    assert ("BATTERY_CELL_VOLTAGES" in dialect.messages, found) == (False, ["message-id"])
    dialect, found = overlaid("battery_cell_faults_rfc_0018.xml", is_corrected=True)
    assert (dialect.messages["BATTERY_CELL_VOLTAGES"].length, found) == (10, [])


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
