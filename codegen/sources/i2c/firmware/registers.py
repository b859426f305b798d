"""Registers of 16 bits of a device on an I2C bus, the high byte first."""


class Registers:
    """Registers of the device at an address; `opened` is a function that opens the bus. OSError: nobody answers."""

    def __init__(self, opened, address):
        self._opened = opened
        self._address = address
        self._bus = None
        self._pair = bytearray(2)

    def open(self):
        """Open the bus, anew after a failure."""
        self._bus = self._opened()

    def read(self, number):
        """Return a register, 0 to 65535."""
        pair = self._pair
        self._bus.readfrom_mem_into(self._address, number, pair)
        return pair[0] << 8 | pair[1]

    def read_signed(self, number):
        """Return a register as a number with a sign."""
        return (self.read(number) ^ 0x8000) - 0x8000

    def write(self, number, value):
        """Set a register."""
        pair = self._pair
        pair[0] = value >> 8
        pair[1] = value & 0xFF
        self._bus.writeto_mem(self._address, number, pair)
