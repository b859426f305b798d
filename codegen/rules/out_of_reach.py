"""Rule for thresholds that no value can be beyond: what waits for them sleeps for ever."""

from collections.abc import Iterator, Mapping

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.failsafe import Condition, Failsafe, Sense
from codegen.model.program import VEHICLE_QUANTITIES, is_set_by_program
from codegen.model.quantities.attainable import attainable, attainable_by_default
from codegen.model.quantities.holding import easiest, in_units, is_reached, place_of
from codegen.model.quantities.reach import Reach
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Quantity
from codegen.source import Place

RULE = Rule(
    "threshold-out-of-reach",
    "A failsafe, or a boolean that follows a limit, waits for a value that its quantity cannot have: beyond the limits "
    "of the quantity, beyond what is plausible of the sensor, or beyond what the table of a received message takes. "
    "What is measured or received there is unknown, or left out, so that nothing would ever happen. So it is with what "
    "believed_above makes unknown. Widen the narrower range, or take a threshold within it.",
    remedy="take a threshold between these, or widen where the quantity comes from",
)
BY_DEFAULT = Rule(
    "default-out-of-reach",
    "A threshold lies where its quantity never comes by the defaults of parameters, that of the threshold or those of "
    "what an ADC measures the quantity with, so that nothing happens until somebody sets another value. Take "
    "defaults with which it is within reach, or 0 where that switches the threshold off.",
    Severity.WARNING,
    remedy="take a default between these, or 0 where that switches the threshold off",
)
KNOWN_FOR_EVER = Rule(
    "known-for-ever",
    "A failsafe waits until a received quantity is unknown, and nothing makes it so again when no message comes any "
    "more: at most a message that says so. With stale_after in state.yaml it is forgotten. Nor is one ever unknown "
    "that the program itself keeps from the start on, such as vehicle.load.",
    Severity.WARNING,
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every condition of a failsafe, and every boolean that follows a limit."""
    found, by_default = attainable(system), attainable_by_default(system)
    for failsafe in system.program.failsafes if system.program else ():
        for condition in failsafe.to_arm:
            yield from _of_condition(failsafe, condition, found, system)
        for condition in failsafe.conditions:
            told = tuple(_of_condition(failsafe, condition, found, system))
            told = told or tuple(_of_belief(failsafe, condition, found))
            yield from told or _of_factors(condition, by_default)
    for component in system.components.values():
        for quantity in component.quantities.values():
            followed = component.quantities.get(quantity.derivation.follows or "")
            if followed is not None:  # else what is wrong with it has been reported
                yield from _of_boolean(quantity, followed, found[followed.path])


def _of_condition(
    failsafe: Failsafe, condition: Condition, found: Mapping[str, Reach], system: System
) -> Iterator[Diagnostic]:
    quantity, limit = condition.quantity, condition.limit
    if quantity is None:
        return
    if limit is None:
        if condition.sense is Sense.UNKNOWN and _is_kept(quantity, system):
            message = f"{quantity.path} is never unknown: the program keeps it from the start on"
            yield Diagnostic(
                place_of(condition), KNOWN_FOR_EVER, message, f"leave {failsafe.name} out", _declared(quantity)
            )
        elif condition.sense is Sense.UNKNOWN and _is_never_forgotten(quantity):
            message = f"{quantity.path} is never unknown again once a message has set it"
            if _can_be_told(quantity, system):
                message += ", unless another one says so"
            hint = f"give it stale_after in state.yaml, so that {failsafe.name} notices that no message comes"
            yield Diagnostic(place_of(condition), KNOWN_FOR_EVER, message, hint, _declared(quantity))
        return
    widest, written = easiest(condition), _written(condition)
    is_below = condition.sense is Sense.BELOW
    if widest is not None and not is_reached(widest, found[quantity.path], is_below=is_below):
        yield _found(RULE, place_of(condition), quantity, found[quantity.path], written, is_below=is_below)
    elif limit.by_default is not None and not is_reached(limit.by_default, found[quantity.path], is_below=is_below):
        words = limit.default_words
        yield _found(BY_DEFAULT, place_of(condition), quantity, found[quantity.path], words, is_below=is_below)


def _of_belief(failsafe: Failsafe, condition: Condition, found: Mapping[str, Reach]) -> Iterator[Diagnostic]:
    """Yield what holds only at values that are not believed; on the other side all that is believed may be bad."""
    quantity, limit, floor = condition.quantity, condition.limit, failsafe.floor(condition)
    if quantity is None or limit is None or floor is None or condition.sense is not Sense.BELOW:
        return
    most = limit.ends[1] if limit.by_default is None else limit.by_default
    if most <= max(floor + 1, found[quantity.path][0]):
        written = f"{limit.default_words}," if limit.parameter else _written(condition)
        unknown = f"what is not above {failsafe.spec.believed_above} counts as unknown (believed_above)"
        message = f"{quantity.path} below {written} never holds: {unknown}"
        doubted = failsafe.spec.at("believed_above"), "what is believed is said here"
        hint = "leave out believed_above, or give it an amount that only a broken sensor tells, below the threshold"
        yield Diagnostic(place_of(condition), RULE, message, hint, (doubted, *_declared(quantity)))


def _of_factors(condition: Condition, by_default: Mapping[str, Reach]) -> Iterator[Diagnostic]:
    """Yield what is within reach by other values of the factors of an ADC alone."""
    quantity, limit = condition.quantity, condition.limit
    if quantity is None or limit is None or limit.by_default is None or quantity.path not in by_default:
        return
    ends, is_below = by_default[quantity.path], condition.sense is Sense.BELOW
    if not is_reached(limit.by_default, ends, is_below=is_below):
        words = f"{limit.default_words}," if limit.parameter else _written(condition)
        low, high = (in_units(end, quantity) for end in ends)
        message = (
            f"{quantity.path} is never {condition.sense.value} {words} by the defaults of what it is measured with: "
        )
        message += f"it goes from {low} to {high} {quantity.unit.name}".rstrip()
        hint = f"take a threshold {f'above {low}' if is_below else f'below {high}'}, or other defaults"
        yield Diagnostic(place_of(condition), BY_DEFAULT, message, hint, _declared(quantity))


def _of_boolean(quantity: Quantity, followed: Quantity, ends: Reach) -> Iterator[Diagnostic]:
    derivation, place = quantity.derivation, quantity.spec.place
    unit, steps = followed.unit.name, followed.steps
    for limits, is_below in ((derivation.own_limits, derivation.is_true_below), (derivation.own_floors, False)):
        # At least is as good as above the number before.
        wanted = max(limits, default=None) if is_below else min(limits, default=None)
        if wanted is not None and not is_reached(wanted if is_below else wanted - 1, ends, is_below=is_below):
            words = f"{decimal(wanted / steps)} {unit}".rstrip()
            yield _found(RULE, place, followed, ends, words, is_below=is_below)


def _is_never_forgotten(quantity: Quantity) -> bool:
    return quantity.derivation.is_received and quantity.trust.stale_after_ms is None


def _can_be_told(quantity: Quantity, system: System) -> bool:
    """Return whether a message can say that it is unknown."""
    fields = [taken for table in system.receptions for taken in table.fields if taken.quantity.path == quantity.path]
    return any(taken.sentinel_words or taken.is_unknown_by_nan for taken in fields)


def _is_kept(quantity: Quantity, system: System) -> bool:
    """Return whether the program writes it: one of the component vehicle, or the level or the health of a failsafe."""
    if quantity.trust.stale_after_ms is not None:
        return False
    if quantity.component == "vehicle" and quantity.name in VEHICLE_QUANTITIES:
        is_set = is_set_by_program(system.components.get("vehicle"), quantity.name)
        return is_set and (quantity.initial is not None or quantity.name == "load")
    if quantity.initial is None:
        return False
    kept = [
        each
        for failsafe in (system.program.failsafes if system.program else ())
        for each in (failsafe.level, failsafe.health)
    ]
    return any(each is quantity for each in kept)


def _found(rule: Rule, place: Place, quantity: Quantity, ends: Reach, words: str, *, is_below: bool) -> Diagnostic:
    low, high = (in_units(end, quantity) for end in ends)
    side = f"below {words}" if is_below else f"above {words}"
    message = f"{quantity.path} is never {side}: it goes from {low} to {high} {quantity.unit.name}".rstrip()
    hint = f"take a threshold {'above ' + low if is_below else 'below ' + high}, or widen where it comes from"
    return Diagnostic(place, rule, message, hint, _declared(quantity))


def _written(condition: Condition) -> str:
    return condition.spec.below or condition.spec.above or ""


def _declared(quantity: Quantity) -> tuple[tuple[Place, str], ...]:
    return ((quantity.spec.place, f"{quantity.path} is declared here"),)
