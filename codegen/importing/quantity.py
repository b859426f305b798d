"""Quantities of the vehicle state in a document: their units, factors and casts, held against the dialect."""

import re

from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.importing.answer import UNREAD, Reading, Sources, Target
from codegen.load.expression import Product
from codegen.load.markdown_table import Cell
from codegen.model.dialect.literals import LIMITS
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.units.unit import Unit, decimal, ratio, symbols, unit_named
from codegen.model.units.unit_table import SCALED, SHOWN

DOCUMENT_QUANTITY = Rule(
    "document-quantity",
    "A document names a quantity that the state of the project does not have.",
    remedy="write it in state.yaml first, or name one that is there",
)
DOCUMENT_FACTOR = Rule(
    "document-factor",
    "A document multiplies a quantity with a number that does not lead from its unit to that of the field.",
)
DOCUMENT_CAST = Rule(
    "document-cast",
    "A document casts a value to a type in which it ends at a number that means unknown, or to another type than the "
    "field's. The tables limit every value to what the field can carry, sentinel excluded.",
    Severity.WARNING,
)

_SPILLS = re.compile(r"\bcell 0\b.*\bremain|\bspill", re.IGNORECASE | re.DOTALL)
_WORD = re.compile(r"[a-z]+")


def read_quantity(product: Product, cell: Cell, target: Target, sources: Sources, report: Report) -> Reading:
    """A product of a quantity becomes ``{state: ...}``: the factor follows from the units, and a cast from the type."""
    _check_cast(product, cell, target, report)
    if sources.quantities is not None and product.path not in sources.quantities:
        if product.path.endswith(".instance") and target.field.definition.is_instance:
            return Reading(f"{{state: {product.path}}}")
        hint = did_you_mean(product.path, sources.quantities)
        report.add(DOCUMENT_QUANTITY, cell.place, f"the state has no quantity {product.path}", hint)
        return UNREAD
    if not _is_factor_right(product, cell, target, sources, report):
        return UNREAD
    return Reading(state_answer(product.path, target))


def state_answer(path: str, target: Target) -> str:
    """The answer that reads a quantity; where the dialect lets the first element spill over, it is split."""
    if target.count == target.field.count and spills(target):
        return f"{{state: {path}, split: true}}"
    return f"{{state: {path}}}"


def spills(target: Target) -> bool:
    """Return whether the dialect's text lets what one element cannot hold go into the
    next, as in BATTERY_STATUS.voltages.
    """
    return target.field.is_array and _SPILLS.search(target.field.definition.description) is not None


def likely_quantity(text: str, target: Target, sources: Sources) -> str | None:
    """The answer with the one quantity whose names all stand in the text, the field or the message; None if unsure."""
    given = _words(text) | _words(target.field.name) | _words(target.message.name)
    unit = field_unit(target)
    fitting = [
        path
        for path, of in (sources.quantities or {}).items()
        if _words(path) <= given and (unit is None or ratio(of, unit) is not None)
    ]
    return state_answer(fitting[0], target) if len(fitting) == 1 else None


def field_unit(target: Target) -> Unit | None:
    """The unit of the field; None for one that is not known."""
    return wire_unit(target.field)


def _words(text: str) -> set[str]:
    """The words in small letters, each also without a plural s."""
    words = set(_WORD.findall(text.casefold()))
    return words | {word.removesuffix("s") for word in words}


def _is_factor_right(product: Product, cell: Cell, target: Target, sources: Sources, report: Report) -> bool:
    """Return whether the factor leads from the unit of the quantity to that of the field."""
    wire = field_unit(target)
    if wire is None:
        return True
    counted = target.field.unit_text or "steps"
    if sources.quantities is not None:
        unit = sources.quantities[product.path]
        factor = ratio(unit, wire)
        if factor == product.factor or (product.factor == 1 and factor is not None):
            return True  # without a factor the document names the quantity only
        named = unit.name or "a number"
        message = f"{product.path} ({named}) times {decimal(product.factor)} is not in {counted}"
        hint = (
            f"{target.name} needs a factor of {decimal(factor)}" if factor else f"{named} does not become {wire.name}"
        )
        report.add(DOCUMENT_FACTOR, cell.place, message, hint)
        return False
    is_known = any(ratio(unit_named(name), wire) == product.factor for name in (*symbols(), *SHOWN, *SCALED))
    if product.factor != 1 and not is_known:
        message = f"{product.path} times {decimal(product.factor)} is in {counted} for no unit that is known"
        report.add(DOCUMENT_FACTOR, cell.place, message, "write the quantity, or another factor")
        return False
    return True


def _check_cast(product: Product, cell: Cell, target: Target, report: Report) -> None:
    """Report what a cast of the document would do on the wire."""
    if product.cast is None:
        return
    cast, wire_type = WIRE_TYPES[product.cast], target.field.type
    if cast.name != wire_type.name:
        message = f"the document casts to {cast.name}, but {target.name} is {wire_type.name}"
        declared = (target.field.definition.place, f"{target.field.name} is declared here")
        report.add(DOCUMENT_CAST, cell.place, message, "the tables convert to the type of the field", [declared])
        return
    sentinel = target.sentinel
    if cast.is_integer and sentinel is not None and sentinel in (cast.maximum, cast.minimum):
        name = next((name for name, value in LIMITS.items() if value == sentinel and _is_of(name, cast.name)), sentinel)
        does = "the rest spills into the next element" if spills(target) else "the table does so by itself"
        end = sentinel - 1 if sentinel == cast.maximum else sentinel + 1
        message = f"a cast to {cast.name} ends at {sentinel} ({name}), which means unknown in {target.label}"
        report.add(DOCUMENT_CAST, cell.place, message, f"limit it to {end}; {does}")


def _is_of(limit: str, type_name: str) -> bool:
    return limit.casefold().startswith(type_name.removesuffix("_t") + "_")
