"""A buoy that nobody can arm has failsafes all the same: they watch at all times, tell it, and act."""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build, codegen

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent

SCRIPT = """
import json
from program_bench import SECOND_US, mock_time, new_craft, run

craft = new_craft()
done = []
craft.dim = lambda: done.append("dim")
craft.dark = lambda: done.append("dark")
found = []


def told(seconds):
    craft.state.sea.humidity = 80
    for _ in range(seconds):
        craft.state.sea.warmth = warmth
        run(craft, SECOND_US)
    vehicle = craft.state.vehicle
    texts = [craft.texts.get(number)[1] for number in range(said + 1, craft.texts.last + 1)]
    found.append([vehicle.status, vehicle.mode, list(done), texts])


said = craft.texts.last
warmth = 12.5
told(3)
warmth = 0.5
told(3)
warmth = 1.2
told(2)
warmth = 1.6
told(2)
print(json.dumps(found))
"""
ACTIVE, CRITICAL = 4, 5
COLD, GOOD = "Frost is cold 0.50 degC", "Frost is good again"


@pytest.fixture(scope="module")
def buoy(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project, built."""
    folder = tmp_path_factory.mktemp("buoy")
    shutil.copytree(HERE / "moored_buoy" / "specs", folder / "specs")
    build(folder)
    return folder


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_what_nobody_arms_is_watched_and_told(buoy: Path, tmp_path: Path, interpreter: str) -> None:
    """HEARTBEAT is critical from the frost until it is over by the hysteresis, with a text at either end."""
    script = tmp_path / "story.py"
    script.write_text(SCRIPT)
    path = os.pathsep.join(str(buoy / "generated" / part) for part in ("firmware", "mocks", "tests"))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": f"{path}{os.pathsep}.frozen"}
    heap = [] if interpreter == "python" else ["-X", "heapsize=4m"]
    command = [str(BIN / interpreter), *heap, str(script)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    statuses = [status for status, *_ in json.loads(done.stdout)]
    texts = [texts for *_, texts in json.loads(done.stdout)]
    assert statuses == [ACTIVE, CRITICAL, CRITICAL, ACTIVE]
    assert [[text for text in each if "Frost" in text] for each in texts] == [[], [COLD], [COLD], [COLD, GOOD]]


def test_its_firmware_knows_nothing_of_arming(buoy: Path) -> None:
    """No reason not to arm, and nothing that asks for one."""
    for module in ("failsafe", "vehicle"):
        text = (buoy / "generated" / "firmware" / f"{module}.py").read_text()
        assert not [word for word in ("armed", "arming", "problem()", "is_against", "if True") if word in text]


WRONG = [
    ("    when: always\n    latch: false\n    hyst", "    latch: false\n    hyst", "when: always", "it rests until"),
    (
        "    level: level\n",
        "    level: level\n    to_arm: [{below: 12 V}]\n",
        "force: 21196",
        "nothing is armed",
    ),
    ("call: dim,", "call: dim, disarm: true,", "leave disarm out", "dim cannot disarm what cannot be armed"),
]


@pytest.mark.parametrize(("old", "new", "hint", "message"), WRONG, ids=["when", "to_arm", "disarm"])
def test_what_only_arming_gives_a_meaning_is_an_error(
    tmp_path: Path, old: str, new: str, hint: str, message: str
) -> None:
    """A failsafe that would rest for ever, a condition that nothing asks for, an action that disarms nothing."""
    shutil.copytree(HERE / "moored_buoy" / "specs", tmp_path / "specs")
    vehicle = tmp_path / "specs" / "vehicle.yaml"
    text = vehicle.read_text()
    assert text.count(old) == 1
    vehicle.write_text(text.replace(old, new))
    done = codegen(tmp_path, "check")
    assert done.returncode == 1
    assert message in done.stdout
    assert hint in done.stdout
    assert done.stdout.count("error") == 1, done.stdout


def test_a_mode_that_nothing_keeps_is_an_error(tmp_path: Path) -> None:
    """An action changes a mode that the state has; without a component vehicle there is none, nor a status to tell."""
    shutil.copytree(HERE / "moored_buoy" / "specs", tmp_path / "specs")
    state = tmp_path / "specs" / "state.yaml"
    text = state.read_text()
    state.write_text("components:\n" + text[text.index("  store:") :])
    heartbeat = tmp_path / "specs" / "messages" / "heartbeat.yaml"
    text = heartbeat.read_text().replace("{state: vehicle.mode}", "{constant: 0}")
    heartbeat.write_text(text.replace("{state: vehicle.status}", "{enum: MAV_STATE_ACTIVE}"))
    done = codegen(tmp_path, "check")
    assert done.returncode == 1
    assert "the state has no number mode in a single component vehicle" in done.stdout
    vehicle = tmp_path / "specs" / "vehicle.yaml"
    vehicle.write_text(vehicle.read_text().replace("mode: 7, ", ""))
    build(tmp_path)
    text = (tmp_path / "generated" / "firmware" / "vehicle.py").read_text()
    assert "status" not in text
    assert "self.dark()" in text


def renamed(folder: Path, old: str, new: str) -> None:
    """Copy the specification, with another name for what it calls so."""
    shutil.copytree(HERE / "moored_buoy" / "specs", folder / "specs")
    for path in (folder / "specs").rglob("*.yaml"):
        text = re.sub(rf"^  {old}:", f"  {new}:", path.read_text(), flags=re.MULTILINE)
        text = re.sub(rf"\b{old}\.", f"{new}.", text)
        path.write_text(text.replace(f"call: {old}", f"call: {new}").replace(f"action: {old}", f"action: {new}"))


@pytest.mark.parametrize("name", ["level", "title"])
def test_a_component_can_have_the_name_of_an_argument(tmp_path: Path, name: str) -> None:
    """The function that makes the text of a failsafe is given these as well, and compiles."""
    renamed(tmp_path, "sea", name)
    build(tmp_path)
    text = (tmp_path / "generated" / "firmware" / "failsafe.py").read_text()
    compile(text, "failsafe.py", "exec")
    assert f"def _frost_text(title, {name}_, level):" in text


@pytest.mark.parametrize("name", ["level", "action", "head", "armed"])
def test_a_failsafe_can_have_the_name_of_a_column(tmp_path: Path, name: str) -> None:
    """The constant with its conditions is not that of the column."""
    renamed(tmp_path, "frost", name)
    build(tmp_path)
    text = (tmp_path / "generated" / "firmware" / "failsafe.py").read_text()
    assert text.count(f"\n_{name.upper()}_FAILSAFE = (") == 1
    assert text.count(f"\n_{name.upper()} = ") <= 1


TAKEN = [
    *(("sea", name) for name in ("words", "words_at", "forget_next", "tell_sea", "update_sea", "store_words", "board")),
    *(
        ("dim", name)
        for name in ("access", "connections", "is_armed", "restart_ms", "frost_failsafes", "received_ping")
    ),
]


@pytest.mark.parametrize(("old", "new"), TAKEN)
def test_a_name_that_the_firmware_has_is_an_error(tmp_path: Path, old: str, new: str) -> None:
    """A component would replace a part of the state, and an action one of the vehicle."""
    renamed(tmp_path, old, new)
    done = codegen(tmp_path, "check")
    kind = "component" if old == "sea" else "call of its own"
    assert done.returncode == 1
    assert f"{new} cannot be the name of a {kind}" in done.stdout


def test_a_parameter_can_have_the_name_of_a_method(tmp_path: Path) -> None:
    """RESTORE does not replace restore(), without which nothing starts."""
    shutil.copytree(HERE / "moored_buoy" / "specs", tmp_path / "specs")
    for path in (tmp_path / "specs").rglob("*.yaml"):
        path.write_text(path.read_text().replace("BUOY_LOW", "RESTORE"))
    build(tmp_path)
    assert "self.restore_ = 110" in (tmp_path / "generated" / "firmware" / "parameters.py").read_text()
