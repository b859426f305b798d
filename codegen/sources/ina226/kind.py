"""An INA226: voltages up to 36 V in steps of 1.25 mV, across the shunt up to 82 mV in steps of 2.5 uV."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.quantities.source_kind import Polling
from codegen.sources.i2c.monitor import Chip, Monitor, MonitorSpec, resolve_monitor
from codegen.sources.i2c.shown import Sheet
from codegen.sources.kind import Around, KindOfSource

SHEET = Sheet(
    reset={0: 0x4127, 1: 0, 2: 0, 6: 8, 0xFE: 0x5449, 0xFF: 0x2260},
    read_only=(1, 2, 0xFE, 0xFF),
    volts=Fraction(125, 100000),
    bus_shift=0,
    bus_flags=0,
    most_bus=28800,
    across=Fraction(25, 10000000),
    most_across=32766,
    averages=((1, 0), (4, 1), (16, 2), (64, 3), (128, 4), (256, 5), (512, 6), (1024, 7)),
    setting_mask=0x0E07,
    setting=0x0007,
    setting_shifts=(9,),
)
"""Tables 3 to 8 of SBOS547A: averages stand in bits 9 to 11, 7 in the lowest three converts both for ever."""

CHIP = Chip(
    kind="ina226",
    name="INA226",
    bus_step=Fraction(1, 800),
    most_bus=28800,
    shunt_step=Fraction(1, 400000),
    most_shunt=32766,
    longest_us=1210,
    codes={1: 0, 4: 1, 16: 2, 64: 3, 128: 4, 256: 5, 512: 6, 1024: 7},
    sheet=SHEET,
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Ina226Spec(MonitorSpec):
    """An INA226 on an I2C bus."""


def resolve_ina226(spec: Ina226Spec, polling: Polling, around: Around) -> Monitor | None:
    """The bus and the shunt; None after a finding."""
    return resolve_monitor(spec, polling, around, CHIP)


INA226 = KindOfSource("ina226", Ina226Spec, resolve_ina226, "10 Hz")
