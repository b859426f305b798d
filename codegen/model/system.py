"""The resolved system: every populated field bound to its source, every name looked up, every factor exact.

Rules, targets, ``explain`` and the documents read this model; none of them looks at files again.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import Enum
from fractions import Fraction

from codegen.model.dialect import Dialect, WireField, WireMessage
from codegen.model.population_spec import FieldAnswer, PopulationSpec, Rounding
from codegen.model.program import BoardLink, Program
from codegen.model.receiver import Receiver
from codegen.model.spec import Generation, GenerationsSpec, Requirement, Spec
from codegen.model.vehicle import SMALL_INT_MAX, AdcChannel, Citation, Component, Parameter, Quantity, Stream

FLOAT_DIVISOR_MAX = 2**25
"""Largest divisor of a value that goes out as a float by integer arithmetic: the firmware's ``put_float``."""


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
        return self.field.label(self.first, self.count)


@dataclass(frozen=True, slots=True)
class FixedBinding:
    """Values known at build time, one per element (a char array has one ``str``), with the words for reviewers."""

    covers: Elements
    values: tuple[int | float | str, ...]
    meaning: str
    is_unknown: bool = False


@dataclass(frozen=True, slots=True)
class PartBinding:
    """A fact that differs between the instances of the component: the binding of each, by number."""

    covers: Elements
    values: tuple[FixedBinding, ...]


@dataclass(frozen=True, slots=True)
class InstanceBinding:
    """The index of the component's instance, from 0, or from the number that the parameter ``first`` has at start."""

    covers: Elements
    component: str
    first: Parameter | None = None


@dataclass(frozen=True, slots=True)
class TextBinding:
    """A text that the running board knows, cut to the field. ``source``: unique_id, the chip's number in hex."""

    covers: Elements
    source: str


@dataclass(frozen=True, slots=True)
class PageBinding:
    """The number of the first value on a page of ``size`` values."""

    covers: Elements
    size: int


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

    @property
    def steps(self) -> tuple[int, int]:
        """The smallest and the largest stored value that goes out as it is."""
        return math.ceil(self.low / self.factor), math.floor(self.high / self.factor)

    @property
    def makes_float(self) -> bool:
        """Whether a builder has to make a float of the value, for which MicroPython allocates.

        A float of 32 bits comes of integer arithmetic while value times numerator, and the shifted rest of the division
        by the denominator, fit a board's small integers.
        """
        wire_type, factor = self.covers.field.type, self.factor
        if wire_type.is_integer:
            return False
        largest = max(map(abs, self.steps)) * factor.numerator
        return wire_type.size != 4 or largest > SMALL_INT_MAX or factor.denominator > FLOAT_DIVISOR_MAX


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


@dataclass(frozen=True, slots=True)
class EachBinding:
    """One value of a quantity with elements for each covered element, from the value ``first`` on.

    On pages (``is_paged``) ``first`` counts from the begin of the page. The conversion is that of ``LiveBinding``;
    what is unknown, and what lies beyond the last value, becomes ``unknown``, the sentinel of every element. With a
    ``room`` the values go out together or not at all: only while all of them are known and no more than the ``room``
    that the message has; otherwise ``fallback`` goes out, or ``unknown`` in every element.
    Source: the dialect's text for BATTERY_STATUS.voltages.
    """

    covers: Elements
    source: Quantity
    first: int
    factor: Fraction
    rounding: Rounding
    low: Fraction
    high: Fraction
    unknown: int
    hole: Fraction | None = None
    beside: Fraction | None = None
    is_paged: bool = False
    fallback: SplitBinding | None = None
    room: int | None = None


Binding = (
    FixedBinding
    | PartBinding
    | TextBinding
    | InstanceBinding
    | PageBinding
    | FlagsBinding
    | LiveBinding
    | SplitBinding
    | EachBinding
)


class Policy(Enum):
    """How one of several instances is chosen for a message that there is once."""

    FIRST = "first"
    PARAMETER = "parameter"
    LOWEST = "lowest"


@dataclass(frozen=True, slots=True)
class Representation:
    """Which instance of ``component`` a single message reports.

    ``FIRST``: the first one. ``PARAMETER``: the one whose number, from 1, the ``parameter`` has, if it is enabled.
    ``LOWEST``: of the enabled ones the one whose ``quantity`` is lowest, if it is known of one. Otherwise the first
    enabled one, or the first.
    """

    component: Component
    policy: Policy
    parameter: Parameter | None = None
    quantity: Quantity | None = None


def read_quantities(binding: Binding) -> tuple[Quantity, ...]:
    """The quantities of the state that a builder reads for a binding."""
    if isinstance(binding, FlagsBinding):
        return tuple(quantity for _, _, quantity in binding.conditional)
    if isinstance(binding, EachBinding):
        return (binding.source, *(read_quantities(binding.fallback) if binding.fallback else ()))
    if isinstance(binding, LiveBinding | SplitBinding) and isinstance(binding.source, Quantity):
        return (binding.source,)
    return ()


@dataclass(frozen=True, slots=True)
class PopulatedMessage:
    """A message with a binding for every element; ``bindings`` are in the order of their offsets.

    ``component`` is the component that each instance of the message belongs to, or None for a single message.
    Without a ``stream`` it is sent when a ground station asks for it. With ``on_connection`` it is announced, which is
    to be sent at once, to who appears on a link; a change of the quantity ``on_change`` announces it, too.
    ``pages`` is how many messages the values of the instance with most of them take. ``represents`` tells by component
    which instance a single message is about.
    """

    wire: WireMessage
    bindings: tuple[Binding, ...]
    stream: Stream | None
    component: Component | None
    citation: Citation
    population: PopulationSpec
    represents: Mapping[str, Representation]
    on_connection: bool = False
    on_change: Quantity | None = None
    pages: int = 1

    @property
    def name(self) -> str:
        """The name in the dialect."""
        return self.wire.name

    @property
    def is_announced(self) -> bool:
        """Whether something other than time and requests sends it."""
        return self.on_connection or self.on_change is not None

    @property
    def instances(self) -> int:
        """How many of the message exist."""
        return self.component.instances if self.component else 1

    @property
    def made_floats(self) -> tuple[LiveBinding, ...]:
        """The bindings that make a float at each build, which allocates on MicroPython."""
        return tuple(binding for binding in self.bindings if isinstance(binding, LiveBinding) and binding.makes_float)


@dataclass(frozen=True, slots=True)
class Generations:
    """Two generations of messages about ``component``: ``parameter`` chooses at run time, or ``send`` has chosen.

    ``old`` and ``new`` are names of messages. The parameter is 0 for the old ones, 1 for the new ones, 2 for both.
    """

    component: Component
    old: tuple[str, ...]
    new: tuple[str, ...]
    parameter: Parameter | None
    send: Generation | None
    spec: GenerationsSpec
    citation: Citation | None

    @property
    def default(self) -> Generation:
        """What is sent until somebody chooses otherwise."""
        if self.parameter is None:
            return self.send or Generation.BOTH
        return tuple(Generation)[self.parameter.default]

    def names(self, choice: Generation) -> tuple[str, ...]:
        """The messages that are sent with a choice."""
        return {Generation.OLD: self.old, Generation.NEW: self.new, Generation.BOTH: self.old + self.new}[choice]


@dataclass(frozen=True, slots=True)
class System:
    """Everything that is generated from, resolved. ``messages`` are in the order of their ids.

    ``requirements`` has every document under its id and under each of its aliases. ``system_parameter`` sets the
    system id where the project says so; ``system_id`` is then its default. So it is with ``component_parameter``.
    """

    spec: Spec
    dialect: Dialect
    system_id: int
    system_parameter: Parameter | None
    component_id: int
    component_parameter: Parameter | None
    channels: Mapping[str, AdcChannel]
    parameters: Mapping[str, Parameter]
    components: Mapping[str, Component]
    streams: Mapping[str, Stream]
    messages: tuple[PopulatedMessage, ...]
    links: tuple[BoardLink, ...]
    program: Program | None
    requirements: Mapping[str, Requirement]
    generations: tuple[Generations, ...] = ()
    receiver: Receiver | None = None

    @property
    def wires(self) -> tuple[WireMessage, ...]:
        """The messages that the firmware knows, in the order of their ids: populated ones and those of the services."""
        services = self.program.services if self.program else ()
        known = {wire.id: wire for wire in (*services, *(message.wire for message in self.messages))}
        return tuple(known[number] for number in sorted(known))

    @property
    def sent(self) -> tuple[WireMessage, ...]:
        """The messages that the firmware sends whole, in the order of their ids."""
        services = self.program.sent if self.program else ()
        names = {*services, *(message.name for message in self.messages)}
        return tuple(wire for wire in self.wires if wire.name in names)

    def quantity(self, path: str) -> Quantity | None:
        """The quantity written as ``component.name``, or None."""
        component, _, name = path.partition(".")
        return self.components[component].quantities.get(name) if component in self.components else None

    def gpios(self, component: Component, channel: AdcChannel) -> tuple[int, ...]:
        """The GPIO number by instance of a component, at first: pins may be parameters."""
        names = channel.pin.siblings if channel.pin else ()
        pins = [self.parameters[name].default for name in names if name in self.parameters]
        return tuple(pins) or (channel.gpio,) * component.instances

    def measured(self) -> tuple[tuple[str, Quantity], ...]:
        """Each component that an ADC measures, with the quantity that it measures."""
        return tuple(
            (component.name, quantity)
            for component in self.components.values()
            for quantity in component.quantities.values()
            if quantity.conversion is not None
        )
