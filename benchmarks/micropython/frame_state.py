"""Vehicle state to frame with the generated firmware of the rover: all six quantities of the battery are known.

The voltage comes from a reading, so that every frame asks the clock whether it is too old. The board is a stand-in
that only has what SystemState asks for: time is that of MicroPython itself, as on the board.
Arguments: passes, frames per pass.
"""

import sys

import telemetry
from state import SystemState
from stopwatch import answer
from streams import open_link

passes, count = map(int, sys.argv[1:3])


class Board:
    """Reads the same count at any time."""

    def read_battery_adc(self, _instance):
        """Return the count."""
        return 3000


board = Board()
link = open_link(None)
state = SystemState(log=lambda *_words: None)  # standard output has the answer
battery = state.battery[0]
battery.temperature_cdegc = 2345
battery.current_ma = 15200
battery.energy_hj = 4567
battery.remaining_pct = 67


def sample():
    """Take a reading; it is good for longer than a pass takes."""
    state.update_battery(board)


def frames(first, count):
    """Make `count` frames; the charge counts on from `first`. Return the last frame."""
    encode = telemetry.battery_status_frame
    frame = None
    for consumed in range(first, first + count):
        battery.consumed_mah = consumed
        frame = encode(link, state, 0)
    return frame


sample()
if battery.expires_ms is None or battery.voltage_mv is None:
    raise SystemExit("the voltage is not known, or never grows old")
answer(frames, count, passes, [bytes(frames(first, 1)).hex() for first in (1234, 98765)], sample)
