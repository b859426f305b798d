"""Asks the monitor for some days, in an irregular way, and prints what was counted of its readings each day.

The only argument is how many days. In between it fails, alone and six times in a row, has nothing new, or says what
cannot be.
"""

import json
import sys

sys.path[:0] = ["generated/firmware", "generated/mocks"]

import mock_time  # noqa: E402

mock_time.install()

import mock_i2c  # noqa: E402
from parameters import Parameters  # noqa: E402
from sources import Sources  # noqa: E402
from state import SystemState  # noqa: E402

try:
    from micropython import mem_total
except ImportError:

    def mem_total():
        return 0


STEPS_MS = (7, 100, 100, 1900, 20000, 59999, 60000, 60001, 40000, 3)
REGISTERS = {0: 0x4127, 1: 0, 2: 0, 3: 0, 4: 0, 5: 0, 6: 8, 0xFE: 0x5449, 0xFF: 0x2260}

mock_time.set_ticks_us(0)
parameters = Parameters()
parameters.pack_capacity = 100000
state = SystemState(parameters, log=lambda *_: None)
sources = Sources(state, lambda *_: None)
device = mock_i2c.attach(0, 0x40, mock_i2c.Device(REGISTERS, (1, 2, 0xFE, 0xFF)))
registers, power = device.registers, sources.power
days, turn, number, counted = int(sys.argv[1]), 0, 1, []
passed_ms = largest = 0
while len(counted) < days:
    number = (number * 1103 + 12345) % 65536  # any numbers that are the same everywhere
    turn += 1
    is_long = turn % 500 < 6
    step = 2000 if turn % 500 < 8 else STEPS_MS[number % 10]
    mock_time.advance_us(step * 1000)
    passed_ms += step
    device.absent = is_long or number % 13 == 0
    was_new = registers[6]
    registers[6] = 0 if number % 17 == 0 else 8  # no conversion has ended
    registers[2] = 30000 if number % 19 == 0 else 9000 + number % 800
    registers[1] = 32767 if number % 23 == 0 else (number * 7 % 8000 - 2000) & 0xFFFF
    is_quiet = not device.absent and power.failures == 0 and (was_new or registers[6])  # none twice is a failure
    before = mem_total()
    power.turn()
    if is_quiet:  # what a failure tells takes memory
        largest = max(largest, mem_total() - before)
    if passed_ms >= (len(counted) + 1) * 86400000:
        pack = state.pack
        counted.append((turn, pack.consumed_mah, pack.energy_hj, pack.left_mah, pack.remaining_pct))


def left():
    pack = state.pack
    return [pack.left_mah, pack.remaining_pct, pack.time_left_s]


def steady(turns, shunt):
    """Ask it ten times a second, with so many steps of 1.25 mA."""
    device.absent = False
    registers[1], registers[6] = shunt & 0xFFFF, 8
    for _ in range(turns):
        mock_time.advance_us(100000)
        power.turn()


last = {}
parameters.pack_capacity = 0  # counts from the next start
steady(400, 800)  # 1 A
last["drawn"] = left() + [state.pack.consumed_mah]  # noqa: RUF005  not in MicroPython
mock_time.advance_us(60000000)
last["just believed"] = left()
mock_time.advance_us(1000)
last["too old"] = left()
steady(1, 1600)
last["begins anew"] = left()
steady(400, -800)
last["charged"] = left() + [state.pack.consumed_mah]  # noqa: RUF005  not in MicroPython
steady(20, 800)
device.absent = True
for _ in range(5):
    last["before"] = left()
    mock_time.advance_us(2000000)
    power.turn()
last["lost"] = left()
print(json.dumps([counted, largest, last]))  # noqa: T201
