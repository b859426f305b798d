"""explain tells the whole story of anything that has a name in the project."""

import re

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
    ("BATT2_LOW_VOLT", ["10.5 V", "of battery 2: the low threshold of the failsafe of battery.voltage"]),
    (
        "BATT2_CAPACITY",
        [
            "of battery 2: what battery.remaining is counted from",
            "SMART_BATTERY_INFO.capacity_full_specification, BATTERY_INFO.design_capacity",
        ],
    ),
    ("BATT_ARM_VOLT", ["the least battery.voltage to arm with"]),
    ("BATT_MONITOR", ["from the next start", "0 Disabled, 3 Analog", "whether battery is measured and reported"]),
    ("BATT_VOLT_PIN", ["26..28", "from the next start", "the pin of the ADC channel battery_voltage"]),
    ("SR0_EXTRA1", ["int16", "the rate of stream EXTRA1"]),
    ("SYSID_THISMAV", ["from the next start", "the system id of the vehicle"]),
    ("battery.voltage", ["GPIO 26 and 27", "1000 ms after the last good one", "SYS_STATUS.voltage_battery"]),
    ("battery", ["battery.voltage", "battery.temperature"]),
    ("EXTRA1", ["SR0_EXTRA1", "BATTERY_STATUS"]),
    ("FR-00068.4", ["BATTERY_STATUS.current_battery", "SYS_STATUS.current_battery"]),
    ("FR-zxxlp", ["FR-00068 | "]),
    ("GPS_RAW_INT", ["no table populates it", "satellites_visible"]),
    ("BATT_REPORT", ["0 Old, 1 New, 2 Both", "which generation of battery messages is sent", "old by default"]),
    ("SMART_BATTERY_INFO", ["sent at once on connection and when battery.swaps changes", "BATT_REPORT: 0 old, 1 new"]),
    ("sentinel-contradiction", ["error", "unknown"]),
    ("crowded-slot", ["warning", "codegen explain loop"]),
    (
        "heap",
        [
            "of it for machine code",
            "Raspberry Pi Pico 2 W (RP2350) has 440 KB",
            "messages that are sent",
            "In the program smart_battery:",
            "Not counted: code of yours",
        ],
    ),
    (
        "loop",
        [
            "main loop on Raspberry Pi Pico 2 W (RP2350): control() is called every 2500 us",
            "battery + links + reminder",
            "battery   battery is read, with its failsafe, every 100 ms",
            "frames, from the state to the port",
            "each further station of a link takes",
            "Not counted: control()",
            "No times: nobody has measured how many cycles the RP2040 takes",
        ],
    ),
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


@pytest.mark.requirement("FR-00072.7")
@pytest.mark.parametrize("topic", ["battery", "BATT_REPORT", "BATTERY_STATUS", "BATTERY_STATUS_V2"])
def test_the_price_of_generations(topic, capsys):
    """Bytes per second of old, new and both: sums of rates and frames, of which each is told, too.

    BATTERY_STATUS of battery 1 is 47 bytes where the charge left, its last base byte, is 0, and up to 63 where it has
    faults, whose lowest byte holds all that are told. SMART_BATTERY_INFO is 109: its manufacturing date is not known,
    and the byte before it is one of a current.
    """
    assert main(["explain", topic]) == 0
    lines = capsys.readouterr().out.partition("In the program ")[0].splitlines()
    rows = {line.split()[0]: re.split(r"  +", line) for line in lines if line}
    assert rows["old"][1] == "99.5 to 131.4"
    assert rows["BATTERY_STATUS"][2:4] == ["2 Hz", "47 to 63"]
    assert rows["SMART_BATTERY_INFO"][2:4] == ["0.05 Hz", "109"]
    old, new, both = ([float(number) for number in rows[name][1].split(" to ")] for name in ("old", "new", "both"))
    assert both == pytest.approx([old[0] + new[0], old[1] + new[1]], abs=0.11)
    assert old == pytest.approx([2 * 47 + 0.05 * 109, 2 * 63 + 0.05 * 109], abs=0.06)
    assert any("without the zeros" in line for line in lines)
