"""Facts from which steps are drawn by lot that machine code and plain Python take alike: counterparts_run.py."""

from collections.abc import Iterator, Sequence

from codegen.frozen import dataclass
from codegen.model.system import PopulatedMessage, System
from codegen.targets.firmware.program.parameters import ParameterView, parameter_views
from codegen.targets.firmware.readings.board import plain_readers
from codegen.targets.naming import message_about
from codegen.targets.suite.facts.components import ComponentFacts, QuantityFacts
from codegen.targets.suite.facts.readings import ReadingFacts


@dataclass(frozen=True, slots=True)
class DrawnReading:
    """A reading of a component: its input in the mock, the largest count, and how many instances are read."""

    name: str
    component: str
    input: str
    full_scale: int
    instances: int


@dataclass(frozen=True, slots=True)
class DrawnQuantity:
    """A quantity that code sets, of so many ``elements`` or 0: literals of values, those beyond its limits at last."""

    component: str
    instances: int
    attribute: str
    elements: int
    values: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class DrawnTable:
    """A message, and by literal what its functions can be told about: the instance, the page, both or nothing."""

    name: str
    abouts: str


@dataclass(frozen=True, slots=True)
class CounterpartsView:
    """The data for counterparts_facts.py; ``ages_ms`` are the times after which something is forgotten.

    ``on`` are parameters, each with the steps with which readings are taken.
    """

    system_id: int
    component_id: int
    ages_ms: tuple[int, ...]
    readings: tuple[DrawnReading, ...]
    on: tuple[tuple[str, int], ...]
    parameters: tuple[ParameterView, ...]
    quantities: tuple[DrawnQuantity, ...]
    tables: tuple[DrawnTable, ...]


def counterparts_view(
    system: System, components: Sequence[ComponentFacts], readings: Sequence[ReadingFacts]
) -> CounterpartsView:
    """Return what is drawn from in the suite of a system."""
    ages = {
        quantity.trust.stale_after_ms
        for component in system.components.values()
        for quantity in component.quantities.values()
    }
    return CounterpartsView(
        system_id=system.system_id,
        component_id=system.component_id,
        ages_ms=tuple(sorted(age for age in ages if age is not None)) or (1000,),
        readings=tuple(_readings(system, components, readings)),
        on=tuple({name: steps for each in readings for name, steps in each.on.items()}.items()),
        parameters=parameter_views(system),
        quantities=tuple(
            _quantity(each, one, system) for each in components for one in each.quantities if one.is_stored
        ),
        tables=tuple(DrawnTable(message.name.lower(), repr(_abouts(message))) for message in system.messages),
    )


def _readings(
    system: System, components: Sequence[ComponentFacts], readings: Sequence[ReadingFacts]
) -> Iterator[DrawnReading]:
    measured = [component for component in components if component.measured]
    for reader, component in zip(plain_readers(system), measured, strict=True):
        instances = component.instances if reader.several else 1
        yield DrawnReading(reader.component, component.name, reader.input, reader.full_scale, instances)
    for each in readings:
        yield DrawnReading(each.own.name, each.own.component, each.own.input, each.full_scale, each.instances)


def _quantity(component: ComponentFacts, quantity: QuantityFacts, system: System) -> DrawnQuantity:
    """Return a quantity of all instances, or of the first one where lists have another length in each."""
    lengths = set(system.components[component.name].quantities[quantity.name].elements or ())
    instances = component.instances if len(lengths) < 2 else 1
    unknown = f"[None] * {quantity.elements}" if quantity.elements else "None"
    tried = () if quantity.elements else quantity.tried[1:] if quantity.is_object else ()
    limits = (quantity.within, *quantity.beyond) if quantity.beyond else ()
    values = (unknown, *quantity.samples, *tried, *limits)
    return DrawnQuantity(component.name, instances, quantity.attribute, quantity.elements or 0, values)


def _abouts(message: PopulatedMessage) -> tuple[tuple[int, ...], ...]:
    """Return what can be told of a message: instances, and pages of each."""
    told: tuple[tuple[int, ...], ...] = ((),)
    for kind in message_about(message):
        count = message.pages if kind == "page" else message.component.instances if message.component else 1
        told = tuple((*each, number) for each in told for number in range(count))
    return told
