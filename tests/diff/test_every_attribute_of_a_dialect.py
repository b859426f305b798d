"""Nothing that changes in a dialect is missed: each attribute of each kind of record is changed, its rule expected."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from typing import Any

import pytest

from codegen.decode.dialect.files import decode_dialect_files
from codegen.diagnostics import Report
from codegen.diff.dialect.dialect import dialect_changes
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_path
from codegen.model.dialect.dialect import (
    CommandParameter,
    Dialect,
    EnumDefinition,
    EnumEntry,
    FieldDefinition,
    Lifecycle,
    MessageDefinition,
    Sentinel,
    SentinelForm,
    WireField,
    WireMessage,
)
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.resolve.dialect.dialect import resolve_dialect
from codegen.source import Place

ELSEWHERE = Place("/elsewhere.xml", 7, 3)

UNSEEN = {
    (Dialect, "name"): "reports name both sides by what the user called them",
    (Dialect, "files"): "messages that moved between included files are no change",
    (Dialect, "digest"): "a hash of all that the other attributes come from",
    (Dialect, "overlays"): "which file adds a message is no change of it",
    (Dialect, "known"): "names of other dialects, for a check",
    (Dialect, "corrections"): "what they change is seen in the fields",
    (WireField, "multiplier"): "compared as the definition states it",
    (WireMessage, "definition"): "its own attributes are changed below",
    (WireField, "definition"): "its own attributes are changed below",
    (MessageDefinition, "fields"): "the order in the XML counts only as far as it is that of the wire",
    (MessageDefinition, "written_id"): "of an id that cannot be read there is no resolved message",
    (MessageDefinition, "id_place"): "where a correction stands",
    (FieldDefinition, "invalid"): "compared as the sentinel that it resolves to",
    (Sentinel, "written"): "0xFFFF for UINT16_MAX means the same",
    (EnumEntry, "is_implicit"): "whether the number was written does not change it",
    **{
        (record, "place"): "where it stands is no change"
        for record in (MessageDefinition, FieldDefinition, Sentinel, EnumDefinition, EnumEntry, CommandParameter)
    },
}
"""Attributes of which a change is none, and why."""

RECORDS = (
    *(Dialect, WireMessage, MessageDefinition, WireField, FieldDefinition, Sentinel),
    *(EnumDefinition, EnumEntry, CommandParameter, Lifecycle),
)


def attributes(record: type) -> list[str]:
    return list(record._fields) if hasattr(record, "_fields") else [field.name for field in fields(record)]


def with_value(record: Any, attribute: str, value: Any) -> Any:
    changed = {attribute: value}
    return record._replace(**changed) if hasattr(record, "_replace") else replace(record, **changed)


@dataclass(frozen=True)
class Mutation:
    """One attribute of one kind of record, how it is changed, and the rules that tell: of it, and of what follows."""

    record: type
    attribute: str
    change: Callable[[Any], Any]
    rules: frozenset[str]

    def __str__(self) -> str:
        return f"{self.record.__name__}.{self.attribute}"


def mutation(record: type, attribute: str, change: Callable[[Any], Any], *rules: str) -> Mutation:
    return Mutation(record, attribute, change, frozenset(rules))


def other_type(name: str) -> str:
    return {"float": "int32_t", "char": "uint8_t", "uint16_t": "int16_t"}.get(name, "uint16_t")


LIFE = "lifecycle-changed"
MUTATIONS = (
    mutation(Dialect, "version", lambda value: value + 1, "dialect-version-changed"),
    mutation(Dialect, "messages", lambda value: dict(list(value.items())[1:]), "message-removed"),
    mutation(Dialect, "enums", lambda value: dict(list(value.items())[1:]), "enum-removed"),
    mutation(WireMessage, "fields", lambda value: value[:-1], "field-removed"),
    mutation(WireMessage, "crc_extra", lambda value: value ^ 1, "crc-extra-changed"),
    mutation(WireMessage, "base_length", lambda value: value + 1, "payload-layout-changed"),
    mutation(WireMessage, "length", lambda value: value + 1, "payload-layout-changed"),
    mutation(MessageDefinition, "id", lambda value: value + 100_000, "message-id-changed"),
    mutation(MessageDefinition, "name", lambda value: f"{value}_X", "message-renamed"),
    mutation(MessageDefinition, "description", lambda value: f"{value} More.", "description-changed"),
    mutation(MessageDefinition, "lifecycle", lambda value: replace(value, wip=not value.wip), LIFE),
    mutation(WireField, "type", lambda value: WIRE_TYPES[other_type(value.name)], "field-type-changed"),
    mutation(WireField, "offset", lambda value: value + 1, "payload-layout-changed"),
    mutation(WireField, "count", lambda value: value + 1, "field-type-changed"),
    mutation(
        WireField,
        "sentinel",
        lambda value: Sentinel(SentinelForm.VALUE, (77,), "77", ELSEWHERE) if value is None else None,
        "field-sentinel-changed",
    ),
    mutation(FieldDefinition, "name", lambda value: f"{value}_x", "field-renamed"),
    mutation(FieldDefinition, "type", other_type, "field-type-changed"),
    mutation(FieldDefinition, "length", lambda value: 1 if value is None else value + 1, "field-type-changed"),
    mutation(FieldDefinition, "is_extension", lambda value: not value, "extension-boundary-moved"),
    mutation(FieldDefinition, "units", lambda value: "m" if value != "m" else "km", "field-units-changed"),
    mutation(FieldDefinition, "enum", lambda value: "OTHER" if value is None else None, "field-enum-changed"),
    mutation(FieldDefinition, "is_bitmask", lambda value: not value, "field-display-changed"),
    mutation(FieldDefinition, "is_instance", lambda value: not value, "field-instance-changed"),
    mutation(
        FieldDefinition, "multiplier", lambda value: "1E-3" if value is None else None, "field-multiplier-changed"
    ),
    mutation(FieldDefinition, "minimum", lambda value: "5" if value is None else None, "field-range-changed"),
    mutation(FieldDefinition, "maximum", lambda value: "5" if value is None else None, "field-range-changed"),
    mutation(FieldDefinition, "increment", lambda value: "5" if value is None else None, "field-increment-changed"),
    mutation(FieldDefinition, "unchanged", lambda value: "5" if value is None else None, "field-special-value-changed"),
    mutation(FieldDefinition, "unknown", lambda value: "5" if value is None else None, "field-special-value-changed"),
    mutation(FieldDefinition, "default", lambda value: "5" if value is None else None, "field-default-changed"),
    mutation(FieldDefinition, "print_format", lambda value: None if value else "0x%04x", "print-format-changed"),
    mutation(FieldDefinition, "description", lambda value: f"{value} More.", "description-changed"),
    mutation(
        Sentinel,
        "form",
        lambda value: SentinelForm.EACH if value is not SentinelForm.EACH else SentinelForm.FIRST,
        "field-sentinel-changed",
    ),
    mutation(Sentinel, "values", lambda value: (99, *value[1:]), "field-sentinel-changed"),
    mutation(EnumDefinition, "name", lambda value: f"{value}_X", "enum-added", "enum-removed"),
    mutation(EnumDefinition, "entries", lambda value: value[1:], "enum-entry-removed"),
    mutation(EnumDefinition, "is_bitmask", lambda value: not value, "enum-bitmask-changed"),
    mutation(EnumDefinition, "description", lambda value: f"{value} More.", "description-changed"),
    mutation(EnumDefinition, "lifecycle", lambda value: replace(value, wip=not value.wip), LIFE),
    mutation(EnumEntry, "name", lambda value: f"{value}_X", "enum-entry-renamed"),
    mutation(EnumEntry, "value", lambda value: value + 1_000_000, "enum-entry-value-changed"),
    mutation(EnumEntry, "description", lambda value: f"{value} More.", "description-changed"),
    mutation(EnumEntry, "lifecycle", lambda value: replace(value, wip=not value.wip), LIFE),
    mutation(
        EnumEntry,
        "parameters",
        lambda value: value[1:] if value else (CommandParameter("1", (("label", "L"),), "", ELSEWHERE),),
        "command-parameter-changed",
        *("description-changed",),
    ),
    mutation(EnumEntry, "traits", lambda value: (*value, ("isDestination", "x")), "enum-entry-traits-changed"),
    mutation(CommandParameter, "number", lambda value: f"{value}1", "command-parameter-changed", "description-changed"),
    mutation(CommandParameter, "attributes", lambda value: (*value, ("increment", "7")), "command-parameter-changed"),
    mutation(CommandParameter, "description", lambda value: f"{value} More.", "description-changed"),
    mutation(Lifecycle, "wip", lambda value: not value, LIFE),
    mutation(Lifecycle, "deprecated_since", lambda value: f"{value} 2026-01", LIFE),
    mutation(Lifecycle, "superseded_since", lambda value: f"{value} 2026-01", LIFE),
    mutation(Lifecycle, "replaced_by", lambda value: f"{value}X", LIFE),
    mutation(Lifecycle, "remark", lambda value: f"{value} Indeed.", LIFE),
)


@pytest.fixture(scope="module")
def dialect() -> Dialect:
    """Some forty messages of the real dialect with their enums, so that each comparison takes a moment only."""
    path = shipped_dialect_path("common", DISK)
    assert path is not None
    whole = resolve_dialect("common", decode_dialect_files(path, DISK, Report()), (), Report())
    messages = dict(list(whole.messages.items())[::5])
    used = {field.definition.enum for message in messages.values() for field in message.fields}
    enums = {name: enum for name, enum in whole.enums.items() if name in used or name == "MAV_CMD"}
    return replace(whole, messages=messages, enums=enums)


def sites(dialect: Dialect, record: type) -> Iterator[tuple[str, Place, Any, Callable[[Any], Dialect]]]:
    """Every record of a kind: its name in reports, its place, itself, and the dialect with another in its place."""
    if record is Dialect:
        yield "", ELSEWHERE, dialect, lambda other: other
    for message in dialect.messages.values():
        yield from _in_message(dialect, message, record)
    for enum in dialect.enums.values():
        yield from _in_enum(dialect, enum, record)


def _in_message(dialect: Dialect, message: WireMessage, record: type) -> Iterator[Any]:
    definition = message.definition

    def put(other: WireMessage) -> Dialect:
        return replace(dialect, messages={(other if one is message else one).name: other if one is message else one
                                          for one in dialect.messages.values()})  # fmt: skip

    if record is WireMessage:
        yield message.name, definition.place, message, put
    elif record is MessageDefinition:
        yield message.name, definition.place, definition, lambda other: put(replace(message, definition=other))
    elif record is Lifecycle:
        yield (
            message.name,
            definition.place,
            definition.lifecycle,
            lambda other: put(replace(message, definition=replace(definition, lifecycle=other))),
        )
    for field in message.fields:

        def put_field(other: WireField, field: WireField = field) -> Dialect:
            return put(replace(message, fields=tuple(other if one is field else one for one in message.fields)))

        name, place = f"{message.name}.{field.name}", field.definition.place
        if record is WireField:
            yield name, place, field, put_field
        elif record is FieldDefinition:
            yield name, place, field.definition, lambda other, f=field, p=put_field: p(replace(f, definition=other))
        elif record is Sentinel and field.sentinel is not None:
            yield name, field.sentinel.place, field.sentinel, lambda o, f=field, p=put_field: p(replace(f, sentinel=o))


def _in_enum(dialect: Dialect, enum: EnumDefinition, record: type) -> Iterator[Any]:
    def put(other: EnumDefinition) -> Dialect:
        return replace(dialect, enums={(other if one is enum else one).name: other if one is enum else one
                                       for one in dialect.enums.values()})  # fmt: skip

    if record is EnumDefinition:
        yield enum.name, enum.place, enum, put
    elif record is Lifecycle:
        yield enum.name, enum.place, enum.lifecycle, lambda other: put(replace(enum, lifecycle=other))
    for entry in enum.entries:
        yield from _in_entry(enum, entry, record, put)


def _in_entry(
    enum: EnumDefinition, entry: EnumEntry, record: type, put: Callable[[EnumDefinition], Dialect]
) -> Iterator[Any]:
    def put_entry(other: EnumEntry) -> Dialect:
        return put(replace(enum, entries=tuple(other if one is entry else one for one in enum.entries)))

    name = f"{enum.name}.{entry.name}"
    if record is EnumEntry:
        yield name, entry.place, entry, put_entry
    elif record is Lifecycle:
        yield name, entry.place, entry.lifecycle, lambda other: put_entry(entry._replace(lifecycle=other))
    elif record is CommandParameter:
        for parameter in entry.parameters:

            def put_one(other: CommandParameter, parameter: CommandParameter = parameter) -> Dialect:
                kept = tuple(other if one is parameter else one for one in entry.parameters)
                return put_entry(entry._replace(parameters=kept))

            yield f"{name}.{parameter.number}", parameter.place, parameter, put_one


@pytest.mark.parametrize("record", RECORDS, ids=lambda record: record.__name__)
def test_each_attribute_is_changed_below_or_is_no_change_for_a_reason(record: type) -> None:
    """A new attribute of the model has to be given a rule, or a reason why none tells of it."""
    changed = {one.attribute for one in MUTATIONS if one.record is record}
    unseen = {name for kind, name in UNSEEN if kind is record}
    assert changed | unseen == set(attributes(record))
    assert not changed & unseen


@pytest.mark.parametrize("mutation", MUTATIONS, ids=str)
def test_a_changed_attribute_is_told_by_its_rule_at_its_place(mutation: Mutation, dialect: Dialect) -> None:
    """Each of up to 12 records: one change at least, of the expected rules only, about the record, at its line."""
    found = list(sites(dialect, mutation.record))
    for name, place, record, put in found[:: max(1, len(found) // 12)]:
        value = getattr(record, mutation.attribute)
        new = put(with_value(record, mutation.attribute, mutation.change(value)))
        changes = dialect_changes(dialect, new)
        rules = {change.rule.id for change in changes}
        assert rules, f"{name}: nothing told"
        assert rules <= mutation.rules, f"{name}: {rules}"
        assert sorted(mutation.rules)[0] in rules, f"{name}: {rules}"
        if mutation.record is not Dialect:
            assert all(change.subject.startswith(name.partition(".")[0]) for change in changes), name
            places = {side for change in changes for side in (change.place, change.was_at)}
            below = {one.definition.place for one in getattr(record, "fields", ()) if isinstance(one, WireField)}
            below |= {one.place for one in getattr(record, "entries", ())}
            assert places & {place, ELSEWHERE, *below}, f"{name}: {places}"


@pytest.mark.parametrize(
    ("record", "attribute"),
    [one for one in UNSEEN if one[1] != "definition"],
    ids=lambda one: one if isinstance(one, str) else one.__name__,
)
def test_what_is_no_change_is_not_told(record: type, attribute: str, dialect: Dialect) -> None:
    """Otherwise a diff of two releases would be full of it."""
    others: dict[str, Any] = {
        "name": "x",
        "files": ("/a.xml",),
        "digest": "another",
        "overlays": frozenset({"/a.xml"}),
        "known": (),
        "corrections": (),
        "multiplier": Fraction(7),
        "written_id": "x",
        "id_place": ELSEWHERE,
        "invalid": "12345",
        "written": "12345",
        "is_implicit": True,
        "place": ELSEWHERE,
        "fields": (),
    }
    for _, _, one, put in list(sites(dialect, record))[::9]:
        assert dialect_changes(dialect, put(with_value(one, attribute, others[attribute]))) == ()
