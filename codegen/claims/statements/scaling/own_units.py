"""Two units of one field beside each other, of which the second is its own: "shown in V; the link has mV"."""

from collections.abc import Collection

from codegen.claims.parts.sentence import NamedField, Term
from codegen.claims.parts.span import Span
from codegen.claims.statements.scaling.field_units import has_unit, of_field
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit

_BEHIND = 110
"""Characters behind a unit in which the field's own one says that the two are told apart."""


def is_told_behind(span: Span, offset: int, field: WireField, names: Collection[int] = ()) -> bool:
    """Return whether the field's own unit is told behind another one, no name but ``names`` and its own between."""
    if span.is_code or span.kind is PassageKind.ROW or not field.definition.units:
        return False
    for at, term in span.sentence.within(offset + 1, offset + _BEHIND, "U"):
        between = [each for name, each in span.sentence.within(offset, at, "FPM") if name not in names]
        unit = term.value
        if not isinstance(unit, Unit) or any(not _is_named(each, field) for each in between):
            return False
        if _is_own(field, unit):
            return True
    return False


def _is_named(term: Term, field: WireField) -> bool:
    return isinstance(term.value, NamedField) and term.value.name == field.name


def _is_own(field: WireField, unit: Unit) -> bool:
    own = Unit.parse(field.definition.units)
    return own is not None and own.dimension == of_field(unit, field).dimension and has_unit(field, unit)
