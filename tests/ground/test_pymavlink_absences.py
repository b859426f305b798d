"""pymavlink asks the running firmware for what it does not have, and for checks and defaults."""

from typing import Any

import pytest
from ground_link import VEHICLE, GroundLink
from pymavlink.dialects.v20 import common

pytestmark = pytest.mark.timeout(120)

KINDS = (common.MAV_MISSION_TYPE_MISSION, common.MAV_MISSION_TYPE_FENCE, common.MAV_MISSION_TYPE_RALLY)


@pytest.fixture(scope="module")
def rover(start_shared: Any, link_shared: GroundLink) -> GroundLink:
    """The link to a simulator at ten times the speed."""
    start_shared(link_shared.port, "steady", "--speed", "10")
    link_shared.wait_for("HEARTBEAT", 0)
    return link_shared


def answer_to(rover: GroundLink, name: str, message: str, *values: Any) -> Any:
    """Return the answer to a message, which goes to the vehicle."""
    position = rover.take_in()
    getattr(rover.send, f"{message}_send")(*VEHICLE, *values)
    return rover.wait_for(name, position)


@pytest.mark.requirement("FR-00070.13")
@pytest.mark.parametrize("kind", KINDS)
def test_lists_are_empty(rover: GroundLink, kind: int) -> None:
    """There is nothing to fetch or to clear, and nothing can be brought; each answer is about that list."""
    count = answer_to(rover, "MISSION_COUNT", "mission_request_list", kind)
    assert (count.count, count.mission_type) == (0, kind)
    assert (count.target_system, count.target_component) == (255, 190)
    for result, message, *values in (
        (common.MAV_MISSION_UNSUPPORTED, "mission_count", 3, kind),
        (common.MAV_MISSION_UNSUPPORTED, "mission_count", 256, kind),
        (common.MAV_MISSION_ACCEPTED, "mission_count", 0, kind),
        (common.MAV_MISSION_ACCEPTED, "mission_clear_all", kind),
        (common.MAV_MISSION_INVALID_SEQUENCE, "mission_request_int", 258, kind),
        (common.MAV_MISSION_INVALID_SEQUENCE, "mission_request", 0, kind),
        (common.MAV_MISSION_UNSUPPORTED, "mission_request_partial_list", 0, -1, kind),
        (common.MAV_MISSION_UNSUPPORTED, "mission_write_partial_list", 0, 3, kind),
    ):
        answer = answer_to(rover, "MISSION_ACK", message, *values)
        assert (answer.type, answer.mission_type) == (result, kind), message
        assert (answer.target_system, answer.target_component) == (255, 190)


@pytest.mark.requirement("FR-00070.13")
def test_there_are_no_logs(rover: GroundLink) -> None:
    """The list is empty."""
    entry = answer_to(rover, "LOG_ENTRY", "log_request_list", 0, 0xFFFF)
    assert (entry.num_logs, entry.last_log_num, entry.id, entry.size) == (0, 0, 0, 0)


@pytest.mark.requirement("FR-00070.13")
def test_there_are_no_modes(rover: GroundLink) -> None:
    """SET_MODE, which has no answer of its own, is answered as a command with its id would be."""
    position = rover.take_in()
    rover.send.set_mode_send(VEHICLE[0], common.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, 4)
    answer = rover.wait_for("COMMAND_ACK", position)
    assert (answer.command, answer.result) == (common.MAVLINK_MSG_ID_SET_MODE, common.MAV_RESULT_UNSUPPORTED)
    assert (answer.target_system, answer.target_component) == (255, 190)


@pytest.mark.requirement("FR-00070.14")
def test_checks_are_run_on_request(rover: GroundLink) -> None:
    """The reasons against arming come at once, though they were said before."""
    rover.set_parameter("BATT_ARM_VOLT", 12.5)
    rover.wait_for("STATUSTEXT", where=lambda text: text.text.startswith("PreArm: Battery 1 below minimum"))
    position = rover.take_in()
    assert rover.command(common.MAV_CMD_RUN_PREARM_CHECKS).result == common.MAV_RESULT_ACCEPTED
    first = rover.find("STATUSTEXT", position, lambda text: text.text.startswith("PreArm: Battery 1 below minimum"))
    assert sum(message.get_type() == "HEARTBEAT" for message in rover.heard[position:first]) <= 2
    rover.set_parameter("BATT_ARM_VOLT", 0)


@pytest.mark.requirement("FR-00070.15")
def test_all_parameters_have_their_defaults_again(rover: GroundLink) -> None:
    """By one command, while the rover is disarmed."""
    assert rover.set_parameter("BATT_LOW_VOLT", 10.8).param_value == pytest.approx(10.8)
    assert rover.set_parameter("SR0_EXTRA3", 4).param_value == 4
    assert rover.command(common.MAV_CMD_COMPONENT_ARM_DISARM, 1).result == common.MAV_RESULT_ACCEPTED
    assert rover.command(common.MAV_CMD_PREFLIGHT_STORAGE, 2).result == common.MAV_RESULT_FAILED
    assert rover.parameter("SR0_EXTRA3").param_value == 4
    assert rover.command(common.MAV_CMD_COMPONENT_ARM_DISARM, 0).result == common.MAV_RESULT_ACCEPTED
    assert rover.command(common.MAV_CMD_PREFLIGHT_STORAGE, 2).result == common.MAV_RESULT_ACCEPTED
    assert rover.parameter("BATT_LOW_VOLT").param_value == 10.5
    assert rover.parameter("SR0_EXTRA3").param_value == 1
