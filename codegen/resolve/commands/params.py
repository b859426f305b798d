"""The parameters of a command: what the dialect says of them, and what the project makes of that."""

import math
import struct
from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.frozen import dataclass
from codegen.measure import UNIT_MISMATCH, find_unit
from codegen.model.command import WHOLE_IN_INT, Axis, CommandParam, single
from codegen.model.dialect.dialect import Dialect, EnumDefinition, EnumEntry
from codegen.model.dialect.literals import exact_number
from codegen.model.spec.command import CommandParamSpec, CommandSpec
from codegen.model.spec.described import Nothing
from codegen.model.units.affine import AffineMap
from codegen.model.units.unit import NUMBER, Unit, conversion, decimal, ratio, unit_named
from codegen.resolve.commands.left_values import left_values
from codegen.resolve.named import is_name
from codegen.resolve.quantities.kept import UNKNOWN_ENTRY

BAD_COMMAND_PARAM = Rule(
    "bad-command-parameter",
    "A parameter of a command has a number from 1 to 7 and a name of its own that Python can have, its limits lie "
    "within those of the dialect, the smaller one first, and its default lies within them.",
)
_AXES = {(5, "latitude"): Axis.LATITUDE, (6, "longitude"): Axis.LONGITUDE}
_SHOWN_ENTRIES = 6
_LARGEST = Fraction(struct.unpack("<f", b"\xff\xff\x7f\x7f")[0])
_DEGREES_E7 = unit_named("degE7")


@dataclass(frozen=True, slots=True)
class _Stated:
    """The attributes that the dialect states for a parameter; None where it states nothing."""

    unit: Unit | None
    minimum: Fraction | None
    maximum: Fraction | None
    increment: Fraction | None
    enum: str | None
    axis: Axis | None
    is_altitude: bool


def resolve_params(
    name: str, entry: EnumEntry, spec: CommandSpec, dialect: Dialect, report: Report
) -> tuple[CommandParam, ...]:
    """The parameters of a command in the order of its method's arguments; those with a finding are left out."""
    found: list[CommandParam] = []
    for key, param in spec.params.items():
        if key not in tuple("1234567"):
            report.add(
                BAD_COMMAND_PARAM,
                param.place,
                f"a command has parameters 1 to 7, and no {key}",
                hint="write the number of the parameter: params: {1: {name: ...}}",
            )
            continue
        if not is_name(param.name) or param.name == "self" or any(param.name == each.name for each in found):
            message = f"{param.name} cannot be the name of an argument of its own"
            report.add(
                BAD_COMMAND_PARAM,
                param.at("name"),
                message,
                hint="take a lower-case identifier that no other parameter of the command has",
            )
            continue
        resolved = _param(f"{name} {key}", int(key), param, _stated(entry, key), dialect, report)
        if resolved is not None:
            found.append(resolved)
    return tuple(found)


def _stated(entry: EnumEntry, key: str) -> _Stated:
    attributes: Mapping[str, str] = next((dict(each.attributes) for each in entry.parameters if each.number == key), {})
    words = attributes.get("label", "").lower().replace("/", " ").split()
    axis = _AXES.get((int(key), words[0])) if words else None
    unit = Unit.parse(attributes.get("units"))
    if unit is None and axis is not None:
        unit = unit_named("deg")
    minimum, maximum, increment = (_number(attributes.get(name)) for name in ("minValue", "maxValue", "increment"))
    if axis is not None and unit == _DEGREES_E7:  # which is said of COMMAND_INT: a float has degrees
        unit = unit_named("deg")
        minimum, maximum = (None if end is None else end / 10**7 for end in (minimum, maximum))
    if axis is not None and unit is not None and minimum is maximum is None:
        found = conversion(unit_named("deg"), unit)
        end = found.exact(Fraction(axis.value)) if found else None
        minimum, maximum = (None, None) if end is None else (-end, end)
    is_altitude = key == "7" and "altitude" in words
    return _Stated(unit, minimum, maximum, increment, attributes.get("enum"), axis, is_altitude)


def _number(text: str | None) -> Fraction | None:
    """A number as the dialect writes it; None where it writes none that can be read."""
    return None if text is None else exact_number(text)


def _param(
    label: str, number: int, spec: CommandParamSpec, stated: _Stated, dialect: Dialect, report: Report
) -> CommandParam | None:
    unit = find_unit(spec.unit, spec.at("unit"), report) if spec.unit else stated.unit or NUMBER
    if unit is None:
        return None
    wire_unit = stated.unit or unit
    scale = conversion(wire_unit, unit)
    if scale is None or scale.offset:
        message = f"{label} is in {wire_unit.name}, and {unit.name} is not: no factor leads from one to the other"
        report.add(
            UNIT_MISMATCH, spec.at("unit"), message, hint=f"unit: {wire_unit.name}, or one to which a factor leads"
        )
        return None
    enum = _enum(spec, stated, dialect, report)
    if enum is None and (spec.enum or (stated.enum and stated.enum in dialect.enums)):
        return None
    ends = [
        _end(label, key, written, limit, scale, report, spec)
        for key, written, limit in (("min", spec.min, stated.minimum), ("max", spec.max, stated.maximum))
    ]
    minimum, maximum = (None if end is None else _nearest(end) for end in ends)
    if minimum is not None and maximum is not None and minimum > maximum:
        key = "min" if spec.min is not None else "max"
        report.add(
            BAD_COMMAND_PARAM,
            spec.at(key),
            f"{spec.name} has no value: its smallest is above its largest",
            hint="swap min and max, or widen them to what the dialect allows",
        )
        return None
    is_whole = spec.whole
    if is_whole is None:
        is_counted = stated.increment is not None and stated.increment.denominator == 1 and scale.ratio == 1
        is_sent_whole = stated.axis is not None and unit == _DEGREES_E7
        is_whole = enum is not None or is_counted or is_sent_whole
    if isinstance(spec.default, Fraction):
        on_wire = AffineMap(1 / scale.factor, -scale.pi).settled(spec.default, _nearest)
        is_within = (minimum is None or on_wire >= minimum) and (maximum is None or on_wire <= maximum)
        _check_default(spec, spec.default, enum, is_whole, is_within, report)
    left, is_nan_left = left_values(label, spec, report)
    steps = _steps(label, number, spec, stated.axis, wire_unit, report)
    limits = (_limit(own, limit, scale) for own, limit in ((spec.min, stated.minimum), (spec.max, stated.maximum)))
    found = CommandParam(
        number=number,
        name=spec.name,
        unit=unit,
        wire_unit=wire_unit,
        scale=scale,
        minimum=minimum,
        maximum=maximum,
        limits=_words(spec, stated, scale, unit, enum, is_whole=is_whole),
        is_whole=is_whole,
        enum=enum,
        default=spec.default if isinstance(spec.default, Fraction) else None,
        axis=stated.axis,
        steps=steps,
        is_altitude=stated.is_altitude,
        spec=spec,
        left=left,
        is_none_for_nan=is_nan_left or spec.default is Nothing.NULL,
        ends=(next(limits), next(limits)),
    )
    if not _has_value(found):
        report.add(
            BAD_COMMAND_PARAM,
            spec.place,
            f"{spec.name} has no value: none within its limits is {found.limits}",
            hint="widen min and max until there is one",
        )
        return None
    return found


def _steps(
    label: str, number: int, spec: CommandParamSpec, axis: Axis | None, wire_unit: Unit, report: Report
) -> Fraction | None:
    """Return how many steps to one in its unit COMMAND_INT has of a parameter; None where it has whole ones."""
    if axis is not None:
        if spec.scaled is not None:
            message = f"{label} is a {axis.name.lower()}, of which COMMAND_INT has 1e-7 degrees"
            report.add(BAD_COMMAND_PARAM, spec.at("scaled"), message, hint="leave scaled out")
        return ratio(wire_unit, _DEGREES_E7) or Fraction(1)
    if spec.scaled is None or spec.scaled == 1:
        return None
    if number not in WHOLE_IN_INT:
        message = f"COMMAND_INT has {label} as COMMAND_LONG has it, and multiplies parameters 5 and 6 alone"
        report.add(BAD_COMMAND_PARAM, spec.at("scaled"), message, hint="leave scaled out")
        return None
    if spec.scaled < 1 or spec.scaled.denominator != 1:
        message = f"COMMAND_INT has {label} multiplied by a whole number, not by {decimal(spec.scaled)}"
        report.add(BAD_COMMAND_PARAM, spec.at("scaled"), message, hint="scaled: 1e7 for a global position")
        return None
    return spec.scaled


def _has_value(param: CommandParam) -> bool:
    """Return whether a parameter has any value at all: a whole one, or an entry of its enum, within its limits."""
    low, high = (
        None if end is None else param.scale.settled(end, Fraction) if param.scale.ratio else end
        for end in (param.minimum, param.maximum)
    )
    if param.enum is not None:
        values = [0, flags_of(param.enum)] if param.enum.is_bitmask else [each.value for each in param.enum.entries]
        return any((low is None or value >= low) and (high is None or value <= high) for value in values)
    if not param.is_whole or param.is_rounded or low is None or high is None:
        return True
    return math.floor(high) >= math.ceil(low)


def _enum(spec: CommandParamSpec, stated: _Stated, dialect: Dialect, report: Report) -> EnumDefinition | None:
    if spec.enum is None:
        return dialect.enums.get(stated.enum or "")
    enum = dialect.enums.get(spec.enum)
    if enum is None:
        hint = did_you_mean(spec.enum, dialect.enums)
        report.add(UNKNOWN_ENTRY, spec.at("enum"), f"the dialect has no enum {spec.enum}", hint)
        return None
    if stated.enum not in (None, spec.enum) and stated.enum in dialect.enums:
        message = f"{spec.name} is of {stated.enum} in the dialect, not of {spec.enum}"
        report.add(
            BAD_COMMAND_PARAM,
            spec.at("enum"),
            message,
            hint=f"leave enum out, or set it in a corrections file: enum: {spec.enum}",
        )
        return None
    return enum


def _end(
    label: str,
    key: str,
    written: Fraction | None,
    stated: Fraction | None,
    scale: AffineMap,
    report: Report,
    spec: CommandParamSpec,
) -> Fraction | None:
    """A limit on the wire: the one that the project writes, within the dialect's, or that one."""
    if written is None:
        return stated
    found = AffineMap(1 / scale.factor, -scale.pi).settled(written, _nearest)
    if stated is not None and (found < _nearest(stated) if key == "min" else found > _nearest(stated)):
        message = f"{decimal(written)} is beyond what the dialect allows for {label}: {decimal(stated)} on the wire"
        name, _, number = label.rpartition(" ")
        wanted = f"{float(written / scale.ratio):.9g}" if scale.ratio else f"{float(found):.7g}"
        hint = (
            f"where the dialect's words allow it, a correction does: {{enum: MAV_CMD, entry: {name}, param: {number}, "
            f"set: {{{key}Value: {wanted}}}}}"
        )
        report.add(BAD_COMMAND_PARAM, spec.at(key), message, hint)
    return found


def _nearest(value: Fraction) -> Fraction:
    """The float of 32 bits that COMMAND_LONG has for a value; the largest one for what is beyond all of them."""
    within = max(min(value, _LARGEST), -_LARGEST)
    return single(within)


def _limit(written: Fraction | None, stated: Fraction | None, scale: AffineMap) -> Fraction | None:
    """Return a limit in the unit of the argument, exactly; None for none, and where pi is in the way."""
    if written is not None or stated is None:
        return written
    return scale.exact(stated)


def _check_default(
    spec: CommandParamSpec,
    value: Fraction,
    enum: EnumDefinition | None,
    is_whole: bool,
    is_within: bool,
    report: Report,
) -> None:
    """Report a default that is no value which the parameter accepts; ``is_within``: its limits, on the wire."""
    is_within = is_within and (spec.min is None or value >= spec.min) and (spec.max is None or value <= spec.max)
    is_within = is_within and abs(value) <= _LARGEST  # as the method is given it
    if not is_within or (is_whole and value.denominator != 1) or (enum is not None and not has_entry(enum, int(value))):
        message = f"the default of {spec.name} is no value that it accepts"
        report.add(
            BAD_COMMAND_PARAM,
            spec.at("default"),
            message,
            hint="write one within min and max: an entry of the enum, or a whole number, where it wants one",
        )


def has_entry(enum: EnumDefinition, value: int) -> bool:
    """Return whether a value is an entry of an enum, or a sum of its flags."""
    values = [entry.value for entry in enum.entries]
    return value in values if not enum.is_bitmask else value >= 0 and not value & ~flags_of(enum)


def flags_of(enum: EnumDefinition) -> int:
    """All flags of a bitmask."""
    mask = 0
    for entry in enum.entries:
        mask |= entry.value
    return mask


def _words(
    spec: CommandParamSpec,
    stated: _Stated,
    scale: AffineMap,
    unit: Unit,
    enum: EnumDefinition | None,
    *,
    is_whole: bool,
) -> str:
    """``0 to 60 s``, ``a whole number from 1 on``, ``0, 1 or 2``: what a value has to be, in its unit."""
    if stated.axis is not None and unit == _DEGREES_E7:
        scale, unit, is_whole = AffineMap(scale.factor / 10**7), unit_named("deg"), False
        written = [None if end is None else end / 10**7 for end in (spec.min, spec.max)]
    else:
        written = [spec.min, spec.max]
    low, high = (
        _shown(own, limit, scale) for own, limit in zip(written, (stated.minimum, stated.maximum), strict=True)
    )
    if enum is not None:
        values = ["0", "1"] if enum.is_bitmask and flags_of(enum) == 1 else [str(each.value) for each in enum.entries]
        if (enum.is_bitmask and flags_of(enum) > 1) or len(values) > _SHOWN_ENTRIES:
            return f"{'flags' if enum.is_bitmask else 'one'} of {enum.name}"
        return f"{', '.join(values[:-1])} or {values[-1]}" if len(values) > 1 else values[0]
    suffix = f" {unit.name}" if unit.name else ""
    number = "whole, " if is_whole else ""
    if low and high:
        return f"{number}{low} to {high}{suffix}"
    if low or high:
        return f"{number}at {'least' if low else 'most'} {low or high}{suffix}"
    return "a whole number" if is_whole else f"a number{f' of {unit.name}' if unit.name else ''}"


def _shown(written: Fraction | None, stated: Fraction | None, scale: AffineMap) -> str:
    if written is not None:
        return decimal(written)
    if stated is None:
        return ""
    exact = scale.exact(stated)
    return decimal(exact) if exact is not None else f"{scale.settled(stated, float):.6g}"
