# Generated from templates/mocks/machine.py: do not edit.
# Inputs: 1fc147b8a61a2a95
"""The board's module `machine`, as far as the firmware uses it: pins, and ADC inputs that follow a script.

analog(gpio) is the script of one input; it works on all ADC objects of that GPIO, made before or after.
"""

import errno

import mock_time

FULL_SCALE = 4095  # counts of the 12 bit converter

adc_pins = None  # GPIO numbers with an ADC, which the board sets; None for any

_inputs = {}
_chip = [b"\xe6\x61\x38\x52\x83\x1b\x2c\x21"]


class AnalogInput:
    """One ADC input, as a test sets it up.

    `source` is what is read, in counts from 0 to 4095: a number; a list, whose last item stays; or a function that
    gets the microseconds since the start of the clock. None in place of a count is a reading that fails.
    `failures` is how many of the next readings fail, `absent` makes ADC() fail, `delay_us` is the virtual time that
    a reading takes, and `reads` counts the readings, failed ones too.
    """

    def __init__(self):
        self.reset()

    def reset(self):
        """Read 0, work, take no time."""
        self.source = 0
        self.failures = 0
        self.absent = False
        self.delay_us = 0
        self.reads = 0

    @property
    def source(self):
        return self._source

    @source.setter
    def source(self, source):
        self._source = source
        self._position = 0

    def read_count(self):
        """Take one reading; OSError if it fails."""
        self.reads += 1
        mock_time.advance_us(self.delay_us)
        if self.failures > 0:
            self.failures -= 1
            raise OSError(errno.EIO)
        count = self._next_count()
        if count is None:
            raise OSError(errno.EIO)
        if not 0 <= count <= FULL_SCALE:
            raise ValueError(f"an ADC of 12 bits does not read {count!r}")
        return int(count)

    def _next_count(self):
        source = self._source
        if source is None or isinstance(source, int):  # the usual case, and the one that must not allocate
            return source
        if callable(source):
            return source(mock_time.elapsed_us())
        if not isinstance(source, (list, tuple)):
            return source
        count = source[min(self._position, len(source) - 1)]
        self._position += 1
        return count


def analog(gpio):
    """Return the script of the ADC input on this GPIO."""
    if gpio not in _inputs:
        if adc_pins is not None and gpio not in adc_pins:
            raise ValueError(f"GPIO {gpio} has no ADC")
        _inputs[gpio] = AnalogInput()
    return _inputs[gpio]


def reset_analog():
    """Reset the script of every input, also of those that ADC objects exist for."""
    for script in _inputs.values():
        script.reset()


def ramp(start, stop, steps):
    """Return `steps` counts, evenly from `start` to `stop`, both included: rising or falling."""
    if steps < 2:
        raise ValueError("a ramp has at least two steps")
    return [start + (stop - start) * step // (steps - 1) for step in range(steps)]


class Pin:
    """A pin that keeps the level it was given, and what irq() was given: nothing comes in at it by itself."""

    IN = 0
    OUT = 1
    PULL_UP = 1
    PULL_DOWN = 2
    IRQ_RISING = 1
    IRQ_FALLING = 2

    def __init__(self, id, mode=IN, pull=None, value=0):  # noqa: A002 - the board's own argument names
        self.id = id
        self.mode = mode
        self.pull = pull
        self._level = 1 if value else 0
        self.handler = None
        self.trigger = 0

    def irq(self, handler=None, trigger=3):
        """Keep what is to be called with the pin at an edge, and at which edges."""
        self.handler = handler
        self.trigger = trigger
        return self

    def value(self, level=None):
        """Return the level, or set it."""
        if level is None:
            return self._level
        self._level = 1 if level else 0
        return None

    def on(self):
        """Set the level to 1."""
        self._level = 1

    def off(self):
        """Set the level to 0."""
        self._level = 0

    def toggle(self):
        """Change the level."""
        self._level ^= 1


class ADC:
    """An ADC input, by pin, GPIO number (26 to 29) or channel (0 to 3); `atten` is what an ESP32 asks for."""

    ATTN_11DB = 3

    def __init__(self, pin, atten=None):  # noqa: ARG002
        number = pin.id if isinstance(pin, Pin) else pin
        if isinstance(number, str):
            number = int(number[1:])  # X19
        self._input = analog(number + 26 if 0 <= number <= 3 and not isinstance(pin, Pin) else number)
        if self._input.absent:
            raise OSError(errno.ENODEV)

    def read_u16(self):
        """Take a reading of 0 to 65535: the 12 bits at the top and their first four again below, as RP2 does."""
        count = self._input.read_count()
        return (count << 4) | (count >> 8)


class SerialLine:
    """One UART, as a test sets it up.

    `room` is how many bytes the UART still takes, None for no limit; `parts` is a list of how many bytes the next
    writes take at most, one each, where 0 is a full buffer. `failures` is how many of the next reads and writes fail,
    `absent` makes UART() fail. `sent` is everything that was written, `settings` what UART() was given.
    """

    def __init__(self):
        self.reset()

    def reset(self):
        """Take everything, send nothing."""
        self.room = None
        self.parts = []
        self.failures = 0
        self.absent = False
        self.sent = bytearray()
        self.settings = {}
        self._arrived = bytearray()

    def arrives(self, data):
        """Let bytes arrive, to be read later."""
        self._arrived.extend(data)

    def waiting(self):
        """Return how many bytes can be read."""
        return len(self._arrived)

    def take(self, data):
        """Write as much as there is room for; return how many bytes, None for none."""
        self._fail()
        count = len(data) if self.room is None else min(len(data), self.room)
        if self.parts:
            count = min(count, self.parts.pop(0))
        if self.room is not None:
            self.room -= count
        self.sent.extend(bytes(data)[:count])
        return count or None

    def read_into(self, buffer):
        """Read what fits; return how many bytes, None for none."""
        self._fail()
        count = min(len(buffer), len(self._arrived))
        buffer[:count] = self._arrived[:count]
        self._arrived = self._arrived[count:]
        return count or None

    def _fail(self):
        if self.failures > 0:
            self.failures -= 1
            raise OSError(errno.EIO)


_lines = {}


def serial(id):  # noqa: A002 - the board's own argument name
    """Return the script of the UART of this number; which ones a board has is the specification's concern."""
    if id not in _lines:
        _lines[id] = SerialLine()
    return _lines[id]


def reset_serial():
    """Reset the script of every UART."""
    for line in _lines.values():
        line.reset()


class UART:
    """A UART with timeout 0: it takes and gives what it can at once."""

    def __init__(self, id, baudrate=115200, **settings):  # noqa: A002 - the board's own argument name
        self._line = serial(id)
        self.init(baudrate, **settings)

    def init(self, baudrate=115200, **settings):
        """Set the line up again."""
        if self._line.absent:
            raise OSError(errno.ENODEV)
        settings["baudrate"] = baudrate
        self._line.settings = settings

    def any(self):
        """Return how many bytes can be read."""
        return self._line.waiting()

    def readinto(self, buffer):
        """Read into a buffer; return how many bytes, None for none."""
        return self._line.read_into(buffer)

    def read(self, size=-1):
        """Return up to `size` bytes, None for none."""
        data = bytearray(self.any() if size < 0 else size)
        count = self.readinto(data)
        return None if count is None else bytes(data[:count])

    def write(self, data):
        """Write bytes; return how many, None for none."""
        return self._line.take(data)


class Reset(SystemExit):
    """The board starts again: no part of the firmware may hold this up."""


def reset():
    """Start the board again: Reset, which ends a program that does not expect it."""
    set_reset_cause(cause_of_restart)
    raise Reset


class WatchdogReset(Reset):
    """The watchdog was not fed in time."""


PWRON_RESET = 1
WDT_RESET = 3

watchdog_range_ms = (1, None)  # the shortest and the longest timeout, which the board sets; None for any
cause_of_restart = None  # what reset_cause() tells after reset(), which the board sets
_reset_cause = [PWRON_RESET]
# Words at addresses: scratch registers of the watchdogs of RP2040 and RP2350, whose number tells that one was not fed.
_SCRATCHES = (0x4005801C, 0x400D801C)
_NOT_FED = 0x6AB73121
mem32 = dict.fromkeys(_SCRATCHES, 0)
_CLEARS = (0x4005B000, 0x400DB000)  # clear bits of their control registers: the program stops one there


def reset_cause():
    """Return what the last reset came from, 1 at first; set_reset_cause() changes it."""
    return _reset_cause[0]


def set_reset_cause(number, by_watchdog=False):
    """Be a board that was reset so, by a watchdog that was not fed or by something else; no watchdog runs."""
    reset_watchdog()
    _reset_cause[0] = number
    mem32.update(dict.fromkeys(_SCRATCHES, _NOT_FED if by_watchdog else 0))


_watchdog = [0, 0]  # its timeout in microseconds, or 0; how often it was fed


class WDT:
    """The watchdog: WatchdogReset is raised wherever the clock goes beyond `timeout` ms since it was fed."""

    def __init__(self, id=0, timeout=5000):  # noqa: A002, ARG002 - the board's own argument names
        shortest, longest = watchdog_range_ms
        if timeout < shortest or (longest is not None and timeout > longest):
            raise ValueError(f"a watchdog of this board does not take {timeout} ms")
        _watchdog[0] = timeout * 1000
        mem32.update(dict.fromkeys(_SCRATCHES, _NOT_FED))
        mem32.update(dict.fromkeys(_CLEARS, 0))
        self.feed()

    def feed(self):
        """Begin its time anew."""
        mock_time.set_alarm(_watchdog[0], _not_fed)
        _watchdog[1] += 1


def watchdog():
    """Return the microseconds until it resets the board, its timeout, 0 while none runs, and how often it was fed."""
    return mock_time.alarm_left_us(), _watchdog[0], _watchdog[1]


def reset_watchdog():
    """Let none run, and no timer, as after a reset."""
    mock_time.follow_nobody()
    mock_time.set_alarm(0, None)
    _watchdog[0] = _watchdog[1] = 0


def _not_fed(left_us):
    if any(mem32[clear] for clear in _CLEARS):
        _watchdog[0] = 0
        return
    set_reset_cause(WDT_RESET, by_watchdog=True)
    mock_time.advance_us(left_us)
    raise WatchdogReset("the watchdog was not fed in time")


def unique_id():
    """Return the 8 bytes that no other board has; set_unique_id() changes them."""
    return _chip[0]


def set_unique_id(number):
    """Be another board: take these bytes for its chip's number."""
    _chip[0] = bytes(number)
