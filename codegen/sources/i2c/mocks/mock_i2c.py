"""An I2C bus of a host: devices are models of what they answer, which a test can break. machine.I2C is this class.

There are devices with registers of 16 bits (Device), with registers of 8 bits (Bytes), and without registers
(Commands).
"""

import errno

import machine
import mock_time

_devices = {}


class Device:
    """A device with registers of 16 bits, the high byte first.

    `registers` are their values by number, `read_only` the numbers of those that cannot be set. While it is `absent`
    nobody answers; `failures` is how many of the next transfers fail, and `delay_us` the time that each takes. With
    `is_stuck` nothing that is written changes anything. `on_read(number)` and `on_write(number, value)` are called
    before and after; `transfers` counts. What is read without the number of a register is of the one that was written
    last.
    """

    def __init__(self, registers, read_only=()):
        self.registers = dict(registers)
        self.read_only = read_only
        self.absent = False
        self.failures = 0
        self.delay_us = 0
        self.is_stuck = False
        self.transfers = 0
        self.on_read = None
        self.on_write = None
        self._number = 0

    def answer(self):
        """Take part in a transfer; OSError if it fails."""
        self.transfers += 1
        mock_time.advance_us(self.delay_us)
        if self.absent:
            raise OSError(errno.ENODEV)
        if self.failures > 0:
            self.failures -= 1
            raise OSError(errno.EIO)

    def read(self, number):
        """Return a register, 0xFFFF where there is none."""
        if self.on_read is not None:
            self.on_read(number)
        return self.registers.get(number, 0xFFFF)

    def write(self, number, value):
        """Set a register."""
        if not self.is_stuck and number not in self.read_only:
            self.registers[number] = value
            if self.on_write is not None:
                self.on_write(number, value)

    def fill(self, number, buffer):
        """Read registers from a number on, in functions of few variables: those of larger ones lie on the heap."""
        at = 0
        while at < len(buffer):
            _put(buffer, at, self.read(number))
            number += 1
            at += 2

    def store(self, number, data):
        """Set registers from a number on."""
        if len(data) % 2:
            raise OSError(errno.EIO)  # half a register
        for at in range(0, len(data), 2):
            self.write(number + at // 2, data[at] << 8 | data[at + 1])

    def received(self, data):
        """Take what is written without more: the number of a register, and what is to be stored from there on."""
        if len(data):
            self._number = data[0]
            self.store(data[0], data[1:])

    def give(self, buffer):
        """Read without more, from the register that was written last."""
        self.fill(self._number, buffer)


class Bytes(Device):
    """The same with registers of 8 bits; `registers` has a byte for a number, or some in a row from there on.

    What is read without the number of a register goes on behind what was read before.
    """

    def __init__(self, registers, read_only=()):
        single = {}
        for number, value in registers.items():
            for at, byte in enumerate([value] if isinstance(value, int) else value):
                single[number + at] = byte
        Device.__init__(self, single, read_only)

    def read(self, number):
        """Return a register, 0xFF where there is none."""
        return Device.read(self, number) & 0xFF

    def fill(self, number, buffer):
        """Read registers from a number on."""
        at = 0
        while at < len(buffer):
            buffer[at] = self.read(number)
            number += 1
            at += 1

    def store(self, number, data):
        """Set registers from a number on."""
        for at in range(len(data)):
            self.write(number + at, data[at])

    def give(self, buffer):
        """Read without more, and go on behind that."""
        self.fill(self._number, buffer)
        self._number += len(buffer)


class Commands(Device):
    """A device without registers: `answers` has, by the bytes that were written last, what is read then.

    A transfer with which it can do nothing fails. `written` has what arrived; `on_write(data, None)` is called then.
    """

    def __init__(self, answers):
        Device.__init__(self, {})
        self.answers = dict(answers)
        self.written = []

    def received(self, data):
        """Take a command."""
        self.written.append(bytes(data))
        if self.on_write is not None:
            self.on_write(bytes(data), None)

    def give(self, buffer):
        """Give the answer to the last command, and ones behind it, as a bus reads that nobody pulls down."""
        answer = self.answers.get(self.written[-1] if self.written else b"")
        if answer is None:
            raise OSError(errno.EIO)
        for at in range(len(buffer)):
            buffer[at] = answer[at] if at < len(answer) else 0xFF

    def fill(self, number, buffer):
        """Take a number as a command, and give its answer."""
        self.received(bytes([number]))
        self.give(buffer)

    def store(self, number, data):
        """Take a number and what follows as a command."""
        self.received(bytes([number]) + bytes(data))


def attach(bus, address, device):
    """Connect a device to a bus; return it. None disconnects what is there."""
    _devices[bus << 8 | address] = device
    return device


def detach_all():
    """Leave nothing on any bus."""
    _devices.clear()


class I2C:
    """A bus by its number; `settings` is what it was opened with."""

    def __init__(self, id, **settings):  # noqa: A002 - the board's own argument name
        self.id = id
        self.settings = settings

    def scan(self):
        """Return the addresses at which something answers."""
        return [at for at in range(8, 120) if (found := _devices.get(self.id << 8 | at)) and not found.absent]

    def readfrom_mem_into(self, address, number, buffer, addrsize=8):  # noqa: ARG002
        """Read registers."""
        device = self._device(address)
        device.answer()
        device.fill(number, buffer)

    def readfrom_mem(self, address, number, size, addrsize=8):
        """Return what registers have."""
        buffer = bytearray(size)
        self.readfrom_mem_into(address, number, buffer, addrsize=addrsize)
        return bytes(buffer)

    def writeto_mem(self, address, number, data, addrsize=8):  # noqa: ARG002
        """Set registers."""
        device = self._device(address)
        device.answer()
        device.store(number, data)

    def readfrom_into(self, address, buffer, stop=True):  # noqa: ARG002
        """Read into a buffer."""
        device = self._device(address)
        device.answer()
        device.give(buffer)

    def readfrom(self, address, size, stop=True):
        """Return what is read."""
        buffer = bytearray(size)
        self.readfrom_into(address, buffer, stop)
        return bytes(buffer)

    def writeto(self, address, data, stop=True):  # noqa: ARG002
        """Write; return how many bytes were taken."""
        device = self._device(address)
        device.answer()
        device.received(data)
        return len(data)

    def _device(self, address):
        device = _devices.get(self.id << 8 | address)
        if device is None:
            raise OSError(errno.ENODEV)
        return device


def _put(buffer, at, value):
    buffer[at] = value >> 8
    if at + 1 < len(buffer):
        buffer[at + 1] = value & 0xFF


machine.I2C = I2C
