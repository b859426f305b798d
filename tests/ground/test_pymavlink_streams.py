"""pymavlink counts what the firmware sends by itself, in the rover's time."""

import math
from collections import Counter
from typing import Any

import pytest
from ground_link import GroundLink
from pymavlink.dialects.v20 import common

pytestmark = pytest.mark.timeout(120)


@pytest.mark.requirement("FR-00068.2", "FR-00068.8", "FR-00068.9")
def test_rates_at_the_defaults(start: Any, link: GroundLink) -> None:
    """HEARTBEAT and SYS_STATUS at 1 Hz and BATTERY_STATUS at 2 Hz, over 30 s of the rover's time.

    Wi-Fi is up after the first second, so that the first of each may get lost.
    """
    program = start(link.port, "steady", "--speed", "10", "--duration", "30 s")
    assert program.wait() == 0
    link.take_in(0.2)
    counts = Counter(message.get_type() for message in link.heard)
    assert counts["HEARTBEAT"] in (28, 29, 30, 31)
    assert counts["SYS_STATUS"] in (28, 29, 30, 31)
    assert counts["BATTERY_STATUS"] in (57, 58, 59, 60, 61)
    assert counts["SMART_BATTERY_INFO"] in (1, 2, 3), "on connection, and every 20 s"
    assert set(counts) == {"HEARTBEAT", "SYS_STATUS", "BATTERY_STATUS", "SMART_BATTERY_INFO", "STATUSTEXT"}


@pytest.mark.requirement("FR-00068.8")
def test_real_time_is_real_time(start: Any, link: GroundLink) -> None:
    """Without --speed, the HEARTBEAT is heard about once in a second of the listener's clock."""
    start(link.port, "steady")
    times = [link.wait_for("HEARTBEAT")._timestamp for _ in range(4)]
    assert 2.5 <= times[-1] - times[0] <= 8, "late on a busy computer, never early"


@pytest.mark.requirement("FR-00020.1", "FR-00020.2", "FR-00020.7", "FR-00070.8")
def test_failsafe_is_told(start: Any, link: GroundLink) -> None:
    """Both levels come as STATUSTEXT, in time, and in this order."""
    start(link.port, "failing", "--speed", "20")
    for word, volts, expected_s in (("low", "10.30", 16), ("critical", "9.70", 36)):
        position = link.find("STATUSTEXT", 0, lambda message, word=word: f"is {word}" in message.text)
        text = link.heard[position]
        assert text.text == f"Battery 1 is {word} {volts}V"
        assert text.severity == common.MAV_SEVERITY_WARNING
        seconds = sum(message.get_type() == "HEARTBEAT" for message in link.heard[:position])
        assert math.isclose(seconds, expected_s, abs_tol=2.5)


@pytest.mark.requirement("FR-00068.4", "FR-00068.5", "FR-00068.6", "FR-00068.9", "FR-00077.5", "FR-00077.7")
def test_current_and_charge_are_told(start: Any, link: GroundLink) -> None:
    """12 A of a pack of 100 mAh, for 27 s: 90 mAh are drawn, and every message fits to the others and to itself."""
    program = start(link.port, "drawing", "--speed", "10", "--duration", "27 s")
    assert program.wait() == 0
    link.take_in(0.2)
    told = [message for message in link.heard if message.get_type() == "BATTERY_STATUS"]
    for status in told:
        assert status.current_battery == 1200
        assert status.battery_remaining == 100 - status.current_consumed
        # 12 A are 12.005 A for the converter: of 27 s it may be 26.99.
        assert status.battery_remaining * 3600 // 12000 - status.time_remaining in (0, 1)
        assert abs(status.energy_consumed - status.current_consumed * 12 * 36 / 1000) <= 1
    assert 85 <= told[-1].current_consumed <= 90
    assert told[-1].current_consumed - told[0].current_consumed >= 75
    of_system = [message for message in link.heard if message.get_type() == "SYS_STATUS"]
    assert {message.current_battery for message in of_system} == {1200}
    assert abs(of_system[-1].battery_remaining - told[-1].battery_remaining) <= 4
