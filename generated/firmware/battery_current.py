# Generated from specs/board.yaml, specs/parameters.yaml, specs/state.yaml: do not edit.
# Inputs: 5557e20688bf36f5
"""The current of the battery: imported only where it is measured.

The board gets `read_battery_current_adc()` by connect(), and behind() lets the state take readings
behind those before, the first of the battery.
"""

from adc_inputs import AdcInputs
from board import open_adc
from micropython import const
from reading_turns import in_turn, turns

try:
    from battery_current_viper import battery_current_reading, read_battery_current
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from battery_current_plain import battery_current_reading, read_battery_current

# What stands where among the words of the battery, see state.py.
_BATTERY_CURRENT_COUNT = const(26)
_BATTERY_CURRENT_MULTIPLIER = const(27)
_BATTERY_CURRENT_OFFSET = const(28)
_BATTERY_CURRENT_FAILURES = const(29)
_BATTERY_CURRENT_IS_READ = const(31)
_BATTERY_BATT_CAPACITY = const(38)

# Names of the parameters that each has of its own.
_BATT_AMP_PERVLT = ("batt_amp_pervlt", "batt2_amp_pervlt")
_BATT_AMP_OFFSET = ("batt_amp_offset", "batt2_amp_offset")
_BATT_CURR_PIN = ("batt_curr_pin", "batt2_curr_pin")
_BATT_MONITOR = ("batt_monitor", "batt2_monitor")
_BATT_CAPACITY = ("batt_capacity", "batt2_capacity")


def current_from_adc(adc, mult, offset):
    """Return the A that a count stands for, FR-00077.3."""
    return (adc / 4095 * 3.3 - offset) * mult


def connect(board, parameters, log):
    """Give a board what reads the inputs."""
    pins = [None] * 2
    for instance in range(2):
        if getattr(parameters, _BATT_MONITOR[instance]) == 4:  # else its pin may be somebody else's
            pins[instance] = getattr(parameters, _BATT_CURR_PIN[instance])
    inputs = AdcInputs(log, "battery {}'s current", pins, open_adc, battery_current_reading)
    board.battery_current_inputs = inputs
    board.read_battery_current_adc = inputs.read


def behind(update, state, log):
    """Return what takes a turn of `update`, then one reading of each, when it is given the board."""
    parts = state.battery_words
    parameters = state.parameters
    for instance in range(2):
        words = parts[instance]
        words[_BATTERY_CURRENT_MULTIPLIER] = getattr(parameters, _BATT_AMP_PERVLT[instance])
        words[_BATTERY_CURRENT_OFFSET] = getattr(parameters, _BATT_AMP_OFFSET[instance])
        words[_BATTERY_BATT_CAPACITY] = getattr(parameters, _BATT_CAPACITY[instance])
        words[_BATTERY_CURRENT_IS_READ] = 1 if getattr(parameters, _BATT_MONITOR[instance]) == 4 else 0

    def follow():
        for instance in range(2):
            words = parts[instance]
            words[_BATTERY_BATT_CAPACITY] = getattr(parameters, _BATT_CAPACITY[instance])

    def tell(told, instance, error):
        value = state.battery[instance].current
        if told & 1:
            log(f"battery {instance + 1}: current {value:.2f} A")
        if error is not None:
            log(f"error: the board cannot read battery {instance + 1}'s current:", str(error) or type(error).__name__)

    places = (_BATTERY_CURRENT_COUNT, _BATTERY_CURRENT_FAILURES)
    turn = turns(state, read_battery_current, parts, places, tell, follow)
    return in_turn(update, turn, state._start_battery)
