"""Texts that fill a field at whose end the dialect wants a NUL."""

import re
from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.answers.answer import Answer
from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.phrase import phrase
from codegen.model.system import System
from codegen.model.vehicle import QuantityKind

RULE = Rule(
    "unterminated-text",
    "The words of a field say that its text ends with a NUL, and a constant, a fact or a quantity fills it to its last "
    "byte: a receiver that relies on the NUL reads on into what follows. Keep the text a byte shorter than the field.",
    Severity.WARNING,
)
_ENDED = phrase(
    r"(?:\bNUL?L|(?<![.\d])0|zero)[- ]terminated|\bterminated by (?:a )?NUL?L\b|\bwith (?:a )?NUL?L termination|"
    r"\d ?\+ ?NUL?L\b|\b(?:including|plus) (?:the |a )?(?:terminating )?NUL?L\b",
    re.IGNORECASE,
)
_NOT_ENDED = phrase(r"\bwithout (?:a )?(?:NUL?L|termination|terminating)", re.IGNORECASE)


def check(system: System) -> Iterator[Diagnostic]:
    """One finding for each text that has no room for the NUL."""
    for message in system.messages:
        for answer in message.answers:
            words = _ending(answer.covers.field)
            if words and not answer.covers.first:
                yield from _filled(message.wire.name, answer, words)


def _ending(field: WireField) -> str:
    """Return the words that ask for a NUL at the end; empty where there are none, or some leave it out."""
    description = field.definition.description
    found = _ENDED.search(description)
    return "" if found is None or field.count < 2 or _NOT_ENDED.search(description) else found[0]


def _filled(message: str, answer: Answer, words: str) -> Iterator[Diagnostic]:
    """Yield the finding about a constant, a fact or a quantity that takes all bytes of its field."""
    field, written = answer.covers.field, answer.covers.written
    for text in answer.constants:
        if isinstance(text, str) and len(text.encode()) >= field.count:
            what, hint = f"{text!r} takes", f"a text of {field.count - 1} bytes at most"
            break
    else:
        long = [each for each in answer.carried if each.kind is QuantityKind.TEXT and each.length >= field.count]
        if not long:
            return
        what, hint = f"{long[0].path} can take", f"text: {field.count - 1} at {long[0].path}"
    yield Diagnostic(
        written.place,
        RULE,
        f"{what} all {field.count} bytes of {message}.{answer.covers.label}, whose words say {words!r}",
        hint,
        ((field.definition.place, "the dialect says so here"),),
    )
