"""Numbers of a field with an enum that its description leaves to anybody, without an entry."""

import re

from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.phrase import phrase

_LEFT_FREE = phrase(
    r"\b(?:codes?|values?|numbers?|ids?) (?:greater|larger|higher) than (?P<above>\d{1,10}) (?:are|is) "
    r"(?:considered |regarded as |free for |left to |for )?(?:local|private|experimental|user[- ]defined|own)\b",
    re.IGNORECASE,
)


def is_left_free(value: int, field: WireField) -> bool:
    """Return whether the field's description leaves a number to anybody who wants one."""
    found = _LEFT_FREE.search(field.definition.description)
    return found is not None and value > int(found["above"])
