"""Checks of the driver with lines of NMEA 0183, and with lines that are none, from a UART that a check fills.

As a program it prints one JSON object: what went wrong in each check, or null.
"""

import json
import sys

from nmea import Nmea
from nmea_lines import LINES, ROWS
from sim_nmea import checksum

try:
    from micropython import mem_total  # bytes that were ever allocated
except ImportError:  # CPython, and boards

    def mem_total():
        return 0


UNKNOWN = -0x3FFFFFFF - 1
OUTPUTS = ("fix", "satellites", "latitude", "longitude", "altitude", "speed", "course", "hdop", "vdop", "time")
PLACES = (0, 1, 2, 3, 5, 6, 7, 8, 9, 10)  # of the outputs among the driver's values
NEW = 14
GGA = LINES["GGA"][0]


class Uart:
    """Gives what waits, a piece at a time."""

    def __init__(self):
        self.waiting = b""

    def any(self):
        return len(self.waiting)

    def readinto(self, buffer):
        count = min(len(buffer), len(self.waiting))
        buffer[:count] = self.waiting[:count]
        self.waiting = self.waiting[count:]
        return count or None


class Again:
    """Gives the same again and again, without the heap."""

    def __init__(self, data):
        self.data = data

    def readinto(self, buffer):
        at = 0
        while at < len(self.data):
            buffer[at] = self.data[at]
            at += 1
        return at


class Bench:
    """A driver on such a UART."""

    def __init__(self):
        self.uart = Uart()
        self.driver = Nmea(lambda: self.uart)
        self.driver.begin()
        self.hear(b"0" * 128)  # of what is left in its buffer nothing is read again

    def hear(self, data, piece=128):
        """Let bytes arrive in pieces of a size; return what they say that is new, by outputs."""
        said = {}
        for at in range(0, len(data), piece):
            self.uart.waiting = data[at : at + piece]
            assert self.driver.waiting() == len(self.uart.waiting)
            is_new = self.driver.poll(0)
            assert is_new == (self.driver.values[NEW] != 0)
            said.update(self._said())
        return said

    def _said(self):
        values = self.driver.values
        said = {}
        for bit, name in enumerate(OUTPUTS):
            if values[NEW] >> bit & 1:
                place = PLACES[bit]
                value = values[place]
                if name == "longitude" and value != UNKNOWN:
                    value |= values[place + 1] << 16
                    value -= value >> 31 << 32
                elif name == "time":
                    value = sum([values[place + half] << 16 * half for half in range(4)])
                said[name] = None if value == UNKNOWN else value
        return said

    def counts(self):
        """Return how many lines were taken, had a wrong checksum, and were cut."""
        return self.driver.lines, self.driver.wrong, self.driver.cut


def told():
    """Return a bench that has heard all that there is, GGA last: so that what is said otherwise is seen."""
    bench = Bench()
    for kind in ("GSA", "VTG", "RMC", "GGA"):
        bench.hear(line(LINES[kind][0]))
    return bench


def line(text):
    """Return a whole line."""
    return b"$" + text.encode() + b"*" + (b"%02X" % checksum(text)) + b"\r\n"


def varied(kind, field, text):
    """Return a line of a kind with something else in a field."""
    fields = LINES[kind][0].split(",")
    fields[field] = text
    return ",".join(fields)


def each_kind_says_what_it_has():
    """All of it is new, and nothing else, from each kind of satellites; other talkers and types say nothing."""
    for text, said in LINES.values():
        for talker in ("GP", "GN", "GL", "GA", "GB", "BD"):
            found = told().hear(line(talker + text[2:]))
            assert found == said, (talker, text, found)
        for talker in ("GO", "GM", "GQ", "GC", "GK", "BE", "BC", "HP", "FP", "gp", "BP", "GD", "P"):
            bench = told()
            assert bench.hear(line(talker + text[2:])) == {}, (talker, text)
            assert bench.counts() == (5, 0, 0)
        for kind in (text[2:4] + chr(ord(text[4]) + 1), text[2:4], text[2:5].lower(), text[2:5] + "X", "GSV", "ZDA"):
            assert told().hear(line("GP" + kind + text[5:])) == {}, (kind, text)
    for text in ("", "G", "GPGGA", "GPGG,"):
        bench = Bench()
        assert bench.hear(line(text)) == {}, text
        assert bench.counts() == (1, 0, 0), text
    assert set(Bench().hear(line("GPGGA,"))) == set(LINES["GGA"][1])  # its fields are empty


def each_field_says_what_stands_in_it():
    """Numbers with a sign and behind the point, angles, letters, times and days: at their ends, and what is none."""
    for kind, field, text, changes in ROWS:
        expected = {name: value for name, value in LINES[kind][1].items() if changes.get(name) is not False}
        expected.update({name: value for name, value in changes.items() if value is not False})
        found = told().hear(line(varied(kind, field, text)))
        assert found == expected, (kind, field, text, found)


def the_south_and_the_west_are_below_zero():
    """Each angle that there is to the north or to the east."""
    for kind, field, text, changes in ROWS:
        if kind == "GGA" and field in (2, 4):
            fields = varied(kind, field, text).split(",")
            fields[3], fields[5] = "S", "W"
            expected = dict(LINES[kind][1])
            expected.update(changes)
            for name in ("latitude", "longitude"):
                expected[name] = None if expected[name] is None else -expected[name]
            found = told().hear(line(",".join(fields)))
            assert found == expected, (field, text, found)


def a_fix_without_height_is_remembered():
    """Once GSA has said that a fix is flat, GGA has no height for it, until GSA says otherwise."""
    bench = Bench()
    for dimension, fixes in (("3", (3, 4)), ("2", (2, 4)), ("", (3, 4)), ("2", (2, 4)), ("1", (3, 4)), ("2", (2, 4))):
        bench.hear(line(varied("GSA", 2, dimension)))
        for quality, fix in (("1", fixes[0]), ("3", fixes[0]), ("2", fixes[1]), ("9", fixes[0])):
            said = bench.hear(line(varied("GGA", 6, quality)))
            assert said["fix"] == fix, (dimension, quality, said)
            assert said["altitude"] == (None if fix == 2 else LINES["GGA"][1]["altitude"]), (dimension, quality, said)


def whole_lines_count():
    """A line begins with a dollar, has text, and ends with its checksum; others are counted by their fault."""
    good = line(GGA)
    for data, lines, wrong, cut in (
        (good, 1, 0, 0),
        (good * 3, 3, 0, 0),
        (b"noise*00\r\n" + good, 1, 0, 0),
        (good[1:], 0, 0, 0),
        (good[:-2].lower().replace(GGA.lower().encode(), GGA.encode()), 1, 0, 0),
        (good[:20] + good, 1, 0, 1),
        (b"$" + good, 1, 0, 1),
        (good[:-4] + good, 1, 0, 1),
        (good[:-3] + good, 1, 0, 1),
        (good[:-5] + b"\r\n" + good, 1, 0, 1),
        (good[:-4] + b"\r\n" + good, 1, 1, 0),
        (b"$*00$*0", 1, 0, 0),
        (b"$*0" + good, 1, 0, 1),
        (b"$*01", 0, 1, 0),
        (b"$*10", 0, 1, 0),
    ):
        for piece in (1, 7, 128):
            bench = Bench()
            said = bench.hear(data, piece)
            assert bench.counts() == (lines, wrong, cut), (data, piece, bench.counts())
            assert said == (LINES["GGA"][1] if good in data or (lines and b"GGA" in data) else {}), (data, said)
    for byte in range(256):
        begins = byte == 36  # a dollar
        if not begins and byte != 42:
            bench = Bench()
            is_text = 32 <= byte <= 126
            bench.hear(b"$GPTXT," + bytes([byte]) + (b"*%02x" % (checksum("GPTXT,") ^ byte)))
            assert bench.counts() == (is_text, 0, not is_text), (byte, bench.counts())
        for half, digits in ((b"$*", b"0123456789abcdefABCDEF"), (b"$0*3", b"0")):  # the checksum of "0" is 30
            bench = Bench()
            bench.hear(half + bytes([byte]))
            is_digit = byte in digits
            is_whole = is_digit and half == b"$0*3"
            assert bench.counts() == (is_whole, not is_digit and not begins, begins), (half, byte, bench.counts())


def each_digit_of_a_checksum_counts():
    """All 256 of them, in capitals or not; each other one is wrong."""
    for high in range(4):
        for low in range(32, 127):
            text = chr(low) + (chr(high + 64) if high else "")
            if "$" in text or "*" in text:
                continue
            bench = Bench()
            bench.hear(line(text))
            bench.hear(b"$" + text.encode() + (b"*%02x" % checksum(text)))
            bench.hear(b"$" + text.encode() + (b"*%02X" % (checksum(text) ^ 1)))
            bench.hear(b"$" + text.encode() + (b"*%02X" % (checksum(text) ^ 16)))
            assert bench.counts() == (2, 2, 0), text


def lines_have_a_longest():
    """96 characters between the dollar and the star; what is longer is cut, and the next line counts."""
    for length in (95, 96, 97):
        for fill in ("0", " "):  # usual characters, and others
            bench = Bench()
            text = GGA + fill * (length - len(GGA))
            said = bench.hear(line(text))
            assert bench.counts() == ((1, 0, 0) if length <= 96 else (0, 0, 1)), (length, bench.counts())
            assert said == (LINES["GGA"][1] if length <= 96 else {}), (length, said)
            bench.hear(line(GGA))
            assert bench.counts()[0] == (2 if length <= 96 else 1), (length, bench.counts())


def a_new_beginning_forgets_half_a_line():
    """Once the UART is opened again, a line that was not whole is over."""
    bench = Bench()
    half = line(GGA)
    bench.hear(half[:30])
    bench.driver.begin()
    assert bench.hear(half[30:]) == {}
    assert bench.counts() == (0, 0, 0)
    assert bench.hear(half) == LINES["GGA"][1]
    assert bench.driver.poll(0) is False, "nothing waits"
    bench.uart.waiting = bytes(300)
    bench.driver.poll(0)
    assert bench.driver.waiting() == 300 - 128, "a turn stays short"
    fast = Nmea(lambda: bench.uart, 240)
    fast.begin()
    bench.uart.waiting = line(GGA) * 4
    fast.poll(0)
    assert fast.waiting() == 4 * len(line(GGA)) - 240, "it takes what its line brings"
    assert fast.lines == 240 // len(line(GGA))


def counts_stay_small():
    """Each count goes round at 2 ** 30, where a board's whole numbers end that need no heap."""
    bench = Bench()
    for place in (5, 6, 7):
        bench.driver._words[place] = 0x3FFFFFFF
    bench.hear(line(GGA) + b"$*01$$*00")
    assert bench.counts() == (1, 0, 0), bench.counts()


def lines_take_nothing_from_the_heap():
    """Nothing is allocated, whatever the lines say."""
    for text in [LINES[kind][0] for kind in LINES] + ["", "GPTXT,x"]:
        bench = Bench()
        bench.driver._uart = Again(line(text))
        bench.driver.poll(0)
        before = mem_total()
        bench.driver.poll(0)
        assert mem_total() == before, text


CHECKS = (
    each_kind_says_what_it_has,
    each_field_says_what_stands_in_it,
    the_south_and_the_west_are_below_zero,
    a_fix_without_height_is_remembered,
    whole_lines_count,
    each_digit_of_a_checksum_counts,
    lines_have_a_longest,
    a_new_beginning_forgets_half_a_line,
    counts_stay_small,
    lines_take_nothing_from_the_heap,
)


def main():
    found = {}
    for check in CHECKS:
        found[check.__name__] = None
        try:
            check()
        except Exception as error:
            found[check.__name__] = f"{type(error).__name__}: {error}"
            if "-v" in sys.argv:
                raise
    print(json.dumps(found))


if __name__ == "__main__":
    main()
