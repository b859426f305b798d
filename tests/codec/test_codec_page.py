"""The page of a codec: its examples are of a field that suits them, and it says what there is and nothing else."""

from typing import Any

import pytest

from codegen.commands.codec import read_codec_dialect
from codegen.diagnostics import Report
from codegen.model.dialect.dialect import Dialect
from codegen.targets.codec.page import page_text


@pytest.fixture(scope="module")
def common() -> Dialect:
    dialect = read_codec_dialect("common", Report())
    assert dialect is not None
    return dialect


def page(dialect: Dialect, *names: str, enums: tuple[str, ...] = ()) -> str:
    """The page about some messages and enums."""
    return page_text("common", [dialect.messages[name] for name in names], [dialect.enums[name] for name in enums])


@pytest.mark.parametrize(
    ("names", "example", "setting", "live"),
    [
        (("HEARTBEAT",), "Heartbeat", 'message.set("custom_mode", 1)', "custom_mode"),
        (("HEARTBEAT", "ATTITUDE"), "Attitude", 'message.set("time_boot_ms", 1)', "time_boot_ms"),
        (("ATTITUDE", "HEARTBEAT"), "Attitude", 'message.set("time_boot_ms", 1)', "time_boot_ms"),
        (("STATUSTEXT", "SYS_STATUS"), "SysStatus", 'message.set("load", 1)', "load"),
        (("AUTH_KEY",), "AuthKey", 'message.set("key", "text")', None),
        (("WHEEL_DISTANCE",), "WheelDistance", 'message.set("time_usec", 1)', "count"),
        (("WIFI_CONFIG_AP",), "WifiConfigAp", 'message.set("ssid", "text")', None),
    ],
)
def test_the_example_is_a_number_with_a_unit_if_there_is_one(
    common: Dialect, names: Any, example: str, setting: str, live: str | None
) -> None:
    """One that is neither a text nor an array; a live one has up to 32 bits."""
    text = page(common, *names)
    assert f"message = {example}()" in text
    assert setting in text
    assert ("live[0] = 1" in text) is (live is not None)
    if live is not None:
        assert f'(live=("{live}",))' in text


def test_what_is_counted(common: Dialect) -> None:
    one, two = page(common, "HEARTBEAT"), page(common, "HEARTBEAT", "SYS_STATUS", enums=("MAV_STATE",))
    assert "\n1 message, made by" in one
    assert "\n2 messages, made by" in two
    assert "`longest=9`" in one
    assert "`longest=43`" in two
    assert "The fields of these messages refer to no enum." in one
    assert "`from enums import MAV_STATE_UNINIT`." in two
    assert "- `MAV_STATE`: 9" in two
    assert "`Heartbeat`, id 0, CRC_EXTRA 50, 9 bytes. The heartbeat" in one
    assert "`SysStatus`, id 1, CRC_EXTRA 124, 31 bytes, 43 with extensions. " in two


def test_rows_of_fields(common: Dialect) -> None:
    """Extensions, units and enums are told where there are any."""
    rows = page(common, "HEARTBEAT", "BATTERY_STATUS").splitlines()
    voltages = next(row for row in rows if row.startswith("| voltages |"))
    assert voltages.startswith(
        "| voltages | uint16[10] | mV |  | 65535 in an element | Battery voltage of cells 1 to 10"
    )
    assert any(row.startswith("| voltages_ext (extension) | uint16[4] | mV |  |  |") for row in rows)
    assert any(row.startswith("| type | uint8 |  | `MAV_TYPE` |  | ") for row in rows)
    assert sum(row.startswith("| ") and "(extension)" in row for row in rows) == 5


def test_doubles_are_explained_where_there_are_some(common: Dialect) -> None:
    assert "## Doubles" not in page(common, "HEARTBEAT", "ATTITUDE")
    assert "## Doubles\n\n`distance` of WHEEL_DISTANCE is a double" in page(common, "HEARTBEAT", "WHEEL_DISTANCE")
