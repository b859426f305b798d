"""A vehicle of which one failsafe is looked at, condition by condition, and what else of it holds meanwhile."""

from program_bench import mock_time, needs, new_craft
from program_facts import CHECKS_US, FORCE_ARM, PARAMETERS, WATCHED

LEVEL, ATTRIBUTE, SENSE, LIMIT, FACTOR, IS_OFF_AT_ZERO, AFTER, AFTER_MS, SLACK, LOW, HIGH = range(11)
THRESHOLDS = ("below", "above")
SOME_PASSES = 4  # in which a HEARTBEAT that has come is taken


class Bench:
    """A vehicle of which one failsafe is looked at; what it watches has the values that a check gives it."""

    def __init__(self, facts, is_armed=True, ports=None):
        self.facts = facts
        self.craft = new_craft(ports=ports)
        self.failsafe = getattr(self.craft, facts["list"])[0]
        check, own = self.craft._check, getattr(self.craft, facts["list"])
        self.craft._check = lambda failsafes: check(failsafes) if failsafes is own else None  # the others rest
        self.period_us = facts["period_us"] or CHECKS_US
        self.component = None
        self.values = {}
        self.craft.disarm = lambda **_forced: None  # else an action hides what else there is
        if facts["component"]:
            self.component = getattr(self.craft.state, facts["component"])[0]
        name = "update_" + (facts["component"] or "")
        if hasattr(self.craft.state, name):
            self._read = getattr(self.craft.state, name)
            setattr(self.craft.state, name, self._update)
        if is_armed and FORCE_ARM is not None:
            assert self.craft.arm(force=True) is None

    def _update(self, board):
        self._read(board)
        self.set_values()

    def set_values(self):
        """Give what is watched the values of the check."""
        for attribute, value in self.values.items():
            setattr(self.component, attribute, value)

    def run(self, seconds=None, passes=None):
        """Run passes, one in each period; return the numbers of those in which the level changed, with the level."""
        found = []
        count = passes if passes is not None else int(seconds * 1000000) // self.period_us
        for number in range(count):
            before = self.failsafe.level
            if not self.facts["period_us"]:
                self.set_values()
            self.craft.run_pass()
            if self.failsafe.level != before:
                found.append((number, self.failsafe.level))
            mock_time.advance_us(self.period_us)
        return found

    def delay(self, condition):
        """Return after how many passes a condition has held for long enough: the first of them begins it."""
        if condition[AFTER]:
            parameter = _parameter(condition[AFTER])
            enough = -(-SOME_PASSES * self.period_us // (condition[AFTER_MS] * 1000))
            setattr(
                self.craft.parameters, condition[AFTER], min(max(enough, parameter["minimum"]), parameter["maximum"])
            )
        return self.due(condition)

    def due(self, condition):
        """Return the same with its time as it is, None for one that is switched off."""
        after_ms = self.after_ms(condition)
        return None if condition[AFTER] and not after_ms else -(-after_ms * 1000 // self.period_us)

    def after_ms(self, condition):
        """Return for how long a condition has to hold; of one whose parameter is 0, which is switched off, 0."""
        steps = getattr(self.craft.parameters, condition[AFTER]) if condition[AFTER] else 1
        return condition[AFTER_MS] * steps

    def limit(self, condition):
        """Return what a condition compares with, in stored steps; a parameter is set so that it holds alone."""
        if condition[LIMIT]:
            setattr(self.craft.parameters, condition[LIMIT], _chosen(self.facts, condition))
        return _compared(self.facts, condition)

    def rests(self, condition):
        """Keep what else there is from holding with `condition`, where that can be: 0 switches off a threshold of 0 or
        above, another one is as far off as it can be, and other quantities have values with which nothing holds.
        """
        others = [each for each in self.facts["conditions"] if each[ATTRIBUTE] and each is not condition]
        for other in others:
            if other[LIMIT] and other[LIMIT] != condition[LIMIT]:
                setattr(self.craft.parameters, other[LIMIT], 0 if other[IS_OFF_AT_ZERO] else _farthest(other))
        for other in others:
            self.values.setdefault(other[ATTRIBUTE], self.calm(other[ATTRIBUTE]))

    def calm(self, attribute):
        """Return a value with which no condition holds, nor just behind its hysteresis; an end where there is none."""
        own = [each for each in self.facts["conditions"] if each[ATTRIBUTE] == attribute]
        low, high = own[0][LOW], own[0][HIGH]
        tried = [high, low] if own[0][SENSE] == "below" else [low, high]
        for each in own:
            limit = self._in_force(each)
            if limit is not None:
                tried.append(limit + each[SLACK] if each[SENSE] == "below" else limit - each[SLACK])
        for value in tried:
            if low <= value <= high and not any(self.holds(each, value, each[SLACK]) for each in own):
                return value
        return tried[0]

    def _in_force(self, condition):
        """Return the limit as it is, in stored steps; None for one that is switched off, or compares with nothing."""
        if condition[SENSE] not in THRESHOLDS:
            return None
        if not condition[LIMIT]:
            return condition[FACTOR]
        steps = getattr(self.craft.parameters, condition[LIMIT])
        return None if not steps and condition[IS_OFF_AT_ZERO] else steps * condition[FACTOR]

    def holds(self, condition, value, slack=0):
        """Return whether a condition holds at a value, or within `slack` of its limit."""
        if value is None or condition[SENSE] == "unknown":
            return value is None and condition[SENSE] == "unknown"
        limit = self._in_force(condition)
        if limit is None:
            return False
        return value < limit + slack if condition[SENSE] == "below" else value > limit - slack

    def holding(self):
        """Return the conditions that hold at the values of now."""
        own = [each for each in self.facts["conditions"] if each[ATTRIBUTE]]
        return [each for each in own if self.holds(each, self.values.get(each[ATTRIBUTE]))]

    def is_free(self):
        """Return whether nothing speaks against arming: none holds, what is watched is known, levels become worse."""
        known = self.facts["watched"] is None or self.values.get(self.facts["watched"]) is not None
        return known and not self.holding() and not self.is_mixed_up()

    def is_mixed_up(self):
        """Return whether a level has a threshold that is no worse than that of the one before it: of parameters."""
        return any(self._is_no_worse(one, other) for one in self.facts["conditions"] for other in self._next(one))

    def _next(self, milder):
        """Return the conditions of the next level that compare the same with another parameter."""
        own = [each for each in self.facts["conditions"] if each[LEVEL] == milder[LEVEL] + 1 and each[LIMIT]]
        own = own if milder[LEVEL] and milder[LIMIT] else []
        return [each for each in own if (each[ATTRIBUTE], each[SENSE]) == (milder[ATTRIBUTE], milder[SENSE])]

    def _is_no_worse(self, milder, worse):
        first, second = self._in_force(milder), self._in_force(worse)
        if first is None or second is None:
            return False
        return second >= first if worse[SENSE] == "below" else second <= first

    def as_bad(self, condition):
        """Yield the other conditions of the same quantity that lead as far, with the passes that each takes."""
        for other in beside(self.facts, condition):
            passes = self.due(other)
            if condition[LEVEL] <= other[LEVEL] and passes is not None:
                yield other, passes

    def is_forestalled(self, condition, at, beyond, passes):
        """Return whether another condition leads as far: one that holds at `at`, too, in so many passes, or is faster.

        Nothing that can be set keeps that from it.
        """
        due = self.due(condition)
        for other, after in self.as_bad(condition):
            if self.holds(other, at):
                if after < passes:
                    return True
            elif due is not None and after < due and self.holds(other, beyond):
                return True
        return False


def beside(facts, condition):
    """Return the other conditions on the same quantity."""
    return [each for each in facts["conditions"] if each[ATTRIBUTE] == condition[ATTRIBUTE] and each is not condition]


def _parameter(attribute):
    return next(each for each in PARAMETERS if each["attribute"] == attribute)


def _farthest(condition):
    """Return the steps of a threshold with which it holds as rarely as it can."""
    facts = _parameter(condition[LIMIT])
    if condition[SENSE] == "below":
        return max(facts["minimum"], condition[LOW] // condition[FACTOR])
    return min(facts["maximum"], -(-condition[HIGH] // condition[FACTOR]))


def _chosen(facts, condition):
    """Return steps for a threshold: half of its range, or of the part in which no amount of the others holds."""
    parameter, factor = _parameter(condition[LIMIT]), condition[FACTOR]
    high = min(parameter["maximum"], condition[HIGH] // factor)
    low = max(parameter["minimum"], -(-condition[LOW] // factor))
    steps = (low + high) // 2
    least, most = low, high
    for other in beside(facts, condition):
        if other[SENSE] in THRESHOLDS and not other[LIMIT]:
            apart = 1 + other[SLACK] + condition[SLACK]
            if other[SENSE] == "below":
                least = max(least, -(-(other[FACTOR] + apart) // factor))
            else:
                most = min(most, (other[FACTOR] - apart) // factor)
    if least <= most and not least <= steps <= most:
        steps = (least + most) // 2
    return steps or min(1, high) if condition[IS_OFF_AT_ZERO] else steps


def _compared(facts, condition):
    """Return what a condition compares with in checks, in stored steps."""
    return condition[FACTOR] * (_chosen(facts, condition) if condition[LIMIT] else 1)


def sides(facts, condition):
    """Return the value at the threshold, which is good, and the next one beyond it; None where that cannot be."""
    limit = _compared(facts, condition)
    beyond = limit - 1 if condition[SENSE] == "below" else limit + 1
    return (limit, beyond) if condition[LOW] <= beyond <= condition[HIGH] else None


def each_of(kinds=THRESHOLDS):
    """Return failsafes with their timed conditions of some kinds; leave the check out where there are none."""
    found = []
    for facts in WATCHED:
        found += [(facts, each) for each in facts["conditions"] if each[LEVEL] and each[SENSE] in kinds]
    needs(found, "a failsafe of this kind")
    found = [(facts, each) for facts, each in found if each[SENSE] not in THRESHOLDS or sides(facts, each)]
    needs(found, "a threshold within the limits")
    return found


def bench_of(facts, condition, is_armed=True):
    """Return a bench in which only this condition can hold, with its values at and beyond the threshold."""
    bench = Bench(facts, is_armed)
    bench.limit(condition)
    at, beyond = sides(facts, condition)
    bench.rests(condition)
    bench.values[condition[ATTRIBUTE]] = at
    return bench, at, beyond
