"""Descriptions of pymavlink's dialects that may state what no attribute does: a sentinel, a unit, a multiplier.

The phrases are meant to find more than there is: whatever they find has to be corrected or to be looked at once.
"""

import re
from collections.abc import Iterator
from typing import NamedTuple

from codegen.model.dialect.dialect import FieldDefinition, MessageDefinition

_LIMIT = r"U?INT(?:8|16|32|64)_M(?:AX|IN)|\bNaN\b|\b(?:255|65535|32767|4294967295)\b|\b0xff+\b"
_UNKNOWN = (
    r"unknown|invalid|unavailable|undefined|unused|ignore|\bempty\b|otherwise|"
    r"\bzero (?:means?|if|in this|values?|when|for|indicates|it|or)\b|zero-length|"
    r"\b(?:not|no|never|isn't|aren't|doesn't|don't) (?:\w+ )?"
    r"(?:available|provided?|supplied|support(?:ed)?|measured?|estimated?|known|used|valid|set|present|required|applicable|"
    r"specified)\b|"
    r"\bif (?:un|not\b|no\b)|"
    r"(?<![\w.,\[-])-1\b(?! ?(?:\.\.|to))|(?<![\w.]) ?0 (?:if|for(?! broadcast)|when|means?|indicates)"
)
_UNIT = (
    r"\b(?:milli|micro|centi|deci(?!mal)|kilo)\w*|\b(?:degrees|radians?|met(?:er|re)s?|seconds|volts|amperes?|pascals?|"
    r"hertz|percent(?:age)?|celsius|gauss|rpm|lit(?:er|re)s?\S*|knots?|bytes/s)\b|"
    r"\b(?:[cmkd]?m/s|cm|mm|us|m[AVW]|Hz|kPa|hPa|mbar)\b|\[[A-Za-z/%^*]{1,6}\]|\bin C\b"
)
_FACTOR = r"\*\s*\d|\bx 1|\b10\^\d|\b1E-?\d|multiplied|multiplier|scale[sd]? (?:by|as|with|to)|divided by|\(-?100%\)"

SENTINEL = re.compile(f"{_LIMIT}|{_UNKNOWN}", re.IGNORECASE)
UNIT = re.compile(_UNIT, re.IGNORECASE)
FACTOR = re.compile(_FACTOR, re.IGNORECASE)


class Candidate(NamedTuple):
    """A possible statement of a description about a field, or, with ``*`` for the field, about several."""

    kind: str
    message: str
    field: str
    phrase: str

    @property
    def name(self) -> str:
        """As the list of what was looked at has it."""
        return f"{self.message}.{self.field}"


def candidates(message: MessageDefinition) -> Iterator[Candidate]:
    """The phrases of a message and its fields for which there is no attribute."""
    for kind, phrase in (("invalid", SENTINEL), ("multiplier", FACTOR)):
        found = phrase.search(message.description)
        if found and (kind != "invalid" or any(_lacks(field) for field in message.fields)):
            yield Candidate(kind, message.name, "*", found[0])
    for field in message.fields:
        found = SENTINEL.search(field.description)
        if found and not field.invalid:
            yield Candidate("invalid", message.name, field.name, found[0])
        found = UNIT.search(field.description)
        if found and not (field.units or field.enum or field.type == "char"):
            yield Candidate("units", message.name, field.name, found[0])
        found = FACTOR.search(field.description)
        if found and not field.multiplier and not field.type.startswith("char"):
            yield Candidate("multiplier", message.name, field.name, found[0])


def _lacks(field: FieldDefinition) -> bool:
    return field.invalid is None
