"""Streams of one link: HEARTBEAT at 1 Hz, two batteries, one of once a day, and messages sent on request only."""

import time

import messages

_OWN_US = {0: 1000000, 24: 86400000000, 147: 500000, 148: -1, 300: -1}


class Streams:
    """Sends HEARTBEAT itself; keeps what it was asked for."""

    def __init__(self, link, calls):
        self._link = link
        self._calls = calls
        self._intervals = dict(_OWN_US)
        self._heartbeat = messages.Heartbeat()
        self._batteries = (messages.BatteryStatus().update(id=0), messages.BatteryStatus().update(id=1))
        self._version = messages.AutopilotVersion().update(flight_sw_version=0x01020304)
        self._protocol = messages.ProtocolVersion().update(version=200, min_version=100, max_version=200)
        self._due_ms = time.ticks_ms()
        self.is_broken = False
        self.has_waited = False

    def wait_ms(self, now_ms):
        """Return for how long nothing is due, at most 100 ms."""
        return 0 if self.is_broken else min(max(time.ticks_diff(self._due_ms, now_ms), 0), 100)

    def run(self, now_ms):
        """Send what is due."""
        if self.is_broken:
            raise ValueError("broken stream")
        if time.ticks_diff(now_ms, self._due_ms) >= 0:
            self._due_ms = time.ticks_add(self._due_ms, 1000)
            self._link.send(self._heartbeat)

    def connect(self):
        """Note that somebody has appeared."""
        self._calls.append(["connect"])

    def announce(self):
        """Nothing waits."""

    def has(self, message_id, number):
        """Return whether a message would be about an instance; 0 is all."""
        return message_id in self._intervals and (message_id != 147 or number < 2)

    def send(self, message_id, number=0):
        """Send all instances of a message once, or the one with a number."""
        if message_id == 147:
            for battery in self._batteries:
                if number in (0, battery.id):
                    self._link.send(battery)
        elif message_id in self._intervals:
            self._link.send({0: self._heartbeat, 148: self._version, 300: self._protocol}[message_id])
        return message_id in self._intervals

    def set_interval(self, message_id, interval_us):
        """Set an interval; 0 is the stream's own."""
        if message_id not in self._intervals:
            return False
        self._intervals[message_id] = interval_us or _OWN_US[message_id]
        return True

    def is_withheld(self, _message_id):
        return False

    def interval_us(self, message_id):
        """Return the interval, -1 if off, 0 if there is no such message."""
        return self._intervals.get(message_id, 0)

    def request(self, data_stream, rate_hz):
        """Keep the request."""
        self._calls.append(["request", data_stream, rate_hz])
        return True
