"""The roles of fields in predicting how long a store still lasts; receiver.yaml gives them by names."""

from collections.abc import Iterable, Mapping

from codegen.model.dialect.dialect import EnumDefinition, EnumEntry
from codegen.model.spec.receiver import RolesSpec

UNITS: Mapping[str, str] = {"current": "A", "consumed": "Ah", "left": "Ah", "percent": "%", "full": "Ah"}
"""The units in which roles are computed; what is not among them is only compared."""
LASTING = ("full", "serial", "cycles", "count")
"""Roles of values that never change for one thing: where one changes, another thing has taken its place."""


def role_of(field: str, roles: RolesSpec) -> str | None:
    """The role that a field of this name plays, or None."""
    return next((name for name, fields in roles.fields() if field in fields), None)


def describes(fields: Iterable[str], roles: RolesSpec) -> bool:
    """Return whether a message with these fields describes a thing that lasts, and not its present state."""
    return any(role_of(field, roles) in LASTING for field in fields)


def charging_entry(enum: EnumDefinition, roles: RolesSpec) -> EnumEntry | None:
    """The entry of an enum that says that it is being charged, or None."""
    return next((entry for entry in enum.entries if entry.name in roles.charging), None)
