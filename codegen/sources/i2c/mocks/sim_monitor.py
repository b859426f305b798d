"""True voltages and currents at monitors on an I2C bus, in a simulation: registers that follow them, for the driver."""

import mock_i2c

_READ_ONLY = {"ina226": (1, 2, 6, 0xFE, 0xFF), "ina219": (1, 2, 3)}
_AT_START = {"ina226": {0: 0x4127, 1: 0, 2: 0, 6: 8, 0xFE: 0x5449, 0xFF: 0x2260}, "ina219": {0: 0x399F, 2: 0, 3: 0}}
_READY = {"ina226": 6, "ina219": 3}  # the register after whose reading a conversion counts no more as new
_AVERAGES = (1, 4, 16, 64, 128, 256, 512, 1024)
_TIMES_US = (140, 204, 332, 588, 1100, 2116, 4156, 8244)  # of one conversion of an INA226
_OF_12_BITS_US = 532  # of an INA219
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
        self._is_new = False
        self._ends_ms = now_ms() + self.conversion_ms()
        self.on_read = self._looked_at
        self.on_write = self._written

    def conversion_ms(self):
        """Return the time of what it averages by its settings, of the bus and of the shunt, by the data sheet."""
        settings = self.registers[0]
        if self._chip == "ina226":
            both_us = _TIMES_US[settings >> 6 & 7] + _TIMES_US[settings >> 3 & 7]
            return -(-both_us * _AVERAGES[settings >> 9 & 7] // 1000)
        return -(-_OF_12_BITS_US * ((1 << (settings >> 7 & 7)) + (1 << (settings >> 3 & 7))) // 1000)

    def answer(self):
        """Take part in a transfer, with what is true now in the registers; OSError in a fault."""
        at_ms = self._now_ms()
        slow = self._fault("slow", at_ms)
        self.delay_us = slow["delay_us"] if slow else 0
        self.absent = bool(self._fault("fail", at_ms) or self._fault("absent", at_ms))
        voltage, current = self._steps("voltage", at_ms), self._steps("current", at_ms)
        if voltage is None or current is None:
            self.absent = True
        elif at_ms >= self._ends_ms:
            self._convert(min(max(voltage, 0), _FULL), min(max(current, -_FULL), _FULL))
            self._is_new = True
            self._ends_ms = at_ms + self.conversion_ms()
        if self._chip == "ina226":
            self.registers[6] = 8 if self._is_new else 0
        elif not self._is_new:
            self.registers[2] &= ~2
        mock_i2c.Device.answer(self)

    def _looked_at(self, number):
        if number == _READY[self._chip]:
            self._is_new = False

    def _convert(self, voltage, current):
        self.registers[1] = current & 0xFFFF
        self.registers[2] = voltage if self._chip == "ina226" else min(voltage, _FULL >> 2) << 3 | 2

    def _written(self, number, value):
        if number == 0:
            if self._chip == "ina219" and value & _RESET:
                self.registers[0] = _AT_START["ina219"][0]
            self._is_new = False
            self._ends_ms = self._now_ms() + self.conversion_ms()

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
