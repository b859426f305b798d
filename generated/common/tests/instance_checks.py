# Generated from templates/tests/program/instance_checks.py: do not edit.
# Inputs: 50ae9c2fbbc627d1
"""Several instances of a component: each is measured, watched and reported by itself; one that is off is left out."""

from program_bench import (
    IS_MICROPYTHON,
    SECOND_US,
    Craft,
    Sink,
    fitted,
    good_count,
    id_of,
    machine,
    main,
    mock_time,
    needs,
    new_craft,
    run,
    save,
    value_of,
)
from program_facts import ACTIONS, CONTROL_US, FAILSAFES, MEASURED, PARAMETERS, STREAMS

import dialect

try:
    from micropython import heap_lock, heap_unlock, mem_total
except ImportError:  # CPython has no heap to lock, and no check asks for one there
    heap_lock = heap_unlock = mem_total = None

LOW, CRITICAL = 1, 2


def _several():
    """Return what is measured of a component of which two instances at least can be on, each at its own pin."""
    found = [each for each in MEASURED if each["instances"] > 1 and each["families"]["pin"]]
    needs(found and found[0]["families"]["enabled_by"], "several instances with pins and switches of their own")
    return found[0]


def _watched():
    """Return the same with its failsafe, in which each instance has thresholds, times and actions of its own."""
    measured = _several()
    facts = [each for each in FAILSAFES if each["component"] == measured["component"]]
    families = facts[0]["families"] if facts else {"": None}
    needs(all(families[key] for key in families if key != "minimum"), "a failsafe with parameters for each instance")
    return measured, facts[0]


def _pins(measured):
    """Return GPIO numbers with an ADC, for as many instances as there are."""
    return [26, 27, 28][: measured["instances"]]


def craft_with(measured, on=None, **arguments):
    """Return a vehicle in which so many instances are on, or all that have pins, with a good value at each pin."""
    pins = _pins(measured)
    families = measured["families"]
    first = new_craft()
    for instance in range(measured["instances"]):
        is_on = instance < (len(pins) if on is None else on)
        switch = next(each for each in PARAMETERS if each["attribute"] == families["enabled_by"][0])
        setattr(first.parameters, families["enabled_by"][instance], (switch["default"] or 1) if is_on else 0)
        setattr(first.parameters, families["pin"][instance], pins[instance] if instance < len(pins) else pins[0])
    save(first)
    machine.reset_analog()
    for instance, gpio in enumerate(pins):
        machine.analog(gpio).source = good_count(measured, instance)
    return fitted(Craft(flash=first.flash, **arguments))


def _components(craft, measured):
    return getattr(craft.state, measured["component"])


def _values(craft, measured):
    return [getattr(component, measured["attribute"]) for component in _components(craft, measured)]


def each_is_read_at_its_pin():
    """Different voltages at the pins are different values, and one that changes leaves the others alone."""
    measured = _several()
    pins = _pins(measured)
    craft = craft_with(measured)
    counts = [good_count(measured) * (9 - number) // 10 for number in range(len(pins))]
    for gpio, count in zip(pins, counts):  # noqa: B905  no strict there
        machine.analog(gpio).source = count
    run(craft, SECOND_US)
    before = _values(craft, measured)[: len(pins)]
    assert before == [value_of(measured, count, number) for number, count in enumerate(counts)], before
    for number, gpio in enumerate(pins):
        machine.analog(gpio).source = good_count(measured) * 5 // 10
        run(craft, SECOND_US)
        after = _values(craft, measured)[: len(pins)]
        assert [at for at in range(len(pins)) if after[at] != before[at]] == [number], (before, after)
        before = after


def each_is_told_once():
    """The first value of each is logged, with its number."""
    measured = _several()
    craft = craft_with(measured)
    run(craft, 5 * SECOND_US)
    for number in range(1, len(_pins(measured)) + 1):
        assert len(craft.said(f"{measured['component']} {number}: ")) == 1, craft.said()


def each_has_its_own_multiplier():
    """A calibration changes the multiplier of one instance, which counts from the next start if it is latched."""
    measured = _several()
    names = measured["families"]["multiplier"]
    needs(names, "a multiplier for each instance")
    craft = craft_with(measured)
    run(craft, SECOND_US)
    before = [getattr(craft.parameters, name) for name in names]
    meter = getattr(_components(craft, measured)[1], measured["name"]) * 1.1
    assert getattr(craft.state, "calibrate_" + measured["component"])(meter, 1)
    changed = [at for at, name in enumerate(names) if getattr(craft.parameters, name) != before[at]]
    assert changed == [1], changed
    save(craft)
    again = Craft(flash=craft.flash)
    run(again, SECOND_US)
    values, former = _values(again, measured), _values(craft, measured)
    assert values[0] == former[0]
    assert abs(values[1] - former[1] * 1.1) <= former[1] // 1000, (former, values)


def each_fails_by_itself():
    """Failing readings of one make it unknown, are an error with its number once, and leave the others alone."""
    measured = _several()
    needs(measured["invalid_after"], "a limit for failed readings")
    pins = _pins(measured)
    for number, gpio in enumerate(pins):
        craft = craft_with(measured)
        run(craft, SECOND_US)
        machine.analog(gpio).source = None
        run(craft, 5 * SECOND_US)
        unknown = [at for at, value in enumerate(_values(craft, measured)[: len(pins)]) if value is None]
        assert unknown == [number], unknown
        errors = [text for severity, text in craft.said() if severity == dialect.MAV_SEVERITY_ERROR]
        assert len(errors) == 1, errors
        assert f"{measured['component']} {number + 1}" in errors[0], errors


def one_that_is_off_is_left_out():
    """Its pin is not read, its value unknown, a missing converter there no warning, and arming does not wait."""
    measured = _several()
    craft = craft_with(measured, on=1)
    for gpio in _pins(measured)[1:]:
        machine.analog(gpio).absent = True
    craft = fitted(Craft(flash=craft.flash))
    reads = [machine.analog(gpio).reads for gpio in _pins(measured)[1:]]
    run(craft, 10 * SECOND_US)
    assert [machine.analog(gpio).reads for gpio in _pins(measured)[1:]] == reads
    assert _values(craft, measured)[1:] == [None] * (measured["instances"] - 1)
    assert not [text for severity, text in craft.said() if severity <= dialect.MAV_SEVERITY_WARNING], craft.said()
    assert craft.arm() is None
    machine.reset_analog()


def _sent_in(craft, duration_us):
    """Return how many frames of each message went out, by its id."""
    craft.port.frames = []
    run(craft, duration_us)
    sent = {}
    for frame in craft.port.frames:
        number = id_of(frame)
        sent[number] = sent.get(number, 0) + 1
    return sent


def each_that_is_on_is_reported():
    """Messages of instances go out once for each that is on; those that follow no switch are as many as before."""
    measured = _several()
    counts = [_sent_in(craft_with(measured, on=on), 20 * SECOND_US) for on in (1, len(_pins(measured)))]
    of_instances = 0
    for stream in STREAMS:
        for number, _, is_switched in stream["messages"]:
            one, several = (count.get(number, 0) for count in counts)
            factor = len(_pins(measured)) if is_switched else 1
            assert abs(several - factor * one) <= factor, (stream["name"], number, one, several)
            of_instances += is_switched and one > 0
    assert of_instances, "no message of an instance went out"


def _watching(low=(), critical=()):
    """Return an armed vehicle whose readings of these instances are below a level, and what calls it makes."""
    measured, facts = _watched()
    craft = craft_with(measured)
    run(craft, SECOND_US)
    assert craft.arm(force=True) is None
    for instance in range(measured["instances"]):
        families = facts["families"]
        setattr(craft.parameters, families["after"][instance], 1)
        value = _values(craft, measured)[instance]
        for level, those in (("low", low), ("critical", critical)):
            steps = (value + 1000) // facts[level + "_scale"] if instance in those else 0
            setattr(craft.parameters, families[level][instance], steps)
    for _, name, _, _ in ACTIONS:
        setattr(craft, name, _note(craft, name))
    craft.calls = []
    return craft, measured, facts


def _note(craft, name):
    def call():
        craft.calls.append(name)

    return call


def _two_actions():
    calls = [(value, call) for value, call, _, disarms in ACTIONS if not disarms]
    needs(len(calls) > 1, "two actions")
    return calls[0], calls[1]


def _levels(craft, facts):
    return [failsafe.level for failsafe in getattr(craft, facts["list"])]


def failsafe_of_one_is_its_own():
    """One that stays too low has its level, text and action; the vehicle's status is critical, the others have none."""
    (first, _), (second, call) = _two_actions()
    craft, measured, facts = _watching(low=(1,))
    setattr(craft.parameters, facts["families"]["low_action"][0], first)
    setattr(craft.parameters, facts["families"]["low_action"][1], second)
    run(craft, 3 * SECOND_US)
    expected = [LOW if instance == 1 else 0 for instance in range(measured["instances"])]
    assert _levels(craft, facts) == expected, _levels(craft, facts)
    assert craft.calls == [call], craft.calls
    title = facts["title"][:-1]
    assert [text[1].partition(" is ")[0] for text in craft.said(title) if " is " in text[1]] == [title + "2"]
    assert craft.state.vehicle.status == dialect.MAV_STATE_CRITICAL
    if facts["level"]:
        levels = [getattr(component, facts["level"]) for component in _components(craft, measured)]
        assert levels == expected, levels


def highest_of_two_acts():
    """Two levels in one pass: both are told, and the higher one acts, whichever comes first; of equals the first."""
    (first, one), (second, other) = _two_actions()
    for lows, criticals, expected in (((0,), (1,), other), ((1,), (0,), one), ((0, 1), (), one)):
        craft, _, facts = _watching(low=lows, critical=criticals)
        for level in ("low_action", "critical_action"):
            setattr(craft.parameters, facts["families"][level][0], first)
            setattr(craft.parameters, facts["families"][level][1], second)
        run(craft, 3 * SECOND_US)
        reached = [LOW] * len(lows) + [CRITICAL] * len(criticals)
        assert sorted(_levels(craft, facts))[-2:] == reached, _levels(craft, facts)
        assert craft.calls == [expected], craft.calls


def lower_level_does_not_act_later():
    """After one is critical, another that gets low is told, but what the first asked for goes on."""
    (first, one), (second, _) = _two_actions()
    craft, measured, facts = _watching(critical=(0,))
    setattr(craft.parameters, facts["families"]["critical_action"][0], first)
    setattr(craft.parameters, facts["families"]["low_action"][1], second)
    run(craft, 3 * SECOND_US)
    assert craft.calls == [one], craft.calls
    value = _values(craft, measured)[1]
    setattr(craft.parameters, facts["families"]["low"][1], (value + 1000) // facts["low_scale"])
    run(craft, 3 * SECOND_US)
    assert _levels(craft, facts)[:2] == [CRITICAL, LOW], _levels(craft, facts)
    assert craft.calls == [one], craft.calls


def arming_says_which():
    """A second that cannot be read, or is too low, keeps the vehicle from being armed, by its own name."""
    measured, facts = _watched()
    title = facts["title"][:-1] + "2"
    craft = craft_with(measured)
    machine.analog(_pins(measured)[1]).source = None
    run(craft, SECOND_US)
    assert craft.arm() == f"PreArm: {title} unhealthy", craft.arm()
    assert not craft.state.vehicle.ready
    craft = craft_with(measured)
    run(craft, SECOND_US)
    assert craft.arm() is None
    craft.disarm()
    value = _values(craft, measured)[1]
    setattr(craft.parameters, facts["families"]["low"][1], (value + 1000) // facts["low_scale"])
    assert craft.arm() == f"PreArm: {title} low {facts['quantity']} failsafe", craft.arm()


def each_has_its_own_minimum_to_arm():
    """A value below its own minimum is a reason not to arm, and no level of its failsafe."""
    measured, facts = _watched()
    minimums = facts["families"]["minimum"]
    needs(minimums and facts["minimum"], "a minimum for arming of each instance")
    craft = craft_with(measured)
    run(craft, SECOND_US)
    for instance, value in enumerate(_values(craft, measured)[: len(_pins(measured))]):
        assert craft.arm() is None
        own = getattr(craft.parameters, minimums[instance])
        setattr(craft.parameters, minimums[instance], value // facts["minimum_scale"] + 1)
        run(craft, 3 * SECOND_US)
        assert not any(_levels(craft, facts)), _levels(craft, facts)
        craft.disarm()
        title = facts["title"][:-1] + str(instance + 1)
        assert craft.arm() == f"PreArm: {title} below minimum arming {facts['quantity']}", craft.arm()
        setattr(craft.parameters, minimums[instance], own)


def health_of_each_is_its_own():
    """Each is judged by its own thresholds."""
    measured, facts = _watched()
    needs(facts["health"], "a health")
    craft, _, _ = _watching(low=(0,), critical=(1,))
    run(craft, SECOND_US)
    found = [getattr(component, facts["health"]) for component in _components(craft, measured)[:2]]
    assert found == [1, 2], found


def several_allocate_nothing():
    """The steady cycle with all of them on leaves the heap alone, while they are good and while they are too low."""
    needs(IS_MICROPYTHON, "a heap that tells")
    measured, facts = _watched()
    for level in (0, 100000):
        craft = craft_with(measured, ports=[Sink()])
        for stream in STREAMS:
            if stream["parameter"]:
                setattr(craft.parameters, stream["parameter"], stream["maximum"])
        run(craft, 5 * SECOND_US)
        for name in facts["families"]["low"]:
            setattr(craft.parameters, name, level // facts["low_scale"])
        run(craft, 26 * SECOND_US)  # what stands is said after 30 s, and not again before a minute is over
        heap_lock()
        try:
            _passes(craft)
        finally:
            heap_unlock()
        before = mem_total()
        _passes(craft)
        assert mem_total() == before, mem_total() - before


def _passes(craft):
    for _ in range(800):
        craft.run_pass()
        mock_time.advance_us(CONTROL_US)


CHECKS = (
    (each_is_read_at_its_pin, "component.own_readings"),
    (each_is_told_once, "component.own_readings"),
    (each_has_its_own_multiplier, "component.own_parameters"),
    (each_fails_by_itself, "component.own_readings"),
    (one_that_is_off_is_left_out, "component.off"),
    (each_that_is_on_is_reported, "component.own_messages"),
    (failsafe_of_one_is_its_own, "component.own_failsafe"),
    (highest_of_two_acts, "component.own_failsafe"),
    (lower_level_does_not_act_later, "component.own_failsafe"),
    (arming_says_which, "component.own_failsafe"),
    (each_has_its_own_minimum_to_arm, "component.own_failsafe"),
    (health_of_each_is_its_own, "component.own_failsafe"),
    (several_allocate_nothing, "component.several"),
)
LONG = (
    each_is_told_once,
    each_fails_by_itself,
    one_that_is_off_is_left_out,
    each_that_is_on_is_reported,
    highest_of_two_acts,
    lower_level_does_not_act_later,
    each_has_its_own_minimum_to_arm,
    several_allocate_nothing,
)

if __name__ == "__main__":
    main(CHECKS)
