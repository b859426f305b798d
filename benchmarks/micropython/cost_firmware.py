"""The generated firmware of the rover: from a reading to the state, from the state to frames. See counting.py.

All quantities of the battery are known. The state asks a stand-in for the board, whose own share is counted too, to be
subtracted; the true board has a converter that answers at once, since how long a conversion takes is the converter's.
"""

import counting  # isort: skip  before anybody looks at the clock
import machine
import micropython
import telemetry
from board import Board
from state import SystemState
from streams import open_link


class StandIn:
    """Reads the same count at any time."""

    def read_battery_adc(self, _instance):
        """Return the count."""
        return 3000


class Converter:
    """An ADC that always reads 0, with a function in C as on the board."""

    def __init__(self, _pin):
        self.read_u16 = micropython.opt_level


machine.ADC = Converter
stand_in = StandIn()
board = Board(log=lambda *_words: None)
link = open_link(None)
state = SystemState(log=lambda *_words: None)
battery = state.battery[0]


def take_readings(rounds):
    """Let the state take readings, of which it keeps the trend: see that more than 40 came before."""
    update = state.update_battery
    for _ in range(rounds):
        update(stand_in)


def ask_the_stand_in(rounds):
    """Call the stand-in alone."""
    for _ in range(rounds):
        stand_in.read_battery_adc(0)


def read_the_board(rounds):
    """Read the battery: five samples and their mean."""
    for _ in range(rounds):
        board.read_battery_adc(0)


def build_battery_status(rounds):
    """Make the message, not the frame."""
    build = telemetry.build_battery_status
    for _ in range(rounds):
        build(state)


def encode_battery_status(rounds):
    """Make the frame of a message that is there."""
    encode = link.encode
    message = telemetry.build_battery_status(state)
    for _ in range(rounds):
        encode(message)


def encode_the_first(rounds):
    """Make the frame of the state, with the instance left out."""
    encode = telemetry.encode_battery_status
    for _ in range(rounds):
        encode(link, state)


def set_voltage(rounds):
    """Set a quantity in the unit of people."""
    for _ in range(rounds):
        battery.voltage = 11.7


def frame_of(name, *about):
    """Return the workload that makes the frame of a message, by its instance and page, and tells its full length.

    It calls what the streams call.
    """
    build = getattr(telemetry, "build_" + name)
    length = 12 + build(state).LENGTH

    def make_frames(rounds):
        encode = getattr(telemetry, name + "_frame" if about else "encode_" + name)
        if len(about) == 2:
            for _ in range(rounds):
                encode(link, state, 0, 0)
        elif about:
            for _ in range(rounds):
                encode(link, state, 0)
        else:
            for _ in range(rounds):
                encode(link, state)
        return length

    return make_frames


battery.temperature = 23.45
battery.current = 15.2
battery.consumed = 1234
battery.energy = 456700
battery.remaining = 67
take_readings(50)
if battery.voltage is None or battery.trend is None or board.read_battery_adc(0) != 0:
    raise SystemExit("a reading failed")
counting.count(
    update=take_readings,
    stand_in=ask_the_stand_in,
    reading=read_the_board,
    build=build_battery_status,
    encode_the_first=encode_the_first,
    encode=encode_battery_status,
    battery_status=frame_of("battery_status", 0),
    sys_status=frame_of("sys_status"),
    battery_status_v2=frame_of("battery_status_v2", 0),
    cell_voltages=frame_of("battery_cell_voltages", 0, 0),
    set_voltage=set_voltage,
)
