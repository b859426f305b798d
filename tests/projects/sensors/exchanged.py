"""Of a pack whose voltage an ADC measures and whose current a monitor gives: what is counted when it is exchanged."""

import json
import sys

sys.path[:0] = ["generated/firmware", "generated/mocks"]

import mock_time  # noqa: E402

mock_time.install()

import mock_i2c  # noqa: E402
from mock_board import MockBoard  # noqa: E402
from parameters import Parameters  # noqa: E402
from sources import Sources  # noqa: E402
from state import SystemState  # noqa: E402

REGISTERS = {0: 0x4127, 1: 8000, 2: 9600, 3: 0, 4: 0, 5: 0, 6: 8, 0xFE: 0x5449, 0xFF: 0x2260}

mock_time.set_ticks_us(0)
parameters = Parameters()
board = MockBoard(log=lambda *_: None, parameters=parameters)
state = SystemState(parameters, log=lambda *_: None)
sources = Sources(state, lambda *_: None)
mock_i2c.attach(0, 0x40, mock_i2c.Device(REGISTERS, (1, 2, 0xFE, 0xFF)))
found = []
for turns, count in ((400, 3000), (5, 10), (1, 3000), (360, 3000)):
    for _ in range(turns):
        mock_time.advance_us(100000)
        board.set_adc_value(count)
        state.update_pack(board)
        sources.power.turn()
    found.append((state.pack.swaps, state.pack.consumed_mah, state.pack.left_mah))
print(json.dumps(found))  # noqa: T201
