"""Explains what only the dialect knows: a message or a field that no table populates, and an unanswered command."""

from collections.abc import Iterator, Sequence
from textwrap import fill

from codegen.explain.commands import unanswered_command_story
from codegen.explain.corrections import correction_facts
from codegen.explain.text import facts
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.system import System


def dialect_story(topic: str, system: System) -> str | None:
    """The story of a message, a field of one, or a command of the dialect, whatever the program does with it."""
    name, _, field = topic.partition(".")
    wire = system.dialect.messages.get(name.upper())
    if wire is not None:
        return _unpopulated(wire) if not field else _unpopulated_field(wire, field, system)
    story = unanswered_command_story(topic, system)
    return None if story is None else "\n".join([story[0], story[1].strip(), "", *facts(story[2])]) + "\n"


def without_it(topic: str, systems: Sequence[System]) -> Iterator[str]:
    """Return the line that names programs without a message or a command of the dialect; of other things none."""
    names = ", ".join(system.spec.program or system.spec.project.project for system in systems)
    if topic.partition(".")[0].upper() in systems[0].dialect.messages:
        yield f"No table of {names} populates or takes it.\n"
    elif unanswered_command_story(topic, systems[0]) is not None:
        yield f"Not answered by {names}.\n"


def attributes(field: WireField) -> list[tuple[str, str]]:
    """Return what the dialect states beside unit, enum and sentinel."""
    stated = field.definition
    is_limited = stated.minimum is not None or stated.maximum is not None
    return [
        ("range", f"{stated.minimum or ''}..{stated.maximum or ''}" if is_limited else ""),
        ("increment", stated.increment or ""),
        ("default", stated.default or ""),
        ("printed as", stated.print_format or ""),
        ("display", "bits" if stated.is_bitmask else ""),
        ("instance", "tells apart what the messages are about" if stated.is_instance else ""),
    ]


def _unpopulated_field(message: WireMessage, name: str, system: System) -> str | None:
    """A field that no table populates: what the dialect states, corrections included."""
    field = message.field(name)
    if field is None:
        return None
    length = f"[{field.count}]" if field.is_array else ""
    told = [
        ("offset", f"{field.offset}, {field.size} bytes"),
        ("type", field.type.name + length),
        ("unit", field.unit_text),
        ("enum", field.definition.enum or ""),
        *attributes(field),
        ("unknown", f"{field.sentinel.written}  ({field.sentinel.place.shown()})" if field.sentinel else "no sentinel"),
        *correction_facts(system.dialect, message.name, name),
        ("declared at", field.definition.place.shown()),
    ]
    parts = [f"{message.name}.{name}; no table populates it", fill(field.definition.description, 100), ""]
    return "\n".join([*parts, *facts(told)]) + "\n"


def _unpopulated(wire: WireMessage) -> str:
    head = f"{wire.name} ({wire.id}), CRC_EXTRA {wire.crc_extra}, payload {wire.base_length} bytes"
    lines = [
        f"{head}, {wire.length} with extensions; no table populates it",
        fill(wire.definition.description, 100),
        "",
    ]
    for field in wire.fields:
        length = f"[{field.count}]" if field.is_array else ""
        unit = field.unit_text
        sentinel = f"unknown {field.sentinel.written}" if field.sentinel else ""
        facts = (
            f"{field.offset:>4} {field.size:>4}  {field.name:<32} {field.type.name + length:<14} {unit:<8} {sentinel}"
        )
        lines.append(facts.rstrip())
    return "\n".join(lines) + "\n"
