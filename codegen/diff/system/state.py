"""Subjects of the parameters and of the state of a vehicle."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diff.system import behaviour_rules as rules
from codegen.diff.system.subject import Fact, Subject, amount, citations, cited
from codegen.diff.system.trace_rules import CITATION, DOC
from codegen.model.code.storage import HALF, Storage
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Component, Parameter, Quantity

_NUMBERED = "whether receivers know the instances by other numbers"


def parameter_subjects(system: System) -> Iterator[Subject]:
    """The parameters, by name."""
    return (_parameter(parameter) for parameter in system.parameters.values())


def _parameter(parameter: Parameter) -> Subject:
    spec, unit = parameter.spec, parameter.unit.name

    def shown(steps: int) -> str:
        return amount(steps * parameter.step, unit)

    choices = ", ".join(f"{shown(value)} {text}" for value, text in sorted(parameter.choices.items()))
    facts = (
        Fact("default", shown(parameter.default), rules.PARAMETER_DEFAULT, spec.at("default")),
        Fact("minimum", shown(parameter.minimum), rules.PARAMETER_RANGE, spec.at("min")),
        Fact("maximum", shown(parameter.maximum), rules.PARAMETER_RANGE, spec.at("max")),
        Fact("unit", unit, rules.PARAMETER_UNIT, spec.at("unit")),
        Fact("type", spec.type.value, rules.PARAMETER_TYPE, spec.at("type")),
        Fact("step", amount(parameter.step, unit), rules.PARAMETER, spec.at("step")),
        Fact("values", choices, rules.PARAMETER, spec.at("values")),
        Fact("used", "after a restart" if spec.reboot else "at once", rules.PARAMETER, spec.at("reboot")),
        Fact("was", _was(parameter), rules.PARAMETER, spec.at("was")),
        Fact("belongs to", _owner(parameter), rules.PARAMETER, spec.at("for_each")),
        Fact("default is", f"times {spec.per}" if spec.per else "", rules.PARAMETER, spec.at("per")),
        Fact("answers to", str(parameter.citation or ""), CITATION, spec.at("requirement")),
        Fact("doc", spec.doc, DOC, spec.at("doc")),
    )
    says = f"default {shown(parameter.default)}, {shown(parameter.minimum)} to {shown(parameter.maximum)}"
    return Subject(
        name=parameter.name,
        says=says,
        added=rules.PARAMETER_ADDED,
        removed=rules.PARAMETER_REMOVED,
        place=spec.place,
        facts=facts,
        cited=cited(parameter.citation),
        row=parameter.siblings[0] if parameter.siblings else "",
    )


def _was(parameter: Parameter) -> str:
    return ", ".join(f"{name} times {decimal(factor)}" for name, factor in sorted(parameter.spec.was.items()))


def _owner(parameter: Parameter) -> str:
    if parameter.component is None:
        return ""
    return f"{parameter.component} {parameter.instance + 1} of {', '.join(parameter.siblings)}"


def state_subjects(system: System) -> Iterator[Subject]:
    """The components of the state, each before its quantities."""
    for component in system.components.values():
        yield _component(component)
        yield from _facts(component, system)
        for quantity in component.quantities.values():
            yield _quantity(quantity)


def fact_name(component: str, fact: str) -> str:
    """Return what a fact of the board is called among changes: ``board.battery.weight``."""
    return f"board.{component}.{fact}"


def _facts(component: Component, system: System) -> Iterator[Subject]:
    """Yield what the board states of a component, each fact by itself, with that of each instance where they differ."""
    for name in dict.fromkeys(fact for part in component.parts for fact in part.facts):
        values = [str(part.facts.get(name, "nothing")) for part in component.parts]
        text = values[0] if len(set(values)) == 1 else ", ".join(values)
        place = system.spec.board.fact_place(component.name, 0, name)
        facts = (Fact(name, text, rules.FACT, place),)
        yield Subject(fact_name(component.name, name), text, rules.FACT, rules.FACT, place, facts)


def _component(component: Component) -> Subject:
    spec = component.spec
    parts = [
        Fact(
            f"instance {part.number + 1}:",
            f"parameters {part.prefix or 'without a prefix'}",
            rules.INSTANCES,
            spec.place,
        )
        for part in component.parts
    ]
    returns = component.returns
    counted = ""
    if returns is not None:
        names = ", ".join(quantity.name for quantity in returns.restarting) or "nothing"
        counted = f"{returns.count.name} when {returns.gone.name} ends; {names} begin anew"
    first = component.first_number.name if component.first_number else ""
    facts = (
        *parts,
        Fact("number of the first:", first, rules.INSTANCES, spec.at("first_number"), doubt=_NUMBERED),
        Fact("updated every", amount(component.period_ms, "ms"), rules.UPDATE_RATE, spec.at("update_rate")),
        Fact("counts", counted, rules.INSTANCES, spec.place),
        Fact("answers to", citations(component.citation, component.aspects), CITATION, spec.at("requirement")),
        Fact("doc", spec.doc, DOC, spec.at("doc")),
    )
    count = len(component.parts)
    return Subject(
        name=component.name,
        says=f"{count} {'instance' if count == 1 else 'instances'}",
        added=rules.COMPONENT_ADDED,
        removed=rules.COMPONENT_REMOVED,
        place=spec.place,
        facts=facts,
        cited=cited(component.citation, component.aspects),
    )


def _quantity(quantity: Quantity) -> Subject:
    spec, stored, trust = quantity.spec, quantity.stored.name, quantity.trust
    unit = quantity.unit.name
    coded = f"whether code that sets or reads {quantity.name} does so in {unit or 'plain numbers'}"
    smallest, largest = (_limit(limit, stored, quantity.storage) for limit in (quantity.minimum, quantity.maximum))
    facts = (
        Fact("unit", unit, rules.QUANTITY_UNIT, spec.at("unit"), doubt=coded),
        Fact("kept", f"as {quantity.attribute}{_kept_in(quantity)}", rules.QUANTITY_UNIT, spec.at("stored")),
        Fact(
            "steps",
            amount(quantity.steps, f"{stored} each {unit}" if unit else ""),
            rules.QUANTITY_UNIT,
            spec.at("stored"),
        ),
        Fact("kind", quantity.kind.value, rules.QUANTITY_SOURCE, spec.place),
        Fact("enum", quantity.enum.name if quantity.enum else "", rules.QUANTITY_SOURCE, spec.at("enum")),
        Fact("minimum", smallest, rules.QUANTITY_RANGE, spec.at("min")),
        Fact("maximum", largest, rules.QUANTITY_RANGE, spec.at("max")),
        Fact("values", _counts(quantity), rules.QUANTITY_RANGE, spec.at("elements")),
        Fact("initially", _initially(quantity), rules.QUANTITY_SOURCE, spec.at("initial")),
        *_derivation(quantity),
        Fact("unknown after", amount(trust.stale_after_ms, "ms"), rules.QUANTITY_AGE, spec.at("stale_after")),
        Fact("failures until unknown:", amount(trust.invalid_after), rules.QUANTITY_AGE, spec.at("invalid_after")),
        Fact("answers to", citations(quantity.citation, quantity.aspects), CITATION, spec.at("requirement")),
        Fact("called", quantity.called, rules.QUANTITY_SOURCE, spec.at("called")),
        Fact("doc", spec.doc, DOC, spec.at("doc")),
    )
    return Subject(
        name=quantity.path,
        says=f"{quantity.kind.value}{f' in {stored}' if stored else ''}",
        added=rules.QUANTITY_ADDED,
        removed=rules.QUANTITY_REMOVED,
        place=spec.place,
        facts=facts,
        cited=cited(quantity.citation, quantity.aspects),
    )


def _limit(limit: int | Fraction, stored: str, storage: Storage) -> str:
    """A limit; nothing where it is only that of what holds the number."""
    return "" if limit in storage.limits else amount(limit, stored)


def _kept_in(quantity: Quantity) -> str:
    """Return the steps and the width in which it is kept; a plain number of one word has neither to tell."""
    has_steps = quantity.stored.name or quantity.length
    return f"{f' in {quantity.stored.name}' if has_steps else ''}{_width(quantity)}"


def _width(quantity: Quantity) -> str:
    """Return how many bits there are, where it is not one word, or bytes of a text."""
    storage = quantity.storage
    if quantity.length:
        return f"up to {quantity.length} bytes"
    if storage is Storage.SMALL:
        return ""
    return f", {'a float' if storage.is_float else 'an integer'} of {HALF * storage.halves} bits"


def _initially(quantity: Quantity) -> str:
    if isinstance(quantity.initial, str):
        return quantity.start
    return amount(quantity.initial, quantity.stored.name) or "unknown"


def _counts(quantity: Quantity) -> str:
    return ", ".join(str(count) for count in quantity.elements or ())


def _derivation(quantity: Quantity) -> Iterator[Fact]:
    for fact in quantity.derivation.facts(quantity):
        rule = rules.QUANTITY_AGE if fact.is_trust else rules.QUANTITY_SOURCE
        yield Fact(fact.attribute, fact.text, rule, quantity.spec.at(fact.key))
