"""Drives the sensors of this project by their mocks, and prints what becomes of it as one JSON object, by name."""

import json
import sys
from array import array

sys.path[:0] = ["generated/firmware", "generated/mocks"]

import mock_time

mock_time.install()

import machine
import mock_i2c
import mock_pulse
from sources import Sources
from state import SystemState

try:
    from micropython import mem_total
except ImportError:

    def mem_total():
        return 0


told = []
found = {}


def log(*words):
    told.append(" ".join([str(word) for word in words]))


def fresh():
    """Return a new state with sensors, at 5 s, with nothing connected."""
    mock_time.set_ticks_us(5000000)
    mock_i2c.detach_all()
    machine.reset_serial()
    del told[:]
    state = SystemState(log=log)
    return state, Sources(state, log)


def sentence(text):
    """Return a line with its checksum."""
    total = 0
    for byte in text.encode():
        total ^= byte
    return f"${text}*{total:02X}\r\n".encode()


# The receiver of satellites.

GGA = "GPGGA,123519.00,4807.038,N,01131.000,E,1,08,0.9,545.4,M,47.0,M,,"
RMC = "GPRMC,123520.50,A,3521.79726,S,13941.40000,W,022.4,360.00,190926,,,A"


def position(gps):
    return [gps.fix, gps.lat_dege7, gps.lon_dege7, gps.alt_mm, gps.satellites_number]


def motion(gps):
    return [gps.speed_cm_s, gps.course_cdeg, gps.hdop_steps, gps.vdop_steps]


def hear(sources, data, turns=3):
    machine.serial(1).arrives(data)
    for _ in range(turns):
        mock_time.advance_us(50000)
        sources.receiver.turn()


state, sources = fresh()
gps = state.gps
hear(sources, b"")
found["nothing yet"] = position(gps) + motion(gps)
found["uart"] = {name: machine.serial(1).settings[name] for name in ("baudrate", "timeout", "rxbuf")}
hear(sources, sentence(GGA))
found["gga"] = position(gps) + motion(gps)
hear(sources, sentence(RMC))
found["rmc"] = position(gps) + motion(gps) + [str(state.clock.unix_us)]
hear(sources, sentence("GNVTG,054.75,T,034.4,M,005.5,N,010.2,K,D"))
found["vtg"] = motion(gps)
hear(sources, sentence("GNGSA,A,3,80,71,73,79,69,,,,,,,,1.83,1.09,1.47"))
found["gsa"] = motion(gps)
hear(sources, sentence("GNGSA,A,2,80,71,73,79,69,,,,,,,,1.83,1.09,1.47") + sentence(GGA))
found["flat"] = position(gps)
hear(sources, sentence("GNGSA,A,3,80,71,73,79,69,,,,,,,,1.83,1.09,1.47"))
for quality in (0, 2, 4, 5, 6, 8, 3):
    hear(sources, sentence(GGA.replace("E,1,", f"E,{quality},")))
    found[f"quality {quality}"] = position(gps)
hear(sources, sentence(RMC.replace(",A,35", ",V,35")))
found["void"] = position(gps) + motion(gps)
hear(sources, sentence(GGA) + sentence(RMC))
hear(sources, sentence("GNVTG,,T,,M,,N,,K,N"))
found["no motion"] = motion(gps)

# Ends, and what cannot be.
ends = {}
for name, text in (
    ("north pole", "GPGGA,000000,9000.0000,N,18000.0000,W,1,12,99.99,-999.999,M,,M,,"),
    ("beyond north", "GPGGA,000000,9000.0001,N,01131.0,E,1,12,1.0,0.0,M,,M,,"),
    ("beyond west", "GPGGA,000000,4500.0,N,18000.0001,W,1,12,1.0,0.0,M,,M,,"),
    ("just south", "GPGGA,000000,0000.000001,S,00000.000001,W,1,12,1.0,0.0,M,,M,,"),
    ("date line", "GPGGA,000000,0000.0,S,17959.99999999,E,1,12,1.0,0.0,M,,M,,"),
    ("half a word", "GPGGA,000000,4500.0,N,00000.393216,W,1,12,1.0,0.0,M,,M,,"),
    ("60 minutes", "GPGGA,000000,4560.0,N,01131.0,E,1,12,1.0,0.0,M,,M,,"),
    ("no side", "GPGGA,000000,4500.0,,01131.0,E,1,12,1.0,0.0,M,,M,,"),
    ("letters", "GPGGA,000000,45x0.0,N,01131.0,E,1,ab,1.0,0.0,M,,M,,"),
    ("too long", "GPGGA,000000,4500.0,N,01131.0,E,1,12,1.0,123456789.0,M,,M,,"),
    ("short", "GPGGA,000000,4500.0,N"),
    ("empty", "GPGGA,,,,,,,,,,,,,,"),
):
    state, sources = fresh()
    hear(sources, sentence(text))
    ends[name] = position(state.gps) + [state.gps.hdop_steps]
found["ends"] = ends

# Which lines are taken.
state, sources = fresh()
receiver = sources.receiver.driver
for talker in ("GP", "GN", "GL", "GA", "GB", "BD", "HC", "gp"):
    before = state.gps.satellites_number
    hear(sources, sentence(GGA.replace("GP", talker, 1).replace(",08,", f",{len(talker) + (before or 0):02},")))
found["talkers"] = [state.gps.satellites_number, receiver.lines]

state, sources = fresh()
receiver = sources.receiver.driver
line = sentence(GGA)
hear(sources, line.replace(b"4807", b"4808"))
found["wrong"] = position(state.gps) + [receiver.lines, receiver.wrong, receiver.cut]
hear(sources, line[:30])
hear(sources, line[20:])
hear(sources, line[:40] + line)
found["joined"] = [receiver.lines, receiver.wrong, receiver.cut]
hear(sources, line[:30] + b"\r\n" + line[30:])
hear(sources, b"$" + b"G" * 200 + b"*00\r\n")
hear(sources, line.replace(b"*", b"*G"))
hear(sources, line.split(b"*")[0] + b"\r\n")
hear(sources, bytes(range(128, 256)) + b"\x00\xff" + line.lower()[:5])
found["bad lines"] = [receiver.lines, receiver.wrong, receiver.cut]
hear(sources, line[:10])
hear(sources, line[10:33])
hear(sources, line[33:])
found["in pieces"] = [receiver.lines, receiver.wrong, receiver.cut, state.gps.lat_dege7]
hear(sources, line.replace(line[-4:-2], line[-4:-2].lower()))
found["small letters"] = receiver.lines

# A flood: a turn takes 128 bytes, the rest waits; noise of a thousand bytes, then a line.
state, sources = fresh()
receiver = sources.receiver.driver
machine.serial(1).arrives(line * 10)
sources.receiver.turn()
sources.receiver.turn()
found["flood"] = [receiver.lines, machine.serial(1).waiting(), len(line)]
noise = bytearray((at * 7919 + at // 3) & 0xFF for at in range(1000))
hear(sources, bytes(noise) + b"\r\n" + line, 20)
found["after noise"] = position(state.gps)

# Dates.
dates = {}
for clock, date in (
    ("000000.00", "010100"),
    ("235959.999", "311299"),
    ("120000.00", "290224"),
    ("120000.00", "290223"),
    ("120000.00", "310426"),
    ("120000", "010380"),
    ("235960.00", "311216"),
    ("240000.00", "010126"),
    ("126000.00", "010126"),
    ("120000.00", "320126"),
    ("120000.00", "011326"),
    ("120000.00", ""),
    ("120000.00", "190138"),
):
    state, sources = fresh()
    hear(sources, sentence(RMC.replace("123520.50", clock).replace("190926", date)), 1)
    unix = state.clock.unix_us
    dates[clock + " " + date] = None if unix is None else str(unix)
found["dates"] = dates

# The clock is left alone while it is right to the second.
state, sources = fresh()
kept = []
for clock in ("120000.00", "120000.90", "120001.00", "120009.00", "120003.00"):
    hear(sources, sentence(RMC.replace("123520.50", clock)), 1)
    kept.append(state.clock.unix_us // 1000 - 1789819200000)
found["clock"] = kept

# Nothing is heard for a while, and then again.
state, sources = fresh()
hear(sources, sentence(GGA))
was_known = state.gps.lat_dege7
for _ in range(20):
    mock_time.advance_us(500000)
    sources.receiver.turn()
    sources.watch()
found["silent"] = [was_known, position(state.gps), list(told)]
hear(sources, sentence(GGA))
hear(sources, sentence(GGA), 20)
found["heard again"] = [position(state.gps), told[-1]]
state, sources = fresh()
machine.serial(1).absent = True
hear(sources, b"", 1)
found["no uart"] = list(told)
state, sources = fresh()
hear(sources, sentence(GGA))
machine.serial(1).failures = 2
hear(sources, b"x", 2)
found["uart fails"] = [told[-1], sources.receiver.failures, sources.receiver.is_down]

# Turns allocate nothing, with a line and without.
state, sources = fresh()
every = b"".join(sentence(text) for text in (GGA, RMC, "GNVTG,054.75,T,034.4,M,005.5,N,010.2,K,D", GGA))
hear(sources, every, 5)


class Line:
    """A UART that gives a piece of a text each time, without using the heap itself."""

    def __init__(self, text):
        self.text = text
        self.at = 0

    def any(self):
        return 1

    def readinto(self, buffer):
        for at in range(len(buffer)):
            buffer[at] = self.text[self.at]
            self.at = (self.at + 1) % len(self.text)
        return len(buffer)


sources.receiver.driver._uart = Line(every)
for _ in range(3):
    sources.receiver.turn()
before = mem_total()
for _ in range(20):
    sources.receiver.turn()
found["nmea allocates"] = [mem_total() - before, sources.receiver.driver.wrong]

# The monitors on the I2C bus.


def ina226():
    device = mock_i2c.Device(
        {0: 0x4127, 1: 0, 2: 0, 3: 0, 4: 0, 5: 0, 6: 8, 0xFE: 0x5449, 0xFF: 0x2260}, (1, 2, 0xFE, 0xFF)
    )
    return mock_i2c.attach(0, 0x40, device)


def ina219():
    device = mock_i2c.Device({0: 0x399F, 1: 0, 2: 2, 3: 0, 4: 0, 5: 0}, (1, 2, 3))

    def written(number, value):
        if number == 0 and value & 0x8000:
            device.registers[0] = 0x399F

    device.on_write = written
    return mock_i2c.attach(0, 0x41, device)


def pack(state):
    return [state.pack.voltage_mv, state.pack.current_ca, state.pack.power_mw]


state, sources = fresh()
device, panel = ina226(), ina219()
device.registers[1], device.registers[2] = 4000, 9600  # 10 mV across 2 mOhm, 12 V
panel.registers[1], panel.registers[2] = 1234, 4321 << 3 | 2
sources.power.turn()
sources.solar.turn()
found["monitors"] = pack(state) + [state.panel.voltage_steps]
found["panel"] = [state.panel.voltage, state.panel.current]
found["settings"] = [device.registers[0], panel.registers[0], sources.power.driver._registers._bus.settings["freq"]]
readings = {}
for name, shunt, volts in (
    ("drawn", 0x0001, 1),
    ("charged", 0xFFFF, 28800),
    ("most", 0x7FFE, 28800),
    ("least", 0x8002, 28800),
    ("too much", 0x7FFF, 28799),
    ("too little", 0x8000, 0),
    ("beyond", 4, 28801),
    ("broken", 0xFFFF, 0xFFFF),
):
    device.registers[1], device.registers[2] = shunt, volts
    sources.power.turn()
    readings[name] = pack(state)
found["readings"] = readings

device.registers[1], device.registers[2] = 4000, 9600
sources.power.turn()
device.registers[6] = 0
device.registers[2] = 8000
sources.power.turn()
found["not converted"] = pack(state)
mock_time.advance_us(78000)  # twice 16 conversions of 1.21 ms, of the bus and of the shunt
sources.power.turn()
found["converts still"] = list(told)
mock_time.advance_us(1000)
sources.power.turn()
found["converts no more"] = told[-1]
device.registers[6] = 8
mock_time.advance_us(1000000)
sources.power.turn()
found["converts again"] = pack(state) + [told[-1]]

device.failures = 1
sources.power.turn()
found["one failure"] = pack(state) + [told[-1], len(told)]
sources.power.turn()
mock_time.advance_us(11000000)
device.absent = True
for _ in range(6):
    sources.power.turn()
found["gone"] = pack(state) + [told[-1], sources.power.failures]
device.absent = False
mock_time.advance_us(1000000)
sources.power.turn()
found["back"] = pack(state) + [told[-1], sources.power.failures]

problems = {}
for name in ("wrong id", "wrong die", "stuck", "nobody"):
    state, sources = fresh()
    device = ina226()
    if name == "wrong id":
        device.registers[0xFE] = 0x1234
    elif name == "wrong die":
        device.registers[0xFF] = 0x2190
    elif name == "stuck":
        device.is_stuck = True
    else:
        mock_i2c.detach_all()
    sources.power.turn()
    problems[name] = pack(state) + told
state, sources = fresh()
ina219().registers[0] = 0x1234
mock_i2c._devices[0x41].is_stuck = True
sources.solar.turn()
problems["no ina219"] = list(told)
found["problems"] = problems

state, sources = fresh()
device = ina226()
device.delay_us = 300
sources.power.turn()
sources.power.turn()
sources.power.turn()
found["three transfers"] = [sources.power.longest_us, sources.power.overruns]
device.delay_us = 1000
sources.power.turn()
found["slow bus"] = [sources.power.longest_us, sources.power.overruns, told[-1]]
device.delay_us = 0
for _ in range(3):
    sources.power.turn()
before = mem_total()
for _ in range(20):
    sources.power.turn()
found["ina226 allocates"] = mem_total() - before

# A driver of the project's own.
state, sources = fresh()
compass = mock_i2c.attach(0, 0x1E, mock_i2c.Device({0: 3590, 1: 48}))
sources.needle.turn()
found["compass"] = [state.compass.heading, state.compass.field]
compass.registers[1] = 1001
sources.needle.turn()
found["strong field"] = [state.compass.heading_cdeg, state.compass.field]

# What a class of the user raises is told by its name, what a bus does not answer by the place on it.


class Many:
    """A compass with a value more than its outputs take: nobody knows which belongs to which."""

    values = array("i", [1, 2, 3])

    def begin(self):
        pass

    def poll(self, _now_ms):
        return True


class Failing:
    error = OSError("no file")

    def read(self):
        raise self.error


class Module:
    Sonar = Failing


sys.modules["sonar"] = Module
raised = []
for Failing.error in (OSError("no file"), ValueError("no echo")):
    state, sources = fresh()
    sources.sonar.turn()
    raised.append(told[-1])
state, sources = fresh()
sources.needle.turn()
raised.append(told[-1])
state, sources = fresh()
sources.needle.driver = Many()
sources.needle.turn()
found["raised"] = raised + [told[-1]]

# Pulses.
state, sources = fresh()
turns = []


def count(high_us, low_us, pulses):
    if pulses:
        mock_pulse.pulse(15, high_us, low_us, pulses)
    sources.log.turn()
    return [state.log.turns_number, state.log.rate_mhz, state.log.width_us]


found["pulses"] = [
    count(0, 0, 0),
    count(1500, 18500, 1),
    count(1500, 18500, 10),
    count(100, 233, 600),
    count(20, 80, 9000),
    count(1, 1, 1),
    count(1000000, 999999, 1),
]
mock_time.advance_us(2100000)
found["no pulses"] = count(0, 0, 0)
found["pulses again"] = [count(500, 500, 1), count(500, 500, 4)]
found["pin"] = [mock_pulse._pins[15].pull, mock_pulse._pins[15].mode]

# Whose turn it is: sensors that only count, asked in each pass of the main loop.


class Counted:
    values = ()

    def __init__(self):
        self.turns = 0
        self.waits = 1

    def begin(self):
        pass

    def waiting(self):
        return self.waits

    def poll(self, _now_ms):
        self.turns += 1
        return False


state, sources = fresh()
for poller in sources.every:
    poller.driver = Counted()
most = last = 0
for _ in range(200):
    sources.turn()
    total = sum([poller.driver.turns for poller in sources.every])
    most = max(most, total - last)
    last = total
    mock_time.advance_us(20000)
found["turns"] = {poller.name: poller.driver.turns for poller in sources.every}
found["at once"] = most
mock_time.advance_us(700000000)
for _ in range(4):
    sources.turn()
found["after half a turn of the ticks"] = sum([poller.driver.turns for poller in sources.every]) - last

# A turn of one that speaks by itself looks whether something waits, but for the first, which sets it up.
state, sources = fresh()
quiet = sources.receiver.driver = Counted()
quiet.waits = 0
asked = []
for quiet.waits in (0, 0, 3, 0):
    for _ in range(3):
        sources.turn()
        mock_time.advance_us(20000)
    asked.append(quiet.turns)
found["asked while nothing waits"] = asked

print(json.dumps(found))
