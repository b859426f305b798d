# Generated from templates/tests/program/announcement_checks.py: do not edit.
# Inputs: 6441199ba90b406a
"""Checks of announcements: on a new connection and after a change, never in a burst, and never lost."""

from time import ticks_ms

from generation_checks import is_chosen, reporting
from program_bench import (
    SECOND_US,
    TURN_MS_US,
    GroundStation,
    Port,
    id_of,
    main,
    messages,
    mock_time,
    needs,
    new_craft,
    run,
    run_passes,
    sequence_of,
)
from program_facts import CONTROL_US, GENERATIONS, LINKS_US, MESSAGES, SILENCE_MS, WITHHELD

import dialect

ONBOARD_CONTROLLER = 18  # MAV_TYPE_ONBOARD_CONTROLLER of MAVLink's minimal.xml
STEP_US = 10000
LONG_US = 3 * SECOND_US // 2  # enough for every announcement, one in a pass
OFTEN_HZ = 0.1  # what is streamed more often than that is put to rest
REST_US = 600 * SECOND_US


def _expected(craft):
    """Return the ids that a link is told when somebody appears, once for each frame."""
    found = []
    for number in sorted(MESSAGES):
        if MESSAGES[number]["on_connection"] and is_chosen(craft, number):
            found += [number] * (len(reporting(craft, number)) * MESSAGES[number]["pages"])
    return found


def _announced(port, since=0):
    """Return the ids of what is sent on connection among the frames of a port, in their order."""
    known = [number for number, facts in MESSAGES.items() if facts["on_connection"]]
    return sorted(id_of(frame) for frame in port.frames[since:] if id_of(frame) in known)


def _craft(**arguments):
    """Return a vehicle whose announced messages have no other reason to be sent: their streams are at rest."""
    needs([facts for facts in MESSAGES.values() if facts["on_connection"]], "a message that is sent on connection")
    craft = new_craft(**arguments)
    needs(_expected(craft), "a message that is sent on connection by default")
    for number in MESSAGES:
        _rest(craft, number, REST_US)
    return craft


def _rest(craft, number, interval_us):
    """Let a message that is streamed often be streamed at most once in an interval."""
    if (MESSAGES[number]["rate"] or 0) > OFTEN_HZ:
        for connection in craft.connections:
            connection.streams.set_interval(number, interval_us)


def _beat(station, kind=dialect.MAV_TYPE_GCS):
    station.send(messages.Heartbeat, type=kind)


def _quiet(craft, ports):
    """Let all announcements and the first turn of all streams pass."""
    run(craft, LONG_US)
    for port in ports:
        port.frames = []


def told_at_the_start():
    """Each message once about each instance, though its stream is due then, too; at most one in a pass."""
    port = Port()
    craft = _craft(ports=[port])
    most = 0
    for _ in range(100 * -(-LINKS_US // CONTROL_US)):
        count = len(_announced(port))
        mock_time.advance_us(craft.run_pass())
        most = max(most, len(_announced(port)) - count)
    assert _announced(port) == _expected(craft)
    assert most == 1, most


def told_to_who_appears():
    """The first HEARTBEAT of a component, whatever its type, not the next ones; so does a second one."""
    for at_us in (0, TURN_MS_US - 3 * SECOND_US):
        ports = [Port(), Port()]
        craft = _craft(ports=ports, at_us=at_us)
        _quiet(craft, ports)
        station, other = GroundStation(ports[0]), GroundStation(ports[0], system_id=254)
        for who, kind, is_told in (
            (station, ONBOARD_CONTROLLER, True),
            (station, ONBOARD_CONTROLLER, False),
            (other, dialect.MAV_TYPE_GCS, True),
            (station, ONBOARD_CONTROLLER, False),
            (other, dialect.MAV_TYPE_GCS, False),
        ):
            _beat(who, kind)
            ports[0].frames = []
            run(craft, LONG_US)
            assert _announced(ports[0]) == (_expected(craft) if is_told else []), (kind, is_told)
        assert _announced(ports[1]) == [], "the other link was told"


def many_are_told_once():
    """More components than there are places for: the last ones wait for the stream, none is told twice."""
    port = Port()
    craft = _craft(ports=[port])
    _quiet(craft, [port])
    crowd = [GroundStation(port, system_id=100 + number) for number in range(14)]
    for turn in range(2):
        told = 0
        for member in crowd:
            port.frames = []
            _beat(member, ONBOARD_CONTROLLER)
            run(craft, SILENCE_MS * 1000 // 40, STEP_US)  # all of them in both turns: before the first is silent
            told += _announced(port) == _expected(craft)
        assert told == (0 if turn else 12), (turn, told)


def places_of_who_is_gone_are_free():
    """Once more components than there are places for were silent, who comes is new."""
    port = Port()
    craft = _craft(ports=[port])
    for number in range(14):
        _beat(GroundStation(port, system_id=100 + number), ONBOARD_CONTROLLER)
        run_passes(craft, 2)
    run(craft, SILENCE_MS * 1200, STEP_US * 12)
    _quiet(craft, [port])
    _beat(GroundStation(port), ONBOARD_CONTROLLER)
    run(craft, LONG_US)
    assert _announced(port) == _expected(craft)


def told_again_after_a_silence():
    """A HEARTBEAT just before the silence is long enough tells nothing, one after it tells everything again."""
    for missing_ms, is_told in ((200, False), (-200, True)):
        port = Port()
        craft = _craft(ports=[port])
        _quiet(craft, [port])
        station = GroundStation(port)
        _beat(station)
        run(craft, (SILENCE_MS - missing_ms) * 1000, STEP_US // 4)
        _beat(station)
        port.frames = []
        run_passes(craft, 60)
        assert _announced(port) == (_expected(craft) if is_told else []), missing_ms


def told_again_while_another_stays():
    """A component that was silent is new again; one that went on meanwhile is not, in whatever order they came."""
    for first in (0, 1):
        port = Port()
        craft = _craft(ports=[port])
        _quiet(craft, [port])
        gone, there = GroundStation(port), GroundStation(port, system_id=254)
        for who in ((gone, there), (there, gone))[first]:
            _beat(who)
            run(craft, LONG_US)
        for _ in range(4):
            run(craft, SILENCE_MS * 1000 // 4, STEP_US)
            _beat(there)
        for who, is_told in ((gone, True), (there, False)):
            _beat(who)
            port.frames = []
            run(craft, LONG_US)
            assert _announced(port) == (_expected(craft) if is_told else []), (first, is_told)


def told_after_days_of_silence():
    """Six to twelve days, in which ticks_ms() are hard to compare, are a silence like any other."""
    port = Port()
    craft = _craft(ports=[port])
    _quiet(craft, [port])
    station = GroundStation(port)
    _beat(station)
    run(craft, LONG_US)
    for _ in range(9):
        mock_time.advance_us(86400 * SECOND_US)
        run(craft, LONG_US)
    port.frames = []
    streamed = len(_announced(port))
    _beat(station)
    run_passes(craft, 60)
    assert _announced(port, streamed) == _expected(craft)


def a_port_that_takes_nothing_loses_none():
    """They wait for a port that is full, or down; nothing counts as lost, and other frames do not wait for them."""
    for is_up in (True, False):
        port = Port()
        port.is_up = is_up
        port.room = 0
        craft = _craft(ports=[port])
        run(craft, 5 * SECOND_US)
        assert port.frames == []
        assert craft.connections[0].faults == 0
        link = craft.connections[0].link
        assert link.sequence == link.tx_errors & 0xFF, "a frame that waits has a number already"
        port.is_up = True
        port.room = None
        run_passes(craft, 1)
        assert len(_announced(port)) <= 1
        run_passes(craft, 60)
        assert _announced(port) == _expected(craft), is_up
        numbers = [sequence_of(frame) for frame in port.frames]
        for place in range(1, len(numbers)):
            assert numbers[place] == (numbers[place - 1] + 1) & 0xFF, "a frame counts as lost"


def _watched():
    found = [number for number, facts in MESSAGES.items() if facts["watched"]]
    needs(found, "a message that is sent on a change")
    return found


def _owners(craft, component):
    owner = getattr(craft.state, component)
    return list(owner)


def told_of_a_change():
    """A change of one instance is told at once, on each link, about that instance; nothing is told without one."""
    for number in _watched():
        facts = MESSAGES[number]
        component, attribute = facts["watched"]
        ports = [Port(), Port()]
        craft = new_craft(ports=ports)
        _rest(craft, number, REST_US)
        _quiet(craft, ports)
        for place, owner in enumerate(_owners(craft, component)):
            for value in (5, 6, None):
                setattr(owner, attribute, value)
                is_told = is_chosen(craft, number) and place in reporting(craft, number)
                if value is None and facts["watched"] in WITHHELD.get(number, ()):
                    is_told = False  # it cannot say so
                for port in ports:
                    port.frames = []
                run_passes(craft, 20)
                for port in ports:
                    found = [id_of(frame) for frame in port.frames].count(number)
                    assert found == (facts["pages"] if is_told else 0), (number, place, value, found)


def told_of_all_when_their_turn_comes():
    """One instance waits for a port that is full, and the stream's turn comes: then all of them wait, none is lost."""
    several = 0
    for number in _watched():
        facts = MESSAGES[number]
        component, attribute = facts["watched"]
        port = Port()
        craft = new_craft(ports=[port])
        owners = _owners(craft, component)
        for owner in owners:
            if facts["enabled"] and facts["component"] == component:
                setattr(owner, facts["enabled"], True)
        if not facts["rate"] or not is_chosen(craft, number):
            continue
        several = max(several, len(reporting(craft, number)))
        interval_us = int(SECOND_US / min(facts["rate"], OFTEN_HZ))
        _rest(craft, number, interval_us)
        _quiet(craft, [port])
        port.room = 0
        setattr(owners[-1], attribute, 5)
        run(craft, interval_us + SECOND_US, STEP_US)
        port.room = None
        run_passes(craft, 60)
        found = [id_of(frame) for frame in port.frames].count(number)
        assert found == len(reporting(craft, number)) * facts["pages"], (number, found)
    needs(several > 1, "several instances that are announced")


def only_what_is_on_is_told():
    """An instance that is switched off is not announced; one that is on is, whatever the others do."""
    port = Port()
    craft = _craft(ports=[port])
    _quiet(craft, [port])
    station = GroundStation(port)
    names = {(facts["component"], facts["enabled"]) for facts in MESSAGES.values() if facts["enabled"]}
    needs(names, "a component that can be off")
    for component, enabled in sorted(names):
        for owner in _owners(craft, component):
            setattr(owner, enabled, not getattr(owner, enabled))
    station.received()
    _beat(station)
    port.frames = []
    run_passes(craft, 60)
    assert _announced(port) == _expected(craft)


def not_told_what_was_switched_off():
    """An interval of -1 on a link is respected there."""
    ports = [Port(), Port()]
    craft = _craft(ports=ports)
    _quiet(craft, ports)
    stations = [GroundStation(port) for port in ports]
    for number in set(_expected(craft)):
        stations[0].command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, -1)
        run_passes(craft, 4)
    for station in stations:
        _beat(station)
        station.port.frames = []
    run_passes(craft, 60)
    assert _announced(ports[0]) == []
    assert _announced(ports[1]) == _expected(craft)


def told_of_the_generation_that_is_chosen():
    """Each choice of generations: who appears is told that one only."""
    choosing = [each for each in GENERATIONS if each["parameter"]]
    needs(choosing, "a parameter that chooses a generation")
    for choice in (0, 1, 2):
        port = Port()
        craft = _craft(ports=[port])
        for each in choosing:
            craft.parameters.set(each["parameter"], choice)
        _quiet(craft, [port])
        station = GroundStation(port)
        _beat(station)
        run_passes(craft, 60)
        assert _announced(port) == _expected(craft), choice


def told_in_place_of_the_stream():
    """An announced message that is due before its stream has a turn is sent once, and again an interval later."""
    port = Port()
    craft = _craft(ports=[port])
    station = GroundStation(port)
    for number in sorted(set(_expected(craft))):
        station.command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, number, 5 * SECOND_US)
        run_passes(craft, 4)
    run(craft, 7 * SECOND_US)
    connection = craft.connections[0]
    streams = connection.streams
    for is_told, later_us in ((True, 6 * SECOND_US), (False, 4 * SECOND_US), (False, 2 * SECOND_US)):
        mock_time.advance_us(later_us)
        connection._budget[0] = 1000
        port.frames = []
        if is_told:
            streams.connect()
        for _ in range(40):
            streams.announce()
        streams.run(ticks_ms())
        assert _announced(port) == ([] if later_us == 4 * SECOND_US else _expected(craft)), (later_us, _announced(port))


def told_besides():
    """Announced messages go out at their stream's rate, too: so often in two minutes."""
    found = [number for number, facts in MESSAGES.items() if facts["on_connection"] and facts["rate"]]
    needs(found, "a message that is announced and has a rate")
    port = Port()
    craft = new_craft(ports=[port])
    _quiet(craft, [port])
    run(craft, 120 * SECOND_US, STEP_US)
    for number in found:
        turn = len(reporting(craft, number)) * MESSAGES[number]["pages"] if is_chosen(craft, number) else 0
        count = [id_of(frame) for frame in port.frames].count(number)
        assert abs(count - 120 * MESSAGES[number]["rate"] * turn) <= turn, (number, count)


CHECKS = (
    (told_at_the_start, "message.connection"),
    (told_to_who_appears, "message.connection"),
    (many_are_told_once, "message.connection"),
    (places_of_who_is_gone_are_free, "message.connection"),
    (told_again_after_a_silence, "message.connection"),
    (told_again_while_another_stays, "message.connection"),
    (told_after_days_of_silence, "message.connection"),
    (a_port_that_takes_nothing_loses_none, "message.connection"),
    (only_what_is_on_is_told, "message.connection"),
    (not_told_what_was_switched_off, "message.connection"),
    (told_of_a_change, "message.change"),
    (told_of_all_when_their_turn_comes, "message.change"),
    (told_besides, "message.besides"),
    (told_in_place_of_the_stream, "message.besides"),
    (told_of_the_generation_that_is_chosen, "generations.choice"),
)
LONG = (
    told_to_who_appears,
    told_again_after_a_silence,
    told_again_while_another_stays,
    told_after_days_of_silence,
    a_port_that_takes_nothing_loses_none,
    told_of_a_change,
    told_of_all_when_their_turn_comes,
    told_besides,
    told_in_place_of_the_stream,
    told_of_the_generation_that_is_chosen,
)

if __name__ == "__main__":
    main(CHECKS)
