"""The vehicle state: its components, with their instances and their quantities."""

from collections.abc import Mapping

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.measure import read_rate
from codegen.model.dialect import Dialect
from codegen.model.population_spec import Rounding
from codegen.model.spec import Requirement, Spec
from codegen.model.state_spec import ComponentSpec, StateSpec
from codegen.model.vehicle import AdcChannel, Component, Instance, Parameter, Quantity
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.derived import check_derived
from codegen.resolve.quantity import BAD_QUANTITY, QuantityResolver, is_name
from codegen.resolve.returns import resolve_returns
from codegen.resolve.vehicle import find_parameter
from codegen.source import Place

BAD_COMPONENT = Rule(
    "bad-component",
    "A component has a lower-case identifier as its name; the number of its first instance is a parameter of whole "
    "numbers from 0 to 255.",
)
UNKNOWN_QUANTITY = Rule("unknown-quantity", "A table names a quantity that state.yaml does not have.")

_RESERVED_COMPONENTS = {"parameters", "state", "instance", "message", "messages", "payload", "value", "time", "system"}
"""Names that the generated code uses itself, beside Python's own."""
_CONVERSIONS = {"complete", "limited", "pack_into", "put_float", "spill", *Rounding}


def resolve_components(
    spec: Spec,
    dialect: Dialect,
    instances: Mapping[str, tuple[Instance, ...]],
    channels: Mapping[str, AdcChannel],
    parameters: Mapping[str, Parameter],
    index: Mapping[str, Requirement],
    report: Report,
) -> dict[str, Component]:
    """The components by name."""
    components = {}
    for name, written in spec.state.components.items():
        _check_component(name, written, report)
        period = None
        if written.update_rate is not None:
            rate = read_rate(written.update_rate, written.at("update_rate"), report)
            period = None if rate is None else round(1000 / rate)
        quantities = {}
        for quantity_name, quantity_spec in written.quantities.items():
            resolver = QuantityResolver(name, quantity_name, quantity_spec, spec, report)
            quantity = resolver.resolve(dialect, instances[name], channels, parameters, index, period)
            if quantity is not None:
                quantities[quantity_name] = quantity
        _check_quantities(written, quantities, report)
        components[name] = Component(
            name=name,
            parts=instances[name],
            first_number=_first_number(written, spec, parameters, report),
            period_ms=period,
            quantities=quantities,
            returns=resolve_returns(written, quantities, report),
            spec=written,
            citation=cite_optional(written.requirement, written.at("requirement"), index, report),
            aspects=cite_aspects(written, index, report),
        )
    return components


def _first_number(
    spec: ComponentSpec, whole: Spec, parameters: Mapping[str, Parameter], report: Report
) -> Parameter | None:
    if spec.first_number is None:
        return None
    place = spec.at("first_number")
    parameter = find_parameter(spec.first_number, place, whole.parameters, parameters, report)
    if parameter is not None and (parameter.step != 1 or parameter.minimum < 0 or parameter.maximum > 255):
        report.add(BAD_COMPONENT, place, f"{parameter.name} is not a whole number from 0 to 255")
    return parameter


def _check_component(name: str, spec: ComponentSpec, report: Report) -> None:
    if not is_name(name) or name in _RESERVED_COMPONENTS | _CONVERSIONS or name.startswith(("update_", "calibrate_")):
        report.add(BAD_COMPONENT, spec.place, f"{name} cannot be the name of a component", "choose another name")


def _check_quantities(spec: ComponentSpec, quantities: Mapping[str, Quantity], report: Report) -> None:
    """What holds between the quantities of one component."""
    for quantity in quantities.values():
        followed = quantity.while_known
        if followed is not None and followed not in spec.quantities:
            hint = did_you_mean(followed, spec.quantities)
            report.add(UNKNOWN_QUANTITY, quantity.spec.at("while_known"), f"there is no quantity {followed}", hint)
        elif followed is not None and spec.quantities[followed].boolean:
            message = f"{quantity.name} follows {followed}, a boolean, which is never unknown"
            report.add(BAD_QUANTITY, quantity.spec.at("while_known"), message)
    owners: dict[str, Quantity] = {}
    for quantity in quantities.values():
        names = {quantity.name, quantity.attribute}
        names |= {f"{quantity.name}_from_adc"} if quantity.conversion else set()
        for name in sorted(names):
            owner = owners.setdefault(name, quantity)
            if owner is not quantity:
                related = [(owner.spec.place, f"{owner.name} takes the name {name} in the firmware")]
                report.add(BAD_QUANTITY, quantity.spec.place, f"{quantity.name} needs the name {name}", None, related)
    check_derived(spec, quantities, report)
    measured = [quantity for quantity in quantities.values() if quantity.conversion is not None]
    for second in measured[1:]:
        report.add(
            BAD_QUANTITY,
            second.spec.at("adc"),
            "a component has one quantity that an ADC measures",
            related=[(measured[0].spec.at("adc"), f"{measured[0].name} is measured, too")],
        )


def find_quantity(
    path: str, components: Mapping[str, Component], state: StateSpec, place: Place, report: Report
) -> Quantity | None:
    """The quantity written as ``component.quantity``; one that is written but broken has been reported already."""
    component, _, name = path.partition(".")
    if component in components and name in components[component].quantities:
        return components[component].quantities[name]
    if component in state.components and name in state.components[component].quantities:
        return None
    known = [f"{owner.name}.{quantity}" for owner in components.values() for quantity in owner.quantities]
    report.add(UNKNOWN_QUANTITY, place, f"the state has no quantity {path}", did_you_mean(path, known))
    return None
