"""Factors of fields whose unit depends on something else: "for local frames metres times 1e3" of `x` and `y`.

Such fields have no unit in the dialect, but several in their descriptions: "local: x position in meters * 1e4, global:
latitude in degrees * 10^7". The factor stands far behind their names, or in the next sentence.
"""

from collections.abc import Iterator

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import ASKED, CHANGED, DENIED, MISTAKEN, OWN, PAST, REPLACED, SUPPOSED, words
from codegen.claims.rules import SCALING, as_sure
from codegen.claims.statements.scaling.field_units import described_units, has_unit, shown_units
from codegen.claims.statements.subjects import about
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_TIMES = pattern(r"\s(?:times|multiplied|scaled)\s|[*\u00d7]")
_NOT = words(ASKED, CHANGED, DENIED, MISTAKEN, OWN, PAST, REPLACED, SUPPOSED, r"\bplanner\b", r"\bfile\b")
_FAR = 300
"""Characters before a factor in which the fields are named."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every factor that the descriptions of the fields before it do not have."""
    if span.is_code or span.kind is PassageKind.ROW:
        return
    for offset, term in span.sentence.within(0, len(span.text), "U"):
        unit = term.value
        if (
            not isinstance(unit, Unit)
            or not _TIMES.search(term.written)
            or _NOT.search(span.text, *span.bounds(offset))
        ):
            continue
        named = (about(reading, span, at) for at, _ in span.sentence.within(max(offset - _FAR, 0), offset, "FP"))
        meant = [
            one
            for one in named
            if one is not None and any(each.dimension == unit.dimension for each in described_units(one.field))
        ]
        if meant and not any(has_unit(one.field, unit) for one in meant):
            one = meant[-1]
            text = f"{one.name} is in {shown_units(one.field)}, not {' '.join(term.written.split())}"
            yield reading.found(as_sure(SCALING, is_sure=False), span.place(offset), f"{one.name} {unit.name}", text)
