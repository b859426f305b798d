"""Imports of the user's modules that lead nowhere are told before anything is changed on a board."""

import os
import re
import shutil
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import pytest
from as_written import compiled_as_written
from board_on_pty import powered
from in_process import codegen

from codegen.deploy.built_in import ANYWHERE, built_in
from codegen.deploy.connection import Connection
from codegen.deploy.contents import Contents
from codegen.deploy.imports import needed_imports
from codegen.deploy.missing import UNKNOWN_BOARD, Importable, report_missing
from codegen.deploy.transfer import importable
from codegen.diagnostics import Report
from codegen.source import Place

PICO = {"_machine": "Raspberry Pi Pico 2 W with RP2350"}
LISTED = """\
__main__          asyncio/core      network           time
_asyncio          builtins          machine           ujson
asyncio/__init__  gc                micropython
Plus any modules on the filesystem
"""
BOARD = Importable(frozenset({"machine", "time"}), is_known=True)


def needed(text: str, *there: str, is_main: bool = False) -> list[str]:
    """Return what a text needs; those with a question mark behind them only perhaps."""
    found = needed_imports(text, lambda module: module in there, "", is_main=is_main)
    return [each.module + ("" if each.is_sure else "?") for each in found]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("import a, b.c as d\nfrom e.f import g", ["a", "b.c", "e.f"]),
        ("def f():\n    import a\nclass C:\n    import b\n    def g(self):\n        import c", ["a?", "b", "c?"]),
        ("try:\n    import a\nexcept ImportError:\n    a = None", ["a"]),  # it is asked whether it is there
        ("for x in y:\n    import a\nwhile z:\n    import b\nelse:\n    import c", ["a?", "b?", "c?"]),
        ("if x:\n    import a\nelse:\n    import b", ["a?", "b?"]),
        ("if False:\n    import a\nelse:\n    import b\nif 0:\n    import c", ["b"]),
        ("if TYPE_CHECKING:\n    import a\nif not typing.TYPE_CHECKING:\n    import b", ["b"]),
        ("if sys.implementation.name == 'micropython':\n    import a\nelse:\n    import b", ["a"]),
        ("if sys.implementation.name != 'micropython':\n    import a\nelse:\n    import b", ["b"]),
        ("if sys.implementation.name == 'cpython':\n    import a", []),
        ("if __name__ == '__main__':\n    import unittest", []),
        ("with x:\n    import a", ["a"]),
        ("a = __import__('b')\n__import__(c)", ["b"]),
        ("x = = 1", []),
    ],
)
def test_what_a_module_needs(text: str, expected: list[str]) -> None:
    there = ("a", "b", "c", "e.f", "b.c")
    assert needed(text, *there) == expected


def test_the_started_module_is_main() -> None:
    assert needed("if __name__ == '__main__':\n    import a", is_main=True) == ["a"]


@pytest.mark.parametrize(
    ("there", "expected"),
    [(("a",), ["a", "after"]), (("b",), ["b"]), ((), ["b"]), (("a", "b"), ["a", "after"])],
)
@pytest.mark.parametrize("caught", ["ImportError", "(OSError, ImportError)", "Exception", ""])
def test_what_is_tried_and_what_stands_for_it(there: tuple[str, ...], expected: list[str], caught: str) -> None:
    """Neither is missed while the other is there; where both are not, the second one is."""
    handler = f"except {caught}:" if caught else "except:"
    assert needed(f"try:\n    import a\n{handler}\n    import b\nelse:\n    import after", *there) == expected


def test_another_exception_is_no_way_out() -> None:
    assert needed("try:\n    import a\nexcept OSError:\n    import b") == ["a", "b?"]


def test_relative_imports_are_of_their_package() -> None:
    found = needed_imports("from . import a\nfrom .b import c\nfrom ..d import e", lambda _module: False, "p.q")
    assert [(each.module, each.names) for each in found] == [("p.q", ("a",)), ("p.q.b", ("c",)), ("p.d", ("e",))]


def test_what_help_lists() -> None:
    """All columns, packages by their first name, and both names of what was once called utime."""
    found = built_in(LISTED.replace("\n", "\r\n"))
    assert found is not None
    assert {"__main__", "asyncio", "network", "time", "utime", "ujson", "json", "micropython"} <= found
    assert not {"Plus", "modules", "asyncio/core", "telemetry"} & found
    assert built_in("object modules is of type str\r\n") is None
    assert {"machine", "umachine", "asyncio", "network", "rp2", "esp32", "pyb"} <= ANYWHERE


def system_with(*sources: Any) -> Any:
    program = SimpleNamespace(module="app", class_name="App", spec=SimpleNamespace(code=None, place=Place("/v.yaml")))
    return cast(Any, SimpleNamespace(program=program, sources={str(at): each for at, each in enumerate(sources)}))


def source_of(imported: str) -> Any:
    spec = SimpleNamespace(at=lambda _key: Place("/board.yaml", 7, 3))
    return SimpleNamespace(imported=imported, own_modules={}, polling=SimpleNamespace(spec=spec))


def told(
    own: dict[str, str], *sources: Any, made: dict[str, str] | None = None, board: Importable = BOARD
) -> list[str]:
    report = Report()
    made = {"main.py": "", "state.py": ""} if made is None else made
    report_missing(system_with(*sources), Contents({}, made, own, "/p"), board, Place("/tty"), report)
    return [
        f"{each.place.file}:{each.place.line}:{each.place.column} {each.rule.id}: {each.message}" for each in report
    ]


def rules(own: dict[str, str], *sources: Any, **others: Any) -> list[str]:
    """Return the file and the rule of each finding."""
    lines = (re.fullmatch(r"(?:/p/)?([^:]*):\S* (\S+): .*", line) for line in told(own, *sources, **others))
    return [f"{found[1]} {found[2]}" for found in lines if found]


def test_a_module_that_is_nowhere_is_an_error_at_its_import() -> None:
    assert told({"app.py": "import time, state, machine\nimport motor\n"}) == [
        "/p/app.py:2:1 missing-import: there is no motor: neither in the folder of the project, nor generated, nor on "
        "the board"
    ]


def test_modules_are_followed() -> None:
    """Through packages, too, of which only what is imported counts."""
    own = {
        "app.py": "import parts.wheel\nimport parts.axle\ndef f():\n    import later\n",
        "later.py": "import gone\n",
        "parts/__init__.py": "from . import hub\n",
        "parts/wheel.py": "from .tyre import Tyre\nfrom parts import rim\n",
        "parts/hub.py": "import lost\n",
        "parts/unused.py": "import unittest\n",
    }
    assert rules(own) == [
        *("app.py missing-import", "later.py uncertain-import", "parts/hub.py missing-import"),
        "parts/wheel.py missing-import",
    ]


@pytest.mark.parametrize(
    "lines", [("def f():\n    import pump\n", "import tank\n"), ("import tank\n", "def f():\n    import pump\n")]
)
def test_the_way_that_is_always_taken_counts(lines: tuple[str, ...]) -> None:
    """A module that a call imports, and another module whenever it is loaded, in whatever order they are found."""
    own = {"app.py": "".join(lines), "tank.py": "import pump\n", "pump.py": "import gone\n"}
    assert rules(own) == ["pump.py missing-import"]


def test_all_folders_count_in_which_a_board_looks() -> None:
    """Beside its own file system, which was looked through: a ROMFS. What goes from there is not there any more."""
    folders = [
        ["", ["app.py", "pump.mpy", "lib", "empty"]],
        ["/flash/lib", ["lidar"]],
        ["/rom", ["motor.mpy", "notes.txt"]],
    ]
    connection = cast(Any, SimpleNamespace(ask=lambda _call: ["/flash", *folders], run=lambda _call: LISTED))
    found = ["app.py", "pump.mpy", "lib/", "lib/lidar/", "lib/lidar/__init__.mpy", "empty/"]
    board = importable(connection, found, {"pump.mpy"})
    assert board.is_known
    assert {"app", "lidar", "motor", "machine"} <= board.names
    assert not {"pump", "empty", "notes", "lib/lidar", "sonar"} & board.names


def test_what_a_sensor_imports_is_a_warning() -> None:
    """The program goes on without that sensor; a class that is nowhere is the finding of before."""
    own = {"app.py": "", "sonar.py": "import gone\n"}
    assert rules(own, source_of("sonar"), source_of("lidar")) == ["/board.yaml no-module", "sonar.py uncertain-import"]


def test_where_the_board_is_not_known_it_is_a_warning() -> None:
    """Modules that any MicroPython may have are no finding then."""
    assert rules({"app.py": "import rp2, ujson, esp32\nimport motor\n"}, board=UNKNOWN_BOARD) == [
        "app.py uncertain-import"
    ]


def test_code_that_is_not_there_is_told() -> None:
    assert told({}) == ["/v.yaml:1:1 no-code: there is no app.py: the generated vehicle runs, without code of yours"]
    assert told({}, board=Importable(frozenset({"app"}), is_known=True)) == []


def test_what_the_firmware_needs_of_micropython() -> None:
    made = {"main.py": "", "wifi.py": "def f():\n    import network\n"}
    words = "the MicroPython of this board has no module network, which wifi.py imports"
    assert told({"app.py": ""}, made=made) == [f"/tty:1:1 other-board: {words}"]
    assert told({"app.py": ""}, made=made, board=UNKNOWN_BOARD) == []


@pytest.fixture(scope="module", autouse=True)
def as_written() -> Iterator[None]:
    """No test here is about what is compiled."""
    with compiled_as_written():
        yield


@pytest.fixture(scope="module")
def template(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("project")
    assert codegen(folder, "init", ".").returncode == 0
    return folder


@pytest.fixture
def project(template: Path, tmp_path: Path) -> Path:
    return Path(shutil.copytree(template, tmp_path / "project"))


@pytest.fixture(scope="module")
def flash(template: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """That of a board with the program of the template, and a module pump."""
    folder = Path(shutil.copytree(template, tmp_path_factory.mktemp("deployed") / "project"))
    (folder / "pump.py").write_text("")
    (folder / "app.py").write_text(f"import pump\n{(folder / 'app.py').read_text()}")
    image = folder / "flash"
    done, _ = deployed(folder, image)
    assert done.returncode == 0, done.stdout
    return image


def deployed(folder: Path, image: Path, *arguments: str, code: str = "", **settings: Any) -> tuple[Any, list[str]]:
    """Run some code on a board, then deploy; return what the command said, and the names that are on the board then."""
    with powered(image, told=PICO, **settings) as board:
        if code:
            on_board(board.port, code)
        done = codegen(folder, "deploy", "--port", board.port, "--log", "0", *arguments)
        return done, on_board(board.port, "import os; print('\\n'.join(os.listdir()))").split()


def on_board(port: str, code: str) -> str:
    connection = Connection(port)
    try:
        return connection.run(code)
    finally:
        connection.close()


def import_in(folder: Path, line: str) -> None:
    app = folder / "app.py"
    app.write_text(f"{line}\n{app.read_text()}")


def test_a_board_gets_nothing_that_cannot_run(project: Path, tmp_path: Path) -> None:
    import_in(project, "import machine, asyncio, motor")
    done, names = deployed(project, tmp_path / "flash")
    assert done.returncode == 1
    assert "app.py:1:1: error missing-import: there is no motor: neither in the folder of the project" in done.stdout
    assert "nor on the board" in done.stdout
    assert names == []


@pytest.mark.parametrize(
    "there",
    [
        "open('motor.py', 'w').close()",
        "import os; os.mkdir('lib'); open('lib/motor.mpy', 'w').close()",
        "import os; os.mkdir('motor'); open('motor/__init__.py', 'w').close()",
    ],
)
def test_a_module_that_is_on_the_board(project: Path, tmp_path: Path, there: str) -> None:
    """By mip or by hand, as a module or a package."""
    import_in(project, "import motor")
    done, _ = deployed(project, tmp_path / "flash", "--dry-run", code=there)
    assert done.returncode == 0, done.stdout
    assert "import" not in done.stdout


def test_a_module_that_the_board_has_in_another_file_system(project: Path, tmp_path: Path) -> None:
    """As in a ROMFS: all folders count in which MicroPython looks."""
    (tmp_path / "rom").mkdir()
    (tmp_path / "rom" / "motor.mpy").write_text("")
    import_in(project, "import motor")
    done, _ = deployed(project, tmp_path / "flash", "--dry-run", path=[str(tmp_path / "rom")])
    assert done.returncode == 0, done.stdout


def test_a_module_that_this_deploy_removes_is_not_there(project: Path, flash: Path, tmp_path: Path) -> None:
    """An earlier deploy has put it there, and it is gone from the project; the same deploy is right with it."""
    image = Path(shutil.copy(flash, tmp_path / "flash"))
    import_in(project, "import pump")
    done, names = deployed(project, image)
    assert done.returncode == 1
    assert "error missing-import: there is no pump" in done.stdout
    assert "pump.mpy" in names


def test_an_import_that_is_tried(project: Path, tmp_path: Path) -> None:
    import_in(project, "try:\n    import motor\nexcept ImportError:\n    motor = None")
    done, _ = deployed(project, tmp_path / "flash", "--dry-run")
    assert done.returncode == 0
    assert "import" not in done.stdout


def test_a_micropython_that_lists_no_modules(project: Path, tmp_path: Path) -> None:
    """It may have any module: a warning says that nobody knows."""
    import_in(project, "import machine, motor")
    done, _ = deployed(project, tmp_path / "flash", "--dry-run", modules=None)
    assert done.returncode == 0
    assert "app.py:1:1: warning uncertain-import: there is no motor" in done.stdout
    assert "whether the board has it is not known" in done.stdout
    assert done.stdout.count("uncertain-import") == 1


def test_a_pico_without_wifi_by_another_vendor(project: Path, tmp_path: Path) -> None:
    """Its name does not tell, but its modules do."""
    modules = [
        "asyncio",
        "machine",
        "micropython",
        "struct",
        "time",
        "os",
        "sys",
        "gc",
        "array",
        "json",
        "errno",
        "socket",
    ]
    done, _ = deployed(project, tmp_path / "flash", "--dry-run", modules=modules)
    assert done.returncode == 0
    assert re.findall(
        "warning (.*): the MicroPython of this board has no module (.*), which network_port.py", done.stdout
    ) == [("other-board", "network")]


def test_an_image_is_of_no_board(project: Path) -> None:
    import_in(project, "import machine, rp2, motor")
    done = codegen(project, "deploy", "--image", "image")
    assert done.returncode == 0
    assert (project / "image").exists()
    assert re.findall(r"app.py:1:1: warning (\S+): there is no (\w+)", done.stdout) == [("uncertain-import", "motor")]


def test_a_vehicle_without_code(project: Path, tmp_path: Path) -> None:
    """It is deployed, simulated and put into an image, and it is told."""
    (project / "app.py").rename(project / "application.py")
    done, names = deployed(project, tmp_path / "flash")
    assert done.returncode == 0
    assert "main.py" in names
    words = "there is no app.py: the generated vehicle runs, without code of yours"
    assert done.stdout.count(f"warning no-code: {words}") == 1
    done = codegen(project, "deploy", "--image", "image")
    assert (done.returncode, done.stdout.count(f"warning no-code: {words}")) == (0, 1)
    assert codegen(project, "build").returncode == 0
    done = codegen(project, "sim", "--speed", "max", "--duration", "2", "--quiet")
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stderr.count(f"codegen sim: warning: {words}") == 1
    done = codegen(project, "sim", "--speed", "max", "--duration", "2", "--quiet", "--code", "application.py")
    assert words not in done.stderr


def test_code_that_was_put_on_the_board_by_hand(project: Path, tmp_path: Path) -> None:
    (project / "app.py").unlink()
    done, _ = deployed(project, tmp_path / "flash", "--dry-run", code="open('app.py', 'w').close()")
    assert "no-code" not in done.stdout


def test_a_mistyped_line_is_told_where_it_is(project: Path, tmp_path: Path) -> None:
    """In the file of the user, wherever the command runs."""
    (project / "parts").mkdir()
    (project / "parts" / "__init__.py").write_text("")
    (project / "parts" / "wheel.py").write_text("A = 1\n\n\ndef f():\n    return = A\n")
    import_in(project, "from parts import wheel")
    done, names = deployed(project, tmp_path / "flash")
    assert done.returncode == 1
    words = "error code-refused: MicroPython's compiler refuses it: SyntaxError: invalid syntax"
    assert f"{os.path.join('parts', 'wheel.py')}:5:12: {words}" in done.stdout
    assert "--mpy" not in done.stdout
    assert names == []
    done = codegen(tmp_path, "deploy", "--project", str(project), "--image", "image")
    assert f"{os.path.join('project', 'parts', 'wheel.py')}:5:12: {words}" in done.stdout


@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        ("import time\n\ndef turn(x:\n    return x\n", "3:9", "SyntaxError: invalid syntax"),
        ("def turn():\n    pass\n\n\nbreak\n", "5:1", "SyntaxError: 'break'/'continue' outside loop"),
        ("x = 1\nmatch x:\n    case 1:\n        pass\n", "2:1", "SyntaxError: invalid syntax"),  # Python reads it
    ],
)
def test_a_main_of_ones_own_is_read_before_anything_is_copied(
    project: Path, tmp_path: Path, text: str, place: str, words: str
) -> None:
    """It goes to the board as it is, where it would end at its first line; without a program nothing else starts."""
    (project / "specs" / "vehicle.yaml").unlink()
    assert codegen(project, "build").returncode == 0
    (project / "main.py").write_text("import time\n")
    assert "main.py" in deployed(project, tmp_path / "flash")[1]
    (project / "main.py").write_text(text)
    done, names = deployed(project, tmp_path / "other")
    assert done.returncode == 1
    assert f"main.py:{place}: error code-refused: MicroPython's compiler refuses it: {words}" in done.stdout
    assert names == []
    done = codegen(project, "deploy", "--image", "image")
    assert done.returncode == 1
    assert f"main.py:{place}: error code-refused" in done.stdout
    assert not (project / "image").exists()


def test_the_board_file_of_a_further_program_is_named(project: Path, tmp_path: Path) -> None:
    (project / "specs" / "buoy").mkdir()
    (project / "specs" / "buoy" / "codegen.yaml").write_text("base: ..\nproject: buoy\n")
    (project / "specs" / "buoy" / "board.yaml").write_text("board: pico\nlinks:\n  usb: {usb: true}\n")
    settings = project / "specs" / "codegen.yaml"
    settings.write_text(f"{settings.read_text()}programs:\n  buoy: buoy/codegen.yaml\n")
    done, _ = deployed(project, tmp_path / "flash", "--dry-run", "--program", "buoy")
    named = os.path.join("specs", "buoy", "board.yaml")
    words = f"the board is Raspberry Pi Pico 2 W with RP2350, and {named} names Raspberry Pi Pico (RP2040)"
    assert f"error other-chip: {words}" in done.stdout, done.stdout + done.stderr


def test_what_board_full_says_is_what_counts(project: Path, tmp_path: Path) -> None:
    """Nearly as many bytes as are free do not fit in whole blocks, and the figures say so."""
    done, _ = deployed(project, tmp_path / "flash")
    taken = int(re.findall(r"^(\d+) files copied", done.stderr, re.MULTILINE)[0])
    refused = 0
    for blocks in (taken + 2, taken + 8, taken + 30):
        done, _ = deployed(project, tmp_path / f"flash{blocks}", "--dry-run", blocks=blocks)
        for needed, free in re.findall(r"board-full: (\d+) KB are needed .*, and (\d+) KB are free", done.stdout):
            assert int(needed) > int(free)
            refused += 1
    assert refused
