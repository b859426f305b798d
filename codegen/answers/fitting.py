"""Checks that an answer fits its field: its unit, its enum, its sentinel."""

from codegen.answers.scope import Scope
from codegen.diagnostics import Report, Rule
from codegen.measure import unknown_field_unit
from codegen.model.answers.answer import Elements
from codegen.model.answers.step import Step
from codegen.model.dialect.dialect import EnumDefinition, WireField
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.units.unit import Unit

NO_SENTINEL = Rule(
    "no-sentinel",
    "A table says unknown, or a quantity can become unknown, where the dialect has no value that means unknown. "
    "Give the quantity an initial value, withhold the message with 'send: while_known', answer the field otherwise, "
    "or, where the dialect states the sentinel only in words, add it to the corrections file.",
)
NOT_AN_ENUM_FIELD = Rule(
    "not-an-enum-field",
    "An enum entry or flags are given for a field that has no such enum.",
    remedy="answer with what its own enum has, or give it another enum in a corrections file",
)
BAD_SOURCE = Rule(
    "bad-source",
    "A source does not fit its field: a boolean, a text field, or one value for several elements without split.",
)


WITHHELD = Step("unknown", "the message is withheld", ("no number of the field means unknown",), ())


def no_sentinel(covers: Elements, key: str, what: str, report: Report) -> None:
    """Report that ``what``, which stands under a key of the table, can be unknown and its field cannot say so."""
    initial = "" if key == "clock" else "give the quantity an 'initial' value, or "  # a clock has none
    report.add(
        NO_SENTINEL,
        covers.written.at(key),
        f"{what} can be unknown, and {covers.field.name} has no value that says so",
        f"{initial}withhold the message with 'send: while_known', or, where the dialect states a sentinel in words, "
        "add it to the corrections file",
        [(covers.field.definition.place, f"{covers.field.name} is declared here")],
    )


def field_enum(covers: Elements, key: str, scope: Scope) -> EnumDefinition | None:
    """The enum of the field, of which the table names entries under ``key``."""
    name = covers.field.definition.enum
    if name is None:
        scope.report.add(
            NOT_AN_ENUM_FIELD,
            covers.written.at(key),
            f"{covers.field.name} has no enum in the dialect",
            hint="answer with a number, or state its enum in a corrections file: enum: NAME",
        )
        return None
    return scope.enum(name)


def field_unit(field: WireField, report: Report) -> Unit | None:
    """The unit that the numbers of a field on the wire are in, the dialect's multiplier included."""
    unit = wire_unit(field)
    if unit is None:
        report.extend([unknown_field_unit(field)])
    return unit
