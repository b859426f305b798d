"""One table of a received message: the fields that it takes, and what else it asks of the message."""

import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.dialect.dialect import Kind, WireField, WireMessage
from codegen.model.reception import ReceivedField, Reception
from codegen.model.spec.receive import ReceivedFieldSpec, ReceiveSpec
from codegen.pattern import pattern
from codegen.resolve.citation import cite, cite_aspects
from codegen.resolve.population.elements import ANSWERED_TWICE, UNKNOWN_ELEMENT, UNKNOWN_FIELD, answered_ranges
from codegen.resolve.population.population import BAD_TABLE_NAME, UNKNOWN_MESSAGE, Parts
from codegen.resolve.program.services import HEAD_ONLY
from codegen.resolve.quantities.kept import UNKNOWN_ENTRY
from codegen.resolve.quantities.quantity import LONGEST_NAME
from codegen.resolve.receptions.provisos import resolve_provisos
from codegen.resolve.receptions.taken_field import resolve_taken
from codegen.source import Place

NOTHING_RECEIVES = Rule(
    "nothing-receives",
    "A table in receives/ is for a message that the program never sees: the project has no vehicle.yaml, which "
    "describes the program that reads the links, or the message is one of which the services read a part only.",
    remedy="describe the program in vehicle.yaml, or remove the table",
)
BAD_CONDITION = Rule(
    "bad-condition",
    "'where' names a field that is no single whole number, a number that the field cannot carry, so that no message "
    "would ever be taken, or one flag of a bitmask, with which no other one could be set.",
    remedy="name a field of whole numbers of 8 or 16 bits, and a number that it carries",
)
_ELEMENT = pattern(r"(\w+)(\[.*\])?")


def resolve_reception(spec: ReceiveSpec, parts: Parts, report: Report) -> Reception | None:
    """The table; None after a finding without which nothing can be said of it."""
    wire = parts.dialect.messages.get(spec.receive)
    if wire is None:
        hint = did_you_mean(spec.receive, parts.dialect.messages)
        message = f"{parts.dialect.name} has no message {spec.receive}"
        report.add(UNKNOWN_MESSAGE, spec.at("receive"), message, hint)
    _check_name(spec, parts, report)
    if parts.spec.vehicle is None:
        hint = "describe the program in vehicle.yaml"
        report.add(NOTHING_RECEIVES, spec.at("receive"), f"nothing receives {spec.receive}: there is no program", hint)
    elif spec.receive in HEAD_ONLY:
        message = f"the services read the beginning of {spec.receive} only, so its fields are not there to be taken"
        report.add(
            NOTHING_RECEIVES, spec.at("receive"), message, hint="remove the table: the services answer the message"
        )
    citation = cite(spec.requirement, spec.at("requirement"), parts.requirements, report)
    aspects = cite_aspects(spec, parts.requirements, report)
    if wire is None:
        return None
    conditions = tuple(_conditions(spec, wire, parts, report))
    demanded = {field.name: number for field, number in conditions}
    fields: list[ReceivedField] = []
    places: dict[tuple[str, int], Place] = {}
    for key, written in spec.fields.items():
        for field, element in _elements(key, written, wire, report):
            earlier = places.setdefault((field.name, element), written.place)
            if earlier is not written.place:
                message = f"{wire.name}.{key} is taken twice"
                report.add(
                    ANSWERED_TWICE,
                    written.place,
                    message,
                    related=[(earlier, "the first time is here")],
                    hint="keep one of them",
                )
            taken = _taken(field, element, written, spec, parts, report)
            provisos = resolve_provisos(written, field, wire, demanded, parts.dialect, report)
            fields += [] if taken is None else [replace(taken, provisos=provisos)]
    if citation is None:
        return None
    fields.sort(key=lambda each: each.offset)
    return Reception(citation, aspects, wire, tuple(fields), conditions, spec)


def _check_name(spec: ReceiveSpec, parts: Parts, report: Report) -> None:
    name = spec.named
    if name is None:
        return
    problem, hint = None, "choose another name"
    if not re.fullmatch(rf"[a-z][a-z0-9_]{{0,{LONGEST_NAME - 1}}}", name):
        problem, hint = "is no name of a table", "write it like 'stick' or 'second_gps'"
    elif name.upper() == spec.receive:
        problem, hint = "says nothing: a table is called like its message anyway", "leave it out"
    elif name.upper() in parts.dialect.messages:
        problem = f"is the name of another message, {name.upper()}"
    if problem is not None:
        report.add(BAD_TABLE_NAME, spec.at("as"), f"{name!r} {problem}", hint)


def _elements(
    key: str, written: ReceivedFieldSpec, wire: WireMessage, report: Report
) -> Iterator[tuple[WireField, int]]:
    """The one element that a key names; nothing after a finding."""
    match = _ELEMENT.fullmatch(key)
    field = wire.field(match[1]) if match else None
    if field is None:
        known = [each.name for each in wire.fields]
        message = f"{wire.name} has no field {key}"
        report.add(UNKNOWN_FIELD, written.place, message, lambda: did_you_mean(key, known))
        return
    ranges = list(answered_ranges(key, wire))
    is_text = field.type.kind is Kind.CHAR
    if not ranges or (match and match[2] and (is_text or not field.is_array)):
        what = "a text, taken as a whole" if is_text else f"{field.count} elements, from 0"
        report.add(
            UNKNOWN_ELEMENT,
            written.place,
            f"{key!r} is no element: {field.name} has {what}",
            hint=f"write {field.name}" if is_text else f"write {field.name}[0]",
        )
        return
    ((_, first, count),) = ranges
    if count != 1 and not is_text:
        message = f"{key} has {count} elements, and each sets a quantity of its own"
        report.add(UNKNOWN_ELEMENT, written.place, message, f"write {field.name}[{first}]")
        return
    yield field, first


def _taken(
    field: WireField, element: int, written: ReceivedFieldSpec, spec: ReceiveSpec, parts: Parts, report: Report
) -> ReceivedField | None:
    text, place = written.requirement, written.at("requirement")
    if text is None:
        text, place = spec.requirement, spec.at("requirement")
        citation = cite(text, place, parts.requirements, Report())
    else:
        citation = cite(text, place, parts.requirements, report)
    return resolve_taken(field, element, written, citation, parts, report)


def _conditions(spec: ReceiveSpec, wire: WireMessage, parts: Parts, report: Report) -> Iterator[tuple[WireField, int]]:
    """The fields that decide whether the message is taken, with their numbers."""
    for name, written in spec.where.items():
        place = spec.at(f"where.{name}")
        field = wire.field(name)
        if field is None:
            hint = did_you_mean(name, [each.name for each in wire.fields])
            report.add(UNKNOWN_FIELD, place, f"{wire.name} has no field {name}", hint)
            continue
        if field.is_array or not field.type.is_integer or field.type.size > 2:
            message = f"{name} is {field.type.name}{'[]' if field.is_array else ''}, no whole number of up to 16 bits"
            report.add(BAD_CONDITION, place, message)
            continue
        number = written
        if isinstance(written, str):
            enum = parts.dialect.enums.get(field.definition.enum or "")
            entry = enum.entry(written) if enum else None
            if entry is None:
                known = [each.name for each in enum.entries] if enum else []
                message = f"{field.definition.enum or name} has no entry {written}"
                report.add(UNKNOWN_ENTRY, place, message, did_you_mean(written, known))
                continue
            number = Fraction(entry.value)
            if number and field.definition.is_bitmask:  # an enum of flags makes it one
                message = f"{name} has flags: a message is taken only if {written} is set and no other one"
                hint = f"when: {{{name}: {written}}} at each field looks at this flag, {name}: {number} at all of them"
                report.add(BAD_CONDITION, place, message, hint)
                continue
        assert isinstance(number, Fraction)
        if number.denominator != 1 or not field.type.minimum <= number <= field.type.maximum:
            message = f"{name} carries whole numbers from {field.type.minimum} to {field.type.maximum}"
            report.add(BAD_CONDITION, place, message)
            continue
        yield field, int(number)
