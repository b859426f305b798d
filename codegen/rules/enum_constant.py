"""Numbers in fields that carry an enum."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.answers.answer import Answer
from codegen.model.answers.live_numbers import live_numbers
from codegen.model.dialect.dialect import EnumDefinition
from codegen.model.dialect.free_values import is_left_free
from codegen.model.system import System
from codegen.model.vehicle import Parameter

RULE = Rule(
    "not-an-enum-value",
    "A constant, the initial value of a quantity or the default of a parameter stands for no entry of its field's "
    "enum, or sets bits that the bitmask does not have. Name entries with 'enum' or 'flags'. Numbers that the field's "
    "description leaves to anybody, such as codes greater than 32767 in TUNNEL.payload_type, are right without one.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every number that is known now in a field with an enum."""
    for message in system.messages:
        for answer in message.answers:
            enum = system.dialect.enums.get(answer.covers.field.definition.enum or "")
            if enum is None:
                continue
            label = answer.covers.label
            for value in {value for value in answer.constants if isinstance(value, int)}:
                yield from _told(value, f"{label} is {value}", "", answer, enum)
            for source, scaling in live_numbers(answer):
                begins = source.default if isinstance(source, Parameter) else source.initial
                if begins is not None and not isinstance(begins, str):
                    number = begins * scaling.factor
                    word, hint = "initially", f"give {source.path} the enum: enum: {enum.name}"
                    if isinstance(source, Parameter):
                        word, hint = "by default", f"give {source.path} the number of an entry as its default"
                    yield from _told(int(number), f"{label} is {source.path}, {word} {number}", hint, answer, enum)


def _told(value: int, what: str, hint: str, answer: Answer, enum: EnumDefinition) -> Iterator[Diagnostic]:
    """Yield the finding about a number, if there is one."""
    known = {entry.value for entry in enum.entries}
    bits = 0
    for each in known:
        bits |= each
    has_bits = enum.is_bitmask or answer.covers.field.definition.is_bitmask
    if value in known or (has_bits and not value & ~bits) or is_left_free(value, answer.covers.field):
        return
    yield Diagnostic(
        answer.covers.written.place,
        RULE,
        f"{what}, which is no entry of {enum.name}",
        hint or f"answer with enum: and an entry of {enum.name}, or correct the dialect",
        related=((enum.place, f"{enum.name} is declared here"),),
    )
