"""Readings of quantities with one value for each element: from the fields of one message, or from its pages."""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from codegen.answers.page import PageAnswer
from codegen.answers.scaled import to_unit
from codegen.model.answers.answer import Answer
from codegen.model.code.reading import Reading, scaled
from codegen.model.units.unit import decimal

if TYPE_CHECKING:
    from codegen.answers.each.answer import EachAnswer


def element_readings(parts: Sequence["EachAnswer"], answers: Sequence[Answer]) -> Iterator[Reading]:
    """The quantity of which a message carries single values, and the sum that goes out in their place.

    ``parts`` are the answers of the message that take some of the values, ``answers`` all of it. The values of several
    fields follow one another. Where the message goes out in pages, a reading is the values by the number of the first
    one.
    """
    parts = sorted(parts, key=lambda part: part.first)
    source = parts[0].source
    pages = [answer for answer in answers if isinstance(answer, PageAnswer)]
    values = " + ".join(f"{_values(part)}" for part in parts)
    uses: tuple[str, ...] = ("values_of",)
    if pages and any(part.is_paged for part in parts):
        field = pages[0].covers.field.name
        expression, uses = f'page(get("{field}"), {values})', (*uses, "page")
    else:
        full = [part.fallback.element_high for part in parts if part.fallback]
        expression, uses = f"single({values}, {_full(parts[0], full)})", (*uses, "single")
    label = parts[0].covers.label
    yield Reading(source.name, expression, source.unit.name, source.spec.doc, label, uses=uses, is_by_element=True)
    yield from _sum(parts)


def _values(part: "EachAnswer") -> str:
    """The values of a field that are there, as a tuple in the unit of the quantity."""
    covers, factor = part.covers, to_unit(part.source, part.scaling)
    kept = ", keep=True" if part.is_paged else ""
    place = f'raw("{covers.field.name}"), {covers.first}, {covers.count}, {part.unknown}'
    return f"values_of({place}, {factor.numerator}, {factor.denominator}{kept})"


def _full(part: "EachAnswer", full: list[int]) -> str:
    """Return what an element holds whose rest is in the next one, in the quantity's
    unit; None where nothing is spread.
    """
    return decimal(full[0] * to_unit(part.source, part.scaling)) if full else "None"


def _sum(parts: Sequence["EachAnswer"]) -> Iterator[Reading]:
    """The quantity that is spread over the elements while one is unknown: it is their sum in either case."""
    for part in parts:
        if part.fallback is None:
            continue
        source = part.fallback.source
        sums = [
            f'joined(raw("{each.covers.field.name}"), {each.covers.first}, {each.covers.count}, {each.unknown})'
            for each in parts
        ]
        whole = sums[0] if len(sums) == 1 else f"added({', '.join(sums)})"
        expression, uses = scaled(whole, to_unit(source, part.fallback.scaling))
        uses = (*uses, "joined", "added") if len(sums) > 1 else (*uses, "joined")
        yield Reading(source.name, expression, source.unit.name, source.spec.doc, part.covers.label, uses=uses)
