"""Dispatch: who is answered and who is not, pings, streams on request, refused file transfers, heartbeats."""

import struct
from typing import Any

import pymavlink_oracle as oracle
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v10 import common as common_1
from pymavlink.dialects.v20 import common
from service_runs import GROUND, Services, command, command_int, fields, packed

ANSWERS = ("COMMAND_ACK", "PARAM_VALUE", "PARAM_ERROR", "PING", "FILE_TRANSFER_PROTOCOL", "MESSAGE_INTERVAL")
NAK, OPEN_RO, RESET, UNKNOWN_COMMAND = 129, 4, 2, 7


def addressed(target: tuple[int, int]) -> list[Any]:
    """Every message that has a target and an answer."""
    return [
        command(520, 0, target=target),
        command_int(520, 0, target=target),
        common.MAVLink_param_request_list_message(*target),
        common.MAVLink_param_request_read_message(*target, b"", 0),
        common.MAVLink_param_set_message(*target, b"SR0_EXTRA1", 3.0, 4),
        common.MAVLink_request_data_stream_message(*target, 0, 4, 1),
        request_file(target=target),
    ]


def request_file(sequence: int = 3, opcode: int = OPEN_RO, target: tuple[int, int] = (1, 1), session: int = 5) -> Any:
    """A FILE_TRANSFER_PROTOCOL request for the parameters as a file."""
    name = b"@PARAM/param.pck"
    payload = struct.pack("<HBBBBBBI", sequence, session, opcode, len(name), 0, 0, 0, 9) + name
    return common.MAVLink_file_transfer_protocol_message(0, *target, payload.ljust(251, b"\0"))


@pytest.mark.parametrize("target", [(1, 1), (0, 0), (1, 0), (0, 1)])
def test_what_is_addressed_to_the_vehicle_is_answered(services: Services, target: tuple[int, int]) -> None:
    """0 is every system, or every component of this one."""
    for message in addressed(target):
        answer = services.ask(message)
        assert answer.of(*ANSWERS) or answer.state["calls"] == [["request", 0, 4]], message
        assert answer.state["faults"] == 0


@pytest.mark.parametrize("target", [(2, 1), (1, 2), (0, 2), (255, 190), (2, 0)])
def test_what_is_for_others_is_left_alone(services: Services, target: tuple[int, int]) -> None:
    """Other systems, and other components of this one, answer themselves."""
    answer = services.ask(*addressed(target))
    assert answer.of(*ANSWERS) == []
    assert answer.state["calls"] == []
    assert answer.state["received"] == len(addressed(target))


def test_own_messages_are_ignored(services: Services) -> None:
    """A radio that echoes, or a loop of links, must not make the vehicle talk to itself; its other components may."""
    ping = common.MAVLink_ping_message(1, 2, 0, 0)
    echoed = [*addressed((1, 1)), *addressed((0, 0)), ping, HEARTBEAT_OF_GROUND]
    answer = services.run(*[("in", packed(message, source=(1, 1))) for message in echoed])
    assert (answer.of(*ANSWERS), answer.state["calls"], answer.state["ground_station"]) == ([], [], None)
    neighbours = services.run(*[("in", packed(command(520, 0), source=source)) for source in ((1, 2), (2, 1))])
    targets = [fields(ack, "target_system", "target_component") for ack in neighbours.of("COMMAND_ACK")]
    assert targets == [(1, 2), (2, 1)]


HEARTBEAT_OF_GROUND = common.MAVLink_heartbeat_message(6, 8, 0, 0, 4, 3)


def test_ground_station_is_remembered(services: Services) -> None:
    """By its type: another vehicle's HEARTBEAT is none."""
    vehicle = common.MAVLink_heartbeat_message(10, 3, 0, 0, 4, 3)
    assert services.run(("in", packed(vehicle, source=(7, 1)))).state["ground_station"] is None
    assert services.ask(HEARTBEAT_OF_GROUND).state["ground_station"] == list(GROUND)


@pytest.mark.parametrize(("time_us", "number"), [(0, 0), (1, 2), (2**64 - 1, 2**32 - 1), (2**40 + 7, 77)])
def test_ping(services: Services, time_us: int, number: int) -> None:
    """A request is answered to its sender with what it carries; an answer is not answered."""
    answer = services.ask(common.MAVLink_ping_message(time_us, number, 0, 0))
    found = [fields(pong, "time_usec", "seq", "target_system", "target_component") for pong in answer.of("PING")]
    assert found == [(time_us, number, *GROUND)]
    for target in ((1, 1), GROUND, (1, 0), (0, 1)):
        assert services.ask(common.MAVLink_ping_message(time_us, number, *target)).of("PING") == []


def test_data_streams(services: Services) -> None:
    """The requested streams are those of the link; stopping is a rate of 0."""
    asked = [(0, 4, 1), (10, 65535, 1), (10, 4, 0), (255, 0, 1)]
    answer = services.ask(*[common.MAVLink_request_data_stream_message(1, 1, *values) for values in asked])
    assert answer.state["calls"] == [["request", 0, 4], ["request", 10, 65535], ["request", 10, 0], ["request", 255, 0]]


@pytest.mark.parametrize("sequence", [0, 3, 255, 65535])
@pytest.mark.parametrize("opcode", [OPEN_RO, RESET, 0, 127])
def test_file_transfers_are_refused(services: Services, sequence: int, opcode: int) -> None:
    """With the request's opcode and session and the sequence number after it: what it waits for."""
    (refusal,) = services.ask(request_file(sequence, opcode)).of("FILE_TRANSFER_PROTOCOL")
    assert fields(refusal, "target_network", "target_system", "target_component") == (0, *GROUND)
    payload = bytes(refusal.payload)
    expected = struct.pack("<HBBBBBBI", (sequence + 1) & 0xFFFF, 5, NAK, 1, opcode, 0, 0, 0) + bytes([UNKNOWN_COMMAND])
    assert payload == expected.ljust(251, b"\0")


@pytest.mark.parametrize("opcode", [128, 129, 255])
def test_answers_about_files_are_not_answered(services: Services, opcode: int) -> None:
    """Two that refuse each other would never end."""
    assert services.ask(request_file(opcode=opcode)).of("FILE_TRANSFER_PROTOCOL") == []


def test_mavlink_1(services: Services) -> None:
    """Commands, parameters and pings work; who receives MAVLink 1 has no targets in COMMAND_ACK."""
    frames = [command(520, 0), command(400, 1), common.MAVLink_ping_message(5, 6, 0, 0), addressed((1, 1))[2]]
    answer = services.run(*[("in", packed_1(message)) for message in frames], versions=(1,))
    assert answer.state["faults"] == 0
    assert [fields(ack, "command", "result") for ack in answer.of("COMMAND_ACK")] == [(520, 0), (400, 0)]
    assert [fields(pong, "time_usec", "seq") for pong in answer.of("PING")] == [(5, 6)]
    assert len(answer.of("PARAM_VALUE")) == 5
    assert all(message.get_msgbuf()[0] == 0xFE for message in answer.all)


def packed_1(message: Any) -> bytes:
    """The same message of MAVLink 1."""
    kind = common_1.mavlink_map[message.get_msgId()]
    return packed(kind(**{name: getattr(message, name) for name in kind.fieldnames}), version=1)


@settings(max_examples=150)
@given(data=st.lists(st.binary(max_size=300) | st.sampled_from(list(addressed((0, 0)))), max_size=6), cut=st.data())
def test_any_bytes(services: Services, data: list[Any], cut: st.DataObject) -> None:
    """Garbage, cut frames and whole ones in any order: no fault, and a command after a silent line is answered."""
    stream = b"".join(part if isinstance(part, bytes) else packed(part) for part in data)
    at = cut.draw(st.integers(0, len(stream)))
    # The longest frame that garbage can promise is 280 bytes: then the receiver is in step again.
    steps = [("in", stream[at:]), ("passes", 40), ("in", bytes(300)), ("in", packed(command(520, 0)))]
    answer = services.run(*steps)
    assert answer.state["faults"] == 0
    last = answer.of("COMMAND_ACK")[-1]
    assert fields(last, "command", "result") == (520, 0)
    assert answer.state["left"] == 0


@settings(max_examples=80)
@given(kind=st.sampled_from([0, 4, 20, 21, 23, 66, 75, 76, 110]), body=st.binary(max_size=254))
def test_any_payload(services: Services, kind: int, body: bytes) -> None:
    """Every message that is known, with any payload of any length, addressed to all: no fault."""
    message_type = common.mavlink_map[kind]
    wire = bytearray(body[: message_type.unpacker.size].ljust(message_type.unpacker.size, b"\0"))
    for name, (_, offset, _) in oracle.layout(oracle.describe(message_type.msgname)).items():
        if name.startswith("target_"):
            wire[offset] = 0
    frame = oracle.raw_frame(kind, bytes(wire), message_type.crc_extra)
    answer = services.run(("in", frame), ("in", packed(command(520, 0))))
    assert answer.state["received"] == 2
    assert answer.state["faults"] == 0
    assert fields(answer.of("COMMAND_ACK")[-1], "command", "result") == (520, 0)
