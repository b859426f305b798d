"""Replies of a link: to old stations, to whoever asks, about what is not here; it rests where nothing is left."""

from program_bench import (
    GOES_OUT,
    OTHER_SYSTEM,
    SECOND_US,
    GroundStation,
    id_of,
    main,
    messages,
    mock_time,
    needs,
    new_craft,
    payload_of,
    run,
    run_passes,
)
from program_facts import ABSENT, COMPONENT_ID, LINKS_US, PARAMETERS, SYSTEM_ID, VERSION

import dialect
import vehicle as vehicle_module
from mavlink import Link
from message import keep
from stand_ins import Thing


def what_a_table_takes_is_told():
    """A table that takes a message tells what is wrong in it, and code that waits for it is called; each for itself."""
    opened, message = vehicle_module.open_link, messages.Ping(unknown=False)

    def open_link(port, known=(), *more, **named):
        return opened(port, [message if each.ID == message.ID else each for each in known], *more, **named)

    vehicle_module.open_link = open_link
    try:
        craft = new_craft()
    finally:
        vehicle_module.open_link = opened
    own, station = craft.connections[0], craft.ground_station()
    for found, has_code, notes in (
        (0, True, []),
        (1, True, ["told", "called"]),
        (2, False, ["told"]),
        (-1, True, ["called"]),
        (-1, False, []),
    ):
        noted = []
        table = Thing(tell=lambda: noted.append("told"), called=None)  # noqa: B023
        if has_code:
            table.called = lambda: noted.append("called")  # noqa: B023
        keep(message, "_take", lambda _now_ms: found)  # noqa: B023
        own.tables[message.ID] = table
        station.send(messages.Ping, target_system=SYSTEM_ID)
        run_passes(craft, 4)
        assert noted == notes, (found, has_code, noted)
        assert own.faults == 0, craft.said()


def _old_craft():
    """Return a vehicle with a link that speaks MAVLink 1, and the station behind it."""
    opened = vehicle_module.open_link
    vehicle_module.open_link = lambda port, known=(), *_more, **_named: Link(port, SYSTEM_ID, COMPONENT_ID, 1, known)
    try:
        craft = new_craft()
    finally:
        vehicle_module.open_link = opened
    assert craft.connections[0].link.version == 1
    return craft, craft.ground_station(1)


def what_the_first_version_cannot_carry_is_left_out():
    """Over MAVLink 1 long texts are cut, refusals without a message there are left out, and the rest is answered."""
    craft, station = _old_craft()
    connection = craft.connections[0]
    for number in GOES_OUT:
        if number > 255:  # a program with such messages has no link of this kind
            connection.streams.set_interval(number, -1)
    run(craft, 2 * SECOND_US, LINKS_US)
    craft.port.frames, connection.faults = [], 0
    craft.texts("warning: " + "0123456789" * 7)
    craft.texts("warning: short")
    run(craft, SECOND_US, LINKS_US)
    found = [(each.severity, each.text) for each in station.received(messages.Statustext)]
    assert found == [(dialect.MAV_SEVERITY_WARNING, "0123456789" * 5), (dialect.MAV_SEVERITY_WARNING, "short")], found
    run(craft, 2 * SECOND_US, LINKS_US)
    frames, craft.port.frames = craft.port.frames, []
    assert [frame[0] for frame in frames] == [0xFE] * len(frames)
    if PARAMETERS:
        station.send(messages.ParamRequestRead, param_id="NO_SUCH", param_index=-1)
        station.send(messages.ParamSet, param_id="NO_SUCH", param_value=1)
        station.send(messages.ParamRequestRead, param_id=PARAMETERS[0]["name"], param_index=-1)
    ask = messages.FileTransferProtocol(unknown=False)
    ask.update(target_system=SYSTEM_ID, target_component=COMPONENT_ID)
    station.link.send(ask)
    station.send(messages.Ping, seq=8, target_system=0, target_component=0)
    run(craft, SECOND_US, LINKS_US)
    kinds = [type(each) for each in station.received(messages.ParamValue, messages.Ping, messages.FileTransferProtocol)]
    assert kinds == ([messages.ParamValue] if PARAMETERS else []) + [messages.Ping], kinds
    assert (connection.faults, connection.lost_replies, connection.link.tx_errors) == (0, 0, 0), craft.said()


def a_link_without_work_rests():
    """A pass in which nothing is left to do says so; one that has more than it may take in says that, too."""
    craft = new_craft()
    own, station = craft.connections[0], craft.ground_station()
    run(craft, SECOND_US, LINKS_US)
    for number in GOES_OUT:
        own.streams.set_interval(number, -1)
    run(craft, SECOND_US, LINKS_US)
    for _ in range(5):
        assert not own.run(mock_time.ticks_ms()), "nothing is left"
        mock_time.advance_us(LINKS_US)
    for _ in range(4 * craft.MESSAGES):
        station.send(messages.Ping, target_system=0, target_component=0)
    assert own.run(mock_time.ticks_ms()), "more has arrived"
    for _ in range(40):
        own.run(mock_time.ticks_ms())
        mock_time.advance_us(LINKS_US)
    assert not own.run(mock_time.ticks_ms())
    assert len(station.received(messages.Ping)) > 0


LIST, COUNT, CLEAR, REQUEST, REQUEST_INT, ACK, LOGS, LOG = 43, 44, 45, 40, 51, 47, 117, 118

ABSENCES = (  # a question with what its payload has at some places, and the same of the answer
    (LIST, {2: 1}, COUNT, {0: 0, 1: 0, 4: 1}),
    (LIST, {2: 255}, COUNT, {0: 0, 1: 0, 4: 255}),
    (COUNT, {0: 0, 1: 0, 4: 2}, ACK, {2: 0, 3: 2}),
    (COUNT, {0: 1, 1: 0, 4: 0}, ACK, {2: 3, 3: 0}),
    (COUNT, {0: 0, 1: 1, 4: 7}, ACK, {2: 3, 3: 7}),
    (COUNT, {0: 255, 1: 255, 4: 1}, ACK, {2: 3, 3: 1}),
    (CLEAR, {2: 3}, ACK, {2: 0, 3: 3}),
    (REQUEST, {4: 2}, ACK, {2: 13, 3: 2}),
    (REQUEST_INT, {4: 1}, ACK, {2: 13, 3: 1}),
    (LOGS, {0: 1, 2: 9}, LOG, dict.fromkeys(range(14), 0)),
)


def absences_say_what_is_true():
    """Lists are empty, take nothing, and have no item; a list that is sent without items is taken. Of the same kind."""
    needs(ABSENT, "questions about what the vehicle does not have")
    needs(VERSION == 2, "messages with kinds of lists")
    import absences  # noqa: PLC0415  as the firmware does

    craft = new_craft()
    station = craft.ground_station()
    run_passes(craft, 20)
    for question, asked, answer, expected in ABSENCES:
        if (question, answer) not in ABSENT:
            continue
        message = absences.Bare(question)
        for place, byte in asked.items():
            message.wire[place] = byte
        for place, target in zip(message.TARGETS, (SYSTEM_ID, COMPONENT_ID)):  # noqa: B905  MicroPython
            message.wire[place] = target
        craft.port.frames = []
        station.link.send(message)
        run_passes(craft, 4)
        found = [frame for frame in craft.port.frames if id_of(frame) == answer]
        assert len(found) == 1, (question, found)
        payload = payload_of(found[0]) + bytes(20)
        assert {place: payload[place] for place in expected} == expected, (question, asked, payload)


def answers_are_for_who_asks():
    """A reply with a target has the ids of who asked, of whatever system and component that is."""
    craft = new_craft()
    run_passes(craft, 20)
    for system, component in ((201, 45), (255, 190), (OTHER_SYSTEM, 1)):
        station = GroundStation(craft.port, VERSION, system, component)
        station.command(410)
        station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, messages.Heartbeat.ID, 1000000)
        station.send(messages.Ping, target_system=0, target_component=0)
        if hasattr(messages, "Timesync"):
            station.send(messages.Timesync, ts1=5)
        if PARAMETERS:
            station.send(messages.ParamRequestRead, param_id="NO_SUCH", param_index=-1)
            station.send(messages.ParamSet, param_id="NO_SUCH", param_value=1)
        run_passes(craft, 12)
        found = [each for each in station.received() if "target_system" in each.names()]
        if VERSION == 1:  # it does not carry the targets of COMMAND_ACK, which are extensions, nor those of TIMESYNC
            found = [each for each in found if isinstance(each, messages.Ping)]
        assert len(found) >= (3 if VERSION == 2 else 1), found
        for each in found:
            assert (each.target_system, each.target_component) == (system, component), each
    assert craft.connections[0].faults == 0, craft.said()


CHECKS = (
    (what_a_table_takes_is_told,),
    (what_the_first_version_cannot_carry_is_left_out, "services.links"),
    (a_link_without_work_rests, "services.links"),
    (absences_say_what_is_true,),
    (answers_are_for_who_asks, "services.links"),
)

if __name__ == "__main__":
    main(CHECKS)
