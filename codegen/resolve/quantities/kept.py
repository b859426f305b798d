"""Resolves the storage of a quantity: its kind, its units, its limits, and the words that hold a value."""

from dataclasses import replace
from fractions import Fraction

from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule, did_you_mean
from codegen.measure import UNCARRIED_CONVERSION, UNIT_MISMATCH, find_unit, obstacle, other_steps
from codegen.model.answers.scaling import rounded
from codegen.model.code.letters import NUL, cut
from codegen.model.code.storage import SMALL_INT_MAX, Storage, float_storage, storage_of
from codegen.model.dialect.dialect import EnumDefinition, WireField
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.quantities.source_kind import Output
from codegen.model.spec.population import Rounding
from codegen.model.units.unit import Unit, decimal, ratio
from codegen.model.vehicle import QuantityKind

UNKNOWN_ENUM = Rule(
    "unknown-enum",
    "A table names an enum that the dialect does not have.",
    remedy="write an enum that the dialect has, or add it with an overlay",
)
UNKNOWN_ENTRY = Rule(
    "unknown-enum-entry",
    "A table names an entry that the enum of the dialect does not have.",
    remedy="write an entry that the enum has in the dialect, or add it with an overlay",
)
BEYOND_STORAGE = Rule(
    "beyond-storage",
    "The limits of a quantity are wider than what it can be kept in: whole numbers of stored units have 64 bits at "
    f"most, and {SMALL_INT_MAX} is the largest magnitude of one that is measured, computed, compared, counted or spread"
    " over elements. Narrow the limits, or keep it in a coarser unit.",
)

LONGEST_TEXT = 255
"""Bytes of the longest text that a field can have."""

Limits = tuple[int | Fraction, int | Fraction]


def resolve_kept(around: Surroundings) -> tuple[Kept, EnumDefinition | None] | None:
    """Return how the quantity is kept, and the enum of which its values are; None without units."""
    spec = around.spec
    enum = _enum(around)
    kind = _kind(around)
    unit = find_unit(spec.unit, spec.at("unit"), around.report)
    stored = None if unit is None else _stored(around, kind, unit)
    if unit is None or stored is None:
        return None
    steps = ratio(unit, stored)
    if steps is None:
        why = obstacle(unit, stored)
        message = f"{unit.name or 'a number'} cannot be kept in {stored.name}"
        around.bad(
            "stored",
            f"{message}: {why}" if why else message,
            UNCARRIED_CONVERSION if why else UNIT_MISMATCH,
            hint=other_steps(unit, stored),
        )
        return None
    storage, (minimum, maximum) = _storage(around, kind, stored, steps, enum)
    initial = _initial(around, kind, enum, steps, storage)
    if initial is not None and not isinstance(initial, str) and not minimum <= initial <= maximum:
        around.bad(
            "initial",
            f"initial of {around.name} is not between its limits",
            hint="write one that is, or widen min and max",
        )
    return Kept(kind, unit, stored, steps, storage, minimum, maximum, initial), enum


def _kind(around: Surroundings) -> QuantityKind:
    spec, name = around.spec, around.name
    kind = QuantityKind.NUMBER
    if spec.text is not None:
        kind = QuantityKind.TEXT
        _check_text(around)
    elif spec.boolean:
        kind = QuantityKind.BOOLEAN
    elif spec.enum is not None:
        kind = QuantityKind.ENUM
    if kind is not QuantityKind.NUMBER:
        for key in ("unit", "stored", "min", "max"):
            if getattr(spec, key) is not None:
                around.bad(
                    key,
                    f"{name} is a {kind.value} quantity and cannot have {key}",
                    hint=f"leave {key} out, or make it a number: without {kind.value}",
                )
    if kind is not QuantityKind.TEXT and spec.boolean and spec.enum is not None:
        around.bad("enum", f"{name} cannot be both a boolean and an enum", hint="leave out one of them")
    return kind


def _check_text(around: Surroundings) -> None:
    """Say what a text cannot be: what other code sets as a whole, and nothing looks at, has a length."""
    spec, name = around.spec, around.name
    assert spec.text is not None
    if not 1 <= spec.text <= LONGEST_TEXT:
        around.bad("text", f"text of {name} is {spec.text}, not 1 to {LONGEST_TEXT} bytes", hint="text: 50")
    for key in ("boolean", "enum", "elements", "restarts_with"):
        if getattr(spec, key) not in (None, False):
            around.bad(key, f"{name} is a text and cannot have {key}", hint=f"leave out text, or {key}")


def _enum(around: Surroundings) -> EnumDefinition | None:
    name, enums = around.spec.enum, around.dialect.enums
    if name is not None and name not in enums:
        around.bad("enum", f"the dialect has no enum {name}", UNKNOWN_ENUM, did_you_mean(name, enums))
    return None if name is None else enums.get(name)


def _is_plain(around: Surroundings) -> bool:
    """Return whether code sets it, and nothing but the fields of messages looks at it."""
    spec = around.spec
    is_counted = isinstance(spec.elements, str)
    is_computed = spec.derivations and not around.is_sourced
    return not (around.is_compared or is_computed or spec.restarts_with or is_counted)


def _float(around: Surroundings, kind: QuantityKind) -> Storage | None:
    """The float that it is kept as: where ``stored`` says nothing, and it goes out as a float alone."""
    if kind is not QuantityKind.NUMBER or around.spec.stored is not None or not _is_plain(around):
        return None
    if around.is_sourced:
        return None  # sensors give whole steps
    return float_storage({field.type for field in around.carriers})


def _stored(around: Surroundings, kind: QuantityKind, unit: Unit) -> Unit | None:
    """The unit of what is kept: the one that is written, or that of the fields, or the quantity's own.

    That of the fields is taken where they all have the same one, and whole numbers of it are no coarser, or lie between
    whole units, such as steps of 360/255 degrees. What a sensor gives is kept in its steps.
    """
    spec = around.spec
    if spec.stored is not None:
        return find_unit(spec.stored, spec.at("stored"), around.report)
    if kind is QuantityKind.NUMBER and (given := around.outputs()):
        return given[0][1].unit if ratio(unit, given[0][1].unit) is not None else unit
    if kind is not QuantityKind.NUMBER or not around.carriers or not _is_plain(around):
        return unit
    one, *others = (wire_unit(field) for field in around.carriers)
    steps = None if one is None else ratio(unit, one)
    if one is None or steps is None or any(other is None or ratio(other, one) != 1 for other in others):
        return unit
    is_own = steps < 1 and not _is_between_units(around, steps)
    if _float(around, kind) is None and (is_own or not all(field.type.is_integer for field in around.carriers)):
        return unit
    field = around.carriers[0]
    return one if field.multiplier == 1 else replace(one, name=field.unit_text)


def _is_between_units(around: Surroundings, steps: Fraction) -> bool:
    """Return whether the steps of fields lie between whole units, and what the table states is a number of them.

    Only of what is received: code sets whole units, which these steps would round.
    """
    stated = (getattr(around.spec, key) for key in ("min", "max", "initial"))
    ends = [number * steps for number in stated if isinstance(number, Fraction)]
    is_between = (1 / steps).denominator != 1 and all(end.denominator == 1 for end in ends)
    return is_between and bool(around.received)


def _is_in(field: WireField, stored: Unit) -> bool:
    """Return whether a field takes a number as it is kept in a unit."""
    unit = wire_unit(field)
    return unit is not None and ratio(stored, unit) == 1


def _storage(
    around: Surroundings, kind: QuantityKind, stored: Unit, steps: Fraction, enum: EnumDefinition | None
) -> tuple[Storage, Limits]:
    """Return how a value is kept, and between which limits, in stored units."""
    spec = around.spec
    as_float = _float(around, kind)
    if as_float is not None:
        ends = zip((spec.min, spec.max), as_float.limits, strict=True)
        low, high = (end if written is None else as_float.nearest(written * steps) for written, end in ends)
        limits = low, high
        for key in ("min", "max", "initial"):
            written = getattr(spec, key)
            if isinstance(written, Fraction) and abs(written * steps) > as_float.limits[1]:
                message = f"{key} of {around.name} is beyond {float(as_float.limits[1]):.7g}, the largest float there"
                around.bad(key, message, BEYOND_STORAGE, "leave it out, or keep the quantity in a larger unit")
        _check_order(around, limits)
        return as_float, limits
    whole = _of_enum(enum) if enum is not None and enum.entries else _of_number(around, stored, steps)
    _check_order(around, whole)
    storage = storage_of(*whole)
    if storage is None:
        around.bad(
            "max",
            f"{around.name} goes from {whole[0]} to {whole[1]}, which 64 bits do not hold",
            BEYOND_STORAGE,
            hint="narrow min and max, or keep the quantity in a coarser unit: stored",
        )
        return Storage.SMALL, whole
    if storage is not Storage.SMALL and not _is_plain(around):
        beyond = "min" if whole[0] < -SMALL_INT_MAX else "max"
        message = f"{beyond} of {around.name} is beyond {SMALL_INT_MAX} in stored units, the most that can be compared"
        around.bad(beyond, message, BEYOND_STORAGE, "narrow it, or keep the quantity in a coarser unit")
        return Storage.SMALL, whole
    return storage, whole


def _check_order(around: Surroundings, limits: Limits) -> None:
    if limits[0] > limits[1]:
        around.bad("max", f"max of {around.name} is below its min", hint="swap them, or leave out one")


def _of_enum(enum: EnumDefinition) -> tuple[int, int]:
    """Return the smallest and the largest entry; of a bitmask the limits of any flags."""
    values = [entry.value for entry in enum.entries]
    if not enum.is_bitmask:
        return min(values), max(values)
    return 0, max(SMALL_INT_MAX, (1 << max(values).bit_length()) - 1)


def _of_number(around: Surroundings, stored: Unit, steps: Fraction) -> tuple[int, int]:
    """The limits that are written; else what a word holds, or the widest field that takes the number as it is kept."""
    if given := [_given(output, stored) for _, output in around.outputs()]:
        low, high = min(ends[0] for ends in given), max(ends[1] for ends in given)
        return _within(around, steps, low, high)
    low, high = -SMALL_INT_MAX, SMALL_INT_MAX
    ranges = [_range(field) for field in around.carriers if field.type.is_integer and _is_in(field, stored)]
    if _is_plain(around) and len(ranges) == len(around.carriers):
        low, high = min([low, *(each[0] for each in ranges)]), max([high, *(each[1] for each in ranges)])
        if high > SMALL_INT_MAX and ranges and min(each[0] for each in ranges) == 0:
            low = 0  # so that all the bits are those of the number
    return _within(around, steps, low, high)


def _within(around: Surroundings, steps: Fraction, low: int, high: int) -> tuple[int, int]:
    """The limits that are written, or else those that are given."""
    spec = around.spec
    if spec.min is not None:
        low = around.in_steps("min", spec.min, steps)
    if spec.max is not None:
        high = around.in_steps("max", spec.max, steps)
    return low, high


def _given(output: Output, stored: Unit) -> tuple[int, int]:
    """Return what a sensor can give, in stored steps; where its unit does not convert, that is reported elsewhere."""
    factor = ratio(output.unit, stored)
    if factor is None:
        return -SMALL_INT_MAX, SMALL_INT_MAX
    return rounded(output.low * factor, Rounding.NEAREST), rounded(output.high * factor, Rounding.NEAREST)


def _range(field: WireField) -> tuple[int, int]:
    """Return what a field carries, but for a sentinel at an end."""
    low, high = field.type.minimum, field.type.maximum
    sentinels = set(field.sentinel.values) if field.sentinel else set()
    return low + (low in sentinels and low != 0), high - (high in sentinels)


def _initial(
    around: Surroundings, kind: QuantityKind, enum: EnumDefinition | None, steps: Fraction, storage: Storage
) -> int | Fraction | str | None:
    written, name = around.spec.initial, around.name
    if kind is QuantityKind.BOOLEAN:
        is_set = not any(each.GIVES_BOOLEAN and each.is_named for each in around.spec.derivations)
        if is_set and not isinstance(written, bool):
            around.bad("initial", f"the boolean {name} needs initial: true or false", hint="initial: false")
        return int(written is True)
    if written is None:
        return None
    if kind is QuantityKind.TEXT:
        return _initial_text(around, written)
    if isinstance(written, bool) or (kind is QuantityKind.NUMBER) != isinstance(written, Fraction):
        wanted = "a number" if kind is QuantityKind.NUMBER else "an entry of its enum"
        around.bad(
            "initial",
            f"initial of {name} is not {wanted}",
            hint="initial: 0" if kind is QuantityKind.NUMBER else f"name an entry of {around.spec.enum}",
        )
        return None
    if isinstance(written, Fraction):
        return storage.nearest(written * steps) if storage.is_float else around.in_steps("initial", written, steps)
    entry = enum.entry(written) if enum else None
    if enum is not None and entry is None:
        names = [entry.name for entry in enum.entries]
        around.bad("initial", f"{enum.name} has no entry {written}", UNKNOWN_ENTRY, did_you_mean(written, names))
    return entry.value if entry else None


def _initial_text(around: Surroundings, written: str | bool | Fraction) -> str | None:
    length = around.spec.text
    assert length is not None
    if not isinstance(written, str):
        around.bad("initial", f"initial of {around.name} is not a text", hint=f"initial: '{_as_written(written)}'")
        return None
    if cut(written, length) != written:
        problem = (
            "has a NUL in it" if NUL in written else f"is {len(written.encode())} bytes long, and {length} are kept"
        )
        around.bad("initial", f"initial of {around.name} {problem}", hint=f"initial: '{cut(written, length)}'")
    return written


def _as_written(value: bool | Fraction) -> str:
    return str(value).lower() if isinstance(value, bool) else decimal(value)
