"""Values of NMEA 0183 lines are exact, in machine code and in plain Python, however they arrive.

What is expected is worked out here from the standard, with regular expressions and fractions.
"""

import json
import math
import random
import re
import runpy
import struct
import subprocess
import sys
from calendar import timegm
from collections.abc import Iterator
from datetime import UTC, datetime
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from codegen.sources.nmea.kind import OUTPUTS

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(sys.executable).parent
UNKNOWN = -(2**30)
FIX, SATELLITES, LATITUDE, LONGITUDE, ALTITUDE, SPEED, COURSE, HDOP, VDOP, TIME, NEW = 0, 1, 2, 3, 5, 6, 7, 8, 9, 10, 14
TALKERS = ("GP", "GN", "GL", "GA", "GB", "BD")

SCRIPT = """
import json, sys
from array import array
sys.path[:0] = sys.argv[2:]
take = __import__("nmea_" + sys.argv[1]).take
try:
    from micropython import mem_total
except ImportError:
    mem_total = lambda: 0

def run(pieces):
    words, values, line = array("i", [0] * 60), array("i", [-(1 << 30)] * 14 + [0]), bytearray(97)
    used = 0
    for piece in pieces:
        before = mem_total()
        take(words, values, line, piece, len(piece))
        used += mem_total() - before
    return list(values) + list(words[5:8]) + [used]

with open("cases.txt") as file:
    for case in file:
        print(json.dumps(run([bytes.fromhex(piece) for piece in case.split()])))
"""


class Receiver:
    """A reading of a stream of bytes: `values` as the driver has them, and how many lines were taken, wrong or cut."""

    def __init__(self) -> None:
        self.values = [UNKNOWN] * 14 + [0]
        self.lines = self.wrong = self.cut = 0
        self.is_2d = False

    def hear(self, stream: bytes) -> list[int]:
        """Take a whole stream."""
        segments = stream.split(b"$")[1:]
        for number, segment in enumerate(segments):
            text = re.match(rb"[ -)+-~]{0,96}", segment)[0]  # type: ignore[index]
            rest = segment[len(text) :]
            if not rest or (rest[:1] == b"*" and re.fullmatch(rb"[0-9A-Fa-f]?", rest[1:])):
                self.cut += number + 1 < len(segments)  # the stream ends, or another line begins
            elif rest[:1] != b"*":
                self.cut += 1
            elif not re.match(rb"[0-9A-Fa-f]{2}", rest[1:]) or int(rest[1:3], 16) != _sum(text):
                self.wrong += 1
            else:
                self.lines += 1
                self.read(text.decode())
        return [*self.values, self.lines, self.wrong, self.cut]

    def read(self, text: str) -> None:
        """Read a line that is right."""
        head, *fields = text.split(",")
        self.fields = ["", *fields, *[""] * 20]
        if not fields or len(head) != 5 or head[:2] not in TALKERS:
            return
        {"GGA": self.gga, "RMC": self.rmc, "GSA": self.gsa, "VTG": self.vtg}.get(head[2:], lambda: None)()

    def put(self, place: int, value: int | None, bit: int) -> None:
        self.values[place] = UNKNOWN if value is None else value
        self.values[NEW] |= 1 << bit

    def gga(self) -> None:
        quality = self.number(6, 1)
        fix = {1: 3, 2: 4, 3: 3, 4: 6, 5: 5, 9: 3}.get(-1 if quality is None else quality, 1)
        fix = 2 if fix == 3 and self.is_2d else fix
        self.put(FIX, fix, 0)
        self.put(SATELLITES, self.number(7, 1), 1)
        self.put(HDOP, self.number(8, 100), 7)
        self.put(ALTITUDE, self.number(9, 1000) if fix > 2 else None, 4)
        self.position(2 if fix > 1 else None)

    def rmc(self) -> None:
        if self.fields[2][:1] != "A" or self.fields[12][:1] in ("N", "E"):
            self.put(FIX, 1, 0)
            self.put(ALTITUDE, None, 4)
            self.position(None)
            self.motion(None, None)
        else:
            self.position(3)
            self.motion(7, 8)
            self.time()

    def gsa(self) -> None:
        fix = self.number(2, 1)
        self.is_2d = fix == 2
        if fix == 1:
            self.put(FIX, 1, 0)
            self.position(None)
        if fix in (1, 2):
            self.put(ALTITUDE, None, 4)
        self.put(HDOP, self.number(16, 100), 7)
        self.put(VDOP, self.number(17, 100), 8)

    def vtg(self) -> None:
        gone = self.fields[9][:1] in ("N", "E")
        self.motion(*(None, None) if gone else (5, 1))

    def motion(self, knots: int | None, course: int | None) -> None:
        """A knot is 1852 m in an hour; to the nearest cm/s."""
        found = re.fullmatch(r"(-?)(\d{1,8})(\.\d*)?", "" if knots is None else self.fields[knots])
        speed = None
        if found and int(found[2]) < 2000:
            steps = (int(found[2]) + _cut_off(found[3], 7)) * 185200 / 3600
            speed = math.floor(steps + Fraction(1, 2))
        self.put(SPEED, None if found and found[1] and speed else speed, 5)
        course = None if course is None else self.number(course, 100)
        self.put(COURSE, 0 if course == 36000 else course, 6)

    def position(self, field: int | None) -> None:
        self.values[NEW] |= 12
        latitude = None if field is None else self.angle(field, 90, "NS")
        longitude = None if field is None else self.angle(field + 2, 180, "EW")
        self.values[LATITUDE] = self.values[LONGITUDE] = UNKNOWN
        if latitude is not None and longitude is not None:
            self.values[LATITUDE] = latitude
            self.values[LONGITUDE : LONGITUDE + 2] = [longitude & 0xFFFF, longitude >> 16 & 0xFFFF]

    def angle(self, field: int, most: int, sides: str) -> int | None:
        """Degrees, then two digits of minutes, and seven decimals of them: in 1e-7 degrees."""
        found = re.fullmatch(r"(?=.{1,8}(\.|$))(\d*?)(\d{1,2})(\.\d*)?", self.fields[field])
        side = self.fields[field + 1][:1]
        if not found or not side or side not in sides:
            return None
        degrees = int(found[2] or 0)
        minutes = int(found[3]) + _cut_off(found[4], 7)
        exact = degrees + minutes / 60
        if minutes >= 60 or exact > most:
            return None
        steps = degrees * 10**7 + math.floor(minutes * 10**7 / 60 + Fraction(1, 2))
        return -steps if side == sides[1] else steps

    def time(self) -> None:
        clock = re.fullmatch(r"(?=\d{1,8}(\.|$))0*(\d{1,6})(\.\d*)?", self.fields[1])
        date = re.fullmatch(r"(?=\d{1,8}$)0*(\d{1,6})", self.fields[9].split(".")[0])
        if not clock or not date or not re.fullmatch(r"\d+(\.\d*)?", self.fields[9]):
            return
        hours, minutes, seconds = _pairs(clock[2])
        day, month, year = _pairs(date[1])
        if hours > 23 or minutes > 59 or seconds > 60:
            return
        try:
            at = datetime(year + (1900 if year >= 80 else 2000), month, day, hours, minutes, tzinfo=UTC)
        except ValueError:
            return
        micros = (timegm(at.timetuple()) + seconds) * 1000000 + int(_cut_off(clock[3], 3) * 1000000)
        self.values[TIME : TIME + 4] = [micros >> 16 * half & 0xFFFF for half in range(4)]
        self.values[NEW] |= 512

    def number(self, field: int, power: int) -> int | None:
        found = re.fullmatch(r"(-?)(\d{1,8})(\.\d*)?", self.fields[field])
        if not found or int(found[2]) > 9999999 // power * 10:
            return None
        exact = int(found[2]) + Fraction("0" + (found[3] or ".") + "0")
        steps = math.floor(exact * power + Fraction(1, 2))  # a half away from 0
        return -steps if found[1] else steps


def _cut_off(behind: str | None, digits: int) -> Fraction:
    """Return the fraction behind the point, without the digits that are too many."""
    return Fraction("0" + (behind or ".")[: digits + 1] + "0")


def _pairs(digits: str) -> list[int]:
    digits = digits.zfill(6)
    return [int(digits[at : at + 2]) for at in (0, 2, 4)]


def _sum(text: bytes) -> int:
    total = 0
    for byte in text:
        total ^= byte
    return total


chosen = random.Random(183)


def _one(*texts: str) -> str:
    return chosen.choice(texts)


def _decimal(digits: int) -> str:
    whole = str(chosen.randrange(10**digits)) if digits else ""
    return whole + _one("", ".", f".{chosen.randrange(10):d}", f".{chosen.randrange(10**9):09d}", ".5")


def _odd() -> str:
    return _one("", "-", ".", "x", "1x", "1.x", "1.2x", "--1", "-.5", "1.2.3", "123456789", "99999999", "+1", " 1")


def _angle(degrees: int, sides: str) -> str:
    whole = chosen.randrange(degrees * 100)
    ends = (f"{degrees}00.00", f"{degrees}00.0000001", f"{degrees}01", "0", "60", "5959.9999999", "-0100.0")
    value = _one(f"{whole:04d}.{chosen.randrange(10**5):05d}", f"{whole:04d}.{chosen.randrange(10**8):08d}", *ends)
    return f"{value},{_one(*sides, *sides, 'X', '', sides[0] + 'x')}"


def _sentence() -> str:
    """A line, most of them as receivers write them, some of the fields odd."""
    numbers = [_decimal(chosen.choice((1, 2, 3, 5))) for _ in range(20)]
    position = f"{_angle(90, 'NS')},{_angle(180, 'EW')}"
    clock = f"{chosen.randrange(25):02d}{chosen.randrange(61):02d}{chosen.randrange(62):02d}"
    clock += _one("", ".00", ".123", ".9999", ".")
    date = f"{chosen.randrange(33):02d}{chosen.randrange(14):02d}{chosen.randrange(100):02d}"
    height = _one("", "-") + _decimal(4)
    kinds = {
        "GGA": f"{clock},{position},{chosen.randrange(10)},{_decimal(2)},{_decimal(1)},{height},M,,,,",
        "RMC": f"{clock},{_one('A', 'A', 'A', 'V')},{position},{numbers[0]},{_decimal(3)},{date},,,{_one('', *'ADNE')}",
        "GSA": f"A,{_one(*'1233')},{','.join(numbers[:12])},{numbers[12]},{numbers[13]},{numbers[14]}",
        "VTG": f"{_one('360.00', _decimal(3))},T,,M,{numbers[1]},N,{numbers[2]},K{_one('', ',A', ',N', ',E')}",
        "GSV": "2,1,08,01,40,083,46",
    }
    kind = _one(*kinds, *kinds, "gga", "GGAX", "ZDA")
    fields = kinds.get(kind, kinds["GGA"]).split(",")
    if chosen.random() < 0.3:
        fields[chosen.randrange(len(fields))] = _odd()
    if chosen.random() < 0.1:
        fields = fields[: chosen.randrange(len(fields))]
    talker = _one(*TALKERS, *TALKERS, "HC", "P")
    return ",".join([talker + kind, *fields])


def _line() -> bytes:
    """Such a line with its checksum; some are broken on the way."""
    text = _sentence().encode()
    line = b"$" + text + f"*{_sum(text):02X}\r\n".encode()
    if chosen.random() < 0.1:
        line = line.lower().replace(text.lower(), text)
    broken = chosen.random()
    at = chosen.randrange(len(line))
    if broken < 0.05:
        return line[:at]
    if broken < 0.1:
        return line[at:]
    if broken < 0.15:
        return line[:at] + bytes([chosen.randrange(256)]) + line[at + 1 :]
    if broken < 0.18:
        return line[:at] + bytes(chosen.randrange(128, 256) for _ in range(3)) + line[at:]
    if broken < 0.2:
        return line[:2] + b"1," * chosen.randrange(20, 60) + line[2:]
    return line


def cases() -> Iterator[list[bytes]]:
    """Streams in pieces."""
    for number in range(800):
        stream = b"".join(_line() for _ in range(1 + number % 4))
        pieces = []
        while stream:
            length = chosen.randrange(1, 129)
            pieces.append(stream[:length])
            stream = stream[length:]
        yield pieces
    for length in (95, 96, 97):  # the longest line, and one that is too long
        text = b"GPGGA," + b"1" * (length - 6)
        yield [b"$" + text, f"*{_sum(text):02x}".encode()]
    yield [b"$GPGGA,*@9$*00$*", b"0", b"0"]  # the empty line is one


@cache
def all_streams() -> list[list[bytes]]:
    """Return the cases, drawn once."""
    return list(cases())


@pytest.mark.parametrize(
    ("interpreter", "form", "step"),  # words of 32 bits take their time
    [("micropython", "viper", 1), ("micropython", "plain", 1), ("micropython32", "plain", 3), ("python", "plain", 1)],
)
def test_lines_say_what_the_standard_says(interpreter: str, form: str, step: int, tmp_path: Path) -> None:
    """Whatever is broken, and wherever the pieces end; nothing is allocated."""
    streams = all_streams()[::step]
    firmware = ROOT / "codegen" / "sources" / "nmea" / "firmware"
    common = ROOT / "templates" / "firmware"
    for path in (
        *(firmware / f"{name}_{form}.py" for name in ("nmea", "sentences")),
        *(common / name for name in ("polling.py", "guard.py")),
    ):
        (tmp_path / path.name).write_text(path.read_text())
    (tmp_path / "script.py").write_text(SCRIPT)
    lines = (" ".join(piece.hex() for piece in pieces) + "\n" for pieces in streams)
    (tmp_path / "cases.txt").write_text("".join(lines))
    if interpreter == "python":
        (tmp_path / "micropython.py").write_text("def const(value):\n    return value\n")
    command = [str(BIN / interpreter), "script.py", form, "."]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    seen = set()
    for pieces, found in zip(streams, done.stdout.splitlines(), strict=True):
        expected = Receiver().hear(b"".join(pieces))
        assert json.loads(found) == [*expected, 0], b"".join(pieces)
        seen |= {(place, value != UNKNOWN) for place, value in enumerate(expected)}
    assert {(place, True) for place in range(18)} <= seen  # each was known somewhere, and most of them unknown
    assert {(place, False) for place in range(10)} <= seen | {(LONGITUDE + 1, False)}


def test_lines_of_the_generated_suite_are_those_of_the_standard() -> None:
    """The suite's expectations of its driver are written down; here they are worked out anew."""
    listed = runpy.run_path(str(ROOT / "codegen" / "sources" / "nmea" / "tests" / "nmea_lines.py"))
    for text, said in listed["LINES"].values():
        assert _said(text) == said, text
    for kind, field, text, changes in listed["ROWS"]:
        line, said = listed["LINES"][kind]
        fields = line.split(",")
        fields[field] = text
        expected = {name: value for name, value in (said | changes).items() if value is not False}
        assert _said(",".join(fields)) == expected, (kind, field, text)
    assert len(listed["ROWS"]) > 200


def _said(text: str) -> dict[str, int | None]:
    """Return the values that are new after a line, by the names of the outputs."""
    receiver = Receiver()
    receiver.read(text)
    values = receiver.values
    said: dict[str, int | None] = {}
    for bit, name in enumerate((*(output.name for output in OUTPUTS), "time")):
        if values[NEW] >> bit & 1:
            place = bit + (bit > 3)  # longitude has two
            value = values[place]
            if name == "longitude" and value != UNKNOWN:
                value = int.from_bytes(struct.pack("<HH", *values[place : place + 2]), "little", signed=True)
            elif name == "time":
                value = int.from_bytes(struct.pack("<4H", *values[place : place + 4]), "little")
            said[name] = None if value == UNKNOWN else value
    return said
