"""What fields of battery messages mean for the time that remains: words of the dialects, whichever message has them."""

from collections.abc import Iterable, Mapping

from codegen.frozen import dataclass
from codegen.model.dialect import EnumDefinition, EnumEntry


@dataclass(frozen=True, slots=True)
class Role:
    """The fields that play a role, and the unit that it is computed in; None for what is only compared."""

    fields: tuple[str, ...]
    unit: str | None = None


ROLES: Mapping[str, Role] = {
    "current": Role(("current", "current_battery"), "A"),
    "consumed": Role(("capacity_consumed", "current_consumed"), "Ah"),
    "left": Role(("capacity_remaining",), "Ah"),
    "percent": Role(("state_of_charge", "percent_remaining", "battery_remaining"), "%"),
    "full": Role(("full_charge_capacity", "capacity_full"), "Ah"),
    "serial": Role(("serial_number",)),
    "cycles": Role(("cycle_count",)),
    "cells": Role(("cells_in_series",)),
}
"""Source: BATTERY_STATUS, SMART_BATTERY_INFO and BATTERY_INFO of common.xml, BATTERY_STATUS_V2 in both its
forms.

A message of another name that has one of these fields counts as well.
"""


def role_of(field: str) -> str | None:
    """The role that a field of this name plays, or None."""
    return next((name for name, role in ROLES.items() if field in role.fields), None)


def describes_a_battery(fields: Iterable[str]) -> bool:
    """Whether a message with these fields is about what a battery is, not about what it does."""
    return any(role_of(field) in ("full", "serial", "cycles", "cells") for field in fields)


def charging_entry(enum: EnumDefinition) -> EnumEntry | None:
    """The entry of an enum that says that a battery is charging, or None."""
    return next((entry for entry in enum.entries if entry.name.endswith("_CHARGING")), None)
