# Generated from specs/smart_battery/board.yaml, specs/smart_battery/parameters.yaml,
#   specs/smart_battery/state.yaml: do not edit.
# Inputs: 7419676caa2ab49c
"""The hardware: Raspberry Pi Pico (RP2040)."""

import time

import machine
from guard import Guard
from parameters import Parameters
from serial_port import open_uart


class Board:
    """The board; a part that cannot be set up is warned about and reads as failed, the vehicle goes on."""

    def __init__(self, log=print, parameters=None):
        self._log = log
        parameters = parameters or Parameters()  # a pin that is changed counts from the next start
        self._guard = Guard()
        self.battery_failures = 0  # failed readings in a row
        self._battery_count = None
        self._battery_adc = None
        gpio = parameters.batt_volt_pin
        try:
            self._battery_adc = machine.ADC(machine.Pin(gpio))
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

        A failed or late reading returns the last good count, None before the first, and counts in
        `battery_failures`.
        """
        started = time.ticks_us()
        total = self._try_battery()
        if total is None:
            return self._keep_battery("cannot be read:", self._guard.error)
        took = time.ticks_diff(time.ticks_us(), started)
        if took > 2000:
            return self._keep_battery("took too long to read, in us:", took)
        self.battery_failures = 0
        self._battery_count = (total + 2) // 5
        return self._battery_count

    def _try_battery(self):
        with self._guard:
            return self._sum_battery()

    def _sum_battery(self):
        total = 0
        for _ in range(5):
            total += self._battery_adc.read_u16() >> 4
        return total

    def _keep_battery(self, problem, detail):
        self.battery_failures += 1
        if self.battery_failures == 1:  # once for each run of failures, not at each reading
            self._log("error: the battery's ADC", problem, detail)
        return self._battery_count
