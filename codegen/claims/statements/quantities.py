"""Words for what fields measure: "angles" are those in deg or rad, "speeds" those in m/s, mm/s or cm/s."""

from collections.abc import Iterable

from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.units.unit import Unit, unit_named

_NOUNS = {
    "deg": ("angle", "attitude", "heading", "course"),
    "deg/s": ("rate", "gyro"),
    "m/s": ("speed", "velocity", "velocities"),
    "m": ("altitude", "height", "distance", "length", "depth"),
    "degC": ("temperature",),
    "V": ("voltage",),
    "A": ("current",),
    "m/s/s": ("acceleration",),
    "Pa": ("pressure",),
    "s": ("time", "timestamp", "interval", "duration"),
    "mAh": ("charge", "capacity"),
}
_UNIT_OF = {noun: unit for unit, nouns in _NOUNS.items() for noun in nouns}
_PLACES = ("lat", "lon", "lng")
"""Fields in degrees that nobody calls angles begin so."""


def quantities(messages: Iterable[WireMessage], noun: str, unit: Unit) -> list[WireField]:
    """Return the fields of messages that measure what a word says, where a unit measures it, too."""
    named = _UNIT_OF.get(noun) or _UNIT_OF.get(noun.removesuffix("s"))
    if named is None or unit_named(named).dimension != unit.dimension:
        return []
    return measuring(messages, unit)


def measuring(messages: Iterable[WireMessage], unit: Unit) -> list[WireField]:
    """Return the fields of messages that measure what a unit does."""
    fields = (field for message in messages for field in message.fields if not field.name.startswith(_PLACES))
    return [
        field
        for field in fields
        if (own := Unit.parse(field.definition.units)) is not None and own.dimension == unit.dimension
    ]
