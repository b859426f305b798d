"""Resolves generations and announcements, which decide beside the stream whether and when a message goes out."""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.spec.population import PopulationSpec
from codegen.model.spec.spec import Generation, GenerationsSpec, Requirement, Spec
from codegen.model.system import Generations, PopulatedMessage
from codegen.model.vehicle import Component, Parameter, Quantity, QuantityKind
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.families import is_single
from codegen.resolve.quantities.component import find_component
from codegen.resolve.quantities.state import find_quantity
from codegen.resolve.vehicle import find_parameter
from codegen.source import Place

BAD_GENERATIONS = Rule(
    "bad-generations",
    "Generations of messages contradict themselves: each lists messages that have tables, a message is in one list of "
    "one entry only and about the component of the entry, and the parameter that chooses has the values 0 for old, 1 "
    "for new and 2 for both, is whole and acts at once.",
    remedy="list messages that have tables, each in one generation of its component",
)
BAD_ANNOUNCEMENT = Rule(
    "bad-announcement",
    "A message cannot be sent on connection, or on a change: only the program of vehicle.yaml hears ground stations "
    "and watches the state, and what is watched is a quantity of the message's own component, or of one that exists "
    "once, and no text.",
)
CHOICES = tuple(Generation)
"""The choices of the parameter's values 0, 1 and 2."""


def resolve_generations(
    spec: Spec,
    messages: Iterable[PopulatedMessage],
    components: Mapping[str, Component],
    parameters: Mapping[str, Parameter],
    index: Mapping[str, Requirement],
    report: Report,
) -> tuple[Generations, ...]:
    """The generations of streams.yaml; what is wrong with one is reported and leaves it out."""
    resolved = {message.name: message for message in messages}
    tables = {population.name for population in spec.populations}
    taken: dict[str, Place] = {}
    found = []
    for name, written in spec.streams.generations.items():
        citation = cite_optional(written.requirement, written.at("requirement"), index, report)
        aspects = cite_aspects(written, index, report)
        component = find_component(name, components, spec.state, BAD_GENERATIONS, written.place, report)
        problems = [
            *_list_problems(written, tables, taken),
            *_table_problems(written, spec.populations),
            *_owner_problems(name, written, resolved),
        ]
        for place, message, hint, related in problems:
            report.add(BAD_GENERATIONS, place, message, hint, related)
        parameter = None
        if written.parameter is not None:
            place = written.at("parameter")
            parameter = find_parameter(written.parameter, place, spec.parameters, parameters, report)
            if parameter is not None and not _chooses(parameter, place, report):
                parameter = None
        if component is not None and (parameter is not None or written.send is not None):
            found.append(
                Generations(component, written.old, written.new, parameter, written.send, written, citation, aspects)
            )
    return tuple(found)


_Problem = tuple[Place, str, str | None, list[tuple[Place, str]]]


def _list_problems(spec: GenerationsSpec, tables: set[str], taken: dict[str, Place]) -> Iterator[_Problem]:
    """Yield what is wrong with the names; ``taken`` has the places of those that were listed before, and gets these."""
    for key in ("old", "new"):
        names: tuple[str, ...] = getattr(spec, key)
        if not names:
            yield spec.at(key), f"the {key} generation has no message", "list one, or remove the generations", []
        for number, name in enumerate(names):
            place = spec.at(f"{key}[{number}]")
            if name not in tables:
                hint = did_you_mean(name, tables) or "write its table in messages/, or take it out"
                yield place, f"{name} has no population table", hint, []
            if name in taken:
                yield (
                    place,
                    f"{name} belongs to a generation already",
                    "keep it in one list",
                    [(taken[name], "it is listed here")],
                )
            taken.setdefault(name, place)


def _table_problems(spec: GenerationsSpec, tables: Sequence[PopulationSpec]) -> Iterator[_Problem]:
    """A message with several tables is in no generation: who receives it could not tell what belongs to which."""
    for key in ("old", "new"):
        for number, name in enumerate(getattr(spec, key)):
            table = next((table for table in tables if table.name == name), None)
            if table is None:
                continue
            other = next((each for each in tables if each.message == table.message and each is not table), None)
            if other is not None:
                related = [(other.at("message"), "another table of the message")]
                message = f"{name} is one of several tables of {table.message}, which receivers cannot tell apart"
                yield spec.at(f"{key}[{number}]"), message, "take it out, or leave one table of the message", related


def _owner_problems(name: str, spec: GenerationsSpec, messages: Mapping[str, PopulatedMessage]) -> Iterator[_Problem]:
    for key in ("old", "new"):
        for number, listed in enumerate(getattr(spec, key)):
            if listed not in messages:
                continue
            owner = messages[listed].component
            read = {quantity.component for answer in messages[listed].answers for quantity in answer.quantities}
            if owner is None and read and name not in read:
                yield (
                    spec.at(f"{key}[{number}]"),
                    f"{listed} says nothing about a {name}",
                    f"take it out, or answer a field with a quantity of {name}",
                    [],
                )
            if owner is not None and owner.name != name:
                place = messages[listed].population.at("for_each")
                related = [(place, "the component is stated here")]
                message = f"{listed} is sent for each {owner.name}, not {name}"
                yield spec.at(f"{key}[{number}]"), message, f"list it under {owner.name}", related


def _chooses(parameter: Parameter, place: Place, report: Report) -> bool:
    """Return whether a parameter can choose; a finding if not."""
    if not is_single(parameter, place, report):
        return False
    meanings = ", ".join(f"{value} {choice.value}" for value, choice in enumerate(CHOICES))
    related = [(parameter.spec.place, f"{parameter.name} is declared here")]
    if parameter.step != 1 or set(parameter.choices) != set(range(len(CHOICES))):
        message = f"{parameter.name} does not choose between generations: its values are not 0, 1 and 2"
        report.add(BAD_GENERATIONS, place, message, f"give it the values {meanings}", related)
        return False
    if parameter.spec.reboot:
        message = f"{parameter.name} is used only after a restart, but a generation is chosen at once"
        report.add(BAD_GENERATIONS, place, message, "remove its reboot: true", related)
    return True


def resolve_on_change(
    population: PopulationSpec,
    component: Component | None,
    spec: Spec,
    components: Mapping[str, Component],
    report: Report,
) -> Quantity | None:
    """The quantity whose change announces a message; says, too, where nothing can announce it."""
    for key in ("on_connection", "on_change"):
        if spec.vehicle is None and getattr(population, key):
            message = f"{population.message} is to be sent {key.replace('_', ' ')}, and there is no program to do it"
            report.add(BAD_ANNOUNCEMENT, population.at(key), message, "describe the program in vehicle.yaml")
    if population.on_change is None:
        return None
    place = population.at("on_change")
    quantity = find_quantity(population.on_change, components, spec.state, place, report)
    if quantity is None:
        return None
    owner = components[quantity.component]
    if quantity.kind is QuantityKind.TEXT:
        message = f"{quantity.path} is a text, and changes of texts are not watched"
        report.add(BAD_ANNOUNCEMENT, place, message, "name a number, an enum or a boolean that changes with it")
    if component is not None and owner is not component:
        message = f"{quantity.path} says nothing about a {component.name}, which {population.message} is sent for"
        report.add(BAD_ANNOUNCEMENT, place, message, f"name a quantity of {component.name}")
    elif component is None and owner.instances > 1:
        message = f"{population.message} is sent once, and there are several of {owner.name}"
        report.add(BAD_ANNOUNCEMENT, place, message, f"for_each: {owner.name}")
    return quantity
