"""Chooses the instance that a message reports where it reports only one of several."""

from collections.abc import Iterable, Mapping

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.answers.answer import Answer
from codegen.model.spec.population import PopulationSpec, RepresentationSpec
from codegen.model.spec.spec import ParametersSpec
from codegen.model.spec.state import StateSpec
from codegen.model.system import Policy, Representation
from codegen.model.units.unit import NUMBER
from codegen.model.vehicle import Component, Parameter, QuantityKind
from codegen.resolve.in_force import check_at_once
from codegen.resolve.quantities.component import find_component
from codegen.resolve.vehicle import find_parameter

UNCLEAR_INSTANCE = Rule(
    "unclear-instance",
    "A message reads a component of which there are several, and is not sent for each of them: receivers could not "
    "know which one they see. Send it for_each component, or say with represents which one it is about.",
)
BAD_REPRESENTATION = Rule(
    "bad-representation",
    "A message represents a component that it reads and is not sent for_each of. A parameter that chooses has whole "
    "numbers from 1 on, and what is lowest is a number of that component.",
    remedy="write represents: {component: {first: true}}, parameter or lowest",
)


def resolve_representations(
    population: PopulationSpec,
    answers: Iterable[Answer],
    components: Mapping[str, Component],
    state: StateSpec,
    written: ParametersSpec,
    parameters: Mapping[str, Parameter],
    report: Report,
) -> dict[str, Representation]:
    """The choices of a message by component; components of several instances that lack one are reported."""
    read = {quantity.component for answer in answers for quantity in answer.quantities}
    chosen = {}
    for name, policy in population.represents.items():
        place = population.at(f"represents.{name}")
        component = find_component(name, components, state, BAD_REPRESENTATION, place, report)
        if component is None:
            continue
        if name == population.for_each:
            report.add(
                BAD_REPRESENTATION,
                place,
                f"the message is sent for each {name}, and represents all of them",
                hint="leave it out",
            )
        elif name not in read:
            report.add(
                BAD_REPRESENTATION,
                place,
                f"no field of the message is about {name}",
                hint=f"leave it out, or answer a field with a quantity of {name}",
            )
        elif (choice := _choice(component, policy, written, parameters, report)) is not None:
            chosen[name] = choice
    # A choice that could not be read, or the number of an instance asked for in vain, has been reported.
    reported = {written.state.removesuffix(".instance") for written in population.fields.values() if written.state}
    for name in sorted(read - {population.for_each} - population.represents.keys() - reported):
        if components[name].instances > 1 and f"represents.{name}" not in population.places:
            report.add(
                UNCLEAR_INSTANCE,
                population.place,
                f"{population.message} does not say which {name} of {components[name].instances} it is about",
                f"represents: {{{name}: {{first: true}}}}",
            )
    return chosen


def _choice(
    component: Component,
    policy: RepresentationSpec,
    written: ParametersSpec,
    parameters: Mapping[str, Parameter],
    report: Report,
) -> Representation | None:
    if policy.parameter is not None:
        place = policy.at("parameter")
        parameter = find_parameter(policy.parameter, place, written, parameters, report)
        if parameter is None:
            return None
        if parameter.step != 1 or parameter.minimum < 1 or parameter.unit is not NUMBER:
            related = [(parameter.spec.place, f"{parameter.name} is declared here")]
            message = f"{parameter.name} is not the number of a {component.name}, from 1 on"
            report.add(
                BAD_REPRESENTATION,
                place,
                message,
                related=related,
                hint=f"give {parameter.name} min: 1 and step: 1, and no unit",
            )
            return None
        check_at_once(parameter, "what stands for all", BAD_REPRESENTATION, place, report)
        return Representation(component, Policy.PARAMETER, parameter=parameter)
    if policy.lowest is not None:
        place = policy.at("lowest")
        quantity = component.quantities.get(policy.lowest)
        if quantity is None:
            if not component.spec.is_written(policy.lowest):
                hint = did_you_mean(policy.lowest, component.quantities)
                report.add(BAD_REPRESENTATION, place, f"{component.name} has no quantity {policy.lowest}", hint)
            return None
        if quantity.kind is not QuantityKind.NUMBER or quantity.elements is not None:
            report.add(
                BAD_REPRESENTATION,
                place,
                f"{quantity.path} is not a single number",
                hint=f"name a number of {component.name} without elements",
            )
            return None
        return Representation(component, Policy.LOWEST, quantity=quantity)
    return Representation(component, Policy.FIRST)
