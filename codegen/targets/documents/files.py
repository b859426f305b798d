"""Review documents: the resolved system as tables that are committed, so that their diff shows what a change does."""

from dataclasses import replace

from codegen.frozen import dataclass
from codegen.model.quantities.reach import Reach, reach_words, reaches
from codegen.model.reception import Reception
from codegen.model.system import PopulatedMessage, System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Citation, Parameter, Quantity, Stream
from codegen.render.rendered import rendered
from codegen.summaries.fields import FieldRow, field_rows, in_table, others_of, withheld_of
from codegen.summaries.generations import GenerationTable, generation_tables, sent_at_once
from codegen.summaries.parameters import encoding_words, uses
from codegen.summaries.receptions import ReceivedRow, condition_words, received_rows, sender_words
from codegen.targets.documents.program import (
    LinkRow,
    ProgramSection,
    StreamRow,
    link_rows,
    program_section,
    stream_rows,
)
from codegen.targets.firmware.messages.receiving import call_name
from codegen.targets.origin import origin_of, source_name


@dataclass(frozen=True, slots=True)
class MessageDocument:
    """One message with its fields."""

    title: str
    crc_extra: int
    base_length: int
    length: int
    rate: str
    sent_at_once: str
    citation: str
    table: str
    others: str
    withheld: str
    rows: tuple[FieldRow, ...]


@dataclass(frozen=True, slots=True)
class ReceptionDocument:
    """One message that is received, with the fields that set something."""

    title: str
    sender: str
    condition: str
    call: str
    citation: str
    table: str
    rows: tuple[ReceivedRow, ...]
    keeps: bool


@dataclass(frozen=True, slots=True)
class QuantityRow:
    """A quantity of the state: how it is kept, measured and limited."""

    path: str
    kept: str
    limits: str
    source: str
    initial: str
    criterion: str


@dataclass(frozen=True, slots=True)
class ParameterRow:
    """A parameter in its unit."""

    name: str
    type: str
    default: str
    limits: str
    step: str
    values: str
    restart: str
    sets: str
    criterion: str


@dataclass(frozen=True, slots=True)
class CitedCriterion:
    """A criterion that the specification cites, with its text."""

    citation: str
    text: str


@dataclass(frozen=True, slots=True)
class TelemetryDocument:
    """The document: messages in order of id, and the criteria that their fields answer to."""

    project: str
    sources: tuple[str, ...]
    digest: str
    messages: tuple[MessageDocument, ...]
    receptions: tuple[ReceptionDocument, ...]
    quantities: tuple[QuantityRow, ...]
    parameters: tuple[ParameterRow, ...]
    encoding: str
    streams: tuple[StreamRow, ...]
    generations: tuple[GenerationTable, ...]
    links: tuple[LinkRow, ...]
    program: ProgramSection | None
    criteria: tuple[CitedCriterion, ...]


def render_documents(system: System) -> dict[str, str]:
    """The files below ``docs/``."""
    wires = [message.wire for message in system.messages] + [table.wire for table in system.receptions]
    origin = origin_of(system, system.spec.files, wires)
    told = reaches(system)
    view = TelemetryDocument(
        project=system.spec.project.project,
        sources=origin.sources,
        digest=origin.open.digest,
        messages=tuple(_message(message, system) for message in system.messages),
        receptions=tuple(_reception(table, system) for table in system.receptions),
        quantities=tuple(
            _quantity(quantity, told[quantity.path])
            for component in system.components.values()
            for quantity in component.quantities.values()
        ),
        parameters=tuple(_in_table(parameter_row(parameter, system)) for parameter in system.parameters.values()),
        encoding=encoding_words(system),
        streams=stream_rows(system),
        generations=generation_tables(system),
        links=tuple(replace(row, details=in_table(row.details)) for row in link_rows(system)),
        program=program_section(system),
        criteria=tuple(_criteria(system)),
    )
    return {"docs/telemetry.md": origin.closed(rendered("docs/telemetry.md.j2", view))}


def _message(message: PopulatedMessage, system: System) -> MessageDocument:
    return MessageDocument(
        title=message.title,
        crc_extra=message.wire.crc_extra,
        base_length=message.wire.base_length,
        length=message.wire.length,
        rate=_rate(message.stream),
        sent_at_once=sent_at_once(message),
        citation=str(message.citation),
        table=source_name(system, message.population.place.file),
        others=others_of(message),
        withheld=withheld_of(message),
        rows=field_rows(message),
    )


def _reception(table: Reception, system: System) -> ReceptionDocument:
    return ReceptionDocument(
        title=table.title,
        sender=sender_words(table),
        condition=condition_words(table),
        call=call_name(table) if table.spec.call else "",
        citation=str(table.citation),
        table=source_name(system, table.spec.place.file),
        rows=received_rows(table),
        keeps=any(row.unchanged for row in received_rows(table)),
    )


def _rate(stream: Stream | None) -> str:
    if stream is None:
        return "on request"
    rate = f"{decimal(stream.default_rate)} Hz"
    if stream.parameter is not None:
        return f"stream {stream.name}: {stream.parameter.name}, {rate} by default"
    return f"stream {stream.name}: {rate}"


def _quantity(quantity: Quantity, told: Reach) -> QuantityRow:
    return QuantityRow(
        path=quantity.path,
        kept=f"{_counted(quantity)}{quantity.attribute} ({quantity.kept_in})",
        limits=reach_words(quantity, told),
        source=quantity.derivation.words(quantity),
        initial=quantity.start,
        criterion=str(quantity.citation or ""),
    )


def _counted(quantity: Quantity) -> str:
    """``3 in ``, or ``3 and 2 in `` where instances differ."""
    counts = [str(count) for count in quantity.elements or ()]
    return f"{' and '.join(counts if len(set(counts)) > 1 else counts[:1])} in " if counts else ""


def _in_table(row: ParameterRow) -> ParameterRow:
    return replace(row, values=in_table(row.values))


def parameter_row(parameter: Parameter, system: System) -> ParameterRow:
    """Return what documents and pages say of a parameter, as plain text."""
    unit = f" {parameter.unit.name}" if parameter.unit.name else ""
    smallest, largest = (decimal(steps * parameter.step) for steps in (parameter.minimum, parameter.maximum))
    return ParameterRow(
        name=parameter.name,
        type=parameter.spec.type.value,
        default=f"{decimal(parameter.default * parameter.step)}{unit}",
        limits=f"{smallest}..{largest}{unit}",
        step=f"{decimal(parameter.step)}{unit}",
        values=", ".join(
            f"{decimal(steps * parameter.step)} {text}" for steps, text in sorted(parameter.choices.items())
        ),
        restart="yes" if parameter.spec.reboot else "",
        sets=", ".join(uses(parameter, system)),
        criterion=str(parameter.citation or ""),
    )


def _criteria(system: System) -> list[CitedCriterion]:
    cited: dict[str, Citation] = {}
    for message in system.messages:
        for citation in (message.citation, *(answer.covers.citation for answer in message.answers)):
            cited[str(citation)] = citation
    for table in system.receptions:
        for each in (table.citation, *table.aspects.values(), *(taken.citation for taken in table.fields)):
            if each is not None:
                cited[str(each)] = each
    return [
        CitedCriterion(name, in_table(citation.criterion.text if citation.criterion else citation.requirement.title))
        for name, citation in sorted(cited.items())
    ]
