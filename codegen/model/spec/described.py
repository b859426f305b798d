"""Descriptions of the keys of a specification's record.

Field metadata: ``key`` (the YAML key, where it is not the attribute's name) and ``doc`` (shown by editors).
A class may further declare ``ONE_OF``, keys of which exactly one is written, ``BESIDE``, which of these another one
may stand beside all the same, ``SHORT_FORMS``, words that stand for a whole record, and ``INSTEAD``, the hint for a key
that it does not have.

Keys that belong together are a record of their own, though they are written among the others: the field ``flattened``
has a tuple of such records, of which one is made where a key of it is written.
"""

from dataclasses import field
from enum import Enum
from typing import Any, NewType

Amount = NewType("Amount", str)
"""A number with a unit, written as one string: ``3.3 V``, ``10 Hz``, ``2 ms``."""


Verbatim = NewType("Verbatim", str)
"""The text of a scalar as it is written, whether YAML takes it for text, a number or a boolean."""


class Nothing(Enum):
    """The value of a key that is written as ``null``, which says something else than a key that is left out."""

    NULL = "null"


def described(doc: str, key: str | None = None, **rest: Any) -> Any:
    """A dataclass field with the text that editors show for it, and its YAML key if that differs."""
    return field(metadata={"doc": doc, "key": key}, **rest)


def flattened() -> Any:
    """A dataclass field for records, a tuple of a union of classes, whose keys stand among those of this record."""
    return field(metadata={"flattened": True}, default=())
