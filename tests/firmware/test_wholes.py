"""Whole numbers of floats that arrive are those of exact arithmetic, in machine code and in plain Python."""

import json
import math
import random
import struct
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest

TEMPLATES = Path(__file__).resolve().parents[2] / "templates"
PROGRAM = TEMPLATES / "firmware" / "program"
BIN = Path(sys.executable).parent
FACTORS = (
    (1, 1),
    (1000, 1),
    (18, 5),
    (1, 1000),
    (10**7, 1),
    (1, 10**7),
    (999, 7),
    (2**28 - 1, 2**28 - 3),
    (1, 2**28 - 1),
)
SCRIPT = """
import gc, json, micropython, sys
sys.path.insert(0, sys.argv[1])
whole_of_float = __import__("wholes_" + sys.argv[2]).whole_of_float
if sys.argv[2] == "viper":
    from array import array
    from frames_viper import address
    convert, given = whole_of_float, array("i", [0] * 4)
    at = address(given)

    def whole_of_float(high, low, numerator, denominator):
        given[0] = high
        given[1] = low
        given[2] = numerator
        given[3] = denominator
        convert(at)
        return given[0]

cases = CASES

def allocated(rounds):
    before = micropython.mem_total()
    for _ in range(rounds):
        for high, low, numerator, denominator in some:
            whole_of_float(high, low, numerator, denominator)
    return micropython.mem_total() - before

some = cases[::25]
gc.collect()
found = [allocated(1), allocated(3)]
print(json.dumps(found + [[whole_of_float(*case) for case in cases]]))
"""


def cases():
    """Halves of floats and factors, of which the results are numbers of 30 bits: any, halves of a step, and ends."""
    chosen = random.Random(20)
    for numerator, denominator in FACTORS:
        for at in range(200):
            number = chosen.choice((-1, 1)) * math.ldexp(chosen.getrandbits(24), chosen.randint(-60, 6))
            if at < 40:  # a half of a step, or what is beside it
                number = (chosen.randint(-4000, 4000) + 0.5) * denominator / numerator
            low, high = struct.unpack("<HH", struct.pack("<f", number))
            exact = abs(Fraction(struct.unpack("<f", struct.pack("<f", number))[0]))
            if exact < 2**30 and exact * numerator / denominator < 2**30 - 1:
                yield high, low, numerator, denominator
    yield from ((0x8000, 0, 7, 3), (0, 1, 2**28 - 1, 1), (0x4E7F, 0xFFFF, 1, 1), (0xCE7F, 0xFFFF, 1, 1))


def nearest(high, low, numerator, denominator):
    """A half is rounded away from zero."""
    value = Fraction(struct.unpack("<f", struct.pack("<HH", low, high))[0]) * numerator / denominator
    whole = math.floor(abs(value) + Fraction(1, 2))
    return whole if value >= 0 else -whole


@pytest.mark.parametrize(
    ("interpreter", "form"), [("micropython", "viper"), ("micropython", "plain"), ("micropython32", "plain")]
)
def test_they_are_the_nearest_ones(interpreter, form, tmp_path):
    """To the last step, and nothing is allocated on the way."""
    wanted = list(cases())
    script = tmp_path / "wholes.py"
    script.write_text(SCRIPT.replace("CASES", repr(wanted)))
    (tmp_path / f"wholes_{form}.py").write_text((PROGRAM / f"wholes_{form}.py").read_text())
    for module in ("frames_viper.py", "checksum.py"):
        (tmp_path / module).write_text((TEMPLATES / "codec" / module).read_text())
    command = [str(BIN / interpreter), "wholes.py", ".", form]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    first, second, found = json.loads(done.stdout)
    assert first == second
    wrong = [(case, value) for case, value in zip(wanted, found, strict=True) if value != nearest(*case)]
    assert len(wanted) > 1500
    assert not wrong
