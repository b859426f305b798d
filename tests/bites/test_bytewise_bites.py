"""The generated checks of bytewise parameters notice faults: each of these makes one of them fail."""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from in_process import build

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "guarded"

SET, LIST, REFUSED = "set_answers_with_the_value", "list_is_complete", "refused_values_change_nothing"
CAST, TYPE = "numbers_as_floats_are_refused", "another_type_is_refused"

# A module, a text in it, what takes its place, and a check that then fails.
FAULTS = [
    ("bytewise", 'pack_into("<I", wire, at, 0)', "pass", LIST),
    ("bytewise", "min(round(value), smallest + values - 1)", "value + 0.0", SET),
    ("bytewise", "code != _FLOAT", "False", SET),
    ("bytewise", "pack_into(code, wire, at, value)", 'pack_into("<f", wire, at, value)', SET),
    ("bytewise", "return unpack_from(code", 'return unpack_from("<f"', SET),
    ("bytewise", "return unpack_from(code, wire, at)[0]", 'return int(unpack_from("<f", wire, at)[0])', SET),
    ("bytewise", "if any(wire[", "if False and any(wire[", CAST),
    ("bytewise", "at + calcsize(code) : at + _SIZE", "at + calcsize(code) + 1 : at + _SIZE", CAST),
    ("bytewise", "at + calcsize(code) : at + _SIZE", "at + calcsize(code) : at + _SIZE - 1", CAST),
    *(("bytewise", f'"<{right}"', f'"<{wrong}"', LIST) for right, wrong in ("bB", "hH", "ih")),
    *(("bytewise", f'"<{right}"', f'"<{wrong}"', CAST) for right, wrong in ("Bh", "Hi")),  # the same bytes go out
    *(("bytewise", f'"<{right}" if', f'"<{wrong}" if', SET) for right, wrong in ("Ii", "IB")),
    *(("bytewise", f'return "<{code}"', f'return ">{code}"', SET) for code in "HhI"),
    ("parameter_service", "if message.wire[_PARAM_SET_PARAM_TYPE_AT] == kind:", "if True:", TYPE),
    ("parameter_service", "[_PARAM_SET_PARAM_TYPE_AT] == kind:", "[_PARAM_SET_PARAM_TYPE_AT] in (kind, 9):", TYPE),
    ("parameter_service", "[_PARAM_SET_PARAM_TYPE_AT] == kind:", "[_PARAM_SET_PARAM_TYPE_AT] in (kind, 0):", TYPE),
    ("parameter_service", "_PARAM_SET_PARAM_VALUE_AT, kind)", "_PARAM_SET_PARAM_VALUE_AT, 9)", SET),
    ("parameter_service", "_AT, kind, self._vehicle", "_AT, 9, self._vehicle", SET),
    ("parameter_service", "            if value is None:\n", "            if False:\n", TYPE),
    ("parameter_service", "            if value is None:\n", "            if True:\n", REFUSED),
]

CHOSEN = """
import json, sys
import bytewise_checks, parameter_checks
from program_bench import outcome

checks = {check.__name__: check for check, *_ in bytewise_checks.CHECKS + parameter_checks.CHECKS}
names = sys.argv[1:] or list(checks)
print(json.dumps({name: outcome(checks[name]) for name in names}))
"""


@pytest.fixture(scope="module")
def output(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the output of a project with a bytewise parameter of every whole type."""
    folder = tmp_path_factory.mktemp("guarded")
    shutil.copytree(PROJECT / "specs", folder / "specs")
    build(folder)
    return folder / "generated"


def failed(output: Path, *names: str, changed: tuple[Path, ...] = ()) -> set[str]:
    """Return the checks of these names, or of all, that fail under CPython; modules of ``changed`` go before others."""
    path = os.pathsep.join(map(str, (*changed, *(output / name for name in ("firmware", "mocks", "tests")))))
    done = subprocess.run(
        [sys.executable, "-c", CHOSEN, *names],
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": path},
        check=True,
        timeout=60,
    )
    outcomes = json.loads(done.stdout)
    assert outcomes
    return {name for name, said in outcomes.items() if said is not None and not said.startswith("left out: ")}


def test_none_fails_as_it_is(output: Path) -> None:
    assert failed(output) == set()


@pytest.mark.parametrize(("module", "text", "fault", "check"), FAULTS)
def test_fault_is_noticed(output: Path, tmp_path: Path, module: str, text: str, fault: str, check: str) -> None:
    """By the check that is about it."""
    right = (output / "firmware" / f"{module}.py").read_text()
    assert text in right
    (tmp_path / f"{module}.py").write_text(right.replace(text, fault, 1))
    assert failed(output, check, changed=(tmp_path,))
