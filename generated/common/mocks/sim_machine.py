# Generated from templates/mocks/sim_machine.py: do not edit.
# Inputs: 4abf3513cad00f00
"""Parts of `machine` that user code may use in a simulation, and the firmware hardly does: SPI, PWM and timers."""

import machine
import mock_time


class PWM:
    """An output that keeps the frequency and the duty cycle that it was given."""

    def __init__(self, dest, freq=0, duty_u16=0, duty_ns=0, invert=False):  # noqa: ARG002 - the board's own names
        self.dest = dest
        self._freq = freq
        self._duty_u16 = duty_u16
        if duty_ns:
            self.duty_ns(duty_ns)

    def init(self, freq=None, duty_u16=None, duty_ns=None):
        """Change what is given."""
        self._freq = self._freq if freq is None else freq
        self._duty_u16 = self._duty_u16 if duty_u16 is None else duty_u16
        if duty_ns is not None:
            self.duty_ns(duty_ns)

    def freq(self, value=None):
        """Return the frequency in Hz, or set it."""
        if value is None:
            return self._freq
        self._freq = value
        return None

    def duty_u16(self, value=None):
        """Return the duty cycle as a share of 65535, or set it."""
        if value is None:
            return self._duty_u16
        self._duty_u16 = value
        return None

    def duty_ns(self, value=None):
        """Return the length of a pulse in ns, or set it."""
        if value is None:
            return self._duty_u16 * 1000000000 // (65535 * self._freq) if self._freq else 0
        self._duty_u16 = min(65535, value * self._freq * 65535 // 1000000000)
        return None

    def deinit(self):
        """Switch it off."""
        self._duty_u16 = 0


class SPI:
    """A bus without anybody on it: what is written is kept in `sent`, what is read is 0."""

    MSB = 0
    LSB = 1

    def __init__(self, id, baudrate=1000000, **settings):  # noqa: A002 - the board's own argument name
        self.id = id
        self.sent = bytearray()
        self.init(baudrate, **settings)

    def init(self, baudrate=1000000, **settings):
        """Set the bus up again."""
        settings["baudrate"] = baudrate
        self.settings = settings

    def write(self, data):
        """Write bytes."""
        self.sent.extend(bytes(data))

    def read(self, size, write=0):  # noqa: ARG002
        """Return so many zeros."""
        return bytes(size)

    def readinto(self, buffer, write=0):  # noqa: ARG002
        """Read zeros into a buffer."""
        for at in range(len(buffer)):
            buffer[at] = 0

    def write_readinto(self, data, buffer):
        """Write, and read zeros."""
        self.write(data)
        self.readinto(buffer)

    def deinit(self):
        """Do nothing."""


class SoftSPI(SPI):
    """The same on any pins."""

    def __init__(self, baudrate=500000, **settings):
        SPI.__init__(self, None, baudrate, **settings)


class Timer:
    """A timer that calls `callback` every `period` ms as the clock goes on."""

    def __init__(self, id=-1, **settings):  # noqa: A002 - the board's own argument name
        self.id = id
        if settings:
            self.init(**settings)

    def init(self, period, callback):
        """Begin."""
        self._period_us = self._left_us = period * 1000
        self._callback = callback
        mock_time.follow(self._follow)

    def deinit(self):
        """Stop it."""
        self._callback = None

    def _follow(self, passed_us):
        self._left_us -= passed_us
        while self._left_us <= 0:
            self._left_us += self._period_us
            if self._callback is not None:
                self._callback(self)


def install():
    """Let modules find them in `machine`, unless that has its own."""
    for cls in (PWM, SPI, SoftSPI, Timer):
        if not hasattr(machine, cls.__name__):
            setattr(machine, cls.__name__, cls)
