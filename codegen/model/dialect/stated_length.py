"""Fields that say how many bytes of an array of the same message are used: ``len`` of ``data``, ``payload_length``."""

import re
from collections.abc import Iterable, Mapping

from codegen.model.dialect.dialect import Kind, WireField
from codegen.model.dialect.phrase import phrase

_NAMED = phrase(r"(?:(?P<of>\w+)_)?(?:len|length|count|size)")
_ALONE = ("data", "payload")
"""Arrays whose length has no name of its own: ``len``, ``length``, ``count``."""
_BYTES = phrase(r"\b(?:data|frame|payload) length\b|\bbytes\b", re.IGNORECASE)


def stated_lengths(fields: Iterable[WireField]) -> Mapping[str, WireField]:
    """Return by the names of the fields that say how much of an array is used that array."""
    fields = tuple(fields)
    arrays = {field.name: field for field in fields if field.count > 1 and _has_bytes(field)}
    found: dict[str, WireField] = {}
    for field in fields:
        named = _NAMED.fullmatch(field.name)
        if named is None or field.count > 1 or not field.type.is_integer or field.definition.enum is not None:
            continue
        if named["of"]:
            names = [named["of"], f"{named['of']}_bytes", f"{named['of']}_data"]
        else:
            says_bytes = field.definition.units == "bytes" or _BYTES.search(field.definition.description)
            names = list(_ALONE) if says_bytes else []
        meant = next((name for name in names if name in arrays), None)
        if meant is not None:
            found[field.name] = arrays[meant]
    return found


def _has_bytes(field: WireField) -> bool:
    return field.type.size == 1 and field.type.kind is not Kind.CHAR
