"""The MicroPython whose words have 32 bits is one, and loses nothing: what other tests find with it counts."""

import json
import os
import subprocess
import sys
from pathlib import Path

MICROPYTHON32 = Path(sys.executable).with_name("micropython32")

WORDS = """
import json, sys
from micropython import mem_total

def allocated(function):
    function()
    before = mem_total()
    function()
    return mem_total() - before

most = [0x3FFFFFFF]
print(json.dumps([sys.maxsize, allocated(lambda: most[0] - 1), allocated(lambda: most[0] + 1) > 0]))
"""

GARBAGE = """
import gc, sys

def tree(depth):
    # What is made first is held by nothing but a variable of this function while the rest is made.
    return [depth, tree(depth - 1), tree(depth - 1), "x" * depth] if depth else []

def size(node):
    return 1 + size(node[1]) + size(node[2]) if node else 0

for turn in range(400):
    kept = tree(6)
    bytes(1000 + turn)
    assert size(kept) == 63, turn
print(gc.mem_free() > 0)
"""


def run(script: str, folder: Path, *options: str, **settings: str) -> str:
    """Return the output of a script."""
    (folder / "script.py").write_text(script)
    command = [str(MICROPYTHON32), *options, str(folder / "script.py"), "one", "two"]
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **settings}, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_words_have_32_bits(tmp_path: Path) -> None:
    """A number of 30 bits and its sign is small, the next one lies on the heap: as on a board."""
    assert json.loads(run(WORDS, tmp_path)) == [2**31 - 1, 0, True]


def test_nothing_in_use_is_collected(tmp_path: Path) -> None:
    """A small heap that is collected again and again keeps what only variables hold."""
    assert run(GARBAGE, tmp_path, "-X", "heapsize=48k") == "True\n"


def test_it_is_called_as_the_other_one_is(tmp_path: Path) -> None:
    """Arguments, the path of modules, files and the exit code."""
    (tmp_path / "modules").mkdir()
    (tmp_path / "modules" / "beside.py").write_text("value = 5")
    script = "import beside, sys\nprint(sys.argv[1:], beside.value)\nopen('written', 'w').write('x')"
    (tmp_path / "script.py").write_text(script + "\nsys.exit(3)")
    done = subprocess.run(
        [str(MICROPYTHON32), str(tmp_path / "script.py"), "one", "two"],
        capture_output=True,
        text=True,
        cwd=tmp_path,
        env={**os.environ, "MICROPYPATH": str(tmp_path / "modules")},
        check=False,
    )
    assert (done.returncode, done.stdout, done.stderr) == (3, "['one', 'two'] 5\n", "")
    assert (tmp_path / "written").read_text() == "x"
