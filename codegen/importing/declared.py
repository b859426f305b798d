"""Compares type, unit and value for unknown of a field in a document with the dialect."""

import re
from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.importing.answer import Target
from codegen.importing.columns import Role
from codegen.importing.number import stated_number
from codegen.importing.stated import StatedField
from codegen.load.markdown_table import Cell
from codegen.model.dialect.literals import same_number
from codegen.model.dialect.wire_types import WIRE_TYPES
from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import Unit, conversion

DOCUMENT_TYPE = Rule("document-type", "A document states another type for a field than the dialect.")
DOCUMENT_UNIT = Rule("document-unit", "A document states another unit for a field than the dialect.")
DOCUMENT_UNKNOWN = Rule(
    "document-unknown",
    "A document states another value for unknown than the sentinel of the field in the dialect, corrections included, "
    "or one for a field that has none.",
)

_NO_UNIT = ("", "-", "\u2013", "\u2014", "none", "n/a", "1")
_STEP = re.compile(
    r"(?:(?P<step>1 ?/ ?\d{1,9}|\d{1,9}(?:[.,]\d{1,9})?)(?: ?[x\u00d7*\u00b7] ?| ?))?(?P<unit>[^\d\s].*)"
)
_TYPE = re.compile(r"(u?)int_?(\d{1,2})(?:_t)?|([uif])(\d{1,2})|(float|double|char)", re.IGNORECASE)


def check_declared(row: StatedField, target: Target, report: Report) -> None:
    """Report where type, unit or sentinel of a row are others than in the dialect, corrections included."""
    definition = target.field.definition
    related = [(definition.place, f"{definition.name} is declared here")]
    written = row.cells.get(Role.TYPE)
    if written is not None and written.text:
        wanted = definition.type if definition.length is None else f"{definition.type}[{definition.length}]"
        if not _is_type(written.text, target):
            text = f"{target.name} is {wanted} in the dialect, not {written.text}"
            report.add(DOCUMENT_TYPE, written.place, text, f"write {wanted}", related)
    unit = row.cells.get(Role.UNIT)
    if unit is not None and unit.text.casefold() not in _NO_UNIT and not _is_unit(unit.text, target):
        wanted = definition.units or "nothing"
        text = (
            f"{target.name} is in {definition.units} in the dialect"
            if definition.units
            else f"{target.name} has no unit"
        )
        report.add(DOCUMENT_UNIT, unit.place, f"{text}, not in {unit.text}", f"write {wanted}", related)
    unknown = row.cells.get(Role.UNKNOWN)
    if unknown is not None and unknown.text:
        _check_unknown(unknown, target, report)


def _is_unit(text: str, target: Target) -> bool:
    """Return whether a text is the unit of the field: in its spelling, in words, or as a step, 0.01 degrees Celsius."""
    if text == (target.field.definition.units or ""):
        return True
    own, match = Unit.parse(target.field.definition.units), _STEP.fullmatch(text.strip("[]() "))
    unit = worded_unit(match["unit"]) if match is not None else None
    if own is None or unit is None or match is None:
        return False
    step = Fraction(match["step"].replace(" ", "").replace(",", ".") if match["step"] else 1)
    turned = conversion(own, unit)
    return turned is not None and turned.ratio == step


def _check_unknown(cell: Cell, target: Target, report: Report) -> None:
    """A cell with the value for unknown; words say nothing about the number."""
    stated = stated_number(cell.text, target)
    if stated is None or same_number(stated, target.sentinel):
        return
    sentinel = target.field.sentinel
    if sentinel is None or target.sentinel is None:
        text = f"{target.name} has no value for unknown in the dialect, and {cell.text} here"
        related = [(target.field.definition.place, f"{target.field.name} is declared here")]
        report.add(DOCUMENT_UNKNOWN, cell.place, text, "state it in a correction, or leave it out", related)
        return
    text = f"{target.name} is unknown when it is {sentinel.written}, not {cell.text}"
    related = [(sentinel.place, f"invalid={sentinel.written!r} is stated here")]
    report.add(DOCUMENT_UNKNOWN, cell.place, text, f"write {target.sentinel}", related)


def _is_type(text: str, target: Target) -> bool:
    """Return whether a text is the type of the field, in the spelling of C, of Rust
    or of the dialect, with its length.
    """
    name, _, length = text.replace(" ", "").replace("\\", "").partition("[")
    definition = target.field.definition
    if length and length.rstrip("]") != str(definition.length):
        return False
    if not length and definition.length is not None and target.count == definition.length:
        return False
    match = _TYPE.fullmatch(name)
    if match is None:
        return name == definition.type
    unsigned, bits, letter, size, other = match.groups()
    if bits:
        spelt = f"{unsigned.lower()}int{bits}_t"
    elif letter:
        spelt = {"u": f"uint{size}_t", "i": f"int{size}_t", "f": "float" if size == "32" else "double"}[letter.lower()]
    else:
        spelt = other.lower()
    return WIRE_TYPES[spelt].name == target.field.type.name if spelt in WIRE_TYPES else False
