# Generated from specs/smart_battery/board.yaml, specs/smart_battery/parameters.yaml,
#   specs/smart_battery/state.yaml: do not edit.
# Inputs: 940407389e80b8d2
"""The hardware: Raspberry Pi Pico (RP2040)."""

import machine
from parameters import Parameters
from serial_port import open_uart

try:
    from samples_viper import battery_reading
except (AttributeError, ImportError, SyntaxError, ValueError):  # as in frames
    from samples_plain import battery_reading


class Board:
    """The board; a part that cannot be set up is warned about and reads as failed, the vehicle goes on."""

    def __init__(self, log=print, parameters=None):
        self._log = log
        parameters = parameters or Parameters()  # a pin that is changed counts from the next start
        self.battery_failures = 0  # failed readings in a row
        self._read_battery = None
        gpio = parameters.batt_volt_pin
        try:
            adc = machine.ADC(machine.Pin(gpio))
            self._read_battery = battery_reading(self, adc.read_u16)
        except Exception as error:
            log("warning: no ADC for the battery on GPIO", gpio, ":", error)

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

    def read_battery_adc(self):
        """Return the mean of 5 samples as a count, 0 to 4095, FR-00066.2.

        A failed or late reading returns -1, and counts in `battery_failures`. It never raises.
        """
        try:
            return self._read_battery()
        except Exception:  # to keep it, or to do more here, would take heap at each call
            return self.fail_battery()

    def fail_battery(self, took=None):
        """Count a reading that failed, or that took so many us; return -1."""
        self.battery_failures += 1
        if self.battery_failures > 1:  # once for each run of failures, not at each reading
            return -1
        if took is None:
            self._log("error: the battery's ADC", "cannot be read")
        else:
            self._log("error: the battery's ADC", "took too long to read, in us:", took)
        return -1
