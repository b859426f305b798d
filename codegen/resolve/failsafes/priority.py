"""Resolves the order of actions for failsafes that are up together: ``priority`` of vehicle.yaml."""

from collections.abc import Iterable
from itertools import pairwise

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.failsafe import Failsafe
from codegen.model.spec.program import ActionSpec, VehicleSpec

BAD_PRIORITY = Rule(
    "bad-priority",
    "priority lists the calls of all actions once each, the most severe first: of what failsafes that are up ask for, "
    "the first one there holds. So a worse level of a failsafe cannot have an action that gives way to that of a "
    "milder level.",
    remedy="list the calls of actions alone, or declare the action in vehicle.yaml",
)


def resolve_priority(spec: VehicleSpec, failsafes: Iterable[Failsafe], report: Report) -> tuple[ActionSpec, ...]:
    """The actions, the most severe first; none where nothing is said, or something else than can be."""
    if not spec.priority:
        return ()
    place = spec.at("priority")
    by_call = {action.call: action for action in spec.actions}
    own = Report()
    for number, call in enumerate(spec.priority):
        if call not in by_call:
            own.add(BAD_PRIORITY, place, f"there is no action {call}", did_you_mean(call, by_call))
        elif call in spec.priority[:number]:
            own.add(BAD_PRIORITY, place, f"{call} has a place already", hint="leave out the second one")
    if missing := [call for call in by_call if call not in spec.priority]:
        hint = f"priority: [{', '.join([*dict.fromkeys(spec.priority), *missing])}] has them all; the most severe first"
        own.add(BAD_PRIORITY, place, f"{', '.join(missing)} has no place among the others", hint)
    for failsafe in failsafes:
        for milder, worse in pairwise(failsafe.levels):
            first, second = milder.action, worse.action
            if not isinstance(first, ActionSpec) or not isinstance(second, ActionSpec):
                continue  # a parameter chooses
            if first.call in spec.priority and second.call in spec.priority[spec.priority.index(first.call) + 1 :]:
                message = f"{worse.name} would {second.call}, which gives way to {first.call} of {milder.name}"
                own.add(BAD_PRIORITY, worse.spec.at("action"), message, f"{milder.name} is still up then")
    report.extend(own)
    return () if own.has_errors else tuple(by_call[call] for call in spec.priority)
