"""The measurements of `codegen bench` on the board, with the program that is there; nothing of it is stored.

`FACTS` is filled first: what the program has. Each call prints lines of JSON: [name, value] is a measure, [name, about,
value] one of several that such a measure sums up, ["", text] something to be told.
"""

import gc
import json
import time

FACTS = {}


class Port:
    """Takes whatever is sent, and brings nothing."""

    def __init__(self):
        self.name = "bench"
        self.is_up = True
        self.problem = None
        self.dropped = 0

    def write(self, frame):
        """Take a frame."""
        return len(frame)

    def readinto(self, _buffer):
        """Bring nothing."""
        return 0

    def read(self):
        """Bring nothing."""

    def poll(self, _now_ms):
        """Do nothing."""


def say(*words):
    """Print one line."""
    print(json.dumps(words))


def silent(*_words):
    """Log nothing."""


def begin():
    """Make what is measured: the vehicle of the program, or else board and state; print the heap that it takes."""
    global board, state, vehicle  # noqa: PLW0603 - the other calls are about them
    gc.collect()
    before = gc.mem_alloc()
    vehicle = None
    if FACTS["program"]:
        import main

        main.collect_often(True)
        cls = main.vehicle_class()
        vehicle = cls() if FACTS["own_ports"] else cls(None, [Port()])
        main.collect_often(False)
        board, state = vehicle.board, vehicle.state
    else:
        from board import Board
        from state import SystemState

        board, state = Board(silent), SystemState(None, silent)  # not by name: arguments have short ones
    gc.collect()
    say("heap.free_bytes", gc.mem_free())
    say("heap.used_bytes", gc.mem_alloc() - before)


def time_of(call, count):
    """Return the mean time and the longest of a call, in us: first all calls as one, then each of them."""
    gc.collect()
    clock, apart = time.ticks_us, time.ticks_diff
    longest = 0
    started = clock()
    for _ in range(count):
        call()
    mean = apart(clock(), started) / count
    for _ in range(count):
        started = clock()
        call()
        took = apart(clock(), started)
        if took > longest:  # noqa: PLR1730 - max() takes longer
            longest = took
    return mean, longest


def updates(count):
    """Time one reading of each component that is measured, into the state."""
    for name in FACTS["components"]:
        update = getattr(state, "update_" + name)
        each("update", name, time_of(lambda update=update: update(board), count))


def sets(count):
    """Time setting a quantity of each component by its attribute."""
    for name, attribute, instances in FACTS["set"]:
        component = getattr(state, name)
        component = component if instances == 1 else component[0]
        value = getattr(component, attribute)
        value = 0 if value is None else value
        each("set", name, time_of(lambda c=component, a=attribute, v=value: setattr(c, a, v), count))


def frames(count):
    """Time making each message, from the state to the frame that a port takes."""
    import telemetry
    from mavlink import Link

    link = Link(Port(), FACTS["system_id"], FACTS["component_id"])
    for name, about in FACTS["messages"]:
        encode = getattr(telemetry, "encode_" + name)
        if about == 2:
            call = lambda encode=encode: encode(link, state, 0, 0)  # noqa: E731
        elif about == 1:
            call = lambda encode=encode: encode(link, state, 0)  # noqa: E731
        else:
            call = lambda encode=encode: encode(link, state)  # noqa: E731
        each("frame", name, time_of(call, count))


def receptions(count):
    """Time taking in a frame, from its bytes to the message."""
    import messages
    from mavlink import Link

    known = [cls for cls in messages.ALL if cls.NAME == "HEARTBEAT"] or messages.ALL[:1]
    link = Link(Port(), 255, 190, 2, known[:1])
    frame = bytes(link.encode(known[0](unknown=False)))
    link.put(frame)
    if link.receive() is None:
        say("", "what the board sends, it does not receive")
        return

    def call():
        link.put(frame)
        link.receive()

    each("receive", known[0].NAME, time_of(call, count))


def readings(count):
    """Time readings of the converter, and print how far they lie apart, in counts."""
    for name, instances in FACTS["readings"]:
        read = getattr(board, "read_" + name + "_adc", None)
        for instance in range(instances if read else 0):
            found = [read(instance) for _ in range(count)]
            good = [value for value in found if value >= 0]
            about = name + "[" + str(instance) + "]"
            if not good:
                say("", about + " gives no reading")
                continue
            each("adc", about, time_of(lambda read=read, instance=instance: read(instance), count))
            mean = sum(good) / len(good)
            say("adc.noise_counts", about, (sum((value - mean) ** 2 for value in good) / len(good)) ** 0.5)
            say("adc.span_counts", about, max(good) - min(good))
            say("adc.failed", about, count - len(good))


def each(name, about, times):
    """Print a mean and a longest time."""
    say(name + ".mean_us", about, times[0])
    say(name + ".longest_us", about, times[1])


def settle(ms):
    """Run the program as its main loop does, until what happens once is over; garbage is collected then."""
    passes(ms)
    gc.collect()


def steady(ms):
    """Run the program on without collecting garbage; print what that took of the heap, and the slots missed."""
    missed = vehicle.scheduler.overruns
    gc.disable()
    before = gc.mem_alloc()
    passes(ms)
    taken = gc.mem_alloc() - before
    gc.enable()
    say("heap.steady_bytes", taken)
    say("loop.missed_slots", vehicle.scheduler.overruns - missed)
    say("loop.load_percent", vehicle.scheduler.load / 10)


def passes(ms):
    """Run passes of the main loop for so long."""
    started = time.ticks_ms()
    while time.ticks_diff(time.ticks_ms(), started) < ms:
        wait_us = vehicle.run_pass()
        if wait_us > 0:
            time.sleep_us(wait_us)


def turns(count):
    """Read and make all messages, so often, without a program; print the heap that it took."""
    import telemetry
    from mavlink import Link

    link = Link(Port(), FACTS["system_id"], FACTS["component_id"])
    updates = [getattr(state, "update_" + name) for name in FACTS["components"]]
    encoders = [(getattr(telemetry, "encode_" + name), about) for name, about in FACTS["messages"]]
    turn(link, updates, encoders)
    gc.collect()
    gc.disable()
    before = gc.mem_alloc()
    for _ in range(count):
        turn(link, updates, encoders)
    taken = gc.mem_alloc() - before
    gc.enable()
    say("heap.steady_bytes", taken)


def turn(link, updates, encoders):
    """Read each component, and make each message."""
    for update in updates:
        update(board)
    for encode, about in encoders:
        if about == 2:
            encode(link, state, 0, 0)
        elif about == 1:
            encode(link, state, 0)
        else:
            encode(link, state)
