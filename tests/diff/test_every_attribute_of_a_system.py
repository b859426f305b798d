"""Nothing that changes in a specification is missed: each attribute of the resolved system is changed in turn."""

from collections.abc import Iterator, Mapping
from dataclasses import fields, is_dataclass, replace
from enum import Enum
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from codegen.answers.live import LiveAnswer
from codegen.commands.trace import read_trace
from codegen.diagnostics import Report
from codegen.diff.change import Notice
from codegen.diff.reach import traces, with_reach
from codegen.diff.system import system as comparison
from codegen.diff.system.system import compare_systems
from codegen.model.dialect.dialect import Dialect, EnumDefinition, WireField, WireMessage
from codegen.model.price import Price
from codegen.model.spec.spec import ParameterEncoding, ParameterType
from codegen.model.system import PopulatedMessage, System
from codegen.model.units.unit import Unit, unit_named
from codegen.model.vehicle import Citation, Component, Parameter, Quantity, Stream
from codegen.project.systems import read_systems
from codegen.source import Written

ROOT = Path(__file__).resolve().parents[2]

WHOLE = (Dialect, EnumDefinition, WireField, WireMessage, Price)
"""Records of which another test changes the attributes; here they are only exchanged for one another."""

LINKED = (Parameter, Quantity, Component, Stream, Citation, PopulatedMessage, Unit)
"""Records that others point at: there they are exchanged, and changed where they belong."""

HOME = {
    "parameters": Parameter,
    "components": Component,
    "quantities": Quantity,
    "streams": Stream,
    "messages": PopulatedMessage,
}
"""The owners of such records, by the attribute that holds them."""

UNSEEN = {
    "System.spec": "what was written; what it resolves to is compared, and single texts of it",
    "System.dialect": "has a test of its own",
    "CommandParam.limits": "words for its minimum, maximum, unit and enum, which are compared",
    "System.requirements": "the next tests",
    "System.system_id": "compared, but its parameter says it too",
    "PopulatedMessage.population": "what was written",
    "PopulatedMessage.wire": "of the dialect",
    "Elements.field": "of the dialect",
    "Elements.written": "what was written; its note is compared",
    "Elements.first": "which elements: every one of them is compared",
    "Elements.count": "which elements: every one of them is compared",
    "Quantity.component": "part of the name by which it is found",
    "Quantity.name": "the name by which it is found",
    "Component.name": "the name by which it is found",
    "Parameter.name": "the name by which it is found",
    "Stream.name": "the name by which it is found",
    "AdcChannel.name": "the name by which it is found",
    "BoardLink.name": "the name by which it is found",
    "Representation.component": "the name by which it is found",
    "Instance.number": "the place in the list",
    "Receiver.messages": "named by their own tables",
    "Conversion.channel": "has its own attributes",
    "BoardModel.spec": "what was written",
    "BoardModel.pins": "what can be connected; what is connected is compared",
    "BoardModel.taken": "what can be connected; what is connected is compared",
    "BoardModel.labels": "what is printed on the board: the drawing of the wiring alone has it",
    "BoardModel.uarts": "what can be connected; what is connected is compared",
    "BoardModel.i2c": "what can be connected; what is connected is compared",
    "BoardModel.watchdog": "what a program can ask for; what it asks for is compared",
    "BoardWatchdog.shortest_ms": "what a program can ask for; what it asks for is compared",
    "BoardWatchdog.longest_ms": "what a program can ask for; what it asks for is compared",
    "Watchdog.citation": "compared as one of the program",
    "Watchdog.aspects": "compared as those of the program",
    "Converter.pins": "what can be connected; what is connected is compared",
    "Converter.bits": "a default, compared with the channels",
    "Converter.reference": "a default, compared with the channels",
    "Parameter.instance": "part of the family, compared with the component",
    "Program.absences": "follows from the dialect, the component id and whether there are modes, which are compared",
    "Absence.question": "of the dialect",
    "Absence.answer": "of the dialect",
    "Absence.method": "follows from the question",
    "Setting.count": "follows from the parameter, or is the amount in its words",
    "Setting.unit": "that of the quantity, which is compared itself",
    "FailsafeText.parts": "follow from the text as it is written",
    "Shown.quantity": "follows from the text as it is written",
    "Shown.decimals": "follows from the text as it is written",
    "Shown.unknown": "follows from the text as it is written",
    "Failsafe.can_arm": "follows from whether anything is armed, which is compared",
    "Follows.steps": "those of what is followed; limits are compared as amounts, and 0 is 0 in any",
    "FixedAnswer.meaning": "words for the value that is compared",
}
"""Attributes that are not changed here, and why."""


def other(value: Any, siblings: Mapping[type, list[Any]]) -> Any:
    """Another value of the same kind, or None where there is no other."""
    if isinstance(value, (tuple, dict, frozenset)):
        return _other_collection(value, siblings)
    match value:
        case bool():
            return not value
        case Enum():
            return next((one for one in type(value) if one is not value), None)
        case int() | Fraction():
            return value + 1
        case float():
            return 1.25
        case str():
            return f"{value}x"
        case Unit():
            return unit_named("kg" if value.name != "kg" else "g")
    return next((one for one in siblings.get(type(value), []) if one != value), None)


def _other_collection(value: Any, siblings: Mapping[type, list[Any]]) -> Any:
    """Without its last member, or of plain values with another one in its place."""
    if not value:
        return None
    if isinstance(value, dict):
        return dict(list(value.items())[:-1])
    last = value[-1]
    if isinstance(last, (str, int, float)):
        return (*value[:-1], other(last, siblings))
    return value[:-1]


def mutants(record: Any, siblings: Mapping[type, list[Any]], seen: set[int]) -> Iterator[tuple[str, Any]]:
    """The name of each attribute below a record, and the record with that attribute changed."""
    if id(record) in seen:
        return
    seen.add(id(record))
    for field in fields(record):
        name, value = f"{type(record).__name__}.{field.name}", getattr(record, field.name)
        if name in UNSEEN or isinstance(value, Written) or value is None:
            continue
        if not (is_dataclass(value) and not isinstance(value, (*LINKED, *WHOLE))):
            changed = other(value, siblings)
            if changed is not None:
                yield name, replace(record, **{field.name: changed})
        belongs = HOME.get(field.name)
        for key, part in _parts(value):
            if isinstance(part, (*LINKED, *WHOLE)) and not (belongs and isinstance(part, belongs)):
                continue
            for inner, changed in mutants(part, siblings, seen):
                yield inner, replace(record, **{field.name: _put(value, key, changed)})


def _parts(value: Any) -> list[tuple[Any, Any]]:
    """The records directly in a value, each with what it is found by."""
    if isinstance(value, Mapping):
        return [(key, part) for key, part in value.items() if is_dataclass(part) and not isinstance(part, Written)]
    if isinstance(value, tuple):
        return [(i, part) for i, part in enumerate(value) if is_dataclass(part) and not isinstance(part, Written)]
    return [(None, value)] if is_dataclass(value) and not isinstance(value, Written) else []


def _put(value: Any, key: Any, part: Any) -> Any:
    if isinstance(value, Mapping):
        return {**value, key: part}
    if isinstance(value, tuple):
        return (*value[:key], part, *value[key + 1 :])
    return part


@pytest.fixture(scope="module")
def systems() -> tuple[System, ...]:
    return read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())


def said_once(system: System, monkeypatch: pytest.MonkeyPatch) -> None:
    """Find out once what there is to say about a system with which hundreds are compared."""
    said, subjects = comparison._subjects(system), comparison._subjects
    monkeypatch.setattr(comparison, "_subjects", lambda each: said if each is system else subjects(each))


def siblings_of(system: System) -> dict[type, list[Any]]:
    """Records of each kind that others can be exchanged for."""
    quantities = [quantity for component in system.components.values() for quantity in component.quantities.values()]
    citations = [answer.covers.citation for message in system.messages for answer in message.answers]
    wires = list(system.dialect.messages.values())
    found: dict[type, list[Any]] = {
        Parameter: sorted(system.parameters.values(), key=lambda each: each.default),  # some choose by it
        Quantity: quantities,
        Component: list(system.components.values()),
        Stream: list(system.streams.values()),
        Citation: citations,
        PopulatedMessage: list(system.messages),
        WireMessage: wires,
        EnumDefinition: list(system.dialect.enums.values()),
    }
    return found


def test_each_attribute_that_changes_is_told(systems: tuple[System, ...], monkeypatch: pytest.MonkeyPatch) -> None:
    """Of every record of the shipped system: an attribute that is missed would be a change that nobody reviews."""
    main = systems[0]
    said_once(main, monkeypatch)
    missed, told = [], {}
    tried: dict[str, int] = {}
    for name, system in mutants(main, siblings_of(main), set()):
        tried[name] = tried.get(name, 0) + 1
        if tried[name] > 2:
            continue
        changes = compare_systems((main,), (system,)).changes
        if not changes:
            missed.append(name)
        told.setdefault(name, set()).update(change.rule.id for change in changes)
        for change in changes:
            assert change.old != change.new, (name, change.rule.id)
    assert len(tried) > 100, "the walk finds the records"
    assert not missed, missed
    for name, rules in EXPECTED.items():
        assert name in told, f"{name} is not in the shipped system"
        assert rules <= told[name], f"{name}: {told[name]}"


def test_a_parameter_of_a_family_reaches_what_the_family_does(systems: tuple[System, ...]) -> None:
    """The row of a family in the trace stands for those of all instances."""
    main = systems[0]
    second = main.parameters["BATT2_LOW_VOLT"]
    changed = replace(main, parameters={**main.parameters, second.name: replace(second, default=second.default + 1)})
    trace = read_trace((main,), Report())
    found = with_reach(compare_systems((main,), (changed,)).changes, traces(trace, trace, (main, changed)))
    change = next(one for one in found if one.subject == second.name)
    assert "firmware/parameters.py: Parameters.batt2_low_volt" in change.reach.symbols
    assert change.reach.tests


EXPECTED = {
    "LiveAnswer.source": {"population-source-changed"},
    "Scaling.factor": {"population-conversion-changed"},
    "Scaling.rounding": {"population-conversion-changed"},
    "Scaling.low": {"population-limits-changed"},
    "Scaling.high": {"population-limits-changed"},
    "LiveAnswer.unknown": {"population-unknown-changed"},
    "EachAnswer.first": {"population-source-changed"},
    "FlagsAnswer.mask": {"population-flags-changed"},
    "FlagsAnswer.names": {"population-flags-changed"},
    "FixedAnswer.fixed": {"population-constant-changed"},
    "Elements.citation": {"citation-changed"},
    "PopulatedMessage.stream": {"message-schedule-changed"},
    "PopulatedMessage.component": {"message-instances-changed"},
    "Parameter.default": {"parameter-default-changed"},
    "Parameter.minimum": {"parameter-range-changed"},
    "Parameter.unit": {"parameter-unit-changed"},
    "Quantity.stored": {"quantity-unit-changed"},
    "Quantity.maximum": {"quantity-range-changed"},
    "Quantity.initial": {"quantity-source-changed"},
    "Trust.stale_after_ms": {"quantity-trust-changed"},
    "Threshold.above": {"quantity-trust-changed"},
    "Follows.limits": {"quantity-source-changed"},
    "Trend.readings": {"quantity-source-changed"},
    "Stream.fastest": {"stream-rate-changed"},
    "AdcChannel.samples": {"adc-channel-changed"},
    "Condition.sense": {"failsafe-changed"},
    "Program.control_us": {"program-changed"},
    "Program.encoding": {"parameter-encoding-changed"},
    "Receiver.stale_after_ms": {"receiver-changed"},
    "Generations.new": {"generations-changed"},
}
"""Of attributes whose rule matters, the rule."""


def test_a_further_program_is_told_with_what_it_sends(systems: tuple[System, ...]) -> None:
    """One that comes, goes, or is called otherwise: who reads only the report learns what it is for."""
    main, battery = systems
    said = f"a further program, which sends {', '.join(message.name for message in battery.messages)}"
    for old, new, rule, sides in (
        ((main,), (main, battery), "program-added", (None, said)),
        ((main, battery), (main,), "program-removed", (said, None)),
    ):
        found = [change for change in compare_systems(old, new).changes if change.rule.id == rule]
        assert [(change.subject, change.old, change.new) for change in found] == [("smart_battery", *sides)]
    assert "BATTERY_STATUS" in said


def test_what_a_table_says_of_frames_that_are_dropped_is_not_silent(systems: tuple[System, ...]) -> None:
    """Another unknown in a message with the same CRC_EXTRA is believed, in one with another it is not."""
    main = systems[0]
    message = next(one for one in main.messages if one.name == "BATTERY_STATUS")
    live = next(one for one in message.answers if isinstance(one, LiveAnswer) and one.unknown is not None)
    answers = tuple(replace(one, unknown=7) if one is live else one for one in message.answers)
    messages = tuple(replace(one, answers=answers) if one is message else one for one in main.messages)
    wire = replace(message.wire, crc_extra=message.wire.crc_extra ^ 1)
    dialect = replace(main.dialect, messages={**main.dialect.messages, wire.name: wire})
    for head, notice in (
        (replace(main, messages=messages), Notice.SILENT),
        (replace(main, messages=messages, dialect=dialect), Notice.NOTICED),
    ):
        found = [
            one for one in compare_systems((main,), (head,)).changes if one.rule.id == "population-unknown-changed"
        ]
        assert [change.notice for change in found] == [notice]


def test_what_nobody_notices_is_silent_though_no_message_has_it(systems: tuple[System, ...]) -> None:
    """A parameter in another unit takes the old numbers and means others by them."""
    main = systems[0]
    name, parameter = next((name, one) for name, one in main.parameters.items() if one.unit.name == "V")
    parameters = {**main.parameters, name: replace(parameter, unit=unit_named("mV"))}
    found = compare_systems((main,), (replace(main, parameters=parameters),)).changes
    assert {change.rule.id for change in found if change.is_silent} == {"parameter-unit-changed"}


def test_another_encoding_of_parameters_is_silent_where_whole_ones_are_carried(systems: tuple[System, ...]) -> None:
    """A station that goes on with the old one reads and sets other numbers; real32 is the same in both."""
    main = systems[0]
    assert main.program is not None
    bytewise = replace(main.program, encoding=ParameterEncoding.BYTEWISE)
    found = compare_systems((main,), (replace(main, program=bytewise),)).changes
    (change,) = (one for one in found if one.rule.id == "parameter-encoding-changed")
    assert (change.old, change.new) == ("encoding c_cast", "encoding bytewise")
    assert change.is_silent
    assert change.is_breaking
    floats = {
        name: replace(one, spec=replace(one.spec, type=ParameterType.REAL32)) for name, one in main.parameters.items()
    }
    main = replace(main, parameters=floats)
    found = compare_systems((main,), (replace(main, program=bytewise),)).changes
    assert [one.rule.id for one in found] == []


def test_a_program_is_named_once(systems: tuple[System, ...]) -> None:
    main, battery = systems
    found = compare_systems(systems, (main, replace(battery, component_id=99))).changes
    assert [change.subject for change in found if change.rule.id == "identity-changed"] == ["smart_battery"]
