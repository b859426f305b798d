"""Answers with one value for each element, over the fields of a message or over its pages."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from codegen.diagnostics import Report, Rule
from codegen.model.dialect import Kind
from codegen.model.population_spec import PopulationSpec
from codegen.model.state_spec import StateSpec
from codegen.model.system import Binding, EachBinding, Elements, PageBinding, SplitBinding
from codegen.model.vehicle import Component, Quantity
from codegen.resolve.fixed import NO_SENTINEL, find_quantity
from codegen.resolve.limits import Bounds, check_reach, dialect_bounds, limits_of, written_bounds
from codegen.resolve.live import check_source, factor_of

BAD_EACH = Rule(
    "bad-each",
    "each takes a quantity with elements into the elements of an integer field of at most 32 bits; from counts from 0. "
    "Where one field has a fallback (state, with split), the fields of the message take the values from 0 on without a "
    "gap, because they go out together or not at all.",
)
BAD_PAGES = Rule(
    "bad-pages",
    "A message with pages is sent for_each component, one of its fields takes the values of the quantity with each, "
    "without from, and one that can count that far has the number of the first value: {page: true}.",
)


@dataclass(frozen=True, slots=True)
class Pages:
    """What the pages of a message are made of: ``size`` values of ``quantity`` on each of ``count`` pages."""

    quantity: Quantity
    size: int
    count: int


def find_pages(
    population: PopulationSpec,
    elements: Sequence[Elements],
    components: Mapping[str, Component],
    state: StateSpec,
    report: Report,
) -> Pages | None:
    """The pages of a message; None where it has none, or after a finding."""
    if population.pages is None:
        return None
    place = population.at("pages")
    quantity = find_quantity(population.pages, components, state, place, report)
    if quantity is None:
        return None
    if quantity.elements is None:
        report.add(BAD_PAGES, place, f"{quantity.path} is one value", "pages are made of a quantity with elements")
        return None
    if population.for_each != quantity.component:
        report.add(BAD_PAGES, place, f"the message is not sent for each {quantity.component}")
        return None
    takers = [covers for covers in elements if covers.answer.each == quantity.path]
    if len(takers) != 1:
        fields = "no field takes" if not takers else "several fields take"
        report.add(BAD_PAGES, place, f"{fields} the values of {quantity.path}")
        return None
    if not any(covers.answer.page for covers in elements):
        hint = "a field with {page: true} says which page it is"
        report.add(BAD_PAGES, place, "receivers could not tell the pages apart", hint)
        return None
    size = takers[0].count
    return Pages(quantity, size, -(-max(quantity.elements) // size))


def bind_page(covers: Elements, pages: Pages | None, is_paged: bool, report: Report) -> PageBinding | None:
    """The number of the first value on the page; ``is_paged`` tells whether the table speaks of pages at all."""
    place = covers.answer.at("page")
    if pages is None:
        if not is_paged:
            report.add(BAD_PAGES, place, "the message has no pages", "pages: component.quantity")
        return None
    field = covers.field
    last = (pages.count - 1) * pages.size
    if not field.type.is_integer or covers.count != 1 or field.type.maximum < last:
        report.add(BAD_PAGES, place, f"{field.name} cannot carry the number {last}, the first of the last page")
        return None
    return PageBinding(covers, pages.size)


def bind_each(
    covers: Elements, source: Quantity, fallback: SplitBinding | None, is_paged: bool, report: Report
) -> EachBinding | None:
    """One value for each of the covered elements, limited as every live value."""
    answer, field = covers.answer, covers.field
    place = answer.at("each")
    if source.elements is None:
        report.add(BAD_EACH, place, f"{source.path} is one value for all", f"write {{state: {source.path}}}")
        return None
    if answer.first < 0 or (is_paged and answer.first):
        problem = "from has no meaning on pages" if is_paged else f"from is {answer.first}"
        report.add(BAD_EACH, answer.at("from"), problem)
        return None
    if field.type.kind is not Kind.CHAR and not (field.type.is_integer and field.type.size <= 4):
        report.add(BAD_EACH, place, f"{field.name} is a {field.type.name}, which cannot take values one by one")
        return None
    unit = check_source(covers, source, "each", report)
    factor = None if unit is None else factor_of(covers, source, unit, "each", report)
    if unit is None or factor is None:
        return None
    sentinels = set(field.sentinel.values[covers.first : covers.first + covers.count]) if field.sentinel else {None}
    unknown = sentinels.pop()
    if sentinels or not isinstance(unknown, int):
        report.add(
            NO_SENTINEL,
            place,
            f"a value of {source.path} can be unknown or not there, and not every element of {field.name} can say so",
            "add the sentinel to the corrections file: invalid: '[0]'",
            [(field.definition.place, f"{field.name} is declared here")],
        )
        return None
    bounds = Bounds(source.minimum * factor, source.maximum * factor).within(dialect_bounds(field))
    written = written_bounds(answer, source.unit, source.unit.to(unit) or factor, report)
    limits = limits_of(field, unknown, bounds.within(written), factor, answer, report)
    if limits is None:
        return None
    check_reach(covers, written, limits, unknown, report)
    return EachBinding(
        covers=covers,
        source=source,
        first=answer.first,
        factor=factor,
        rounding=answer.rounding,
        low=limits.low,
        high=limits.high,
        unknown=unknown,
        hole=limits.hole,
        beside=limits.beside,
        is_paged=is_paged,
        fallback=fallback,
    )


def with_room(bindings: Iterable[Binding], report: Report) -> list[Binding]:
    """The bindings; those of one message that go out together know how many values it has room for."""
    bindings = list(bindings)
    each = [binding for binding in bindings if isinstance(binding, EachBinding) and not binding.is_paged]
    rooms: dict[str, int] = {}
    for path in {binding.source.path for binding in each if binding.fallback is not None}:
        takers = sorted((b for b in each if b.source.path == path), key=lambda binding: binding.first)
        room = 0
        for binding in takers:
            if binding.first != room:
                message = f"{binding.covers.label} goes on at {binding.first}, the fields before it end at {room}"
                report.add(BAD_EACH, binding.covers.answer.place, message, f"from: {room}")
            room = binding.first + binding.covers.count
        rooms[path] = room
    return [
        replace(binding, room=rooms.get(binding.source.path)) if isinstance(binding, EachBinding) else binding
        for binding in bindings
    ]
