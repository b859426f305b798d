"""A monitor of voltage and current on an I2C bus, as its data sheet has it: registers, and what a reset does."""

import mock_i2c

_SETTING = 0
_RESET = 0x8000


class Device(mock_i2c.Device):
    """The monitor at the bus and the address of the tables; all conversions have ended."""

    def __init__(self, settings):
        self._reset = settings["reset"]
        self._mask, self._setting = settings["setting"]
        mock_i2c.Device.__init__(self, dict(self._reset), settings["read_only"])
        self.on_write = self._written
        mock_i2c.attach(settings["bus"], settings["address"], self)

    def show(self, shown, turn):  # noqa: ARG002 - as other devices
        """Have a voltage at the bus and one across the shunt."""
        self.registers.update(dict(shown["registers"]))

    def check(self):
        """Return what is wrong with what the driver has set."""
        found = self.registers[_SETTING] & self._mask
        return "" if found == self._setting else f"it is set to {found:#06x}, not {self._setting:#06x}"

    def _written(self, number, value):
        if number == _SETTING and value & _RESET:
            self.registers.update(dict(self._reset))
