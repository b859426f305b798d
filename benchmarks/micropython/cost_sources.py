"""Turns of sensors with nothing to do, and lines of a receiver of satellites. See counting.py.

The project is tests/projects/sensors. A method in C with little to do stands in for that of a UART which tells how much
waits: no bytes are a word without spaces.
"""

import counting  # isort: skip  before anybody looks at the clock
from array import array

import micropython
from nmea_viper import take
from sources import Sources
from state import SystemState
from turns_viper import asking

LATER, SINCE = 50000, -5  # when something is due, for a clock that stands still at 0

GGA = b"$GPGGA,123519.00,4807.038,N,01131.000,E,1,08,0.9,545.4,M,47.0,M,,*61\r\n"
RMC = b"$GPRMC,123520.50,A,3521.79726,S,13941.40000,W,022.4,360.00,190926,,,A*65\r\n"
GSA = b"$GPGSA,A,3,04,05,,09,12,,,24,,,,,2.5,1.3,2.1*39\r\n"
VTG = b"$GPVTG,054.7,T,034.4,M,005.5,N,010.2,K*48\r\n"
GSV = b"$GPGSV,2,1,08,01,40,083,46,02,17,308,41,12,07,344,39,14,22,228,45*75\r\n"


class Uart:
    """A UART on which one line arrives before each turn."""

    any = b"".isspace

    def readinto(self, buffer):
        """Let it arrive."""
        buffer[: len(GGA)] = GGA
        return len(GGA)


sources = Sources(SystemState(log=print))
receiver = sources.receiver
driver = receiver.driver
driver._opened = Uart  # no pins here
receiver.turn()


def looks(turns, due):
    """Return a workload: a look for what is due, with the last of the sensors due or not."""
    times = array("i", [len(turns)] + [LATER, 100000] * len(turns))
    last = len(times) - 2
    ask = asking(times, turns, 1)

    def work(rounds):
        for _ in range(rounds):
            times[last] = due
            ask()

    return work


@micropython.native
def native(rounds):
    """Do nothing, as nothing() does, in machine code."""
    for _ in range(rounds):
        pass


@micropython.native
def idle(rounds):
    """Have the turn of a receiver that has said nothing, as ask() does."""
    look = receiver._calls[receiver._place]
    for _ in range(rounds):
        if look():
            receiver.turn()


def takes(line):
    """Return a workload: a line has arrived."""
    piece = bytearray(128)
    piece[: len(line)] = line
    length = len(line)

    def work(rounds):
        words, values, text = driver._words, driver.values, driver._line
        before = driver.lines
        for _ in range(rounds):
            take(words, values, text, piece, length)
        return driver.lines - before

    return work


def whole_turn(rounds):
    """Have a turn in which a line has arrived."""
    turn = receiver.turn
    for _ in range(rounds):
        turn()


def no_turn():
    """Stand for the turn of a sensor."""


counting.count(
    native=native,
    no_sensor=looks([no_turn], LATER),
    every_sensor=looks([source.turn for source in sources.every] + [no_turn], LATER),
    idle=idle,
    gga=takes(GGA),
    rmc=takes(RMC),
    gsa=takes(GSA),
    vtg=takes(VTG),
    gsv=takes(GSV),
    turn=whole_turn,
)
