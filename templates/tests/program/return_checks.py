"""Checks of returns, such as of a pack that is exchanged: each counts once, is told, and counting begins anew."""

from generation_checks import is_chosen
from instance_checks import craft_with
from program_bench import (
    CONTROL_US,
    IS_MICROPYTHON,
    SECOND_US,
    Sink,
    analog,
    good_count,
    id_of,
    machine,
    main,
    mock_time,
    needs,
    new_craft,
    run,
)
from program_facts import GENERATIONS, MEASURED, MESSAGES

import dialect

try:
    from micropython import mem_total
except ImportError:  # CPython has no heap that grows silently
    mem_total = None

WORTH = 77  # of what is counted, before something returns


def _returning():
    found = [measured for measured in MEASURED if measured["returns"]]
    needs(found, "something that counts what comes back")
    return found


def _inputs(measured):
    """Return a call for a vehicle, and by instance that can be on, the script of its ADC input."""
    families = measured["families"]
    if measured["instances"] > 1 and families["pin"] and families["enabled_by"]:
        pins = [26, 27, 28][: measured["instances"]]
        return lambda **arguments: craft_with(measured, **arguments), [machine.analog(pin) for pin in pins]
    return new_craft, [analog(measured)]


def _owner(craft, measured, instance):
    owner = getattr(craft.state, measured["component"])
    return owner[instance]


def _counts(craft, measured, places):
    return [getattr(_owner(craft, measured, place), measured["returns"]["count"]) for place in range(places)]


def _texts(craft):
    return [text for text in craft.said() if text[1].endswith(" connected")]


def _title(measured, instance):
    return measured["returns"]["title"] + (f" {instance + 1}" if measured["instances"] > 1 else "")


def gone_and_back_counts_once():
    """However long it is gone, and however long it is back: one more, and one text that says which."""
    for measured in _returning():
        start, inputs = _inputs(measured)
        for instance, wire in enumerate(inputs):
            craft = start()
            run(craft, SECOND_US)
            expected = [0] * len(inputs)
            for turn in (1, 2):
                wire.source = 0
                run(craft, turn * SECOND_US)
                assert _counts(craft, measured, len(inputs)) == expected, "gone is not back"
                wire.source = good_count(measured)
                run(craft, 3 * SECOND_US)
                expected[instance] += 1
                assert _counts(craft, measured, len(inputs)) == expected
                texts = [(dialect.MAV_SEVERITY_NOTICE, _title(measured, instance) + " connected")] * turn
                assert _texts(craft) == texts, _texts(craft)


def _least_count(craft, measured, instance, value):
    """Return the smallest count that stands for so many stored steps, or more."""
    attribute = measured["families"]["multiplier"]
    multiplier = getattr(craft.parameters, attribute[instance] if attribute else measured["multiplier"])
    steps = (multiplier * measured["numerator"], measured["denominator"])
    least = 0
    while (least * steps[0] * 2 + steps[1]) // (steps[1] * 2) < value:
        least += 1
    return least


def only_what_is_below_the_limit_is_gone():
    """To the stored unit, and by readings: the last count that is enough, and the first that is not."""
    for measured in _returning():
        limits = measured["returns"]["below"]
        needs(limits, "a limit below which it is gone")
        start, inputs = _inputs(measured)
        for instance, wire in enumerate(inputs):
            craft = start()
            owner = _owner(craft, measured, instance)
            for value, is_gone in ((limits[instance], False), (limits[instance] - 1, True), (None, False)):
                setattr(owner, measured["attribute"], value)
                assert getattr(owner, measured["returns"]["gone"]) is is_gone, value
            least = _least_count(craft, measured, instance, limits[instance])
            for count, is_gone in ((least, 0), (least - 1, 1)):
                wire.source = count << measured["spare_bits"]
                run(craft, SECOND_US)
                wire.source = good_count(measured)
                run(craft, SECOND_US)
                assert _counts(craft, measured, len(inputs))[instance] == is_gone, (count, is_gone)


def what_wavers_comes_back_once():
    """Readings between both limits change nothing: what is there stays there, and what is gone stays gone."""
    for measured in _returning():
        limits = measured["returns"]["back_from"]
        needs(limits, "a value from which on it is back")
        start, inputs = _inputs(measured)
        for instance, wire in enumerate(inputs):
            craft = start()
            below = _least_count(craft, measured, instance, measured["returns"]["below"][instance])
            back = _least_count(craft, measured, instance, limits[instance])
            there, between = back << measured["spare_bits"], (back - 1) << measured["spare_bits"]
            least = below << measured["spare_bits"]
            back_again = ((there, 1), (between, 1), (least, 1), (there, 1))
            gone = ((least, 0), (between, 0), (0, 0), (least, 0), (between, 0))
            for count, returned in gone + back_again:
                wire.source = count
                run(craft, SECOND_US)
                assert _counts(craft, measured, len(inputs))[instance] == returned, count


def a_failed_reading_says_nothing():
    """A value that is unknown for a while is no absence, and an absence is not forgotten over failed readings."""
    for measured in _returning():
        start, inputs = _inputs(measured)
        craft = start()
        run(craft, SECOND_US)
        for before, count in ((good_count(measured), 0), (0, 1)):
            for source in (before, None, good_count(measured)):
                inputs[0].source = source
                run(craft, 3 * SECOND_US)
            assert _counts(craft, measured, 1) == [count], before
            assert len(_texts(craft)) == count


def put_in_after_the_start():
    """A thing put in after the start counts and is told; nothing is told before that is untrue."""
    for measured in _returning():
        start, inputs = _inputs(measured)
        craft = start()
        inputs[-1].source = 0
        run(craft, 3 * SECOND_US)
        assert _counts(craft, measured, len(inputs)) == [0] * len(inputs)
        assert _texts(craft) == []
        inputs[-1].source = good_count(measured)
        run(craft, SECOND_US)
        assert _counts(craft, measured, len(inputs))[-1] == 1
        assert [text for _, text in _texts(craft)] == [_title(measured, len(inputs) - 1) + " connected"]


def counting_begins_anew():
    """Back, a sum is 0, what has an initial value has that; all else is unknown once it is gone. Others keep theirs."""
    for measured in _returning():
        restarting = [each for each in measured["returns"]["restarting"] if each[0] not in measured["estimated"]]
        needs(restarting, "something that begins anew")
        start, inputs = _inputs(measured)
        for is_known in (True, False):
            craft = start()
            run(craft, SECOND_US)
            for attribute, anew in restarting:
                if not is_known and isinstance(anew, bool):
                    continue  # a boolean is never unknown
                before = ((not anew) if isinstance(anew, bool) else WORTH) if is_known else None
                after = anew if is_known or anew != 0 else None
                for instance in range(len(inputs)):
                    _set(_owner(craft, measured, instance), attribute, before)
                expected = [before] * len(inputs)
                for source in (0, good_count(measured)):
                    inputs[0].source = source
                    run(craft, SECOND_US)
                    expected[0] = before if source == 0 and anew is not None else after
                    found = [_value(_owner(craft, measured, place), attribute) for place in range(len(inputs))]
                    assert found == expected, (attribute, source, found)


def _set(owner, attribute, value):
    if hasattr(getattr(owner, attribute), "__len__"):
        value = [value] * len(getattr(owner, attribute))
    setattr(owner, attribute, value)


def _value(owner, attribute):
    """Return a value; of a list what all elements are."""
    value = getattr(owner, attribute)
    if not hasattr(value, "__len__"):
        return value
    values = list(value)
    return values[0] if values == [values[0]] * len(values) else values


def its_info_is_sent_at_once():
    """Messages that a change of the count announces go out within a fraction of a second after the reading, once."""
    for measured in _returning():
        watched = (measured["component"], measured["returns"]["count"])
        numbers = [number for number, facts in MESSAGES.items() if facts["watched"] == watched]
        needs(numbers, "a message that is sent when something comes back")
        for choice in range(3 if GENERATIONS and GENERATIONS[0]["attribute"] else 1):
            _info_is_sent(measured, numbers, choice)


def _info_is_sent(measured, numbers, choice):
    """Look at one of the choices of the first generation."""
    start, inputs = _inputs(measured)
    craft = start()
    if GENERATIONS and GENERATIONS[0]["attribute"]:
        setattr(craft.parameters, GENERATIONS[0]["attribute"], choice)
    numbers = [number for number in numbers if is_chosen(craft, number)]
    run(craft, SECOND_US)
    inputs[0].source = 0
    run(craft, SECOND_US)
    craft.port.frames = []
    run(craft, SECOND_US // 2)
    before = [id_of(frame) for frame in craft.port.frames if id_of(frame) in numbers]
    inputs[0].source = good_count(measured)
    craft.port.frames = []
    run(craft, SECOND_US // 2)
    after = [id_of(frame) for frame in craft.port.frames if id_of(frame) in numbers]
    assert (before, sorted(after)) == ([], sorted(numbers)), (before, after)


def one_that_is_gone_allocates_nothing():
    """While it is away the readings go on, and leave the heap alone as ever."""
    needs(IS_MICROPYTHON, "a heap that tells")
    for measured in _returning():
        start, inputs = _inputs(measured)
        craft = start(ports=[Sink()])
        run(craft, 20 * SECOND_US)
        for source in (0, good_count(measured)):
            for wire in inputs:
                wire.source = source
            run(craft, 20 * SECOND_US)
            before = mem_total()
            for _ in range(800):
                craft.run_pass()
                mock_time.advance_us(CONTROL_US)
            assert mem_total() == before, (source, mem_total() - before)


CHECKS = (
    (gone_and_back_counts_once, "quantity.returns"),
    (only_what_is_below_the_limit_is_gone, "quantity.returns"),
    (what_wavers_comes_back_once, "quantity.returns"),
    (a_failed_reading_says_nothing, "quantity.returns"),
    (put_in_after_the_start, "quantity.returns"),
    (counting_begins_anew, "quantity.returns"),
    (its_info_is_sent_at_once, "quantity.returns"),
    (one_that_is_gone_allocates_nothing, "quantity.returns"),
)
LONG = (
    gone_and_back_counts_once,
    only_what_is_below_the_limit_is_gone,
    what_wavers_comes_back_once,
    a_failed_reading_says_nothing,
    counting_begins_anew,
    its_info_is_sent_at_once,
    one_that_is_gone_allocates_nothing,
)

if __name__ == "__main__":
    main(CHECKS)
