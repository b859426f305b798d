# Generated from templates/tests/program/sensed_checks.py: do not edit.
# Inputs: 28ee94c28910838e
"""Things that come from outside: the time, messages that set quantities, sensors, and what methods answer."""

import sys
from array import array

from guard import Guard
from program_bench import GroundStation, main, messages, mock_time, needs, new_craft, run_passes

import dialect

try:
    import satellite_clock
except ImportError:  # no receiver of satellites sets the clock
    satellite_clock = None

try:
    import clock_service
except ImportError:  # no ground station sets the clock
    clock_service = None

try:
    import reception
except ImportError:  # no message sets quantities
    reception = None

try:
    import user_source
except ImportError:  # no code of the user's is a sensor
    user_source = None

try:
    import own_commands
except ImportError:  # there are no commands of the project's own
    own_commands = None

UNKNOWN = -0x3FFFFFFF - 1


def halves(number):
    """Return a number of 64 bits in halves, the low ones first."""
    return [number >> 16 * half & 0xFFFF for half in range(4)]


def satellites_set_the_clock():
    """It is set where it is unknown, or off by a second or more; else it goes on as it is. Each half counts."""
    needs(satellite_clock, "a receiver of satellites")
    mock_time.set_ticks_us(5000000)
    near = (0, 1, 999999, 1000000, 1000001, 1 << 16, 20 << 16, 21 << 16)
    far = (1 << 32, (1 << 32) + 5, 1 << 33, 15 << 44, 1 << 48)
    late = ((3 << 48) + (7 << 32), (5 << 48) + (1 << 40), (6 << 48) + 3)
    for begun in (1700000000000000, 0xFFFF0000, (1 << 32) + 3) + late:  # noqa: RUF005  MicroPython cannot
        for off in [each * sign for each in near + far for sign in (1, -1)]:
            told = begun + off
            if told < 0:
                continue
            values = array("i", [9, 9] + halves(told) + [9])  # noqa: RUF005  MicroPython cannot
            for is_known in (True, False):
                words = array("i", [7] + [0] * 18 + [7])
                words[1:5] = array("i", halves(3000000))
                words[5:9] = array("i", halves(begun - 1000000))
                words[9], words[10] = 4000000, 4000  # a second ago
                if not is_known:
                    words[5] = UNKNOWN
                satellite_clock.set_clock(words, 1, values, 2)
                is_kept = is_known and abs(off) < 1000000
                assert list(words[5:9]) == halves(begun if is_kept else told), (begun, off, is_known)
                assert (words[0], words[19], list(words[1:5])) == (7, 7, halves(4000000))
                assert (words[9], words[10]) == (5000000, 5000)
    mock_time.set_ticks_us(0)


def ground_stations_set_the_clock():
    """By the first SYSTEM_TIME that can be, of a system of which a ground station is heard, while it is unknown."""
    needs(clock_service, "a clock that ground stations set")
    first, last = 1577836800000000, 4102444800000000  # 2020 and 2100
    for told, is_taken in ((0, False), (first, False), (first + 1, True), (last - 1, True), (last, False)):
        craft = new_craft()
        station = craft.ground_station()
        clock = craft.state.clock
        clock.unix_us = None
        station.send(messages.SystemTime, time_unix_usec=told)
        run_passes(craft, 4)
        assert clock.unix_us is None, "nobody is heard yet"
        station.send(messages.Heartbeat, type=dialect.MAV_TYPE_GCS, autopilot=dialect.MAV_AUTOPILOT_INVALID)
        GroundStation(craft.port, 2, 254).send(messages.SystemTime, time_unix_usec=first + 5)
        run_passes(craft, 4)
        assert clock.unix_us is None, "somebody else tells it"
        station.send(messages.SystemTime, time_unix_usec=told)
        run_passes(craft, 4)
        found = clock.unix_us
        assert found is None if not is_taken else 0 <= found - told < 1000000, (told, found)
        station.send(messages.SystemTime, time_unix_usec=first + 7000000000)
        run_passes(craft, 4)
        assert not is_taken or 0 <= clock.unix_us - told < 2000000, "it is known by then"


class Table:
    """A table that takes messages: `finds` is what it says of the next one."""

    def __init__(self, finds, has_call=True):
        self.finds = finds
        self.message = None
        self.taken = []
        self.notes = []
        self.called = self._call if has_call else None
        self.vehicle = self  # which is told what calls it

    def take(self, now_ms):
        """Take it."""
        self.taken.append((self.message, now_ms))
        return self.finds

    def tell(self):
        """Tell of a number."""
        self.notes.append("told")

    def _call(self):
        self.notes.append("called")


def tables_take_in_turn():
    """Each table of a message takes it, tells what is implausible, and calls what is to be called, if it is for it."""
    needs(reception, "a message that sets quantities")
    for finds, has_call, notes in (
        (0, True, []),
        (1, True, ["told", "called"]),
        (2, False, ["told"]),
        (-1, True, ["called"]),
        (-1, False, []),
    ):
        for place in (0, 1):
            tables = [Table(0), Table(0)]
            tables[place] = Table(finds, has_call)
            several = reception.Several(tables[0], tables[1])
            assert several.called is None
            assert several.take(77) == 0
            assert [each.taken for each in tables] == [[(None, 77)]] * 2
            assert (tables[place].notes, tables[1 - place].notes) == (notes, []), (finds, place)
        table = Table(finds, has_call)
        mock_time.set_ticks_us(123000)
        reception.rarely(table)("message")
        assert (table.taken, table.notes, table.message) == ([("message", 123)], notes, None)
    mock_time.set_ticks_us(0)


class Heard:
    """Things that a table asks about senders."""

    def __init__(self, sender):
        from listeners import Listeners  # noqa: PLC0415  the clock has to be in place before

        self.sender = sender
        self.counts = [0, 0, 0, 7]
        self.listeners = Listeners(1000, 2)
        self.listeners.hear(9 << 8 | 190, 0)


def senders_are_judged():
    """Anybody, the vehicle's own system, or systems of which a ground station is heard."""
    needs(reception, "a message that sets quantities")
    for sender, trusted in ((reception.ANY, (7, 8, 9)), (reception.OWN_SYSTEM, (7,)), (reception.GROUND_STATION, (9,))):
        found = [system for system in (7, 8, 9) if reception.is_from(Heard(sender), system)]
        assert tuple(found) == trusted, (sender, found)


class Sensor:
    """The user's sensor of a check."""

    made = []  # noqa: RUF012  of all, for the check

    def __init__(self):
        self.made.append(self)
        self.gives = 1.5

    def read(self):
        """Return what it is told."""
        return self.gives


class Own:
    """Stands in for the user's module."""

    Sensor = Sensor


def the_users_sensor_is_made_anew():
    """Each beginning makes an object of the class, and its numbers are kept in steps within their limits."""
    needs(user_source, "a sensor of the user's")
    sys.modules["own_of_a_check"] = Own
    try:
        source = user_source.UserSource("own_of_a_check", "Sensor", ((10, 1),), ((-20, 20),))
        for count in (1, 2):
            source.begin()
            assert len(Sensor.made) == count
            for gives, kept in ((1.5, 15), (2, 20), (2.1, UNKNOWN), (-2, -20), (-2.1, UNKNOWN), (None, UNKNOWN)):
                Sensor.made[-1].gives = gives
                assert source.poll(0) is True
                assert list(source.values) == [kept], gives
    finally:
        del sys.modules["own_of_a_check"]
        del Sensor.made[:]


def methods_answer():
    """None and True accept, False and a text refuse, NotImplemented is unsupported, and all else is a fault."""
    needs(own_commands, "a command of the project's own")
    accepted, failed = dialect.MAV_RESULT_ACCEPTED, dialect.MAV_RESULT_FAILED

    def given(said):
        if isinstance(said, Exception):
            raise said
        return said

    for said, result in (
        (None, (accepted, None)),
        (True, (accepted, None)),
        (False, (failed, None)),
        ("not now", (failed, "not now")),
        (NotImplemented, (dialect.MAV_RESULT_UNSUPPORTED, None)),
        (0, (failed, "TypeError: returned 0")),
        ([], (failed, "TypeError: returned []")),
        (ValueError("no"), (failed, "ValueError: no")),
        (ValueError(), (failed, "ValueError")),
    ):
        found = own_commands.called(Guard(), given, (said,))
        assert found == result, (said, found)


CHECKS = (
    (satellites_set_the_clock,),
    (ground_stations_set_the_clock,),
    (tables_take_in_turn,),
    (senders_are_judged,),
    (the_users_sensor_is_made_anew,),
    (methods_answer,),
)

if __name__ == "__main__":
    main(CHECKS)
