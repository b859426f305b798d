"""Numbers in fields that carry an enum."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import System

RULE = Rule(
    "not-an-enum-value",
    "A constant stands for no entry of its field's enum, or sets bits that the bitmask does not have. Name entries "
    "with 'enum' or 'flags'.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every constant in a field with an enum."""
    for message in system.messages:
        for answer in message.answers:
            enum = system.dialect.enums.get(answer.covers.field.definition.enum or "")
            if enum is None:
                continue
            known = {entry.value for entry in enum.entries}
            bits = 0
            for value in known:
                bits |= value
            for value in {value for value in answer.constants if isinstance(value, int)}:
                if value in known or (enum.is_bitmask and not value & ~bits):
                    continue
                yield Diagnostic(
                    answer.covers.written.place,
                    RULE,
                    f"{answer.covers.label} is {value}, which is no entry of {enum.name}",
                    f"answer with enum: and an entry of {enum.name}, or correct the dialect",
                    related=((enum.place, f"{enum.name} is declared here"),),
                )
