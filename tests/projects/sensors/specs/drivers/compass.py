"""A compass with registers of 16 bits: 0 is the heading in tenths of a degree, 1 the strength of the field."""

from array import array

from polling import UNKNOWN


class Compass:
    """The compass at an address of the bus that `opened` opens."""

    def __init__(self, opened, address, turned, offset):
        self.values = array("i", [UNKNOWN, UNKNOWN])
        self._opened = opened
        self._address = address
        self._offset = (1800 if turned else 0) + round(offset * 10)
        self._bus = None
        self._pair = bytearray(2)

    def begin(self):
        """Open the bus."""
        self._bus = self._opened()

    def poll(self, _now_ms):
        """Read heading and field."""
        self.values[0] = (self._read(0) + self._offset) % 3600
        self.values[1] = self._read(1)
        return True

    def _read(self, number):
        self._bus.readfrom_mem_into(self._address, number, self._pair)
        return self._pair[0] << 8 | self._pair[1]
