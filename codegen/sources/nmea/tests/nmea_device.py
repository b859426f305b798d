"""A receiver of satellites at a UART: lines of NMEA 0183."""

import machine
from sim_nmea import checksum

_MOST_TURNS = 20  # until everything is read


class Device:
    """The receiver at the UART of the tables."""

    def __init__(self, settings):
        self._line = machine.serial(settings["uart"])

    def show(self, shown, turn):
        """Say lines, and let them be read."""
        for text in shown["lines"]:
            self._line.arrives(f"${text}*{checksum(text):02X}\r\n".encode())
        for _ in range(_MOST_TURNS):
            if self._line.waiting():
                turn()

    def check(self):
        """Return nothing: nothing is set."""
        return ""
