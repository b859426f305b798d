"""One row per answer, as documents and ``explain`` print it."""

from codegen.frozen import dataclass
from codegen.model.answers.answer import Answer
from codegen.model.system import PopulatedMessage
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class FieldRow:
    """The row of a table for the elements that one answer covers, as text; ``place`` is the answer's."""

    offset: int
    size: int
    field: str
    type: str
    unit: str
    source: str
    conversion: str
    limits: str
    sentinel: str
    criterion: str
    place: Place


def others_of(message: PopulatedMessage) -> str:
    """The fields and elements that go out as unknown because the table does not list them: ``alt_ellipsoid, yaw``."""
    return ", ".join(answer.covers.label for answer in message.answers if answer.covers.by_others)


def withheld_of(message: PopulatedMessage) -> str:
    """The quantities that withhold a message, with the fields that cannot say so: ``gps.lat (lat), gps.lon (lon)``."""
    return ", ".join(f"{quantity.path} ({label})" for label, quantity in message.withheld_for)


def field_rows(message: PopulatedMessage) -> tuple[FieldRow, ...]:
    """The rows of a message, in wire order."""
    return tuple(_row(answer) for answer in message.answers)


def _row(answer: Answer) -> FieldRow:
    covers = answer.covers
    field = covers.field
    length = f"[{field.count}]" if field.is_array else ""
    extension = " ext" if field.definition.is_extension else ""
    words = answer.words()
    return FieldRow(
        offset=covers.offset,
        size=covers.count * field.type.size,
        field=covers.label,
        type=f"{field.type.name}{length}{extension}",
        unit=field.unit_text,
        source=f"{words.source} (others)" if covers.by_others else words.source,
        conversion=words.conversion,
        limits=words.limits,
        sentinel=covers.sentinel,
        criterion=str(covers.citation),
        place=covers.written.place,
    )


def in_table(text: str) -> str:
    """Text for a cell of a Markdown table: in one line, its bars marked as text."""
    return " ".join(text.split()).replace("|", "\\|")
