"""Rule for failsafes that are up at every value, or that no value ends."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.failsafe import Condition, Failsafe, Sense
from codegen.model.quantities.attainable import attainable
from codegen.model.quantities.holding import Bounds, Held, by_default, in_units, mildest, place_of
from codegen.model.quantities.reach import Reach
from codegen.model.system import System
from codegen.model.vehicle import Quantity

RULE = Rule(
    "no-good-value",
    "The conditions of a failsafe hold at every value that their quantity can have, one alone or several between them, "
    "so that it is up as soon as anything is known, or the vehicle is never armed; or no value ends a level that is "
    "up, since the hysteresis leaves none, and latch: false says otherwise. Take thresholds that leave values out, and "
    "a hysteresis that fits between a threshold and the end.",
    remedy="take thresholds that leave out some values of the quantity, or a smaller hysteresis",
)
BY_DEFAULT = Rule(
    "no-good-default",
    "With the defaults of parameters the conditions of a failsafe hold at every value of their quantity, or no value "
    "ends a level, until somebody sets others. Take defaults that leave values out, or 0 where that switches a "
    "threshold off.",
    Severity.WARNING,
    remedy="take a default that leaves out some values, or 0 where that switches the threshold off",
)

_ALWAYS_UP, _UNARMED, _NEVER_OVER = "is always up", "never lets the vehicle be armed", "is never over"
Limits = Callable[[Condition], int | None]
"""The threshold of a condition in stored units, None for one that is switched off."""


def check(system: System) -> Iterator[Diagnostic]:
    """Every failsafe: its levels, what has to be better before each is over, and what is looked at for arming."""
    found = attainable(system)
    for failsafe in system.program.failsafes if system.program else ():
        for rule, limits in ((RULE, mildest), (BY_DEFAULT, by_default)):
            told = list(_of_failsafe(failsafe, found, rule, limits))
            yield from told
            if told:
                break  # defaults are no better


def _of_failsafe(failsafe: Failsafe, found: Mapping[str, Reach], rule: Rule, limits: Limits) -> Iterator[Diagnostic]:
    told = list(_held(failsafe.conditions, limits, failsafe, found))
    if told:
        yield from (_told(rule, failsafe.name, _ALWAYS_UP, *each) for each in told)
        return
    if failsafe.to_arm:
        asked = (*failsafe.to_arm, *(failsafe.conditions if failsafe.spec.arming else ()))
        yield from (_told(rule, failsafe.name, _UNARMED, *each) for each in _held(asked, limits, None, found))
    for level in failsafe.levels if failsafe.recovers else ():
        worse = [condition for each in failsafe.levels[level.number :] for condition in each.conditions]
        ended = partial(_ended, limits=limits, up=level.conditions)
        for each in _held((*level.conditions, *worse), ended, failsafe, found):
            yield _told(rule, f"{failsafe.name}, {level.name},", _NEVER_OVER, *each)


def _ended(condition: Condition, limits: Limits, up: tuple[Condition, ...]) -> int | None:
    """Return the threshold while the conditions of a level are up: those are over once it is better by so much."""
    limit = limits(condition)
    if limit is None or not any(condition is each for each in up):
        return limit
    return limit + condition.hysteresis * (1 if condition.sense is Sense.BELOW else -1)


def _held(
    conditions: Iterable[Condition], limits: Limits, failsafe: Failsafe | None, found: Mapping[str, Reach]
) -> Iterator[tuple[Quantity, Bounds]]:
    """Yield each quantity at whose every value one of the conditions holds; those of ``failsafe`` believe not all."""
    quantities: dict[str, tuple[Quantity, list[Held], list[Held], list[int]]] = {}
    for condition in conditions:
        quantity, limit = condition.quantity, limits(condition)
        if quantity is None or limit is None:
            continue
        _, below, above, floors = quantities.setdefault(quantity.path, (quantity, [], [], []))
        (below if condition.sense is Sense.BELOW else above).append((limit, condition))
        floor = failsafe.floor(condition) if failsafe else None
        floors += [] if floor is None else [floor + 1]
    for path, (quantity, below, above, floors) in quantities.items():
        low, high = found[path]
        bounds = Bounds(
            (max(low, *floors), high) if floors else (low, high),
            any(floor > low for floor in floors),
            max(below, key=lambda held: held[0], default=None),
            min(above, key=lambda held: held[0], default=None),
        )
        if bounds.everywhere:
            yield quantity, bounds


def _told(rule: Rule, who: str, what: str, quantity: Quantity, bounds: Bounds) -> Diagnostic:
    held, unit = bounds.everywhere, quantity.unit.name
    words = " or ".join(_words(limit, condition, quantity, is_up=what == _NEVER_OVER) for limit, condition in held)
    low, high = (in_units(end, quantity) for end in bounds.ends)
    reach = f"{'what is believed of it' if bounds.is_doubted else 'it'} goes from {low} to {high} {unit}".rstrip()
    message = f"{who} {what}: {quantity.path} is always {words}, as {reach}"
    last = max((condition for _, condition in held), key=lambda each: place_of(each).line or 0)
    others = [(place_of(each), f"{each.words} is here") for _, each in held if each is not last]
    hint = "leave values between what is too little and what is too much, with the hysteresis"
    if len(held) == 1:
        most = f"at most {high}" if last.sense is Sense.BELOW else f"at least {low}"
        slack = "and the hysteresis " if last.hysteresis and what == _NEVER_OVER else ""
        hint = f"take a threshold {slack}of {most} {unit}".rstrip()
    declared = (quantity.spec.place, f"{quantity.path} is declared here")
    return Diagnostic(place_of(last), rule, message, hint, (*others, declared))


def _words(limit: int, condition: Condition, quantity: Quantity, *, is_up: bool) -> str:
    """Return ``below 5 m``, or ``below 61.5 m (SHALLOW with a hysteresis of 60 m)`` while its level is up."""
    unit = quantity.unit.name
    why = [condition.limit.words] if condition.limit and condition.limit.parameter else []
    if is_up and condition.hysteresis:
        slack = f"with a hysteresis of {in_units(condition.hysteresis, quantity)} {unit}".rstrip()
        why = [condition.spec.below or condition.spec.above or "", slack]
    at = f"{condition.sense.value} {in_units(limit, quantity)} {unit}".rstrip()
    return f"{at} ({' '.join(why)})" if why else at
