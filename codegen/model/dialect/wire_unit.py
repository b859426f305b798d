"""The unit of the numbers of a field: its units times its multiplier, combined nowhere else."""

from dataclasses import replace

from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import NUMBER, Unit


def wire_unit(field: WireField) -> Unit | None:
    """Return what 1 on the wire is: 0.01 for GPS_RAW_INT.eph, 360/255 deg for GPS_STATUS.satellite_azimuth.

    None for units that are not known. Source: the comments beside ``factor`` in MAVLink's schema, ``actual value =
    stated value * 360/255``.
    """
    name = field.definition.units
    unit = NUMBER if name is None else Unit.parse(name)
    if unit is None or field.multiplier == 1:
        return unit
    return replace(unit, scale=unit.scale * field.multiplier)
