"""The pages of a message that is sent once for as many values of a quantity as it holds."""

from codegen.answers.scope import Pages, Scope
from codegen.diagnostics import Rule

BAD_PAGES = Rule(
    "bad-pages",
    "A message with pages is sent for_each component, one of its fields takes the values of the quantity with each, "
    "without from, and one that can count that far has the number of the first value: {page: true}.",
)


def find_pages(scope: Scope) -> Pages | None:
    """The pages of the message; None where it has none, or after a finding."""
    population, report = scope.population, scope.report
    if population.pages is None:
        return None
    place = population.at("pages")
    quantity = scope.quantity(population.pages, place)
    if quantity is None:
        return None
    if quantity.elements is None:
        report.add(BAD_PAGES, place, f"{quantity.path} is one value", "pages are made of a quantity with elements")
        return None
    if population.for_each != quantity.component:
        report.add(
            BAD_PAGES,
            place,
            f"the message is not sent for each {quantity.component}",
            hint=f"for_each: {quantity.component}",
        )
        return None
    takers = [covers for covers in scope.elements if covers.written.each == quantity.path]
    if len(takers) != 1:
        fields = "no field takes" if not takers else "several fields take"
        report.add(
            BAD_PAGES,
            place,
            f"{fields} the values of {quantity.path}",
            hint=f"answer one field with {{each: {quantity.path}}}",
        )
        return None
    if not any(covers.written.page for covers in scope.elements):
        hint = "a field with {page: true} says which page it is"
        report.add(BAD_PAGES, place, "receivers could not tell the pages apart", hint)
        return None
    size = takers[0].count
    return Pages(quantity, size, -(-max(quantity.elements) // size))
