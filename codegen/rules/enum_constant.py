"""Numbers in fields that carry an enum."""

import re
from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.answers.answer import Answer
from codegen.model.dialect.phrase import phrase
from codegen.model.system import System

RULE = Rule(
    "not-an-enum-value",
    "A constant stands for no entry of its field's enum, or sets bits that the bitmask does not have. Name entries "
    "with 'enum' or 'flags'. Numbers that the field's description leaves to anybody, such as codes greater than 32767 "
    "in TUNNEL.payload_type, are right without an entry.",
)
_LEFT_FREE = phrase(
    r"\b(?:codes?|values?|numbers?|ids?) (?:greater|larger|higher) than (?P<above>\d{1,10}) (?:are|is) "
    r"(?:considered |regarded as |free for |left to |for )?(?:local|private|experimental|user[- ]defined|own)\b",
    re.IGNORECASE,
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
                if value in known or (enum.is_bitmask and not value & ~bits) or _is_left_free(value, answer):
                    continue
                yield Diagnostic(
                    answer.covers.written.place,
                    RULE,
                    f"{answer.covers.label} is {value}, which is no entry of {enum.name}",
                    f"answer with enum: and an entry of {enum.name}, or correct the dialect",
                    related=((enum.place, f"{enum.name} is declared here"),),
                )


def _is_left_free(value: int, answer: Answer) -> bool:
    """Return whether the field's description leaves a number to anybody who wants one."""
    found = _LEFT_FREE.search(answer.covers.field.definition.description)
    return found is not None and value > int(found["above"])
