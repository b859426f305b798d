"""docs/receiver.md shows what the receiver of the rover does, to the letter."""

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from codegen.targets.receiver.view import _arguments

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "receiver.md").read_text()
BIN = Path(sys.executable).parent


@pytest.mark.parametrize("interpreter", [sys.executable, str(BIN / "micropython")], ids=["cpython", "micropython"])
def test_the_example_prints_what_the_page_shows(interpreter, tmp_path):
    """The program of the page runs as it stands on both interpreters, and prints the lines below it."""
    example, shown = re.search(r"```python\n(.*?)```\n\n```text\n(.*?)```", PAGE, re.DOTALL).groups()
    script = tmp_path / "example.py"
    script.write_text(example)
    path = str(ROOT / "generated" / "receiver")
    environment = {**os.environ, "MICROPYPATH": path, "PYTHONPATH": path}
    done = subprocess.run([interpreter, str(script)], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout == shown


def test_the_table_is_the_projects():
    """The receiver.yaml of the page says what the project's says."""
    lines = re.search(r"```yaml\n# specs/receiver.yaml\n(.*?)```", PAGE, re.DOTALL)[1].splitlines()
    written = (ROOT / "specs" / "receiver.yaml").read_text().splitlines()
    assert {line.partition("#")[0].rstrip() for line in lines} <= set(written)


@pytest.mark.parametrize(
    ("text", "arguments"),
    [("a", ["a"]), ("a, b", ["a", "b"]), ("a, f(b, g(c, d)), e", ["a", "f(b, g(c, d))", "e"])],
)
def test_a_long_call_is_cut_between_its_own_arguments(text, arguments):
    """Not between those of a call among them."""
    assert list(_arguments(text)) == arguments
