"""The echo sounder: it says some ten times per second how far the ground is, on a UART.

Each report has four bytes: 0xFF, the distance in millimetres (high byte, low byte), and the low byte of their sum.
"""

from machine import UART

_START = 0xFF


class Sounder:
    """Reads the last whole report; `sources: sounder` of specs/board.yaml asks for it."""

    def __init__(self):
        self._uart = UART(1, baudrate=9600, tx=26, rx=25, timeout=0)
        self._byte = bytearray(1)
        self._report = bytearray(4)
        self._length = 0

    def read(self):
        """Return the distance to the ground in metres; OSError when nothing came since the last time."""
        found_mm = None
        for _ in range(min(self._uart.any(), 64)):
            self._uart.readinto(self._byte)
            if self._takes(self._byte[0]):
                found_mm = self._report[1] << 8 | self._report[2]
        if found_mm is None:
            raise OSError("silent")
        return found_mm / 1000 if found_mm else None  # 0 is what it says when it hears no echo

    def _takes(self, byte):
        """Put a byte where it belongs; return whether a report is whole and right."""
        report = self._report
        if self._length == 0 and byte != _START:
            return False
        report[self._length] = byte
        self._length += 1
        if self._length < len(report):
            return False
        self._length = 0
        return (report[0] + report[1] + report[2]) & 0xFF == report[3]
