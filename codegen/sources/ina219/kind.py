"""An INA219: voltages up to 32 V in steps of 4 mV, across the shunt up to 320 mV in steps of 10 uV."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.quantities.source_kind import Polling
from codegen.sources.i2c.monitor import Chip, Monitor, MonitorSpec, resolve_monitor
from codegen.sources.i2c.shown import Sheet
from codegen.sources.kind import Around, KindOfSource

SHEET = Sheet(
    reset={0: 0x399F, 1: 0, 2: 0, 3: 0},
    read_only=(1, 2, 3),
    volts=Fraction(4, 1000),
    bus_shift=3,
    bus_flags=2,
    most_bus=8000,
    across=Fraction(10, 1000000),
    most_across=31999,
    averages=((1, 8), (2, 9), (4, 10), (8, 11), (16, 12), (32, 13), (64, 14), (128, 15)),
    setting_mask=0x3FFF,
    setting=0x3807,
    setting_shifts=(7, 3),
)
"""Tables 2 to 6 of SBOS448G: 32 V, 320 mV; averages stand in bits 7 to 10 and 3 to 6, 7 converts both for ever."""

CHIP = Chip(
    kind="ina219",
    name="INA219",
    bus_step=Fraction(1, 250),
    most_bus=8000,
    shunt_step=Fraction(1, 100000),
    most_shunt=31999,
    longest_us=586,
    codes={1: 8, 2: 9, 4: 10, 8: 11, 16: 12, 32: 13, 64: 14, 128: 15},
    sheet=SHEET,
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Ina219Spec(MonitorSpec):
    """An INA219 on an I2C bus."""


def resolve_ina219(spec: Ina219Spec, polling: Polling, around: Around) -> Monitor | None:
    """The bus and the shunt; None after a finding."""
    return resolve_monitor(spec, polling, around, CHIP)


INA219 = KindOfSource("ina219", Ina219Spec, resolve_ina219, "10 Hz")
