"""An INA226 on I2C: the voltage of a bus, and the current through a shunt by the voltage across it.

Its own registers for current and power are not used: they are rounded once more, by a calibration that is rounded, too.
Source: data sheet SBOS547A, Texas Instruments.
"""

import time
from array import array

from micropython import const
from polling import UNKNOWN, Fault
from registers import Registers

_CONFIGURATION = const(0)
_SHUNT = const(1)  # steps of 2.5 uV
_BUS = const(2)  # steps of 1.25 mV
_MASK = const(6)
_MAKER = const(0xFE)
_DIE = const(0xFF)
_READY = const(8)  # in the mask: a conversion has ended since it was read
_TEXAS = const(0x5449)
_FULL = const(32767)  # what is more across the shunt reads so


class Ina226:
    """`opened` opens its bus; so many conversions are averaged as `code` says, by table 6 of the data sheet.

    In `wait_ms` they have ended, on each chip that works.
    """

    def __init__(self, opened, address, code, wait_ms):
        self.values = array("i", [UNKNOWN] * 3)
        self._registers = Registers(opened, address)
        self._setting = 0x4127 | code << 9  # 1.1 ms for each conversion, of both, one after the other
        self._wait_ms = wait_ms
        self._since_ms = None

    def begin(self):
        """Look who answers, and set it up."""
        registers = self._registers
        registers.open()
        maker = registers.read(_MAKER)
        die = registers.read(_DIE)
        if maker != _TEXAS or die >> 4 != 0x226:
            raise Fault(f"no INA226: its id is {maker:04x} {die:04x}")
        registers.write(_CONFIGURATION, self._setting)
        if registers.read(_CONFIGURATION) != self._setting:
            raise Fault("it does not keep its settings")
        self._since_ms = None

    def poll(self, now_ms):
        """Read it, if a conversion has ended; return whether that is so."""
        registers = self._registers
        if not registers.read(_MASK) & _READY:
            if self._since_ms is None:
                self._since_ms = now_ms
            elif time.ticks_diff(now_ms, self._since_ms) > self._wait_ms:
                raise Fault("it does not convert")
            return False
        self._since_ms = None
        values = self.values
        volts = registers.read(_BUS)
        shunt = registers.read_signed(_SHUNT)
        values[0] = volts
        values[1] = values[2] = UNKNOWN
        if -_FULL <= shunt < _FULL:
            values[1] = shunt
            values[2] = volts * shunt if volts <= _FULL else UNKNOWN
        return True
