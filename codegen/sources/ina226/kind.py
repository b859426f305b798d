"""An INA226: voltages up to 36 V in steps of 1.25 mV, across the shunt up to 82 mV in steps of 2.5 uV."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.quantities.source_kind import Polling
from codegen.sources.i2c.monitor import Chip, Monitor, MonitorSpec, resolve_monitor
from codegen.sources.kind import Around, KindOfSource

CHIP = Chip(
    kind="ina226",
    name="INA226",
    bus_step=Fraction(1, 800),
    most_bus=28800,
    shunt_step=Fraction(1, 400000),
    most_shunt=32766,
    longest_us=1210,
    codes={1: 0, 4: 1, 16: 2, 64: 3, 128: 4, 256: 5, 512: 6, 1024: 7},
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Ina226Spec(MonitorSpec):
    """An INA226 on an I2C bus."""


def resolve_ina226(spec: Ina226Spec, polling: Polling, around: Around) -> Monitor | None:
    """The bus and the shunt; None after a finding."""
    return resolve_monitor(spec, polling, around, CHIP)


INA226 = KindOfSource("ina226", Ina226Spec, resolve_ina226, "10 Hz")
