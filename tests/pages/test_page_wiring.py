"""The drawing of the wiring: pins, resistors that give the multiplier, what is off, and no drawing of nothing."""

import shutil
from fractions import Fraction
from pathlib import Path

import pytest
from lxml import etree
from rendered import PROJECTS, Program, programs_of

from codegen.model.quantities.divider import E24, divider, ohms

SENSORS = Path(__file__).resolve().parents[1] / "projects" / "sensors" / "specs"


def texts(program: Program) -> list[str]:
    drawing = etree.fromstring(program.documents[f"{program.folder}docs/wiring.svg"].encode())
    return [text.text for text in drawing.iter("{*}text")]


def rows(program: Program) -> list[list[str]]:
    """Return the table of pins."""
    found = program.page("wiring.html").xpath("//section[@id='pins']//tbody/tr")
    return [[cell.text_content() for cell in row] for row in found]


def test_the_rover(shipped: list[Program]) -> None:
    """Dividers before what is measured in volts, none before a sensor of currents, and what the defaults switch off."""
    volts = ["up to 12.6 V, shown up to 13.04 V", "15 kΩ over 5.1 kΩ"]
    sensor = ["its output, up to 3.3 V", ""]
    first, second = "off by the default of BATT_MONITOR", "off by the default of BATT2_MONITOR"
    assert rows(shipped[0]) == [
        ["26", "pin 31", "voltage of battery 1", *volts, "BATT_VOLT_PIN", "FR-00066.1"],
        ["27", "pin 32", "voltage of battery 2", *volts, f"BATT2_VOLT_PIN, {second}", "FR-00066.1"],
        ["28", "pin 34", "current of battery 1", *sensor, f"BATT_CURR_PIN, {first}", "FR-00077.1"],
        ["28", "pin 34", "current of battery 2", *sensor, f"BATT2_CURR_PIN, {second}", "FR-00077.1"],
    ]
    drawn = texts(shipped[0])
    assert drawn[:3] == ["Raspberry Pi Pico 2 W", "GPIO 26", "pin 31"]
    assert {"15 kΩ", "5.1 kΩ", "\u00d7 3.94", "voltage of battery 1"} <= set(drawn)


def test_buses_and_serial_lines() -> None:
    """The table has the other end of each wire: RX for tx, all devices of a bus at once."""
    (program,) = programs_of(SENSORS)
    assert [row[:4] for row in rows(program)] == [
        ["4", "pin 6", "SDA of I2C 0", "power, solar, needle"],
        ["5", "pin 7", "SCL of I2C 0", "power, solar, needle"],
        ["8", "pin 11", "RX of receiver", ""],
        ["9", "pin 12", "TX of receiver", ""],
        ["15", "pin 20", "log", ""],
    ]
    assert "pulled up" in program.page("wiring.html").text_content()


def test_what_a_board_does_not_name_is_left_out(tmp_path: Path) -> None:
    """Without a known board, or without anything at a pin, there is neither page nor link."""
    shutil.copytree(PROJECTS["minimal"], tmp_path / "specs")
    (program,) = programs_of(tmp_path / "specs")
    assert not [path for path in program.documents if "wiring" in path]
    assert not program.page("index.html").xpath("//a[contains(@href, 'wiring')]")


@pytest.mark.parametrize("ratio", ["1.01", "1.5", "2", "3.95", "5.0909", "11", "100"])
def test_a_divider_is_as_near_as_any(ratio: str) -> None:
    """Of all pairs that are sold, in the decades that suit a converter."""
    wanted = Fraction(ratio)
    found = divider(wanted)
    assert found is not None
    lower = [each * power for each in E24 for power in (100, 1000) if 5100 <= each * power <= 16000]
    upper = [each * 10**power for each in E24 for power in range(1, 6)]
    least = min(abs(Fraction(one + other, other) - wanted) for one in upper for other in lower)
    assert abs(found.ratio - wanted) == least


def test_no_divider_where_none_is_needed() -> None:
    assert [divider(Fraction(ratio)) for ratio in ("0.5", "1", "100000")] == [None, None, None]
    assert [ohms(value) for value in (910, 5100, 47000, 1_500_000)] == ["910 Ω", "5.1 kΩ", "47 kΩ", "1.5 MΩ"]
