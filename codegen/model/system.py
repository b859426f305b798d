"""The resolved system: every populated field bound to its source, every name looked up, every factor exact.

Rules, targets, ``explain`` and the documents read this model; none of them looks at files again.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction

from codegen.model.dialect import Dialect, EnumDefinition, WireField, WireMessage
from codegen.model.spec import (
    AdcSpec,
    ComponentSpec,
    Criterion,
    FieldAnswer,
    ParameterSpec,
    PopulationSpec,
    QuantitySpec,
    Requirement,
    Rounding,
    Spec,
    StreamSpec,
)
from codegen.model.unit import Unit

SMALL_INT_MAX = 2**30 - 1
"""Largest integer that MicroPython keeps without allocating on 32-bit ports: they have 31 bits, with the sign."""


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


@dataclass(frozen=True, slots=True)
class AdcChannel(Cited):
    """An ADC channel: ``full_scale`` is the largest count, ``reference`` the volts that it stands for.

    ``read_limit_us`` is the longest time for one mean in microseconds, or None.
    """

    name: str
    gpio: int
    bits: int
    full_scale: int
    reference: Fraction
    samples: int
    read_limit_us: int | None
    spec: AdcSpec


@dataclass(frozen=True, slots=True)
class Parameter:
    """A parameter; the firmware keeps ``default``, ``minimum`` and ``maximum`` as whole ``steps``.

    ``step`` is the value of one step in ``unit``.
    """

    name: str
    unit: Unit
    step: Fraction
    default: int
    minimum: int
    maximum: int
    spec: ParameterSpec
    citation: Citation | None

    @property
    def path(self) -> str:
        """How tables and documents write it, as ``Quantity.path``: its name."""
        return self.name


class QuantityKind(Enum):
    """What a quantity of the vehicle state holds."""

    NUMBER = "number"
    ENUM = "enum"
    BOOLEAN = "boolean"


@dataclass(frozen=True, slots=True)
class Conversion:
    """From an ADC count to stored steps: ``count * multiplier_steps * numerator / denominator``, rounded to nearest.

    ``denominator`` and ``numerator`` have no common factor. Source: the formula of FR-00069.
    """

    channel: AdcChannel
    multiplier: Parameter
    numerator: int
    denominator: int


@dataclass(frozen=True, slots=True)
class Quantity(Cited):
    """A quantity of the vehicle state, kept as an integer of ``stored`` units.

    ``steps`` stored units make one ``unit`` (1000 for V kept in mV). ``minimum`` and ``maximum`` are in stored
    units; without a limit in the table they are what a small integer holds. ``initial`` is None where the quantity
    starts unknown and may become unknown again; else the value that stands in for unknown. ``while_known`` names
    the quantity of the same component that a boolean follows: it cannot be set then.
    """

    component: str
    name: str
    attribute: str
    kind: QuantityKind
    unit: Unit
    stored: Unit
    steps: Fraction
    minimum: int
    maximum: int
    initial: int | None
    while_known: str | None
    enum: EnumDefinition | None
    conversion: Conversion | None
    warn_above: int | None
    stale_after_ms: int | None
    spec: QuantitySpec

    @property
    def path(self) -> str:
        """``battery.voltage``, as the tables write it."""
        return f"{self.component}.{self.name}"


@dataclass(frozen=True, slots=True)
class Component(Cited):
    """A part of the vehicle state; ``period_ms`` is the time between two updates, or None."""

    name: str
    instances: int
    period_ms: int | None
    quantities: Mapping[str, Quantity]
    spec: ComponentSpec


@dataclass(frozen=True, slots=True)
class Stream:
    """A stream with either a fixed ``rate`` in Hz or the ``parameter`` that sets it."""

    name: str
    rate: Fraction | None
    parameter: Parameter | None
    spec: StreamSpec
    citation: Citation | None


@dataclass(frozen=True, slots=True)
class Elements:
    """The elements ``first`` to ``first + count - 1`` of a field, and the answer of the table for them."""

    field: WireField
    first: int
    count: int
    answer: FieldAnswer
    citation: Citation

    @property
    def offset(self) -> int:
        """Byte offset of the first element in the payload."""
        return self.field.offset + self.first * self.field.type.size

    @property
    def label(self) -> str:
        """``voltages``, ``voltages[0]`` or ``voltages[1..9]``."""
        if not self.field.is_array or self.count == self.field.count:
            return self.field.name
        last = self.first + self.count - 1
        return f"{self.field.name}[{self.first}]" if last == self.first else f"{self.field.name}[{self.first}..{last}]"


@dataclass(frozen=True, slots=True)
class FixedBinding:
    """Values known at build time, one per element (a char array has one ``str``), with the words for reviewers."""

    covers: Elements
    values: tuple[int | float | str, ...]
    meaning: str
    is_unknown: bool = False


@dataclass(frozen=True, slots=True)
class InstanceBinding:
    """The index of the component's instance, from 0."""

    covers: Elements
    component: str


@dataclass(frozen=True, slots=True)
class FlagsBinding:
    """Bits of a bitmask: ``mask`` is always set, each of ``conditional`` only while its quantity is true."""

    covers: Elements
    mask: int
    names: tuple[str, ...]
    conditional: tuple[tuple[str, int, Quantity], ...]


@dataclass(frozen=True, slots=True)
class LiveBinding:
    """A value that is read when the message is built: a quantity of the state, or a parameter.

    wire = ``source * factor``, rounded, limited to ``low``..``high`` (wire units, sentinel excluded), and where it
    still equals ``hole``, the sentinel within these limits, moved to ``beside``. Unknown becomes ``unknown``.
    For integer fields ``low`` and ``high`` are whole numbers.
    """

    covers: Elements
    source: Quantity | Parameter
    factor: Fraction
    rounding: Rounding
    low: Fraction
    high: Fraction
    unknown: int | float | None
    hole: Fraction | None = None
    beside: Fraction | None = None


@dataclass(frozen=True, slots=True)
class SplitBinding:
    """A quantity spread over elements: each holds up to ``cell_high``, the rest spills into the next.

    ``unused`` is the sentinel of elements that are not reached, ``low`` the smallest value that is sent.
    Source: the dialect's text for BATTERY_STATUS.voltages.
    """

    covers: Elements
    source: Quantity
    factor: Fraction
    rounding: Rounding
    low: int
    high: int
    cell_high: int
    unused: int


Binding = FixedBinding | InstanceBinding | FlagsBinding | LiveBinding | SplitBinding


def read_quantities(binding: Binding) -> tuple[Quantity, ...]:
    """The quantities of the state that a builder reads for a binding."""
    if isinstance(binding, FlagsBinding):
        return tuple(quantity for _, _, quantity in binding.conditional)
    if isinstance(binding, LiveBinding | SplitBinding) and isinstance(binding.source, Quantity):
        return (binding.source,)
    return ()


@dataclass(frozen=True, slots=True)
class PopulatedMessage:
    """A message with a binding for every element; ``bindings`` are in the order of their offsets.

    ``component`` is the component that each instance of the message belongs to, or None for a single message.
    """

    wire: WireMessage
    bindings: tuple[Binding, ...]
    stream: Stream
    component: Component | None
    citation: Citation
    population: PopulationSpec

    @property
    def name(self) -> str:
        """The name in the dialect."""
        return self.wire.name

    @property
    def instances(self) -> int:
        """How many of the message exist."""
        return self.component.instances if self.component else 1

    @property
    def live_floats(self) -> tuple[LiveBinding, ...]:
        """The bindings that write a float at each build, which allocates on MicroPython."""
        return tuple(
            binding
            for binding in self.bindings
            if isinstance(binding, LiveBinding) and not binding.covers.field.type.is_integer
        )


@dataclass(frozen=True, slots=True)
class System:
    """Everything that is generated from, resolved. ``messages`` are in the order of their ids.

    ``requirements`` has every document under its id and under each of its aliases.
    """

    spec: Spec
    dialect: Dialect
    system_id: int
    component_id: int
    channels: Mapping[str, AdcChannel]
    parameters: Mapping[str, Parameter]
    components: Mapping[str, Component]
    streams: Mapping[str, Stream]
    messages: tuple[PopulatedMessage, ...]
    requirements: Mapping[str, Requirement]

    def quantity(self, path: str) -> Quantity | None:
        """The quantity written as ``component.name``, or None."""
        component, _, name = path.partition(".")
        return self.components[component].quantities.get(name) if component in self.components else None

    def measured(self) -> tuple[tuple[str, Quantity], ...]:
        """Each component that an ADC measures, with the quantity that it measures."""
        return tuple(
            (component.name, quantity)
            for component in self.components.values()
            for quantity in component.quantities.values()
            if quantity.conversion is not None
        )
