"""Sensors: what the stages ask each of them, whatever its kind is (``codegen/sources/``)."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from codegen.frozen import dataclass
from codegen.model.code.storage import Storage, storage_of
from codegen.model.quantities.device import Device
from codegen.model.quantities.simulated import SimulatedInput
from codegen.model.spec.driver import OutputSpec
from codegen.model.spec.source import SourceSpec
from codegen.model.units.unit import Unit
from codegen.model.vehicle import Cited

FAULTS = {
    "fail": "the sensor fails",
    "absent": "the sensor is absent",
    "slow": "the sensor takes longer",
    "stuck": "the sensor gives what it gave",
}
"""Faults of a sensor in a simulation."""


@dataclass(frozen=True, slots=True)
class Output:
    """One number that a sensor gives: whole steps of ``unit``, plausible from ``low`` to ``high``.

    ``name`` is empty where a sensor gives only one. What lies outside of its limits is unknown.
    """

    name: str
    unit: Unit
    low: int
    high: int
    doc: str

    @property
    def storage(self) -> Storage:
        """Return how the driver hands it over: a small integer, or its halves of 16 bits, the low one first."""
        storage = storage_of(self.low, self.high)
        assert storage is not None
        return storage


@dataclass(frozen=True, slots=True)
class Polling(Cited):
    """The common settings of sensors: the name, the period of polling, its time limit, and the delay of a new set-up.

    ``limit_us`` is None where nothing limits it.
    """

    name: str
    period_us: int
    limit_us: int | None
    retry_ms: int
    spec: SourceSpec


class PinUse(NamedTuple):
    """A GPIO number that a sensor takes: the key that says so, and the numbers that could stand there instead.

    ``shared`` names what several sensors may be connected to together, such as the lines of a bus; else it is empty.
    """

    gpio: int
    key: str
    choices: frozenset[int]
    shared: str = ""


class ClockUse(NamedTuple):
    """The clock of a bus as a sensor wants it: the bus, its frequency in Hz, and the key that says so."""

    bus: str
    frequency: int
    key: str


class SourceFact(NamedTuple):
    """One attribute of a sensor, as text that differs exactly where the attribute does; ``key`` decides it.

    ``asks``: where it is another one, the same reading may be another number, unless what is connected is another, too.
    What says how long or how often something is read does not; nor does what the outputs say. ``is_trust``: it says
    after what silence nothing is believed any more.
    """

    attribute: str
    text: str
    key: str
    asks: bool = True
    is_trust: bool = False


class Source(ABC):
    """A sensor, resolved. Every kind is a frozen dataclass in a folder of its own."""

    __slots__ = ()

    @property
    @abstractmethod
    def polling(self) -> Polling:
        """Return the settings that sensors of all kinds have: name, period, time limit, time to a new set-up."""

    @property
    @abstractmethod
    def outputs(self) -> tuple[Output, ...]:
        """Return what it gives."""

    def output(self, name: str) -> Output | None:
        """Return the output that is called so; without a name the only one, whatever it is called."""
        outputs = self.outputs
        if not name and len(outputs) == 1:
            return outputs[0]
        return next((output for output in outputs if output.name == name), None)

    @property
    def name(self) -> str:
        """Return what board.yaml calls it."""
        return self.polling.name

    @property
    def is_polled(self) -> bool:
        """Return whether the firmware asks it by itself, in a slot of its own; else
        what it gives is read with a component.
        """
        return True

    # the firmware

    @property
    @abstractmethod
    def module(self) -> str:
        """The module of its driver."""

    @property
    @abstractmethod
    def opened(self) -> str:
        """The expression that makes its driver; ``machine`` is there, and nothing is connected to yet."""

    @property
    def modules(self) -> tuple[str, ...]:
        """The files of the firmware that its driver takes beside its own, by their paths below codegen/sources."""
        return ()

    @property
    def own_modules(self) -> Mapping[str, str]:
        """The same of the project's own: the texts by the paths of their files."""
        return {}

    @property
    def imported(self) -> str:
        """The module of the user's code that its driver imports; empty for none."""
        return ""

    @property
    def mocks(self) -> tuple[str, ...]:
        """The files that stand in for its hardware on a host, by their paths below codegen/sources."""
        return ()

    @property
    def given_in(self) -> tuple[Fraction, ...]:
        """Return for each output the number of its steps in the unit in which read() of the user's code gives it.

        Empty where a driver gives steps.
        """
        return ()

    def declared(self, output: Output) -> OutputSpec | None:  # noqa: ARG002
        """Return what the project declares an output to be; None where the driver is not the project's."""
        return None

    @property
    def declared_values(self) -> int | None:
        """Return how many values the driver has to have; None where it is not the project's, and so has them."""
        return None

    @property
    def tests(self) -> tuple[str, ...]:
        """The files of the generated suite that check its driver, by their paths below codegen/sources.

        Those whose name ends in ``_driver.py`` are run: they print what went wrong in each of their CHECKS.
        """
        return ()

    def device(self, number: int) -> Device | None:  # noqa: ARG002
        """Return its device, for checks of the whole way from there to the state, worked out from its data sheet.

        ``number`` is its place among all sensors: each shows other amounts. None where nobody has a model of it.
        """
        return None

    @property
    def cause(self) -> str:
        """Return what is wrong where its driver raises OSError, in the operator's words; empty: that says its name."""
        return "no answer"

    @property
    def sets_clock(self) -> bool:
        """Return whether it knows the time since 1970: its microseconds stand behind the outputs, in four halves."""
        return False

    @property
    def keeps_limits(self) -> bool:
        """Return whether its driver itself makes unknown what passes the limits of 32 bits or more, and never else."""
        return True

    @property
    def tells_new(self) -> bool:
        """Return whether one reading of the sensor may renew some of its numbers and leave others as they were.

        The last of the driver's values has a bit for each output that is new then, and one for the time.
        """
        return False

    @property
    def clock_modules(self) -> tuple[str, ...]:
        """Further files of the firmware, where it sets the clock; the first has set_clock(words, at, values, place)."""
        return ()

    @property
    def renewed_us(self) -> int:
        """Return the longest time from one new value to the next while it works, in us: it may take several turns."""
        return self.polling.period_us

    @property
    def renewed_key(self) -> str:
        """Return the key that decides this."""
        return "rate"

    @property
    def silence_ms(self) -> int | None:
        """Return the time in ms without anything new after which it counts as failed; None: it always has something."""
        return None

    # what it is connected to

    def pins(self) -> Iterator[PinUse]:
        """The pins that it takes."""
        return iter(())

    @property
    def port(self) -> str:
        """Return what it takes as a whole, such as ``UART 1``; else empty."""
        return ""

    @property
    def place(self) -> str:
        """Return where it alone is on something that is shared, such as an address of a bus; else empty."""
        return ""

    @property
    def clock(self) -> ClockUse | None:
        """Return at which clock it wants a bus that others may be on, too; None where there is none."""
        return None

    # the simulation

    def simulated(self, output: Output, steps: Fraction) -> SimulatedInput | None:
        """Return how a true value of an output reaches the firmware on a host; ``steps`` of the output make one of its
        unit.

        It is given in place of the driver, unless a kind has a mock of its device: then that is driven. None: it
        follows from other outputs.
        """
        places = [each.storage.words for each in self.outputs]
        number = self.outputs.index(output)
        settings = {"source": self.name, "place": sum(places[:number]), "words": places[number], "size": sum(places)}
        return SimulatedInput("source", {**settings, "steps": float(steps)}, FAULTS)

    # words

    @abstractmethod
    def facts(self) -> Iterator[SourceFact]:
        """Return what two versions of it are compared by, beside what all sensors have."""

    @abstractmethod
    def words(self) -> str:
        """Return what it is, in a line for documents and pages."""


def hertz(period_us: int) -> Fraction:
    """The rate of a period."""
    return Fraction(1000000, period_us)
