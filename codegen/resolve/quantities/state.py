"""The vehicle state: its components, with their instances and their quantities."""

from collections.abc import Mapping

from codegen.derivations import clock_component
from codegen.derivations.surroundings import BAD_QUANTITY, UNKNOWN_QUANTITY, Surroundings
from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.measure import read_period_ms
from codegen.model.code.clock import CLOCK
from codegen.model.dialect.dialect import Dialect
from codegen.model.quantities.source_kind import Source
from codegen.model.spec.population import Rounding
from codegen.model.spec.spec import Requirement, Spec
from codegen.model.spec.state import ComponentSpec, StateSpec
from codegen.model.units.unit import NUMBER
from codegen.model.vehicle import AdcChannel, Component, Instance, Parameter, Quantity, Returns
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.in_force import said_start, unsaid_start
from codegen.resolve.quantities.carriers import find_carriers
from codegen.resolve.quantities.quantity import is_name, resolve_quantity
from codegen.resolve.vehicle import find_parameter
from codegen.source import Place

BAD_COMPONENT = Rule(
    "bad-component",
    "A component has a lower-case identifier as its name; the number of its first instance is a parameter of whole "
    "numbers from 0 to 255.",
)

_RESERVED_COMPONENTS = {
    *("parameters", "state", "instance", "message", "messages", "payload", "value", "time", "system"),
    *("words", "words_at", "forget_next", "board", "ticks", "now_ms"),
}
"""Names that the generated code uses itself, beside Python's own."""
_FRONTS = ("update_", "calibrate_", "tell_")
"""The fronts of the names of methods that the state has for each component."""
_CONVERSIONS = {"complete", "limited", "pack_into", "put_float", "spill", *Rounding}


def resolve_components(
    spec: Spec,
    dialect: Dialect,
    instances: Mapping[str, tuple[Instance, ...]],
    channels: Mapping[str, AdcChannel],
    sources: Mapping[str, Source],
    parameters: Mapping[str, Parameter],
    index: Mapping[str, Requirement],
    report: Report,
) -> dict[str, Component]:
    """The components by name."""
    components = {}
    carriers = find_carriers(spec, dialect)

    def find(name: str, place: Place) -> Parameter | None:
        return find_parameter(name, place, spec.parameters, parameters, report)

    for name, written in spec.state.components.items():
        _check_component(name, written, report)
        period = None
        if written.update_rate is not None:
            period = read_period_ms(written.update_rate, written.at("update_rate"), report)
        quantities = {}
        for quantity_name, quantity_spec in written.quantities.items():
            path = f"{name}.{quantity_name}"
            around = Surroundings(
                component=name,
                name=quantity_name,
                spec=quantity_spec,
                parts=instances[name],
                period_ms=period,
                channels=channels,
                sources=sources,
                find_parameter=find,
                whole=spec,
                dialect=dialect,
                carriers=carriers.fields.get(path, ()),
                is_compared=path in carriers.compared,
                received=carriers.received.get(path, ()),
                report=report,
            )
            quantity = resolve_quantity(around, index)
            assert quantity is not None or report.has_errors, f"{path} is left out, and nobody is told why"
            if quantity is not None:
                quantities[quantity_name] = quantity
        _check_names(quantities, report)
        components[name] = Component(
            name=name,
            parts=instances[name],
            first_number=_first_number(written, spec, parameters, report),
            period_ms=period,
            quantities=quantities,
            returns=_returns(quantities),
            spec=written,
            citation=cite_optional(written.requirement, written.at("requirement"), index, report),
            aspects=cite_aspects(written, index, report),
        )
    if any(answer.clock for population in spec.populations for answer in population.fields.values()):
        if CLOCK in components:
            message = f"{CLOCK} is the component of what tables name as clock: boot and clock: unix"
            report.add(BAD_COMPONENT, components[CLOCK].spec.place, message, "choose another name")
        components[CLOCK] = clock_component(spec.state.place)
    return components


def _first_number(
    spec: ComponentSpec, whole: Spec, parameters: Mapping[str, Parameter], report: Report
) -> Parameter | None:
    if spec.first_number is None:
        return None
    place = spec.at("first_number")
    parameter = find_parameter(spec.first_number, place, whole.parameters, parameters, report)
    if parameter is not None and (
        parameter.step != 1 or parameter.minimum < 0 or parameter.maximum > 255 or parameter.unit is not NUMBER
    ):
        report.add(
            BAD_COMPONENT,
            place,
            f"{parameter.name} is not a whole number from 0 to 255",
            hint=f"give {parameter.name} min: 0, max: 255, step: 1 and no unit, or name another parameter",
        )
    elif parameter is not None and not parameter.spec.reboot:
        report.add(BAD_COMPONENT, place, unsaid_start(parameter), said_start(parameter))
    return parameter


def _check_component(name: str, spec: ComponentSpec, report: Report) -> None:
    if (
        not is_name(name)
        or name in _RESERVED_COMPONENTS | _CONVERSIONS
        or name.startswith(_FRONTS)
        or name.endswith("_words")
    ):
        report.add(BAD_COMPONENT, spec.place, f"{name} cannot be the name of a component", "choose another name")


def _check_names(quantities: Mapping[str, Quantity], report: Report) -> None:
    """Report a name in the firmware that belongs to several quantities of the component."""
    owners: dict[str, Quantity] = {}
    for quantity in quantities.values():
        for name in sorted({quantity.name, quantity.attribute, *quantity.derivation.names(quantity)}):
            owner = owners.setdefault(name, quantity)
            if owner is not quantity:
                related = [(owner.spec.place, f"{owner.name} takes the name {name} in the firmware")]
                report.add(
                    BAD_QUANTITY,
                    quantity.spec.place,
                    f"{quantity.name} needs the name {name}",
                    f"rename {quantity.name}",
                    related,
                )


def find_quantity(
    path: str, components: Mapping[str, Component], state: StateSpec, place: Place, report: Report
) -> Quantity | None:
    """The quantity written as ``component.quantity``; one that is written but broken has been reported already."""
    component, _, name = path.partition(".")
    if component in components and name in components[component].quantities:
        return components[component].quantities[name]
    if state.is_written(component, name):
        return None
    known = [f"{owner.name}.{quantity}" for owner in components.values() for quantity in owner.quantities]
    report.add(UNKNOWN_QUANTITY, place, f"the state has no quantity {path}", did_you_mean(path, known))
    return None


def _returns(quantities: Mapping[str, Quantity]) -> Returns | None:
    """Return what counts returns in a component; None where nothing does."""
    for count in quantities.values():
        gone = quantities.get(count.derivation.counts or "")
        if gone is not None:
            restarting = tuple(each for each in quantities.values() if each.spec.restarts_with == count.name)
            return Returns(count, gone, restarting)
    return None
