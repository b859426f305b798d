# Generated from templates/tests/program/reason_checks.py: do not edit.
# Inputs: 3ad2df42a40d30cf
"""What failsafes say: why the vehicle is not armed, level by level, and that a level is over."""

from program_bench import GroundStation, main, messages
from program_facts import WATCHED
from watched_checks import ATTRIBUTE, GCS, HIGH, LEVEL, LIMIT, SENSE, Bench, _each, _on

import dialect

LEVEL_AT = 1  # where a condition of the firmware has its level


def _reason(bench, condition):
    """Return the reason that the firmware has for a condition."""
    found = [each for each in bench.failsafe._conditions if each[LEVEL_AT] == condition[LEVEL]]
    (own,) = [each for each in found if condition[LIMIT] is None or condition[LIMIT] in each]
    (reason,) = [each for each in own if isinstance(each, str) and " " in each]
    return reason


def each_condition_has_its_reason():
    """What holds alone is the reason, whichever condition it is; nothing is while nothing holds, or it is off."""
    for facts, condition in _each():
        bench, at, beyond = _on(facts, condition, is_armed=False)
        for value, is_free in ((at, True), (beyond, False)):
            bench.values[condition[ATTRIBUTE]] = value
            bench._set()
            expected = None if is_free else _reason(bench, condition)
            assert bench.failsafe.problem() == expected, (condition, value, bench.failsafe.problem())
        if facts["enabled_by"]:
            setattr(bench.craft.parameters, facts["enabled_by"], 0)
            assert bench.failsafe.problem() is None


def a_level_is_a_reason():
    """One that is reached is, until it is over: of what is unknown, and of stations that are not heard."""
    for facts, condition in _each(("unknown", "silent")):
        bench = Bench(facts)
        if facts["enabled_by"]:
            setattr(bench.craft.parameters, facts["enabled_by"], 1)
        due = bench.delay(condition)
        bench.rests(condition)
        if condition[SENSE] == "silent":
            station = GroundStation(bench.craft.port)
            station.send(messages.Heartbeat, type=GCS)
        else:
            bench.values[condition[ATTRIBUTE]] = condition[HIGH]
        assert bench.run(passes=2) == []
        assert bench.failsafe.problem() is None, condition
        if condition[SENSE] != "silent":
            bench.values[condition[ATTRIBUTE]] = None
        bench.run(passes=due + 3)
        assert bench.failsafe.level >= condition[LEVEL], condition
        reached = [each for each in facts["conditions"] if each[LEVEL] == bench.failsafe.level]
        found = bench.failsafe.problem()
        assert found in [_reason(bench, each) for each in reached] + ["unhealthy"], found
        if facts["enabled_by"]:
            setattr(bench.craft.parameters, facts["enabled_by"], 0)
            assert bench.failsafe.problem() is None
            setattr(bench.craft.parameters, facts["enabled_by"], 1)
        if facts["is_latched"]:
            continue
        said = bench.craft.texts.last
        if condition[SENSE] == "silent":
            station.send(messages.Heartbeat, type=GCS)
        else:
            bench.values[condition[ATTRIBUTE]] = condition[HIGH]
        bench.run(passes=2)
        assert (bench.failsafe.level, bench.failsafe.problem()) == (0, None), condition
        assert bench.craft.texts.last == said + 1, "it is told that it is over"
        severity, text = bench.craft.texts.get(said + 1)
        assert severity == dialect.MAV_SEVERITY_NOTICE
        reached = [bench.craft.texts.get(number)[1] for number in range(1, said + 1)]
        assert 0 < len(text) <= 50, text
        assert text not in reached, "it says something else than that it is reached"


CHECKS = (
    (each_condition_has_its_reason, "arming.reasons"),
    (a_level_is_a_reason, "arming.reasons"),
)
SUBJECT = WATCHED

if __name__ == "__main__":
    main(CHECKS, SUBJECT)
