# Generated from specs/board.yaml, specs/parameters.yaml, specs/state.yaml: do not edit.
# Inputs: 5557e20688bf36f5
"""The hardware: Raspberry Pi Pico 2 W (RP2350)."""

import machine
from adc_inputs import AdcInputs
from parameters import Parameters
from udp_port import UdpPort

try:
    from samples_viper import battery_reading
except (AttributeError, ImportError, NotImplementedError, SyntaxError, TypeError, ValueError):  # as in frames
    from samples_plain import battery_reading

# Names of the parameters that each has of its own.
_BATT_VOLT_PIN = ("batt_volt_pin", "batt2_volt_pin")
_BATT_MONITOR = ("batt_monitor", "batt2_monitor")


def open_adc(gpio):
    """Return the input of the converter at a pin."""
    return machine.ADC(machine.Pin(gpio))


class Board:
    """The board; a part that cannot be set up is warned about and reads as failed, the vehicle goes on."""

    def __init__(self, log=print, parameters=None):
        self._log = log
        parameters = parameters or Parameters()  # a pin that is changed counts from the next start
        pins = [None] * 2
        for instance in range(2):
            if getattr(parameters, _BATT_MONITOR[instance]) not in (0, 29):  # else its pin may be somebody else's
                pins[instance] = getattr(parameters, _BATT_VOLT_PIN[instance])
        inputs = AdcInputs(log, "battery {}", pins, open_adc, battery_reading)
        self.battery_inputs = inputs  # their figures: failures, times
        self.read_battery_adc = inputs.read
        if any(getattr(parameters, each) == 4 for each in _BATT_MONITOR):
            import battery_current  # noqa: PLC0415  where it is measured only

            battery_current.connect(self, parameters, log)

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
