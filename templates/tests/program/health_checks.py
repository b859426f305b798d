"""Trend, health, remaining charge and readings of what is measured, as the program sees them."""

from program_bench import (
    SECOND_US,
    TURN_MS_US,
    Craft,
    Watch,
    analog,
    good_count,
    machine,
    main,
    mock_time,
    needs,
    new_craft,
    ready_craft,
    run,
    save,
)
from program_facts import FAILSAFES, FORCE_ARM, HEALTH_MS, MEASURED, PARAMETERS

import dialect


def _state_of(craft, measured):
    state = getattr(craft.state, measured["component"])
    return state[0] if measured["first"] != measured["component"] else state


def _trending():
    measured = [each for each in MEASURED if each["trend"]]
    needs(measured, "a trend")
    return measured[0]


def _trend_after(values):
    """Return the trend after readings of these values, None for unknown, through the component itself."""
    measured = _trending()
    component = _state_of(new_craft(), measured)
    for value in values:
        if value is None:
            component.forget()
        else:
            setattr(component, measured["attribute"], value)
            component.set_count(-1, 1)  # a failed reading counts the value once more
            component.failures = 0
    return getattr(component, measured["trend"])


def ramp_gives_its_slope():
    """Rising is positive, falling negative, each exactly the slope in stored steps per second."""
    measured = _trending()
    window = 2 * measured["trend_half"]
    for slope in (-500, -5, -1, 0, 1, 10, 333):
        expected = slope * SECOND_US // measured["period_us"]
        for more in (0, 1, window // 2, window, 2 * window + 1, 5 * window):
            values = [20000 + slope * index for index in range(window + more)]
            assert _trend_after(values) == expected, (slope, more)


def step_is_spread_over_the_window():
    """After a step the trend rises and falls with the readings behind it."""
    measured = _trending()
    half = measured["trend_half"]
    slopes = []
    for after in range(0, 2 * half + 1, half // 2):
        slopes.append(_trend_after([20000] * (2 * half) + [16000] * after))
    peak = -4000 * SECOND_US // (half * measured["period_us"])
    assert slopes == [0, peak // 2, peak, peak // 2, 0], slopes


def unknown_until_the_window_is_full():
    """One reading less than the window is not enough, at the start and after the value was unknown."""
    window = 2 * _trending()["trend_half"]
    assert _trend_after([12000] * (window - 1)) is None
    assert _trend_after([12000] * window) == 0
    assert _trend_after([12000] * window + [None] + [12000] * (window - 1)) is None
    assert _trend_after([12000] * window + [None] + [12000] * window) == 0


def failed_reading_keeps_the_window():
    """A failed reading that leaves the value known counts with the last good one; the window does not start anew."""
    measured = _trending()
    craft = new_craft()
    component = _state_of(craft, measured)
    run(craft, 2 * measured["trend_half"] * measured["period_us"], measured["period_us"])
    assert getattr(component, measured["trend"]) == 0
    analog(measured).failures = 1
    run(craft, measured["period_us"], measured["period_us"])
    assert getattr(component, measured["trend"]) == 0
    needs(measured["invalid_after"], "a limit for failed readings")
    analog(measured).failures = measured["invalid_after"]
    run(craft, measured["invalid_after"] * measured["period_us"], measured["period_us"])
    assert getattr(component, measured["trend"]) is None
    run(craft, measured["period_us"], measured["period_us"])
    assert getattr(component, measured["attribute"]) is not None
    assert getattr(component, measured["trend"]) is None


def _judging(low=10500, critical=9900):
    needs(FAILSAFES and FAILSAFES[0]["health"], "a health")
    facts = FAILSAFES[0]
    unit = facts["low_scale"] * facts["critical_scale"]
    return Watch(low * unit, critical * unit, 10), unit


def health_by_thresholds():
    """Healthy at or above the low threshold, warning below it, unhealthy below the other or unknown; 0 is off."""
    for value, low, critical, expected in (
        (12000, 10500, 9900, 0),
        (10500, 10500, 9900, 0),
        (10499, 10500, 9900, 1),
        (9900, 10500, 9900, 1),
        (9899, 10500, 9900, 2),
        (None, 10500, 9900, 2),
        (9899, 10500, 0, 1),
        (10200, 0, 9900, 0),
        (9899, 0, 9900, 2),
        (None, 0, 0, 2),
    ):
        watch, unit = _judging(low, critical)
        watch.readings(None if value is None else value * unit)
        assert getattr(watch.component, watch.facts["health"]) == expected, (value, low, critical)


def health_of_every_step():
    """Between the thresholds there is no other order: every step from below the one to above the other."""
    watch, unit = _judging(60, 30)
    for value in range(25 * unit, 65 * unit):
        watch.readings(value)
        expected = 2 if value < 30 * unit else 1 if value < 60 * unit else 0
        assert getattr(watch.component, watch.facts["health"]) == expected, value


def change_of_health_is_logged_once():
    """Each change that lasts is one text; swinging around a threshold is bounded by the time between two."""
    watch, unit = _judging()
    title = watch.facts["title"] + " health: "
    lasting = (2 * HEALTH_MS * 1000) // watch.period_us
    for value in (12000, 10400, 9800, 12000):
        watch.readings(value * unit, lasting)
    severities = (dialect.MAV_SEVERITY_WARNING, dialect.MAV_SEVERITY_WARNING, dialect.MAV_SEVERITY_INFO)
    words = ("warning", "unhealthy", "healthy")
    expected = [(severity, title + word) for severity, word in zip(severities, words)]  # noqa: B905  no strict there
    assert watch.craft.said(title) == expected, watch.craft.said(title)
    watch, unit = _judging()
    for _ in range(3 * lasting // 2):
        watch.readings(10500 * unit)
        watch.readings(10500 * unit - 1)
    assert 6 <= len(watch.craft.said(title)) <= 7, watch.craft.said(title)


def health_is_told_after_days():
    """Half a turn of ticks_ms() after the last text, a change is still told."""
    watch, unit = _judging()
    title = watch.facts["title"] + " health: "
    lasting = (2 * HEALTH_MS * 1000) // watch.period_us
    for value in (12000, 10400, 12000):
        watch.readings(value * unit, lasting)
    told = len(watch.craft.said(title))
    for _ in range(160):
        mock_time.advance_us(3600000000)
        watch.readings(12000 * unit)
    watch.readings(10400 * unit)
    assert len(watch.craft.said(title)) == told + 1, watch.craft.said(title)


def estimated():
    """An estimate follows its curve, unknown with the value and once that is gone; without a curve it stays unknown."""
    needs(MEASURED, "something that is measured")
    for measured in MEASURED:
        component = _state_of(new_craft(), measured)
        for name in measured["not_estimated"]:
            component.set_count(measured["full_scale"], 1)
            assert getattr(component, name) is None
        multiplier = next(each["default"] for each in PARAMETERS if each["attribute"] == measured["multiplier"])
        for estimate, points in measured["estimates"]:
            _follows(component, measured, estimate, points, multiplier)


def _follows(component, measured, estimate, points, multiplier):
    returns = measured["returns"]
    begins_anew = returns and any(name == estimate for name, _ in returns["restarting"])
    gone = returns["gone"] if begins_anew else None
    for count in range(0, measured["full_scale"] + 1, 5):
        component.set_count(count, multiplier)
        value, found = getattr(component, measured["attribute"]), getattr(component, estimate)
        if gone and getattr(component, gone):
            assert found is None, (value, found)
            continue
        assert value > points[0][0] or found == points[0][1], (value, found)
        assert value < points[-1][0] or found == points[-1][1], (value, found)
        for (low, one), (high, other) in zip(points, points[1:]):  # noqa: B905, RUF007  MicroPython has neither
            assert not low <= value <= high or min(one, other) <= found <= max(one, other), (value, found)
    component.forget()
    assert getattr(component, estimate) is None


def monitor_off_measures_nothing():
    """With the monitor off the converter is left alone, the value stays unknown, and nothing is complained about."""
    for measured in MEASURED:
        needs(measured["enabled_by"], "a parameter that switches the component off")
        name = next(each["name"] for each in PARAMETERS if each["attribute"] == measured["enabled_by"])
        before = new_craft()
        assert before.parameters.set(name, 0)
        flash = before.flash
        flash.files = {}
        save(before)
        craft = ready_craft(flash=flash)
        reads = analog(measured).reads
        run(craft, 5 * SECOND_US)
        assert analog(measured).reads == reads
        assert getattr(_state_of(craft, measured), measured["attribute"]) is None
        assert FORCE_ARM is None or craft.arm() is None


def read_often_enough():
    """In a minute at least as many readings as the period asks for, each of the specified samples, on its GPIO."""
    for measured in MEASURED:
        craft = new_craft()
        reads = analog(measured).reads
        run(craft, 60 * SECOND_US)
        readings = 60 * SECOND_US // measured["period_us"]
        done = analog(measured).reads - reads
        assert readings <= done // measured["samples"] <= readings + 1, done


def pin_counts_from_the_next_start():
    """The converter on another GPIO is read after the next start, not before."""
    for measured in MEASURED:
        needs(measured["pin"], "a parameter that has the pin")
        facts = next(each for each in PARAMETERS if each["attribute"] == measured["pin"])
        for gpio in range(facts["minimum"], facts["maximum"] + 1):
            craft = _alone(measured)
            setattr(craft.parameters, measured["pin"], gpio)
            run(craft, SECOND_US)
            first = measured["gpios"][0]
            assert gpio == first or machine.analog(gpio).reads == 0
            save(craft)
            craft = new_craft(flash=craft.flash)
            run(craft, SECOND_US)
            assert machine.analog(gpio).reads > 0, gpio
            assert gpio == first or analog(measured).reads == 0


def _alone(measured):
    """Return a vehicle with the first instance only: the others, which may have any pin, are switched off."""
    craft = new_craft()
    for name in measured["families"]["enabled_by"][1:]:
        setattr(craft.parameters, name, 0)
    save(craft)
    return new_craft(flash=craft.flash)


def first_value_is_told_once():
    """The first value is logged as information, once."""
    for measured in MEASURED:
        craft = new_craft()
        run(craft, 5 * SECOND_US)
        title = measured["component"] if measured["instances"] == 1 else measured["component"] + " 1"
        assert len(craft.said(title + ": ")) == 1, craft.said()


def runs_without_a_converter():
    """A converter that cannot be set up is warned about; the vehicle runs, the value is unknown, arming is refused."""
    for measured in MEASURED:
        machine.reset_analog()
        analog(measured).absent = True
        try:
            craft = Craft()  # new_craft() would repair the converter
            run(craft, 60 * SECOND_US)
        finally:
            machine.reset_analog()
        warnings = [text for severity, text in craft.said() if severity == dialect.MAV_SEVERITY_WARNING]
        assert "no ADC" in warnings[0], craft.said()
        assert getattr(_state_of(craft, measured), measured["attribute"]) is None
        assert craft.port.looks >= 60 * SECOND_US // 100000
        assert not FAILSAFES or craft.arm() is not None


def faults_of_an_input_are_told_now_and_then():
    """The first of several at once, then one in ten seconds with how many there were: also where ticks start again."""
    needs(MEASURED, "something that is measured")
    for measured in MEASURED:
        period = measured["period_us"]
        every = -(-10 * SECOND_US // period)  # readings
        craft = new_craft(at_us=TURN_MS_US - 15 * SECOND_US)
        run(craft, period, period)
        source, analog(measured).source = analog(measured).source, None
        found, expected = [], []
        for number in range(3 * every + 1):
            if number % every == 0:
                expected.append((number, f" ({every - 1} more)" if number and every > 1 else ""))
            before = len(_faults(craft, "cannot be read"))
            run(craft, period, period)
            found += [(number, rest) for rest in _faults(craft, "cannot be read")[before:]]
        assert found == expected, found
        analog(measured).source = source
        if measured["read_limit_us"]:  # that is another fault, which is told at once
            analog(measured).delay_us = 2 * measured["read_limit_us"]
            run(craft, 2 * period, period)
            assert len(_faults(craft, "took too long to read")) == 1, craft.said()


def _faults(craft, what):
    """Return what the texts about an input say behind these words."""
    return [text.split(what)[1] for _, text in craft.said() if f"'s ADC {what}" in text]


def a_converter_that_comes_back_is_used():
    """One that could not be set up is tried again in ten seconds, which is told, and its readings count."""
    needs(MEASURED, "something that is measured")
    for measured in MEASURED:
        good = new_craft()  # what the inputs show stays
        analog(measured).absent = True
        craft = Craft()
        run(craft, SECOND_US, measured["period_us"])
        assert getattr(_state_of(craft, measured), measured["attribute"]) is None
        analog(measured).absent = False
        run(craft, 11 * SECOND_US + 2 * measured["period_us"], measured["period_us"])
        told = [text for _, text in craft.said() if " is read on GPIO " in text]
        assert len(told) == 1, craft.said()
        run(good, 2 * measured["period_us"], measured["period_us"])
        value = getattr(_state_of(craft, measured), measured["attribute"])
        assert value == getattr(_state_of(good, measured), measured["attribute"]), value


def sensor_loss_is_noticed():
    """Failing readings make the value unknown after the specified number; one good reading makes it known again."""
    for measured in MEASURED:
        needs(measured["invalid_after"], "a limit for failed readings")
        craft = new_craft()
        component = _state_of(craft, measured)
        run(craft, SECOND_US)
        source, analog(measured).source = analog(measured).source, None
        period = measured["period_us"]
        run(craft, (measured["invalid_after"] - 1) * period, period)
        assert getattr(component, measured["attribute"]) is not None
        run(craft, period, period)
        assert getattr(component, measured["attribute"]) is None
        analog(measured).source = source
        run(craft, period, period)
        assert getattr(component, measured["attribute"]) is not None


def late_reading_is_refused_in_the_program():
    """Readings that take too long keep the last value, are complained about once, and then the value is given up."""
    for measured in MEASURED:
        needs(measured["read_limit_us"], "a limit for the time of a reading")
        craft = new_craft()
        component = _state_of(craft, measured)
        run(craft, SECOND_US)
        analog(measured).delay_us = 100000
        run(craft, 10 * SECOND_US)
        assert getattr(component, measured["attribute"]) is None
        errors = [text for severity, text in craft.said() if severity == dialect.MAV_SEVERITY_ERROR]
        assert len(errors) == 1, errors
        assert craft.scheduler.overruns > 0


def high_value_is_warned_about_at_intervals():
    """A value that stays too high, or swings around the limit, is warned about once in each interval."""
    for measured in MEASURED:
        needs(measured["warning_counts"][0] is not None, "a count that is warned about")
        needs(measured["warn_every_ms"], "a time between warnings")
        period = measured["period_us"]
        first = measured["warning_counts"][0] << measured["spare_bits"]
        for swings in (False, True):
            craft = new_craft(at_us=TURN_MS_US - 3500 * measured["warn_every_ms"])  # the ticks start again meanwhile
            for index in range(6 * measured["warn_every_ms"] * 1000 // period):
                analog(measured).source = first - (index % 2 << measured["spare_bits"] if swings else 0)
                run(craft, period, period)
            warned = [text for _, text in craft.said() if "above" in text]
            assert 6 <= len(warned) <= 7, craft.said()
        craft = new_craft()
        analog(measured).source = first - 1
        run(craft, 10 * SECOND_US, period)
        assert not [text for _, text in craft.said() if "above" in text]


def readings_at_their_edges():
    """Below a half and at one it is rounded to the nearest; at the limit it is not warned about, a step above it is."""
    for measured in MEASURED:
        needs(measured["edges"], "a multiplier that comes to an edge")
        family = measured["families"]["multiplier"]
        for count, steps, value, is_warned in measured["edges"]:
            craft = new_craft()
            setattr(craft.parameters, family[0] if family else measured["multiplier"], steps)
            save(craft)
            craft = new_craft(flash=craft.flash)
            analog(measured).source = count << measured["spare_bits"]
            run(craft, SECOND_US, measured["period_us"])
            component = getattr(craft.state, measured["component"])
            component = component if measured["first"] == measured["component"] else component[0]
            assert getattr(component, measured["attribute"]) == value, (count, steps)
            assert bool([text for _, text in craft.said() if "above" in text]) == is_warned, (count, steps)


def good_count_is_good():
    """The value that the other checks start from is neither low nor worth a warning."""
    for measured in MEASURED:
        craft = ready_craft()
        run(craft, SECOND_US)
        assert good_count(measured) > 0
        assert not [text for severity, text in craft.said() if severity <= dialect.MAV_SEVERITY_WARNING], craft.said()
        mock_time.set_ticks_us(0)


CHECKS = (
    (ramp_gives_its_slope, "quantity.slope"),
    (step_is_spread_over_the_window, "quantity.slope"),
    (unknown_until_the_window_is_full, "quantity.gaps"),
    (failed_reading_keeps_the_window, "quantity.gaps"),
    (health_by_thresholds, "failsafe.health"),
    (health_of_every_step, "failsafe.health"),
    (change_of_health_is_logged_once, "failsafe.health_text"),
    (health_is_told_after_days, "failsafe.health_text"),
    (estimated, "quantity.estimate"),
    (pin_counts_from_the_next_start, "reading.pin"),
    (monitor_off_measures_nothing, "reading.monitor"),
    (read_often_enough, "reading.rate", "component.rate"),
    (first_value_is_told_once, "reading.first"),
    (runs_without_a_converter, "reading.absence"),
    (faults_of_an_input_are_told_now_and_then,),
    (a_converter_that_comes_back_is_used, "reading.absence"),
    (sensor_loss_is_noticed, "quantity.invalid_after", "quantity.stale_after"),
    (high_value_is_warned_about_at_intervals, "quantity.warn_above"),
    (readings_at_their_edges, "quantity.multiplier", "quantity.warn_above"),
    (late_reading_is_refused_in_the_program, "reading.read_limit"),
    (good_count_is_good, "component.mock"),
)
LONG = (
    change_of_health_is_logged_once,
    health_is_told_after_days,
    pin_counts_from_the_next_start,
    read_often_enough,
    runs_without_a_converter,
    high_value_is_warned_about_at_intervals,
)

if __name__ == "__main__":
    main(CHECKS)
