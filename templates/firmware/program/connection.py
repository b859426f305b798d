"""One port of the vehicle: what arrives is answered, and what is due is sent, to each station at its other end.

Nothing here waits, and a pass of the main loop does a limited share of the work that a port brings. A pass in which
nothing arrives and no text is new allocates nothing; what arrives is taken in without allocating too.
"""

from time import ticks_add, ticks_diff

import dialect
import messages
from inbox import Inbox
from micropython import const
from services import Services
from station import Station, TextSender

_MESSAGES = const(2)  # the most that are read in a pass
_REPLIES = const(8)  # the most that wait for the port
_QUIET_MS = const(1000)  # between two texts about faults
_FORGET_MS = const(1000)  # from one look at who is silent to the next
_LOOK_MS = const(100)  # no later the streams and the port have a turn
_ARRIVED = const(0)  # what comes first in a pass: what arrived,
_STREAMS = const(1)  # or streams, and nothing is taken in,
_OTHERS = const(2)  # or what else waits, and then streams
_TO_READ = const(2)  # what poll() of a port says where it is to be read, though look() says nothing
_NUMBER = const(6)  # where the state of a link has the id of a message, frames_plain says more,
_WORKED = const(15)  # what is limited in a pass,
_SENDER = const(23)  # and system << 8 | component that it came from
_HEARTBEAT = messages.Heartbeat.ID
_TYPE = const(4)  # where HEARTBEAT has it
_AUTOPILOT = const(5)


class Connection:
    """Services and streams of one port.

    run(now_ms) does one pass, at time.ticks_ms(): read, answer, send what is due. It returns whether more is left of
    that, to be done in the next pass. It raises nothing: a fault ends the part of the pass that it is in. A pass with
    nothing to do finds that out from few variables.

    A pass takes in and sends vehicle.MESSAGES messages, all stations together. Where all of them arrived, what is to be
    sent comes first in the next one, and so does what had to wait: streams before what arrives, after them what else
    waits, and then what arrives again.

    `port` reads and writes bytes (see ports), `link` makes frames of messages and back: it writes to `port`, and has
    been given services.receivable() as the messages that it receives. `make_streams` returns the streams of a station,
    given the list of how many messages they may send in this pass and how many they left out.

    A port that has look(0) is read where that returns something. Its poll() is called ten times a second, and in the
    next pass where it returns that it has more to do: True, or 2 where it is to be read in that pass.
    A port that has `ends` brings what keeps its stations apart: frames go to ends[0], what was read came from ends[1].
    At the other end of another port there is one station: all that hear what goes out there.

    `inbox` has the messages that arrive. `station` is the one that is served just now, who gets what send() and
    deliver() send, and `streams` are its. What sets quantities is taken after the services, by the Reception that
    `tables` has by the id of its message. `twins`, unless None, looks at what comes from the system of the vehicle.
    `faults` counts exceptions that were caught, `lost_replies` replies that a port did not take for too long.
    """

    def __init__(self, vehicle, port, link, make_streams):
        self.port = port
        self.link = link
        self.faults = 0
        self.lost_replies = 0
        # Each frame says whom it comes from.
        frame = link.encode(messages.Heartbeat(unknown=False))
        at = 5 if link.version == 2 else 3
        self.system_id = frame[at]
        self.component_id = frame[at + 1]
        self._log = vehicle.texts
        self._budget = [0, 0]  # messages that this pass may still take in and send, and those that were left out
        self._make_streams = make_streams
        self._ends = getattr(port, "ends", None)
        if self._ends is None:
            self._stations = None
            self.stations = [self._new_station()]
        else:
            self._stations = port.stations(port, self._new_station, vehicle.SILENCE_MS)
            self.stations = self._stations.served
        self.station = self.stations[0]
        self.station.text = 0  # texts from before there was a link are sent, too
        self.streams = self.station.streams
        self.services = Services(vehicle, self)
        self.inbox = Inbox(port, link)
        self._texts = TextSender(self, vehicle.texts)
        self._is_idle = False  # whether nothing was left to do in the last pass
        self._quiet_from_ms = None
        self._forgot_ms = 0
        self.twins = None
        self.tables = {}
        self._begin(vehicle)

    def _begin(self, vehicle):
        turn = self._passes(vehicle, vehicle.parameters, getattr(self.port, "look", _perhaps))
        next(turn)
        self.run = turn.send

    # A generator keeps variables between passes, which are found at once and need no heap; and it catches an exception
    # without the heap, where a function would put all of its variables there. An interrupt or a restart ends it: a
    # program that goes on afterwards makes a new one.

    def _passes(self, vehicle, parameters, look):  # noqa: C901, PLR0912, PLR0915  calls are dear
        """Do a pass for each time.ticks_ms() that is sent, and yield whether more is left, for ever."""
        add, diff = ticks_add, ticks_diff
        log = self._log
        budget = self._budget
        most = vehicle.MESSAGES
        buffered = self.link._state  # frames_plain says what it holds
        system_id = self.system_id
        is_alone = self._stations is None
        takers, tables = self.services._takers, self.tables
        stations, count = self.stations, len
        is_left = False  # whether more messages have arrived
        first = turn = _ARRIVED  # what comes first in the next pass, and in this one
        changes = text = -1  # of parameters, and of texts, when the last pass began to send
        next_ms = now_ms = yield  # when something is due
        try:
            while True:
                for _ in look(0):
                    is_left = True
                is_more = False
                is_due = not (self._is_idle and 0 < diff(next_ms, now_ms) <= _LOOK_MS)
                if is_due or is_left or log.last != text or parameters.changes != changes:
                    self._is_idle = True  # unless something is left
                    budget[0] = most
                    turn = first
                    first = _ARRIVED
                    if is_left and turn == _ARRIVED:
                        buffered[_WORKED] = taken = 0
                        while is_left and taken < _MESSAGES and budget[0] > 0:
                            taken += 1
                            budget[0] -= 1
                            try:
                                message = self.inbox.next(now_ms)
                                if message is not None:
                                    number = buffered[_NUMBER]
                                    if (buffered[_SENDER] >> 8 != system_id or self.is_other(message)) and (
                                        is_alone or self._has_place(message, number, now_ms)
                                    ):
                                        found = takers.get(number)
                                        if found is not None:
                                            if found[1]:
                                                self.services.handle(message)
                                            else:  # it is for everybody
                                                found[0](message)
                                        take = message._take
                                        found = 0 if take is None else take(now_ms)
                                        if found:
                                            if found > 0:
                                                tables[number].tell()
                                            found = tables[number].called
                                            if found is not None:
                                                vehicle.reception = tables[number]
                                                found()
                            except Exception as error:
                                self._note(error, now_ms)
                            is_left = buffered[0] != buffered[1]
                            if budget[0] > 0:  # or the next pass looks
                                for _ in look(0):
                                    is_left = True
                        if budget[0] <= 0:  # what is to be sent comes first in the next pass
                            first = _STREAMS
                            next_ms = now_ms
                            now_ms = yield True
                            continue
                    changes = parameters.changes
                    text = log.last
                    least_ms = _LOOK_MS
                    is_due = is_due and turn == _ARRIVED and count(stations) == 1  # else ask each station
                    for station in stations:
                        if (
                            is_due
                            or station.waiting
                            or station.text != text
                            or station.said is not None
                            or station.parameter is not None
                        ):
                            wait_ms = 0
                        else:
                            wait_ms = station.streams.wait_ms(now_ms)
                        if not wait_ms:
                            if station is not self.station:
                                self.turn_to(station)
                            if turn != _OTHERS:
                                try:
                                    station.streams.run(now_ms)
                                except Exception as error:
                                    self._note(error, now_ms)
                                if budget[0] <= 0:
                                    break
                            try:
                                if budget[0] > 0 and station.waiting:
                                    self._send_waiting(station.waiting)
                                if budget[0] > 0 and self.port.is_up:
                                    station.streams.announce()
                            except Exception as error:
                                self._note(error, now_ms)
                            try:
                                if budget[0] > 0:
                                    self.services.run()
                                if budget[0] > 0:
                                    self._texts.run(station)
                            except Exception as error:
                                self._note(error, now_ms)
                            if turn == _OTHERS:
                                try:
                                    station.streams.run(now_ms)
                                except Exception as error:
                                    self._note(error, now_ms)
                            if budget[0] <= 0:
                                break
                            wait_ms = self._wait_ms(station, now_ms)
                        if wait_ms < least_ms:  # noqa: PLR1730  min() takes longer
                            least_ms = wait_ms
                    if budget[0] > 0:
                        is_more = is_left
                        left = self._end_pass(now_ms)
                        if left:
                            least_ms = 0
                            is_left = is_left or left == _TO_READ
                        next_ms = add(now_ms, least_ms)
                    else:  # whether anything is left is found out in the next pass
                        is_left_out = self.streams.has_waited if count(stations) == 1 else self._pass_on(now_ms)
                        if is_left_out and turn == _ARRIVED:
                            first = _STREAMS
                        elif turn != _OTHERS:
                            first = _OTHERS
                        next_ms = now_ms
                        is_more = True
                now_ms = yield is_more
        except BaseException:
            self._begin(vehicle)
            raise

    def turn_to(self, station):
        """Let what is sent go to a station from now on."""
        self.station.sequence = self.link.sequence
        self.link.sequence = station.sequence
        self.station = station
        self.streams = station.streams
        if self._ends is not None:
            self._ends[0] = station.address or self.port.home

    def send(self, message):
        """Send a message to the station at hand; return whether the port took it.

        If not, it may be sent again: the receiver does not count it as lost. ValueError: it does not fit the link.
        """
        link = self.link
        sequence = link.sequence
        errors = link.tx_errors
        if link.send(message):
            self._budget[0] -= 1
            return True
        link.sequence = sequence
        link.tx_errors = errors
        return False

    def deliver(self, send, argument):
        """Call send(argument), now and in later passes until it returns True: replies that must not get lost.

        They keep their order. Of too many, the oldest is given up: who asked has to ask again anyway.
        """
        if self.station.waiting or not send(argument):
            self._keep(self.station, (send, argument))

    def deliver_to_others(self, asking, send, argument):
        """Deliver to all stations of this connection, without the one that is asking."""
        for station in self.stations:
            if station is not asking:
                self._keep(station, (send, argument))

    def report(self):
        """Say what could not be sent since the last time."""
        if self._budget[1]:
            self._log("warning:", self.port.name, "is full, messages left out:", self._budget[1])
            self._budget[1] = 0
        if self._stations is not None and self._stations.refused:
            self._log("warning:", self.port.name, "has no place for another station, frames:", self._stations.refused)
            self._stations.refused = 0

    def _new_station(self):
        return Station(self._make_streams(self._budget), self._log.last)

    def _keep(self, station, reply):
        if len(station.waiting) == _REPLIES:
            station.waiting.pop(0)
            self.lost_replies += 1
        station.waiting.append(reply)
        self._is_idle = False

    def is_other(self, message):
        """Return whether another component has sent a message of the system of this vehicle."""
        component = self.link._state[_SENDER] & 0xFF
        if self.twins is not None:
            self.twins.look_at(message, component)
        return component != self.component_id

    def _has_place(self, message, number, now_ms):
        """Turn to the station that has sent a message; return False where there is no place for it."""
        if (  # no vehicle is a station
            number == _HEARTBEAT
            and message.wire[_TYPE] != dialect.MAV_TYPE_GCS
            and message.wire[_AUTOPILOT] != dialect.MAV_AUTOPILOT_INVALID
        ):
            return True
        station = self.station
        ends = self._ends
        if station.is_heard and station.address is ends[0] and station.address == ends[1]:
            station.heard_ms = now_ms  # most often it is the one at hand
            return True
        station = self._stations.hear(ends[1], now_ms)
        if station is None:
            return False
        if station is not self.station or ends[0] is not station.address:
            self.turn_to(station)
        return True

    def _wait_ms(self, station, now_ms):
        """Return for how long a station has nothing to do, at most _LOOK_MS."""
        if (
            station.waiting
            or station.text != self._log.last
            or station.said is not None
            or station.parameter is not None
        ):
            return 0
        return station.streams.wait_ms(now_ms)

    def _end_pass(self, now_ms):
        """End a pass in which there was something to do; return whether the port has something left, as it says."""
        if not 0 <= ticks_diff(now_ms, self._forgot_ms) < _FORGET_MS:
            self._forget(now_ms)
        return self.port.poll(now_ms)

    def _forget(self, now_ms):
        """Forget who is silent, and when a fault was told long ago: such ticks would seem to lie ahead one day."""
        self._forgot_ms = now_ms
        if self._quiet_from_ms is not None and ticks_diff(now_ms, self._quiet_from_ms) >= _QUIET_MS:
            self._quiet_from_ms = None
        self.services.listeners.forget_silent(now_ms)
        self.services.components.forget_silent(now_ms)
        if self._stations is not None:
            self._stations.forget_silent(now_ms)

    def _pass_on(self, now_ms):
        """Let others than the station at hand have their share first next time; return whether streams may wait."""
        stations = self.stations
        while stations[-1] is not self.station:
            stations.append(stations.pop(0))
        for station in stations:
            if station is not self.station and not station.streams.wait_ms(now_ms):
                station.streams.has_waited = True
        return True

    def _send_waiting(self, waiting):
        while waiting and self._budget[0] > 0:
            reply = waiting.pop(0)  # taken out before it can raise: a faulty reply is not tried again
            if not self.port.is_up:
                self.lost_replies += 1  # nobody expects it by the time that the port is up again
            elif not reply[0](reply[1]):
                waiting.insert(0, reply)
                return

    def _note(self, error, now_ms):
        self.faults += 1
        if self._quiet_from_ms is None or ticks_diff(now_ms, self._quiet_from_ms) >= _QUIET_MS:
            self._quiet_from_ms = now_ms
            self._log("error:", self.port.name, "fault", repr(error))


def _perhaps(_wait_ms):
    """Stand in for look() of a port that cannot tell."""
    return (True,)
