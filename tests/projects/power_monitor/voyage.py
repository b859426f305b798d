"""Sets the counts of the converter, and prints what the state keeps and what goes out, by the name of each step."""

import json
import sys

sys.path[:0] = ["generated/firmware", "generated/mocks"]

from mock_board import MockBoard  # noqa: E402  mocks first: they bring the clock
from mock_time import advance_us  # noqa: E402
from parameters import Parameters  # noqa: E402
from state import SystemState  # noqa: E402

found = {}
parameters = Parameters()
told = []


def note(text, *_):
    """Keep a text, without the value behind it."""
    told.append(text)


def started():
    """A board and a state after a start with the parameters."""
    return MockBoard(log=lambda *_: None, parameters=parameters), SystemState(parameters, log=note)


def taken(name, voltage, current, level):
    """Keep what comes of these counts; None of a sample that fails."""
    for setter, count in (
        (board.set_adc_waveform, voltage),
        (board.set_pack_current_adc_waveform, current),
        (board.set_tank_adc_waveform, level),
    ):
        setter([count])
    state.update_pack(board)
    state.update_tank(board)
    found[name] = [state.pack.voltage_mv, state.pack.current_ca, state.tank.level_cpct]


def cells_told(name, cells, count):
    """Keep what comes of cells that another system tells, and of a count: what is estimated, and what is warned of."""
    state.pack.cells_mv = cells
    told.clear()
    board.set_adc_waveform([count])
    state.update_pack(board)
    found[name] = [state.pack.voltage_mv, state.pack.guess_pct, list(told)]


def drawn_for_long(name, count, turns):
    """Keep what is left and how long it lasts after so many readings of the same draw."""
    board.set_pack_current_adc_waveform([count])
    for _ in range(turns):
        advance_us(100000)
        state.update_pack(board)
    found[name] = [state.pack.current_ca, state.pack.left_mah, state.pack.time_left_s]


board, state = started()
taken("half", 2047, 2047, 2047)
taken("no current", 4095, 410, 496)
taken("charging, empty", 0, 0, 0)
taken("full scale", 4095, 4095, 4095)
taken("one fails", 3000, None, 1000)
for _ in range(2):
    taken("and again", 3001, None, None)
taken("for the fourth time", 3000, None, 3000)
taken("and comes back", 3000, 1000, 3000)
parameters.set("BATT_AMP_PERVLT", -20)
parameters.set("BATT_AMP_OFFSET", 1.65)
taken("the other way round, from the middle, at once", 3000, 1000, 3000)
advance_us(10_001_000)
cells_told("full cells, and no ADC", (6300, 6200, 6500), None)
cells_told("cells, and an ADC that shows more", (3800, 4000, None), 4095)
advance_us(10_001_000)
cells_told("other cells, and an ADC that shows more", (3800, 4000, 4200), 4095)
for turn in range(12):
    cells_told("cells that rise, and no ADC", [4000 + 10 * turn] * 3, None)
found["cells that rise, and no ADC"] = [state.pack.voltage_mv, state.pack.trend_mv_s]
cells_told("ADC alone", None, 3000)
advance_us(2_001_000)
taken("one fails, and the last one is too old", 3000, 1000, None)
parameters.set("BATT_MONITOR", 3)
board, state = started()
taken("voltage only", 3000, 1000, 3000)
parameters.set("BATT_MONITOR", 0)
board, state = started()
taken("nothing of the pack", 3000, 1000, 3000)
parameters.__init__()
board, state = started()
drawn_for_long("next to nothing", 410, 1)
drawn_for_long("a little more, for five minutes", 414, 3000)
parameters.set("BATT_MONITOR", 29)
parameters.set("BATT_VOLT_USED", 0)
board, state = started()
found["code sets"] = []
for value, turns in ((12000, 1), (None, 1), (12000, 10), (None, 0)):
    if turns:
        state.pack.voltage_mv = value
    for _ in range(turns or 1):
        advance_us(100000)
        state.update_pack(board)
    found["code sets"].append([state.pack.voltage_mv, state.pack.guess_pct])
print(json.dumps(found))  # noqa: T201
