"""Readings of quantities with one value for each cell: from the fields of one message, or from its pages."""

from collections.abc import Iterator

from codegen.model.system import EachBinding, PageBinding, PopulatedMessage
from codegen.model.unit import decimal
from codegen.targets.receiver.reading import Reading, scaled


def cell_readings(message: PopulatedMessage) -> Iterator[Reading]:
    """Each quantity of which the message carries single values, and the sum that goes out in their place.

    The values of several fields follow one another. Where the message goes out in pages, a reading is the values by the
    number of the first one.
    """
    sources = {binding.source.path: binding.source for binding in _each(message)}
    pages = [binding for binding in message.bindings if isinstance(binding, PageBinding)]
    for path, source in sources.items():
        parts = sorted((part for part in _each(message) if part.source.path == path), key=lambda part: part.first)
        values = " + ".join(f"{_values(part)}" for part in parts)
        uses = frozenset({"values_of"})
        if pages and any(part.is_paged for part in parts):
            field = pages[0].covers.field.name
            expression, uses = f'page(get("{field}"), {values})', uses | {"page"}
        else:
            full = [part.fallback.cell_high for part in parts if part.fallback]
            expression, uses = f"single({values}, {_full(parts[0], full)})", uses | {"single"}
        label = parts[0].covers.label
        yield Reading(source.name, expression, source.unit.name, source.spec.doc, label, uses=uses, is_by_cell=True)
        yield from _sum(parts)


def _each(message: PopulatedMessage) -> list[EachBinding]:
    return [binding for binding in message.bindings if isinstance(binding, EachBinding)]


def _values(part: EachBinding) -> str:
    """The values of a field that are there, as a tuple in the unit of the quantity."""
    covers, factor = part.covers, 1 / (part.factor * part.source.steps)
    kept = ", keep=True" if part.is_paged else ""
    place = f'raw("{covers.field.name}"), {covers.first}, {covers.count}, {part.unknown}'
    return f"values_of({place}, {factor.numerator}, {factor.denominator}{kept})"


def _full(part: EachBinding, full: list[int]) -> str:
    """What an element holds whose rest is in the next one, in the quantity's unit; None where nothing is spread."""
    return decimal(full[0] / (part.factor * part.source.steps)) if full else "None"


def _sum(parts: list[EachBinding]) -> Iterator[Reading]:
    """The quantity that is spread over the elements while a cell is unknown: it is their sum in either case."""
    for part in parts:
        if part.fallback is None:
            continue
        source = part.fallback.source
        sums = [
            f'joined(raw("{each.covers.field.name}"), {each.covers.first}, {each.covers.count}, {each.unknown})'
            for each in parts
        ]
        whole = sums[0] if len(sums) == 1 else f"added({', '.join(sums)})"
        expression, uses = scaled(whole, 1 / (part.fallback.factor * source.steps))
        uses |= {"joined", "added"} if len(sums) > 1 else {"joined"}
        yield Reading(source.name, expression, source.unit.name, source.spec.doc, part.covers.label, uses=uses)
