"""``drivers/NAME.yaml``: a driver of the project's own, for the sensors of board.yaml that say ``driver: NAME``."""

from collections.abc import Mapping
from enum import StrEnum
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.spec.described import Amount, described
from codegen.model.spec.python_class import PythonClass
from codegen.source import Place, Written


class KeyKind(StrEnum):
    """The kind of value that a key of a sensor takes."""

    WHOLE = "whole"
    NUMBER = "number"
    TEXT = "text"
    BOOLEAN = "boolean"
    PIN = "pin"


class BusKind(StrEnum):
    """The bus that the driver's device is connected to."""

    I2C = "i2c"
    UART = "uart"


@dataclass(frozen=True, slots=True, kw_only=True)
class DriverKeySpec(Written):
    """One key of a sensor: the driver is made with its value, under its name."""

    doc: str = described("What it is, for people.")
    kind: KeyKind = described("What stands there; a pin is a GPIO number.", default=KeyKind.WHOLE)
    default: str | bool | Fraction | None = described("Its value where a sensor says none.", default=None)
    min: Fraction | None = described("Smallest number.", default=None)
    max: Fraction | None = described("Largest number.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class OutputSpec(Written):
    """One number that a sensor gives."""

    doc: str | None = described("What it is, for people.", default=None)
    unit: str | None = described("Unit that the code gives it in, such as m; absent for pure numbers.", default=None)
    stored: str | None = described("Unit of one step that it is rounded to, such as mm. Default: unit.", default=None)
    min: Fraction | None = described("Smallest plausible value, in unit; what is less is unknown.", default=None)
    max: Fraction | None = described("Largest plausible value, in unit; what is more is unknown.", default=None)


@dataclass(frozen=True, slots=True, kw_only=True)
class DriverSpec(Written):
    """A driver: NAME.py beside this file has its class, with ``values``, begin() and poll(now_ms)."""

    doc: str = described("What it drives, for people.")
    class_name: str = described("Its class in NAME.py.", key="class")
    bus: BusKind | None = described(
        "What the device is connected to: i2c (a sensor says i2c, sda, scl, and may say frequency) or uart (uart, tx, "
        "rx, baud). The class gets a function that opens it as its first argument.",
        default=None,
    )
    frequency: Amount | None = described(
        "Clock of its I2C bus where a sensor says no frequency, such as 100 kHz. Default: 400 kHz.", default=None
    )
    keys: Mapping[str, DriverKeySpec] = described("The keys of a sensor, by name.", default_factory=dict)
    outputs: Mapping[str, OutputSpec] = described(
        "The numbers that it gives, by name, in the order of its values, each in whole steps of stored; one whose "
        "limits need 32 bits has two values, its halves of 16 bits, the low one first."
    )
    rate: Amount | None = described("How often it is asked where a sensor says nothing. Default: 10 Hz.", default=None)


@dataclass(frozen=True, slots=True)
class DriverModule:
    """A module with the class of a driver: its file, its names, and those that are classes it defines.

    ``names`` is None where it can have any. ``shapes`` are those classes of which the source shows all. ``fault`` is a
    line that is no Python, and what is wrong with it.
    """

    path: str
    names: frozenset[str] | None
    classes: tuple[str, ...]
    shapes: Mapping[str, PythonClass]
    fault: tuple[int, str] | None


@dataclass(frozen=True, slots=True)
class StateStore:
    """An attribute of a component of the state that a module of the user's sets, with its place."""

    component: str
    attribute: str
    place: Place


@dataclass(frozen=True, slots=True)
class OwnDriver:
    """A driver of the project's own with the text of its module, whose file is ``path``."""

    spec: DriverSpec
    path: str
    text: str
    module: DriverModule
