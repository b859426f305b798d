# Generated from templates/tests/amounts/amounts_run.py: do not edit.
# Inputs: e3ec062c17ace37e
"""Cases about amounts: what a device shows, what curves, sums and trends give, and what is true beyond a limit.

The true drivers are run here, against models of their devices. As a program it prints one JSON object: what went wrong
in each case, or null. Its argument is the file of the cases.
"""

import json
import sys

import mock_time

mock_time.install()

from array import array  # noqa: E402  the clock has to be in place before the firmware looks at it

from parameters import Parameters  # noqa: E402
from state import SystemState  # noqa: E402

UNKNOWN = -1073741824
START_US = 5000000


class Texts:
    """Keeps what was logged."""

    def __init__(self):
        self.lines = []

    def __call__(self, *words):
        self.lines.append(" ".join(str(word) for word in words))


class Bench:
    """All sensors whose devices there is a model of, connected as the tables say; `kept` is what each scene left."""

    def __init__(self, devices, cases):
        from sources import Sources  # noqa: PLC0415  there may be no sensor

        mock_time.set_ticks_us(START_US)
        self.texts = Texts()
        self.state = SystemState(log=self.texts)
        sources = Sources(self.state, self.texts)
        self.faults = {}
        self.kept = []
        self._sensors = []
        for each in devices:
            device = __import__(each["module"]).Device(each["settings"])
            self._sensors.append((each, device, getattr(sources, each["sensor"]).turn))
        self._turn()  # which sets each of them up
        for scene in range(max([len(each["shows"]) for each in devices])):
            self._show(scene)
            self._turn()
            self.kept.append([value_of(self.state, case) for case in cases])
        for each, device, _ in self._sensors:
            self._note(each, device.check())

    def _turn(self):
        for _, _, turn in self._sensors:
            turn()

    def _show(self, scene):
        for each, device, turn in self._sensors:
            try:
                device.show(each["shows"][min(scene, len(each["shows"]) - 1)], turn)
            except Exception as error:
                self._note(each, f"{type(error).__name__}: {error}")

    def _note(self, each, problem):
        if problem:
            self.faults.setdefault(each["sensor"], problem)


class Standing:
    """A driver that hands over what it is told, in the place of a true one."""

    def __init__(self, count):
        self.values = array("i", [UNKNOWN] * count)

    def begin(self):
        pass

    def waiting(self):
        return 1

    def poll(self, _now_ms):
        return True


def value_of(state, case, attribute=None):
    """Return what the state has of an instance."""
    return getattr(getattr(state, case["component"])[case["instance"]], attribute or case["attribute"])


def parameters_of(case):
    """Return parameters that are set as a case says."""
    parameters = Parameters()
    for name, steps in case["parameters"].items():
        setattr(parameters, name, steps)
    return parameters


def expect(found, expected, *about):
    assert found == expected, f"{found}, not {expected}, {about}"


def arrives(case, bench, place):
    """The state keeps what a sensor's device shows: by its data sheet, to the nearest step, with its sign."""
    sensor = case["sensor"]
    assert sensor not in bench.faults, bench.faults[sensor]
    for scene, expected in enumerate(case["kept"]):
        expect(bench.kept[scene][place], expected, "scene", scene, bench.texts.lines)


def summed(case):
    """Each value counts for the time since the one before, with its sign; a pause that is too long counts for none."""
    from sources import Sources  # noqa: PLC0415  there may be no sensor

    mock_time.set_ticks_us(START_US)
    texts = Texts()
    state = SystemState(parameters_of(case), texts)
    sources = Sources(state, texts)
    pollers = []
    for name, _, _ in case["phases"][0]["hands"]:
        poller = getattr(sources, name)
        if poller not in pollers:
            poller.driver = Standing(len(poller.driver.values))
            mask = case["masks"].get(name)
            if mask is not None:
                poller.driver.values[mask[0]] = mask[1]
            pollers.append(poller)
    for number, phase in enumerate(case["phases"]):
        for name, place, value in phase["hands"]:
            getattr(sources, name).driver.values[place] = value
        for _ in range(phase["turns"]):
            mock_time.advance_us(phase["every_ms"] * 1000)
            for poller in pollers:
                poller.turn()
        tells(state, case, number, texts)
    grows_old(state, case)


def tells(state, case, number, texts):
    """The state tells after a phase what the tables make of it: exactly, but for the mean, which is rounded itself."""
    phase = case["phases"][number]
    for attribute, expected in phase["kept"]:
        expect(value_of(state, case, attribute), expected, attribute, "phase", number, texts.lines)
    for attribute, least, most in phase["about"]:
        found = value_of(state, case, attribute)
        assert least <= (-1 if found is None else found) <= most, f"{attribute} {found}, not {least} to {most}"


def grows_old(state, case):
    """The rest of a store is known as long as a value is believed, and no longer."""
    old = case["old"]
    known = [name for name in old["attributes"] if value_of(state, case, name) is not None]
    mock_time.advance_us(old["after_ms"] * 1000)
    for attribute in known:
        assert value_of(state, case, attribute) is not None, f"{attribute} is unknown too early"
    mock_time.advance_us(1000)
    for attribute in known:
        expect(value_of(state, case, attribute), None, attribute, "too old")


def read_of(case):
    """Return what sets a count at the input of an instance, takes a reading, and returns its state."""
    from mock_board import MockBoard  # noqa: PLC0415  there may be no converter

    mock_time.set_ticks_us(START_US)
    texts, parameters = Texts(), parameters_of(case)
    board = MockBoard(log=texts, parameters=parameters)
    state = SystemState(parameters, log=texts)
    where = (case["instance"],) if case["several"] else ()

    def read(count):
        getattr(board, case["setter"])(count, *where)
        getattr(state, "update_" + case["component"])(board)
        return state

    return read


def curve(case):
    """An estimate is on its curve: at the points, between them, and beyond the ends as it is there."""
    read = read_of(case)
    for count, measured, expected in case["readings"]:
        state = read(count)
        expect(value_of(state, case, case["of"]), measured, case["of"], "count", count)
        expect(value_of(state, case), expected, case["of"], measured)


def trend(case):
    """A trend is what a value changes by in a second, unknown until its window is full; falling is below zero."""
    read = read_of(case)
    for number, (counts, expected) in enumerate(case["told"]):
        for count in counts:
            state = read(count)
        expect(value_of(state, case), expected, "group", number)


def side(case):
    """A boolean that follows a number is true on one side of its limit, or between two; not while that is unknown."""
    state = SystemState(log=Texts())
    for steps, expected in case["sides"]:
        setattr(getattr(state, case["component"])[case["instance"]], case["of"], steps)
        expect(value_of(state, case), expected, case["of"], steps)


def shown(case):
    """The unit of people shows what is kept in steps, as near as a float is."""
    state = SystemState(log=Texts())
    for steps, numerator, denominator in case["shown"]:
        setattr(getattr(state, case["component"])[case["instance"]], case["attribute"], steps)
        found, exact = value_of(state, case, case["view"]), numerator / denominator
        assert abs(found - exact) <= abs(exact) / 1000000, f"{found}, not {exact}, of {steps} steps"


KINDS = {"sum": summed, "curve": curve, "trend": trend, "side": side, "shown": shown}


def outcome(call, *arguments):
    """Return what goes wrong in a call, or None."""
    try:
        call(*arguments)
    except Exception as error:
        if "-v" in sys.argv:
            raise
        return f"{type(error).__name__}: {error}"
    return None


def main(path):
    with open(path, encoding="utf-8") as file:
        told = json.loads(file.read())
    cases = told["cases"]
    arriving = [case for case in cases if case["kind"] == "arrives"]
    found = {}
    if arriving:
        bench = Bench(told["devices"], arriving)
        for place, case in enumerate(arriving):
            found[case["name"]] = outcome(arrives, case, bench, place)
    for case in cases:
        if case["kind"] in KINDS:
            found[case["name"]] = outcome(KINDS[case["kind"]], case)
    print(json.dumps(found))


if __name__ == "__main__":
    main(sys.argv[1])
