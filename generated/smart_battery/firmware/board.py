# Generated from specs/smart_battery/board.yaml, specs/smart_battery/parameters.yaml,
#   specs/smart_battery/state.yaml: do not edit.
# Inputs: 3473f0c2a70bace6
"""The hardware: Raspberry Pi Pico (RP2040)."""

import machine
from adc_inputs import AdcInputs
from parameters import Parameters
from serial_port import open_uart

try:
    from samples_viper import battery_reading
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from samples_plain import battery_reading


def open_adc(gpio):
    """Return the input of the converter at a pin."""
    return machine.ADC(machine.Pin(gpio))


class Board:
    """The board; a part that cannot be set up is warned about and reads as failed, the vehicle goes on."""

    def __init__(self, log=print, parameters=None):
        self._log = log
        parameters = parameters or Parameters()  # a pin that is changed counts from the next start
        pins = [parameters.batt_volt_pin]
        inputs = AdcInputs(log, "the battery", pins, open_adc, battery_reading)
        self.battery_inputs = inputs  # their figures: failures, times
        self.read_battery_adc = inputs.read

    def open_ports(self):
        """Return the ports to ground stations; one that cannot be opened says so and takes nothing."""
        return [
            open_uart(
                "autopilot",
                0,
                tx=0,
                rx=1,
                baud=57600,
                size=1024,
            ),  # FR-00070.10
        ]
