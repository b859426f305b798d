"""The receiver: the component that it is for, its messages and its times."""

from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches

from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.measure import read_time
from codegen.model.dialect.dialect import Dialect, EnumDefinition, WireMessage
from codegen.model.receiver import Receiver
from codegen.model.spec.receiver import ReceiverSpec
from codegen.model.spec.spec import Requirement
from codegen.model.spec.state import StateSpec
from codegen.model.system import PopulatedMessage
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import Component
from codegen.resolve.citation import cite_aspects, cite_optional
from codegen.resolve.quantities.component import find_component

BAD_RECEIVER = Rule(
    "bad-receiver",
    "A receiver is for a component of the state, and turns back those messages that are sent for each instance of it "
    "and carry the number of the instance. Name such a component, or write a table with for_each and an id.",
    remedy="name a component of state.yaml that a message with for_each is sent for",
)

UNPLAYED_ROLE = Rule(
    "unplayed-role",
    "receiver.yaml gives a role to fields of which the messages that are received have none: what is computed from it "
    "stays unknown. Name a field of these messages. So it is with the entries that say charging; and a name that no "
    "message, or enum, of the dialect has is told beside right ones, too, where it is nearly one of theirs.",
    Severity.WARNING,
    remedy="name a field of the messages that are received, or leave the role, or the name, out",
)


_MISSPELT = 0.85
"""The likeness, from 0 to 1, from which on a name is a misspelling of one of the messages."""


def resolve_receiver(
    spec: ReceiverSpec,
    components: Mapping[str, Component],
    state: StateSpec,
    messages: Sequence[PopulatedMessage],
    index: Mapping[str, Requirement],
    dialect: Dialect,
    report: Report,
) -> Receiver | None:
    """The receiver that receiver.yaml describes; None after a finding."""
    citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
    aspects = cite_aspects(spec, index, report)
    stale = read_time(spec.stale_after, unit_named("ms"), spec.at("stale_after"), report)
    window = read_time(spec.rate_over, unit_named("ms"), spec.at("rate_over"), report)
    component = find_component(spec.component, components, state, BAD_RECEIVER, spec.at("component"), report)
    if component is None:
        return None
    received = sorted(
        (message for message in messages if _is_received(message, component)), key=lambda message: message.wire.id
    )
    _report_shared(received, messages, spec, report)
    if not received and report.has_errors:
        return None  # the table that is missing may be the one that was reported
    if not received:
        what = f"no message is sent for each {component.name} with its number"
        hint = f"write 'for_each: {component.name}' in a table, and answer a field with {component.name}.instance"
        report.add(BAD_RECEIVER, spec.at("component"), what, hint)
        return None
    _report_roles(received, spec, dialect, report)
    if stale is None or window is None:
        return None
    return Receiver(component, tuple(received), stale, window, citation, aspects, spec)


def _report_roles(received: Iterable[PopulatedMessage], spec: ReceiverSpec, dialect: Dialect, report: Report) -> None:
    """A role whose fields no received message has, and each name that is nearly one of theirs."""
    if spec.roles is None:
        return
    wires = [message.wire for message in received]
    named = {field.definition.enum for wire in wires for field in wire.fields}
    enums = [enum for name, enum in dialect.enums.items() if name in named]
    fields, anywhere_in_fields = _fields(wires), _fields(dialect.messages.values())
    for role, names, known, anywhere, what in (
        *((role, names, fields, anywhere_in_fields, "message") for role, names in spec.roles.fields()),
        ("charging", spec.roles.charging, _entries(enums), _entries(dialect.enums.values()), "enum"),
    ):
        place = spec.roles.at(role)
        if names and known.isdisjoint(names):
            of = "message that is received" if what == "message" else "enum of what is received"
            message = f"no {of} has {' or '.join(each or repr(each) for each in names)}"
            report.add(UNPLAYED_ROLE, place, message, did_you_mean(names[0], known))
            continue
        for index, name in enumerate(names):
            if name in anywhere:
                continue
            near = get_close_matches(name, sorted(known), n=1, cutoff=_MISSPELT)
            if near or not name:  # other names may be those of a draft, or of before
                at = spec.roles.places.get(f"{role}[{index}]", place)
                hint = f"did you mean {near[0]}?" if near else "leave it out"
                report.add(UNPLAYED_ROLE, at, f"no {what} of the dialect has {name or repr(name)}", hint)


def _fields(messages: Iterable[WireMessage]) -> set[str]:
    return {field.name for message in messages for field in message.fields}


def _entries(enums: Iterable[EnumDefinition]) -> set[str]:
    return {entry.name for enum in enums for entry in enum.entries}


def _report_shared(
    received: Iterable[PopulatedMessage], messages: Iterable[PopulatedMessage], spec: ReceiverSpec, report: Report
) -> None:
    """Report each received message that has several tables: a receiver cannot tell which of them a frame is of."""
    for message in received:
        other = next((each for each in messages if each.wire is message.wire and each is not message), None)
        if other is not None:
            names = f"{message.name} and {other.name}"
            what = f"{message.wire.name} has several tables, {names}, which look alike to a receiver"
            related = [(table.population.place, f"the table {table.name}") for table in (message, other)]
            report.add(BAD_RECEIVER, spec.at("component"), what, "leave one of them out", related)


def _is_received(message: PopulatedMessage, component: Component) -> bool:
    if message.component is None or message.component.name != component.name:
        return False
    return any(answer.is_instance_number and not answer.covers.field.is_array for answer in message.answers)
