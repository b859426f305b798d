"""Rules for silences of ground stations that are no longer than the time between two of their HEARTBEATs."""

from collections.abc import Iterator

from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.failsafe import Sense, Setting
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.source import Place

RULE = Rule(
    "silence-between-heartbeats",
    "Ground stations send a HEARTBEAT once a second. A time of silence that is no longer is up between any two of "
    "them: the failsafe acts though the station is there, or every station is gone for the rest of each second, and "
    "what only counts from a ground station is refused meanwhile. Take several seconds, such as 5 s.",
    remedy="take several seconds, such as 5 s",
)
ONE_LOST = Rule(
    "silence-of-one-heartbeat",
    "Ground stations send a HEARTBEAT once a second. Of a silence below two seconds one that is lost or late is "
    "enough: then the failsafe acts, or the station is gone, though it is there. The same goes for a parameter that "
    "can be set so low. Take several seconds, or waive it where that is meant.",
    Severity.WARNING,
    remedy="take several seconds, such as 5 s",
)
_PERIOD_MS = 1000
_TWO_MS = 2 * _PERIOD_MS


def check(system: System) -> Iterator[Diagnostic]:
    """The time of each level that waits for silence, and the one after which a station is gone."""
    program = system.program
    if program is None:
        return
    for failsafe in program.failsafes:
        for condition in failsafe.conditions:
            after = condition.after
            if condition.sense is Sense.SILENT and after is not None:
                spec = condition.spec
                place = spec.at("after") if spec.after else failsafe.spec.at("after")
                yield from _of_failsafe(after, failsafe.name, place)
    yield from _of_stations(program.silence_ms, program.spec.services.at("silence"))


def _of_failsafe(after: Setting, name: str, place: Place) -> Iterator[Diagnostic]:
    what = f"{name} waits for a silence of"
    parameter = after.parameter
    if parameter is None:
        yield from _too_short(after.count, f"{what} {_shown(after.count)}", "after: 5 s", place)
        return
    low_ms = parameter.minimum * after.count
    related = ((parameter.spec.place, f"{parameter.name} is declared here"),)
    by_default = after.by_default
    if by_default is not None and by_default < _TWO_MS:
        hint = f"default: {decimal(5000 / (after.count / parameter.step))} at {parameter.name}"
        yield from _too_short(by_default, f"{what} {_shown(by_default)}, the default of {parameter.name}", hint, place)
    elif 0 < low_ms <= _PERIOD_MS:  # from 0 on, which is off, nothing keeps a station from the next step
        message = f"{what} {_shown(low_ms)} where {parameter.name} is set to its least"
        hint = f"min: {decimal(_TWO_MS / (after.count / parameter.step))} at {parameter.name}"
        yield Diagnostic(place, ONE_LOST, f"{message}: HEARTBEATs come once a second", hint, related)


def _of_stations(silence_ms: int, place: Place) -> Iterator[Diagnostic]:
    message = f"a ground station is gone after a silence of {_shown(silence_ms)}"
    yield from _too_short(silence_ms, message, "silence: 10 s", place)


def _too_short(time_ms: int, message: str, hint: str, place: Place) -> Iterator[Diagnostic]:
    if time_ms < _TWO_MS:
        rule = RULE if time_ms <= _PERIOD_MS else ONE_LOST
        yield Diagnostic(place, rule, f"{message}, and HEARTBEATs come once a second", hint)


def _shown(time_ms: int) -> str:
    return f"{time_ms / 1000:g} s"
