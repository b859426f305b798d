"""A sensor whose driver is a file of the project: ``specs/drivers/NAME.yaml`` declares its keys and its outputs."""

import os
import re
from collections.abc import Iterator, Mapping, Sequence
from difflib import get_close_matches

from codegen.diagnostics import did_you_mean
from codegen.frozen import dataclass
from codegen.model.quantities.source_kind import ClockUse, Output, PinUse, Polling, Source, SourceFact
from codegen.model.spec.described import Verbatim
from codegen.model.spec.driver import BusKind, DriverSpec, KeyKind, OutputSpec, OwnDriver
from codegen.model.spec.source import OwnSourceSpec
from codegen.pattern import pattern
from codegen.source import Place
from codegen.sources.class_calls import Use, check_use
from codegen.sources.declared import declared_output
from codegen.sources.kind import BAD_SOURCE, Around, check_class
from codegen.sources.module_names import taken_by
from codegen.sources.own.keys import WHOLE, KeyReader
from codegen.sources.wires import USUAL_CLOCK, Bus, Serial, bus, clock, serial

_CLASS = pattern(r"[A-Za-z_]\w*", re.ASCII)
_OF_BUS: Mapping[BusKind | None, tuple[str, ...]] = {
    None: (),
    BusKind.I2C: ("i2c", "sda", "scl"),
    BusKind.UART: ("uart", "tx", "rx", "baud"),
}
_USUAL_BAUD = "9600"


@dataclass(frozen=True, slots=True)
class OwnSource(Source):
    """A sensor with the driver ``name``; ``arguments`` are those that its class is made with, by name."""

    polling: Polling
    outputs: tuple[Output, ...]
    driver: OwnDriver
    wires: Bus | Serial | None
    arguments: tuple[tuple[str, str], ...]
    inputs: tuple[PinUse, ...]

    @property
    def module(self) -> str:
        return self.polling.spec.driver

    def declared(self, output: Output) -> OutputSpec:
        return self.driver.spec.outputs[output.name]

    @property
    def keeps_limits(self) -> bool:
        return False

    @property
    def declared_values(self) -> int:
        return sum(output.storage.words for output in self.outputs)

    @property
    def own_modules(self) -> Mapping[str, str]:
        return {self.driver.path: self.driver.text}

    @property
    def mocks(self) -> tuple[str, ...]:
        return ("i2c/mocks/mock_i2c.py",) if isinstance(self.wires, Bus) else ()

    @property
    def opened(self) -> str:
        first = [f"lambda: {self.wires.opened}"] if self.wires else []
        arguments = ", ".join([*first, *(f"{name}={value}" for name, value in self.arguments)])
        return f"{self.driver.spec.class_name}({arguments})"

    @property
    def port(self) -> str:
        return self.wires.port if isinstance(self.wires, Serial) else ""

    @property
    def address(self) -> int | None:
        """Return where it is on its I2C bus, by the key of this name; None without one."""
        given = dict(self.arguments).get("address", "") if isinstance(self.wires, Bus) else ""
        return int(given) if WHOLE.fullmatch(given) else None

    @property
    def place(self) -> str:
        return f"address {self.address:#x} of {self.line}" if self.address is not None else ""

    @property
    def line(self) -> str:
        """Return the words for what it is connected to; empty for nothing that codegen opens."""
        if isinstance(self.wires, Bus):
            return f"I2C {self.wires.number}"
        return self.wires.port if self.wires else ""

    @property
    def cause(self) -> str:
        if not self.line or isinstance(self.wires, Serial):
            return f"{self.line} does not work" if self.line else ""
        return "no answer on " + self.line if self.address is None else f"no answer at {self.address:#x} on {self.line}"

    @property
    def clock(self) -> ClockUse | None:
        if not isinstance(self.wires, Bus):
            return None
        return ClockUse(self.line, self.wires.frequency, "keys.frequency")

    def pins(self) -> Iterator[PinUse]:
        if self.wires is not None:
            yield from self.wires.pins()
        yield from self.inputs

    def facts(self) -> Iterator[SourceFact]:
        yield SourceFact("class", self.driver.spec.class_name, "driver")
        if self.wires is not None:
            yield SourceFact("connected by", self.wires.opened, "driver")
        for name, value in self.arguments:
            yield SourceFact(name, value, f"keys.{name}")

    def words(self) -> str:
        return self.driver.spec.doc.rstrip(".")


def resolve_own(spec: OwnSourceSpec, polling: Polling, around: Around, driver: OwnDriver) -> OwnSource | None:
    """Return the sensor, with its keys as the driver declares them; None after a finding."""
    declared = driver.spec
    found = [declared_output(name, output, around) for name, output in declared.outputs.items()]
    outputs = tuple(each[0] for each in found if each is not None)
    reader = KeyReader(declared, around)
    wrong = reader.check()
    if not _CLASS.fullmatch(declared.class_name):
        around.report.add(
            BAD_SOURCE, declared.at("class"), f"{declared.class_name} is no name of a class", "class: Compass"
        )
        around.failed = True
    else:
        check_class(declared.class_name, driver.module, declared.at("class"), around)
        if not wrong:
            check_use(declared.class_name, driver.module, declared.at("class"), _use(declared, outputs), around)
    file = os.path.basename(declared.place.file)
    owner = taken_by(file)
    if owner is not None:
        message = f"{file.removesuffix('.yaml')} cannot be the name of a driver: {owner} has a module of this name"
        around.report.add(BAD_SOURCE, Place(declared.place.file), message, f"rename both files: my_{file}")
        around.failed = True
    of_bus = _OF_BUS[declared.bus]
    known = (*declared.keys, *of_bus, *(("frequency",) if declared.bus is BusKind.I2C else ()))
    unknown = [name for name in spec.keys if name not in known]
    for name in unknown:
        hint = did_you_mean(name, known)
        around.bad(f"keys.{name}", f"the driver {spec.driver} has no key {name}", hint)
    arguments, inputs = [], []
    for name, key in declared.keys.items():
        if name in wrong or (name not in spec.keys and get_close_matches(name, unknown, n=1)):
            continue  # a misspelt key is one mistake
        value = reader.value(name, key, spec.keys.get(name))
        if value is not None:
            arguments.append((name, value))
            board = around.known_board(f"the pin {name}") if key.kind is KeyKind.PIN else None
            if board is not None:
                around.pin(f"keys.{name}", int(value), board.free, name, board)
                inputs.append(PinUse(int(value), f"keys.{name}", board.free))
    wires = _wires(declared, spec, around)
    if around.failed or (declared.bus is not None and wires is None) or None in found:
        return None
    return OwnSource(polling, outputs, driver, wires, tuple(arguments), tuple(inputs))


def _use(declared: DriverSpec, outputs: Sequence[Output]) -> Use:
    """Return what the firmware calls of the class: it is made with the function that opens its bus, and the keys."""
    first = ("opened",) if declared.bus else ()
    count = sum(output.storage.words for output in outputs)
    wide = [output.name for output in outputs if output.storage.words > 1]
    values = f'in __init__: self.values = array("i", [UNKNOWN] * {count})'
    values += f", two each of {', '.join(wide)}, whose limits need 32 bits" if wide else ""
    lengths = {"values": count} if len(outputs) == len(declared.outputs) else {}  # of others nobody knows
    return Use(first, tuple(declared.keys), {"begin": (), "poll": ("now_ms",)}, {"values": values}, lengths)


class _Keys:
    """The keys of a bus as numbers."""

    def __init__(self, given: Mapping[str, int]) -> None:
        self._given = given

    def __getattr__(self, name: str) -> int:
        return self._given[name]


def _clock(declared: DriverSpec, spec: OwnSourceSpec, around: Around) -> int:
    """Return the clock of its bus in Hz: that of the sensor, or that of the driver."""
    usual = declared.frequency or USUAL_CLOCK
    written = None if "frequency" in declared.keys else spec.keys.get("frequency")
    return clock(written, usual, around, "keys.frequency")


def _wires(declared: DriverSpec, spec: OwnSourceSpec, around: Around) -> Bus | Serial | None:
    """Return what the device is connected to; None without, and after a finding."""
    given, kind = {}, declared.bus
    for name in _OF_BUS[kind]:
        written: Verbatim | str | None = spec.keys.get(name, _USUAL_BAUD if name == "baud" else None)
        if written is None or not WHOLE.fullmatch(written):
            problem = "is missing" if written is None else f"is {written}, no whole number"
            around.bad(
                "driver" if written is None else f"keys.{name}",
                f"{name} {problem}",
                hint=f"write a whole number: {name}: 4",
            )
            continue
        given[name] = int(written, 0)
    if kind is None or len(given) < len(_OF_BUS[kind]):
        return None
    keys = _Keys(given)
    frequency = _clock(declared, spec, around) if kind is BusKind.I2C else 0
    around.prefix = "keys."
    found = bus(keys, frequency, around) if kind is BusKind.I2C else serial(keys, given["baud"], 512, around)
    around.prefix = ""
    return found
