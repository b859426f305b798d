"""The resolved system: every populated field bound to its source, every name looked up, every factor exact.

Rules, targets, ``explain`` and the documents read this model; none of them looks at files again.
"""

from collections.abc import Mapping
from dataclasses import field
from enum import Enum

from codegen.frozen import dataclass
from codegen.model.answers.answer import Answer
from codegen.model.board_model import BoardModel
from codegen.model.dialect.dialect import Dialect, WireMessage
from codegen.model.program import BoardLink, Program
from codegen.model.quantities.conversion import Conversion
from codegen.model.quantities.source_kind import Source
from codegen.model.receiver import Receiver
from codegen.model.reception import Reception
from codegen.model.spec.population import PopulationSpec
from codegen.model.spec.spec import (
    Generation,
    GenerationsSpec,
    ParameterEncoding,
    ParameterType,
    Requirement,
    Spec,
)
from codegen.model.vehicle import AdcChannel, Citation, Component, Parameter, Quantity, Reading, Stream


class Policy(Enum):
    """The policy that chooses one of several instances for a message that is sent only once."""

    FIRST = "first"
    PARAMETER = "parameter"
    LOWEST = "lowest"


@dataclass(frozen=True, slots=True)
class Representation:
    """The choice of the instance of ``component`` that a single message reports.

    ``FIRST``: the first one. ``PARAMETER``: the one whose number, from 1, the ``parameter`` has, if it is enabled.
    ``LOWEST``: of the enabled ones the one whose ``quantity`` is lowest, if it is known of one. Otherwise the first
    enabled one, or the first.
    """

    component: Component
    policy: Policy
    parameter: Parameter | None = None
    quantity: Quantity | None = None


@dataclass(frozen=True, slots=True)
class PopulatedMessage:
    """A table: a message with an answer for every element; ``answers`` are in the order of their offsets.

    ``component`` is the component that each instance of the message belongs to, or None for a single message.
    Without a ``stream`` it is sent when a ground station asks for it. With ``on_connection`` it is announced, which is
    to be sent at once, to who appears on a link; a change of the quantity ``on_change`` announces it, too.
    ``pages`` is how many messages the values of the instance with most of them take. ``represents`` tells by component
    which instance a single message is about.
    """

    wire: WireMessage
    answers: tuple[Answer, ...]
    stream: Stream | None
    component: Component | None
    citation: Citation
    population: PopulationSpec
    represents: Mapping[str, Representation]
    aspects: Mapping[str, Citation]
    on_connection: bool = False
    on_change: Quantity | None = None
    pages: int = 1

    def tells_of(self, component: str) -> bool:
        """Return whether it is known which instance of a component its numbers are of: the one that it is sent for, the
        first, or the only one; what is chosen while the program runs does not stand in the message.
        """
        choice = self.represents.get(component)
        if choice is not None:
            return choice.policy is Policy.FIRST or choice.component.instances == 1
        return self.component is None or self.component.name == component

    @property
    def name(self) -> str:
        """Return what its table is called: the name in the dialect, unless the table has one of its own."""
        return self.population.name

    @property
    def title(self) -> str:
        """``GPS_RAW_INT (24)``, or with a name of the table's own ``position: GPS_RAW_INT (24)``."""
        message = f"{self.wire.name} ({self.wire.id})"
        return message if self.name == self.wire.name else f"{self.name}: {message}"

    @property
    def is_announced(self) -> bool:
        """Return whether something other than time and requests sends it."""
        return self.on_connection or self.on_change is not None

    @property
    def instances(self) -> int:
        """Return how many of the message exist."""
        return self.component.instances if self.component else 1

    @property
    def withheld_for(self) -> tuple[tuple[str, Quantity], ...]:
        """The fields and quantities for which the message is withheld: while one of these is unknown."""
        return tuple((answer.covers.label, quantity) for answer in self.answers for quantity in answer.withheld_for)


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
    aspects: Mapping[str, Citation]

    @property
    def default(self) -> Generation:
        """Return what is sent until somebody chooses otherwise."""
        if self.parameter is None:
            return self.send or Generation.BOTH
        return tuple(Generation)[self.parameter.default]

    def names(self, choice: Generation) -> tuple[str, ...]:
        """The messages that are sent with a choice."""
        return {Generation.OLD: self.old, Generation.NEW: self.new, Generation.BOTH: self.old + self.new}[choice]


@dataclass(frozen=True, slots=True)
class System:
    """Everything that is generated from, resolved. ``messages`` are in the order of their ids and names.
    ``board`` is what is known about the board, where it is named.

    ``requirements`` has every document under its id and under each of its aliases. ``system_parameter`` sets the
    system id where the project says so; ``system_id`` is then its default. So it is with ``component_parameter``.
    ``receptions`` are the messages that set quantities, in the same order as ``messages``.
    """

    spec: Spec
    dialect: Dialect
    system_id: int
    system_parameter: Parameter | None
    component_id: int
    component_parameter: Parameter | None
    board: BoardModel | None
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
    sources: Mapping[str, Source] = field(default_factory=dict)
    receptions: tuple[Reception, ...] = ()

    @property
    def wires(self) -> tuple[WireMessage, ...]:
        """The messages that the firmware knows, in the order of their ids: of the tables, and those of the services."""
        services = self.program.services if self.program else ()
        received = (reception.wire for reception in self.receptions)
        known = {wire.id: wire for wire in (*services, *received, *(message.wire for message in self.messages))}
        return tuple(known[number] for number in sorted(known))

    @property
    def sent(self) -> tuple[WireMessage, ...]:
        """The messages that the firmware sends whole, in the order of their ids."""
        services = self.program.sent if self.program else ()
        names = {*services, *(message.wire.name for message in self.messages)}
        return tuple(wire for wire in self.wires if wire.name in names)

    @property
    def signs(self) -> bool:
        """Return whether any link is signed."""
        return self.program is not None and self.program.access is not None and bool(self.program.access.signed)

    @property
    def has_whole_parameters(self) -> bool:
        """Return whether a parameter has another type than real32: all encodings have those alike."""
        return any(parameter.spec.type is not ParameterType.REAL32 for parameter in self.parameters.values())

    @property
    def is_bytewise(self) -> bool:
        """Return whether the program sends and takes parameters as the bytes of their types."""
        encoding = self.program.encoding if self.program else ParameterEncoding.C_CAST
        return encoding is ParameterEncoding.BYTEWISE and self.has_whole_parameters

    def has_document(self, path: str) -> bool:
        """Return whether the document with an absolute path is one of the requirements in its specification."""
        return any(requirement.place.file == path for requirement in self.spec.requirements)

    def tables(self, message: str) -> tuple[PopulatedMessage, ...]:
        """The tables of a message of the dialect, by its name."""
        return tuple(table for table in self.messages if table.wire.name == message)

    @property
    def polled(self) -> tuple[Source, ...]:
        """The sensors that have a slot of the main loop."""
        return tuple(source for source in self.sources.values() if source.is_polled)

    @property
    def board_name(self) -> str:
        """``Raspberry Pi Pico 2 W (RP2350)``, or that any board will do."""
        return f"{self.board.name} ({self.board.spec.mcu})" if self.board else "any board"

    def quantity(self, path: str) -> Quantity | None:
        """The quantity written as ``component.name``, or None."""
        component, _, name = path.partition(".")
        return self.components[component].quantities.get(name) if component in self.components else None

    def gpios(self, component: Component, channel: AdcChannel) -> tuple[int, ...]:
        """The GPIO number by instance of a component, at first: pins may be parameters."""
        names = channel.pin.siblings if channel.pin else ()
        pins = [self.parameters[name].default for name in names if name in self.parameters]
        return tuple(pins) or (channel.gpio,) * component.instances

    def readings(self) -> tuple[Reading, ...]:
        """Return what an ADC measures, in the order of the components and their quantities."""
        return tuple(reading for component in self.components.values() for reading in component.readings)

    def measured(self) -> tuple[tuple[str, Quantity, Conversion], ...]:
        """Each quantity that an ADC measures, with its component and how."""
        return tuple((each.component.name, each.quantity, each.conversion) for each in self.readings())
