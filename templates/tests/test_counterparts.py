"""Machine code and its counterpart in plain Python leave the same, whatever happens: MicroPython and CPython agree."""

import re

import pytest
from interpreters import LARGE_HEAP, files, path_of, told_by

INTERPRETERS = ("cpython", "micropython")
PARTS = ("steps", "ages", "zeros", "short", "lengths", "due", "watched", "frames", "times")
LONG = ("more steps", "limits")
COMPARED = re.compile(r"[<>=]=? (-?\d+)\b")  # with what a number is compared


@pytest.fixture(scope="session")
def told(once):
    """Return a call for what each interpreter tells of some parts, in one run of it."""

    def by(parts):
        def run():
            given = (*map(str, numbers()), "of", *parts)
            return [told_by(each, "counterparts_run.py", *given, heap=LARGE_HEAP) for each in INTERPRETERS]

        return once(f"counterparts-{parts[0].replace(' ', '-')}", run)

    return by


def numbers():
    """Return the numbers that the code compares with what it has at hand, and those beside them.

    In other units than those that are kept a step is ten of these, or a hundred.
    """
    texts = [path.read_text("utf-8") for path in files("firmware/*_plain.py")]
    found = {int(number) for text in texts for number in COMPARED.findall(text)} | {-100, -10, 10, 100}
    return sorted({number + beside for number in found for beside in (-1, 0, 1)})


def same(found, part):
    """Hold both interpreters to the same end of all that is drawn by lot; steps are counted from 0."""
    assert "" not in found, found[""]
    plain, machine = (each[part] for each in found)
    assert len(plain) == len(machine)
    assert plain or part == "times", "no reading is taken"
    assert [step for step, each in enumerate(plain) if each != machine[step]] == []


@pytest.mark.parametrize("part", PARTS)
def test_counterparts(part, told):
    """The state, frames that are sent and those that arrive are the same in machine code as in plain Python."""
    same(told(PARTS), part)


@pytest.mark.days
@pytest.mark.parametrize("part", LONG)
def test_more_steps(part, told):
    """So they are in many more steps, and for each number that anything is compared with."""
    same(told(LONG), part)


def test_machine_code():
    """An interpreter with machine code compiles all of it: else the firmware would be in plain Python, and slow."""
    modules = [path.stem for path in files("firmware/*_viper.py")]
    assert not told_by("micropython", "machine_code_run.py", *modules)


def test_places():
    """A module that names a place of the state has the number that the state has for it.

    It is that within the component, or where the words of all are at hand that within these.
    """
    place = re.compile(r"^(_[A-Z]\w*) = const\((\d+)\)", re.MULTILINE)
    places = {name: int(number) for name, number in place.findall(path_of("firmware", "state.py").read_text("utf-8"))}
    begins = {name + "_": places[name] for name in places if name + "_SIZE" in places}
    wrong = []
    for path in files("firmware/*.py"):
        for name, number in place.findall(path.read_text("utf-8")):
            allowed = [
                begin + places[name] for prefix, begin in begins.items() if name in places and name.startswith(prefix)
            ]
            if allowed and int(number) not in (places[name], *allowed):
                wrong.append((path.name, name, number))
    assert wrong == []


def test_parts():
    """Each word of the state belongs to one component, and none of its names stands for the place of another."""
    text = path_of("firmware", "state.py").read_text("utf-8")
    constants = [(name, int(at)) for name, at in re.findall(r"^(_[A-Z]\w*) = const\((\d+)\)", text, re.MULTILINE)]
    places = dict(constants)
    assert len(places) == len(constants), "a name stands for two places"
    parts = re.findall(r"together\(\w+, self\.words, (\w+), (\w+), (\d+), log\)", text)
    sizes = {size for _, size, _ in parts}
    named, begin = {each: [] for each, _, _ in parts}, None
    for name, at in constants:  # the words of each stand below where it begins
        if name in named:
            begin = name
        elif begin is not None and name not in sizes:
            named[begin].append(at)
    end = 0
    for begin, size, instances in parts:
        assert places[begin] == end, begin
        end += places[size] * int(instances)
        assert sorted(set(named[begin])) == sorted(named[begin]), begin
        assert all(place < places[size] for place in named[begin]), size
    assert end == places["_SIZE"] > 0
