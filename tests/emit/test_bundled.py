"""Modules that are always loaded together are compiled into one, and nobody sees a difference."""

import ast
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.emit.bundled import bundled
from codegen.emit.global_names import GlobalNames
from codegen.emit.mpy import BYTECODE, STARTED, compiled
from codegen.emit.short_names import TABLE, read_table

MICROPYTHON = Path(sys.executable).parent / "micropython"
LOW = '''\
"""The lowest module."""

import struct
from struct import pack

LIMIT = 5
WIDE = -7
_ROWS = ((1, 2), (3, LIMIT))
count = 0


class Base:
    LIMIT = 6

    def __init__(self):
        self.scale = self.LIMIT

    def wide(self, by=WIDE):
        return by

    def rows(self, scale=2):
        return [each for row in _ROWS for each in row], f"{scale} {self.scale} {scaled(scale)}"


def scaled(value, print=None):
    return value * LIMIT + len(pack("<H", 1)) + struct.calcsize("<H")


def counted():
    global _count
    _count = _count + 1
    return _count


_count = 0
'''
MIDDLE = """\
import low
import struct as low_level
from low import LIMIT, Base, counted as told

_ROWS = (9, 9)


class Derived(Base):
    LIMIT = LIMIT

    def rows(self, scale=3):
        counted = (lambda scaled: scaled + LIMIT)(1)
        return super().rows(scale), low.scaled(counted), low.WIDE, told(), _ROWS, low_level.calcsize("<I")


def asks():
    counted = 20
    return low.counted() + counted


def scaled(value):
    from low import scaled as other, LIMIT as most
    import top

    return other(value), most, top.NAME
"""
TOP = """\
import low
from middle import Derived, asks, scaled

NAME = "top"


def run():
    import late

    made = Derived()
    return made.rows(), scaled(4), getattr(low, "counted")(), made.wide(), asks(), late.told(), Derived.__name__
"""
LATE = """\
import low
from middle import (
    Derived,
    scaled,
)


def told():
    return low.scaled(3), scaled(1), Derived.LIMIT
"""
MAIN = "import sys\nfrom top import run\n\nprint(run())\n"
PROGRAM = {"low.py": LOW, "middle.py": MIDDLE, "top.py": TOP, "late.py": LATE, STARTED: MAIN}
OWN = """\
from low import Base, LIMIT, scaled
import middle

print(issubclass(middle.Derived, Base), LIMIT, scaled(2), middle.scaled(1))
"""


def made_of(texts: Mapping[str, str], own: str, folder: Path) -> dict[str, str | bytes]:
    """Return what goes to a board, and put it into a folder."""
    report = Report()
    files = compiled({**texts, "own.py": own}, BYTECODE, report, unnumbered=texts)
    assert not report.has_errors
    for name, content in files.items():
        (folder / name).write_bytes(content.encode() if isinstance(content, str) else content)
    return files


def said(folder: Path, script: str) -> str:
    """Return what MicroPython prints in a folder."""
    ran = [str(MICROPYTHON), "-c", script]
    return subprocess.run(ran, cwd=folder, capture_output=True, text=True, check=True).stdout


def test_a_program_does_what_it_did(tmp_path: Path) -> None:
    """With classes that derive from each other, names that are alike, imports of each kind, and counters."""
    before, after = tmp_path / "before", tmp_path / "after"
    before.mkdir()
    after.mkdir()
    for name, text in {**PROGRAM, "own.py": OWN}.items():
        (before / name).write_text(text)
    files = made_of(PROGRAM, OWN, after)
    for script in (
        "import main, own",
        "import own, main",
        "import middle, top, low; print(top.run(), low.WIDE, middle.Derived)",
    ):
        assert said(after, script) == said(before, script)
    assert {name for name in files if name.startswith("part_")} == {"part_0.mpy", "part_1.mpy"}  # own has "scaled"


def test_what_is_always_loaded_together_is_one_module(tmp_path: Path) -> None:
    """What is asked for later stays, and of the others nobody loads what they leave."""
    files = made_of(PROGRAM, "", tmp_path)
    assert {name for name in files if name.startswith("part_")} == {"part_0.mpy"}
    loaded = said(
        tmp_path, "import main, sys; print([name for name in ('low', 'middle', 'top', 'late') if name in sys.modules])"
    )
    assert loaded.splitlines()[-1] == "['late']"


def test_names_that_the_users_code_has_are_the_same_in_errors(tmp_path: Path) -> None:
    """And all others are in the file beside the modules, with the module that each is of."""
    own = "from low import scaled\n\ndef fail():\n    scaled()\n"
    files = made_of(PROGRAM, own, tmp_path)
    script = "import own\ntry:\n    own.fail()\nexcept TypeError as error:\n    print(error)\n"
    assert said(tmp_path, script).startswith("scaled() ")
    assert "scaled" not in str(files[TABLE])
    made_of(PROGRAM, "", tmp_path)
    names = read_table((tmp_path / TABLE).read_text())["part_0"]
    assert "middle.scaled" in names.values()


@pytest.mark.parametrize(
    ("low", "own"),
    [
        ("def told():\n    return __name__\n", ""),
        ("def told():\n    return globals()\n", ""),
        ("import micropython\n\n@micropython.native\ndef told():\n    return 1\n", ""),
        ("try:\n    import missing\nexcept ImportError:\n    missing = None\n\ndef told():\n    return missing\n", ""),
        ("from time import *\n\ndef told():\n    return 1\n", ""),
        ("state = 1\n\ndef told():\n    global state\n    state = 2\n", ""),
        ("def told():\n    return 1\n", "import low\nlow.told = None\n"),
        ("def told():\n    return 1\n", "from low import *\n"),
    ],
)
def test_a_module_that_could_tell_stays_as_it_is(low: str, own: str) -> None:
    """One that looks at itself, has machine code or what may not be there, or is changed from outside."""
    texts = {"low": low, "top": "from low import told\n\ndef run():\n    return told()\n"}
    made = bundled(texts, "from top import run\n", {}, [own])
    assert made.texts["low"] == low
    assert made.texts["part_0"].startswith("from low import told\n")


def test_what_may_not_be_loaded_is_in_no_bundle() -> None:
    """One in place of another that an interpreter refuses."""
    told = "def told():\n    return 1\n"
    chosen = "try:\n    from fast import told\nexcept ImportError:\n    from plain import told\n"
    texts = {"fast": told, "plain": told, "chosen": chosen, "top": "from chosen import told\n"}
    made = bundled(texts, "import top\n", {}, []).texts
    assert {name: made[name] for name in ("fast", "plain", "chosen")} == {"fast": told, "plain": told, "chosen": chosen}


def test_names_of_a_class_are_its_own_where_its_lines_look_others_up() -> None:
    """A new name of what they look up must be none of them; elsewhere it may be."""
    for default, own in (("first", {"SIZE", "of", "self", "by"}), ("1", {"self", "by"})):
        seen = GlobalNames({})
        seen.visit(ast.parse(f"class One:\n    SIZE = 1\n    def of(self, by={default}):\n        return by\n"))
        assert seen.own == own


def test_a_module_between_others_is_loaded_after_what_it_needs(tmp_path: Path) -> None:
    """Whoever imports it first: what stays as it is begins another bundle."""
    texts = {
        "first.py": "def one():\n    return 1\n",
        "alone.py": "from first import one\n\ndef two():\n    return one() + 1, __name__\n",
        "last.py": "from first import one\nfrom alone import two\n\ndef three():\n    return one(), two()\n",
        STARTED: "from last import three\nprint(three())\n",
    }
    files = made_of(texts, "", tmp_path)
    assert {"part_0.mpy", "part_1.mpy", "alone.mpy"} <= files.keys()
    assert said(tmp_path, "import alone, main") == said(tmp_path, "import main") == "(1, (2, 'alone'))\n"


def test_a_program_that_is_not_generated_has_no_bundles() -> None:
    """Its main.py is its user's, and says what is loaded."""
    texts = {name: text for name, text in PROGRAM.items() if name != STARTED}
    report = Report()
    assert not any(name.startswith("part_") for name in compiled(texts, BYTECODE, report, unnumbered=texts))
    files = compiled({**texts, STARTED: MAIN}, BYTECODE, report, unnumbered=texts)
    assert not any(name.startswith("part_") for name in files)
    assert files[STARTED] == MAIN


def test_each_bundle_has_so_many_names_at_most(monkeypatch: pytest.MonkeyPatch) -> None:
    texts = {name.removesuffix(".py"): text for name, text in PROGRAM.items() if name != STARTED}
    assert "part_1" not in bundled(texts, MAIN, {}, []).texts
    monkeypatch.setattr("codegen.emit.bundles.MOST_NAMES", 10)
    assert "part_2" in bundled(texts, MAIN, {}, []).texts
