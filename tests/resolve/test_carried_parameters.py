"""Parameters whose values a float of 32 bits does not carry are refused; all others come back from link and storage."""

import json
import random
import shutil
import struct
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from in_process import build

from codegen.diagnostics import Report
from codegen.project.systems import read_system
from codegen.resolve.carried_parameter import most_steps

MINIMAL = Path(__file__).resolve().parents[1] / "projects" / "minimal" / "specs"
MORE = "than floats of 32 bits carry, in which parameters are sent and stored"
SCRIPT = """
import json
from parameters import Parameters
kept = []
for name, steps in {steps!r}:
    taken = Parameters()
    setattr(taken, name.lower(), steps)
    again = Parameters()
    kept.append([again.restore(taken.dump()), getattr(again, name.lower())])
print(json.dumps(kept))
"""


def single(value: float) -> float:
    """Return the nearest float of 32 bits."""
    result: float = struct.unpack("<f", struct.pack("<f", value))[0]
    return result


def come_back(steps: int, step: Fraction, *, board: bool) -> int:
    """Return the steps that are found once a number of steps was sent and set, by a board's floats or by a host's."""
    kept = single if board else float
    value = single(kept(kept(steps * step.numerator) / kept(step.denominator)))
    found = kept(kept(value * step.denominator) / step.numerator)
    if int(found) == found:
        return int(found)
    return int(kept(found + 0.5)) if found >= 0 else -int(kept(0.5 - found))


@pytest.mark.parametrize("step", ["1", "2", "3", "0.5", "64", "1000", "0.1", "0.0001", "0.3", "2.7", "1e-9", "1e6"])
def test_every_step_comes_back(step: str) -> None:
    """From the first to the last one, with whole numbers exactly as they are."""
    size = Fraction(step)
    most = most_steps(size)
    lot = random.Random(step)
    tried = [*range(most - 500, most + 1), *(lot.randrange(most) for _ in range(2000))]
    assert [each for each in tried if come_back(each, size, board=True) != each] == []
    assert [each for each in tried if come_back(-each, size, board=False) != -each] == []
    if size.denominator == 1:
        assert all(single(float(each * size)) == each * size for each in tried)
        beyond = [most + 1, most + 2]
        assert any(single(float(each * size)) != each * size for each in beyond)


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ("type: int32, default: 0, min: -16777216, max: 16777216, step: 1", []),
        (
            "type: uint32, default: 16777217, min: 0, max: 16777217, step: 1",
            [(f"max of A is 16777217: that is more {MORE}", "max: 16777216, or a larger step")],
        ),
        (
            "type: int32, default: 0, min: -1073741823, max: 1, step: 1",
            [(f"min of A is -1073741823: that is more {MORE}", "min: -16777216, or a larger step")],
        ),
        ("type: int32, default: 0, min: 0, max: 1073741824, step: 64", []),
        ("type: uint32, default: 0, min: 0, max: 33554432, step: 2", []),
        ("default: 0, min: 0, max: 209715.1, step: 0.1", []),
        (
            "default: 0, min: 0, max: 209715.2, step: 0.1",
            [(f"max of A is 209715.2: that is more {MORE}", "max: 209715.1, or a larger step")],
        ),
        (
            "default: 0, min: 0, max: 4194304, step: 0.1",  # a float has this number, and not a tenth less
            [
                (
                    f"max of A is 4194304: that is more steps of 0.1 {MORE.replace('carry', 'tell apart')}",
                    "max: 209715.1, or a larger step",
                )
            ],
        ),
        ("default: 0, min: 0, max: 8388608, step: 0.5", []),
        ("type: uint32, default: 0, min: 0, max: 16777218, step: 1, values: {0: a, 16777218: b}", []),
        (
            "type: uint32, default: 0, min: 0, max: 16777219, step: 1, values: {0: a, 16777219: b}",
            [(f"16777219 of A is more {MORE}", "choose values up to 16777216")],
        ),
    ],
)
def test_what_is_not_carried_is_refused(keys: str, said: list[tuple[str, str]], tmp_path: Path) -> None:
    """At the limit, or at the single value, with the last one that is."""
    specs = Path(shutil.copytree(MINIMAL, tmp_path / "specs"))
    (specs / "parameters.yaml").write_text(f"parameters: {{A: {{doc: d, {keys}}}}}\n")
    report = Report()
    read_system(str(specs / "codegen.yaml"), report)
    errors = [each for each in report if each.is_error]
    assert [(each.message, each.hint) for each in errors] == said
    assert {each.rule.id for each in errors} <= {"parameter-beyond-float"}


@pytest.mark.parametrize("interpreter", ["python", "micropython"])
def test_the_storage_keeps_the_last_steps(interpreter: str, tmp_path: Path) -> None:
    """What code sets is there again after a restart."""
    specs = Path(shutil.copytree(MINIMAL, tmp_path / "specs"))
    (specs / "parameters.yaml").write_text(
        "parameters:\n"
        "  WHOLE: {doc: d, type: int32, default: 0, min: -16777216, max: 16777216, step: 1}\n"
        "  TENTHS: {doc: d, default: 0, min: -209715.1, max: 209715.1, step: 0.1}\n"
        "  WIDE: {doc: d, type: uint32, default: 0, min: 0, max: 1073741824, step: 64}\n"
    )
    build(tmp_path)
    last = {"WHOLE": 16777216, "TENTHS": 2097151, "WIDE": 16777216}
    steps = [(name, most - less) for name, most in last.items() for less in range(50)]
    steps += [(name, -most + more) for name, most in last.items() if name != "WIDE" for more in range(50)]
    command = [str(Path(sys.executable).parent / interpreter), "-c", SCRIPT.format(steps=steps)]
    firmware = tmp_path / "generated" / "firmware"
    done = subprocess.run(command, cwd=firmware, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == [[[], each] for _, each in steps]
