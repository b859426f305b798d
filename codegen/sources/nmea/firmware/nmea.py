"""A receiver of satellites that speaks NMEA 0183 on a UART: GGA, RMC, GSA and VTG, in whole numbers, without the heap.

Only whole lines count, with the checksum that they have; others are counted in `cut` and `wrong`.
"""

from array import array

from micropython import const
from polling import UNKNOWN

try:
    from nmea_viper import take
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from nmea_plain import take

_NEW = const(14)  # place in `values`, which nmea_plain knows all, as those of the words
_SIZE = const(15)
_PHASE = const(0)
_LINES = const(5)
_WRONG = const(6)
_CUT = const(7)
_WORDS = const(60)
_LONGEST = const(96)  # between the dollar and the star: the standard has 79, some receivers more
_PIECE = const(128)  # bytes that are looked at in one turn, so that it stays short, unless a line brings more


class Nmea:
    """The receiver; `opened` is a function that opens its UART, and a turn takes `piece` bytes at most."""

    def __init__(self, opened, piece=_PIECE):
        self.values = array("i", [UNKNOWN] * _SIZE)
        self.waiting = None
        self._opened = opened
        self._uart = None
        self._piece = bytearray(piece)
        self._line = bytearray(_LONGEST + 1)  # and a comma
        self._words = array("i", [0] * _WORDS)

    @property
    def lines(self):
        """Lines that were taken, counted up to 2 ** 30 as the others."""
        return self._words[_LINES]

    @property
    def wrong(self):
        """Lines with a wrong checksum, or with none behind the star."""
        return self._words[_WRONG]

    @property
    def cut(self):
        """Lines that did not end, were too long, or had in them what is no text."""
        return self._words[_CUT]

    def begin(self):
        """Open the UART."""
        self._uart = self._opened()
        self.waiting = self._uart.any
        self._words[_PHASE] = 0

    def poll(self, _now_ms):
        """Take what waits, as much as a turn has time for; return whether a line said something."""
        values = self.values
        values[_NEW] = 0
        count = self._uart.readinto(self._piece)
        if not count:
            return False
        take(self._words, values, self._line, self._piece, count)
        return values[_NEW] != 0
