"""The dialect's words give a number of a received field a meaning of its own, and the table takes it as a value."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.dialect.dialect import Kind
from codegen.model.dialect.stated_values import StatedValue, stated_below, stated_nan, stated_values
from codegen.model.reception import ReceivedField, Reception
from codegen.model.system import System
from codegen.model.units.unit import decimal

RULE = Rule(
    "untreated-value",
    "The dialect says in words that a number of a received field means something of its own, such as that the field is "
    "to be ignored, and the table takes it for a value like any other. List it under 'unchanged', where it is to leave "
    "the quantity as it was, under 'unknown', where there is no value then, or keep it out with min and max. An empty "
    "list, 'unknown: []', says that it is a value here.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each such number of a field that is taken."""
    for table in system.receptions:
        for taken in table.fields:
            if taken.is_text or taken.field.definition.enum or taken.field in table.targets:
                continue
            ignored = stated_nan(taken.field.definition.description) if taken.field.type.kind is Kind.FLOAT else None
            if ignored is not None and ignored.is_left and not _is_nan_treated(taken):
                yield _finding(table, taken, ignored)
            below = stated_below(taken.field.definition.description)
            if below is not None and taken.low < below[0] and taken.spec.unknown != ():
                yield _below(table, taken, *below)
            for stated in stated_values(taken.field.definition.description):
                if not _is_treated(stated, taken):
                    yield _finding(table, taken, stated)


def _is_nan_treated(taken: ReceivedField) -> bool:
    """Return whether NaN leaves the quantity as it was, or the table says that it does not."""
    return taken.is_kept_by_nan or taken.spec.unchanged == () or taken.spec.unknown is not None


def _is_treated(stated: StatedValue, taken: ReceivedField) -> bool:
    """Return whether the table says what becomes of the number: it lists it, or lets nobody take it for a value."""
    spec, number = taken.spec, stated.number
    is_beyond = not taken.low <= number <= taken.high
    if _is_said_by_another(stated, taken):
        return True
    if is_beyond or spec.unchanged == () or spec.unknown == () or number in (*taken.unchanged, *taken.absent):
        return True
    return number == taken.sentinel and not stated.is_left


def _is_said_by_another(stated: StatedValue, taken: ReceivedField) -> bool:
    """Return whether the words have the number stand for invalid, and the table asks the field by which they say so."""
    description = taken.field.definition.description
    return "invalid" in stated.words.lower() and any(each.field.name in description for each in taken.provisos)


def _finding(table: Reception, taken: ReceivedField, stated: StatedValue) -> Diagnostic:
    key = "unchanged" if stated.is_left else "unknown"
    becomes = "unknown" if stated.is_nan or stated.number == taken.sentinel else "a value"
    label = f"{table.wire.name}.{taken.label}"
    return Diagnostic(
        taken.spec.place,
        RULE,
        f"{label} has a number with a meaning of its own, {stated.words!r}, and it is taken as {becomes}",
        f"write {key}: [{stated.text}], or {key}: [] where that does not hold",
        ((taken.field.definition.place, "the dialect says so here"),),
    )


def _below(table: Reception, taken: ReceivedField, limit: Fraction, words: str) -> Diagnostic:
    """Return the finding that numbers below a limit, which mean that there is no value, are taken."""
    least = f"{decimal(limit)} {taken.field.unit_text}".rstrip() if limit else "0"
    return Diagnostic(
        taken.spec.place,
        RULE,
        f"{table.wire.name}.{taken.label} has numbers with a meaning of their own, {words!r}, and takes them as values",
        f"write min: {least}, which keeps them out, or unknown: [] where they are values here",
        ((taken.field.definition.place, "the dialect says so here"),),
    )
