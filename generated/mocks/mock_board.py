# Generated from specs/board.yaml, specs/state.yaml: do not edit.
# Inputs: 443991c2108b8cd6
"""Raspberry Pi Pico 2 W on a host.

The firmware's own Board on a scripted ADC, and a clock that is moved by hand.
"""

import mock_time

mock_time.install()

import machine  # noqa: E402  the clock has to be in place before the firmware looks at it
from board import Board  # noqa: E402

machine.watchdog_range_ms = (1, 8388)
machine.cause_of_restart = 3
machine.adc_pins = (26, 27, 28)


class MockBoard(Board):
    """A board whose ADC reads what it is told; everything starts at count 0, without faults."""

    def __init__(self, log=print, absent=False, parameters=None):
        machine.reset_analog()
        self._battery_inputs = [machine.analog(gpio) for gpio in (26, 27)]
        for analog in self._battery_inputs:
            analog.absent = absent
        self._battery_current_inputs = [machine.analog(gpio) for gpio in (28, 28)]
        for analog in self._battery_current_inputs:
            analog.absent = absent
        Board.__init__(self, log, parameters)

    def set_adc_value(self, count, instance=0):
        """Let every sample of the battery read this count, 0 to 4095."""
        if not 0 <= count <= 4095:
            raise ValueError(f"an ADC of 12 bits does not read {count!r}")
        self._battery_inputs[instance].source = count

    def set_adc_waveform(self, waveform, instance=0):
        """Let samples follow a list of counts, or a function of the microseconds since the start."""
        self._battery_inputs[instance].source = waveform

    def fail_adc(self, samples, instance=0):
        """Let the next samples fail."""
        self._battery_inputs[instance].failures = samples

    def delay_adc(self, microseconds, instance=0):
        """Let every sample take so long."""
        self._battery_inputs[instance].delay_us = microseconds

    def set_battery_current_adc_value(self, count, instance=0):
        """Let every sample of the battery_current read this count, 0 to 4095."""
        if not 0 <= count <= 4095:
            raise ValueError(f"an ADC of 12 bits does not read {count!r}")
        self._battery_current_inputs[instance].source = count

    def set_battery_current_adc_waveform(self, waveform, instance=0):
        """Let samples follow a list of counts, or a function of the microseconds since the start."""
        self._battery_current_inputs[instance].source = waveform

    def fail_battery_current_adc(self, samples, instance=0):
        """Let the next samples fail."""
        self._battery_current_inputs[instance].failures = samples

    def delay_battery_current_adc(self, microseconds, instance=0):
        """Let every sample take so long."""
        self._battery_current_inputs[instance].delay_us = microseconds


def scenario(name, readings=20):
    """Return a waveform for set_adc_waveform(): nominal, low, critical, rising or falling.

    The levels are shares of full scale; rising and falling go from one end to the other in so many readings.
    """
    full = machine.FULL_SCALE
    nominal, low, critical = full * 9 // 10, full * 3 // 4, full * 2 // 3
    if name == "rising":
        ends = (critical, nominal)
    elif name == "falling":
        ends = (nominal, critical)
    else:
        level = {"nominal": nominal, "low": low, "critical": critical}[name]
        ends = (level, level)
    samples = 5
    return [count for count in machine.ramp(ends[0], ends[1], readings) for _ in range(samples)]
