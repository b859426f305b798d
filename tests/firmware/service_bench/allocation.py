"""Counts on MicroPython what passes of a connection allocate; one line of JSON on standard input, one as the answer."""

import gc
import json
import sys

import micropython
from vehicle_bench import Bench


class Arrivals:
    """Bytes that arrive in each pass, without a piece of memory for each of them."""

    def __init__(self, port, data, count):
        self._data = data
        self._count = count
        self._at = 0
        self.taken = 0
        port.readinto = self.readinto
        port.write = self.write

    def readinto(self, buffer):
        """Read up to `count` bytes, from the start again behind the end."""
        count = 0
        while count < self._count:
            buffer[count] = self._data[self._at]
            self._at = (self._at + 1) % len(self._data)
            count += 1
        self.taken += count
        return count

    def write(self, frame):
        """Take everything."""
        return len(frame)


def allocated(bench, passes):
    """Return the bytes that passes allocate; first with the heap locked, which raises at the first of them."""
    bench.passes(500)
    gc.collect()
    micropython.heap_lock()
    bench.passes(passes)
    micropython.heap_unlock()
    before = micropython.mem_total()
    bench.passes(passes)
    return micropython.mem_total() - before - control(passes)


def control(passes):
    """Return what measuring itself takes: nothing, or the test is none."""
    before = micropython.mem_total()
    Bench.passes(EMPTY, passes)
    return micropython.mem_total() - before


def kept(bench, passes):
    """Return by how many bytes the heap grows over passes in which messages are answered."""
    bench.passes(passes)
    gc.collect()
    before = gc.mem_alloc()
    bench.passes(passes)
    gc.collect()
    return gc.mem_alloc() - before


class Nobody:
    """A vehicle without connections."""

    connections = ()


class Empty:
    """A bench with nothing in it."""

    vehicle = Nobody()


class Forgetful:
    """A list that keeps nothing."""

    def append(self, item):
        """Forget it."""


EMPTY = Empty()
asked = json.loads(sys.stdin.readline())
quiet = Bench()
Arrivals(quiet.port, b"\0", 0)
noisy = Bench()
noise = Arrivals(noisy.port, bytes.fromhex(asked["noise"]), asked["count"])
busy = Bench()
busy.vehicle.calls = Forgetful()
Arrivals(busy.port, bytes.fromhex(asked["requests"]), asked["count"])
results = {
    "quiet": allocated(quiet, 2000),
    "noise": allocated(noisy, 2000),
    "kept": kept(busy, 4000),
    "taken": noise.taken,
    "polls": quiet.port.polls,
    "answered": busy.connection.link.received,
    "faults": [bench.connection.faults for bench in (quiet, noisy, busy)],
}

sys.stdout.write(json.dumps(results) + "\n")
