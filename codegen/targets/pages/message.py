"""The page of one message: its bytes in several states, its fields, and the way of each value to the wire."""

from codegen.frozen import dataclass
from codegen.model.answers.account import FLAGS
from codegen.model.answers.step import Step
from codegen.model.price import frame_size, message_price
from codegen.model.system import PopulatedMessage, System
from codegen.model.units.unit import decimal
from codegen.summaries.fields import FieldRow, field_rows, others_of, withheld_of
from codegen.summaries.generations import sent_at_once
from codegen.targets.origin import Origin, source_name
from codegen.targets.pages.byte_map import ByteMap, byte_map
from codegen.targets.pages.example_state import example_states
from codegen.targets.pages.navigation import Navigation, message_path, navigation
from codegen.targets.pages.value_text import kind_of
from codegen.targets.pages.way import way_of

_KINDS = {
    "unsigned": "unsigned integer (u)",
    "signed": "signed integer (i)",
    "float": "float (f)",
    "text": "text (char)",
    "enum": "entry of an enum",
    "flags": "flags (bits)",
}


@dataclass(frozen=True, slots=True)
class FieldView:
    """A row of the table of fields, with the steps from sensor to wire.

    ``line`` is that of its answer in the message's table.
    ``sources`` is the row's source in lines: one for each flag.
    """

    number: int
    kind: str
    row: FieldRow
    sources: tuple[str, ...]
    line: int
    steps: tuple[Step, ...]


@dataclass(frozen=True, slots=True)
class MessagePage:
    """The page, ready to print. ``facts`` are names with their values, ``kinds`` the classes of fields with words."""

    project: str
    origin: Origin
    navigation: Navigation
    name: str
    criterion: str
    criterion_text: str
    table: str
    facts: tuple[tuple[str, str], ...]
    maps: tuple[ByteMap, ...]
    kinds: tuple[tuple[str, str], ...]
    has_unknown: bool
    has_cut: bool
    fields: tuple[FieldView, ...]


def message_page(message: PopulatedMessage, system: System, origin: Origin) -> MessagePage:
    """The page of a message."""
    numbers = {
        (answer.covers.field.name, answer.covers.first + index): number
        for number, answer in enumerate(message.answers, 1)
        for index in range(answer.covers.count)
    }
    maps = tuple(
        byte_map(message, state, numbers, system, f"state-{index}")
        for index, state in enumerate(example_states(message, system), 1)
    )
    fields = tuple(
        FieldView(
            number=number,
            kind=kind_of(answer.covers.field, system.dialect.enums),
            row=row,
            sources=tuple(row.source.split(FLAGS)),
            line=row.place.line,
            steps=way_of(answer, row, system),
        )
        for number, (answer, row) in enumerate(zip(message.answers, field_rows(message), strict=True), 1)
    )
    used = {field.kind for field in fields}
    pieces = [piece for shown in maps for line in shown.lines for block in line for piece in block.pieces]
    citation = message.citation
    return MessagePage(
        project=system.spec.project.project,
        origin=origin,
        navigation=navigation(system, message_path(message.name)),
        name=message.name,
        criterion=str(citation),
        criterion_text=citation.criterion.text if citation.criterion else citation.requirement.title,
        table=source_name(system, message.population.place.file),
        facts=_facts(message, system),
        maps=maps,
        kinds=tuple((kind, words) for kind, words in _KINDS.items() if kind in used),
        has_unknown=any(piece.is_unknown for piece in pieces),
        has_cut=any(block.cut for shown in maps for line in shown.lines for block in line),
        fields=fields,
    )


def _facts(message: PopulatedMessage, system: System) -> tuple[tuple[str, str], ...]:
    wire = message.wire
    length = f"{wire.length} bytes"
    if wire.length != wire.base_length:
        length += f", {wire.base_length} of them base"
    sizes = dict.fromkeys(
        str(frame_size(message, instance, system.spec.project.protocol)) for instance in range(message.instances)
    )
    price = message_price(message, system)
    facts = [
        *([("Message", wire.name)] if message.name != wire.name else []),
        ("Id", str(wire.id)),
        ("CRC_EXTRA", str(wire.crc_extra)),
        ("Payload", length),
        ("Frame", f"{' / '.join(sizes)} bytes"),
        ("Sent", rate_text(message)),
    ]
    if message.is_announced:
        facts.append(("And at once", sent_at_once(message)))
    if message.stream is not None:
        facts.append(("By default", f"{price.whole} bytes/s"))
    if message.component is not None:
        on = f", {sum(price.is_on)} on by default" if message.instances > 1 else ""
        facts.append((f"For each {message.component.name}", f"{message.instances}{on}"))
    if others_of(message):
        facts.append(("Unknown, as not listed", others_of(message)))
    if message.withheld_for:
        facts.append(("Withheld while unknown", withheld_of(message)))
    if message.pages > 1:
        facts.append(("Pages", str(message.pages)))
    facts += [
        (f"Generation of {generations.component.name} messages", "old" if message.name in generations.old else "new")
        for generations in system.generations
        if message.name in (*generations.old, *generations.new)
    ]
    return tuple(facts)


def rate_text(message: PopulatedMessage) -> str:
    """Return how often a message is sent by default: ``2 Hz, set by SR0_EXTRA1``."""
    stream = message.stream
    if stream is None:
        return "on request"
    return f"{decimal(stream.default_rate)} Hz" + (f", set by {stream.parameter.name}" if stream.parameter else "")
