"""Every command gets one COMMAND_ACK with the result that the dialect defines, and what it asks for comes after it."""

import math
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common
from service_runs import GROUND, Answer, Services, command, command_int, fields

OK, DENIED, UNSUPPORTED, FAILED = 0, 2, 3, 4
REQUEST, SET, GET = 512, 511, 510
ARM, REBOOT, CAPABILITIES, PROTOCOL = 400, 246, 520, 519
FORCE_ARM, FORCE_REBOOT = 21196, 20190226


def results(answer: Answer) -> list[tuple[int, int]]:
    """(command, result) of each COMMAND_ACK; all are addressed to who asked."""
    acks = answer.of("COMMAND_ACK")
    assert all(fields(ack, "target_system", "target_component") == GROUND for ack in acks)
    return [fields(ack, "command", "result") for ack in acks]


def ask(services: Services, *messages: Any, **vehicle: Any) -> Answer:
    """Ask after the first HEARTBEAT, which so is not among the answers."""
    steps = [("passes", 1), ("vehicle", vehicle)] + [("in", m.pack(common.MAVLink(None, *GROUND))) for m in messages]
    answer = services.run(*[(what, bytes(arg) if what == "in" else arg) for what, arg in steps])
    answer.replies[0] = [[]]
    assert answer.state["faults"] == 0
    return answer


@pytest.mark.parametrize("make", [command, command_int])
@pytest.mark.parametrize(
    ("number", "params", "result"),
    [
        (REQUEST, (147,), OK),
        (REQUEST, (242,), DENIED),
        (REQUEST, (147.5,), DENIED),
        (REQUEST, (-1,), DENIED),
        (REQUEST, (math.nan,), DENIED),
        (REQUEST, (math.inf,), DENIED),
        (REQUEST, (147, 1), OK),
        (REQUEST, (147, math.nan), OK),
        (REQUEST, (147, 2), DENIED),
        (REQUEST, (147, 0.5), DENIED),
        (SET, (147, 200000), OK),
        (SET, (147, -1), OK),
        (SET, (147, 0), OK),
        (SET, (147, -2), DENIED),
        (SET, (147, math.nan), DENIED),
        (SET, (147, -math.inf), DENIED),
        (SET, (147, 3e38), DENIED),
        (SET, (242, 200000), DENIED),
        (GET, (147,), OK),
        (GET, (70000,), DENIED),
        (CAPABILITIES, (1,), OK),
        (CAPABILITIES, (0,), OK),
        (CAPABILITIES, (2,), DENIED),
        (PROTOCOL, (1,), OK),
        (PROTOCOL, (math.nan,), DENIED),
        (ARM, (1,), OK),
        (ARM, (0,), OK),
        (ARM, (0.5,), DENIED),
        (ARM, (math.nan,), DENIED),
        (ARM, (2, FORCE_ARM), DENIED),
        (REBOOT, (0,), OK),
        (REBOOT, (1,), OK),
        (REBOOT, (2,), UNSUPPORTED),
        (REBOOT, (3,), UNSUPPORTED),
        (REBOOT, (math.nan,), DENIED),
        (410, (0,), UNSUPPORTED),
        (0, (), UNSUPPORTED),
        (65535, (math.nan,) * 4, UNSUPPORTED),
    ],
)
def test_result(services: Services, make: Any, number: int, params: tuple[float, ...], result: int) -> None:
    """Both forms of a command have the same result."""
    assert results(ask(services, make(number, *params))) == [(number, result)]


@pytest.mark.parametrize(
    ("number", "params", "following"),
    [
        (REQUEST, (147,), ["BATTERY_STATUS", "BATTERY_STATUS"]),
        (REQUEST, (147, 1), ["BATTERY_STATUS"]),
        (REQUEST, (147, math.nan), ["BATTERY_STATUS", "BATTERY_STATUS"]),
        (REQUEST, (148,), ["AUTOPILOT_VERSION"]),
        (REQUEST, (244, 147), ["MESSAGE_INTERVAL"]),
        (REQUEST, (242,), []),
        (CAPABILITIES, (1,), ["AUTOPILOT_VERSION"]),
        (CAPABILITIES, (0,), []),
        (GET, (147,), ["MESSAGE_INTERVAL"]),
        (REQUEST, (300,), ["UNKNOWN_300"]),
        (PROTOCOL, (1,), ["UNKNOWN_300"]),
        (PROTOCOL, (0,), []),
    ],
)
def test_what_is_asked_for_follows_the_acknowledgement(
    services: Services, number: int, params: tuple[float, ...], following: list[str]
) -> None:
    """A ground station that waits for the COMMAND_ACK first would miss a message before it."""
    names = [message.get_type() for message in ask(services, command(number, *params)).all]
    assert names == ["COMMAND_ACK", *following]


def test_intervals(services: Services) -> None:
    """The interval that was set is told by GET_MESSAGE_INTERVAL and by MESSAGE_INTERVAL; 0 for unknown messages."""
    asked = [command(GET, 147), command(SET, 147, 200000), command(GET, 147), command(SET, 147, -1)]
    asked += [command(REQUEST, 244, 147), command(SET, 147, 0), command(REQUEST, 244, 147), command(GET, 242)]
    answer = ask(services, *asked)
    found = [fields(message, "message_id", "interval_us") for message in answer.of("MESSAGE_INTERVAL")]
    assert found == [(147, 500000), (147, 200000), (147, -1), (147, 500000), (242, 0)]
    assert [result for _, result in results(answer)] == [OK] * 8


@pytest.mark.parametrize("asking", [(GET, 24), (REQUEST, 244, 24)])
def test_an_interval_beyond_the_field_is_its_largest(services: Services, asking: tuple[int, ...]) -> None:
    """Of a message that is sent once a day there is no room for the microseconds, and below 0 it would not be sent."""
    answer = ask(services, command(*asking))
    assert [message.interval_us for message in answer.of("MESSAGE_INTERVAL")] == [2147483647]
    assert [result for _, result in results(answer)] == [OK]


@pytest.mark.parametrize(
    ("asked_us", "result"), [(2.0**30 - 64, OK), (2.0**30, DENIED), (2.5e9, DENIED), (-2.0, DENIED)]
)
def test_an_interval_that_is_not_counted_is_denied(services: Services, asked_us: float, result: int) -> None:
    """Up to 18 minutes can be asked for; what is longer is not shortened, and changes nothing."""
    answer = ask(services, command(SET, 147, asked_us), command(GET, 147))
    assert [each for _, each in results(answer)] == [result, OK]
    assert [message.interval_us for message in answer.of("MESSAGE_INTERVAL")] == [asked_us if result == OK else 500000]


def test_arming(services: Services) -> None:
    """Forced or not; a refusal fails and says why."""
    problem = "PreArm: Battery 1 unhealthy"
    answer = ask(services, command(ARM, 1), problem=problem)
    assert results(answer) == [(ARM, FAILED)]
    assert [fields(text, "severity", "text") for text in answer.of("STATUSTEXT")] == [(3, problem)]
    assert answer.state["calls"] == [["arm", False]]
    assert not answer.state["is_armed"]
    answer = ask(services, command(ARM, 1, FORCE_ARM), problem=problem)
    assert results(answer) == [(ARM, OK)]
    assert answer.state["calls"] == [["arm", True]]
    assert answer.state["is_armed"]
    answer = ask(services, command(ARM, 1), command(ARM, 0, 21195), command(ARM, 0, FORCE_ARM))
    assert answer.state["calls"] == [["arm", False], ["disarm", False], ["disarm", True]]


def test_reboot(services: Services) -> None:
    """Only while disarmed, unless it is forced: then the vehicle is disarmed before."""
    answer = ask(services, command(REBOOT, 1))
    assert answer.state["calls"] == [["reboot"]]
    answer = ask(services, command(REBOOT, 1), is_armed=True)
    assert results(answer) == [(REBOOT, FAILED)]
    assert answer.state["calls"] == []
    assert [text.text for text in answer.of("STATUSTEXT")] == ["Reboot: disarm first"]
    answer = ask(services, command(REBOOT, 1, 0, 0, 0, 0, FORCE_REBOOT), is_armed=True)
    assert results(answer) == [(REBOOT, OK)]
    assert answer.state["calls"] == [["disarm", True], ["reboot"]]
    answer = ask(services, command(REBOOT, 1), problem="parameters cannot be saved")
    assert results(answer) == [(REBOOT, FAILED)]
    assert [text.text for text in answer.of("STATUSTEXT")] == ["parameters cannot be saved"]
    for action in (0, 2):
        assert ask(services, command(REBOOT, action)).state["calls"] == []


def test_fault_of_the_vehicle_is_acknowledged_as_failure(services: Services) -> None:
    """An exception of the user's code stops neither the vehicle nor the protocol."""
    steps = [("vehicle", {"is_broken": True}), ("in", bytes(command(ARM, 1).pack(common.MAVLink(None, *GROUND))))]
    answer = services.run(*steps, ("in", bytes(command(CAPABILITIES, 0).pack(common.MAVLink(None, *GROUND)))))
    assert results(answer) == [(ARM, FAILED), (CAPABILITIES, OK)]
    assert answer.state["faults"] == 1
    assert ["OSError" in text.text for text in answer.of("STATUSTEXT")] == [True]


ANY_FLOAT = st.floats(width=32) | st.sampled_from([0.0, 1.0, -1.0, 147.0, 16777216.0, -2147483648.0, 2147483648.0])
NUMBERS = st.sampled_from([REQUEST, SET, GET, ARM, REBOOT, CAPABILITIES, PROTOCOL]) | st.integers(0, 65535)


@settings(max_examples=80)
@given(number=NUMBERS, params=st.lists(ANY_FLOAT, min_size=7, max_size=7), x=st.integers(-(2**31), 2**31 - 1))
def test_any_parameters_get_one_acknowledgement(services: Services, number: int, params: list[float], x: int) -> None:
    """Whatever the parameters are: one COMMAND_ACK for each command, no exception, and the next one is answered."""
    in_long = command(number, *params)
    in_int = command_int(number, *params[:4], x, -x - 1, params[6])
    answer = ask(services, in_long, in_int, command(CAPABILITIES, 0))
    assert [number for number, _ in results(answer)] == [number, number, CAPABILITIES]
    assert results(answer)[-1] == (CAPABILITIES, OK)
