# Generated from templates/tests/program/failsafe_checks.py: do not edit.
# Inputs: 422da576f1957c79
"""The failsafe of a measured quantity: two levels, one time, latched."""

from failsafe_bench import CRITICAL, LOW, TIMER, armed_watch, new_watch, parameter_of
from program_bench import TURN_MS_US, NotHereError, analog, main, mock_time, needs, new_craft
from program_facts import ACTIONS, CHECKS_US, FAILSAFES, MEASURED

import dialect


def low_after_the_timer():
    """Low comes with the reading that ends the time, not before, for short and long times and across the wrap."""
    for timer in (1, TIMER, 120):
        for at_us in (0, TURN_MS_US - 500000):
            watch = armed_watch(timer, at_us)
            due = timer * watch.per_second
            assert watch.readings(watch.low - 1, due) == [], (timer, at_us, watch.events)
            assert watch.readings(watch.low - 1, due) == [(LOW, due)], (timer, at_us, watch.events)


def default_timer_is_the_specified_one():
    """Without any setting the time and the threshold of the parameters' defaults are in force."""
    watch = new_watch()
    facts = watch.facts
    low, timer = parameter_of(facts["low"])["default"], parameter_of(facts["after"])["default"]
    critical = parameter_of(facts["critical"])["default"]
    needs(low > 1 and timer and timer <= 120, "a default that switches the level on")
    watch.set(low * facts["low_scale"], critical * facts["critical_scale"], timer)
    watch.arm()
    watch.readings(low * facts["low_scale"] - 1, timer * watch.per_second + 1)
    assert watch.events == [(watch.failsafe.level, timer * watch.per_second)], watch.events
    assert watch.failsafe.level in (LOW, CRITICAL)


def critical_goes_first():
    """Below both from the start only critical is reached, at the end of the time."""
    watch = armed_watch()
    assert watch.readings(watch.deep, 3 * TIMER * watch.per_second) == [(CRITICAL, TIMER * watch.per_second)]


def each_level_has_its_own_timer():
    """Low and then critical: two escalations, each after its own time; the low timer survives the critical one."""
    watch = armed_watch()
    second = watch.per_second
    watch.readings(watch.between, 4 * second)
    assert watch.readings(watch.deep, 20 * second) == [(LOW, 10 * second), (CRITICAL, 14 * second)], watch.events
    watch = armed_watch()
    watch.readings(watch.deep, 5 * second)
    assert watch.readings(watch.between, 20 * second) == [(LOW, 10 * second)], watch.events


def one_good_reading_restarts():
    """A reading at the threshold is not below it: at 9.9 s it makes low come at 20.0 s, and always it never comes."""
    watch = armed_watch()
    second = watch.per_second
    watch.readings(watch.between, 10 * second - 1)
    watch.readings(watch.low)
    assert watch.readings(watch.between, 12 * second) == [(LOW, 20 * second)], watch.events
    watch = armed_watch()
    assert watch.readings(watch.low, 30 * second) == []


def unknown_neither_restarts_nor_advances():
    """20 readings that are unknown, 0 or less put the end off by 20 readings."""
    for ignored in (None, 0, -1, -12000):
        watch = armed_watch()
        second = watch.per_second
        watch.readings(watch.between, 4 * second)
        watch.readings(ignored, 2 * second)
        assert watch.readings(watch.between, 10 * second) == [(LOW, 12 * second)], (ignored, watch.events)
    watch = armed_watch()
    assert watch.readings(None, 30 * second) == []
    assert watch.readings(0, 30 * second) == []


def zero_switches_off():
    """A threshold of 0 switches off its level alone, a time of 0 both."""
    for low, critical, timer, expected in (
        (0, 1, TIMER, [CRITICAL]),
        (1, 0, TIMER, [LOW]),
        (0, 0, TIMER, []),
        (1, 1, 0, []),
    ):
        watch = armed_watch()
        watch.set(low * watch.low, critical * watch.critical, timer)
        watch.readings(1, 20 * watch.per_second)
        assert [level for level, _ in watch.events] == expected, (low, critical, timer, watch.events)


def disarmed_it_rests():
    """While disarmed nothing is reached, and nothing of that time counts afterwards."""
    watch = new_watch()
    second = watch.per_second
    assert watch.readings(watch.deep, 600 * second) == []
    watch = armed_watch()
    watch.readings(watch.between, 6 * second)
    watch.craft.disarm()
    watch.readings(watch.between, 2 * second)
    watch.arm()
    assert watch.readings(watch.between, 12 * second) == [(LOW, 18 * second)], watch.events


def nothing_clears_it():
    """Recovery, disarming, arming by force, other thresholds: the level stays; it rises from low to critical."""
    for value, level in (("between", LOW), ("deep", CRITICAL)):
        watch = armed_watch(1)
        watch.readings(getattr(watch, value), 2 * watch.per_second)
        assert watch.failsafe.level == level
        watch.readings(watch.low + 1000, 30 * watch.per_second)
        watch.craft.disarm()
        watch.readings(watch.low + 1000, 2 * watch.per_second)
        watch.arm()
        watch.set(0, 0, 0)
        watch.readings(None, 2 * watch.per_second)
        assert watch.failsafe.level == level
        assert len(watch.events) == 1, watch.events
    watch = armed_watch(1)
    state = 12345
    highest = 0
    for _ in range(3000):
        state = (state * 1103515245 + 12345) & 0x3FFFFFFF
        watch.readings((None, watch.low, watch.between, watch.deep, watch.between, watch.deep)[(state >> 12) % 6])
        assert watch.failsafe.level >= highest
        highest = watch.failsafe.level
    assert watch.readings(watch.deep, 2 * watch.per_second)[-1][0] == CRITICAL


def text_of_each_escalation():
    """One warning for each escalation, in ArduPilot's words, with the value of that moment, in a single frame."""
    watch = armed_watch(1)
    facts = watch.facts
    watch.readings(watch.between, 3 * watch.per_second)
    watch.readings(watch.deep, 3 * watch.per_second)
    texts = watch.craft.said(facts["title"] + " is ")
    tail = facts["tails"][0]
    expected = [
        (
            dialect.MAV_SEVERITY_WARNING,
            f"{facts['title']} is {word} {value / facts['divisor']:.2f}{tail}",
        )
        for word, value in (("low", watch.between), ("critical", watch.deep))
    ]
    assert texts == expected, texts
    assert max(len(text) for _, text in texts) <= 50


def text_counts_the_charge_used():
    """Another quantity stands in the text once it is known, such as the charge that was used."""
    watch = armed_watch(1)
    needs(watch.facts["used"], "another quantity in the text")
    setattr(watch.component, watch.facts["used"], 1234)
    watch.readings(watch.between, 2 * watch.per_second)
    assert watch.craft.said(watch.facts["title"] + " is ")[0][1].endswith(watch.facts["tails"][1])


def _note(craft, name):
    def call():
        craft.calls.append(name)

    return call


def each_action_is_its_call():
    """For each value of both parameters exactly that call is made, once, with its mode; 0 is none."""
    for level, value in (("low", "between"), ("critical", "deep")):
        for number, call, mode, disarms in ((0, None, None, False),) + ACTIONS:  # noqa: RUF005  MicroPython cannot
            watch = armed_watch(1)
            craft = watch.craft
            facts = watch.facts
            choices = parameter_of(facts[level + "_action"])
            if not choices["minimum"] <= number <= choices["maximum"]:
                continue
            for _, name, _, _ in ACTIONS:
                setattr(craft, name, _note(craft, name))
            setattr(watch.parameters, facts["low_action"], 0)
            setattr(watch.parameters, facts["critical_action"], 0)
            setattr(watch.parameters, facts[level + "_action"], number)
            mode_before = craft.state.vehicle.mode_number
            craft.calls = []
            watch.readings(getattr(watch, value), 5 * watch.per_second)
            expected = [call] if call else []
            if disarms:
                expected.append("on_disarm")
            assert craft.calls == expected, (level, number, craft.calls)
            assert craft.state.vehicle.mode_number == (mode_before if mode is None else mode), (level, number)
            assert craft.is_armed != disarms, (level, number)


def action_that_raises_does_no_harm():
    """A fault in the user's call is logged and everything goes on; what disarms has disarmed even then."""
    for number, call, _, disarms in ACTIONS:
        watch = armed_watch(1)

        def fail():
            raise ValueError("broken")

        setattr(watch.craft, call, fail)
        setattr(watch.parameters, watch.facts["low_action"], number)
        watch.readings(watch.between, 3 * watch.per_second)
        assert watch.failsafe.level == LOW
        assert watch.craft.is_armed != disarms, call
        job = watch.facts["component"] if watch.period_us <= CHECKS_US else "checks"
        assert len(watch.craft.said(job + " failed")) == 1
        passes = watch.craft.port.looks
        watch.readings(watch.deep, 3 * watch.per_second)
        assert watch.craft.port.looks >= passes + 3 * watch.per_second
        assert watch.failsafe.level == (LOW if disarms else CRITICAL)


def heartbeat_says_critical():
    """MAV_STATE_CRITICAL from the pass of the trigger on, also when disarmed; standby and active before."""
    watch = new_watch(1)
    vehicle = watch.craft.state.vehicle
    assert vehicle.status == dialect.MAV_STATE_STANDBY
    watch.arm()
    assert vehicle.status == dialect.MAV_STATE_ACTIVE
    watch.readings(watch.between, watch.per_second)
    assert vehicle.status == dialect.MAV_STATE_ACTIVE
    watch.readings(watch.between)
    assert vehicle.status == dialect.MAV_STATE_CRITICAL
    watch.craft.disarm()
    assert vehicle.status == dialect.MAV_STATE_CRITICAL


def counts_lead_to_both_levels():
    """From the converter's counts on, through the real board: low, then critical, with the default parameters."""
    needs(FAILSAFES, "a failsafe")
    facts = FAILSAFES[0]
    measured = next(each for each in MEASURED if each["component"] == facts["component"])
    low, critical = parameter_of(facts["low"])["default"], parameter_of(facts["critical"])["default"]
    timer = parameter_of(facts["after"])["default"]
    multiplier = parameter_of(measured["multiplier"])["default"]
    full = measured["full_scale"] * multiplier * measured["numerator"] // measured["denominator"]
    low, critical = low * facts["low_scale"], critical * facts["critical_scale"]
    if not (0 < critical < low < full and 0 < timer <= 120):
        raise NotHereError("defaults that both levels can be reached with")
    craft = new_craft()
    failsafe = getattr(craft, facts["list"])[0]
    _let_run(craft, measured, full - 1, 1)
    assert craft.arm(force=True) is None
    _let_run(craft, measured, (low + critical) // 2, timer + 1)
    assert failsafe.level == LOW
    _let_run(craft, measured, critical * 9 // 10, timer + 1)
    assert failsafe.level == CRITICAL


def _let_run(craft, measured, value, seconds):
    multiplier = getattr(craft.parameters, measured["multiplier"])
    count = value * measured["denominator"] // (measured["numerator"] * multiplier)
    new = min(count, measured["full_scale"]) << measured["spare_bits"]
    analog(measured).source = new
    for _ in range(seconds * 1000000 // measured["period_us"]):
        craft.run_pass()
        mock_time.advance_us(measured["period_us"])


CHECKS = (
    (low_after_the_timer, "pair.first"),
    (default_timer_is_the_specified_one, "pair.first"),
    (critical_goes_first, "pair.second"),
    (each_level_has_its_own_timer, "pair.second"),
    (one_good_reading_restarts, "pair.timer"),
    (unknown_neither_restarts_nor_advances, "pair.timer"),
    (zero_switches_off, "pair.off"),
    (disarmed_it_rests, "pair.disarmed"),
    (nothing_clears_it, "pair.latch"),
    (text_of_each_escalation, "pair.text"),
    (text_counts_the_charge_used, "pair.text"),
    (each_action_is_its_call, "pair.action"),
    (action_that_raises_does_no_harm, "pair.action"),
    (heartbeat_says_critical, "pair.status"),
    (counts_lead_to_both_levels, "component.scenarios"),
)
LONG = (
    low_after_the_timer,
    each_level_has_its_own_timer,
    one_good_reading_restarts,
    unknown_neither_restarts_nor_advances,
    zero_switches_off,
    disarmed_it_rests,
    nothing_clears_it,
    each_action_is_its_call,
)

if __name__ == "__main__":
    main(CHECKS)
