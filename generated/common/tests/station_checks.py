# Generated from templates/tests/program/station_checks.py: do not edit.
# Inputs: d06fd006aadd2cd4
"""Several stations at one port: each is served for itself, and nobody's bytes take anything away from another one."""

from time import ticks_add, ticks_ms

from program_bench import (
    GOES_OUT,
    SECOND_US,
    SETTABLE,
    GroundStation,
    id_of,
    main,
    messages,
    needs,
    new_craft,
    run,
    run_passes,
    sequence_of,
    turns,
)
from program_facts import COMPONENT_ID, LINKS_US, MESSAGES, PARAMETERS, SILENCE_MS, SYSTEM_ID, VERSION
from stations import Stations

import dialect

HOME = ("10.0.0.255", 14550)  # the declared address


class Air:
    """A port that tells addresses: what arrives stands in `arrived`, and `taken` has the frames for each address."""

    name = "air"
    is_up = True
    stations = Stations

    def __init__(self, home=HOME):
        self.home = home
        self.ends = [home, None]
        self.arrived = []
        self.taken = {}

    def read(self):
        """Return the next datagram."""
        if not self.arrived:
            return None
        self.ends[1], data = self.arrived.pop(0)
        return data

    def write(self, frame):
        """Take a frame, if it is for anybody."""
        if self.ends[0] is None:
            return 0
        self.taken.setdefault(self.ends[0], []).append(bytes(frame))
        return len(frame)

    def poll(self, _now_ms):
        """Do nothing."""


class End:
    """One address at the other end, as GroundStation takes it."""

    def __init__(self, air, address):
        self._air = air
        self._address = address

    def arrives(self, data):
        """Let a datagram arrive at the vehicle."""
        self._air.arrived.append((self._address, bytes(data)))

    @property
    def frames(self):
        """Return the frames that came back."""
        return self._air.taken.get(self._address, [])

    @frames.setter
    def frames(self, frames):
        self._air.taken[self._address] = frames


class Scene:
    """A vehicle on the air, and stations by the number of their address."""

    def __init__(self, home=HOME):
        self.air = Air(home)
        self.craft = new_craft(ports=[self.air])
        self.stations = {}

    def station(self, number, system_id=255):
        """Return the station at an address, with this system id."""
        if number not in self.stations:
            self.stations[number] = GroundStation(End(self.air, address(number)), VERSION, system_id)
        return self.stations[number]

    def seconds(self, count, *present):
        """Let seconds pass in which these stations send a HEARTBEAT each."""
        for _ in range(count):
            for number in present:
                self.beat(number)
            run(self.craft, SECOND_US)

    def beat(self, number):
        """Let a station send a HEARTBEAT."""
        self.station(number).send(
            messages.Heartbeat, type=dialect.MAV_TYPE_GCS, autopilot=dialect.MAV_AUTOPILOT_INVALID
        )

    def heard(self, count, *numbers):
        """Return how many HEARTBEATs each station got in some seconds in which it beats; None is the declared address.

        Only the frames of the last second are kept.
        """
        found = [0] * len(numbers)
        for _ in range(count):
            self.air.taken = {}
            self.seconds(1, *[number for number in numbers if number is not None])
            for place in range(len(numbers)):
                found[place] += self.beats(HOME if numbers[place] is None else address(numbers[place]))
        return found

    def beats(self, of):
        """Return how many of the frames for an address are HEARTBEATs."""
        return len([frame for frame in self.air.taken.get(of, ()) if id_of(frame) == messages.Heartbeat.ID])


def address(number):
    """Return an address."""
    return ("10.0.0." + str(number), 50000)


def all_of_four_are_served():
    """Each gets as much as one alone, and misses nothing."""
    scene = Scene()
    alone = scene.heard(10, 1)[0]
    assert alone >= 1
    scene.seconds(1, 1, 2, 3, 4)
    found = scene.heard(10, 1, 2, 3, 4)
    assert [abs(count - alone) <= 1 for count in found] == [True] * 4, (alone, found)
    scene.air.taken = {}
    scene.seconds(5, 1, 2, 3, 4)
    for number in (1, 2, 3, 4):
        assert _follows(scene.air.taken[address(number)]), number


def _follows(frames):
    first = sequence_of(frames[0])
    return [sequence_of(frame) for frame in frames] == [(first + at) & 0xFF for at in range(len(frames))]


def rates_are_of_who_asked():
    """A message that one station switches off goes on for the other, and comes back only for one that asks for it."""
    scene = Scene()
    scene.seconds(1, 1, 2)
    scene.station(1).command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, messages.Heartbeat.ID, -1)
    scene.seconds(1, 1, 2)
    off, on = scene.heard(5, 1, 2)
    assert off == 0
    assert on >= 4
    scene.station(2).command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, messages.Heartbeat.ID, 0)
    scene.seconds(1, 1, 2)
    assert scene.heard(5, 1, 2)[0] == 0


def lists_of_parameters_go_side_by_side():
    """Each station gets its own, from the first parameter to the last, whenever it asks."""
    needs(PARAMETERS, "parameters")
    scene = Scene()
    scene.seconds(1, 1, 2, 3)
    scene.air.taken = {}
    for number in (1, 2, 3):
        scene.station(number).send(messages.ParamRequestList)
        run_passes(scene.craft, 3)
    run(scene.craft, 5 * SECOND_US + turns(3 * len(PARAMETERS), every=3) * LINKS_US)
    for number in (1, 2, 3):
        found = [value.param_index for value in scene.station(number).received(messages.ParamValue)]
        assert found == list(range(len(PARAMETERS))), (number, found)


def a_new_value_is_told_to_all():
    """The station that sets a parameter is answered, and the others are told."""
    needs(SETTABLE, "a parameter with several values")
    scene = Scene()
    scene.seconds(1, 1, 2, 3)
    scene.air.taken = {}
    limits = scene.craft.parameters.limits(SETTABLE[0]["name"])
    now = scene.craft.parameters.get(SETTABLE[0]["name"])
    value = limits[0] if now != limits[0] else limits[1]
    scene.station(2).set_parameter(SETTABLE[0], value)
    run_passes(scene.craft, 12)
    for number in (1, 2, 3):
        found = [each.param_id for each in scene.station(number).received(messages.ParamValue)]
        assert found == [SETTABLE[0]["name"]], (number, found)


def who_asks_is_answered():
    """Two stations have one system id: each gets its own answers."""
    scene = Scene()
    scene.seconds(1, 1, 2)
    scene.air.taken = {}
    scene.station(1).command(410)
    scene.station(2).command(411)
    run_passes(scene.craft, 4)
    for number, expected in ((1, 410), (2, 411)):
        assert [ack.command for ack in scene.station(number).received(messages.CommandAck)] == [expected]


def bytes_that_are_no_frame_change_nothing():
    """A stray byte, noise and a damaged frame: nobody is served for them, and nobody less."""
    scene = Scene()
    frame = bytes(scene.station(7).link.encode(messages.Heartbeat(unknown=False).update(type=dialect.MAV_TYPE_GCS)))
    own = bytes(GroundStation(None, VERSION, SYSTEM_ID, COMPONENT_ID).link.encode(messages.Ping(unknown=False)))
    strays = (b"", b"\0", b"\xfd\xff\0", frame[:-1], frame[:-1] + bytes((frame[-1] ^ 1,)), bytes(range(256)) * 4)
    for present in ((None,), (1, 2)):
        for stray in strays + (own,):  # noqa: RUF005  MicroPython has no stars there
            scene.air.arrived.append((address(9), stray))
            scene.air.taken = {}
            run_passes(scene.craft, 8)
        found = scene.heard(5, *present)
        assert min(found) >= 4, found
        assert address(9) not in scene.air.taken
        scene.seconds(1, 1, 2)


def datagrams_stand_for_themselves():
    """A part of a frame from one station does not become part of another one's, and delays nothing."""
    scene = Scene()
    scene.seconds(1, 1, 2)
    scene.air.taken = {}
    announced = b"\xfd\xff\0\0\0\xff\xbe\x4c\0\0" if VERSION == 2 else b"\xfe\xff\0\xff\xbe\x4c"
    for _ in range(5):
        scene.air.arrived.append((address(2), announced))
        scene.station(1).command(410)
        run_passes(scene.craft, 2)
    assert len(scene.station(1).received(messages.CommandAck)) == 5
    frame = bytes(scene.station(1).link.encode(messages.CommandLong(unknown=False).update(command=410)))
    scene.air.arrived += [(address(1), frame[:20]), (address(2), frame[20:])]
    run_passes(scene.craft, 4)
    assert not scene.station(1).received(messages.CommandAck) + scene.station(2).received(messages.CommandAck)


def vehicles_are_no_stations():
    """Another vehicle that broadcasts to the same port does not take the telemetry away."""
    scene = Scene()
    other = GroundStation(End(scene.air, address(9)), VERSION, 7)
    other.send(messages.Heartbeat, type=2, autopilot=3)
    scene.seconds(1)
    assert scene.heard(5, None)[0] >= 4
    assert address(9) not in scene.air.taken


def the_declared_address_is_served_while_nobody_is_there():
    """Before the first station, and after the last one; nobody is where none is declared."""
    for home in (HOME, None):
        scene = Scene(home)
        assert scene.heard(5, None)[0] >= (4 if home else 0)
        scene.seconds(1, 1)
        declared, one = scene.heard(5, None, 1)
        assert (declared, one >= 4) == (0, True)
        scene.seconds(SILENCE_MS // 1000 + 2)
        declared = scene.heard(5, None)[0]
        assert declared >= 4 if home else declared == 0
        assert address(1) not in scene.air.taken
        scene.seconds(1, 2, 3, 4, 5)
        assert min(scene.heard(5, 2, 3, 4, 5)) >= 4


def the_declared_address_keeps_its_rates():
    """A station there that never beats has what it has asked for, for as long as nobody else is there."""
    home = address(1)
    scene = Scene(home)
    scene.seconds(1)
    scene.station(1).command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, messages.Heartbeat.ID, -1)
    scene.seconds(SILENCE_MS // 1000 + 2)
    scene.air.taken = {}
    run(scene.craft, 5 * SECOND_US)
    assert scene.beats(home) == 0
    scene.seconds(1, 2)
    assert scene.heard(5, 2)[0] >= 4
    assert home not in scene.air.taken
    scene.seconds(SILENCE_MS // 1000 + 2)
    scene.air.taken = {}
    run(scene.craft, 5 * SECOND_US)
    assert scene.beats(home) == 0
    assert address(2) not in scene.air.taken


def who_comes_back_finds_its_rates():
    """From the laptop to the tablet and back: each has what it asked for, and who is away is not sent to."""
    scene = Scene()
    scene.seconds(1, 1)
    scene.station(1).command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, messages.Heartbeat.ID, -1)
    scene.seconds(1, 1)
    scene.seconds(SILENCE_MS // 1000 + 2, 2)
    assert scene.heard(5, 2)[0] >= 4
    assert address(1) not in scene.air.taken
    scene.seconds(SILENCE_MS // 1000 + 2)
    assert scene.heard(5, None)[0] >= 4
    scene.seconds(1, 1)
    there, back = scene.heard(5, 2, 1)
    assert (there >= 4, back) == (True, 0)


def who_comes_back_is_told_what_it_missed():
    """Only the station that comes back gets the messages sent on connection, though another has its system id."""
    # What is streamed as often comes to both.
    told = [number for number, facts in MESSAGES.items() if facts["on_connection"] and (facts["rate"] or 0) < 0.1]
    scene = Scene()
    needs(told and VERSION == 2, "a message that is sent on connection")
    scene.seconds(2, 1, 2)
    scene.seconds(SILENCE_MS // 1000 + 2, 2)
    scene.air.taken = {}
    scene.seconds(1, 1, 2)
    found = [[frame for frame in scene.air.taken[address(number)] if id_of(frame) in told] for number in (1, 2)]
    assert found[0], "who came back"
    assert not found[1], "who was there"


def a_station_that_starts_again_is_served_at_once():
    """It has another port each time, more often than there are places; who still beats goes on."""
    scene = Scene()
    scene.seconds(1, 1)
    for number in range(2, 9):
        scene.seconds(1, 1, number)
        assert min(scene.heard(4, 1, number)) >= 3, number


def there_is_no_place_for_a_fifth():
    """It gets nothing and a text says so, until one of the four is away."""
    scene = Scene()
    for _ in range(2):
        scene.seconds(6, 1, 2, 3, 4)
        scene.beat(5)
    scene.seconds(12, 1, 2, 3, 4)
    assert address(5) not in scene.air.taken
    told = scene.craft.said("air has no place for another station")
    assert sum(int(text.rsplit(" ", 1)[1]) for _, text in told) == 2, told  # each of its frames once
    assert scene.craft.connections[0].faults == 0
    scene.seconds(6, 1, 2, 3, 5)
    assert min(scene.heard(5, 1, 2, 3, 5)) >= 4


def too_much_is_left_out_from_the_end():
    """Four stations ask for all that there is: HEARTBEATs come, others are left out in turn, and a text says so."""
    scene = Scene()
    scene.seconds(1, 1, 2, 3, 4)
    for number in (1, 2, 3, 4):
        for message in GOES_OUT:
            scene.station(number).command(dialect.MAV_CMD_SET_MESSAGE_INTERVAL, message, 1)
            run_passes(scene.craft, 2)
    streams = [station.streams for station in scene.craft.connections[0].stations]
    intervals_us = [each.interval_us(message) for each in streams for message in GOES_OUT]
    per_pass = sum([LINKS_US / interval_us for interval_us in intervals_us if interval_us > 0])
    needs(per_pass > 9, "enough messages")
    scene.seconds(1, 1, 2, 3, 4)
    found, frames = [0] * 4, [0] * 4
    for _ in range(5):
        beats = scene.heard(1, 1, 2, 3, 4)
        for place in range(4):
            found[place] += beats[place]
            frames[place] += len(scene.air.taken[address(place + 1)])
    assert min(frames) > max(frames) * 3 // 4, frames
    wanted = 5 * SECOND_US // streams[0].interval_us(messages.Heartbeat.ID)
    assert 2 * min(found) >= max(found), found
    assert min(found) >= wanted // 5, found
    for _ in range(11):
        scene.air.taken = {}
        scene.seconds(1, 1, 2, 3, 4)
    assert scene.craft.said("air is full, messages left out")
    for number in (1, 2, 3, 4):
        scene.air.taken = {}
        scene.station(number).command(410)
        run_passes(scene.craft, 4)
        assert len(scene.station(number).received(messages.CommandAck)) == 1


def who_had_no_turn_is_late_for_want_of_room():
    """Another station than the one that took all of a pass comes first next time, and what it misses counts."""
    scene = Scene()
    scene.seconds(1, 1, 2)
    connection = scene.craft.connections[0]
    for place in (0, 1):
        taking, other = connection.stations[place], connection.stations[1 - place]
        connection.turn_to(taking)
        now_ms = {}  # when the other one has nothing to do, unless it always has something, and when it has
        for ahead_ms in range(2000):
            at_ms = ticks_add(ticks_ms(), ahead_ms)
            now_ms[0 if other.streams.wait_ms(at_ms) else 1] = at_ms
        assert 1 in now_ms
        for is_due in sorted(now_ms):
            taking.streams.has_waited = other.streams.has_waited = False
            assert connection._pass_on(now_ms[is_due])
            assert connection.stations[0] is other
            assert [taking.streams.has_waited, other.streams.has_waited] == [False, is_due == 1]


CHECKS = (
    (all_of_four_are_served, "services.stations"),
    (rates_are_of_who_asked, "services.stations"),
    (lists_of_parameters_go_side_by_side, "services.stations"),
    (a_new_value_is_told_to_all, "services.stations"),
    (who_asks_is_answered, "services.stations"),
    (bytes_that_are_no_frame_change_nothing, "services.stations"),
    (datagrams_stand_for_themselves, "services.stations"),
    (vehicles_are_no_stations, "services.stations"),
    (the_declared_address_is_served_while_nobody_is_there, "services.stations"),
    (the_declared_address_keeps_its_rates, "services.stations"),
    (who_comes_back_finds_its_rates, "services.stations"),
    (who_comes_back_is_told_what_it_missed, "services.stations"),
    (a_station_that_starts_again_is_served_at_once, "services.stations"),
    (there_is_no_place_for_a_fifth, "services.stations"),
    (too_much_is_left_out_from_the_end, "services.stations"),
    (who_had_no_turn_is_late_for_want_of_room, "services.stations"),
)
LONG = (
    all_of_four_are_served,
    rates_are_of_who_asked,
    lists_of_parameters_go_side_by_side,
    bytes_that_are_no_frame_change_nothing,
    vehicles_are_no_stations,
    the_declared_address_is_served_while_nobody_is_there,
    the_declared_address_keeps_its_rates,
    who_comes_back_finds_its_rates,
    who_comes_back_is_told_what_it_missed,
    a_station_that_starts_again_is_served_at_once,
    there_is_no_place_for_a_fifth,
    too_much_is_left_out_from_the_end,
)

if __name__ == "__main__":
    main(CHECKS)
