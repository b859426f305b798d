# Generated from templates/tests/program/reason_checks.py: do not edit.
# Inputs: 103aa43bf33152b4
"""Texts and reasons of failsafes: why the vehicle is not armed, level by level, and that a level is over."""

from program_bench import GroundStation, main, messages, needs_arming
from program_facts import FORCE_ARM, WATCHED
from watched_bench import ATTRIBUTE, LEVEL, LIMIT, SENSE, Bench, bench_of, each_of
from watched_checks import GCS

import dialect


def _reasons(bench, condition):
    """Return the reasons that the firmware may have for a condition: one where a parameter has its limit."""
    own = [each for each in bench.failsafe._conditions if condition[LEVEL] in each]
    if condition[LIMIT] is not None:
        own = [each for each in own if condition[LIMIT] in each]
    found = [part for each in own for part in each if isinstance(part, str) and " " in part]
    assert found, condition
    sharing = [each for each in bench.facts["conditions"] if each[LIMIT] == condition[LIMIT]]
    assert len(found) == 1 or condition[LIMIT] is None or len(sharing) > 1
    return found


def _spoken(bench):
    """Return the reasons of what holds at the values of now, [None] for none, and [] where levels are mixed up."""
    held = bench.holding()
    if not held:
        return [] if bench.is_mixed_up() else [None]
    return [reason for each in held for reason in _reasons(bench, each)]


def each_condition_has_its_reason():
    """A condition that holds alone is the reason, whichever it is; nothing is while nothing holds, or it is off."""
    needs_arming()
    for facts, condition in each_of():
        bench, at, beyond = bench_of(facts, condition, is_armed=False)
        for value in (at, beyond):
            bench.values[condition[ATTRIBUTE]] = value
            bench.set_values()
            assert condition in bench.holding() or value == at
            problem, expected = bench.failsafe.problem(), _spoken(bench)
            assert problem in expected or (not expected and problem), (condition, value, problem)
        if facts["enabled_by"]:
            setattr(bench.craft.parameters, facts["enabled_by"], 0)
            assert bench.failsafe.problem() is None


def _speaks_against_arming(bench, expected):
    """Hold the reason not to arm to those that are expected, where something can be armed."""
    if FORCE_ARM is not None:
        found = bench.failsafe.problem()
        assert found in expected, found


def a_level_is_a_reason():
    """One that is reached is, until it is over: of what is unknown, and of stations that are not heard."""
    for facts, condition in each_of(("unknown", "silent")):
        bench = Bench(facts)
        if facts["enabled_by"]:
            setattr(bench.craft.parameters, facts["enabled_by"], 1)
        due = bench.delay(condition)
        bench.rests(condition)
        if condition[SENSE] == "silent":
            station = GroundStation(bench.craft.port)
            station.send(messages.Heartbeat, type=GCS)
        else:
            bench.values[condition[ATTRIBUTE]] = bench.calm(condition[ATTRIBUTE])
        assert bench.run(passes=2) == []
        _speaks_against_arming(bench, [None])
        if condition[SENSE] != "silent":
            bench.values[condition[ATTRIBUTE]] = None
        bench.run(passes=due + 3)
        assert bench.failsafe.level >= condition[LEVEL], condition
        reached = [each for each in facts["conditions"] if each[LEVEL] == bench.failsafe.level]
        if FORCE_ARM is not None:
            reasons = [reason for each in reached for reason in _reasons(bench, each)]
            _speaks_against_arming(bench, reasons + ["unhealthy"])  # noqa: RUF005  MicroPython
        if facts["enabled_by"]:
            setattr(bench.craft.parameters, facts["enabled_by"], 0)
            _speaks_against_arming(bench, [None])
            setattr(bench.craft.parameters, facts["enabled_by"], 1)
        if facts["is_latched"]:
            continue
        said = bench.craft.texts.last
        if condition[SENSE] == "silent":
            station.send(messages.Heartbeat, type=GCS)
        else:
            bench.values[condition[ATTRIBUTE]] = bench.calm(condition[ATTRIBUTE])
        bench.run(passes=2)
        assert bench.failsafe.level == 0, condition
        _speaks_against_arming(bench, [None])
        assert bench.craft.texts.last == said + 1, "it is told that it is over"
        severity, text = bench.craft.texts.get(said + 1)
        assert severity == dialect.MAV_SEVERITY_NOTICE
        reached = [bench.craft.texts.get(number)[1] for number in range(1, said + 1)]
        assert 0 < len(text) <= 50, text
        assert text not in reached, "it says something else than that it is reached"


CHECKS = (
    (each_condition_has_its_reason, "arming.reasons"),
    (a_level_is_a_reason,),
)
SUBJECT = WATCHED

if __name__ == "__main__":
    main(CHECKS, SUBJECT)
