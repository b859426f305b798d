"""The conditions of failsafes, and whether they become worse from level to level."""

from collections.abc import Sequence

from codegen.model.failsafe import Condition, FailsafeLevel, Sense
from codegen.model.spec.failsafe import ConditionSpec, FailsafeLevelSpec, FailsafeSpec
from codegen.model.vehicle import Quantity
from codegen.resolve.failsafes.scope import FailsafeScope


def level_conditions(
    scope: FailsafeScope, spec: FailsafeSpec, written: FailsafeLevelSpec, quantity: Quantity | None
) -> tuple[Condition, ...]:
    """Return the conditions of a level; findings are reported."""
    given = [key for key in ("below", "above", "unknown", "either") if getattr(written, key)]
    if quantity is None:
        for key in given:
            scope.bad(
                written,
                "or" if key == "either" else key,
                "silence is compared with a time alone: after",
                hint="leave it out, and write after: 5 s",
            )
        after = written.after or spec.after
        if after is None:
            scope.bad(written, None, "how long it may be silent is not said", "after: 5 s")
        delay = scope.settings.time(after, written.at("after") if written.after else spec.at("after"), None)
        return (Condition(Sense.SILENT, None, None, delay, 0, written),)
    if len(given) - ("either" in given) != 1:
        scope.bad(
            written,
            None,
            "a level says exactly one of below, above and unknown",
            hint="keep one, such as below: 3.3 V; others go under or",
        )
        return ()
    return (*_conditions(scope, (written,), spec, quantity), *_conditions(scope, written.either, spec, quantity))


def arming_conditions(scope: FailsafeScope, spec: FailsafeSpec, quantity: Quantity | None) -> tuple[Condition, ...]:
    """Return the conditions of ``to_arm``, which have no time."""
    for each in spec.to_arm:
        for key in ("after", "hysteresis"):
            if getattr(each, key) is not None:
                scope.bad(each, key, "what is looked at for arming has to hold for no time", hint=f"leave {key} out")
    return _conditions(scope, spec.to_arm, spec, quantity)


def _conditions(
    scope: FailsafeScope,
    written: Sequence[ConditionSpec | FailsafeLevelSpec],
    spec: FailsafeSpec,
    watched: Quantity | None,
) -> tuple[Condition, ...]:
    """Conditions on quantities; one of ``or`` is at once where it has no time of its own."""
    found = []
    for each in written:
        quantity = watched
        is_level = isinstance(each, FailsafeLevelSpec)
        if isinstance(each, ConditionSpec) and each.watches and watched:
            quantity = scope.quantity(each, "watches", each.watches, watched.component)
        if quantity is None:
            continue
        component = scope.components[quantity.component]
        sense = Sense.BELOW if each.below else Sense.ABOVE if each.above else Sense.UNKNOWN
        written_limit = each.below or each.above
        limit = None
        if written_limit is not None:
            limit = scope.settings.threshold(written_limit, each.at(sense.value), quantity, component)
        whose = each if each.after or not is_level else spec
        after = scope.settings.time(whose.after, whose.at("after"), component)
        whose = each if each.hysteresis or not is_level else spec
        slack = 0
        if whose.hysteresis is not None:
            slack = scope.settings.difference(whose.hysteresis, whose.at("hysteresis"), quantity) or 0
        found.append(Condition(sense, quantity, limit, after, slack, each))
    return tuple(found)


def check_order(scope: FailsafeScope, milder: FailsafeLevel, worse: FailsafeLevel) -> None:
    """Amounts have to become worse from level to level; of parameters the firmware says so before arming."""
    for one in milder.conditions:
        for other in worse.conditions:
            if one.sense is not other.sense or one.quantity is not other.quantity:
                continue
            first, second = (one.after, other.after) if one.limit is None else (one.limit, other.limit)
            if first is None or second is None or first.parameter or second.parameter:
                continue
            is_worse = second.count < first.count if one.sense is Sense.BELOW else second.count > first.count
            if not is_worse:
                key = "after" if one.limit is None else one.sense.value
                scope.bad(
                    other.spec,
                    key,
                    f"{worse.name} is no worse than {milder.name}, the level before it",
                    hint="order the levels from the mildest to the worst",
                )
