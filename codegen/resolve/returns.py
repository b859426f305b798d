"""What comes back after it was gone, such as a pack that was exchanged: what counts that, and what begins anew then."""

from collections.abc import Iterator, Mapping

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.state_spec import ComponentSpec, QuantitySpec
from codegen.model.unit import NUMBER
from codegen.model.vehicle import Quantity, QuantityKind, Returns
from codegen.source import Place

BAD_RETURN = Rule(
    "bad-return",
    "One quantity of a component counts returns: a number without a unit and with an initial value. It names a boolean "
    "that follows a limit of what an ADC measures in the same component. What restarts with the count is a number that "
    "can be 0, or a boolean with an initial value, and set by code alone.",
)

_Problem = tuple[Place, str, str | None]


def resolve_returns(spec: ComponentSpec, quantities: Mapping[str, Quantity], report: Report) -> Returns | None:
    """What counts returns in a component; None, perhaps with findings, where nothing does."""
    counting = [name for name, written in spec.quantities.items() if written.counts_returns_of is not None]
    problems = [
        *(problem for name in counting for problem in _count_problems(name, spec, quantities)),
        *(problem for name in spec.quantities for problem in _restart_problems(name, spec, quantities, counting)),
    ]
    for place, message, hint in problems:
        report.add(BAD_RETURN, place, message, hint)
    for name in counting[1:]:
        related = [(spec.quantities[counting[0]].at("counts_returns_of"), f"{counting[0]} counts them, too")]
        place = spec.quantities[name].at("counts_returns_of")
        report.add(BAD_RETURN, place, "a component has one quantity that counts returns", None, related)
    if problems or len(counting) != 1 or counting[0] not in quantities:
        return None
    count = quantities[counting[0]]
    gone = quantities.get(count.spec.counts_returns_of or "")
    restarting = tuple(quantity for quantity in quantities.values() if quantity.spec.restarts_with is not None)
    return None if gone is None else Returns(count, gone, restarting)


def _count_problems(name: str, spec: ComponentSpec, quantities: Mapping[str, Quantity]) -> Iterator[_Problem]:
    written = spec.quantities[name]
    place, watched = written.at("counts_returns_of"), written.counts_returns_of or ""
    if watched not in spec.quantities:
        yield place, f"there is no quantity {watched}", did_you_mean(watched, spec.quantities)
    elif not _follows_a_reading(spec.quantities[watched], spec):
        message = f"{watched} is no boolean that follows a limit of what an ADC measures"
        yield place, message, f"{watched}: {{boolean: true, follows: voltage, below: 1.0, doc: ...}}"
    count = quantities.get(name)
    if count is not None and (count.kind is not QuantityKind.NUMBER or count.unit is not NUMBER or not _is_set(count)):
        yield place, f"{name} is no pure number that only code sets, so it cannot count", None
    elif count is not None and count.initial is None:
        yield place, f"{name} starts unknown, and nothing can be added to that", "initial: 0"


def _follows_a_reading(written: QuantitySpec, spec: ComponentSpec) -> bool:
    """As written: what cannot be resolved has been reported, and is no fault of the count."""
    followed = spec.quantities.get(written.follows or "")
    return written.follows is not None and (followed is None or followed.adc is not None)


def _restart_problems(
    name: str, spec: ComponentSpec, quantities: Mapping[str, Quantity], counting: list[str]
) -> Iterator[_Problem]:
    with_which = spec.quantities[name].restarts_with
    if with_which is None:
        return
    place = spec.quantities[name].at("restarts_with")
    if with_which not in spec.quantities:
        yield place, f"there is no quantity {with_which}", did_you_mean(with_which, counting or spec.quantities)
    elif with_which not in counting:
        yield place, f"{with_which} does not count returns", "counts_returns_of: names what returns"
    quantity = quantities.get(name)
    if quantity is None:
        return
    if name in counting or quantity.kind is QuantityKind.ENUM or not _is_set(quantity):
        yield place, f"{name} is not a number or a boolean that only code sets", None
    elif quantity.kind is QuantityKind.NUMBER and not quantity.minimum <= 0 <= quantity.maximum:
        yield place, f"{name} cannot be 0, from which it would start again", None


def _is_set(quantity: Quantity) -> bool:
    """Whether code sets the quantity, one value, and nothing else does."""
    derived = (quantity.conversion, quantity.trend, quantity.estimate, quantity.elements, quantity.enabled_by)
    return quantity.followed is None and all(each is None for each in derived)
