# ruff: noqa: T201  what is printed is the answer
"""Single passes of the main loop of any project, for benchmarks/loop.py, which says what to do in a file of JSON.

The clock goes on when it is told to: its ticks are functions in C as those of the board. Before and after each pass
that counts the environment is written to, which valgrind notices; see counting.py.
"""

import gc
import io
import json
import os
import sys
from time import sleep_ms, sleep_us, ticks_add, ticks_diff

import micropython


class Clock:
    """The module `time`. Its ticks are what functions in C return that tell a number which was told to them.

    That is how far code is optimised, which here does not matter any more, and the place in a stream of bytes.
    """

    _ms = io.BytesIO(b"")
    ticks_us, ticks_ms = micropython.opt_level, _ms.tell
    sleep_ms, sleep_us, ticks_add, ticks_diff = sleep_ms, sleep_us, ticks_add, ticks_diff

    def go_to(self, now_us):
        """Let it be so late."""
        micropython.opt_level(now_us)
        self._ms.seek(now_us // 1000)


clock = Clock()
sys.modules["time"] = clock

import machine  # noqa: E402


class Converter:
    """An ADC that always reads the same, with a function in C as on the board."""

    def __init__(self, _pin, **_settings):
        count = io.BytesIO(b"")
        count.seek(48000)
        self.read_u16 = count.tell


machine.ADC = Converter

from texts import Texts  # noqa: E402
from vehicle import Vehicle  # noqa: E402

HERE, NOTHING = (True,), ()
_ROOM = 20000  # bytes, more than the frames of a pass


class Port:
    """A port that takes everything, with a function in C as a UART; `frame` is what arrives, once."""

    name = "port"
    is_up = True
    frame = b""

    def __init__(self):
        self._taken = io.BytesIO(bytearray(_ROOM))
        self.write = self._taken.write

    def forget(self):
        """Forget what it has taken."""
        self._taken.seek(0)

    def sent(self):
        """Return how many frames it has taken, and how many bytes."""
        size = self._taken.tell()
        taken = self._taken.getvalue()
        frames = at = 0
        while at < size:
            head, signature = (10, 13 * (taken[at + 2] & 1)) if taken[at] == 0xFD else (6, 0)
            at += head + taken[at + 1] + 2 + signature
            frames += 1
        return frames, size

    def look(self, _wait_ms):
        """Return something while the frame is there; ipoll() of a board takes as long."""
        return HERE if self.frame else NOTHING

    def readinto(self, buffer):
        """Let the frame arrive."""
        length = len(self.frame)
        if length:
            buffer[:length] = self.frame
            self.frame = b""
        return length

    def read(self):
        """Let the frame arrive as a datagram."""
        frame = self.frame
        if frame:
            self.frame = b""
        return frame

    def poll(self, _now_ms):
        """Do nothing: a pass ends."""


class Passes:
    """Does the steps of a plan, each a list of the name of a method and what it is given."""

    def __init__(self, plan):
        self.port = Port()
        if plan["datagrams"]:
            from stations import Stations  # noqa: PLC0415  which only such ports have

            Port.stations = Stations
            self.port.home = "home", 1
            self.port.ends = [None, ("here", 1)]
        self.vehicle = Vehicle(ports=[self.port], texts=Texts(lambda *_words: None))
        self.period_us = plan["control_us"]
        self.now_us = 0

    def go(self, until_us):
        """Have all passes that are due before a time."""
        while self.now_us < until_us:
            self.turn()

    def turn(self):
        """Have the next pass."""
        clock.go_to(self.now_us)
        self.port.forget()
        self.vehicle.run_pass()
        self.now_us += self.period_us

    def count(self, name):
        """Have the next pass, which counts."""
        clock.go_to(self.now_us)
        self.port.forget()
        run = self.vehicle.run_pass
        os.putenv("MARK", "")
        run()
        os.putenv("MARK", "")
        self.now_us += self.period_us
        print(name, *self.port.sent())

    def count_call(self, name, owner, method, *arguments):
        """Call a method of a part of the vehicle, which counts; `owner` is its path."""
        part = self.vehicle
        for attribute in owner:
            part = part[attribute] if isinstance(attribute, int) else getattr(part, attribute)
        call = getattr(part, method)
        arguments = [self.vehicle.board if argument == "board" else argument for argument in arguments]
        os.putenv("MARK", "")
        call(*arguments)
        os.putenv("MARK", "")
        print(name, 0, 0)

    def count_nothing(self, name):
        """Count what counting takes."""
        run = clock.ticks_us
        os.putenv("MARK", "")
        run()
        os.putenv("MARK", "")
        print(name, 0, 0)

    def interval(self, message_id, interval_us):
        """Let a message be sent in this interval from now on."""
        self.vehicle.connections[0]._is_idle = False  # or it would look only some passes later
        for station in self.vehicle.connections[0].stations:
            if not station.streams.set_interval(message_id, interval_us):
                raise SystemExit("no message " + str(message_id))

    def arrive(self, frame, sender):
        """Let the bytes of a frame arrive in the next pass of the links."""
        self.port.frame = bytes(frame)
        if sender:
            self.port.ends[1] = tuple(sender)

    def job(self, period_us):
        """Let a job be there that does nothing; from now on a pass runs all that are due."""
        self.vehicle.scheduler._most = 9
        self.vehicle.scheduler.every(period_us, self.nothing, "nothing")

    def nothing(self):
        """Do nothing."""

    def know(self, component, instance, name, value):
        """Let a quantity of the state be known."""
        part = getattr(self.vehicle.state, component)
        setattr(part if instance is None else part[instance], name, value)


with open(sys.argv[1]) as file:
    plan = json.load(file)
gc.collect()
gc.disable()
passes = Passes(plan)
for step in plan["steps"]:
    getattr(passes, step[0])(*step[1:])
