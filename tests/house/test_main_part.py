"""The main part of the generated suite stays short: what simulates more than some seconds is listed as LONG.

How long it takes, `make suite` prints; a test counts how often the clock moves, which is the same on any computer.
"""

import ast
import json
import os
import subprocess
import sys
from pathlib import Path

from generated_suite import scripts_of

ROVER = Path(__file__).resolve().parents[2] / "generated"
MOST = 2300  # five seconds of the rover's main loop, with its readings
COUNTING = """
import importlib, json, sys
import program_bench, mock_time
moves, advance = [0], mock_time.advance_us
def counted(duration):
    moves[0] += 1
    advance(duration)
mock_time.advance_us = counted
found = {}
for asked in sys.argv[2:]:
    script, name = asked.split()
    moves[0] = 0
    program_bench.outcome(getattr(importlib.import_module(script), name))
    found[asked] = moves[0]
print(json.dumps(found))
"""


def test_what_takes_long_is_listed_as_long() -> None:
    """No check that every edit runs goes through more than five seconds, or moves the clock so often."""
    scripts = scripts_of(ROVER / "tests")
    checks_of = scripts.checks_of
    asked = []
    for path in scripts.files("tests/*_checks.py"):
        long = {check.id for check in checks_of(path.name, "LONG")}
        names = [entry.elts[0].id for entry in checks_of(path.name)]
        assert long <= set(names), path.name
        asked += [f"{path.stem} {name}" for name in names if name not in long and path.stem != "steady_checks"]
    path = os.pathsep.join(scripts.PATHS)
    done = subprocess.run(
        [sys.executable, "-c", COUNTING, "9", *asked],
        capture_output=True, text=True, check=True, env={**os.environ, "PYTHONPATH": path},
    )  # fmt: skip
    moves = json.loads(done.stdout)
    assert len(moves) > 100
    assert {check: count for check, count in moves.items() if count > MOST} == {}


def test_all_checks_of_a_script_are_found() -> None:
    """The suite parses a list of checks alone, not the whole script: it finds the same."""
    scripts = scripts_of(ROVER / "tests")
    found = 0
    for path in [*scripts.files("tests/*_checks.py"), scripts.path_of("tests", "behaviour.py")]:
        statements = [each for each in ast.parse(path.read_text()).body if isinstance(each, ast.Assign)]
        values = {ast.unparse(each.targets[0]): each.value for each in statements}
        for name in ("CHECKS", "LONG"):
            written = list(values[name].elts) if name in values else []
            checks = scripts.checks_of(path.name, name)
            assert list(map(ast.unparse, checks)) == list(map(ast.unparse, written)), path.name
            found += len(checks)
    assert found > 300
