# Generated from specs/board.yaml, specs/parameters.yaml, specs/state.yaml: do not edit.
# Inputs: 39cc7d02773ef247
"""The hardware: Raspberry Pi Pico 2 W (RP2350)."""

import machine
from parameters import Parameters
from udp_port import UdpPort

try:
    from samples_viper import battery_reading
except (AttributeError, ImportError, SyntaxError, ValueError):  # as in frames
    from samples_plain import battery_reading

# Names of the parameters that each has of its own.
_BATT_VOLT_PIN = ("batt_volt_pin", "batt2_volt_pin")
_BATT_MONITOR = ("batt_monitor", "batt2_monitor")


class Board:
    """The board; a part that cannot be set up is warned about and reads as failed, the vehicle goes on."""

    def __init__(self, log=print, parameters=None):
        self._log = log
        parameters = parameters or Parameters()  # a pin that is changed counts from the next start
        self.battery_failures = [0] * 2  # failed readings in a row, of each
        self._read_battery = [None] * 2
        for instance in range(2):
            if getattr(parameters, _BATT_MONITOR[instance]) == 0:
                continue  # its pin may be somebody else's
            gpio = getattr(parameters, _BATT_VOLT_PIN[instance])
            try:
                adc = machine.ADC(machine.Pin(gpio))
                self._read_battery[instance] = battery_reading(self, adc.read_u16, instance)
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

        A failed or late reading returns -1, and counts in `battery_failures`. It never raises.
        """
        try:
            return self._read_battery[instance]()
        except Exception:  # to keep it, or to do more here, would take heap at each call
            return self.fail_battery(instance)

    def fail_battery(self, instance, took=None):
        """Count a reading that failed, or that took so many us; return -1."""
        self.battery_failures[instance] += 1
        if self.battery_failures[instance] > 1:  # once for each run of failures, not at each reading
            return -1
        if took is None:
            self._log(f"error: battery {instance + 1}'s ADC", "cannot be read")
        else:
            self._log(f"error: battery {instance + 1}'s ADC", "took too long to read, in us:", took)
        return -1
