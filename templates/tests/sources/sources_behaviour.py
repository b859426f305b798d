"""Checks of how sensors are polled, whatever is behind them: drivers of these checks stand in for the true ones.

As a program it prints one JSON object: what went wrong in each check, or null.
"""

import sys

import mock_time

mock_time.install()

from array import array  # noqa: E402  the clock has to be in place before the firmware looks at it

from polling import UNKNOWN, Fault  # noqa: E402
from source_facts import EVERY_US, MOST, SOURCES  # noqa: E402
from sources import Sources  # noqa: E402
from state import SystemState  # noqa: E402
from telling import tell  # noqa: E402

import sources  # noqa: E402

try:
    from micropython import mem_total  # bytes that were ever allocated
except ImportError:  # CPython, and boards

    def mem_total():
        return 0


SECOND_US = 1000000
TURN_MS_US = (1 << 30) * 1000  # ticks_ms() starts again


class Driver:
    """A sensor that does what it is told: `error` is raised, `took_us` is how long a turn takes."""

    def __init__(self, count):
        self.values = array("i", [UNKNOWN] * count)
        self.error = None
        self.absent = None
        self.took_us = 0
        self.is_new = True
        self.begun = 0
        self.polls = 0

    def begin(self):
        self.begun += 1
        if self.absent is not None:
            raise self.absent

    def waiting(self):
        return 1 if self.is_new or self.error is not None else 0

    def poll(self, _now_ms):
        self.polls += 1
        mock_time.advance_us(self.took_us)
        if self.error is not None:
            raise self.error
        return self.is_new


class Bench:
    """One sensor with its state; `texts` is what it told."""

    def __init__(self, facts, at_us=5 * SECOND_US):
        mock_time.set_ticks_us(at_us)
        self.texts = []
        self.facts = facts
        self.state = SystemState(log=silent)
        self.sources = Sources(self.state, self._log)
        self.poller = getattr(self.sources, facts["name"])
        self.driver = self.poller.driver = Driver(facts["values"])
        self.calls = [self.poller.turn]
        if facts["listens"]:
            self.poller.listen(self.calls, 0)
        if facts["mask"] is not None:
            self.driver.values[facts["mask"]] = facts["new"]

    def _log(self, *words):
        self.texts.append(" ".join(str(word) for word in words))

    def give(self, quantity, handed):
        """Let the sensor hand over a number for a quantity."""
        for at in range(max(1, quantity["halves"])):
            value = handed
            if handed is None:
                value = UNKNOWN
            elif quantity["halves"]:
                value = (handed >> 16 * at) & 0xFFFF
            self.driver.values[quantity["place"] + at] = value

    def give_all(self):
        """Let it hand over a plausible number for each quantity."""
        for quantity in self.facts["quantities"]:
            self.give(quantity, quantity["plain"])

    def kept(self, quantity):
        """Return what the state has."""
        return getattr(getattr(self.state, quantity["component"])[quantity["instance"]], quantity["attribute"])

    def turn(self, ms=0):
        """Let so much time pass, and then a turn, as asking() does."""
        mock_time.advance_us(ms * 1000)
        if self.calls[0]():
            self.poller.turn()


class Written:
    """A name of Python as a text; a call of it is the text of that call, with what functions in it return."""

    def __init__(self, text):
        self.text = text

    def __getattr__(self, name):
        return Written(self.text + "." + name)

    def __call__(self, *given, **named):
        parts = [_text(each) for each in given] + [name + "=" + _text(named[name]) for name in sorted(named)]
        return Written(self.text + "(" + ", ".join(parts) + ")")


def _text(value):
    if callable(value) and not isinstance(value, Written):
        value = value()
    return value.text if isinstance(value, Written) else repr(value)


def _stated(value):
    """Return what a fact states of a call: itself, unless it is a name, or a call, as Written has these."""
    if not isinstance(value, dict):
        return value
    if "name" in value:
        return Written(value["name"])
    named = {name: _stated(each) for name, each in value["named"].items()}
    return Written(value["call"])(*[_stated(each) for each in value["given"]], **named)


def _made():
    """Return the sensors with stand-ins for their drivers, which know the text of what made them as `made`."""

    def maker(name):
        def make(*given, **named):
            driver = Driver(max([facts["values"] for facts in SOURCES if facts["made"]["call"] == name]))
            driver.made = Written(name)(*given, **named).text
            return driver

        return make

    names = {facts["made"]["call"] for facts in SOURCES} | {"machine"}
    before = [(name, getattr(sources, name, None)) for name in names]
    for name in names:
        setattr(sources, name, Written(name) if name == "machine" else maker(name))
    try:
        return Sources(SystemState(log=silent), silent)
    finally:
        for name, own in before:
            setattr(sources, name, own)


def opened_and_asked(facts):
    """Its driver is made with what the specification says, and asked at its rate, beside all others."""
    start_us = 5 * SECOND_US
    mock_time.set_ticks_us(start_us)
    made = _made()
    driver = getattr(made, facts["name"]).driver
    assert driver.made == _stated(facts["made"]).text, driver.made
    times = []
    driver.poll = lambda _now_ms: times.append(mock_time.elapsed_us()) or True
    period_us = facts["period_us"]
    step_us = max(EVERY_US, period_us // 500)
    looks = -(-step_us // EVERY_US) if MOST == 1 else 1
    for _ in range(20 * period_us // step_us + 1):
        for _ in range(min(looks, len(SOURCES))):
            made.turn()
        mock_time.advance_us(step_us)
    waits_us = step_us * len(SOURCES)  # for others that are due, too
    for turn, at_us in enumerate(times):
        late_us = at_us - start_us - turn * period_us
        assert 0 <= late_us <= period_us + waits_us, (turn, late_us)
        assert abs(at_us - times[0] - turn * period_us) <= waits_us, (turn, at_us, times[0])
    assert 20 <= len(times) <= 21, len(times)


def silent(*_words):
    """Log nothing."""


def _as_written(quantity, stored):
    """Return a number as it is stored: the initial one in place of an unknown one."""
    return quantity["initial"] if stored is None else stored


def ends(facts):
    """Each number is kept in the steps of its quantity, to the nearest; what cannot be is unknown, and nothing else."""
    bench = Bench(facts)
    bench.give_all()
    bench.turn()
    for quantity in facts["quantities"]:
        for handed, stored in quantity["pairs"]:
            bench.give(quantity, handed)
            bench.turn()
            found = bench.kept(quantity)
            assert found == _as_written(quantity, stored), (quantity["path"], handed, found, stored)
    assert bench.texts == [], bench.texts


def what_code_gives(facts):
    """Numbers that read() gives in units become steps; None, NaN and what is beyond the limits are unknown at once."""
    if not facts["given"]:
        return
    driver = getattr(Sources(SystemState(log=silent), silent), facts["name"]).driver
    count = len(facts["given"])
    middle = [(low + high) // 2 for low, high, _, _ in facts["given"]]
    known = [steps * each[3] / each[2] for steps, each in zip(middle, facts["given"])]  # noqa: B905  as below

    def know():
        driver._read = lambda: known[0] if count == 1 else tuple(known)
        assert driver.poll(0)
        assert _numbers(driver.values, facts["given"]) == middle, list(driver.values)

    for at, (low, high, numerator, denominator) in enumerate(facts["given"]):
        for steps in (low - 1, low, (low + high) // 2, high, high + 1, None):
            expected = steps if steps is not None and low <= steps <= high else UNKNOWN
            for number in (float("nan"), None) if steps is None else (steps * denominator / numerator,):
                know()
                driver._read = lambda at=at, number=number: _row(count, at, number)
                assert driver.poll(0)
                found = _numbers(driver.values, facts["given"])
                assert found == [expected if place == at else UNKNOWN for place in range(count)], (at, number, found)
    if count > 1:
        know()
        driver._read = lambda: None
        assert driver.poll(0)
        assert list(driver.values) == [UNKNOWN] * len(driver.values)
        for wrong in (count - 1, count + 1):
            driver._read = lambda wrong=wrong: (0,) * wrong
            try:
                driver.poll(0)
            except Fault:
                continue
            raise AssertionError(wrong)


def _numbers(values, given):
    """Return what stands in the values of a driver: what needs more than 31 bits has two of them."""
    left, found = list(values), []
    for low, high, _, _ in given:
        number = left.pop(0)
        if not -(1 << 30) < low <= high < 1 << 30:
            above = left.pop(0)
            number = number if number == UNKNOWN else number | above << 16
            number -= (number >> 31 << 32) if low < 0 and number != UNKNOWN else 0
        found.append(number)
    assert not left, left
    return found


def _row(count, at, number):
    return number if count == 1 else tuple([number if place == at else None for place in range(count)])


def failures(facts):
    """A failure keeps the last value, so many in a row make it unknown; the first is told at once, its return, too."""
    bench = Bench(facts)
    bench.give_all()
    bench.turn()
    first = [bench.kept(quantity) for quantity in facts["quantities"]]
    bench.driver.error = Fault("the cause")
    most = max([quantity["invalid_after"] or 0 for quantity in facts["quantities"]] + [3])
    for count in range(1, most + 2):
        bench.turn()
        assert bench.poller.failures == count, (bench.poller.failures, count)
        for quantity, value in zip(facts["quantities"], first):  # noqa: B905  MicroPython's has no strict
            is_lost = quantity["invalid_after"] is not None and count >= quantity["invalid_after"]
            assert bench.kept(quantity) == (quantity["initial"] if is_lost else value), (quantity["path"], count)
    assert bench.texts == ["error: " + facts["name"] + ": the cause"], bench.texts
    bench.driver.error = None
    bench.turn(facts["retry_ms"])
    assert [bench.kept(quantity) for quantity in facts["quantities"]] == first
    assert bench.poller.failures == 0
    assert bench.texts[1:] == ["notice: " + facts["name"] + " works again"], bench.texts


def set_up_again(facts):
    """Three failures in a row, and it is set up again each time that is due, until it works."""
    bench = Bench(facts)
    bench.turn()
    assert bench.driver.begun == 1
    bench.driver.error = OSError(5)
    for _ in range(3):
        bench.turn()
    assert bench.poller.is_down
    bench.driver.absent = OSError(19)
    for attempt in range(2, 5):
        bench.turn(facts["retry_ms"] - 1)
        assert bench.driver.begun == attempt - 1, bench.driver.begun
        bench.turn(1)
        assert bench.driver.begun == attempt, bench.driver.begun
    bench.driver.absent = bench.driver.error = None
    bench.turn(facts["retry_ms"])
    assert not bench.poller.is_down
    assert bench.poller.failures == 0


def absent_at_the_start(facts):
    """One that is not there at the start is told once, and used as soon as it is there."""
    bench = Bench(facts)
    bench.driver.absent = OSError(19)
    bench.give_all()
    for _ in range(4):
        bench.turn(facts["retry_ms"] // 4)
    assert len(bench.texts) == 1, bench.texts
    assert bench.texts[0].startswith("error: " + facts["name"] + ": "), bench.texts
    assert facts["cause"] in bench.texts[0], bench.texts
    bench.driver.absent = None
    bench.turn(facts["retry_ms"])
    for quantity in facts["quantities"]:
        assert bench.kept(quantity) is not None, quantity["path"]


def few_texts(facts):
    """A minute in which every second turn fails has seven texts about failures, and counts them."""
    bench = Bench(facts)
    bench.give_all()
    turns = 0
    for _ in range(601):
        bench.driver.error = None if bench.driver.error else Fault("now and then")
        turns += bench.driver.error is not None
        bench.turn(100)
    told = [text for text in bench.texts if text.startswith("error: ")]
    assert 6 <= len(told) <= 7, bench.texts
    assert len(bench.texts) <= 2 * len(told), bench.texts
    counted = sum(int(text.split("(")[1].split(" ")[0]) if "(" in text else 1 for text in told)
    assert 0 <= turns - counted <= 60, (turns, counted)


def takes_too_long(facts):
    """A turn above the limit is counted and told, and its value counts; mean and longest turn are kept."""
    bench = Bench(facts)
    limit = facts["limit_us"] or 1000
    bench.give_all()
    bench.driver.took_us = limit
    for _ in range(4):
        bench.turn()
    assert (bench.poller.overruns, bench.poller.longest_us, bench.poller.mean_us) == (0, limit, limit)
    assert bench.texts == []
    bench.driver.took_us = limit * 3
    bench.turn()
    assert (bench.poller.longest_us, bench.poller.mean_us) == (3 * limit, 7 * limit // 5)
    for quantity in facts["quantities"]:
        assert bench.kept(quantity) is not None, quantity["path"]
    if facts["limit_us"] is not None:
        bench.turn()
        text = "warning: " + facts["name"] + " took too long, in us: " + str(3 * limit)
        assert (bench.poller.overruns, bench.texts) == (2, [text]), bench.texts
    bench = Bench(facts)
    bench.driver.took_us = 1 << 27
    for _ in range(9):  # more than a small number holds, all together
        bench.turn()
        assert 1 << 26 < bench.poller.mean_us <= bench.poller.longest_us == 1 << 27, bench.poller.mean_us


def grows_old(facts):
    """A value is unknown once it is too old, and not before; also where the ticks start again."""
    for start_us in (5 * SECOND_US, TURN_MS_US - 1000000):
        for quantity in facts["quantities"]:
            stale_ms = quantity["stale_after_ms"]
            if stale_ms is None:
                continue
            bench = Bench(facts, start_us)
            bench.give_all()
            bench.turn()
            value = bench.kept(quantity)
            mock_time.advance_us(stale_ms * 1000)
            assert bench.kept(quantity) == value is not None, quantity["path"]
            mock_time.advance_us(1000)
            assert bench.kept(quantity) is None, quantity["path"]


def silence(facts):
    """One that speaks by itself and does not is told once a second, within the limits of texts, and comes back."""
    if not facts["listens"]:
        return
    bench = Bench(facts)
    bench.give_all()
    bench.turn()
    bench.driver.is_new = False
    bench.turn()
    assert bench.driver.polls == 1  # nothing waits
    for _ in range(30):
        bench.turn(1000)
        bench.sources.watch()
    told = [text for text in bench.texts if "nothing arrives" in text]
    assert 2 <= len(told) <= 3, bench.texts
    assert bench.poller.failures > 3
    assert bench.driver.begun > 2
    bench.driver.is_new = True
    bench.turn(facts["retry_ms"])
    assert bench.poller.failures == 0
    assert bench.texts[-1] == "notice: " + facts["name"] + " works again", bench.texts


def strange_errors(facts):
    """Whatever a driver raises, its turn does not, and the text says what."""
    for error, words in (
        (MemoryError(), "memory is full"),
        (ValueError("no number"), "ValueError: no number"),
        (KeyError(), "KeyError"),
        (OSError(5), facts["cause"] or "OSError"),
    ):
        bench = Bench(facts)
        bench.turn()
        bench.driver.error = error
        bench.turn()
        assert len(bench.texts) == 1, bench.texts
        assert words in bench.texts[0], bench.texts


def allocates_nothing(facts):
    """Turns that bring something new, and those that do not, leave the heap alone."""
    bench = Bench(facts)
    bench.give_all()
    used = 0
    for is_new in (True, False, True, False):
        bench.driver.is_new = is_new
        bench.turn()
        before = mem_total()
        for _ in range(20):
            bench.turn()
        used = mem_total() - before
        assert used == 0, (is_new, used)


CHECKS = (
    ("rate", opened_and_asked),
    ("range", ends),
    ("range", what_code_gives),
    ("failure", failures),
    ("recovery", set_up_again),
    ("recovery", absent_at_the_start),
    ("texts", few_texts),
    ("limit", takes_too_long),
    ("failure", grows_old),
    ("failure", silence),
    ("texts", strange_errors),
    ("rate", allocates_nothing),
)


def outcome(check, facts):
    """Return None for a check that passes, else what went wrong."""
    try:
        check(facts)
    except Exception as error:
        if "-v" in sys.argv:
            raise
        return f"{type(error).__name__}: {error}"
    return None


def main():
    tell((facts["name"] + "-" + check.__name__, outcome(check, facts)) for facts in SOURCES for _, check in CHECKS)


if __name__ == "__main__":
    main()
