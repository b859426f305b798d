# Generated from templates/tests/program/watched_checks.py: do not edit.
# Inputs: 69c6a96b26afbf33
"""Every failsafe, condition by condition: where it begins to hold, for how long it has to, and when it is over."""

from program_bench import GroundStation, Port, main, mock_time, needs, needs_arming, new_craft
from program_facts import ACTIONS, PARAMETERS, PRIORITY, TELLS_STATUS, WATCHED
from watched_bench import (
    AFTER,
    ATTRIBUTE,
    HIGH,
    IS_OFF_AT_ZERO,
    LEVEL,
    LIMIT,
    LOW,
    SENSE,
    SLACK,
    THRESHOLDS,
    Bench,
    bench_of,
    each_of,
    sides,
)

import dialect
import messages

GCS = 6  # MAV_TYPE
ALONE = "a condition that leads to its level alone"


def _first(level, found):
    """Return the pass in which at least a level was reached."""
    return next((number for number, reached in found if reached >= level), None)


def a_condition_holds_beyond_its_threshold_for_its_time():
    """At the threshold nothing is reached; one step beyond it the level comes with the reading that ends the time."""
    seen = 0
    for facts, condition in each_of():
        bench, at, beyond = bench_of(facts, condition)
        due = bench.delay(condition)
        if bench.is_forestalled(condition, at, beyond, 2 * due + 4):
            continue
        seen += 1
        bench.values[condition[ATTRIBUTE]] = at
        assert _first(condition[LEVEL], bench.run(passes=due + 3)) is None, condition
        bench.values[condition[ATTRIBUTE]] = beyond
        if due:
            assert _first(condition[LEVEL], bench.run(passes=due)) is None, condition
        assert _first(condition[LEVEL], bench.run(passes=1)) == 0, (condition, bench.failsafe.level)
        if facts["level"]:
            assert getattr(bench.component, facts["level"]) == bench.failsafe.level
        bench, _, beyond = bench_of(facts, condition)
        bench.delay(condition)
        _holds_to_the_millisecond(bench, condition, beyond)
    needs(seen, ALONE)


def _holds_to_the_millisecond(bench, condition, value):
    """Hold the time of a condition to what it is: the level comes with the look at its end, not with one before."""
    after_ms = bench.after_ms(condition)
    bench.values[condition[ATTRIBUTE]] = value
    bench.set_values()
    now_ms = mock_time.ticks_ms()
    if after_ms:
        for passed_ms in (0, after_ms - 1):
            bench.failsafe.update(now_ms + passed_ms)
            assert bench.failsafe.level < condition[LEVEL], (condition, passed_ms)
    bench.failsafe.update(now_ms + after_ms)
    assert bench.failsafe.level >= condition[LEVEL], (condition, after_ms)


def one_good_reading_begins_the_time_anew():
    """A value at the threshold restarts the time; one that is unknown neither restarts it nor lets it go on."""
    for facts, condition in each_of():
        bench, at, beyond = bench_of(facts, condition)
        due = bench.delay(condition)
        if due < 3 or bench.is_forestalled(condition, at, beyond, 3 * due + 5):
            continue
        for between, expected in ((at, due), (None, 1)):
            if between is None and _leads_unknown(bench, condition, 2):
                continue
            bench, at, beyond = bench_of(facts, condition)
            bench.delay(condition)
            bench.values[condition[ATTRIBUTE]] = beyond
            bench.run(passes=due)
            bench.values[condition[ATTRIBUTE]] = between
            bench.run(passes=2)
            bench.values[condition[ATTRIBUTE]] = beyond
            found = _first(condition[LEVEL], bench.run(passes=due + 3))
            assert found == (expected if between is not None else 0), (condition, between, found)


def _leads_unknown(bench, condition, passes):
    """Return whether a condition on unknown leads as far in so many passes."""
    return any(bench.holds(other, None) and after < passes for other, after in bench.as_bad(condition))


def unknown_counts_from_when_it_is_unknown():
    """A condition on unknown holds while nothing is known, and not a moment else."""
    for facts, condition in each_of(("unknown",)):
        bench = Bench(facts)
        due = bench.delay(condition)
        bench.rests(condition)
        if bench.is_forestalled(condition, condition[LOW], None, 0):
            continue
        for value in (condition[LOW], condition[HIGH], bench.calm(condition[ATTRIBUTE])):
            bench.values[condition[ATTRIBUTE]] = value
            if not bench.holding():  # another one of the same value may hold there
                assert bench.run(passes=due + 3) == [], condition
        bench.values[condition[ATTRIBUTE]] = None
        earlier = [each[LEVEL] for each in bench.holding() if each[LEVEL] < condition[LEVEL]]
        assert [level for _, level in bench.run(passes=due) if level not in earlier] == [], condition
        assert _first(condition[LEVEL], bench.run(passes=1)) == 0, condition


def disarmed_only_what_always_watches_acts():
    """While disarmed nothing is reached, but by what looks always."""
    for facts, condition in each_of():
        bench, _, beyond = bench_of(facts, condition, is_armed=False)
        due = bench.delay(condition)
        bench.values[condition[ATTRIBUTE]] = beyond
        bench.run(passes=due + 5)
        assert (bench.failsafe.level >= condition[LEVEL]) == facts["is_always"], condition


def a_level_stays_or_is_over():
    """A latched level stays; another one is over once the value is better by the hysteresis, and that is told once."""
    seen = 0
    for facts, condition in each_of():
        bench, at, beyond = bench_of(facts, condition)
        due = bench.delay(condition)
        step = 1 if condition[SENSE] == "below" else -1
        better = at + step * condition[SLACK]
        passes = due + 16
        if bench.is_forestalled(condition, at, beyond, passes) or _leads_further(bench, condition, beyond, passes):
            continue
        if _stays_up(bench, condition, better, passes):
            continue
        seen += 1
        bench.values[condition[ATTRIBUTE]] = beyond
        bench.run(passes=due + 1)
        level = bench.failsafe.level
        assert level >= condition[LEVEL]
        if condition[SLACK]:
            bench.values[condition[ATTRIBUTE]] = better - step
            assert bench.run(passes=5) == [], condition
        if not _leads_unknown(bench, condition, 5):
            bench.values[condition[ATTRIBUTE]] = None
            assert bench.run(passes=5) == [], condition
        bench.values[condition[ATTRIBUTE]] = min(max(better, condition[LOW]), condition[HIGH])
        said = bench.craft.texts.last
        found = bench.run(passes=5)
        if facts["is_latched"] or not condition[LOW] <= better <= condition[HIGH]:  # no value is so much better
            assert found == [], condition
            _tells(bench, dialect.MAV_STATE_CRITICAL)
            continue
        assert found, condition
        assert found[0][0] == 0, (condition, found)
        assert bench.failsafe.level < condition[LEVEL], (condition, found)
        texts = _said_since(bench, said)
        assert len(texts) == (len(found) if bench.holding() else 1), texts
        if not bench.failsafe.level:
            severity, _ = texts[0]
            assert severity == dialect.MAV_SEVERITY_NOTICE
            _tells(bench, dialect.MAV_STATE_ACTIVE)
        _begins_anew(bench, condition, at, beyond)
    needs(seen, ALONE)


def _said_since(bench, number):
    """Return the texts since one, but for those about the health and what has come back, which values tell, too."""
    texts = [bench.craft.texts.get(each) for each in range(number + 1, bench.craft.texts.last + 1)]
    return [text for text in texts if " health: " not in text[1] and not text[1].endswith(" connected")]


def _begins_anew(bench, condition, at, beyond):
    """A level that is over has its own threshold again, and does not come at once where a value becomes unknown."""
    due = bench.due(condition)
    steps = [(at, due + 2)] if condition[SLACK] else []
    steps += [(beyond, 1), (None, 3)] if due > 1 and not _leads_unknown(bench, condition, 3) else []
    for value, passes in steps:
        bench.values[condition[ATTRIBUTE]] = value
        bench.run(passes=passes)
        assert bench.failsafe.level < condition[LEVEL], (condition, value)


def _leads_further(bench, condition, beyond, passes):
    """Return whether another condition leads to a worse level in so many passes."""
    own = [(other, after) for other, after in bench.as_bad(condition) if other[LEVEL] > condition[LEVEL]]
    return any(after < passes and bench.holds(other, beyond) for other, after in own)


def _stays_up(bench, condition, better, passes):
    """Return whether another condition keeps the level up at a better value."""
    own = bench.as_bad(condition)
    return any(after < passes and bench.holds(other, better, other[SLACK]) for other, after in own)


def _tells(bench, status):
    """Hold what HEARTBEAT tells to a status, where the program sets it."""
    if TELLS_STATUS:
        assert bench.craft.state.vehicle.status == status


def each_level_does_what_it_says():
    """Its action is called once, with the action's mode, and what disarms disarms; HEARTBEAT says critical."""
    for facts, condition in each_of(("below", "above", "unknown")):
        for chosen, (number, call, mode, disarms) in _choices(facts["actions"][condition[LEVEL] - 1]):
            bench = Bench(facts)
            at, beyond = None, None
            if condition[SENSE] != "unknown":
                bench.limit(condition)
                at, beyond = sides(facts, condition)
            due = bench.delay(condition)
            bench.rests(condition)
            passes = due + 5
            if bench.is_forestalled(condition, at, beyond, passes) or _leads_further(bench, condition, beyond, passes):
                continue
            if chosen:
                setattr(bench.craft.parameters, chosen, number)
            calls = []
            for name in [name for _, name, _, _ in ACTIONS] + ["disarm"]:
                setattr(bench.craft, name, _note(calls, name))
            vehicle = getattr(bench.craft.state, "vehicle", None)
            bench.values[condition[ATTRIBUTE]] = beyond
            milder = _milder(bench, condition)
            if milder:  # such a level comes first and acts, too
                bench.run(passes=due)
                if PRIORITY and (number in milder or not _is_worse(number, milder)):
                    continue
                del calls[:]
            before = getattr(vehicle, "mode_number", None)
            bench.run(passes=5 if milder else due + 5)
            assert calls == ([call] if call else []) + (["disarm"] if disarms else []), (condition, number, calls)
            assert getattr(vehicle, "mode_number", None) == (before if mode is None else mode), (condition, number)
            _tells(bench, dialect.MAV_STATE_CRITICAL)


def _milder(bench, condition):
    """Return the numbers of the actions of milder levels that are reached before."""
    found = []
    for each in bench.holding():
        passes = bench.due(each)
        if 0 < each[LEVEL] < condition[LEVEL] and passes is not None and passes < bench.due(condition):
            action = bench.facts["actions"][each[LEVEL] - 1] or 0
            found.append(getattr(bench.craft.parameters, action) if isinstance(action, str) else action)
    return found


def _is_worse(number, others):
    """Return whether an action is done where others are in force."""
    return number in PRIORITY and all(PRIORITY.index(number) < PRIORITY.index(each) for each in others if each)


def _choices(action):
    """Return what can be done at a level: the parameter that chooses it or None, and the action."""
    none = (0, None, None, False)
    if not isinstance(action, str):
        return [(None, next((each for each in ACTIONS if each[0] == action), none))]
    parameter = next(each for each in PARAMETERS if each["attribute"] == action)
    actions = [none] + [each for each in ACTIONS]  # noqa: C416  MicroPython cannot
    return [(action, each) for each in actions if parameter["minimum"] <= each[0] <= parameter["maximum"]]


def _note(calls, name):
    return lambda **_given: calls.append(name)


def a_parameter_of_0_switches_off():
    """A threshold of 0, a time of 0 and the failsafe's own switch."""
    for facts, condition in each_of():
        switches = [each for each in (condition[AFTER], facts["enabled_by"]) if each]
        if condition[LIMIT] and condition[IS_OFF_AT_ZERO]:
            switches.append(condition[LIMIT])
        for switch in switches:
            bench, _, beyond = bench_of(facts, condition)
            due = bench.delay(condition)
            bench.values[condition[ATTRIBUTE]] = beyond
            setattr(bench.craft.parameters, switch, 0)
            if switch != facts["enabled_by"] and bench.is_forestalled(condition, beyond, beyond, due + 5):
                continue
            bench.run(passes=due + 5)
            assert bench.failsafe.level < condition[LEVEL], (condition, switch)


def arming_asks_for_every_condition():
    """Beyond a threshold, and while unknown, the vehicle is not armed, with a text that names the failsafe."""
    needs_arming()
    needs(WATCHED, "a failsafe")
    for facts in WATCHED:
        for condition in facts["conditions"]:
            if condition[SENSE] not in THRESHOLDS or not sides(facts, condition):
                continue
            bench, at, beyond = bench_of(facts, condition, is_armed=False)
            for value in (at, beyond, None):
                bench.values[condition[ATTRIBUTE]] = value
                bench.set_values()
                is_free = bench.is_free()  # another one may hold at the threshold, too
                assert not is_free or value != beyond
                problem = bench.failsafe.problem()
                assert (problem is None) == is_free, (condition, value, problem)
                refused = bench.craft.arming_problem()
                if facts["forbids_arming"] and not is_free:
                    assert refused is not None


class _Changed:
    """Stands for a failsafe whose level is another one now."""

    def update(self, _now_ms):
        """Return that the level has changed."""
        return 1


def the_most_severe_action_holds():
    """Whichever comes first; once it is over the next one does, and what holds already is not done again."""
    needs(len(PRIORITY) > 1, "actions by their severity")
    needs(len(WATCHED) > 1, "several failsafes")
    craft = new_craft()
    one, other = (getattr(craft, facts["list"])[0] for facts in WATCHED[:2])
    for at in range(1, len(PRIORITY)):
        severe, mild = PRIORITY[at - 1], PRIORITY[at]
        for first, second, told in ((mild, severe, [mild, severe]), (severe, mild, [severe]), (mild, mild, [mild])):
            done = []
            craft._act = done.append
            one.action, other.action = (lambda: first), (lambda: second)  # noqa: B023  called in this turn
            for each in (one, other):
                each.level = 1
                craft._check([_Changed()])
                craft._check([])
            assert done == told, (first, second, done)
            one.level = 0
            craft._check([_Changed()])
            assert done[-1] == second, (first, second, done)
            other.level = 0
            craft._check([_Changed()])
            assert done[-1] == 0, (first, second, done)


def each_text_fits_one_frame():
    """A text of the failsafe has at most 50 characters where the values are those that bring it."""
    for facts, condition in each_of():
        bench, _, beyond = bench_of(facts, condition)
        due = bench.delay(condition)
        bench.values[condition[ATTRIBUTE]] = beyond
        before = bench.craft.texts.last
        bench.run(passes=due + 2)
        texts = [bench.craft.texts.get(number) for number in range(before + 1, bench.craft.texts.last + 1)]
        texts = [text for severity, text in texts if severity == dialect.MAV_SEVERITY_WARNING]
        assert texts, condition
        assert max(len(text) for text in texts) <= 50, texts


def silence_is_counted_from_the_last_heartbeat():
    """Nobody is missed before the first HEARTBEAT; then each level comes in its time, and a HEARTBEAT ends it."""
    found = each_of(("silent",))
    for facts in {each["list"]: each for each, _ in found}.values():
        levels = [each for each in facts["conditions"] if each[SENSE] == "silent"]
        bench = Bench(facts)
        if facts["enabled_by"]:
            setattr(bench.craft.parameters, facts["enabled_by"], 1)
        delays = [bench.delay(each) for each in levels]
        assert bench.run(passes=max(delays) + 10) == [], "nobody was heard yet"
        station = GroundStation(bench.craft.port)
        for times in range(2):
            station.send(messages.Heartbeat, type=GCS)
            changes = bench.run(passes=1 + max(delays) + 3)
            if times and not facts["is_latched"]:
                assert changes[0] == (0, 0) or changes[0] == (1, 0), changes
                changes = changes[1:]
            assert [level for _, level in changes] == [each[LEVEL] for each in levels], changes
            for (number, _), delay in zip(changes, delays):  # noqa: B905  MicroPython has no strict
                assert delay <= number <= delay + 2, (number, delay)
            if facts["is_latched"]:
                break


def silence_begins_anew_with_each_heartbeat():
    """A ground station that is heard just before the time is over is never missed, one that others talk over is."""
    found = each_of(("silent",))
    for facts, condition in found:
        bench = Bench(facts)
        if facts["enabled_by"]:
            setattr(bench.craft.parameters, facts["enabled_by"], 1)
        delay = min(bench.delay(each) for each in facts["conditions"])
        station = GroundStation(bench.craft.port)
        for _ in range(5):
            station.send(messages.Heartbeat, type=GCS)
            assert bench.run(passes=delay - 1) == [], condition
        other = 0  # a HEARTBEAT of anything else than a ground station
        for _ in range(delay + 3):
            station.send(messages.Heartbeat, type=other)
            bench.run(passes=1)
        assert bench.failsafe.level >= 1


def a_station_on_any_link_is_heard():
    """One that is heard on one link and then on another is not missed, though each of them is silent for too long."""
    for facts, condition in each_of(("silent",)):
        bench = Bench(facts, ports=[Port(), Port()])
        if facts["enabled_by"]:
            setattr(bench.craft.parameters, facts["enabled_by"], 1)
        delay = min(bench.delay(each) for each in facts["conditions"])
        for _ in range(3):
            for connection in bench.craft.connections:
                GroundStation(connection.port).send(messages.Heartbeat, type=GCS)
                assert bench.run(passes=delay - 1) == [], condition


CHECKS = (
    (a_condition_holds_beyond_its_threshold_for_its_time, "failsafe.timer", "failsafe.below", "failsafe.above"),
    (one_good_reading_begins_the_time_anew, "failsafe.timer"),
    (unknown_counts_from_when_it_is_unknown, "failsafe.unknown"),
    (disarmed_only_what_always_watches_acts, "failsafe.disarmed"),
    (a_level_stays_or_is_over, "failsafe.latch", "failsafe.recovery"),
    (each_level_does_what_it_says, "failsafe.action", "failsafe.status"),
    (a_parameter_of_0_switches_off, "failsafe.off"),
    (arming_asks_for_every_condition, "arming.reasons"),
    (the_most_severe_action_holds, "failsafe.action"),
    (each_text_fits_one_frame, "failsafe.text"),
    (silence_is_counted_from_the_last_heartbeat, "failsafe.timer", "failsafe.silent"),
    (silence_begins_anew_with_each_heartbeat, "failsafe.timer", "failsafe.silent"),
    (a_station_on_any_link_is_heard, "failsafe.silent"),
)

if __name__ == "__main__":
    main(CHECKS)
