"""One quantity of the vehicle state: how it is kept, its limits, and where its value comes from."""

import keyword
import re
from collections.abc import Mapping
from fractions import Fraction

from codegen.derivations import resolve_derivation
from codegen.derivations.counts_returns import check_restart
from codegen.derivations.elements import resolve_elements
from codegen.derivations.follows import BAD_FOLLOWING
from codegen.derivations.surroundings import Kept, Surroundings
from codegen.diagnostics import Rule, did_you_mean
from codegen.measure import UNCARRIED_CONVERSION, UNIT_MISMATCH, find_unit, obstacle
from codegen.model.dialect import EnumDefinition
from codegen.model.spec import Requirement
from codegen.model.unit import Unit, ratio
from codegen.model.vehicle import SMALL_INT_MAX, Quantity, QuantityKind, Trust
from codegen.resolve.citation import cite_aspects, cite_optional

UNKNOWN_ENUM = Rule("unknown-enum", "A table names an enum that the dialect does not have.")
UNKNOWN_ENTRY = Rule("unknown-enum-entry", "A table names an entry that the enum of the dialect does not have.")

_IDENTIFIER = re.compile(r"[a-z][a-z0-9_]*")
# Names that the generated code uses itself, beside Python's own.
_RESERVED_QUANTITIES = {
    "instance",
    "number",
    "failures",
    "expires_ms",
    "warned_ms",
    "warn_above",
    "expire",
    "set_count",
    "forget",
    "keep",
    "gone",
    "has_returned",
}
_SUFFIX = {"%": "pct", "d%": "dpct", "c%": "cpct"}


def is_name(name: str) -> bool:
    """Whether the generated code can use a name as it is."""
    return bool(_IDENTIFIER.fullmatch(name)) and not keyword.iskeyword(name)


def resolve_quantity(around: Surroundings, index: Mapping[str, Requirement]) -> Quantity | None:
    """The quantity; None after a finding. Every problem of it is reported before it is given up."""
    spec, report = around.spec, around.report
    citation = cite_optional(spec.requirement, spec.at("requirement"), index, report)
    _check(around)
    enum = _enum(around)
    kept = _kept(around, enum)
    if kept is None:
        return None
    trust = Trust(spec.invalid_after, around.time_ms("stale_after", spec.stale_after))
    derivation = resolve_derivation(kept, around)
    elements = resolve_elements(around)
    check_restart(kept, around)
    if around.failed or derivation is None:
        return None
    return Quantity(
        component=around.component,
        name=around.name,
        attribute=_attribute(around.name, kept.kind, kept.stored),
        kind=kept.kind,
        unit=kept.unit,
        stored=kept.stored,
        steps=kept.steps,
        minimum=kept.minimum,
        maximum=kept.maximum,
        initial=kept.initial,
        enum=enum,
        elements=elements,
        derivation=derivation,
        trust=trust,
        spec=spec,
        citation=citation,
        aspects=cite_aspects(spec, index, report),
    )


def _check(around: Surroundings) -> None:
    """What can be told without the rest of the specification."""
    spec, name = around.spec, around.name
    if not is_name(name) or name in _RESERVED_QUANTITIES:
        around.bad("", f"{name} cannot be the name of a quantity", hint="choose another name")
    if spec.invalid_after is not None and not 1 <= spec.invalid_after <= 1000:
        around.bad("invalid_after", f"invalid_after of {name} is {spec.invalid_after}, not 1 to 1000")
    if not any(written.has_readings for written in spec.derivations):
        if spec.invalid_after is not None:
            around.bad("invalid_after", f"{name} has no adc, so invalid_after says nothing")
        if spec.stale_after is not None:
            _check_age(around)
    if spec.per_cell and not any(written.has_limit for written in spec.derivations):
        around.bad("per_cell", "per_cell says nothing without follows", BAD_FOLLOWING)


def _check_age(around: Surroundings) -> None:
    """Whether what no reading gives can become too old: code sets it, as a whole, and it can be unknown."""
    spec, name = around.spec, around.name
    if any(written.is_named for written in spec.derivations):
        around.bad("stale_after", f"{name} is not set by code, so stale_after says nothing")
    elif spec.boolean:
        around.bad("stale_after", f"{name} is a boolean, which is never unknown, so stale_after says nothing")
    elif spec.initial is not None:
        hint = "leave out one of them"
        around.bad(
            "stale_after", f"{name} has an initial value in place of unknown, so stale_after says nothing", hint=hint
        )
    elif spec.elements is not None:
        around.bad("stale_after", f"{name} has elements, each of which is set by itself: stale_after cannot tell when")


def _kept(around: Surroundings, enum: EnumDefinition | None) -> Kept | None:
    """How the quantity is kept; None without units."""
    spec = around.spec
    kind = _kind(around)
    unit = find_unit(spec.unit, spec.at("unit"), around.report)
    stored = unit if spec.stored is None else find_unit(spec.stored, spec.at("stored"), around.report)
    if unit is None or stored is None:
        return None
    steps = ratio(unit, stored)
    if steps is None:
        why = obstacle(unit, stored)
        message = f"{unit.name or 'a number'} cannot be kept in {stored.name}"
        around.bad("stored", f"{message}: {why}" if why else message, UNCARRIED_CONVERSION if why else UNIT_MISMATCH)
        return None
    minimum, maximum = _limits(around, steps, enum)
    initial = _initial(around, kind, enum, steps)
    if initial is not None and not minimum <= initial <= maximum:
        around.bad("initial", f"initial of {around.name} is not between its limits")
    return Kept(kind, unit, stored, steps, minimum, maximum, initial)


def _kind(around: Surroundings) -> QuantityKind:
    spec, name = around.spec, around.name
    kind = QuantityKind.NUMBER
    if spec.boolean:
        kind = QuantityKind.BOOLEAN
    elif spec.enum is not None:
        kind = QuantityKind.ENUM
    if kind is not QuantityKind.NUMBER:
        for key in ("unit", "stored", "min", "max"):
            if getattr(spec, key) is not None:
                around.bad(key, f"{name} is a {kind.value} quantity and cannot have {key}")
    if spec.boolean and spec.enum is not None:
        around.bad("enum", f"{name} cannot be both a boolean and an enum")
    return kind


def _enum(around: Surroundings) -> EnumDefinition | None:
    name, enums = around.spec.enum, around.dialect.enums
    if name is not None and name not in enums:
        around.bad("enum", f"the dialect has no enum {name}", UNKNOWN_ENUM, did_you_mean(name, enums))
    return None if name is None else enums.get(name)


def _limits(around: Surroundings, steps: Fraction, enum: EnumDefinition | None) -> tuple[int, int]:
    """The smallest and the largest value in stored units: of an enum those of its entries."""
    if enum is not None and enum.entries:
        values = [entry.value for entry in enum.entries]
        return (0, SMALL_INT_MAX) if enum.is_bitmask else (min(values), min(SMALL_INT_MAX, max(values)))
    spec = around.spec
    minimum = -SMALL_INT_MAX if spec.min is None else around.in_steps("min", spec.min, steps)
    maximum = SMALL_INT_MAX if spec.max is None else around.in_steps("max", spec.max, steps)
    if minimum > maximum:
        around.bad("max", f"max of {around.name} is below its min")
    return minimum, maximum


def _initial(around: Surroundings, kind: QuantityKind, enum: EnumDefinition | None, steps: Fraction) -> int | None:
    written, name = around.spec.initial, around.name
    if kind is QuantityKind.BOOLEAN:
        is_set = not any(each.GIVES_BOOLEAN and each.is_named for each in around.spec.derivations)
        if is_set and not isinstance(written, bool):
            around.bad("initial", f"the boolean {name} needs initial: true or false")
        return int(written is True)
    if written is None:
        return None
    if isinstance(written, bool) or (kind is QuantityKind.NUMBER) != isinstance(written, Fraction):
        wanted = "a number" if kind is QuantityKind.NUMBER else "an entry of its enum"
        around.bad("initial", f"initial of {name} is not {wanted}")
        return None
    if isinstance(written, Fraction):
        return around.in_steps("initial", written, steps)
    entry = enum.entry(written) if enum else None
    if enum is not None and entry is None:
        names = [entry.name for entry in enum.entries]
        around.bad("initial", f"{enum.name} has no entry {written}", UNKNOWN_ENTRY, did_you_mean(written, names))
    return entry.value if entry else None


def _attribute(name: str, kind: QuantityKind, stored: Unit) -> str:
    """The firmware's name of the integer: a number without a unit has a suffix, too, so that its name can check it."""
    suffix = _SUFFIX.get(stored.name) or re.sub(r"[^a-z0-9]+", "_", stored.name.lower()).strip("_")
    if kind is QuantityKind.NUMBER:
        return f"{name}_{suffix or 'number'}"
    return name
