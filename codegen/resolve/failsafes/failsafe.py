"""Failsafes: what they watch, their levels with thresholds and times, and their actions."""

from collections.abc import Mapping
from itertools import pairwise

from codegen.diagnostics import Report
from codegen.measure import read_time
from codegen.model.failsafe import Failsafe, FailsafeLevel, FailsafeText
from codegen.model.spec.failsafe import GROUND_STATION, ConditionSpec, FailsafeLevelSpec, FailsafeSpec, Watching
from codegen.model.spec.program import VehicleSpec
from codegen.model.spec.spec import ParametersSpec, Requirement
from codegen.model.spec.state import StateSpec
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import Component, Parameter, Quantity
from codegen.pattern import pattern
from codegen.resolve.citation import cite, cite_aspects, cite_optional
from codegen.resolve.failsafes.condition import arming_conditions, check_order, level_conditions
from codegen.resolve.failsafes.scope import FailsafeScope
from codegen.resolve.failsafes.setting import SettingReader
from codegen.resolve.failsafes.text import read_text

_MOST_CONDITIONS = 30
"""Each is a bit of a small integer where the firmware asks which hold."""
_NOT_OF_SILENCE = ("believed_above", "hysteresis", "health", "health_every", "to_arm")


def resolve_failsafes(
    spec: VehicleSpec,
    written: ParametersSpec,
    parameters: Mapping[str, Parameter],
    components: Mapping[str, Component],
    state: StateSpec,
    index: Mapping[str, Requirement],
    report: Report,
) -> tuple[Failsafe, ...]:
    """The failsafes in the order of vehicle.yaml; one with a finding is left out, after all that is wrong with it."""
    found = []
    for name, failsafe in spec.failsafes.items():
        own = Report()
        settings = SettingReader(written, parameters, own)
        scope = FailsafeScope(settings, components, state, spec.actions, index, own)
        resolved = _failsafe(name, failsafe, scope, can_arm=spec.arming is not None)
        report.extend(own)
        if resolved is not None and not own.has_errors:
            found.append(resolved)
    return tuple(found)


def _failsafe(name: str, spec: FailsafeSpec, scope: FailsafeScope, *, can_arm: bool) -> Failsafe | None:
    if not pattern(r"[a-z][a-z0-9_]*").fullmatch(name):
        scope.bad(
            spec,
            None,
            f"{name!r} is no name of a failsafe: small letters, digits and _",
            hint="write it like 'engine' or 'low_oil'",
        )
    citation = cite(spec.requirement, spec.at("requirement"), scope.index, scope.report)
    quantity = None if spec.watches is None else scope.quantity(spec, "watches", spec.watches, None)
    if citation is None or (spec.watches is not None and quantity is None):
        return None
    if quantity is None:
        _check_silence(spec, scope)
    if not can_arm:
        _check_unarmed(spec, scope)
    watched = scope.components[quantity.component] if quantity else None
    level = scope.kept(spec, "level", spec.level, watched)
    health = scope.kept(spec, "health", spec.health, watched)
    component = watched or (scope.components[level.component] if level else None)
    every = believed = enabled_by = over = None
    if spec.health_every is not None:
        every = read_time(spec.health_every, unit_named("ms"), spec.at("health_every"), scope.report)
    if spec.believed_above is not None and quantity is not None:
        believed = scope.settings.amount(spec.believed_above, spec.at("believed_above"), quantity)
    if spec.enabled_by is not None:
        enabled_by = scope.settings.parameter(spec.enabled_by, spec.at("enabled_by"), component)
    if spec.latch:
        _check_latch(spec, scope)
    else:
        over = read_text(spec.over or "{name} is good again", spec.at("over"), component, quantity, scope.report)
    found = Failsafe(
        name=name,
        component=component,
        quantity=quantity,
        levels=_levels(spec, quantity, component, scope),
        to_arm=arming_conditions(scope, spec, quantity),
        title=_title(name, spec, component, scope),
        over=over,
        believed_above=believed,
        enabled_by=enabled_by,
        health=health,
        health_every_ms=every or 0,
        level=level,
        can_arm=can_arm,
        spec=spec,
        citation=citation,
        aspects=cite_aspects(spec, scope.index, scope.report),
    )
    _check_counts(found, scope)
    return found


def _check_silence(spec: FailsafeSpec, scope: FailsafeScope) -> None:
    if spec.silence != GROUND_STATION:
        hint = "a message or a sensor that stops is a quantity with stale_after: levels: {lost: {unknown: true}}"
        scope.bad(spec, "silence", f"{spec.silence} is nobody to wait for, but {GROUND_STATION} is", hint)
    for key in _NOT_OF_SILENCE:
        if getattr(spec, key):
            scope.bad(spec, key, f"{key} is about a quantity, and silence has none", hint=f"leave {key} out")


def _check_unarmed(spec: FailsafeSpec, scope: FailsafeScope) -> None:
    """Report what has no meaning where nothing is armed: a failsafe that rests until then, and what is asked before."""
    if spec.when is Watching.ARMED:
        message = "it rests until the vehicle is armed, and this one cannot be: vehicle.yaml has no arming"
        scope.bad(spec, "when", message, "write when: always")
    for each in spec.to_arm:
        scope.bad(each, None, "nothing is armed that this could keep from it", "write arming: {force: 21196}")


def _check_latch(spec: FailsafeSpec, scope: FailsafeScope) -> None:
    if spec.over is not None:
        scope.bad(spec, "over", "what is latched is never over", "write latch: false")
    records: list[FailsafeSpec | FailsafeLevelSpec | ConditionSpec] = [spec]
    for level in spec.levels.values():
        records += [level, *level.either]
    for record in records:
        if record.hysteresis is not None:
            scope.bad(record, "hysteresis", "what is latched does not end, hysteresis or not", "write latch: false")


def _title(name: str, spec: FailsafeSpec, component: Component | None, scope: FailsafeScope) -> str:
    several = component is not None and component.instances > 1
    if spec.title is None:
        return name.replace("_", " ").capitalize() + (" {number}" if several else "")
    rest = spec.title.replace("{number}", "")
    if not rest.strip():
        scope.bad(
            spec, "title", f"{spec.title!r} names nothing", hint="leave it out: without it the failsafe's name is shown"
        )
    elif set(rest) & set('{}"\\') or not spec.title.isprintable():
        scope.bad(
            spec,
            "title",
            f"{spec.title!r} is no title: of braces it has {{number}} alone, and no quotes",
            hint="write words, and {number} for the number of the instance",
        )
    elif several and "{number}" not in spec.title:
        scope.bad(spec, "title", "there are several, and the title says of none which it is", "put {number} into it")
    return spec.title


def _levels(
    spec: FailsafeSpec, quantity: Quantity | None, component: Component | None, scope: FailsafeScope
) -> tuple[FailsafeLevel, ...]:
    found = []
    for number, (name, written) in enumerate(spec.levels.items(), 1):
        if not pattern(r"[a-z][a-z0-9_ ]*").fullmatch(name):
            scope.bad(
                written,
                None,
                f"{name!r} is no name of a level: small letters, digits, _ and spaces",
                hint="write it like 'low' or 'critical'",
            )
        found.append(
            FailsafeLevel(
                name=name,
                number=number,
                conditions=level_conditions(scope, spec, written, quantity),
                action=scope.action(written, component),
                text=_text(spec, written, quantity, component, scope),
                citation=cite_optional(written.requirement, written.at("requirement"), scope.index, scope.report),
                spec=written,
            )
        )
    for milder, worse in pairwise(found):
        check_order(scope, milder, worse)
    return tuple(found)


def _text(
    spec: FailsafeSpec,
    level: FailsafeLevelSpec,
    quantity: Quantity | None,
    component: Component | None,
    scope: FailsafeScope,
) -> FailsafeText:
    """Return what is said when a level is reached: its own text, or that of the failsafe, or what all say."""
    written, place = (spec.text, spec.at("text")) if level.text is None else (level.text, level.at("text"))
    if written is None:
        value = f" {{value:.2}} {quantity.unit.name}".rstrip() if quantity is not None and not level.unknown else ""
        written = f"{{name}} is {{level}}{value}"
    return read_text(written, place, component, quantity, scope.report) or FailsafeText(written, ())


def _check_counts(failsafe: Failsafe, scope: FailsafeScope) -> None:
    count = len(failsafe.levels)
    for key, quantity in (("level", failsafe.level), ("health", failsafe.health)):
        if quantity is not None and quantity.maximum < count:
            message = f"{quantity.path} goes to {quantity.maximum}, and there are {count} levels"
            scope.bad(failsafe.spec, key, message, hint=f"write max: {count} at the quantity, or fewer levels")
    conditions = len(failsafe.to_arm) + len(failsafe.conditions)
    if conditions > _MOST_CONDITIONS:
        message = f"it has {conditions} conditions, and at most {_MOST_CONDITIONS} are told apart"
        scope.bad(failsafe.spec, None, message, "make two failsafes of it")
    if failsafe.level is not None and failsafe.level is failsafe.health:
        scope.bad(
            failsafe.spec,
            "health",
            f"{failsafe.health.path} has the level already",
            hint="give it a quantity of its own",
        )
