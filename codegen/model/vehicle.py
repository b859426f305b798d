"""The parts of the vehicle, resolved: ADC channels, parameters, the state with its quantities, streams."""

import math
from collections.abc import Mapping
from dataclasses import replace
from enum import Enum
from fractions import Fraction
from typing import TYPE_CHECKING

from codegen.frozen import dataclass
from codegen.model.code.letters import on_one_line, words_of
from codegen.model.code.storage import Storage
from codegen.model.dialect.dialect import EnumDefinition
from codegen.model.quantities.basis import Basis
from codegen.model.quantities.derivation import Derivation
from codegen.model.quantities.trust import Trust
from codegen.model.spec.board import AdcSpec
from codegen.model.spec.spec import Criterion, ParameterSpec, Requirement, StreamSpec
from codegen.model.spec.state import ComponentSpec, QuantitySpec
from codegen.model.units.unit import Unit

if TYPE_CHECKING:
    from codegen.model.quantities.conversion import Conversion


@dataclass(frozen=True, slots=True)
class Citation:
    """A requirement, or one criterion of it, that a part of the system answers to."""

    requirement: Requirement
    criterion: Criterion | None

    def __str__(self) -> str:
        """``FR-00068`` or ``FR-00068.3``."""
        return self.requirement.id if self.criterion is None else f"{self.requirement.id}.{self.criterion.number}"


@dataclass(frozen=True, slots=True)
class Cited:
    """Something that criteria ask for: ``citation`` for the whole of it, ``aspects`` for single ones."""

    citation: Citation | None
    aspects: Mapping[str, Citation]

    def cited(self, aspect: str) -> str:
        """The criterion that asks for one aspect, or the one for the whole, or nothing."""
        return str(self.aspects.get(aspect, self.citation or ""))

    def criteria(self, *aspects: str) -> tuple[str, ...]:
        """The criteria of some aspects, or of the whole where none is named, each once."""
        names = [self.cited(aspect) for aspect in aspects] or [str(self.citation or "")]
        return tuple(dict.fromkeys(name for name in names if name))


@dataclass(frozen=True, slots=True)
class AdcChannel(Cited):
    """An ADC channel: ``full_scale`` is the largest count, ``reference`` the volts that it stands for.

    ``read_limit_us`` is the longest time for one mean in microseconds, or None. ``pin`` is the parameter that has the
    GPIO number, or None; ``gpio`` is then its default. ``when`` is a parameter with the steps at which the channel is
    read at all; None: it always is.
    """

    name: str
    gpio: int
    pin: "Parameter | None"
    when: "tuple[Parameter, int] | None"
    bits: int
    full_scale: int
    reference: Fraction
    samples: int
    read_limit_us: int | None
    spec: AdcSpec


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter; the firmware keeps ``default``, ``minimum`` and ``maximum`` as whole ``steps``.

    ``step`` is the value of one step in ``unit``. ``choices`` are the only steps that are accepted, with what each
    means; without any, every one within the limits is. One of a family belongs to an ``instance`` of a ``component``,
    and ``siblings`` are the names of the family by instance.
    """

    name: str
    unit: Unit
    step: Fraction
    default: int
    minimum: int
    maximum: int
    choices: Mapping[int, str]
    spec: ParameterSpec
    citation: Citation | None
    component: str | None = None
    instance: int = 0
    siblings: tuple[str, ...] = ()

    @property
    def path(self) -> str:
        """Return how tables and documents write it, as ``Quantity.path``: its name."""
        return self.name


def by_instance(parameter: Parameter, parameters: Mapping[str, Parameter], instances: int) -> tuple[Parameter, ...]:
    """The parameter of each instance: one of its family for each, or the same for all."""
    names = parameter.siblings or (parameter.name,) * instances
    return tuple(parameters.get(name, parameter) for name in names)


class QuantityKind(Enum):
    """The kind of values that a quantity of the vehicle state holds."""

    NUMBER = "number"
    ENUM = "enum"
    BOOLEAN = "boolean"
    TEXT = "text"


@dataclass(frozen=True, slots=True)
class Represented:
    """A quantity that code sets in place of the ADC where a ``parameter`` has so many ``steps`` when the board starts.

    A value is believed for ``stale_after_ms`` after it was set.
    """

    parameter: Parameter
    steps: int
    stale_after_ms: int

    def readings(self, component: "Component") -> int:
        """The same in readings of the component."""
        return math.ceil(self.stale_after_ms / component.read_every_ms)


@dataclass(frozen=True, slots=True)
class Quantity(Cited):
    """A quantity of the vehicle state, kept in ``stored`` units, as an integer or a float: ``storage`` says how.

    ``steps`` stored units make one ``unit`` (1000 for V kept in mV). ``minimum`` and ``maximum`` are in stored units;
    without a limit in the table they are what the storage holds, or the fields carry. They are whole numbers where
    integers are kept. ``initial`` is None where the quantity starts unknown and may become unknown again; else the
    value that stands in for unknown. Of a text the words have the bytes in UTF-8, two in each, and there are no limits;
    see codegen/model/code/letters.py. With ``elements`` it is a list of such numbers, each of which can be None; they
    are counted for each instance. ``derivation`` is where the value comes from, ``trust`` how long it is believed.
    """

    component: str
    name: str
    attribute: str
    kind: QuantityKind
    unit: Unit
    stored: Unit
    steps: Fraction
    storage: Storage
    minimum: int | Fraction
    maximum: int | Fraction
    initial: int | Fraction | str | None
    enum: EnumDefinition | None
    elements: tuple[int, ...] | None
    derivation: Derivation
    trust: Trust
    spec: QuantitySpec

    @property
    def path(self) -> str:
        """``battery.voltage``, as the tables write it."""
        return f"{self.component}.{self.name}"

    @property
    def called(self) -> str:
        """Return what texts of failsafes say of it."""
        return self.spec.called or self.name

    @property
    def length(self) -> int:
        """Return how many bytes of a text are kept; 0 of anything else."""
        return self.spec.text or 0 if self.kind is QuantityKind.TEXT else 0

    @property
    def kept_in(self) -> str:
        """The unit of what is kept, or what it is, for people."""
        return f"text of up to {self.length} bytes" if self.length else self.stored.name or self.kind.value

    @property
    def start(self) -> str:
        """Return what it is at the start, for people."""
        if self.initial is None:
            return "unknown"
        return f'"{on_one_line(self.initial)}"' if isinstance(self.initial, str) else str(self.initial)

    @property
    def words(self) -> int:
        """Return how many words of the state it takes, or each of its elements."""
        return words_of(self.length) if self.length else self.storage.words

    @property
    def is_row(self) -> bool:
        """Return whether it is a list of so many values as the table says, which
        fields of that length take as a whole.
        """
        return self.elements is not None and not isinstance(self.spec.elements, str)

    @property
    def element(self) -> "Quantity":
        """One value of the list, as if it were kept alone."""
        return replace(self, elements=None)

    @property
    def ages(self) -> bool:
        """Return whether it is forgotten once neither code nor a message has set it for a while.

        What readings give is forgotten with these.
        """
        counts = self.derivation.ages_alone or self.derivation.ages_with is not None
        return counts and self.trust.stale_after_ms is not None and not self.ages_by_readings

    @property
    def ages_by_readings(self) -> bool:
        """Return whether it is a list that the readings of its component forget:
        each of its values is set by itself.
        """
        return isinstance(self.spec.elements, str) and self.trust.stale_after_ms is not None

    @property
    def lost(self) -> str:
        """Return when its value is no longer believed, for people; nothing where that does not happen by itself."""
        return self.trust.words("it was set") if self.ages else self.trust.words()

    @property
    def decided_by(self) -> str:
        """The path of the quantity whose stored value decides: its own, or that of the one that it follows."""
        return f"{self.component}.{self.derivation.follows or self.name}"

    @property
    def is_computed(self) -> bool:
        """Return whether it follows another quantity each time that it is read, so that nothing sets it."""
        return self.derivation.follows is not None


@dataclass(frozen=True, slots=True)
class Returns:
    """``count`` goes up when ``gone`` was true at a good reading and is not at a later one; ``restarting`` begin anew.

    A sum begins with 0, if it is known, what has an initial value with that; anything else is unknown.
    """

    count: Quantity
    gone: Quantity
    restarting: tuple[Quantity, ...]


@dataclass(frozen=True, slots=True)
class Instance:
    """One instance of a component: its number from 0, the front of its parameters' names, and what is known of it."""

    number: int
    prefix: str
    facts: Mapping[str, str | Fraction]

    def count(self, fact: str) -> int | None:
        """Return how many there are of what a fact counts, such as cells or tanks;
        None where the fact is no such number.
        """
        number = self.facts.get(fact)
        return int(number) if isinstance(number, Fraction) and number.denominator == 1 and number > 0 else None


@dataclass(frozen=True, slots=True)
class Component(Cited):
    """A part of the vehicle state; ``period_ms`` is the time between two updates, or None.

    ``parts`` are its instances, one at least. ``first_number`` is the parameter with the number of the first one in
    messages, or None where that is 0. ``returns`` is what counts that it was exchanged, or None.
    """

    name: str
    parts: tuple[Instance, ...]
    first_number: Parameter | None
    period_ms: int | None
    quantities: Mapping[str, Quantity]
    returns: Returns | None
    spec: ComponentSpec

    @property
    def instances(self) -> int:
        """Return the number of instances of the component."""
        return len(self.parts)

    @property
    def read_every_ms(self) -> int:
        """Return the time between two readings: that between two updates, or 100 ms where none is stated."""
        return self.period_ms or 100

    @property
    def readings(self) -> tuple["Reading", ...]:
        """Return what an ADC measures of it, in the order of its quantities."""
        found: list[Reading] = []
        for quantity in self.quantities.values():
            if quantity.derivation.conversion is not None:
                found.append(Reading(self, quantity, quantity.derivation.conversion, is_first=not found))
        return tuple(found)

    @property
    def counted_on(self) -> tuple[Basis, ...]:
        """Return what sensors give of it that others are counted of, in the order of its quantities."""
        found = (Basis(self, quantity) for quantity in self.quantities.values() if quantity.derivation.gives)
        return tuple(basis for basis in found if basis.sums or basis.given)

    def extremes(self, listed: Quantity) -> tuple[Quantity, ...]:
        """Return what is the lowest or the highest value of a list."""
        return tuple(each for each in self.quantities.values() if each.derivation.extreme_of == listed.name)

    @property
    def enabled(self) -> Quantity | None:
        """The boolean that says whether the component is measured and reported; None where it always is."""
        return next((quantity for quantity in self.quantities.values() if quantity.derivation.switch), None)

    @property
    def switch(self) -> Parameter | None:
        """The parameter that switches the component on and off; None where it is always on."""
        return self.enabled.derivation.switch if self.enabled else None


@dataclass(frozen=True, slots=True)
class Reading(Basis):
    """A quantity of a component that an ADC measures. The first of a component is called as the component is."""

    conversion: "Conversion"
    is_first: bool

    @property
    def name(self) -> str:
        """``battery``, of a further one ``battery_current``: the middle of the names of what reads it."""
        return self.component.name if self.is_first else f"{self.component.name}_{self.quantity.name}"

    def word(self, word: str) -> str:
        """The name of a word that readings need: ``failures``, of a further one ``current_failures``."""
        return word if self.is_first else f"{self.quantity.name}_{word}"

    @property
    def trend(self) -> Quantity | None:
        """Return its change per second, where the component keeps that."""
        return next((each for each in self.given if each.derivation.kept_readings), None)

    @property
    def returns(self) -> Returns | None:
        """Return what counts that the component came back, where its readings show that."""
        returns = self.component.returns
        follows = returns.gone.derivation.follows if returns else None
        return returns if follows == self.quantity.name else None

    @property
    def is_plain(self) -> bool:
        """Return whether it is the first, always read, and its count times a parameter: one that a meter calibrates."""
        return self.is_first and not self.is_conditional and self.conversion.is_plain

    @property
    def expires(self) -> bool:
        """Return whether it can become too old."""
        return self.quantity.trust.stale_after_ms is not None

    @property
    def is_optional(self) -> bool:
        """Return whether the component is read without it, so that its code is loaded only where it is needed."""
        return self.is_conditional and not self.is_first

    @property
    def is_conditional(self) -> bool:
        """Return whether a parameter decides if it is read, beside the one that switches the component on."""
        return self.conversion.channel.when is not None


SLOWEST_ASKED = Fraction(1000000, 0x3FFFFFFF)
"""Hz of the longest interval that a ground station can ask for: what boards count without making an object."""


@dataclass(frozen=True, slots=True)
class Stream:
    """A stream with either a fixed ``rate`` in Hz or the ``parameter`` that sets it.

    ``data_stream`` is the number by which REQUEST_DATA_STREAM asks for it, or None; ``fastest`` the highest rate in Hz
    that a ground station can ask for, and that its parameter can set. Below ``SLOWEST_ASKED`` it is ``rate``.
    """

    name: str
    rate: Fraction | None
    parameter: Parameter | None
    data_stream: int | None
    fastest: Fraction
    spec: StreamSpec
    citation: Citation | None

    @property
    def default_rate(self) -> Fraction:
        """The rate in Hz that holds until a parameter or a ground station changes it; 0 is never."""
        if self.parameter is not None:
            return self.parameter.default * self.parameter.step
        return self.rate or Fraction(0)
