# Generated from templates/tests/program/program_bench.py: do not edit.
# Inputs: e1d23311e2efb17e
"""A whole vehicle on a host: a clock that is moved by hand, flash in memory, and ports that record.

The check scripts beside this file import it first, so that the clock is in place before the firmware looks at it.
"""

import errno
import json
import os
import sys

import mock_time

mock_time.install()

import mock_asyncio  # noqa: E402  the clock has to be in place before it

mock_asyncio.install()

import asyncio  # noqa: E402  on MicroPython it runs on the clock of the mocks now

import machine  # noqa: E402
import messages  # noqa: E402
from mavlink import Link  # noqa: E402
from program_facts import (  # noqa: E402
    ACCESS,
    BYTEWISE,
    CALM,
    COMPONENT_ID,
    CONTROL_US,
    FAILSAFES,
    FORCE_ARM,
    LINKS_US,
    MEASURED,
    MESSAGES,
    KNOWN,
    ON_REQUEST,
    SHARED,
    PARAMETERS,
    SENT,
    STREAMS,
    SYSTEM_ID,
)
from texts import Texts  # noqa: E402
from vehicle import Vehicle  # noqa: E402

import dialect  # noqa: E402
import storage  # noqa: E402

try:
    import access
    import signing
except ImportError:  # no link is signed
    access = signing = None

IS_MICROPYTHON = sys.implementation.name == "micropython"
TURN_US = 1 << 30  # ticks_us() starts again
TURN_MS_US = (1 << 30) * 1000  # ticks_ms() starts again
SECOND_US = 1000000
OTHER_SYSTEM = SYSTEM_ID % 255 + 1  # somebody else's ids
OTHER_COMPONENT = COMPONENT_ID % 255 + 1
MOST_STEPS = 70000  # of a save, whose largest has 65535 bytes, in chunks of one at least


class NotHereError(Exception):
    """The specification, or this interpreter, leaves out what a check is about."""


def needs(condition, what):
    """Leave a check out where the condition is false: ``what`` it is about is not there."""
    if not condition:
        raise NotHereError(what)


GOES_OUT = SENT + tuple(SHARED)
"""The ids of all messages that go out, those of several tables with them."""
SETTABLE = [facts for facts in PARAMETERS if len(facts["choices"]) > 1 or facts["minimum"] < facts["maximum"]]
"""Those of the parameters that have more than one value."""
WHOLE = {
    dialect.MAV_PARAM_TYPE_UINT8: (1, False),
    dialect.MAV_PARAM_TYPE_INT8: (1, True),
    dialect.MAV_PARAM_TYPE_UINT16: (2, False),
    dialect.MAV_PARAM_TYPE_INT16: (2, True),
    dialect.MAV_PARAM_TYPE_UINT32: (4, False),
    dialect.MAV_PARAM_TYPE_INT32: (4, True),
}
"""The types that go over the wire as their bytes where the program is BYTEWISE: how many, and whether with a sign."""


def needs_arming():
    """Leave a check out where the program has nothing to arm."""
    needs(FORCE_ARM is not None, "something to arm")


class Flash:
    """Files in memory; what is written counts from close() on, and `operations` keeps what each file would hold.

    `fail_after` is how many writes still work, `delay_us` the time that each takes, `longest` the longest so far.
    """

    def __init__(self):
        self.files = {ACCESS["key"]: b"00" * 32} if access else {}  # a key, so that nobody is warned
        self.operations = []
        self.longest = 0
        self.fail_after = None
        self.delay_us = 0
        self.use()

    def use(self):
        """Be what the firmware's files lie in."""
        storage.open = self.open
        for module in (access, signing):
            if module is not None:
                module.open = self.open
                module.os = self

    urandom = staticmethod(os.urandom)

    def rename(self, old, new):
        """Rename a file, as the function of os does."""
        self.note(new, self.files.pop(old))

    def open(self, path, mode):
        """Open a file as the built-in function does, in the modes rb and wb."""
        if mode == "wb":
            self.note(path, b"")
        elif path not in self.files:
            raise OSError(errno.ENOENT, "no such file")
        return _File(self, path)

    def note(self, path, content):
        """Keep what a file holds from now on."""
        self.files[path] = content
        self.operations.append((path, content))


class _File:
    def __init__(self, flash, path):
        self._flash = flash
        self._path = path
        self._at = 0

    def __enter__(self):
        return self

    def __exit__(self, *_raised):
        self.close()

    def read(self, size=None):
        content = self._flash.files[self._path]
        part = content[self._at :] if size is None else content[self._at : self._at + size]
        self._at += len(part)
        return part

    def write(self, data):
        flash = self._flash
        mock_time.advance_us(flash.delay_us)
        if flash.fail_after is not None:
            if flash.fail_after == 0:
                raise OSError(errno.EIO, "broken")
            flash.fail_after -= 1
        flash.longest = max(flash.longest, len(data))
        flash.note(self._path, flash.files[self._path] + bytes(data))
        return len(data)

    def close(self):
        pass


HERE = (True,)  # what a port returns that has something


class Port:
    """A port that gives what `arrives` got, and keeps the frames that it takes: `room` in each pass, None for all."""

    name = "bench"

    def __init__(self):
        self.is_up = True
        self.room = None
        self.frames = []
        self.looks = 0
        self._taken = 0
        self._arrived = b""

    def arrives(self, data):
        """Let bytes arrive."""
        self._arrived += bytes(data)

    def look(self, wait_ms):
        """Return something where something has arrived; the main loop asks in each pass of the links, for no time."""
        self.looks += 1
        assert wait_ms == 0, "nothing waits for a link"
        return HERE if self._arrived else ()

    def readinto(self, buffer):
        """Give what fits."""
        count = min(len(buffer), len(self._arrived))
        if count:
            buffer[:count] = self._arrived[:count]
            self._arrived = self._arrived[count:]
        return count

    def write(self, frame):
        """Take a whole frame, or nothing."""
        if not self.is_up or (self.room is not None and self._taken >= self.room):
            return 0
        self._taken += 1
        self.frames.append(bytes(frame))
        return len(frame)

    def poll(self, _now_ms):
        """Begin a new pass."""
        self._taken = 0


class Sink:
    """A port on which nothing arrives, and that only counts what it takes."""

    name = "sink"
    is_up = True

    def __init__(self):
        self.count = 0

    def readinto(self, _buffer):
        """Nothing arrives."""
        return 0

    def write(self, frame):
        """Take all."""
        self.count += 1
        return len(frame)

    def poll(self, _now_ms):
        """Do nothing."""


def id_of(frame):
    """Return the id of a frame's message, of either version."""
    return frame[7] | frame[8] << 8 | frame[9] << 16 if frame[0] == 0xFD else frame[5]


def payload_of(frame):
    """Return the payload of a frame, without a signature."""
    return frame[10:-2] if frame[0] == 0xFD else frame[6:-2]


def sequence_of(frame):
    """Return the number of a frame among those of its sender."""
    return frame[4 if frame[0] == 0xFD else 2]


def sender_of(frame):
    """Return the system that sent a frame."""
    return frame[5 if frame[0] == 0xFD else 3]


class GroundStation:
    """The other end of a port: the firmware's own link, with the ids of a ground station."""

    def __init__(self, port, version=2, system_id=255, component_id=190):
        self.port = port
        self.link = Link(self, system_id, component_id, version, messages.ALL)

    def write(self, frame):
        """Let a frame of the ground station arrive at the vehicle."""
        self.port.arrives(frame)
        return len(frame)

    def send(self, message, **values):
        """Send a message to the vehicle, unless `values` say to whom; fields that are not given are 0."""
        message = message(unknown=False)
        for name, target in (("target_system", SYSTEM_ID), ("target_component", COMPONENT_ID)):
            if name in message.names():
                message.update(**{name: target})
        self.link.send(message.update(**values))

    def set_parameter(self, facts, value):
        """Set a parameter to a number, as the program takes it."""
        message = messages.ParamSet(unknown=False)
        message.update(target_system=SYSTEM_ID, target_component=COMPONENT_ID, param_id=facts["name"])
        put_number(message.update(param_type=facts["type"]), value)
        self.link.send(message)

    def command(self, number, *params, **values):
        """Send a COMMAND_LONG with the first of its parameters."""
        for index, param in enumerate(params):
            values[f"param{index + 1}"] = param
        self.send(messages.CommandLong, command=number, **values)

    def received(self, *kinds):
        """Return the messages that came since the last call, of these classes, or all but the streams."""
        frames, self.port.frames = self.port.frames, []
        found = [message for frame in frames for message in self.link.feed(frame)]
        if kinds:
            return [message for message in found if isinstance(message, kinds)]
        streamed = [number for number in SENT if number not in ON_REQUEST] + [messages.Statustext.ID] + list(SHARED)
        return [message for message in found if message.ID not in streamed]


def _bytes_of(kind):
    """Return how many bytes of param_value a MAV_PARAM_TYPE has, and whether with a sign; None if it is a float."""
    return WHOLE.get(kind) if BYTEWISE else None


def put_number(message, value):
    """Write a number into a PARAM_SET that has its type already."""
    whole = _bytes_of(message.param_type)
    if whole is None:
        message.update(param_value=value)
    else:  # param_value comes first on the wire: no other field is as large
        message.wire[: whole[0]] = (int(value) % (1 << 8 * whole[0])).to_bytes(whole[0], "little")


def number_of(message):
    """Return the number of a PARAM_VALUE as a station takes it; None where zeros do not fill its bytes."""
    whole = _bytes_of(message.param_type)
    if whole is None:
        return message.param_value
    size, is_signed = whole
    if any(message.wire[size:4]):
        return None
    number = int.from_bytes(bytes(message.wire[:size]), "little")
    return number - (1 << 8 * size) if is_signed and number >> 8 * size - 1 else number


def can_be_sent(facts, value):
    """Return whether PARAM_SET carries a number for a parameter: of a whole type only those that it has."""
    whole = _bytes_of(facts["type"])
    if whole is None:
        return True
    size, is_signed = whole
    low = -(1 << 8 * size - 1) if is_signed else 0
    return low <= value < low + (1 << 8 * size) and value == int(value)


class Craft(Vehicle):
    """A vehicle that notes which of the user's calls were made; `problem` is what check_arming() returns."""

    def __init__(self, flash=None, ports=None, texts=None, at_us=0, board=None):
        machine.reset_watchdog()
        mock_time.set_ticks_us(at_us)
        self.calls = []
        self.problem = None
        self.flash = flash or Flash()
        self.flash.use()
        Vehicle.__init__(self, board, [Port()] if ports is None else ports, texts or Texts(silent, 500))
        for name, steps in self.set_by_code:  # they count at the start, and stay what they are
            setattr(self.parameters, name, steps)
        know(self.state)
        for poller in self.sources.every if hasattr(self, "sources") else ():
            poller.driver = Quiet()
            poller._keep = keep_nothing

    def _load_parameters(self):
        """Start without what code would have to set all the time."""
        Vehicle._load_parameters(self)
        self.set_by_code = []
        for name, steps, off in [each for measured in MEASURED for each in measured["set_by_code"]]:
            if getattr(self.parameters, name) == steps:
                self.set_by_code.append((name, steps))
                setattr(self.parameters, name, off)

    @property
    def port(self):
        """The first port."""
        return self.connections[0].port

    def check_arming(self):
        """Pass, unless told otherwise."""
        return self.problem

    def on_arm(self):
        """Note it."""
        self.calls.append("on_arm")

    def on_disarm(self):
        """Note it."""
        self.calls.append("on_disarm")

    def ground_station(self, version=2):
        """Return what is at the other end of the first port."""
        return GroundStation(self.port, version)

    def said(self, part=""):
        """Return the texts so far that begin with `part`; of very many, the newest."""
        kept = [self.texts.get(number) for number in range(1, self.texts.last + 1)]
        return [text for text in kept if text is not None and text[1].startswith(part)]


class Quiet:
    """A sensor that works, and of which nothing is kept: what the state has stays as a check wants it."""

    values = ()

    def begin(self):
        pass

    def poll(self, _now_ms):
        return True

    def waiting(self):
        return 1


def keep_nothing(_words, _values, _now_ms):
    """Leave the state as it is."""


def silent(_text):
    """Show nothing."""


def unheard(_loop, _context):
    """Say nothing of an exception that nobody waits for: a check looks at what the vehicle does."""


def beats(seconds):
    """Return how many HEARTBEATs come at least in so many seconds."""
    for stream in STREAMS:
        if stream["parameter"] is None and stream["messages"] and stream["messages"][0][0] == messages.Heartbeat.ID:
            return seconds * 1000 * stream["period_denominator"] // stream["period_numerator"] - 1
    return 0


def know(state):
    """Set everything without which a message is withheld, for ever."""
    for component, instance, attribute, value, expires in KNOWN:
        setattr(getattr(state, component)[instance], attribute, value)
        if expires is not None:
            state.words[expires] = -0x3FFFFFFF - 1


def new_craft(**arguments):
    """Return a vehicle whose components read a good value, each instance its own, with working converters."""
    machine.reset_analog()
    for gpio, shown in CALM:
        machine.analog(gpio).source = shown
    for measured in MEASURED:
        for instance in range(measured["instances"]):
            if measured["are_on"][instance]:  # the pin of an instance that is off may be another one's
                analog(measured, instance).source = good_count(measured, instance)
    return Craft(**arguments)


def ready_craft(**arguments):
    """Return the same with thresholds that the good values are above."""
    return fitted(new_craft(**arguments))


def fitted(craft):
    """Lower thresholds that no value of the ADC is above: a default divider may be too small for its pack."""
    for facts in FAILSAFES:
        measured = next(each for each in MEASURED if each["component"] == facts["component"])
        for instance in range(facts["instances"]):
            value = good_value(measured, instance)
            limits = []
            for level, share in (("minimum", 9), ("low", 8), ("critical", 7)):
                name = name_of(facts, level, instance)
                if name:
                    limits.append((name, facts[level + "_scale"], share))
            if max(getattr(craft.parameters, name) * scale for name, scale, _ in limits) >= value:
                for name, scale, share in limits:
                    if getattr(craft.parameters, name):
                        setattr(craft.parameters, name, value * share // 10 // scale)
    return craft


def name_of(facts, key, instance):
    """Return the attribute of an instance's parameter, of a family or the only one."""
    family = facts["families"][key]
    return family[instance] if family else facts[key]


def analog(measured, instance=0):
    """Return the script of the ADC input that an instance of a component has by default."""
    return machine.analog(measured["gpios"][instance])


def good_count(measured, instance=0):
    """Return a count of the 12 bit converter that is neither low nor worth a warning."""
    first = measured["warning_counts"][instance]
    ceiling = measured["full_scale"] if first is None else first - 1
    return (ceiling * 19 // 20) << measured["spare_bits"]


def good_value(measured, instance=0):
    """Return what this count is in stored steps, with the default multiplier."""
    return value_of(measured, good_count(measured, instance), instance)


def value_of(measured, count, instance=0):
    """Return what a count is in stored steps, with the default multiplier of an instance."""
    family = measured["families"]["multiplier"]
    name = family[instance] if family else measured["multiplier"]
    multiplier = next(each["default"] for each in PARAMETERS if each["attribute"] == name)
    whole = (count >> measured["spare_bits"]) * multiplier * measured["numerator"]
    return (whole + measured["denominator"] // 2) // measured["denominator"]


def run(vehicle, duration_us, step_us=None):
    """Run passes for so long: each when it is due, or one after every `step_us`. What is late is left out."""
    elapsed_us, advance_us, run_pass = mock_time.elapsed_us, mock_time.advance_us, vehicle.run_pass
    end_us = elapsed_us() + duration_us
    while elapsed_us() < end_us:
        wait_us = run_pass()
        advance_us(wait_us if step_us is None else step_us)


def finish(storage):
    """Do the steps of a save, up to its end."""
    for _ in range(MOST_STEPS):
        if not storage.step():
            return
    raise AssertionError("a save does not end")


def save(vehicle):
    """Save the parameters at once, without the vehicle's own task."""
    vehicle.storage.begin(vehicle.parameters.dump())
    finish(vehicle.storage)


def streamed_at(every=1):
    """Return how many messages of streams may be due at once, and how many are while a port has room for others.

    That is one pass of the links of `every` one.
    """
    tables = [table for each in [MESSAGES.values()] + list(SHARED.values()) for table in each]  # noqa: RUF005  MicroPython
    counts = [each["instances"] * each["pages"] for each in tables]
    rate = sum([each["rate"] * count for each, count in zip(tables, counts)])  # noqa: B905  MicroPython
    return sum(counts), rate * LINKS_US * every / SECOND_US


def turns(count, every=1):
    """Return in how many passes with room for it what waits beside the streams has so many turns.

    Such are answers, texts and parameters. Streams may take three quarters of the room, or have to be quieted().
    """
    at_once, in_a_pass = streamed_at(every)
    taken, left = at_once // Craft.MESSAGES, 1 - in_a_pass / Craft.MESSAGES
    return int((count + taken) / max(left, 0.25)) + 1 if taken else count


def quieted(craft, every=1):
    """Return a vehicle; where its streams take more than a quarter of the room, all are off but for the HEARTBEAT."""
    if streamed_at(every)[1] * 4 > craft.MESSAGES:
        for number, each in MESSAGES.items():
            if each["rate"] and number != messages.Heartbeat.ID:
                craft.connections[0].streams.set_interval(number, -1)
        for number in SHARED:
            craft.connections[0].streams.set_interval(number, -1)
    return craft


def run_turns(vehicle, count):
    """Run the passes, each when it is due, in which what waits beside the streams has so many turns."""
    run_passes(vehicle, turns(count))


def run_passes(vehicle, count):
    """Run the passes, each when it is due, in which links are served so often."""
    for _ in range(count * -(-LINKS_US // CONTROL_US)):
        mock_time.advance_us(vehicle.run_pass())


def live(vehicle, story):
    """Run the vehicle's tasks while the coroutine function `story` goes on; return whether the board was reset."""
    if IS_MICROPYTHON:
        asyncio.new_event_loop()

    resets = []

    async def both():
        if not IS_MICROPYTHON:  # it would print the whole stack for each task that a reset of the board has ended
            asyncio.get_running_loop().set_exception_handler(unheard)

        async def board():
            try:
                await vehicle.run()
            except machine.Reset:
                resets.append(mock_time.elapsed_us())
                told.cancel()

        told = asyncio.create_task(story())
        running = asyncio.create_task(board())
        try:
            await told
        except asyncio.CancelledError:
            assert resets
        running.cancel()

    asyncio.run(both())
    return bool(resets)


class Watch:
    """A failsafe whose component has exactly the values that a check gives it; `at` sets thresholds in stored steps."""

    def __init__(self, low, critical, timer, at_us=0, flash=None):
        needs(FAILSAFES, "a failsafe")
        self.facts = FAILSAFES[0]
        self.craft = ready_craft(at_us=at_us, flash=flash)
        self.failsafe = getattr(self.craft, self.facts["list"])[0]
        component = getattr(self.craft.state, self.facts["component"])
        self.component = component if self.facts["instances"] == 1 else component[0]
        self.parameters = self.craft.parameters
        self.period_us = next(each for each in MEASURED if each["component"] == self.facts["component"])["period_us"]
        self.value = None
        self.events = []
        self.started_us = at_us
        self.set(low, critical, timer)
        name = "update_" + self.facts["component"]
        self._read = getattr(self.craft.state, name)
        setattr(self.craft.state, name, self._update)

    def set(self, low, critical, timer):
        """Set the thresholds, in stored steps, and the time in seconds."""
        setattr(self.parameters, self.facts["low"], low // self.facts["low_scale"])
        setattr(self.parameters, self.facts["critical"], critical // self.facts["critical_scale"])
        setattr(self.parameters, self.facts["after"], timer)

    def _update(self, board):
        self._read(board)
        setattr(self.component, self.facts["attribute"], self.value)

    def readings(self, value, count=1):
        """Run so many readings of a value, one in each period; note when a level is reached."""
        self.value = value
        for _ in range(count):
            before = self.failsafe.level
            self.craft.run_pass()
            if self.failsafe.level != before:
                passed_us = mock_time.elapsed_us() - self.started_us
                self.events.append((self.failsafe.level, passed_us // self.period_us))
            mock_time.advance_us(self.period_us)
        return self.events

    def arm(self):
        """Arm by force."""
        assert self.craft.arm(force=True) is None

    @property
    def per_second(self):
        """Readings in a second."""
        return SECOND_US // self.period_us


def outcome(check):
    """Return None for a check that passes, else what went wrong, and "left out" where it is about nothing."""
    try:
        check()
    except NotHereError as what:
        return f"left out: {what}"
    except Exception as error:
        return f"{type(error).__name__}: {error}"
    return None


def outcomes(checks, subject, asked):
    """Yield name and outcome of each check that is asked for, as asked; without a subject it is left out."""
    if IS_MICROPYTHON:
        machine.reset_analog()
    known = {check.__name__: check for check, *_ in checks}
    for name in asked:
        yield name, outcome(known[name]) if subject else "left out: there is nothing of it"


def main(checks, subject=True):
    """Run the checks and print what went wrong in each, or null, by their names; without a subject all are left out.

    The script's arguments are the number of a port, and the names of the checks to run; without any, all are.
    """
    asked = sys.argv[2:] or [check.__name__ for check, *_ in checks]
    print(json.dumps(dict(outcomes(checks, subject, asked))))
