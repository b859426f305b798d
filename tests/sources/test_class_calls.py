"""The class of a sensor is compared with what the firmware calls of it, and the keys of a driver with themselves."""

import shutil
from pathlib import Path
from typing import Any

import pytest

from codegen.cli import main

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "minimal"
LASER = "laser: {driver: laser, i2c: 0, sda: 4, scl: 5}"
SONAR = "sonar: {driver: user, class: sonar.Sonar, unit: m, stored: mm, min: 0, max: 100}"
DRIVER = """\
doc: A laser.
class: Laser
bus: i2c
keys:
  address: {doc: a, min: 0x10, max: 0x1f, default: 0x12}
  gain: {doc: g, default: 1}
outputs: {distance: {unit: m, stored: mm, min: 0, max: 100}}
"""
KEYS = DRIVER[DRIVER.index("  address") : DRIVER.index("outputs")]
CLASS = """\
from array import array


class Laser:
    def __init__(self, opened, address, gain):
        self.values = array("i", [0])

    def begin(self):
        pass

    def poll(self, now_ms):
        return True
"""
MADE = "def __init__(self, opened, address, gain):"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = Path(shutil.copytree(PROJECT, tmp_path / "project"))
    (folder / "specs" / "drivers").mkdir()
    (folder / "specs" / "drivers" / "laser.yaml").write_text(DRIVER)
    (folder / "specs" / "drivers" / "laser.py").write_text(CLASS)
    monkeypatch.chdir(folder)
    return folder


def errors(folder: Path, source: str, capsys: Any) -> list[tuple[str, str]]:
    """Return the errors of a project with a sensor, each with its hint; sensors have no other."""
    (folder / "specs" / "board.yaml").write_text(f"board: pico_2\nsources:\n  {source}\n")
    code = main(["check"])
    lines = capsys.readouterr().out.splitlines()
    found = [
        (line, after.strip().removeprefix("hint: "))
        for line, after in zip(lines, [*lines[1:], ""], strict=True)
        if ": error " in line
    ]
    assert code == bool(found)
    return found


FITTING = [
    CLASS,
    CLASS.replace("opened, address, gain", "opener, *, gain, address=3"),
    CLASS.replace("opened, address, gain", "*wires, **keys"),
    CLASS.replace("self, now_ms", "self, _now, often=1"),
    CLASS.replace("    def begin(self)", "    @micropython.native\n    def begin(self)"),
    CLASS.replace("    def begin(self)", "    @decorated\n    def begin()"),
    CLASS.replace("class Laser:", "from maker import Base\n\n\nclass Laser(Base):").replace("def poll", "def pol"),
    CLASS.replace("class Laser:", "class Base:").replace("    def poll", "\nclass Laser(Base):\n    def poll"),
    CLASS.replace("    def poll(self, now_ms):\n        return True\n", "    poll = begin\n"),
    CLASS.replace("def poll", "def __getattr__(self, name): pass\n\n    def pol"),
    CLASS.replace("def poll", "def pol") + "\n\nLaser.poll = Laser.pol\n",
    CLASS.replace("class Laser:", "class Laser:\n    values = None\n").replace("self.values", "self.kept"),
    CLASS.replace("def poll", "def pol") + "\n\nclass Laser(Laser):\n    pass\n",
    CLASS.replace("[0]", "[0] * COUNT"),
    CLASS.replace("[0])", "[])\n        self.values.append(0)"),
    CLASS.replace("[0])", "[])\n        self.values = array('i', [0])"),
]


@pytest.mark.parametrize("text", FITTING, ids=range(len(FITTING)))
def test_a_class_that_fits_or_whose_source_does_not_show_all(folder: Path, text: str, capsys: Any) -> None:
    (folder / "specs" / "drivers" / "laser.py").write_text(text)
    assert errors(folder, LASER, capsys) == []


UNFIT = [
    ("address, gain", "address", "cannot be made with opened, address, gain: __init__ does not take gain", MADE),
    ("gain)", "gain, speed)", "cannot be made with opened, address, gain: __init__ wants speed, which it is not", MADE),
    ("opened, address", "address", "cannot be made with opened, address, gain: __init__ is given address twice", MADE),
    (
        "opened, address, gain",
        "*, opened, address, gain",
        "cannot be made with opened, address, gain: __init__ takes no argument, and is given 1",
        MADE,
    ),
    ("def poll", "def pol", "has no poll(), which is called", "did you mean pol? def poll(self, now_ms):"),
    ("def begin", "def start", "has no begin(), which is called", "def begin(self):"),
    ("self, now_ms", "self", "cannot be asked: poll takes no argument, and is given 1", "def poll(self, now_ms):"),
    ("begin(self)", "begin(self, bus)", "cannot be asked: begin wants bus, which it is not given", "def begin(self):"),
    (
        "self.values",
        "self.valeus",
        "has no values, which is read",
        'in __init__: self.values = array("i", [UNKNOWN] * 1)',
    ),
    (
        "[0]",
        "[0] * 2",
        "makes values with 2, and 1 are read",
        'in __init__: self.values = array("i", [UNKNOWN] * 1)',
    ),
]


@pytest.mark.parametrize(("old", "new", "message", "hint"), UNFIT, ids=range(len(UNFIT)))
def test_a_class_that_the_firmware_cannot_use(
    folder: Path, old: str, new: str, message: str, hint: str, capsys: Any
) -> None:
    """At the class in the driver's YAML, with the line to write."""
    (folder / "specs" / "drivers" / "laser.py").write_text(CLASS.replace(old, new))
    ((line, told),) = errors(folder, LASER, capsys)
    assert line.startswith(f"specs/drivers/laser.yaml:2:8: error unfit-driver-class: Laser of laser.py {message}")
    assert told == hint


def test_an_output_of_32_bits_takes_two_values(folder: Path, capsys: Any) -> None:
    """A driver with one value for each output would have each number behind such a one be another's."""
    drivers = folder / "specs" / "drivers"
    lines = "lat: {unit: deg, stored: degE7, min: -90, max: 90}, lon: {unit: deg, stored: degE7, min: -180, max: 180}"
    (drivers / "laser.yaml").write_text(DRIVER.replace("outputs: {", f"outputs: {{{lines}, "))
    (drivers / "laser.py").write_text(CLASS.replace("[0]", "(0, 0, 0)"))
    ((line, hint),) = errors(folder, LASER, capsys)
    assert line.endswith("Laser of laser.py makes values with 3, and 4 are read")
    assert hint == 'in __init__: self.values = array("i", [UNKNOWN] * 4), two each of lon, whose limits need 32 bits'
    (drivers / "laser.py").write_text(CLASS.replace("[0]", "(0, 0, 0, 0)"))
    assert errors(folder, LASER, capsys) == []


USERS = [
    ("class Sonar:\n    def read(self): pass\n", ""),
    ("class Sonar:\n    def __init__(self, pin=3): pass\n    def read(self): pass\n", ""),
    ("class Sonar:\n    def __init__(self): self.read = print\n", ""),
    ("class Sonar:\n    def raed(self): pass\n", "has no read(), which is called"),
    ("class Sonar:\n    def read(self, now): pass\n", "cannot be asked: read wants now, which it is not given"),
    (
        "class Sonar:\n    def __init__(self, pin): pass\n    def read(self): pass\n",
        "cannot be made with nothing: __init__ wants pin, which it is not given",
    ),
]


@pytest.mark.parametrize(("text", "message"), USERS, ids=range(len(USERS)))
def test_a_class_of_the_user(folder: Path, text: str, message: str, capsys: Any) -> None:
    """It is made without arguments, and its read() is called."""
    (folder / "sonar.py").write_text(text)
    found = [line for line, _ in errors(folder, SONAR, capsys)]
    where = "specs/board.yaml:3:32: error unfit-driver-class: Sonar of sonar.py "
    assert found == ([where + message] if message else [])


def test_a_class_of_the_module_of_a_driver(folder: Path, capsys: Any) -> None:
    """That module goes to the board with the firmware, so it is the one that has to have the class."""
    source = f"{LASER}\n  {SONAR.replace('sonar.Sonar', 'laser.Sonar')}"
    ((line, _),) = errors(folder, source, capsys)
    assert line == "specs/board.yaml:4:32: error no-driver-class: laser.py has no class Sonar"


@pytest.mark.parametrize("name", ["machine.ADC", "machine.Pin"])
def test_a_class_of_the_hardware_is_none_of_the_user(folder: Path, name: str, capsys: Any) -> None:
    ((line, _),) = errors(folder, SONAR.replace("sonar.Sonar", name), capsys)
    message = f"{name} is hardware, which is not made without arguments, or has no read()"
    assert line == f"specs/board.yaml:3:32: error bad-source-driver: {message}"


WRONG_KEYS = [
    ("class: {doc: a, default: 1}", "5:3", "class cannot be the name of a key: Laser is given it as an argument"),
    ("a-b: {doc: a, default: 1}", "5:3", "a-b cannot be the name of a key: Laser is given it as an argument"),
    ("self: {doc: a, default: 1}", "5:3", "self cannot be the name of a key: Laser is given it as an argument"),
    ("rate: {doc: a, default: 1}", "5:3", "rate cannot be the name of a key: every sensor has one of this name"),
    ("driver: {doc: a, default: 1}", "5:3", "driver cannot be the name of a key: every sensor has one of this name"),
    ("opened: {doc: a, default: 1}", "5:3", "opened cannot be the name of a key: so the function is called"),
    ("a: {doc: a, default: abc}", "5:24", "the default of a is abc, no whole"),
    ("a: {doc: a, default: 30 s}", "5:24", "the default of a is 30 s, no whole"),
    ("a: {doc: a, default: 30.5}", "5:24", "the default of a is 30.5, no whole"),
    ("a: {doc: a, max: 31, default: 300}", "5:33", "the default of a is 300, not ... to 31"),
    ("a: {doc: a, min: 0x1f, max: 0x1e}", "5:31", "max of a is 30, less than min, 31"),
    ("a: {doc: a, min: 0.5, default: 1}", "5:20", "min of a is 0.5, and it takes whole numbers"),
    ("a: {doc: a, kind: text, max: 5, default: x}", "5:32", "a is a text, which has no max"),
    ("a: {doc: a, kind: boolean, default: 1}", "5:39", "the default of a is 1, no boolean"),
    ("a: {doc: a, kind: number, min: 0.5, default: 0.25}", "5:48", "the default of a is 0.25, not 0.5 to ..."),
]


@pytest.mark.parametrize(("key", "place", "message"), WRONG_KEYS, ids=range(len(WRONG_KEYS)))
@pytest.mark.parametrize("is_given", [False, True])
def test_what_a_driver_declares_is_told_where_it_stands(
    folder: Path, key: str, place: str, message: str, is_given: bool, capsys: Any
) -> None:
    """Once, in the file of the driver, whether a sensor leaves the key out or says it."""
    drivers = folder / "specs" / "drivers"
    (drivers / "laser.yaml").write_text(DRIVER.replace(KEYS, f"  {key}\n"))
    (drivers / "laser.py").write_text(CLASS.replace("opened, address, gain", "opened, **keys"))
    source = LASER
    if is_given and key.startswith("a: "):
        source = LASER.replace("i2c: 0", "a: 1, i2c: 0")
    ((line, hint),) = errors(folder, source, capsys)
    assert line.startswith(f"specs/drivers/laser.yaml:{place}: error bad-source-driver: {message}"), line
    assert hint
