# Generated from specs/board.yaml, specs/parameters.yaml, specs/state.yaml: do not edit.
# Inputs: 22bc6f042f62670f
"""The hardware: Raspberry Pi Pico 2 W (RP2350)."""

import time

import machine
from guard import Guard
from parameters import Parameters
from udp_port import UdpPort

# Names of the parameters that each has of its own.
_BATT_VOLT_PIN = ("batt_volt_pin", "batt2_volt_pin")
_BATT_MONITOR = ("batt_monitor", "batt2_monitor")


class Board:
    """The board; a part that cannot be set up is warned about and reads as failed, the vehicle goes on."""

    def __init__(self, log=print, parameters=None):
        self._log = log
        parameters = parameters or Parameters()  # a pin that is changed counts from the next start
        self._guard = Guard()
        self.battery_failures = [0] * 2  # failed readings in a row, of each
        self._battery_count = [None] * 2
        self._battery_adc = [None] * 2
        for instance in range(2):
            if getattr(parameters, _BATT_MONITOR[instance]) == 0:
                continue  # its pin may be somebody else's
            gpio = getattr(parameters, _BATT_VOLT_PIN[instance])
            try:
                self._battery_adc[instance] = machine.ADC(machine.Pin(gpio))
            except Exception as error:
                log(f"warning: no ADC for battery {instance + 1} on GPIO", gpio, ":", error)

    def open_ports(self):
        """Return the ports to ground stations; one that cannot be opened says so and takes nothing."""
        return [
            UdpPort(
                "wifi",
                "255.255.255.255",
                14550,
                local_port=0,
                credentials="wifi.json",
                retry_ms=5000,
                log=self._log,
            ),  # FR-00070.10
        ]

    def read_battery_adc(self, instance=0):
        """Return the mean of 5 samples as a count, 0 to 4095, FR-00066.2.

        A failed or late reading returns the last good count, None before the first, and counts in
        `battery_failures`.
        """
        started = time.ticks_us()
        total = self._try_battery(instance)
        if total is None:
            return self._keep_battery("cannot be read:", self._guard.error, instance)
        took = time.ticks_diff(time.ticks_us(), started)
        if took > 2000:
            return self._keep_battery("took too long to read, in us:", took, instance)
        self.battery_failures[instance] = 0
        self._battery_count[instance] = (total + 2) // 5
        return self._battery_count[instance]

    def _try_battery(self, instance):
        with self._guard:
            return self._sum_battery(instance)

    def _sum_battery(self, instance):
        total = 0
        for _ in range(5):
            total += self._battery_adc[instance].read_u16() >> 4
        return total

    def _keep_battery(self, problem, detail, instance):
        self.battery_failures[instance] += 1
        if self.battery_failures[instance] == 1:  # once for each run of failures, not at each reading
            self._log(f"error: battery {instance + 1}'s ADC", problem, detail)
        return self._battery_count[instance]
