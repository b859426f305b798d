# Generated from templates/tests/counterparts_run.py: do not edit.
# Inputs: 6dc8cdd9c4c17b0e
"""Prints what the firmware makes of the same steps, drawn by lot from a seed, on whatever interpreter reads this file.

Where MicroPython makes machine code, it takes the modules of that, and CPython their counterparts in plain Python: both
leave the same in the state, in frames and in counters, step by step. Each step is told as a few numbers: sums of what
it left, by part. The arguments are numbers that the code compares with, then "of", and the parts.
"""

import json
import sys
from array import array
from binascii import crc32

import mock_time

mock_time.install()

import messages  # noqa: E402  the clock has to be in place before the firmware looks at it
from counterparts_facts import (  # noqa: E402
    AGES_MS,
    COMPONENT_ID,
    ON,
    PARAMETERS,
    QUANTITIES,
    READINGS,
    SYSTEM_ID,
    TABLES,
)
from mavlink import Link  # noqa: E402
from parameters import Parameters  # noqa: E402
from state import SystemState  # noqa: E402

import receiver  # noqa: E402
import sender  # noqa: E402
import state as state_module  # noqa: E402
import telemetry  # noqa: E402

try:
    from scan_viper import holding, take_due, watch
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from scan_plain import holding, take_due, watch

try:
    from streams import VERSION, open_link
except ImportError:  # there is no program
    VERSION = 0

if READINGS:
    from mock_board import MockBoard

COMPONENTS = sorted({reading[2] for reading in READINGS})  # of which readings are taken
HALF_TURN_MS = 1 << 29
GUARDS = (0x5A5A5A5, -0x5A5A5A5)  # words behind an array: they belong to nobody, and stay what they are
BEFORE_WRAP_US = ((1 << 30) - 300) * 1000  # ticks_ms() starts again soon
UNKNOWN = -0x3FFFFFFF - 1


class Lot:
    """Numbers by lot, the same ones everywhere."""

    def __init__(self, seed):
        self.seed = seed

    def below(self, count):
        """Return one of so many numbers from 0 on."""
        self.seed = (self.seed * 69069 + 12345) & 0xFFFFFFFF
        return (self.seed >> 8) % count

    def one(self, values):
        """Return one of some values."""
        return values[self.below(len(values))]

    def within(self, low, high):
        """Return a number of a range, its ends and those beside them more often than others."""
        kind = self.below(8)
        if kind < 6 or high - low < 2:
            return (low, high, low, high, min(low + 1, high), max(high - 1, low), low, high)[kind]
        return low + (self.below(1 << 24) << 24 | self.below(1 << 24)) % (high - low + 1)


class Log:
    """Counts what is logged: floats look a bit different on each interpreter."""

    def __init__(self):
        self.count = 0

    def __call__(self, *_words):
        self.count += 1


class Wire:
    """A stream that takes everything and keeps the last frame."""

    def write(self, frame):
        self.frame = bytes(frame)
        return len(frame)


BEHIND = b"\x5a\xa5" * 8  # the same of buffers
KEPT = 40


def guarded(kind, values):
    """Return the array of a state with a few words behind it."""
    return array(kind, list(values) + list(GUARDS))


class Buffers:
    """The newest buffers of links, each with a few bytes behind it that are nobody's."""

    def __init__(self):
        self.kept = []

    def make(self, size):
        """Return a new one."""
        if len(self.kept) == KEPT:
            self.look()
            del self.kept[: KEPT // 2]
        buffer = bytearray(size) + BEHIND
        self.kept.append(buffer)
        return buffer

    def look(self):
        """Fail where anything was written behind one."""
        for buffer in self.kept:
            assert buffer[-len(BEHIND) :] == BEHIND, "it writes behind a buffer"


# Machine code does not look where an array or a buffer ends.
buffers = Buffers()
state_module.array = guarded
sender.bytearray = receiver.bytearray = buffers.make


def new_state(lot, log):
    """Return a state and what reads for it, or None, with parameters by lot: in one of three all, else a few.

    Two of three readings are taken that can be.
    """
    parameters, few = Parameters(), lot.one((1, 3, 3))
    for attribute, choices, low, high in PARAMETERS:
        if lot.below(few) == 0:
            setattr(parameters, attribute, lot.one(choices) if choices else lot.within(low, high))
    for attribute, steps in ON:
        if lot.below(3):
            setattr(parameters, attribute, steps)
    board = MockBoard(log=log, parameters=parameters) if READINGS else None
    return SystemState(parameters, log=log), board


def set_by_lot(lot, state, kind):
    """Let code set a quantity of an instance: one of its values, or any number of its range."""
    name, instances, attribute, elements, values = kind
    component = getattr(state, name)[lot.below(instances)]
    value = lot.one(values) if lot.below(4) else values[0]  # it is unknown
    if isinstance(values[-2], int) and isinstance(values[-1], int) and not elements and lot.below(2):
        value = lot.within(values[-2], values[-1])
    if not elements and lot.below(8) == 0 and isinstance(values[1], int):
        value = 0
    if elements and lot.below(2):
        value = [lot.one(lot.one(values)) for _ in range(elements)]
    setattr(component, attribute, value)


def read(lot, state, board, times):
    """Let the inputs have counts by lot, or fail, and take so many readings of each component, 100 ms apart.

    Each is over within a millisecond: machine code looks at the clock before all parts, plain Python behind each one.
    Return the sum of the state behind each reading.
    """
    found = []
    for _, name, _, full_scale, instances in READINGS:
        for instance in range(instances):
            about = (instance,) if instances > 1 else ()
            counts = (0, 1, 2, 5, full_scale // 2, full_scale * 3 // 4, full_scale, lot.within(0, full_scale))
            getattr(board, "set_" + name + "_value")(lot.one(counts), *about)
            getattr(board, "fail_" + name)(times if lot.below(5) == 0 else 0, *about)
            getattr(board, "delay_" + name)(lot.one((0, 0, 1, 7)), *about)
    for _ in range(times):
        for component in COMPONENTS:
            getattr(state, "update_" + component)(board)
        found.append(summed(state))
        mock_time.advance_us(100000 - mock_time.elapsed_us() % 1000)
    return found


def counted(board):
    """Return the sum of what is counted of each input: its failures, and the times of its readings."""
    found = 0
    for reading in READINGS:
        inputs = getattr(board, reading[0] + "_inputs", None)
        for counts in inputs.counts if inputs else ():
            found = crc32(bytes(array("i", counts)), found)
    return found


def forget(state):
    """Let everything be forgotten that is too old."""
    for name, instances in {(kind[0], kind[1]) for kind in QUANTITIES}:
        for instance in range(instances):
            one = getattr(state, name)[instance]
            if hasattr(one, "expire"):
                one.expire()
    if hasattr(state, "forget_next"):
        for _ in QUANTITIES:
            state.forget_next()


def summed(state):
    """Return the sum of all words of a state, and of those behind them, which nothing writes to."""
    assert tuple(state.words[-len(GUARDS) :]) == GUARDS, "it writes behind the state"
    return crc32(bytes(state.words))


def sent(links, state, name, about):
    """Return the sum of the frames of a message: straight from the state, and of the message that is built."""
    frame = getattr(telemetry, "encode_" + name)(links[0], state, *about)
    found = 0 if frame is None else crc32(bytes(frame))
    message = getattr(telemetry, "build_" + name)(state, *about)
    if message is not None:
        link = links[1] if message.ID < 256 else links[0]
        link.send(message)
        found = crc32(link.stream.frame, found)
    return found


def sent_anew(link, payloads, state, name, about):
    """Return the sum of a message's frame where its payload is another one than the last, else 0.

    Few messages tell a quantity. Where the payload is the same, the frame of it is that of before.
    """
    message = getattr(telemetry, "build_" + name)(state, *about)
    payload = None if message is None else bytes(message.wire)
    if payload == payloads.get(name, b""):
        return 0
    payloads[name] = payload
    frame = getattr(telemetry, "encode_" + name)(link, state, *about)
    return 0 if frame is None else crc32(bytes(frame))


def links_of():
    """Return a link for each version of MAVLink."""
    return [Link(Wire(), SYSTEM_ID, COMPONENT_ID, version) for version in (2, 1)]


def views_stay(link, state):
    """Send all messages over a link of the program: it has the views of their frames, and makes no more."""
    are_missing = [view is None for view in link.room[1]]
    for name, abouts in TABLES:
        for about in abouts:
            getattr(telemetry, "encode_" + name)(link, state, *about)
    assert [view is None for view in link.room[1]] == are_missing, "a view is made of a frame that goes out"


def steps_of_state(seed=1, turns=20):
    """Code sets quantities, readings are taken, time passes, and something is sent: what that leaves, step by step."""
    lot, links = Lot(seed), links_of()
    times_ms = [0, 1, 20, 100, 100, 100, 999, HALF_TURN_MS]
    ends_ms = [age + late for age in AGES_MS for late in (0, 1, -100, -99)]  # 100 ms are over behind a reading
    times_ms += [end for end in ends_ms if end >= 0]
    for turn in range(turns):
        mock_time.set_ticks_us(BEFORE_WRAP_US if turn % 2 else 0)
        log = Log()
        state, board = new_state(lot, log)
        for _ in range(STEPS):
            for _ in range(lot.below(4)):
                set_by_lot(lot, state, lot.one(QUANTITIES))
            mock_time.advance_us(1000 * lot.one(times_ms))
            step = []
            if board is not None and lot.below(4):
                step += read(lot, state, board, lot.one((1, 2, 3, 8, 1, 2, 3, 60)))
                step.append(counted(board))
            step += [summed(state), log.count]
            if lot.below(4) == 0:
                forget(state)
                step.append(summed(state))
            for _ in range(3):
                name, abouts = lot.one(TABLES)
                step.append(sent(links, state, name, lot.one(abouts)))
            step.append(summed(state))
            yield step
        if VERSION == 2:
            views_stay(open_link(Wire()), state)
    mock_time.set_ticks_us(0)


def ages_of_state():
    """Each message finds what is too old, and what just is not, by itself: what it sends and leaves then, by age."""
    lot, links = Lot(2), links_of()
    late = (-100, -99, 0, 1, HALF_TURN_MS - 101, HALF_TURN_MS - 100, HALF_TURN_MS - 1, HALF_TURN_MS)  # as in steps
    for begun_us in (0, BEFORE_WRAP_US):
        mock_time.set_ticks_us(begun_us)
        state, board = new_state(Lot(0), Log())
        if board is not None:
            read(lot, state, board, 2)
        for kind in QUANTITIES:
            for instance in range(kind[1]):
                setattr(getattr(state, kind[0])[instance], kind[2], kind[4][1])
        now_us = mock_time.elapsed_us()
        words = array("i", state.words)
        for name, abouts in list(TABLES) + [(None, ((),))]:  # noqa: RUF005  MicroPython has no (*TABLES, 1) here
            for about in abouts:
                told = []
                for age_ms in AGES_MS:
                    for late_ms in late:
                        state.words[:] = words
                        mock_time.set_ticks_us(max(0, now_us + 1000 * (age_ms + late_ms)))
                        told.append(forget(state) if name is None else sent(links, state, name, about))
                        told.append(summed(state))
                yield told
    mock_time.set_ticks_us(0)


def zeros_of_state():
    """All is 0 but one quantity, in turn: so many zeros are left out at the end of each message, and so many summed."""
    links = links_of()
    state = SystemState(log=Log())
    zeros = [([0] * kind[3] if kind[3] else 0 if isinstance(kind[4][1], int) else kind[4][0]) for kind in QUANTITIES]
    for kind, zero in zip(QUANTITIES, zeros):  # noqa: B905  MicroPython's takes nothing else
        for instance in range(kind[1]):
            setattr(getattr(state, kind[0])[instance], kind[2], zero)
    for kind, zero in zip(QUANTITIES, zeros):  # noqa: B905
        told, one = [], getattr(state, kind[0])[0]
        for value in kind[4]:
            setattr(one, kind[2], value)
            told.append([sent(links, state, name, abouts[0]) for name, abouts in TABLES])
        setattr(one, kind[2], zero)
        yield told


def limits_of_state():
    """One quantity at a time has each number that the code compares with, or one beside it: what that leaves.

    All others are unknown, or small numbers.
    """
    link, payloads = links_of()[0], {}
    state, board = new_state(Lot(0), Log())
    for base in (0, 1):
        for name, instances, attribute, _, values in QUANTITIES:
            for instance in range(instances):
                setattr(getattr(state, name)[instance], attribute, values[base])
        words = array("i", state.words)
        for kind in QUANTITIES:
            yield from limits_of(kind, link, payloads, state, board, words)


def limits_of(kind, link, payloads, state, board, words):
    """Yield what each of the numbers leaves, as the value of a quantity of the first instance."""
    name, _, attribute, elements, values = kind
    low, high = [each[0] if elements else each for each in values[-2:]]
    for number in NUMBERS:
        if isinstance(low, int) and isinstance(high, int) and low <= number <= high:
            state.words[:] = words
            setattr(getattr(state, name)[0], attribute, [number] * elements if elements else number)
            told = [sent_anew(link, payloads, state, table, abouts[0]) for table, abouts in TABLES]
            for component in COMPONENTS:
                getattr(state, "update_" + component)(board)
            told.append(summed(state))
            yield told


def short_links():
    """Links with room for less than a message: who encodes is told, and nothing else is written."""
    state = SystemState(log=Log())
    for name, abouts in TABLES:
        kind = getattr(telemetry, "build_" + name)(state, *abouts[0])
        told, longest = [], kind.LENGTH if kind is not None else 20
        for version, room in ((2, longest), (2, longest - 1), (2, max(1, longest - 40)), (2, 1), (1, longest)):
            link = Link(Wire(), SYSTEM_ID, COMPONENT_ID, version, (), room)
            try:
                frame = getattr(telemetry, "encode_" + name)(link, state, *abouts[-1])
                told.append(frame and crc32(bytes(frame)))
            except ValueError as error:
                told.append(str(error))
        yield told


def lengths_of_links():
    """Any message over a link of either version that has room for it, or a byte less, and keeps views of few frames."""
    lot = Lot(7)
    for kind in messages.ALL:
        message, told = kind(unknown=False), []
        for version, room in ((2, kind.LENGTH), (1, kind.LENGTH), (2, max(1, kind.LENGTH - 1)), (1, 255)):
            link = Link(Wire(), SYSTEM_ID, COMPONENT_ID, version, (), room, None, ((0, lot.below(room)), (room, room)))
            for at in (0, len(message.wire) // 2, len(message.wire) - 1):
                message.wire[:] = bytes(len(message.wire))
                message.wire[at] = 1 + lot.below(255)
                try:
                    told.append(crc32(bytes(link.encode(message))))
                except ValueError as error:
                    told.append(str(error))
        yield told


def due_by_lot():
    """The messages that are due, and the times at which they are due again, which wrap."""
    lot = Lot(3)
    for _ in range(SCANS):
        count = 1 + lot.below(4)
        now_ms = lot.one((0, 5, (1 << 30) - 3, HALF_TURN_MS, 123456))
        times = array("i", [count, lot.one((100, 1000, HALF_TURN_MS - 1))])
        for _ in range(count):
            parts = lot.one((0, 1, 1, 3, 1000))
            ahead = lot.one((0, 1, -1, 99, 100, 101, 1000, 1001, -20, -2000, HALF_TURN_MS - 1, HALF_TURN_MS))
            times.extend(
                array("i", [now_ms + ahead & 0x3FFFFFFF, lot.below(parts or 1), lot.one((1, 20, 100, 5000)), parts])
            )
        times.extend(array("i", GUARDS))
        step = []
        for _ in range(3):
            step += [take_due(times, now_ms, lot.below(2)), list(times)]
        assert tuple(times[-len(GUARDS) :]) == GUARDS, "it writes behind the times"
        yield step


def watched_by_lot():
    """The conditions that hold and are up, for values around their limits, at times that wrap."""
    lot = Lot(4)
    for _ in range(SCANS):
        count = lot.below(5)
        values = (UNKNOWN, -1, 0, 9, 10, 11, 5, 0x3FFFFFFF, -0x3FFFFFFF)
        words = array("i", [0] * 4)
        words.extend(array("i", GUARDS))
        now_ms = lot.one((0, 5, (1 << 30) - 3, HALF_TURN_MS))
        rows = array("i", [count, lot.below(count + 1), lot.below(3), 7, 7, now_ms, lot.below(4) - 1, lot.below(3), -1])
        rows[8] = lot.one((-1, 3))
        for _ in range(count):
            rows.extend(array("i", [lot.below(3), lot.below(5) - 1, 10, lot.one((UNKNOWN, UNKNOWN, -1, 9))]))
            rows.extend(array("i", [lot.one((-1, 0, 1, 100)), lot.one((-1, 0, 99, 1 << 24)), 1 + lot.below(2)]))
        step = []
        for _ in range(4):
            for at in range(3):
                words[at] = lot.one(values)
            now_ms = now_ms + lot.one((0, 1, 100, 1000, HALF_TURN_MS - 1, HALF_TURN_MS)) & 0x3FFFFFFF
            flags = lot.below(4)
            step += [1 if watch(words, rows, now_ms, flags) else 0, holding(words, rows), list(words), list(rows)]
        assert tuple(words[-len(GUARDS) :]) == GUARDS, "it writes behind what it watches"
        yield step


def broken(lot, frame):
    """Return a frame with a fault, now and then: a bit, its end, or other bytes in front of it."""
    fault = lot.below(8)
    if fault == 0:
        frame[lot.below(len(frame))] ^= 1 << lot.below(8)
    if fault == 1:
        return frame[: lot.below(len(frame))]
    return bytes([lot.one((0xFD, 0xFE, 0, 9)) for _ in range(lot.below(12))]) + frame if fault == 2 else frame


def bytes_by_lot(lot, senders):
    """Return the frames of a few messages, or of many, of which some are broken."""
    data = b""
    for _ in range(1 + lot.below(lot.one((3, 3, 30)))):
        message = lot.one(messages.ALL)(unknown=False)
        for at in range(lot.below(len(message.wire) + 1)):
            message.wire[at] = lot.below(256) if lot.below(2) else 0
        sender = senders[0] if message.ID > 255 else lot.one(senders)
        sender.send(message)
        data += broken(lot, bytearray(sender.stream.frame))
    return data


def receiver_by_lot(lot):
    """Return a link that receives some messages, or all: each into one object, or made anew for each frame."""
    share, few = lot.below(5), lot.one((3, 99))
    kinds = [kind for kind in messages.ALL if lot.below(few)]
    return Link(Wire(), 1, 1, 2, [kind(unknown=False) if lot.below(4) < share else kind for kind in kinds])


def frames_by_lot():
    """Messages arrive among other bytes, whole, cut and broken, in pieces of any size: what is received of them."""
    lot = Lot(5)
    senders = links_of()
    for turn in range(FRAMES):
        if turn % 5 == 0:
            link = receiver_by_lot(lot)
            state = link._state
        data = bytes_by_lot(lot, senders)
        step = [crc32(data)]
        state[16] = lot.one((0, 0, 20, 200))  # so many bytes are looked at until somebody else has a turn
        while data:
            size = 1 + lot.below(lot.one((2, 20, 300, 3000)))
            link.put(lot.one((bytes, bytearray, memoryview))(data[:size]))
            data = data[size:]
            if lot.below(8) == 0:  # or more arrives first
                continue
            last, state[15] = -1, 0
            while state[0] != last:
                message, last = link.receive(), state[0]
                if message is not None:
                    step += [message.ID, crc32(bytes(message.wire)), state[23]]
                    last = -1
                elif state[16]:
                    step.append(state[15])
                    state[15] = 0
        step += [link.received, link.unknown, link.dropped, link.crc_errors, state[0], state[1]]
        yield step
        if lot.below(8) == 0:
            link.give_up()


def times_of_readings():
    """A reading takes as long as a number that the code compares with, or about that: what comes of it is counted.

    Parameters are drawn by lot several times: with some of them an input is not read.
    """
    delays_us = sorted({number // samples for number in NUMBERS for samples in range(1, 9) if 100 <= number <= 20000})
    for seed in range(4):
        _, board = new_state(Lot(seed), Log())
        for name, mock, _, full_scale, instances in READINGS:
            for instance in range(instances):
                about, told = (instance,) if instances > 1 else (), []
                getattr(board, "set_" + mock + "_value")(full_scale // 3, *about)
                for delay_us in delays_us:  # of each sample
                    getattr(board, "delay_" + mock)(delay_us, *about)
                    told += [getattr(board, "read_" + name + "_adc")(*about), counted(board)]
                yield told


def more_steps_of_state():
    """More of the same, for who has the time."""
    return steps_of_state(6, 160)


STEPS = 12
SCANS = 300
FRAMES = 100
TOGETHER = 48
PARTS = {
    "steps": steps_of_state,
    "more steps": more_steps_of_state,
    "ages": ages_of_state,
    "zeros": zeros_of_state,
    "limits": limits_of_state,
    "short": short_links,
    "lengths": lengths_of_links,
    "due": due_by_lot,
    "watched": watched_by_lot,
    "frames": frames_by_lot,
    "times": times_of_readings,
}


def tell_sums(steps):
    """Print the sum of each step, as a list: many in a line, since each line is a call of the system for both ends."""
    told, begin = [], "["
    for step in steps:  # one by one: there are as many as there are messages, times numbers
        told.append(str(crc32(str(step).encode())))
        if len(told) == TOGETHER:
            print(begin + ",".join(told))
            told, begin = [], ","
    print(begin + ",".join(told) + "]" if told or begin == "[" else "]")


if __name__ == "__main__":
    of = sys.argv.index("of")
    NUMBERS = [int(number) for number in sys.argv[1:of]]
    begin = "{"
    for name in sys.argv[of + 1 :]:
        print(f"{begin}{json.dumps(name)}: ")
        begin = ", "
        tell_sums(PARTS[name]())
        buffers.look()
    print("}")
