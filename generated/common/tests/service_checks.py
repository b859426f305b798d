# Generated from templates/tests/program/service_checks.py: do not edit.
# Inputs: eea6aeebed10bd58
"""Checks of the services: messages of ground stations, and the answers of the whole vehicle."""

from program_bench import (
    OTHER_COMPONENT,
    OTHER_SYSTEM,
    SECOND_US,
    SETTABLE,
    TURN_US,
    Flash,
    GroundStation,
    Port,
    id_of,
    main,
    messages,
    needs,
    needs_arming,
    new_craft,
    payload_of,
    quieted,
    ready_craft,
    run,
    run_passes,
    run_turns,
)
from program_facts import (
    ABSENT,
    ANSWERED,
    COMPONENT_ID,
    CONTROL_US,
    FILES,
    FORCE_ARM,
    LINKS_US,
    MESSAGES,
    ON_REQUEST,
    PARAMETERS,
    SENT,
    SYSTEM_ID,
    TOLD_ARMED,
    VERSION,
)
from texts import Texts

import dialect

ACCEPTED = dialect.MAV_RESULT_ACCEPTED
DENIED = dialect.MAV_RESULT_DENIED
FAILED = dialect.MAV_RESULT_FAILED
UNSUPPORTED = dialect.MAV_RESULT_UNSUPPORTED
ARMED = 0x80  # MAV_MODE_FLAG_SAFETY_ARMED
KNOWN = (
    dialect.MAV_CMD_REQUEST_MESSAGE,
    dialect.MAV_CMD_SET_MESSAGE_INTERVAL,
    dialect.MAV_CMD_GET_MESSAGE_INTERVAL,
    dialect.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES,
    dialect.MAV_CMD_REQUEST_PROTOCOL_VERSION,
    dialect.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN,
)
UNKNOWN = tuple(number for number in (0, 16, 22, 176, 410, 521, 2000, 31010, 65535) if number not in ANSWERED)
ARMING = (dialect.MAV_CMD_COMPONENT_ARM_DISARM,)
if FORCE_ARM is None:
    UNKNOWN += ARMING
else:
    KNOWN = ARMING + KNOWN


def _met():
    """Return a vehicle that has run for a second, and its ground station."""
    craft = ready_craft()
    run(craft, SECOND_US)
    station = craft.ground_station()
    station.received()
    return craft, station


def _result(craft, station, number, *params, **values):
    station.command(number, *params, **values)
    run_passes(craft, 4)
    acks = station.received(messages.CommandAck)
    assert len(acks) == 1, (number, params, acks)
    assert acks[0].command == number
    return acks[0].result


def every_command_is_answered():
    """Known, unknown, as COMMAND_LONG and COMMAND_INT, whatever its parameters are: one COMMAND_ACK to who asked."""
    craft, station = _met()
    odd = (0.0, -1.0, 0.5, 3e38, float("nan"), float("inf"), -float("inf"))
    for number in KNOWN + UNKNOWN:
        for value in odd if number in KNOWN else (0.0, float("nan")):
            params = {f"param{index}": value for index in range(1, 5)}
            for kind in (messages.CommandLong, messages.CommandInt):
                station.send(kind, command=number, **params)
                run_passes(craft, 3)
                acks = station.received(messages.CommandAck)
                assert [ack.command for ack in acks] == [number], (number, value, acks)
                if VERSION == 2:  # the targets are extensions, which MAVLink 1 does not carry
                    assert (acks[0].raw("target_system"), acks[0].raw("target_component")) == (255, 190), acks
                assert (acks[0].result == UNSUPPORTED) == (number not in KNOWN) or number == KNOWN[-1], acks
                if FORCE_ARM is not None:
                    craft.disarm()
                craft.restart_ms = None
    assert craft.connections[0].faults == 0, craft.said()


def others_are_left_alone():
    """A request to another system or component is not answered; 0 is everybody."""
    craft, station = _met()
    for system, component, answers in (
        (OTHER_SYSTEM, COMPONENT_ID, 0),
        (SYSTEM_ID, OTHER_COMPONENT, 0),
        (0, COMPONENT_ID, 1),
        (SYSTEM_ID, 0, 1),
        (0, 0, 1),
    ):
        station.command(410, target_system=system, target_component=component)
        station.send(messages.ParamRequestRead, param_index=0, target_system=system, target_component=component)
        run_passes(craft, 4)
        assert len(station.received()) == 2 * answers, (system, component)


def message_follows_the_acknowledgement():
    """COMMAND_ACK first, then the message that was asked for; of unknown ones nothing."""
    craft, station = _met()
    for number in SENT + (messages.MessageInterval.ID,):  # noqa: RUF005  MicroPython cannot
        station.command(dialect.MAV_CMD_REQUEST_MESSAGE, number)
        run_passes(craft, 3)
        found = station.received(*messages.ALL)
        kinds = [message.ID for message in found if message.ID in (messages.CommandAck.ID, number)]
        at = kinds.index(messages.CommandAck.ID)  # its stream may just have sent one before
        assert kinds[at : at + 2] == [messages.CommandAck.ID, number], (number, kinds)
    for number in (9999, 76, 0.5, -1, 1e9):
        assert _result(craft, station, dialect.MAV_CMD_REQUEST_MESSAGE, number) == DENIED, number
    for command, name in (
        (dialect.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES, "AutopilotVersion"),
        (dialect.MAV_CMD_REQUEST_PROTOCOL_VERSION, "ProtocolVersion"),
    ):
        number = getattr(getattr(messages, name, None), "ID", None)
        if number not in ON_REQUEST:
            assert _result(craft, station, command, 1) == DENIED
            continue
        station.command(command, 1)
        run_passes(craft, 3)
        assert [message.ID for message in station.received()] == [messages.CommandAck.ID, number]
        station.command(command, 0)
        run_passes(craft, 3)
        assert [message.ID for message in station.received()] == [messages.CommandAck.ID]
        assert _result(craft, station, command, 2) == DENIED


def full_port_delays_but_does_not_reorder():
    """While the port takes nothing the answers wait; then they come in their order."""
    craft, station = _met()
    quieted(craft)
    craft.port.room = 0
    asked = [410, 411, 412]
    for number in asked:
        station.command(number)
    run_passes(craft, 40)
    assert station.received() == []
    craft.port.room = 1
    run_passes(craft, 20)
    assert [ack.command for ack in station.received(messages.CommandAck)] == asked


def _tells(craft, station):
    """Return whether HEARTBEAT has the flag that the table asks for in the state at hand."""
    run(craft, SECOND_US)
    found = station.received(messages.Heartbeat)
    return TOLD_ARMED is None or bool(found[-1].base_mode & ARMED) is TOLD_ARMED[craft.is_armed]


def one_instance_is_sent_on_request():
    """The second parameter is the number of an instance, 0 and NaN are all; for one that is not there it is denied."""
    craft, station = _met()
    asked = [number for number in SENT if number in MESSAGES and MESSAGES[number]["number_at"] is not None]
    needs(asked, "a message with the number of its instance")
    for number in asked:
        present = _numbers_told(craft, station, number, 0)
        assert present, number
        assert _numbers_told(craft, station, number, float("nan")) == present, number
        for one in {each for each in present if each}:
            assert _numbers_told(craft, station, number, one) == [each for each in present if each == one], number
        absent = next(each for each in range(1, 256) if each not in present)
        for one in (absent, 255 if 255 not in present else absent, 0.5, -1, 256):
            assert _result(craft, station, dialect.MAV_CMD_REQUEST_MESSAGE, number, one) == DENIED, (number, one)
            run_passes(craft, 1)


def _numbers_told(craft, station, number, one):
    """Return the numbers of the instances that messages are about which are sent on request."""
    place = MESSAGES[number]["number_at"]
    station.port.frames = []
    station.command(dialect.MAV_CMD_REQUEST_MESSAGE, number, one)
    times = craft.connections[0].streams._times
    before = [times[at] for at in range(2, len(times), 4)]
    for index in range(len(before)):  # nothing of its own accord meanwhile
        times[2 + 4 * index] = before[index] + 1000000 & 0x3FFFFFFF
    run_passes(craft, 4)
    for index in range(len(before)):
        times[2 + 4 * index] = before[index]
    found = [frame for frame in station.port.frames if id_of(frame) == number]
    acks = station.received(messages.CommandAck)
    assert [ack.result for ack in acks] == [ACCEPTED], (number, one, acks)
    return [payload[place] if place < len(payload) else 0 for payload in map(payload_of, found)]


def arming_by_command():
    """Armed, disarmed, refused with a text, forced; anything but 0 and 1 is denied; HEARTBEAT follows."""
    needs_arming()
    craft, station = _met()
    command = dialect.MAV_CMD_COMPONENT_ARM_DISARM
    assert _tells(craft, station)
    assert _result(craft, station, command, 1) == ACCEPTED
    assert craft.is_armed
    assert _tells(craft, station)
    assert _result(craft, station, command, 0) == ACCEPTED
    assert not craft.is_armed
    assert _tells(craft, station)
    craft.problem = "door open"
    station.received()
    station.command(command, 1)
    run_turns(craft, 4)
    found = station.received(messages.CommandAck, messages.Statustext)
    assert [each.result for each in found if each.ID == messages.CommandAck.ID] == [FAILED]
    texts = [each for each in found if each.ID == messages.Statustext.ID]
    assert [each.text for each in texts] == ["PreArm: door open"], texts
    assert texts[0].severity == dialect.MAV_SEVERITY_ERROR
    for number in (FORCE_ARM + 1, 0, 1, float("nan")):
        assert _result(craft, station, command, 1, number) == FAILED, number
    assert _result(craft, station, command, 1, FORCE_ARM) == ACCEPTED
    assert craft.is_armed
    for value in (0.5, 2, -1, float("nan"), float("inf")):
        assert _result(craft, station, command, value) == DENIED, value
    assert craft.is_armed
    assert _result(craft, station, command, 0, FORCE_ARM) == ACCEPTED
    assert not craft.is_armed


def restart_by_command():
    """Accepted while disarmed; failed while armed unless forced; 0 does nothing, 2 and more are unsupported."""
    command = dialect.MAV_CMD_PREFLIGHT_REBOOT_SHUTDOWN
    craft, station = _met()
    assert _result(craft, station, command, dialect.REBOOT_SHUTDOWN_ACTION_NONE) == ACCEPTED
    assert _result(craft, station, command, 2) == UNSUPPORTED
    assert _result(craft, station, command, 3) == UNSUPPORTED
    assert _result(craft, station, command, 0.5) == DENIED
    assert craft.restart_ms is None
    if FORCE_ARM is not None:
        craft.arm(force=True)
        assert _result(craft, station, command, 1) == FAILED
        assert _result(craft, station, command, 1, param6=1) == FAILED
        assert craft.restart_ms is None
        assert craft.is_armed
        assert _result(craft, station, command, 1, param6=dialect.REBOOT_SHUTDOWN_CONDITIONS_FORCE) == ACCEPTED
        assert craft.restart_ms is not None
        assert not craft.is_armed
        craft, station = _met()
    assert _result(craft, station, command, 1) == ACCEPTED
    assert craft.restart_ms is not None


def pings_are_answered():
    """The same time and number, addressed to who asked; an answer is not answered."""
    craft, station = _met()
    time_usec = 1 << 52 | 12345
    station.send(messages.Ping, time_usec=time_usec, seq=77, target_system=0, target_component=0)
    run_passes(craft, 3)
    pongs = station.received(messages.Ping)
    assert [(pong.time_usec, pong.seq) for pong in pongs] == [(time_usec, 77)], pongs
    assert (pongs[0].target_system, pongs[0].target_component) == (255, 190)
    station.send(messages.Ping, time_usec=1, seq=1)
    run_passes(craft, 3)
    assert station.received(messages.Ping) == []


def what_arrives_together_is_answered_before_its_turns():
    """A link that has work left after its turn goes on in the next slot, where that comes before its next turn."""
    needs(LINKS_US > CONTROL_US, "slots between the turns of a link")
    craft, station = _met()
    count, taken = 16, min(craft.MESSAGES, 2)  # of those in a turn
    for seq in range(1, count + 1):
        station.send(messages.Ping, time_usec=1, seq=seq, target_system=0, target_component=0)
    run(craft, count // taken * LINKS_US * 3 // 4)
    assert [pong.seq for pong in station.received(messages.Ping)] == list(range(1, count + 1))


def _chunks(craft, station):
    run_turns(craft, 6)
    return station.received(messages.Statustext)


def texts_in_chunks():
    """Texts of every length arrive whole: up to 50 characters alone, longer ones in chunks, the last with a NUL."""
    craft, station = _met()
    station.received(messages.Statustext)
    numbers = []
    for length in (1, 49, 50, 51, 99, 100, 101, 120):
        text = "".join([chr(ord("a") + index % 26) for index in range(length)])
        craft.texts.say(dialect.MAV_SEVERITY_NOTICE, text)
        chunks = _chunks(craft, station)
        if VERSION == 1:  # chunks are told by extensions, which it does not carry
            assert [chunk.text for chunk in chunks] == [text[:50]], (length, chunks)
            continue
        assert "".join([chunk.text for chunk in chunks]) == text, (length, chunks)
        assert len(chunks) == (1 if length <= 50 else length // 50 + 1), length
        assert [chunk.chunk_seq for chunk in chunks] == list(range(len(chunks)))
        assert {chunk.severity for chunk in chunks} == {dialect.MAV_SEVERITY_NOTICE}
        assert len({chunk.raw("id") for chunk in chunks}) == 1
        assert (chunks[0].raw("id") == 0) == (length <= 50)
        assert length <= 50 or len(chunks[-1].text) < 50
        numbers += [chunks[0].raw("id")] if length > 50 else []
    assert len(set(numbers)) == len(numbers)
    texts = Texts(lambda _text: None)
    for number in range(17):
        texts(number)
    assert [texts.get(number) is not None for number in (1, 2, 17)] == [False, True, True], "16 texts wait"


def texts_reach_every_link():
    """A text goes out on each link once; one that is down does not hold up the others."""
    ports = [Port(), Port()]
    craft = new_craft(ports=ports)
    stations = [GroundStation(port) for port in ports]
    run(craft, SECOND_US)
    for station in stations:
        station.received()
    ports[0].is_up = False
    craft.texts("warning: one")
    run_turns(craft, 6)
    assert [text.text for text in stations[1].received(messages.Statustext)] == ["one"]
    ports[0].is_up = True
    run_turns(craft, 6)
    assert [text.text for text in stations[0].received(messages.Statustext)] == ["one"]


def what_stands_is_told_again():
    """While disarmed every 30 s, and within a second to a ground station that appears; nothing while armed."""
    flash = Flash()
    flash.files.update(dict.fromkeys(FILES, b"rubbish"))
    craft = ready_craft(flash=flash)
    station = craft.ground_station()
    lost = "parameters have their defaults: "
    run(craft, 5 * SECOND_US)
    assert len(craft.said(lost)) == 1, craft.said()
    assert 24 <= craft._quiet_s <= 26  # seconds of the 30 that are left: to wait for them all takes long
    craft._quiet_s = 2
    run(craft, 3 * SECOND_US)
    assert len(craft.said(lost)) == 2, craft.said()
    assert 28 <= craft._quiet_s <= 30
    station.received()
    station.send(messages.Heartbeat, type=dialect.MAV_TYPE_GCS)
    run(craft, 2 * SECOND_US)
    said = [text.text for text in station.received(messages.Statustext)]
    assert said.count(craft.said(lost)[-1][1][:50]) == 1, said
    if FORCE_ARM is not None:
        craft.check_arming = lambda: "no"
        craft._has_lost = False  # as a save leaves it
        craft.remind()
        run(craft, 2 * SECOND_US)
        assert len(craft.said("PreArm: no")) == 1, craft.said()
        craft.arm(force=True)
        craft.remind()
        run(craft, 2 * SECOND_US)
        assert len(craft.said("PreArm: no")) == 1, craft.said()


def what_is_not_here_is_answered():
    """One answer to each question about missions, logs and modes, to who asked; none where it is for others."""
    needs(ABSENT, "questions about what the vehicle does not have")
    import absences  # noqa: PLC0415  as the firmware does

    craft, station = _met()
    for question, answer in ABSENT:
        for targets in ((SYSTEM_ID, COMPONENT_ID), (0, 0), (OTHER_SYSTEM, 0), (SYSTEM_ID, OTHER_COMPONENT)):
            asked = absences.Bare(question)
            for place, target in zip(asked.TARGETS, targets):  # noqa: B905  SET_MODE has no target component
                asked.wire[place] = target
            station.port.frames = []
            station.link.send(asked)
            run_passes(craft, 3)
            found = [frame for frame in station.port.frames if id_of(frame) == answer]
            is_asked = targets[0] in (0, SYSTEM_ID) and (len(asked.TARGETS) == 1 or targets[1] in (0, COMPONENT_ID))
            assert len(found) == is_asked, (question, targets, found)
            places = absences.Bare(answer).TARGETS
            if VERSION == 1 and answer == messages.CommandAck.ID:
                continue  # its targets are extensions
            for frame in found:
                payload = payload_of(frame) + bytes(20)  # of MAVLink 2 without zeros at its end
                assert [payload[place] for place in places] == [255, 190][: len(places)], found
    assert craft.connections[0].faults == 0, craft.said()


def files_are_refused():
    """A request for files: at once a NAK with the next number, to who asked; none for others, and none to an answer."""
    import services  # noqa: PLC0415  as long as nothing else here needs it

    craft, station = _met()
    for system, component in ((SYSTEM_ID, COMPONENT_ID), (0, 0), (OTHER_SYSTEM, 0), (SYSTEM_ID, OTHER_COMPONENT)):
        for number, session, opcode in ((0, 0, 0), (254, 1, 4), (255, 2, 5), (256, 9, 127), (65535, 7, 3), (1, 3, 128)):
            head = bytes([number & 0xFF, number >> 8, session, opcode])
            request = services.FtpHead(unknown=False)
            for place, byte in enumerate(bytes([0, system, component]) + head):
                request.wire[place] = byte
            station.port.frames = []
            station.link.send(request)
            run_passes(craft, 3)
            found = [payload_of(frame) for frame in station.port.frames if id_of(frame) == 110]
            next_number = number + 1 & 0xFFFF
            refusal = bytes([next_number & 0xFF, next_number >> 8, session, 129, 1, opcode, 0, 0, 0, 0, 0, 0, 7])
            is_asked = system in (0, SYSTEM_ID) and component in (0, COMPONENT_ID) and opcode < 128
            is_asked = is_asked and VERSION == 2  # of MAVLink 1 a refusal would take all 251 bytes
            assert found == [bytes([0, 255, 190]) + refusal] * is_asked, (number, opcode, system, component, found)
    assert craft.connections[0].faults == 0, craft.said()


def checks_are_said_on_request():
    """Within a second what speaks against arming is said, while the vehicle is disarmed."""
    needs_arming()
    craft, station = _met()
    craft.problem = "door open"
    run(craft, 2 * SECOND_US)
    before = len(craft.said("PreArm: door open"))
    assert _result(craft, station, dialect.MAV_CMD_RUN_PREARM_CHECKS) == ACCEPTED
    run(craft, 2 * SECOND_US)
    assert len(craft.said("PreArm: door open")) == before + 1, craft.said()
    craft.arm(force=True)
    assert _result(craft, station, dialect.MAV_CMD_RUN_PREARM_CHECKS) == dialect.MAV_RESULT_TEMPORARILY_REJECTED
    run(craft, 2 * SECOND_US)
    assert len(craft.said("PreArm: door open")) == before + 1, craft.said()


def defaults_by_command():
    """All parameters have their defaults, and are saved; not while armed. Other actions change nothing."""
    command = dialect.MAV_CMD_PREFLIGHT_STORAGE
    craft, station = _met()
    usual = {facts["attribute"]: getattr(craft.parameters, facts["attribute"]) for facts in PARAMETERS}
    other = [facts for facts in SETTABLE if usual[facts["attribute"]] == facts["default"]]
    for facts in other:
        choices = facts["choices"] or (facts["minimum"], facts["maximum"])
        setattr(craft.parameters, facts["attribute"], next(value for value in choices if value != facts["default"]))
    changes = craft.parameters.changes
    for action, result in ((0, UNSUPPORTED), (1, ACCEPTED), (3, UNSUPPORTED), (0.5, DENIED), (float("nan"), DENIED)):
        assert _result(craft, station, command, action) == result, action
    if FORCE_ARM is not None:
        craft.arm(force=True)
        assert _result(craft, station, command, 2) == FAILED
        assert craft.said("Defaults: disarm first")
        craft.disarm()
    assert craft.parameters.changes == changes
    assert _result(craft, station, command, 2) == ACCEPTED
    needs(other, "a parameter with two values")
    for facts in other:
        assert getattr(craft.parameters, facts["attribute"]) == facts["default"], facts["name"]
    assert craft.parameters.changes == changes + len(other)


def garbage_is_survived():
    """Random bytes, cut and altered frames around whole ones: the whole ones are answered, and faults are counted.

    One in 256 false frames of a message that the link does not know passes for one, and hides what is within it.
    """
    craft, station = _met()
    state = 1
    answered = asked = 0

    def noise(count):
        nonlocal state
        data = bytearray()
        for _ in range(count):
            state = (state * 1103515245 + 12345) & 0x3FFFFFFF
            data.append((state >> 16) & 0xFF)
        return data

    frame = bytearray(station.link.encode(messages.CommandLong(unknown=False).update(command=410)))
    for round_ in range(60):
        craft.port.arrives(noise(round_))
        craft.port.arrives(frame[: round_ % len(frame)])
        altered = bytearray(frame)
        altered[round_ % (len(frame) - 1) + 1] ^= 0x55
        craft.port.arrives(altered)
        craft.port.arrives(bytes(300))  # what looks like a long frame is over after these
        craft.port.arrives(b"\xfd\xc0\x00\x00")  # a false start: the true frame is within the false one
        station.command(1000 + round_)
        craft.port.arrives(bytes(300))
        asked += 1
        run_passes(craft, 20)
        answered += len([ack for ack in station.received(messages.CommandAck) if ack.command == 1000 + round_])
    assert answered >= asked - 1, (answered, asked)
    link = craft.connections[0].link
    assert link.crc_errors > 0
    assert link.received >= answered
    assert craft.connections[0].faults == 0


def ground_stations_are_noted():
    """The HEARTBEAT of a ground station is remembered, that of another vehicle is not."""
    craft, station = _met()
    services = craft.connections[0].services
    station.send(messages.Heartbeat, type=2)
    run_passes(craft, 3)
    assert services.ground_station is None
    station.send(messages.Heartbeat, type=dialect.MAV_TYPE_GCS)
    run_passes(craft, 3)
    assert services.ground_station == (255, 190)
    announced = [number for number, facts in MESSAGES.items() if facts["on_connection"]]
    assert [each for each in station.received() if each.ID not in announced] == []
    GroundStation(craft.port, system_id=254, component_id=191).send(messages.Heartbeat, type=dialect.MAV_TYPE_GCS)
    run_passes(craft, 3)
    assert services.ground_station == (254, 191), "the one that was heard last"


def answers_across_the_wrap():
    """Nothing gets stuck where ticks_us() starts again."""
    craft = new_craft(at_us=TURN_US - SECOND_US // 2)
    station = craft.ground_station()
    for number in range(400, 500):
        station.command(number + 1000)
        run(craft, SECOND_US // 100)
    run_passes(craft, 4)  # the last one may have come between two turns of the links
    found = [ack.command for ack in station.received(messages.CommandAck)]
    assert found == list(range(1400, 1500)), found


CHECKS = (
    (every_command_is_answered, "services.commands"),
    (others_are_left_alone, "services.commands"),
    (full_port_delays_but_does_not_reorder, "services.commands"),
    (answers_across_the_wrap, "services.commands"),
    (message_follows_the_acknowledgement, "services.request"),
    (one_instance_is_sent_on_request, "services.request"),
    (arming_by_command, "arming.command", "arming.reasons"),
    (restart_by_command, "services.restart"),
    (pings_are_answered, "services.ping"),
    (what_arrives_together_is_answered_before_its_turns, "services.ping"),
    (texts_in_chunks, "services.texts"),
    (texts_reach_every_link, "services.texts"),
    (what_stands_is_told_again, "services.standing"),
    (what_is_not_here_is_answered, "services.absent"),
    (files_are_refused, "services.absent"),
    (checks_are_said_on_request, "services.checks"),
    (defaults_by_command, "services.defaults"),
    (garbage_is_survived, "services.garbage"),
    (ground_stations_are_noted, "services.garbage"),
)
LONG = (what_stands_is_told_again, checks_are_said_on_request, garbage_is_survived)

if __name__ == "__main__":
    main(CHECKS)
