"""An INA219: voltages up to 32 V in steps of 4 mV, across the shunt up to 320 mV in steps of 10 uV."""

from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.quantities.source_kind import Polling
from codegen.sources.i2c.monitor import Chip, Monitor, MonitorSpec, resolve_monitor
from codegen.sources.kind import Around, KindOfSource

CHIP = Chip(
    kind="ina219",
    name="INA219",
    bus_step=Fraction(1, 250),
    most_bus=8000,
    shunt_step=Fraction(1, 100000),
    most_shunt=31999,
    longest_us=586,
    codes={1: 8, 2: 9, 4: 10, 8: 11, 16: 12, 32: 13, 64: 14, 128: 15},
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Ina219Spec(MonitorSpec):
    """An INA219 on an I2C bus."""


def resolve_ina219(spec: Ina219Spec, polling: Polling, around: Around) -> Monitor | None:
    """The bus and the shunt; None after a finding."""
    return resolve_monitor(spec, polling, around, CHIP)


INA219 = KindOfSource("ina219", Ina219Spec, resolve_ina219, "10 Hz")
