"""Facts about generations and announcements of messages for the generated checks."""

from codegen.frozen import dataclass
from codegen.model.price import Range, chosen, default_rate, frame_size, price
from codegen.model.spec.spec import Generation
from codegen.model.system import Generations, PopulatedMessage, System
from codegen.targets.firmware.messages.sending import number_at, shortest_us
from codegen.targets.naming import parameter_attribute


@dataclass(frozen=True, slots=True)
class GenerationFacts:
    """Generations: the parameter that chooses, the ids of each list, and bytes per second of old, new and both."""

    parameter: str
    attribute: str
    default: int
    old: tuple[int, ...]
    new: tuple[int, ...]
    prices: tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class MessageFacts:
    """A message: whom it is about, its default rate in Hz, the bytes of its frames by instance, and what announces it.

    ``watched`` is the component and the attribute whose change sends it.
    """

    id: int
    component: str | None
    enabled: str | None
    instances: int
    pages: int
    rate: float
    shortest_us: int
    frames: tuple[tuple[int, int], ...]
    on_connection: bool
    watched: tuple[str, str] | None
    number_at: int | None


def generation_facts(system: System) -> tuple[GenerationFacts, ...]:
    """The generations in the order of streams.yaml."""
    return tuple(_generations(generations, system) for generations in system.generations)


def _generations(generations: Generations, system: System) -> GenerationFacts:
    parameter = generations.parameter
    old, new = (
        tuple(message.wire.id for message in chosen(generations, choice, system))
        for choice in (Generation.OLD, Generation.NEW)
    )
    return GenerationFacts(
        parameter=parameter.name if parameter else "",
        attribute=parameter_attribute(parameter.name) if parameter else "",
        default=tuple(Generation).index(generations.default),
        old=old,
        new=new,
        prices=tuple(_floats(price(generations, choice, system)) for choice in Generation),
    )


def _floats(found: Range) -> tuple[float, float]:
    return float(found.low), float(found.high)


def message_facts(system: System) -> tuple[MessageFacts, ...]:
    """The messages in the order of their ids; not those of several tables, whose frames do not tell which it was."""
    alone = (message for message in system.messages if len(system.tables(message.wire.name)) == 1)
    return tuple(_message(message, system) for message in alone)


def shared_facts(system: System) -> dict[int, tuple[MessageFacts, ...]]:
    """The tables of each message that has several, by its id."""
    tables = {message.wire.id: system.tables(message.wire.name) for message in system.messages}
    return {
        number: tuple(_message(table, system) for table in each) for number, each in tables.items() if len(each) > 1
    }


def _message(message: PopulatedMessage, system: System) -> MessageFacts:
    component, watched = message.component, message.on_change
    sizes = [frame_size(message, instance, system.spec.project.protocol) for instance in range(message.instances)]
    return MessageFacts(
        id=message.wire.id,
        component=component.name if component else None,
        enabled=component.enabled.name if component and component.enabled else None,
        instances=message.instances,
        pages=message.pages,
        rate=float(default_rate(message)),
        shortest_us=shortest_us(message, system),
        frames=tuple((int(size.low), int(size.high)) for size in sizes),
        on_connection=message.on_connection,
        watched=(watched.component, watched.attribute) if watched else None,
        number_at=number_at(message),
    )
