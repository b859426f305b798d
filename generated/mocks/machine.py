# Generated from templates/mocks/machine.py: do not edit.
# Inputs: fa499090a74a2f53
"""The board's module `machine`, as far as the firmware uses it: pins, and ADC inputs that follow a script.

analog(gpio) is the script of one input; it works on all ADC objects of that GPIO, made before or after.
"""

import mock_time

FULL_SCALE = 4095  # counts of the 12 bit converter

_EIO = 5
_ENODEV = 19
_inputs = {}


class AnalogInput:
    """What happens at one ADC input.

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
            raise OSError(_EIO)
        count = self._next_count()
        if count is None:
            raise OSError(_EIO)
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
    """Return the script of the ADC input on this GPIO, 26 to 29."""
    if gpio not in _inputs:
        if not 26 <= gpio <= 29:
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
    """A pin that keeps the level it was given."""

    IN = 0
    OUT = 1
    PULL_UP = 1
    PULL_DOWN = 2

    def __init__(self, id, mode=IN, pull=None, value=0):  # noqa: A002 - the board's own argument names
        self.id = id
        self.mode = mode
        self.pull = pull
        self._level = 1 if value else 0

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
    """An ADC input, by pin, GPIO number (26 to 29) or channel (0 to 3)."""

    def __init__(self, pin):
        number = pin.id if isinstance(pin, Pin) else pin
        self._input = analog(number + 26 if 0 <= number <= 3 and not isinstance(pin, Pin) else number)
        if self._input.absent:
            raise OSError(_ENODEV)

    def read_u16(self):
        """Take a reading of 0 to 65535: the 12 bits at the top and their first four again below, as RP2 does."""
        count = self._input.read_count()
        return (count << 4) | (count >> 8)
