"""pymavlink asks the running firmware for everything that a ground station may ask for."""

import random
from typing import Any

import pytest
from ground_link import VEHICLE, GroundLink
from programs import Program
from pymavlink.dialects.v10 import common as old
from pymavlink.dialects.v20 import common

pytestmark = pytest.mark.timeout(120)

PROTOCOL_VERSION = "PROTOCOL_VERSION" if 300 in common.mavlink_map else "UNKNOWN_300"
"""pymavlink's name for message 300, which its dialects may not have."""
STANDARD_RATE = 2.0
"""SR0_EXTRA1, in Hz."""


@pytest.fixture(scope="module")
def running(start_shared: Any, link_shared: GroundLink) -> Program:
    """A simulator at twenty times the speed, which the link hears."""
    program: Program = start_shared(link_shared.port, "steady", "--speed", "20")
    link_shared.wait_for("HEARTBEAT", 0)
    return program


@pytest.fixture
def rover(running: Program, link_shared: GroundLink) -> GroundLink:
    """The link to it, and the rates as they are after a start."""
    assert running.position >= 0
    for message in (common.MAVLINK_MSG_ID_BATTERY_STATUS, common.MAVLINK_MSG_ID_SYS_STATUS):
        link_shared.command(common.MAV_CMD_SET_MESSAGE_INTERVAL, message, 0)
    link_shared.take_in()
    return link_shared


@pytest.mark.requirement("FR-00068.1", "FR-00068.8")
def test_heartbeat_and_battery_say_what_the_pack_is(rover: GroundLink) -> None:
    """A rover with one battery of 12 V, and nothing that it does not measure."""
    heartbeat = rover.wait_for("HEARTBEAT")
    assert (heartbeat.type, heartbeat.autopilot) == (common.MAV_TYPE_GROUND_ROVER, common.MAV_AUTOPILOT_ARDUPILOTMEGA)
    assert (heartbeat.get_srcSystem(), heartbeat.get_srcComponent()) == VEHICLE
    battery = rover.wait_for("BATTERY_STATUS")
    assert battery.voltages == [12_000] + [65535] * 9
    assert (battery.current_battery, battery.battery_remaining, battery.temperature) == (-1, -1, 32767)
    status = rover.wait_for("SYS_STATUS")
    assert (status.voltage_battery, status.battery_remaining) == (12_000, -1)


@pytest.mark.requirement("FR-00070.3", "FR-00068.2")
def test_message_interval_is_set_and_told(rover: GroundLink) -> None:
    """The rate of BATTERY_STATUS is set, and counted; 50 Hz is the end."""
    number = common.MAVLINK_MSG_ID_BATTERY_STATUS
    for asked, told, rate in ((100_000, 100_000, 10), (5_000, 20_000, 50), (-1, -1, 0), (0, 500_000, STANDARD_RATE)):
        assert rover.command(common.MAV_CMD_SET_MESSAGE_INTERVAL, number, asked).result == 0
        position = rover.take_in()
        assert rover.command(common.MAV_CMD_GET_MESSAGE_INTERVAL, number).result == 0
        answer = rover.wait_for("MESSAGE_INTERVAL", position)
        assert (answer.message_id, answer.interval_us) == (number, told)
        assert abs(rover.per_heartbeat("BATTERY_STATUS") - rate) <= 0.2 + rate / 50, asked


@pytest.mark.requirement("FR-00070.3")
def test_interval_of_a_message_that_there_is_not(rover: GroundLink) -> None:
    """It is refused, and told as not available."""
    assert rover.command(common.MAV_CMD_SET_MESSAGE_INTERVAL, 30, 100_000).result == common.MAV_RESULT_DENIED
    position = rover.take_in()
    assert rover.command(common.MAV_CMD_GET_MESSAGE_INTERVAL, 30).result == common.MAV_RESULT_ACCEPTED
    assert rover.wait_for("MESSAGE_INTERVAL", position).interval_us == 0


@pytest.mark.requirement("FR-00070.4")
def test_request_data_stream(rover: GroundLink) -> None:
    """The rate of a stream, on and off, and no other stream changes with it."""
    stream = common.MAV_DATA_STREAM_EXTRA1
    for rate, is_on, expected in ((8, 1, 8.0), (8, 0, 0.0), (2, 1, 2.0)):
        rover.send.request_data_stream_send(*VEHICLE, stream, rate, is_on)
        rover.wait_for("HEARTBEAT")
        assert abs(rover.per_heartbeat("BATTERY_STATUS") - expected) <= 0.2
        assert abs(rover.per_heartbeat("SYS_STATUS") - 1.0) <= 0.2


@pytest.mark.parametrize(
    ("number", "name"),
    [
        (148, "AUTOPILOT_VERSION"),
        (300, PROTOCOL_VERSION),
        (147, "BATTERY_STATUS"),
        (1, "SYS_STATUS"),
        (242, None),
    ],
)
@pytest.mark.requirement("FR-00070.2")
def test_request_message(rover: GroundLink, number: int, name: str | None) -> None:
    """COMMAND_ACK first, then the message; what the rover does not have is denied."""
    for streamed in (common.MAVLINK_MSG_ID_BATTERY_STATUS, common.MAVLINK_MSG_ID_SYS_STATUS):
        rover.command(common.MAV_CMD_SET_MESSAGE_INTERVAL, streamed, -1)
    rover.wait_for("HEARTBEAT")
    position = rover.take_in()
    answer = rover.command(common.MAV_CMD_REQUEST_MESSAGE, number)
    assert answer.result == (common.MAV_RESULT_DENIED if name is None else common.MAV_RESULT_ACCEPTED)
    if name is not None:
        assert rover.find("COMMAND_ACK", position) < rover.find(name, position)


@pytest.mark.parametrize(
    ("command", "name"),
    [
        (common.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, "AUTOPILOT_VERSION"),
        (common.MAV_CMD_REQUEST_PROTOCOL_VERSION, PROTOCOL_VERSION),
    ],
)
@pytest.mark.requirement("FR-00070.2")
def test_older_ways_to_ask(rover: GroundLink, command: int, name: str) -> None:
    """Ground stations still use the commands that came before REQUEST_MESSAGE."""
    position = rover.take_in()
    assert rover.command(command, 1).result == common.MAV_RESULT_ACCEPTED
    rover.wait_for(name, position)


@pytest.mark.requirement("FR-00070.1")
@pytest.mark.parametrize("command", [common.MAV_CMD_GET_HOME_POSITION, common.MAV_CMD_NAV_TAKEOFF, 31_999])
def test_unknown_command(rover: GroundLink, command: int) -> None:
    """Silence would make a ground station repeat it."""
    assert rover.command(command).result == common.MAV_RESULT_UNSUPPORTED


@pytest.mark.requirement("FR-00070.1")
def test_command_int(rover: GroundLink) -> None:
    """COMMAND_INT is answered as COMMAND_LONG is."""
    position = rover.take_in()
    number = common.MAV_CMD_REQUEST_MESSAGE
    rover.send.command_int_send(*VEHICLE, 0, number, 0, 0, common.MAVLINK_MSG_ID_AUTOPILOT_VERSION, 0, 0, 0, 0, 0, 0)
    assert rover.wait_for("COMMAND_ACK", position).result == common.MAV_RESULT_ACCEPTED
    rover.wait_for("AUTOPILOT_VERSION", position)


@pytest.mark.requirement("FR-00070.1")
def test_a_command_for_somebody_else(rover: GroundLink) -> None:
    """Nothing that is for another system is answered."""
    position = rover.take_in()
    rover.send.command_long_send(77, 1, common.MAV_CMD_REQUEST_MESSAGE, 0, 148, 0, 0, 0, 0, 0, 0)
    rover.command(common.MAV_CMD_GET_HOME_POSITION)
    assert [answer.command for answer in rover.since(position, "COMMAND_ACK")] == [common.MAV_CMD_GET_HOME_POSITION]


@pytest.mark.requirement("FR-00070.7")
def test_ping(rover: GroundLink) -> None:
    """With the same time and number, to the one who asked."""
    position = rover.take_in()
    rover.send.ping_send(123_456_789_012, 42, 0, 0)
    answer = rover.wait_for("PING", position)
    assert (answer.time_usec, answer.seq) == (123_456_789_012, 42)
    assert (answer.target_system, answer.target_component) == (255, 190)


@pytest.mark.requirement("NFR-00061.6")
def test_all_parameters(rover: GroundLink) -> None:
    """The whole list, numbered without gaps, and each of them by name and by number."""
    position = rover.take_in()
    rover.send.param_request_list_send(*VEHICLE)
    first = rover.wait_for("PARAM_VALUE", position)
    rover.wait_for("PARAM_VALUE", position, lambda value: value.param_index == first.param_count - 1)
    values = rover.since(position, "PARAM_VALUE")
    assert [value.param_index for value in values] == list(range(39))
    names = [value.param_id for value in values]
    assert names == sorted(names)
    for value in values:
        assert rover.parameter(value.param_id).param_value == value.param_value
        position = rover.take_in()
        rover.send.param_request_read_send(*VEHICLE, b"", value.param_index)
        assert rover.wait_for("PARAM_VALUE", position).param_id == value.param_id


@pytest.mark.requirement("NFR-00061.5")
def test_parameters_that_are_refused(rover: GroundLink) -> None:
    """The answer carries the value in force."""
    answer = rover.set_parameter("BATT_LOW_VOLT", 10.8)
    assert answer.param_value == pytest.approx(10.8)
    assert answer.param_index == 65535  # it is not part of a list
    for value in (1000.0, -1.0, float("nan")):
        assert rover.set_parameter("BATT_LOW_VOLT", value).param_value == pytest.approx(10.8)
    assert rover.set_parameter("BATT_LOW_VOLT", 10.5).param_value == 10.5
    assert rover.set_parameter("BATT_MONITOR", 1).param_value == 3


@pytest.mark.requirement("FR-00070.9")
def test_garbage_does_not_hurt(rover: GroundLink) -> None:
    """Noise, cut frames and false starts are survived, and the frame behind them is understood."""
    dice = random.Random(70)
    ping = common.MAVLink(None, srcSystem=255, srcComponent=190)
    frame = ping.ping_encode(7, 7, 0, 0).pack(ping)
    for length in (1, 2, 11, 12, 48, 263, 280, 1400, 9000):
        rover.write(dice.randbytes(length))
        rover.write(frame[: dice.randrange(1, len(frame))])
        rover.write(b"\xfd\xff\x00\x00\x01\xff\xbe\x04\x00\x00")
        broken = bytearray(frame)
        broken[dice.randrange(10, len(frame))] ^= 1 << dice.randrange(8)
        rover.write(bytes(broken))
    position = rover.take_in()
    for number in range(
        20
    ):  # the false starts above announce 255 bytes each, which have to come before they are seen through
        rover.send.ping_send(8, 100 + number, 0, 0)
    assert rover.wait_for("PING", position).time_usec == 8
    assert {answer.time_usec for answer in rover.since(position, "PING")} == {8}
    assert rover.wait_for("BATTERY_STATUS").voltages[0] == 12_000


@pytest.mark.requirement("FR-00068.10", "FR-00070.1")
def test_frames_of_mavlink_1_are_answered(rover: GroundLink) -> None:
    """A ground station that speaks MAVLink 1 gets its answers."""
    speaker = old.MAVLink(None, srcSystem=255, srcComponent=190)
    position = rover.take_in()
    rover.write(speaker.command_long_encode(*VEHICLE, 410, 0, 0, 0, 0, 0, 0, 0, 0).pack(speaker))
    assert rover.wait_for("COMMAND_ACK", position).result == common.MAV_RESULT_UNSUPPORTED
    rover.write(speaker.param_request_read_encode(*VEHICLE, b"BATT_VOLT_MULT", -1).pack(speaker))
    assert rover.wait_for("PARAM_VALUE", position).param_value == pytest.approx(3.95)
    rover.write(speaker.ping_encode(5, 6, 0, 0).pack(speaker))
    assert rover.wait_for("PING", position).seq == 6


@pytest.mark.requirement("FR-00070.5")
def test_arming(rover: GroundLink) -> None:
    """Armed and disarmed, and the HEARTBEAT shows it."""
    for wanted, flag in ((1, common.MAV_MODE_FLAG_SAFETY_ARMED), (0, 0)):
        assert rover.command(common.MAV_CMD_COMPONENT_ARM_DISARM, wanted).result == common.MAV_RESULT_ACCEPTED
        heartbeat = rover.wait_for("HEARTBEAT")
        assert heartbeat.base_mode & common.MAV_MODE_FLAG_SAFETY_ARMED == flag
    assert rover.command(common.MAV_CMD_COMPONENT_ARM_DISARM, 2).result == common.MAV_RESULT_DENIED
