"""board-file: what a program saves on its board replaces no module, nothing of its own, and nothing of deploy's.

The cases change tests/projects/guarded, which has all kinds of such files: parameters, a key, credentials.
"""

import re
import shutil
from pathlib import Path

import pytest

from codegen.cli import main

SPECS = Path(__file__).resolve().parents[1] / "projects" / "guarded" / "specs"
FILES, CREDENTIALS, SETUP = "files: [parameters.0, parameters.1]", "credentials: wifi.json", "  setup: [cable]\n"
LONG = "p" * 65

CASES = [
    ("files: [§main.py, boot.py]", FILES, "main.py cannot be where parameters are saved: it is the name of a module"),
    ("files: [parameters.0, §state.mpy]", FILES, "state.mpy cannot be where parameters are saved"),
    ("files: [parameters.0, §GATE.PY]", FILES, "GATE.PY cannot be"),
    ("files: [parameters.0, §gate]", FILES, "gate cannot be where parameters are saved: modules lie in a folder there"),
    ("files: [parameters.0, §lib]", FILES, "lib cannot be"),
    ("files: [§sub/a, b]", FILES, "nobody makes the folder sub on the board"),
    ("files: [parameters.0, §..]", FILES, "no . at the end"),
    ("files: [parameters.0, §parameters.]", FILES, "no . at the end"),
    (f"files: [parameters.0, §{LONG}]", FILES, "it has 65 letters, and 64 are the most"),
    ("files: [a, §a]", FILES, "a cannot be where parameters are saved: parameters are saved there"),
    ("files: [a, §A]", FILES, "A cannot be where parameters are saved: parameters are saved there, in a, and FAT"),
    ("files: [parameters.0, signing.key]", FILES, "signing.key cannot be where the key is kept: parameters are saved"),
    ("files: [parameters.0, signing.key.wifi]", FILES, "signing.key.wifi cannot be where the key is kept"),
    ("files: [parameters.0, signing.key.new]", FILES, "signing.key.new cannot be where the key is kept"),
    ('files: [§"", b]', FILES, "'' cannot be where parameters are saved"),
    ("files: [§deployed.json, b]", FILES, "codegen deploy has its list there"),
    ('credentials: §""', CREDENTIALS, "'' cannot be where wifi has its credentials"),
    ("credentials: §main.py", CREDENTIALS, "main.py cannot be where wifi has its credentials"),
    ("credentials: §Parameters.0", CREDENTIALS, "parameters are saved there, in parameters.0, and FAT"),
    ("credentials: §signing.key", CREDENTIALS, "signing.key cannot be where wifi has its credentials: the key is kept"),
    ("credentials: §wifi.json.", CREDENTIALS, "no . at the end"),
    (f"{SETUP}  key: §parameters.0\n", SETUP, "parameters.0 cannot be where the key is kept: parameters are saved"),
    (f"{SETUP}  key: wifi.json\n", SETUP, "wifi.json cannot be where wifi has its credentials: the key is kept"),
    (f"{SETUP}  key: §boot.py\n", SETUP, "boot.py cannot be where the key is kept: it is the name of a module"),
    (f"{SETUP}  key: §../key\n", SETUP, "nobody makes the folder .. on the board"),
]


def changed(specs: Path, old: str, new: str) -> str:
    """Replace a text that one of the two files has; return the place that "§" marks, or nothing."""
    for path in (specs / "vehicle.yaml", specs / "board.yaml"):
        text = path.read_text()
        if old in text:
            text = text.replace(old, new)
            before, mark, _ = text.partition("§")
            path.write_text(text.replace("§", ""))
            return f"{path.name}:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}: " if mark else ""
    raise AssertionError(old)


@pytest.mark.parametrize(("new", "old", "says"), CASES, ids=[case[0].strip().replace("§", "")[:40] for case in CASES])
def test_a_name_that_destroys_something_is_refused(
    new: str, old: str, says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """At the name, or at that of the other file of two with one name; with a name that would do."""
    specs = Path(shutil.copytree(SPECS, tmp_path / "specs"))
    place = changed(specs, old, new)
    assert main(["build", "--project", str(specs / "codegen.yaml")]) == 1
    printed = capsys.readouterr().out
    errors = [line for line in printed.splitlines() if ": error " in line]
    assert errors
    assert any(says in line for line in errors), printed
    assert all(re.search(r":\d+:\d+: error board-file: ", line) for line in errors)
    assert place in errors[0]
    assert re.search("hint: (files: .parameters.0, parameters.1.|key: signing.key|credentials: wifi.json)\n", printed)
    assert not (tmp_path / "generated").exists()
