# Generated from specs/messages/autopilot_version.yaml, specs/messages/battery_cell_voltages.yaml,
#   specs/messages/battery_status.yaml, specs/messages/battery_status_v2.yaml,
#   specs/messages/protocol_version.yaml, specs/smart_battery/codegen.yaml,
#   specs/smart_battery/messages/battery_info.yaml,
#   specs/smart_battery/messages/heartbeat.yaml,
#   specs/smart_battery/messages/smart_battery_info.yaml,
#   specs/smart_battery/parameters.yaml, specs/smart_battery/streams.yaml: do not edit.
# Inputs: 1df7f316e517b18a
"""Sends each message at the rate of its stream, or at the one that a ground station asks for."""

from array import array
from time import ticks_add, ticks_diff, ticks_ms

import messages
import telemetry
from mavlink import Link
from micropython import const

try:
    from scan_viper import LATE, LOOK_MS, take_due
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from scan_plain import LATE, LOOK_MS, take_due

SYSTEM_ID = 1  # at first: SYSID_THISMAV sets it
COMPONENT_ID = 180  # MAV_COMP_ID_BATTERY; COMPID_BATT sets it
VERSION = 2
LONGEST = 140  # bytes of the longest payload
# Lengths of payloads that go out, from the first to the last of each range, without the zeros at the end: a link keeps
# a view of each.
_LENGTHS = ((0, 54), (97, 97), (107, 107))

OFF = -1
_OWN = const(-2)  # as an interval: the own rate of its stream, whatever was asked for of that
_LOOK_MS = const(100)  # from one look at what is watched to the next
_FURTHEST_MS = const(1 << 21)  # nothing is due later: the ticks went half round while nobody asked
_TICKS = const(0x3FFFFFFF)  # they are counted in 30 bits

# Positions in the times that scan_plain reads: those of each message, which stand behind the common ones.
_DUE_MS = const(2)
_LATE_BY = const(3)
_PERIOD = const(4)
_PARTS = const(5)
_STEP = const(4)

# What is sent: the id of each message, its stream (None: on request only) and the shortest interval in microseconds.
_IDS = (0, 147, 369, 370, 372, 148, 300, 54371)
_STREAMS = (0, 1, 2, 3, 3, None, None, None)
_SHORTEST_US = (100000, 100000, 100000, 1000000, 1000000, 100000, 100000, 100000)

# Generations of messages: 1 the old one, 2 the new one, 3 what is sent in any case.
_GENERATIONS = (3, 1, 2, 1, 2, 3, 3, 3)

# Where the payload of each message has the number of the instance that it is about, None where it has none.
_NUMBER_AT = (None, 32, 26, 18, 44, None, None, 0)

# Streams: the number by which REQUEST_DATA_STREAM asks for each (None: it cannot) and the highest rate in Hz.
_DATA_STREAMS = (None, 10, 12, None)
_FASTEST_HZ = (10, 10, 10, 1)

# Where the state has, by instance, whether it is measured, and what is watched for changes.
_BATTERY_MONITORED = 11
_BATTERY_SWAPS_NUMBER = 10


def open_link(stream, known=messages.ALL, system_id=SYSTEM_ID, component_id=COMPONENT_ID):
    """Return a link with the ids and the MAVLink version of this vehicle; `known` are the messages it receives."""
    return Link(stream, system_id, component_id, VERSION, known, LONGEST, None, _LENGTHS)


def _send(encode, state, link):
    link.send_frame(encode(link, state))


def _send_battery(encode, state, link):
    if state.words[_BATTERY_MONITORED]:  # what is not measured is not reported
        link.send_frame(encode(link, state, 0))


def _send_battery_page(encode, state, link):
    if state.words[_BATTERY_MONITORED]:  # what is not measured is not reported
        link.send_frame(encode(link, state, 0, 0))


# What makes the frames of each message, and what sends them.
_ENCODERS = (
    telemetry.encode_heartbeat,
    telemetry.battery_status_frame,
    telemetry.battery_status_v2_frame,
    telemetry.smart_battery_info_frame,
    telemetry.battery_info_frame,
    telemetry.encode_autopilot_version,
    telemetry.encode_protocol_version,
    telemetry.battery_cell_voltages_frame,
)
_SENDERS = (
    _send,
    _send_battery,
    _send_battery,
    _send_battery,
    _send_battery,
    _send,
    _send,
    _send_battery_page,
)


def _announce_battery(encode, state, link, _instance, _page):
    if state.words[_BATTERY_MONITORED]:
        link.send_frame(encode(link, state, 0))


# What is sent at once, a frame each: the place of the message, what sends it, the number of the instance, the page.
# The first _ON_CONNECTION of them are for who appears on the link.
_ANNOUNCED = (
    (3, _announce_battery, 0, 0),
    (4, _announce_battery, 0, 0),
)
_ON_CONNECTION = 2


class _One:
    """In place of a link: counts the frames about the instance with a number, and sends them if it has one."""

    def __init__(self, maker, encode, place, number):
        self._maker = maker
        self._encode = encode
        self._place = place
        self._number = number
        self.link = None
        self.count = 0

    def made(self, _link, *about):
        """Return the frame of an instance, as its encoder does."""
        return self._encode(self._maker, *about)

    def send_frame(self, frame):
        """Send it if it is about that instance. Zeros at the end of a payload are not there."""
        place = self._place + (10 if frame[0] == 0xFD else 6)
        if place < len(frame) - 2 and frame[place] == self._number:
            self.count += 1
            if self.link is not None:
                self.link.send_frame(frame)


class Streams:
    """The streams of one link, all due at once when they start.

    A message's rate is that of its stream: fixed, or set by a parameter. request() overrides it for a stream until the
    parameter changes, set_interval() for a message until it is called again.

    Of two generations of messages only the chosen one is streamed and announced; send() and set_interval() reach both.
    """

    def __init__(self, state, link, budget=None):
        self._state = state
        self._link = link
        # How many messages may go out in this pass, which all stations of the link share, and how many were left out.
        self._budget = [0x3FFFFFFF, 0] if budget is None else budget
        self.has_waited = False  # whether something is due for which there was no room
        self._next_ms = ticks_ms()  # when something is due, or is looked at again
        due_ms = self._next_ms & _TICKS
        self._times = array("i", [len(_IDS), _FURTHEST_MS] + [due_ms, 0, 0, 0] * len(_IDS))  # scan_plain says what
        self._interval_us = array("i", [0] * len(_IDS))  # asked for; 0 is the rate of the stream
        self._asked_hz = array("i", [OFF] * len(_FASTEST_HZ))  # asked for; -1 is the stream's own rate
        self._parameters = state.parameters
        self._changes = state.parameters.changes
        self._steps = self._parameter_steps()
        self._settle_all()
        self._waits = bytearray(len(_ANNOUNCED))  # 1: to be sent in one of the next passes
        self._is_waiting = False  # whether any announcement is to be sent
        self._seen = [state.words[_BATTERY_SWAPS_NUMBER]]
        self._looked_ms = ticks_add(self._next_ms, -_LOOK_MS)  # before anything is announced
        self.connect()

    def wait_ms(self, now_ms):
        """Return for how long run() and announce() have nothing to do, at most LOOK_MS."""
        ahead_ms = ticks_diff(self._next_ms, now_ms)
        if not 0 < ahead_ms <= LOOK_MS or self._parameters.changes != self._changes or self._is_waiting:
            return 0
        return ahead_ms

    def run(self, now_ms):
        """Send what is due; call it in every pass of the main loop with ticks_ms(), unless wait_ms() is not 0."""
        if self._parameters.changes != self._changes:
            self._follow_parameters(now_ms)
        if not 0 <= ticks_diff(now_ms, self._looked_ms) < _LOOK_MS:
            self._looked_ms = now_ms
            self._look_for_changes()
        self._next_ms = now_ms  # also if something raises, or has to wait
        times = self._times
        budget = self._budget
        left = budget[0]
        while True:
            index = take_due(times, now_ms, left)
            if index < 0:
                break
            if left <= 0:  # what comes first goes first
                self.has_waited = True
                return
            if index >= LATE:
                index -= LATE
                if self.has_waited:
                    budget[1] += 1
            if self._is_waiting and not self._is_off(index) and self._is_announced_soon(index):
                continue
            budget[0] = left = left - 1
            _SENDERS[index](_ENCODERS[index], self._state, self._link)
        self.has_waited = False
        self._next_ms = ticks_add(now_ms, -index)

    def connect(self):
        """Let everything be announced that who appears on the link has to know."""
        for place in range(_ON_CONNECTION):
            self._waits[place] = 1
            self._is_waiting = True

    def announce(self):
        """Send at most one of the messages that wait to be announced; call it after run() while the port is up."""
        if not self._is_waiting:
            return
        for place in range(len(_ANNOUNCED)):
            if self._waits[place]:
                self._waits[place] = 0  # before it can raise: so a faulty one goes
                if self._is_off(_ANNOUNCED[place][0]):
                    continue
                if self._send_announced(place):
                    self._pass_over(_ANNOUNCED[place][0])
                else:
                    self._waits[place] = 1
                return
        self._is_waiting = False

    def _look_for_changes(self):
        """Let what tells about an instance be announced where a quantity of the instance has changed."""
        state = self._state
        seen = self._seen
        if state.words[_BATTERY_SWAPS_NUMBER] == seen[0]:
            return
        value = state.words[_BATTERY_SWAPS_NUMBER]
        if value != seen[0]:
            seen[0] = value
            self._await(3, 0)  # SMART_BATTERY_INFO
            self._await(4, 0)  # BATTERY_INFO

    def _await(self, index, instance):
        for place in range(len(_ANNOUNCED)):
            if _ANNOUNCED[place][0] == index and _ANNOUNCED[place][2] == instance:
                self._waits[place] = 1
                self._is_waiting = True

    def _pass_over(self, index):
        """Let a message that was announced just now not be sent again because it is due as well."""
        times = self._times
        at = _STEP * index
        now_ms = ticks_ms() & _TICKS
        if times[at + _PARTS] and not 0 < times[at + _DUE_MS] - now_ms & _TICKS <= _FURTHEST_MS:
            times[at + _DUE_MS] = now_ms + times[at + _PERIOD] // times[at + _PARTS] & _TICKS

    def _is_off(self, index):
        """Return whether a message is left out: by its generation, or because a ground station has switched it off."""
        return self._interval_us[index] == OFF or not self._is_chosen(index)

    def _is_announced_soon(self, index):
        """Return whether a message waits; then all of its instances do, so that its stream need not send it, too."""
        found = False
        for place in range(len(_ANNOUNCED)):
            if _ANNOUNCED[place][0] == index and self._waits[place]:
                found = True
        if found:
            for place in range(len(_ANNOUNCED)):
                if _ANNOUNCED[place][0] == index:
                    self._waits[place] = 1
        return found

    def _send_announced(self, place):
        """Send one frame; return False if the port did not take it, so that it is not counted as lost either."""
        link = self._link
        sequence = link.sequence
        errors = link.tx_errors
        announced = _ANNOUNCED[place]
        announced[1](_ENCODERS[announced[0]], self._state, link, announced[2], announced[3])
        if link.tx_errors == errors:
            self._budget[0] -= 1
            return True
        link.sequence = sequence
        link.tx_errors = errors
        return False

    def send(self, message_id, number=0):
        """Send a message once, each of its tables and instances; return whether this vehicle has it.

        With a number it is sent about the instance alone that has it in the message, where it is about instances.
        """
        return self._send_about(message_id, number, self._link)

    def has(self, message_id, number):
        """Return whether a message would be about the instance with a number now, or about none; 0 stands for all."""
        return self._send_about(message_id, number, None)

    def _send_about(self, message_id, number, link):
        found = False
        for index in range(len(_IDS)):
            if _IDS[index] == message_id:
                if number and _NUMBER_AT[index] is not None:
                    one = _One(self._link, _ENCODERS[index], _NUMBER_AT[index], number)
                    one.link = link
                    _SENDERS[index](one.made, self._state, one)
                    found = found or one.count > 0
                    continue
                found = True
                if link is not None:
                    self._send(index)
        return found

    def is_withheld(self, _message_id):
        """Return whether nothing of a message goes out now, because what it tells is unknown."""
        return False

    def set_interval(self, message_id, interval_us):
        """Send a message in this interval from now on: microseconds, -1 for never, 0 for its stream's own rate.

        It holds for each of its tables. Shorter ones than allowed become the shortest. False: this vehicle has no such
        message.
        """
        found = False
        for index in range(len(_IDS)):
            if _IDS[index] == message_id and interval_us >= OFF:
                found = True
                self._set_interval(index, interval_us)
        return found

    def _set_interval(self, index, interval_us):
        if interval_us > 0:
            interval_us = min(max(interval_us, _SHORTEST_US[index]), 0x3FFFFFFF)
        self._interval_us[index] = interval_us or _OWN
        self._restart(index, ticks_ms())

    def interval_us(self, message_id):
        """Return the interval of a message in microseconds, -1 while it is off, 0 if this vehicle does not have it.

        Of several tables it is the shortest one.
        """
        shortest_us = 0
        for index in range(len(_IDS)):
            if _IDS[index] == message_id:
                at = _STEP * index
                parts = self._times[at + _PARTS]
                interval_us = self._times[at + _PERIOD] * 1000 // parts if parts else OFF
                if shortest_us <= 0 or 0 < interval_us < shortest_us:
                    shortest_us = interval_us
        return shortest_us

    def request(self, data_stream, rate_hz):
        """Send a stream at another rate, 0 for never, until its parameter changes; number 0 means all streams.

        The numbers are those of MAV_DATA_STREAM. False: this vehicle has no such stream.
        """
        found = False
        for stream in range(len(_FASTEST_HZ)):
            number = _DATA_STREAMS[stream]
            if number is not None and data_stream in (0, number):
                found = True
                self._override(stream, min(rate_hz, _FASTEST_HZ[stream]), ticks_ms())
        return found

    def _override(self, stream, rate_hz, now_ms):
        is_changed = self._asked_hz[stream] != rate_hz
        self._asked_hz[stream] = rate_hz
        for index in range(len(_IDS)):
            if _STREAMS[index] == stream:
                if self._interval_us[index] != 0:
                    self._interval_us[index] = 0
                    is_changed = True
                if is_changed:  # ground stations repeat their requests: that is no reason to start anew
                    self._restart(index, now_ms)

    def _parameter_steps(self):
        """Return what the parameters of the streams are, in steps."""
        parameters = self._state.parameters
        return [parameters.batt_status_rate, parameters.batt_v2_rate]

    def _follow_parameters(self, now_ms):
        """Drop what was asked for where the stream's parameter has changed."""
        self._changes = self._parameters.changes
        self._settle_all()
        for index in range(len(_IDS)):
            if self._times[_STEP * index + _LATE_BY] == OFF:  # its stream may be on by now
                self._restart(index, now_ms)
        steps = self._parameter_steps()
        if steps[0] != self._steps[0]:
            self._override(1, OFF, now_ms)
            self._restart_stream(1, now_ms)
        if steps[1] != self._steps[1]:
            self._override(2, OFF, now_ms)
            self._restart_stream(2, now_ms)
        self._steps = steps

    def _restart_stream(self, stream, now_ms):
        for index in range(len(_IDS)):
            if _STREAMS[index] == stream:
                self._restart(index, now_ms)

    def _restart(self, index, now_ms):
        self._settle(index)
        self._next_ms = now_ms
        self._times[_STEP * index + _DUE_MS] = now_ms & _TICKS
        self._times[_STEP * index + _LATE_BY] = 0

    def _settle_all(self):
        for index in range(len(_IDS)):
            self._settle(index)

    def _settle(self, index):
        """Find out the period of a message: what was asked for, or that of its stream."""
        numerator = self._interval_us[index]
        denominator = 1000 if numerator > 0 else 0
        stream = _STREAMS[index]
        if not (numerator > 0 or numerator == OFF or stream is None or not self._is_chosen(index)):
            denominator = OFF if numerator == _OWN else self._asked_hz[stream]
            numerator = 1000
            if denominator < 0:
                numerator, denominator = self._own_period(stream)
        self._times[_STEP * index + _PERIOD] = numerator
        self._times[_STEP * index + _PARTS] = denominator

    def _is_chosen(self, index):
        """Return whether the generation of a message is sent without being asked for."""
        parameters = self._state.parameters
        # BATT_REPORT is 0 for the old ones, 1 for the new ones, 2 for both (FR-00072.2)
        return _GENERATIONS[index] & (parameters.batt_report + 1) != 0

    def _own_period(self, stream):
        """Return the period of a stream in milliseconds, numerator and denominator, which is 0 for one that is off."""
        if stream == 0:  # HEARTBEAT: 1 Hz (FR-00074.1)
            return 1000, 1
        if stream == 1:  # EXTRA1: BATT_STATUS_RATE sets the rate (FR-00074.3)
            return 10000, self._state.parameters.batt_status_rate
        if stream == 2:  # EXTRA3: BATT_V2_RATE sets the rate (FR-00074.3)
            return 10000, self._state.parameters.batt_v2_rate
        if stream == 3:  # INFO: 0.05 Hz (FR-00074.4)
            return 20000, 1
        return 0, 0

    def _send(self, index):
        _SENDERS[index](_ENCODERS[index], self._state, self._link)
