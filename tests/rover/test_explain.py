"""explain tells the whole story of anything that has a name in the project."""

import pytest

from codegen.cli import main

STORIES = [
    ("BATTERY_STATUS", ["CRC_EXTRA 154", "-32768..32767, -1 -> -2", "battery_status.yaml:12", "[UINT16_MAX]"]),
    ("battery_status.voltages", ["offset       10, 20 bytes", "spills above 65534", "FR-00068.3: "]),
    ("BATT_VOLT_MULT", ["1..10", "0.0001; kept as 10000..100000 steps", "the multiplier of battery.voltage"]),
    (
        "BATT_FS_LOW_ACT",
        ["int8", "0 None, 1 RTL, 2 Hold", "at once", "the low action of the failsafe of battery.voltage"],
    ),
    ("BATT_CRT_VOLT", ["real32", "the critical threshold of the failsafe of battery.voltage"]),
    ("BATT_LOW_TIMER", ["0..120 s", "the delay of the failsafe of battery.voltage"]),
    ("BATT_ARM_VOLT", ["the least battery.voltage to arm with"]),
    ("BATT_MONITOR", ["from the next start", "0 Disabled, 3 Analog", "whether battery is measured and reported"]),
    ("BATT_VOLT_PIN", ["26..28", "from the next start", "the pin of the ADC channel battery_voltage"]),
    ("SR0_EXTRA1", ["int16", "the rate of stream EXTRA1"]),
    ("SYSID_THISMAV", ["from the next start", "the system id of the vehicle"]),
    ("battery.voltage", ["GPIO 26", "1000 ms after the last good one", "SYS_STATUS.voltage_battery"]),
    ("battery", ["battery.voltage", "battery.temperature"]),
    ("EXTRA1", ["SR0_EXTRA1", "BATTERY_STATUS"]),
    ("FR-00068.4", ["BATTERY_STATUS.current_battery", "SYS_STATUS.current_battery"]),
    ("FR-zxxlp", ["FR-00068 | "]),
    ("GPS_RAW_INT", ["no table populates it", "satellites_visible"]),
    ("sentinel-contradiction", ["error", "unknown"]),
]


@pytest.mark.parametrize(("topic", "words"), STORIES, ids=[story[0] for story in STORIES])
def test_story(topic, words, capsys):
    """Exit code 0, and everything that a reader looks for."""
    assert main(["explain", topic]) == 0
    told = capsys.readouterr().out
    for word in words:
        assert word in told, told


@pytest.mark.parametrize(("topic", "hint"), [("BATERY_STATUS", "BATTERY_STATUS"), ("FR-00068.99", "FR-00068")])
def test_nothing_is_called_so(topic, hint, capsys):
    """Exit code 2, and what may have been meant."""
    assert main(["explain", topic]) == 2
    assert hint in capsys.readouterr().out
