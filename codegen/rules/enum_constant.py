"""Numbers in fields that carry an enum."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import FixedBinding, System

RULE = Rule(
    "not-an-enum-value",
    "A constant stands for no entry of its field's enum, or sets bits that the bitmask does not have. Name entries "
    "with 'enum' or 'flags'.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every constant in a field with an enum."""
    for message in system.messages:
        for binding in message.bindings:
            enum = system.dialect.enums.get(binding.covers.field.definition.enum or "")
            if enum is None or not isinstance(binding, FixedBinding) or binding.is_unknown:
                continue
            known = {entry.value for entry in enum.entries}
            bits = 0
            for value in known:
                bits |= value
            for value in {value for value in binding.values if isinstance(value, int)}:
                if value in known or (enum.is_bitmask and not value & ~bits):
                    continue
                yield Diagnostic(
                    binding.covers.answer.place,
                    RULE,
                    f"{binding.covers.label} is {value}, which is no entry of {enum.name}",
                    related=((enum.place, f"{enum.name} is declared here"),),
                )
