"""An INA219 on I2C: the voltage of a bus, and the current through a shunt by the voltage across it.

Its own registers for current and power are not used: they are rounded once more, by a calibration that is rounded, too.
Source: data sheet SBOS448G, Texas Instruments.
"""

import time
from array import array

from micropython import const
from polling import UNKNOWN, Fault
from registers import Registers

_CONFIGURATION = const(0)
_SHUNT = const(1)  # steps of 10 uV
_BUS = const(2)  # above three bits, steps of 4 mV
_POWER = const(3)  # to read it takes the conversion for read
_READY = const(2)
_RESET = const(0x8000)
_AFTER_RESET = const(0x399F)
_FULL = const(32000)  # what is more across the shunt reads so


class Ina219:
    """`opened` opens its bus; so many conversions are averaged as `code` says, by table 5 of the data sheet.

    In `wait_ms` they have ended, on each chip that works.
    """

    def __init__(self, opened, address, code, wait_ms):
        self.values = array("i", [UNKNOWN] * 3)
        self._registers = Registers(opened, address)
        self._setting = 0x3807 | code << 7 | code << 3  # up to 32 V, and 320 mV, of both, one after the other
        self._wait_ms = wait_ms
        self._since_ms = None

    def begin(self):
        """Look who answers by what its settings are after a reset: it has no id. Then set it up."""
        registers = self._registers
        registers.open()
        registers.write(_CONFIGURATION, _RESET)
        found = registers.read(_CONFIGURATION)
        if found != _AFTER_RESET:
            raise Fault(f"no INA219: its settings are {found:04x}")
        registers.write(_CONFIGURATION, self._setting)
        if registers.read(_CONFIGURATION) != self._setting:
            raise Fault("it does not keep its settings")
        self._since_ms = None

    def poll(self, now_ms):
        """Read it, if a conversion has ended; return whether that is so."""
        registers = self._registers
        volts = registers.read(_BUS)
        if not volts & _READY:
            if self._since_ms is None:
                self._since_ms = now_ms
            elif time.ticks_diff(now_ms, self._since_ms) > self._wait_ms:
                raise Fault("it does not convert")
            return False
        self._since_ms = None
        volts >>= 3
        shunt = registers.read_signed(_SHUNT)
        registers.read(_POWER)
        values = self.values
        values[0] = volts
        values[1] = values[2] = UNKNOWN
        if -_FULL < shunt < _FULL:
            values[1] = shunt
            values[2] = volts * shunt
        return True
