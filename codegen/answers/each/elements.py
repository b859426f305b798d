"""The elements of a field that take a value each: whether they can, how they say unknown, how many have room."""

from codegen.answers.fitting import NO_SENTINEL
from codegen.answers.scope import Scope
from codegen.diagnostics import Rule
from codegen.model.answers.answer import Elements
from codegen.model.dialect.dialect import Kind
from codegen.model.spec.population import Send
from codegen.model.vehicle import Quantity

BAD_EACH = Rule(
    "bad-each",
    "each takes a quantity with elements into the elements of an integer field of at most 32 bits; from counts from 0. "
    "Where one field has a fallback (state, with split), the fields of the message take the values from 0 on without a "
    "gap, because they go out together or not at all.",
)


def can_take(covers: Elements, quantity: Quantity, is_paged: bool, scope: Scope) -> bool:
    """Return whether the field takes values one by one, and the quantity has such; a finding if not."""
    written, field, report = covers.written, covers.field, scope.report
    place = written.at("each")
    if quantity.elements is None:
        report.add(BAD_EACH, place, f"{quantity.path} is one value for all", f"write {{state: {quantity.path}}}")
        return False
    if written.first < 0 or (is_paged and written.first):
        problem = "from has no meaning on pages" if is_paged else f"from is {written.first}"
        report.add(
            BAD_EACH, written.at("from"), problem, hint="leave from out" if is_paged else "from: 0 is the first value"
        )
        return False
    if field.type.kind is not Kind.CHAR and not (field.type.is_integer and field.type.size <= 4):
        report.add(
            BAD_EACH,
            place,
            f"{field.name} is a {field.type.name}, which cannot take values one by one",
            hint="each fills integer fields of at most 32 bits; answer this one otherwise",
        )
        return False
    return True


def has_all(covers: Elements, quantity: Quantity, first: int) -> bool:
    """Return whether there is a value for each of the elements, from the value ``first`` on, in every instance."""
    return min(quantity.elements or (0,)) >= first + covers.count


def unknown_of(covers: Elements, quantity: Quantity, scope: Scope) -> int | None:
    """The sentinel that every element has; None, with a finding, where they do not have the same one."""
    field = covers.field
    withheld = "withhold the message with 'send: while_known', which takes a value for each element, or "
    if scope.population.send is Send.WHILE_KNOWN:
        withheld = "send: while_known takes a value for each element of the field, and no pages; or "
    sentinels = set(field.sentinel.values[covers.first : covers.first + covers.count]) if field.sentinel else {None}
    unknown = sentinels.pop()
    if sentinels or not isinstance(unknown, int):
        scope.report.add(
            NO_SENTINEL,
            covers.written.at("each"),
            f"a value of {quantity.path} can be unknown or not there, and not every element of {field.name} can say so",
            f"{withheld}add the sentinel to the corrections file: invalid: '[0]'",
            [(field.definition.place, f"{field.name} is declared here")],
        )
        return None
    return unknown


def room_of(covers: Elements, scope: Scope) -> int | None:
    """Return how many values the fields of the message take together; None where none of them has a fallback.

    A finding where this field does not go on where the one before it ends.
    """
    written = covers.written
    takers = [other for other in scope.elements if other.written.each == written.each and other.written.first >= 0]
    if all(other.written.state is None for other in takers):
        return None
    room = 0
    for taker in sorted(takers, key=lambda other: other.written.first):
        if taker is covers and written.first != room:
            message = f"{covers.label} goes on at {written.first}, the fields before it end at {room}"
            scope.report.add(BAD_EACH, written.place, message, f"from: {room}")
        room = taker.written.first + taker.count
    return room
