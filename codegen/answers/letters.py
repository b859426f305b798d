"""Finds out whether a field takes a text, and whether the empty text means unknown there."""

from codegen.model.answers.answer import Elements
from codegen.model.dialect.dialect import Kind, SentinelForm


def carries_text(covers: Elements) -> bool:
    """Return whether a field takes a text: one of characters, or all of an array of bytes that are no numbers of
    something.

    The dialect has such as CAMERA_INFORMATION.vendor_name, a ``uint8_t[32]``.
    """
    field = covers.field
    if field.type.kind is Kind.CHAR:
        return True
    definition = field.definition
    is_bytes = field.type.kind is Kind.UNSIGNED and field.type.size == 1 and field.is_array
    return is_bytes and covers.count == field.count and not (definition.units or definition.enum)


def says_unknown(covers: Elements) -> bool:
    """Return whether the empty text means unknown in a field: its first element is 0, by the dialect."""
    sentinel = covers.field.sentinel
    if sentinel is None or sentinel.values[0] != 0:
        return False
    return sentinel.form is SentinelForm.FIRST or set(sentinel.values) == {0}
