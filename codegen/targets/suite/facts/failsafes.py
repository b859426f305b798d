"""Facts about failsafes for the generated tests: those that every check knows, and all that a pair of levels has."""

from codegen.frozen import dataclass
from codegen.model.failsafe import Clause, Condition, Failsafe, FailsafeText, Sense, Setting, Shown
from codegen.model.program import Program
from codegen.model.spec.program import ActionSpec
from codegen.model.system import System
from codegen.model.vehicle import Parameter, Quantity
from codegen.targets.naming import failsafe_function, parameter_attribute

USED = 1234
"""Steps of the other quantity that a text shows, in checks."""


@dataclass(frozen=True, slots=True)
class PairFacts:
    """A failsafe as checks of readings know it: latched, of a measured quantity, two levels below parameters.

    ``names`` are the attributes of its parameters by what they are for, ``families`` those of each instance. ``used``
    is the attribute of another quantity that its text shows, ``tails`` what stands behind the value: while that is
    unknown, and while it is ``USED``.
    """

    attribute: str
    component: str
    instances: int
    title: str
    quantity: str
    watched: str
    divisor: int
    words: tuple[str, str]
    names: dict[str, str | None]
    scales: dict[str, int]
    families: dict[str, tuple[str, ...]]
    level: str | None
    health: str | None
    health_every_ms: int
    used: str | None
    tails: tuple[str, str]
    enabled: str | None


@dataclass(frozen=True, slots=True)
class ConditionFacts:
    """A condition: the component's attribute, what it is compared with (a parameter and a factor, or an amount)."""

    level: int
    attribute: str | None
    sense: str
    limit: str | None
    factor: int
    is_off_at_zero: bool
    after: str | None
    after_ms: int
    slack: int
    low: int
    high: int


@dataclass(frozen=True, slots=True)
class WatchFacts:
    """Any failsafe, by its conditions; ``actions`` are by level: a parameter's attribute, a value, or None.

    ``period_us`` is the time between two readings of its component, with which it looks, or None: then it looks with
    all other checks.
    """

    attribute: str
    component: str | None
    watched: str | None
    period_us: int | None
    title: str
    levels: tuple[str, ...]
    actions: tuple[str | int | None, ...]
    conditions: tuple[ConditionFacts, ...]
    to_arm: tuple[ConditionFacts, ...]
    is_latched: bool
    is_always: bool
    forbids_arming: bool
    enabled_by: str | None
    floor: int | None
    level: str | None
    switch: str | None


def pair_facts(system: System, program: Program) -> tuple[PairFacts, ...]:
    """Return the pairs that the checks of readings are about."""
    return tuple(map(_pair, pairs(system, program)))


def pairs(system: System, program: Program) -> tuple[Failsafe, ...]:
    """Failsafes of two levels below parameters of what is measured, which the checks of readings are about."""
    measured = {reading.quantity.path for reading in system.readings() if reading.is_plain}
    return tuple(failsafe for failsafe in program.failsafes if _is_pair(failsafe, measured))


def _is_pair(failsafe: Failsafe, measured: set[str]) -> bool:
    spec = failsafe.spec
    first = [level.conditions[0] for level in failsafe.levels]
    return (
        failsafe.quantity is not None
        and failsafe.quantity.path in measured
        and failsafe.believed_above == 0
        and len(failsafe.levels) == 2
        and spec.latch
        and spec.arming
        and spec.when.value == "armed"
        and failsafe.enabled_by is None
        and len({level.text.written for level in failsafe.levels}) == 1
        and all(each.sense is Sense.BELOW and each.limit and each.limit.parameter for each in first)
        and all(each.after is not None and each.after.parameter is not None for each in first)
        and len({each.after.words for each in first if each.after}) == 1
        and all(isinstance(level.action, Parameter) for level in failsafe.levels)
    )


def _pair(failsafe: Failsafe) -> PairFacts:
    component, quantity = failsafe.component, failsafe.quantity
    assert component is not None
    assert quantity is not None
    read: dict[str, Parameter] = {}
    scales: dict[str, int] = {}
    for key, level in zip(("low", "critical"), failsafe.levels, strict=True):
        condition = level.conditions[0]
        assert condition.limit is not None
        assert condition.limit.parameter is not None
        assert isinstance(level.action, Parameter)
        read[key], scales[key] = condition.limit.parameter, condition.limit.count
        read[f"{key}_action"] = level.action
        assert condition.after is not None
        assert condition.after.parameter is not None
        read["after"] = condition.after.parameter
    least = next((each for each in failsafe.to_arm if each.quantity is quantity and each.sense is Sense.BELOW), None)
    if least is not None and least.limit is not None and least.limit.parameter is not None:
        read["minimum"], scales["minimum"] = least.limit.parameter, least.limit.count
    text = failsafe.levels[0].text
    used = next((part.quantity for part in _shown(text) if part.quantity is not quantity), None)
    families = {key: tuple(map(parameter_attribute, parameter.siblings)) for key, parameter in read.items()}
    return PairFacts(
        attribute=failsafe_function(failsafe.name),
        component=component.name,
        instances=component.instances,
        title=failsafe.title.replace("{number}", "1"),
        quantity=quantity.name,
        watched=quantity.attribute,
        divisor=int(quantity.steps),
        words=(failsafe.levels[0].name, failsafe.levels[1].name),
        names={"minimum": None, **{key: parameter_attribute(parameter.name) for key, parameter in read.items()}},
        scales={"minimum": 1, **scales},
        families={"minimum": (), **families},
        level=failsafe.level.attribute if failsafe.level else None,
        health=failsafe.health.attribute if failsafe.health else None,
        health_every_ms=failsafe.health_every_ms,
        used=used.attribute if used else None,
        tails=(_behind(text, quantity, None), _behind(text, quantity, USED)),
        enabled=component.enabled.name if component.enabled else None,
    )


def _shown(text: FailsafeText) -> list[Shown]:
    parts = [part.parts if isinstance(part, Clause) else (part,) for part in text.parts]
    return [part for each in parts for part in each if isinstance(part, Shown)]


def _behind(text: FailsafeText, watched: Quantity, used: int | None) -> str:
    """Return what stands behind the watched value, its unit first, while others are so many steps, or unknown."""
    said, is_behind = "", False
    for part in text.parts:
        is_clause = isinstance(part, Clause)
        parts = part.parts if isinstance(part, Clause) else (part,)
        if is_clause and used is None and not any(isinstance(p, Shown) and p.quantity is watched for p in parts):
            continue
        for each in parts:
            if isinstance(each, Shown) and each.quantity is watched:
                is_behind = True
            elif is_behind and isinstance(each, Shown):
                value = None if used is None else float(used / each.quantity.steps)
                said += each.unknown if value is None else f"{value:.{each.decimals}f}"
            elif is_behind and isinstance(each, str):
                said += each
    return said


def watch_facts(program: Program) -> tuple[WatchFacts, ...]:
    """All failsafes."""
    return tuple(_watch(failsafe, program) for failsafe in program.failsafes)


def _watch(failsafe: Failsafe, program: Program) -> WatchFacts:
    component = failsafe.component
    numbers = {id(condition): level.number for level in failsafe.levels for condition in level.conditions}
    return WatchFacts(
        attribute=failsafe_function(failsafe.name),
        component=component.name if component else None,
        watched=failsafe.quantity.attribute if failsafe.quantity else None,
        period_us=component.read_every_ms * 1000 if component and program.looks_with_readings(failsafe) else None,
        title=failsafe.title.replace("{number}", "1"),
        levels=tuple(level.name for level in failsafe.levels),
        actions=tuple(_action(level.action) for level in failsafe.levels),
        conditions=tuple(_condition(each, numbers[id(each)]) for each in failsafe.conditions),
        to_arm=tuple(_condition(each, 0) for each in failsafe.to_arm),
        is_latched=failsafe.spec.latch,
        is_always=failsafe.spec.when.value == "always",
        forbids_arming=failsafe.spec.arming,
        enabled_by=parameter_attribute(failsafe.enabled_by.name) if failsafe.enabled_by else None,
        floor=failsafe.believed_above,
        level=failsafe.level.attribute if failsafe.level else None,
        switch=component.enabled.name if component and component.enabled else None,
    )


def _action(action: Parameter | ActionSpec | None) -> str | int | None:
    if action is None:
        return None
    return parameter_attribute(action.name) if isinstance(action, Parameter) else action.value


def _condition(condition: Condition, level: int) -> ConditionFacts:
    quantity = condition.quantity
    return ConditionFacts(
        level=level,
        attribute=quantity.attribute if quantity else None,
        sense=condition.sense.value,
        limit=_parameter(condition.limit),
        factor=condition.limit.count if condition.limit else 0,
        is_off_at_zero=condition.limit.is_off_at_zero if condition.limit else False,
        after=_parameter(condition.after),
        after_ms=condition.after.count if condition.after else 0,
        slack=condition.hysteresis,
        low=int(quantity.minimum) if quantity else 0,
        high=int(quantity.maximum) if quantity else 0,
    )


def _parameter(setting: Setting | None) -> str | None:
    return parameter_attribute(setting.parameter.name) if setting and setting.parameter else None
