"""True voltages and currents at monitors on an I2C bus, in a simulation: registers that follow them, for the driver."""

import mock_i2c

_READ_ONLY = {"ina226": (1, 2, 6, 0xFE, 0xFF), "ina219": (1, 2, 3)}
_AT_START = {"ina226": {0: 0x4127, 1: 0, 2: 0, 6: 8, 0xFE: 0x5449, 0xFF: 0x2260}, "ina219": {0: 0x399F, 3: 0}}
_RESET = 0x8000
_FULL = 0x7FFF


def connect(courses, now_ms, start_ms):  # noqa: ARG001 - as other inputs, see sim_adc
    """Attach a monitor to each bus and address for which there are courses."""
    found = {}
    for course in courses:
        settings = course.settings
        place = (settings["bus"], settings["address"], settings["chip"])
        found.setdefault(place, {})[settings["output"]] = course
    for (bus, address, chip), outputs in found.items():
        mock_i2c.attach(bus, address, Monitor(chip, outputs, now_ms))


class Monitor(mock_i2c.Device):
    """A monitor of voltage and current; it does not answer while one of them is not known."""

    def __init__(self, chip, outputs, now_ms):
        mock_i2c.Device.__init__(self, _AT_START[chip], _READ_ONLY[chip])
        self._chip = chip
        self._outputs = outputs
        self._now_ms = now_ms
        self.on_write = self._written

    def answer(self):
        """Take part in a transfer, with what is true now in the registers; OSError in a fault."""
        at_ms = self._now_ms()
        slow = self._fault("slow", at_ms)
        self.delay_us = slow["delay_us"] if slow else 0
        self.absent = bool(self._fault("fail", at_ms) or self._fault("absent", at_ms))
        voltage, current = self._steps("voltage", at_ms), self._steps("current", at_ms)
        if voltage is None or current is None:
            self.absent = True
        else:
            self._convert(min(max(voltage, 0), _FULL), min(max(current, -_FULL), _FULL))
        mock_i2c.Device.answer(self)

    def _convert(self, voltage, current):
        self.registers[1] = current & 0xFFFF
        self.registers[2] = voltage if self._chip == "ina226" else min(voltage, _FULL >> 2) << 3 | 2

    def _written(self, number, value):
        if self._chip == "ina219" and number == 0 and value & _RESET:
            self.registers[0] = _AT_START["ina219"][0]

    def _steps(self, name, at_ms):
        """Return what is true in steps of the chip, 0 without a course; None while it is not known."""
        course = self._outputs.get(name)
        if course is None:
            return 0
        value = course.seen(at_ms)
        return None if value is None else round(value * course.settings["steps"])

    def _fault(self, kind, at_ms):
        for course in self._outputs.values():
            fault = course.fault(kind, at_ms)
            if fault is not None:
                return fault
        return None
