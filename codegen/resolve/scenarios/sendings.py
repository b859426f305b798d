"""Resolves a message that a scenario sends to the vehicle: from its fields to the bytes of its payload."""

import math
import struct
from fractions import Fraction

from codegen.diagnostics import Rule, did_you_mean
from codegen.measure import find_unit, read_real
from codegen.model.code.storage import Storage
from codegen.model.dialect.dialect import Kind, WireField, WireMessage
from codegen.model.dialect.literals import LIMITS, exact_number
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.model.listening import deaf_links
from codegen.model.scenario import GROUND_STATION, Sending
from codegen.model.spec.scenario import EventSpec
from codegen.model.system import System
from codegen.pattern import pattern
from codegen.resolve.scenarios.values import ScenarioValues
from codegen.source import Place

SCENARIO_SEND = Rule(
    "scenario-send",
    "A scenario sends a message of the dialect: fields by their names, field[1] for an element, what is not listed is "
    "0, or the vehicle's own ids for its target. A value is a number in the unit of the field, an amount in any unit "
    "that fits, an entry of its enum, a limit of a type such as INT32_MAX, NaN or .inf in a float, a text.",
    remedy="write values that the field has: a number, an amount in its unit, an entry of its enum",
)
_NO_NUMBERS = {"nan": math.nan, "inf": math.inf, "-inf": -math.inf}
_NAME = pattern(r"(\w+)(?:\[([0-9]{1,3})\])?")


def sending(event: EventSpec, at_ms: int, system: System, values: ScenarioValues) -> Sending | None:
    """Return what an event sends; None after an error."""
    name = event.send or ""
    wire = system.dialect.messages.get(name)
    if wire is None:
        hint = did_you_mean(name, system.dialect.messages)
        values.say(SCENARIO_SEND, event.at("send"), f"{system.dialect.name} has no message {name}", hint)
        return None
    if system.links and len(deaf_links(system)) == len(system.links):
        message = f"no link takes what a scenario sends, unsigned and as system {GROUND_STATION}"
        values.say(SCENARIO_SEND, event.at("send"), message, "open a link in access, or list that station")
        return None
    payload = bytearray(wire.length)
    for field, number in ((wire.target_system, system.system_id), (wire.target_component, system.component_id)):
        if field is not None:
            payload[field.offset] = number
    for written, text in event.fields.items():
        _put(payload, wire, written, text, event.at(f"fields.{written}"), values)
    if name == "PARAM_SET" and system.is_bytewise:
        _put_bytewise(payload, wire, event, system, values)
    every_ms = None if event.every is None else values.milliseconds(event.every, event.at("every"), 1)
    for_ms = None if event.for_ is None else values.milliseconds(event.for_, event.at("for"), 1)
    until_ms = None if for_ms is None else at_ms + for_ms
    cut = bytes(payload).rstrip(b"\0") or bytes(1)  # as MAVLink 2 does
    return Sending(at_ms, name, wire.id, wire.crc_extra, cut, every_ms, until_ms)


def _put(payload: bytearray, wire: WireMessage, written: str, text: str, place: Place, values: ScenarioValues) -> None:
    """Put a value into its field; nothing after a finding."""
    match = _NAME.fullmatch(written)
    field = wire.field(match[1]) if match else None
    if match is None or field is None:
        hint = did_you_mean(written, [each.name for each in wire.fields])
        values.say(SCENARIO_SEND, place, f"{wire.name} has no field {written}", hint)
        return
    element = int(match[2] or 0)
    if element >= field.count or (match[2] and not field.is_array):
        values.say(
            SCENARIO_SEND,
            place,
            f"{field.name} has {field.count} elements",
            hint=f"write {field.name}[0] to {field.name}[{field.count - 1}]"
            if field.is_array
            else f"write {field.name}",
        )
        return
    if field.type.kind is Kind.CHAR:
        data = text.encode()
        if len(data) > field.size:
            values.say(
                SCENARIO_SEND,
                place,
                f"{text!r} has more than the {field.size} bytes of {field.name}",
                hint="shorten it",
            )
            return
        payload[field.offset : field.offset + len(data)] = data
        return
    number = _number(text, field, wire, place, values)
    if number is not None:
        struct.pack_into(f"<{field.type.code}", payload, field.offset + element * field.type.size, number)


def _put_bytewise(
    payload: bytearray, wire: WireMessage, event: EventSpec, system: System, values: ScenarioValues
) -> None:
    """Put a number for a whole parameter as the bytes of its type, which is the parameter's where none is written."""
    carried, kind = wire.field("param_value"), wire.field("param_type")
    enum = system.dialect.enums.get("MAV_PARAM_TYPE")
    parameter = system.parameters.get(event.fields.get("param_id", ""))
    assert carried is not None  # SERVICE_FIELDS: the dialect has them
    assert kind is not None
    entries = enum.entries if enum else ()
    if "param_type" not in event.fields and parameter is not None:
        own = f"MAV_PARAM_TYPE_{parameter.spec.type.upper()}"
        payload[kind.offset] = next(entry.value for entry in entries if entry.name == own)
    name = next((entry.name for entry in entries if entry.value == payload[kind.offset]), "")
    whole = WIRE_TYPES.get(f"{name.removeprefix('MAV_PARAM_TYPE_').lower()}_t")
    text = event.fields.get("param_value", "0")
    if whole is None or not whole.is_integer or whole.size > carried.size:
        return
    number = _exact(text)
    if number is None:
        return  # after a finding
    if number.denominator != 1 or not whole.minimum <= number <= whole.maximum:
        place, hint = event.at("fields.param_value"), f"write {whole.minimum} to {whole.maximum}, or another param_type"
        values.say(SCENARIO_SEND, place, f"{name} carries whole numbers of its range, not {text}", hint)
        return
    payload[carried.offset : carried.offset + carried.size] = bytes(carried.size)
    struct.pack_into(f"<{whole.code}", payload, carried.offset, int(number))


def _number(text: str, field: WireField, wire: WireMessage, place: Place, values: ScenarioValues) -> float | int | None:
    """Return what a field carries for a text; None after a finding."""
    value: Fraction | float | None
    no_number = _NO_NUMBERS.get(text.lower().replace(".", "", 1))  # YAML writes .nan
    if no_number is not None:
        if not field.type.is_integer:
            return no_number
        message = f"{wire.name}.{field.name} is {field.type.name}, which has whole numbers only"
        values.say(SCENARIO_SEND, place, message, "write a number, or the limit of its type that means as much")
        return None
    exact = _exact(text)
    if exact is not None:
        value = exact if text in LIMITS else exact / field.multiplier
    else:
        value = _named(text, field, place, values)
    if value is None:
        return None
    if not field.type.is_integer:
        most = Fraction(Storage(field.type.code).limits[1])
        if -most <= value <= most:
            return float(value)
        message = f"{wire.name}.{field.name} carries up to {float(most):.7g}, not {text}"
        values.say(SCENARIO_SEND, place, message, "write a number that a float of its size has")
        return None
    number = round(value)
    if not field.type.minimum <= number <= field.type.maximum:
        low, high = field.type.minimum, field.type.maximum
        values.say(
            SCENARIO_SEND,
            place,
            f"{wire.name}.{field.name} carries {low} to {high}, not {text}",
            hint=f"the nearest is {low if number < low else high}",
        )
        return None
    return number


def _exact(text: str) -> Fraction | None:
    """Return the number that a text is, or the limit of a type; None where it is neither."""
    return Fraction(LIMITS[text]) if text in LIMITS else exact_number(text)


def _named(text: str, field: WireField, place: Place, values: ScenarioValues) -> Fraction | float | None:
    """An entry of the field's enum, or an amount in its unit; None after a finding."""
    enum = values.enums.get(field.definition.enum or "")
    entry = enum.entry(text) if enum else None
    if entry is not None:
        return Fraction(entry.value)
    if enum is not None:
        hint = did_you_mean(text, [each.name for each in enum.entries])
        values.say(SCENARIO_SEND, place, f"{enum.name} has no entry {text}", hint)
        return None
    unit = find_unit(field.definition.units, place, values.report)
    amount = None if unit is None else read_real(text, unit, place, values.report)
    values.is_good = values.is_good and amount is not None
    return None if amount is None else amount / float(field.multiplier)
