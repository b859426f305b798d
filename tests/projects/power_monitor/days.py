"""Takes readings for some days, in an irregular way, and prints what they were and what was counted of them each day.

The only argument is how many days.
"""

import json
import sys

sys.path[:0] = ["generated/firmware", "generated/mocks"]

import mock_time  # noqa: E402  mocks first: they bring the clock
from mock_board import MockBoard  # noqa: E402
from parameters import Parameters  # noqa: E402
from state import SystemState  # noqa: E402

try:
    from micropython import mem_total
except ImportError:

    def mem_total():
        return 0


STEPS_MS = (7, 100, 100, 1900, 20000, 59999, 60000, 60001, 40000, 3)

mock_time.set_ticks_us(0)
parameters = Parameters()
board, state = MockBoard(log=lambda *_: None, parameters=parameters), SystemState(parameters, log=lambda *_: None)
days, turn, number, counted = int(sys.argv[1]), 0, 1, []
passed_ms = 0
largest = 0
while len(counted) < days:
    number = (number * 1103 + 12345) % 65536  # any numbers that are the same everywhere
    step = STEPS_MS[number % 10]
    mock_time.advance_us(step * 1000)
    passed_ms += step
    board.set_adc_value(3200 + number % 800)
    current = 350 + number * 7 % 3700
    board.set_pack_current_adc_waveform(None if number % 13 == 0 else current)
    state.update_pack(board)  # what a reading tells first, and what the mock makes of None
    turn += 1
    if passed_ms >= (len(counted) + 1) * 86400000:
        counted.append(
            (turn, state.pack.consumed_mah, state.pack.energy_hj, state.pack.left_mah, state.pack.time_left_s)
        )
print(json.dumps(counted))  # noqa: T201
