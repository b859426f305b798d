"""The checks of commands and modes in a generated suite: they pass, each notices what it is about, and they are evidence."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import suite_is_green
from in_process import build, codegen

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent

# A change of the firmware, and the checks that have to notice it.
CHANGES = [
    ("own_commands.py", "if not param[_LEAST] <= value <= param[_MOST]:", "if not value <= param[_MOST]:", {"beyond_is_denied"}),
    ("own_commands.py", "if not param[_LEAST] <= value <= param[_MOST]:", "if not param[_LEAST] < value < param[_MOST]:", {"ends_are_done"}),
    ("own_commands.py", "value * param[_MULTIPLIER] / param[_DIVISOR]", "value * param[_MULTIPLIER]", {"ends_are_done"}),
    (
        "own_commands.py",
        "return _CANNOT if param[_DEFAULT] is None else param[_DEFAULT]",
        "return param[_LEAST]",
        {"ends_are_done", "beyond_is_denied"},
    ),
    ("own_commands.py", "if None in leaves:", "if value in leaves:", {"ends_are_done"}),
    ("own_commands.py", "    if value in leaves:\n        return None\n", "", {"ends_are_done"}),
    ("own_commands.py", "return min(max(whole, param[_ENDS][0]), param[_ENDS][1])", "return whole", {"ends_are_done"}),
    ("own_commands.py", "(is_int and row[_INT_PARAMS]) or row[_PARAMS]", "row[_PARAMS]", {"command_int_is_the_same"}),
    ("own_commands.py", "if is_int and row[_FRAMES] and", "if is_int and row[_INT_PARAMS] and False and", {"other_frames_are_denied"}),
    ("own_commands.py", "return whole if _is_among(param[_AMONG], whole) else _CANNOT", "return whole", {"beyond_is_denied"}),
    ("own_commands.py", "if whole != value and", "if whole is None and", {"beyond_is_denied"}),
    ("own_commands.py", "row[_ARMED] is not None and row[_ARMED] != ", "row[_ARMED] is not None and row[_ARMED] == ", {"only_when_it_is_allowed"}),
    ("own_commands.py", "if row[_STATIONS] and not", "if False and not", {"only_who_is_heard"}),
    ("own_commands.py", "if said is False:", "if said is None:", {"refusals_have_failed"}),
    ("own_commands.py", "if said is NotImplemented:", "if said is Ellipsis:", {"unwritten_is_unsupported"}),
    ("own_commands.py", "    with guard:\n        return judged(method(*values))\n", "    return judged(method(*values))\n", {"exceptions_have_failed"}),
    ("services.py", "if target != 0 and target != self._connection.system_id:", "if False:", {"others_are_left_alone"}),
    ("long_commands.py", "_TELL_MS = const(1000)", "_TELL_MS = const(2000)", {"progress_is_told"}),
    ("long_commands.py", "self._running.remove(running)", "pass", {"progress_is_told", "cancelled_ends"}),
    ("long_commands.py", "wire[_COMMAND_ACK_PROGRESS_AT] = running.progress", "wire[_COMMAND_ACK_PROGRESS_AT] = 0", {"progress_is_told"}),
    ("long_commands.py", 'wire[_COMMAND_LONG_CONFIRMATION_AT] > 0', 'wire[_COMMAND_LONG_CONFIRMATION_AT] >= 0', {"repeated_is_begun_once"}),
    ("command_cancel.py", "if result == _MAV_RESULT_ACCEPTED:", "if True:", {"cancelled_ends"}),
    ("mode_service.py", "not in self._vehicle.MODES", "in ()", {"modes_are_entered"}),
    ("set_mode.py", "wire[_SET_MODE_BASE_MODE_AT]", "wire[_SET_MODE_CUSTOM_MODE_AT]", {"modes_are_entered"}),
    ("vehicle.py", "vehicle.guided = mode in (11, 15,)", "vehicle.guided = mode in (11,)", {"modes_are_entered"}),
]  # fmt: skip


@pytest.fixture(scope="module")
def boat(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder in which the boat is built."""
    folder = tmp_path_factory.mktemp("commanded")
    shutil.copytree(HERE / "commanded" / "specs", folder / "specs")
    build(folder)
    return folder


def checked(boat: Path, interpreter: str, firmware: Path, *names: str) -> dict[str, str | None]:
    """Return the fault that each check finds, or None, with a firmware: of those that are named, or of all."""
    generated = boat / "generated"
    path = os.pathsep.join(map(str, (firmware, generated / "mocks", generated / "tests")))
    command = [str(BIN / interpreter), *(["-B"] if interpreter == "python" else ["-X", "heapsize=2m"])]
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": f"{path}{os.pathsep}.frozen"}
    script = [str(generated / "tests" / "command_checks.py"), "9", *names]  # a port of nobody's
    done = subprocess.run([*command, *script], env=environment, capture_output=True, text=True, check=False, timeout=60)
    assert done.returncode == 0, done.stderr
    found: dict[str, str | None] = json.loads(done.stdout)
    return found


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_they_pass(boat: Path, interpreter: str) -> None:
    """None is left out: the boat has all that they are about."""
    found = checked(boat, interpreter, boat / "generated" / "firmware")
    assert len(found) == 16
    assert not any(found.values()), found


@pytest.mark.parametrize(("file", "old", "new", "noticed"), CHANGES)
def test_a_change_is_noticed(boat: Path, tmp_path: Path, file: str, old: str, new: str, noticed: set[str]) -> None:
    """A check that cannot fail protects nothing."""
    firmware = tmp_path / "firmware"
    shutil.copytree(boat / "generated" / "firmware", firmware)
    text = (firmware / file).read_text()
    assert text.count(old) == 1, (file, old)
    (firmware / file).write_text(text.replace(old, new))
    found = checked(boat, "python", firmware, *sorted(noticed))
    assert noticed == {name for name, wrong in found.items() if wrong}, found


def test_they_are_evidence_for_what_the_commands_cite(boat: Path) -> None:
    """Every criterion about commands and modes has tests, by the names that pytest gives them."""
    done = codegen(boat, "trace", "--fail-on", "uncovered,orphaned,unspecified,uncited")
    assert done.returncode == 0, done.stdout
    listed = subprocess.run(
        [sys.executable, "-m", "pytest", "--collect-only", "-q", "-p", "no:cacheprovider", "-n0", "generated/tests/test_program.py"],
        cwd=boat, capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    for interpreter in ("cpython", "micropython"):
        assert f"[{interpreter}-command-cancelled_ends-FR-301.6]" in listed
        assert f"[{interpreter}-command-modes_are_entered-FR-301.9]" in listed
        assert f"[{interpreter}-command-ends_are_done-FR-301.2-FR-301.3]" in listed


def test_a_vehicle_whose_commands_are_all_short(tmp_path):
    """Its program answers with the results that commands have, and has nothing of those that take long."""
    shutil.copytree(HERE / "commanded" / "specs", tmp_path / "specs")
    commands = tmp_path / "specs" / "commands.yaml"
    assert "    long: true\n" in commands.read_text()
    commands.write_text(commands.read_text().replace("    long: true\n", ""))
    build(tmp_path)
    assert not (tmp_path / "generated" / "firmware" / "long_commands.py").exists()
    suite_is_green(tmp_path, "generated/tests", only="test_program and micropython-command")
