"""Descriptions of overlays that name another sentinel than the attribute."""

import re
from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.literals import named_number, same_number
from codegen.model.system import System

RULE = Rule(
    "text-contradicts-invalid",
    "The description of a field of an overlay, or of a dialect of the project, names one value for unknown, and the "
    "attribute invalid another. Generators follow the attribute, people the text. Correct the one that is wrong, in "
    "the XML or in a correction.",
)

_UNKNOWN = r"unknown|unavailable|unset|invalid|(?:not|no) (?:provided|known|available|measured|sent|estimate|value)"
# A value, what ties it to a meaning, and a meaning within the same clause: "NaN: not provided", "255 if it is unknown".
_STATED = re.compile(
    rf"(?<![\w.-])(-?\d+|U?INT\d+_M(?:IN|AX)|nan)\b\s*(?::|=|if|means|where|when|is|stands for)\s[^.;,:]*?"
    rf"\b(?:{_UNKNOWN})\b",
    re.IGNORECASE,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every field of the messages that overlays add."""
    for message in system.dialect.added_messages():
        for field in message.fields:
            stated = contradicting_text(field)
            if stated is not None and field.sentinel is not None:
                corrected = field.sentinel.place
                yield Diagnostic(
                    field.definition.place,
                    RULE,
                    f"{message.name}.{field.name}: the text says {stated}, the attribute {field.sentinel.written}",
                    "correct the attribute or the description",
                    ((corrected, "the attribute is stated here"),) if corrected != field.definition.place else (),
                )


def contradicting_text(field: WireField) -> str | None:
    """The first value that the description names for unknown, if none that it names is the field's sentinel."""
    if field.sentinel is None:
        return None
    stated = _STATED.findall(field.definition.description)
    values = [named_number(text) for text in stated]
    sentinels = [value for value in field.sentinel.values if value is not None]
    if not stated or any(same_number(value, sentinel) for value in values for sentinel in sentinels):
        return None
    return str(stated[0])
