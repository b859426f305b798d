"""Monitors of voltage and current with a shunt: what differs between two chips is a record."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.measure import read_amount
from codegen.model.quantities.device import Device
from codegen.model.quantities.simulated import SimulatedInput
from codegen.model.quantities.source_kind import FAULTS, ClockUse, Output, PinUse, Polling, Source, SourceFact
from codegen.model.spec.described import Amount, described
from codegen.model.spec.source import SourceSpec
from codegen.model.units.unit import Unit, decimal, unit_named
from codegen.sources.i2c.shown import Sheet, monitor_device
from codegen.sources.kind import Around
from codegen.sources.wires import USUAL_CLOCK, Bus, bus, clock


@dataclass(frozen=True, slots=True, kw_only=True)
class MonitorSpec(SourceSpec):
    """A monitor of voltage and current on an I2C bus, which measures the current by the voltage across a shunt."""

    i2c: int = described("Number of the I2C bus.")
    sda: int = described("GPIO number of the bus's data.")
    scl: int = described("GPIO number of the bus's clock.")
    address: int = described("Address of the device on the bus.", default=0x40)
    shunt: Amount = described("Resistance of the shunt, such as 2 mOhm.")
    average: int = described("How many conversions are averaged; the chip has powers of two.", default=16)
    frequency: Amount | None = described("Clock of the bus, such as 100 kHz. Default: 400 kHz.", default=None)


@dataclass(frozen=True, slots=True)
class Chip:
    """The data of one chip: the volts of a step of the bus and of the shunt, with the most steps of each.

    ``longest_us`` is the longest time of one conversion, by the data sheet, as the driver sets it up. ``codes`` has
    what stands for so many conversions that are averaged; ``kind`` is the word for the driver. ``sheet`` are the same
    and more numbers as the data sheet has them, for checks that take nothing from here.
    """

    kind: str
    name: str
    bus_step: Fraction
    most_bus: int
    shunt_step: Fraction
    most_shunt: int
    longest_us: int
    codes: dict[int, int]
    sheet: Sheet


@dataclass(frozen=True, slots=True)
class Monitor(Source):
    """One of them on a bus; ``shunt`` are its Ohm."""

    polling: Polling
    chip: Chip
    bus: Bus
    address: int
    shunt: Fraction
    average: int

    @property
    def outputs(self) -> tuple[Output, ...]:
        chip = self.chip
        volts, amperes = chip.bus_step, chip.shunt_step / self.shunt
        shunt, power = chip.most_shunt, chip.most_bus * chip.most_shunt
        return (
            Output("voltage", _steps("V", volts), 0, chip.most_bus, "Of the bus."),
            Output("current", _steps("A", amperes), -shunt, shunt, "Through the shunt."),
            Output("power", _steps("W", volts * amperes), -power, power, "Of what the shunt leads to."),
        )

    @property
    def module(self) -> str:
        return self.chip.kind

    @property
    def modules(self) -> tuple[str, ...]:
        return (f"{self.chip.kind}/firmware/{self.chip.kind}.py", "i2c/firmware/registers.py")

    @property
    def mocks(self) -> tuple[str, ...]:
        return ("i2c/mocks/mock_i2c.py", "i2c/mocks/sim_monitor.py")

    @property
    def tests(self) -> tuple[str, ...]:
        return ("i2c/tests/monitor_device.py",)

    def device(self, number: int) -> Device:
        return monitor_device(self.chip.sheet, (self.bus.number, self.address), self.shunt, self.average, number)

    def simulated(self, output: Output, steps: Fraction) -> SimulatedInput | None:
        if output.name not in ("voltage", "current"):
            return None  # it follows from these
        place = {"chip": self.chip.kind, "bus": self.bus.number, "address": self.address}
        return SimulatedInput("monitor", {**place, "output": output.name, "steps": float(steps)}, FAULTS)

    @property
    def opened(self) -> str:
        code = self.chip.codes[self.average]
        wait_ms = -(-2 * self.conversion_us // 1000)  # twice as long as any chip takes
        return f"{self.chip.kind.capitalize()}(lambda: {self.bus.opened}, {self.address:#x}, {code}, {wait_ms})"

    @property
    def conversion_us(self) -> int:
        """Return the longest time that it takes to a new value, in us: of the bus and of the shunt, averaged."""
        return 2 * self.chip.longest_us * self.average

    @property
    def renewed_us(self) -> int:
        period_us = self.polling.period_us
        return -(-self.conversion_us // period_us) * period_us

    @property
    def renewed_key(self) -> str:
        return "average" if self.conversion_us > self.polling.period_us else "rate"

    @property
    def cause(self) -> str:
        return f"no answer at {self.address:#x} on I2C {self.bus.number}"

    def pins(self) -> Iterator[PinUse]:
        return self.bus.pins()

    @property
    def place(self) -> str:
        return f"address {self.address:#x} of I2C {self.bus.number}"

    @property
    def clock(self) -> ClockUse:
        return ClockUse(f"I2C {self.bus.number}", self.bus.frequency, "frequency")

    def facts(self) -> Iterator[SourceFact]:
        yield SourceFact("bus", self.bus.opened, "i2c")
        yield SourceFact("address", f"{self.address:#x}", "address")
        yield SourceFact("shunt", f"{decimal(self.shunt)} Ohm", "shunt")
        yield SourceFact("average", f"of {self.average} conversions", "average", asks=False)

    def words(self) -> str:
        shunt = decimal(self.shunt * 1000)
        return f"{self.chip.name} at {self.address:#x} on I2C {self.bus.number}, shunt of {shunt} mOhm"


def _steps(unit: str, size: Fraction) -> Unit:
    """Steps of so many of a unit."""
    base = unit_named(unit)
    named = {Fraction(1, 1000): f"m{unit}", Fraction(1, 100): f"c{unit}", Fraction(1): unit}
    name = named.get(size, f"steps of {decimal(size)} {unit}")
    return replace(base, name=name, scale=base.scale * size)


def resolve_monitor(spec: MonitorSpec, polling: Polling, around: Around, chip: Chip) -> Monitor | None:
    """The bus and the shunt; None after a finding."""
    shunt = read_amount(spec.shunt, unit_named("Ohm"), spec.at("shunt"), around.report)
    frequency = clock(spec.frequency, USUAL_CLOCK, around)
    if shunt is not None and not Fraction(1, 100000) <= shunt <= 10:
        around.bad("shunt", f"a shunt of {spec.shunt} is not one of 0.01 mOhm to 10 Ohm", hint="shunt: 2 mOhm")
    if not 0x40 <= spec.address <= 0x4F:
        around.bad(
            "address",
            f"{spec.address:#x} is no address of an {chip.name}, which has 0x40 to 0x4f",
            hint="address: 0x40, if its pins A0 and A1 are at GND",
        )
    if spec.average not in chip.codes:
        known = ", ".join(map(str, chip.codes))
        around.bad("average", f"the {chip.name} does not average {spec.average} conversions", f"known: {known}")
    found = bus(spec, frequency, around)
    if found is None or shunt is None or around.failed:
        return None
    return Monitor(polling, chip, found, spec.address, shunt, spec.average)
