"""An I2C bus of a host: devices are models of their registers, which a test can break. machine.I2C is this class."""

import errno

import machine
import mock_time

_devices = {}


class Device:
    """A device with registers of 16 bits.

    `registers` are their values by number, `read_only` the numbers of those that cannot be set. While it is `absent`
    nobody answers; `failures` is how many of the next transfers fail, and `delay_us` the time that each takes. With
    `is_stuck` nothing that is written changes anything. `on_read(number)` and `on_write(number, value)` are called
    before and after; `transfers` counts.
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
        """Read registers, the high byte first."""
        device = self._device(address)
        device.answer()
        _fill(buffer, device, number)

    def readfrom_mem(self, address, number, size, addrsize=8):
        """Return what registers have."""
        buffer = bytearray(size)
        self.readfrom_mem_into(address, number, buffer, addrsize=addrsize)
        return bytes(buffer)

    def writeto_mem(self, address, number, data, addrsize=8):  # noqa: ARG002
        """Set registers, the high byte first."""
        device = self._device(address)
        device.answer()
        for at in range(0, len(data), 2):
            device.write(number + at // 2, data[at] << 8 | data[at + 1])

    def _device(self, address):
        device = _devices.get(self.id << 8 | address)
        if device is None:
            raise OSError(errno.ENODEV)
        return device


def _fill(buffer, device, number):
    """Read registers into a buffer, in functions of few variables: those of larger ones lie on the heap."""
    at = 0
    while at < len(buffer):
        _put(buffer, at, device.read(number))
        number += 1
        at += 2


def _put(buffer, at, value):
    buffer[at] = value >> 8
    buffer[at + 1] = value & 0xFF


machine.I2C = I2C
