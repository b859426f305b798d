"""Regular expressions for the words of a dialect, each compiled when a description is first looked at."""

import re
from functools import cache


@cache
def phrase(expression: str, flags: int = 0) -> "re.Pattern[str]":
    """Return ``re.compile(expression, flags)``: few projects need most of them."""
    return re.compile(expression, flags)
