"""Pulses at an input: bursts of them."""

import mock_pulse


class Device:
    """Whatever makes the pulses at the GPIO of the tables."""

    def __init__(self, settings):
        self._gpio = settings["gpio"]

    def show(self, shown, turn):
        """Let pulses arrive in bursts, with a turn of the sensor between two of them."""
        for at, count in enumerate(shown["bursts"]):
            if at:
                turn()
            mock_pulse.pulse(self._gpio, shown["high_us"], shown["low_us"], count)

    def check(self):
        """Return nothing: nothing is set."""
        return ""
