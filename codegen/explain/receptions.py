"""Explains messages that set quantities."""

from textwrap import fill

from codegen.explain.corrections import correction_facts
from codegen.explain.text import cited, columns, facts
from codegen.model.reception import Reception
from codegen.model.system import System
from codegen.summaries.receptions import ReceivedRow, condition_words, received_rows, sender_words
from codegen.targets.firmware.messages.receiving import call_name

_COLUMNS = (
    *("offset", "size", "field", "type", "unit", "sets", "conversion"),
    *("taken", "sets it unknown", "leaves it", "criterion", "where"),
)


def explained_reception(table: Reception) -> str:
    """The story of a message that is received."""
    condition = condition_words(table)
    lines = [
        f"{table.title}, received {sender_words(table)}{f', with {condition}' if condition else ''}",
        f"{cited(table.citation)}",
        *([f"calls {call_name(table)}() of the vehicle"] if table.spec.call else []),
        "what is not listed is ignored",
        "",
        *columns([_COLUMNS, *(_received_cells(row) for row in received_rows(table))]),
    ]
    return "\n".join(lines) + "\n"


def _received_cells(row: ReceivedRow) -> tuple[str, ...]:
    return (
        *(str(row.offset), str(row.size), row.field, row.type, row.unit, row.quantity, row.conversion, row.taken),
        *(row.unknown, row.unchanged, row.criterion, row.place.shown().rpartition(":")[0]),
    )


def explained_received_field(table: Reception, name: str, system: System) -> str | None:
    """Return the story of a field of a received message; None where the table does not take it."""
    parts: list[str] = []
    for taken, row in zip(table.fields, received_rows(table), strict=True):
        if name not in (taken.field.name, taken.label):
            continue
        parts += [f"{table.name}.{taken.label}, received", fill(taken.field.definition.description, 100), ""]
        found = [
            ("offset", f"{row.offset}, {row.size} bytes"),
            ("type", row.type),
            ("unit", row.unit),
            ("sets", row.quantity),
            ("conversion", row.conversion),
            ("taken", f"{row.taken}; what is beyond is counted and leaves {row.quantity} as it was"),
            ("unknown by", row.unknown),
            ("unchanged by", row.unchanged),
            *correction_facts(system.dialect, table.wire.name, taken.field.name),
            ("criterion", cited(taken.citation)),
            ("stated at", row.place.shown()),
            ("declared at", taken.field.definition.place.shown()),
            ("note", taken.spec.note or ""),
        ]
        parts += facts(found)
    return "\n".join(parts) + "\n" if parts else None
