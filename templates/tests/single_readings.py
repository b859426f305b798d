"""Checks of single readings: what a count stands for, and that each fails and grows old by itself.

`facts` of a reading are what behaviour.py knows of it. `fresh` makes a board, a state and the log of both.
"""

import machine
import mock_time

try:
    from micropython import heap_lock, heap_unlock, mem_total
except ImportError:  # CPython has no heap to lock

    def heap_lock():
        pass

    def heap_unlock():
        pass

    def mem_total():
        return 0


def value_of(state, facts):
    """Return what is kept of the first instance."""
    return own(state, facts, facts["attribute"])


def update(state, board, facts):
    """Take a reading of everything of the component."""
    getattr(state, "update_" + facts["component"])(board)


def set_count(board, facts, count):
    """Let the input of a reading show a count."""
    getattr(board, "set_" + facts["input"] + "_value")(count)


def fails_alone(facts, fresh):
    """A reading that fails keeps its last value for so many readings; the others of the component go on."""
    board, state, log = fresh(facts["on"])
    for one in [facts] + facts["others"]:
        set_count(board, one, one["counts"][0])
    update(state, board, facts)
    before = value_of(state, facts)
    assert before is not None
    set_count(board, facts, facts["counts"][1])
    others = [value_of(state, one) for one in facts["others"]]
    for one in facts["others"]:
        set_count(board, one, one["counts"][1])
    told = len(log.lines)
    for failures in range(1, (facts["invalid_after"] or 3) + 1):
        assert value_of(state, facts) == before
        getattr(board, "fail_" + facts["input"])(1)
        update(state, board, facts)
        assert failures_of(board, facts) == failures
    assert value_of(state, facts) == (None if facts["invalid_after"] else before)
    assert len(log.lines) == told + 1, log.lines
    assert [value_of(state, one) for one in facts["others"]] != others or not others
    update(state, board, facts)
    assert value_of(state, facts) not in (before, None)
    assert failures_of(board, facts) == 0


def failures_of(board, facts):
    """Return how many readings of the first instance failed in a row."""
    inputs = getattr(board, facts["name"] + "_inputs", None)
    return 0 if inputs is None else inputs.figures()[0]  # without inputs there are no failures


def ages_alone(facts, fresh):
    """A reading that is not taken any longer is unknown after its own time, and not before."""

    def forget(state):
        first_of(state, facts).expire()

    for build in facts["builders"] + [forget]:
        for start_us in (0, (1 << 30) * 1000 - 200000):  # the second is just before ticks_ms() wraps
            mock_time.set_ticks_us(start_us)
            board, state, _ = fresh(facts["on"])
            set_count(board, facts, facts["counts"][0])
            update(state, board, facts)
            mock_time.advance_us(facts["stale_after_ms"] * 1000)
            build(state)
            assert value_of(state, facts) is not None
            mock_time.advance_us(1000)
            build(state)
            assert value_of(state, facts) is None
    mock_time.set_ticks_us(0)


def raises_nothing(facts, fresh):
    """A board that raises, or returns what no board should, fails the reading and nothing else."""
    for result in (None, "12", -1, facts["full_scale"] + 1, OSError(5), ValueError(), MemoryError()):
        board, state, log = fresh(facts["on"])
        for one in [facts] + facts["others"]:
            set_count(board, one, one["counts"][0])
        update(state, board, facts)
        before = value_of(state, facts)

        def read(*_instance, result=result):
            if isinstance(result, Exception):
                raise result
            return result

        good = getattr(board, "read_" + facts["name"] + "_adc")
        setattr(board, "read_" + facts["name"] + "_adc", read)
        update(state, board, facts)
        assert value_of(state, facts) == before
        assert len(log.lines) <= facts["instances"], log.lines
        if isinstance(result, Exception):
            assert log.lines, "an error is told"
        for failures in range(2, (facts["invalid_after"] or 0) + 1):
            assert value_of(state, facts) == before, failures
            update(state, board, facts)
        assert value_of(state, facts) == (None if facts["invalid_after"] else before)
        setattr(board, "read_" + facts["name"] + "_adc", good)
        set_count(board, facts, facts["counts"][1])
        update(state, board, facts)
        assert value_of(state, facts) not in (before, None), result


def is_left_alone_where_it_is_off(facts, fresh):
    """With the other values of its parameter it is unknown, its input is not read, and nothing is complained about."""
    for settings in facts["off"]:
        board, state, log = fresh(settings)
        for one in [facts] + facts["others"]:
            set_count(board, one, one["counts"][0])
        for _ in range(3):
            update(state, board, facts)
        assert value_of(state, facts) is None
        assert failures_of(board, facts) == 0
        assert log.lines == [], log.lines


def is_what_its_instance_has(facts, fresh):
    """Its own parameters say which input each instance has and what a count is there: those of others say other things.

    So each has the same at that input, and what another input shows changes nothing.
    """
    names = [facts["attribute"]] + [rest["attribute"] for rest in facts.get("rests", ())]
    (first, second), expected = facts["counts"], None
    for instance in range(len(facts["apart"])):
        board, state, _ = fresh(facts["apart"][instance])
        one, other = [machine.analog(gpio) for gpio in facts["pins"]]
        found = []
        for one.source, other.source in ((first, second), (second, first), (second, second)):
            update(state, board, facts)
            component = getattr(state, facts["component"])[instance]
            found.append([getattr(component, name) for name in names])
        values = [each[0] for each in found]
        assert None not in values, (instance, found)
        assert values[0] != values[1] == values[2], (instance, found)
        expected = expected or found
        assert found == expected, (instance, found, expected)


def allocates_nothing(facts, fresh):
    """Over all of its counts, with the factors that make the largest numbers; what is told of one takes memory."""
    for settings in facts["extremes"]:
        board, state, _ = fresh(settings)
        other_board, other_state, log = fresh(settings)
        take, take_first = (getattr(each, "update_" + facts["component"]) for each in (state, other_state))
        for count in (0, facts["full_scale"]):  # warnings are logged now, before memory is counted
            set_count(board, facts, count)
            set_count(other_board, facts, count)
            take(board)
            take_first(other_board)
        for count in range(0, facts["full_scale"] + 1, 195):
            set_count(board, facts, count)
            set_count(other_board, facts, count)
            told = len(log.lines) + len(log.notes)
            take_first(other_board)
            if len(log.lines) + len(log.notes) > told:
                take(board)
                continue
            before = mem_total()
            heap_lock()
            try:
                take(board)
            finally:
                heap_unlock()
            assert mem_total() == before, (settings, count)


def lasts_at_the_mean(facts, fresh):
    """The rest lasts at the mean of the readings: the first one, then each one by its share of the way to it."""
    lasting = facts["lasting"]
    readings = lasting["readings"]
    parts = max(1, 128 // (readings + 1))
    board, state, _ = fresh(facts["on"])
    for one in facts["others"]:
        set_count(board, one, one["counts"][0])
    mean = None
    for count in facts["counts"]:
        set_count(board, facts, count)
        for _ in range(readings // 2):
            mock_time.advance_us(1000)  # next to nothing is drawn in so short a time
            update(state, board, facts)
            value = value_of(state, facts)
            mean = parts * readings * value if mean is None else mean
            mean += parts * value - (mean + readings // 2) // readings
            left, told = (own(state, facts, lasting[name]) for name in ("left", "attribute"))
            at = (mean + parts * readings // 2) // (parts * readings)
            expected = None if at <= 0 or left is None else min(left * lasting["factor"] // at, lasting["most"])
            assert told == expected, (told, expected, mean)
    mock_time.set_ticks_us(0)


def is_summed_exactly(facts, fresh):
    """Each reading counts for the time since the one before, and not where that is a gap; a step is told at its half.

    What a sum leaves of a full store goes with it, of stores of several sizes and of none.
    """
    sizes = max(len(rest["sizes"]) for rest in facts["rests"]) if facts["rests"] else 1
    begins_alike(facts, fresh)
    for at in range(sizes):
        settings = dict(facts["on"])
        for rest in facts["rests"]:
            settings[rest["full"]] = rest["sizes"][min(at, len(rest["sizes"]) - 1)]
        board, state, _ = fresh(settings)
        for one in facts["others"]:
            set_count(board, one, one["counts"][0])
            getattr(board, "fail_" + one["input"])(1)  # a product has nothing to begin with
        mock_time.set_ticks_us((1 << 30) * 1000 - 1500000)  # ticks_ms() wraps meanwhile
        totals = {}
        for each in facts["sums"]:
            begun = max(0, each["least"]) if at else None
            setattr(first_of(state, facts), each["attribute"], begun)
            totals[each["attribute"]] = begun if begun is None else begun * each["parts"] + each["parts"] // 2
        gap = facts["stale_after_ms"]
        summed_over(facts, board, state, settings, totals, [0])
        summed_over(facts, board, state, settings, totals, [gap, gap + 1, gap, 1, 3, gap // 2, gap + 1, gap - 1])
        for each in facts["sums"]:
            near = 1 if each["times"] is None else each["parts"] // 100000
            for part in (each["parts"] - near, 0):  # just short of a step, then exactly at one
                fill(facts, board, state, settings, totals, each, part, near)
    mock_time.set_ticks_us(0)


def begins_alike(facts, fresh):
    """Hold a sum that the first reading begins against one that is 0 before: to their last part they are alike."""
    found = []
    for begun in (None, 0):
        mock_time.set_ticks_us(0)
        board, state, _ = fresh(facts["on"])
        for each in facts["sums"]:
            setattr(first_of(state, facts), each["attribute"], begun)
        for one in [facts] + facts["others"]:
            set_count(board, one, one["counts"][0])
        for _ in range(3):
            update(state, board, facts)
            mock_time.advance_us(1000)
        found.append(list(state.words))
    assert found[0] == found[1] or max(each["least"] for each in facts["sums"]) > 0, found


def summed_over(facts, board, state, settings, totals, times_ms):
    """Take a reading after each of these times, of both counts in turn, and hold the sums against `totals`."""
    for turn, took_ms in enumerate(times_ms):
        mock_time.advance_us(took_ms * 1000)
        set_count(board, facts, facts["counts"][turn % 2])
        before = [each["times"] and own(state, facts, each["times"]) for each in facts["sums"]]
        update(state, board, facts)
        counted = value_of(state, facts) * took_ms if took_ms <= facts["stale_after_ms"] else 0
        for each, times in zip(facts["sums"], before):  # noqa: B905  MicroPython's takes nothing else
            check_sum(state, facts, each, counted, times, totals)
        for rest in facts["rests"]:
            check_rest(state, facts, rest, settings[rest["full"]] * rest["steps"])


def fill(facts, board, state, settings, totals, each, part, near):
    """Let a sum come to so many parts of a step, or less than `near` more, where times of both counts make it so."""
    gap, amounts = facts["stale_after_ms"], []
    for count in facts["counts"]:
        set_count(board, facts, count)
        update(state, board, facts)
        amounts.append(value_of(state, facts) * (1 if each["times"] is None else own(state, facts, each["times"])))
    for _ in range(40):
        for first in range(1, gap + 1):
            missing = (part - totals[each["attribute"]] - amounts[0] * first) % each["parts"]
            second = -(-missing // (amounts[1] or 1))
            if 0 <= second * amounts[1] - missing < near and 0 < second <= gap:
                summed_over(facts, board, state, settings, totals, [first, second])
                assert 0 <= totals[each["attribute"]] % each["parts"] - part < near
                return
        summed_over(facts, board, state, settings, totals, [gap])


def check_sum(state, facts, each, counted, times, totals):
    """Hold a sum against exact arithmetic: from its half a step on is told. ``times`` is what it is multiplied by."""
    name, parts = each["attribute"], each["parts"]
    if each["times"] is None:
        times = 1
    elif each["is_after"]:
        times = own(state, facts, each["times"])
    if times is not None:
        total = (parts // 2 if totals[name] is None else totals[name]) + counted * times
        steps = min(max(total // parts, each["least"]), each["most"])
        totals[name] = steps * parts + total % parts
    told = own(state, facts, name)
    assert told == (None if totals[name] is None else totals[name] // parts), (name, told, totals[name])


def check_rest(state, facts, rest, size):
    """Hold what is left against what the sum says."""
    left = min(max(size - own(state, facts, rest["after"]), 0), size)
    if rest["share"] is not None and size:
        left = (left * rest["share"] + size // 2) // size
    told = own(state, facts, rest["attribute"])
    assert told == (min(left, rest["most"]) if size else None), (rest["attribute"], told, size)


def first_of(state, facts):
    """Return the first instance of the component."""
    component = getattr(state, facts["component"])
    return component[0] if facts["several"] else component


def own(state, facts, attribute):
    """Return an attribute of the first instance."""
    return getattr(first_of(state, facts), attribute)
