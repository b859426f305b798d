"""Headings that a column must have for its cells to state a type, a unit or another fact."""

import re
from functools import cache

from codegen.claims.parts.span import Span, head_of
from codegen.claims.ruled_out import is_own_column

_HEADS = {
    "claim-struct": r"type|data ?type|format|length|elements|count|array|encoding",
    "claim-unit": r".*\bunits?\b.*|type|scal\w*|resolution|encoding|type.*unit.*",
    "claim-message-id": r"#|(?:message |msg )?(?:id|no\.?|number|#)|message",
    "claim-crc-extra": r"crc.*|seed|extra.*",
    "claim-message-size": r".*(?:bytes|payload|size|len|frame|packet|wire).*",
    "claim-bytes-per-second": r".*(?:/s|per second|bandwidth|load|total|throughput|rate).*",
    "claim-sentinel": (
        r"values?|content|data|(?:on the )?wire|sent"
        r"|.*(?:unknown|invalid|sentinel|missing|n/a|not available|no data).*"
    ),
    "claim-extension": r".*ext.*|base.*|group|part|kind",
    "claim-offset": r".*(?:offset|byte|at|pos).*",
    "claim-enum-value": r"value|id|number|no\.?|#|bit|code|dec(?:imal)?|num|entry|name|constant|result|flag|command.*",
    "claim-enum-of-field": r"enum.*|values?|type",
    "claim-command-parameter": r"param.*|p\d|unit|number|#",
    "claim-scaling": (
        r"raw|encoded|wire|value|sent|on the wire|factor|multiplier|scale|real|decoded|means|physical.*|amount"
    ),
    "claim-range": r"range|max.*|min.*|greatest.*",
    "claim-wire-order": r"order|position|#",
}
"""By kind of finding, what the heading of a column has to be for a cell to be sure of what it says."""


@cache
def _head(rule: str) -> "re.Pattern[str] | None":
    heads = _HEADS.get(rule)
    return None if heads is None else re.compile(rf"(?:{heads})(?: ?[(\[].*)?", re.IGNORECASE)


def is_headed(span: Span, at: int, rule: str) -> bool:
    """Return whether the column of a value is one of such values, and nobody's own."""
    head, known = head_of(span, at), _head(rule)
    return known is not None and known.fullmatch(head.strip("*_` ")) is not None and not is_own_column(head)
