"""A product of more than 30 bits is rounded as if it had been worked out at once, by numbers of 30 bits alone.

Degrees became milliradians of one factor whose products do not fit into a word, and the quantity was refused.
"""

import json
import math
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest

from codegen.model.answers.scaling import rounded
from codegen.model.code.payload_code import indented
from codegen.model.code.two_steps import in_one_step, in_two_steps, most_in_steps
from codegen.model.spec.population import Rounding
from codegen.model.units.affine import AffineMap

DEGREES = AffineMap(Fraction(1000, 180), 1).whole_factor(32768)
FACTORS = [
    (DEGREES, 32768),  # a whole degree in mrad
    (AffineMap(Fraction(10, 180), 1).whole_factor(65535), 65535),  # a cdeg
    (Fraction(196133, 20000), 32768),  # a mG in mm/s/s
    (Fraction(99991, 100000), 10**6),  # less than one
    (Fraction(65537, 65536), 2**24),
]
SMALL = range(-(1 << 30), 1 << 30)
SCRIPT = """
import json
%s
def converted(number) -> int:
%s
    return value
for number in json.loads(open("numbers.json").read()):
    print(converted(number))
"""


def numbers(factor: Fraction, most: int) -> list[int]:
    """Return the ends, those around them, and those of which the products lie next to a half."""
    some = {*range(300), *range(most - 300, most + 1), *range(0, most, most // 997)}
    halves = {most // 2 // factor.denominator * factor.denominator + factor.denominator // 2 * at for at in range(9)}
    return sorted(number * sign for number in some | {each for each in halves if each <= most} for sign in (1, -1))


@pytest.mark.parametrize("rounding", list(Rounding))
@pytest.mark.parametrize(("factor", "most"), FACTORS)
def test_every_number_is_rounded_alike(factor: Fraction, most: int, rounding: Rounding) -> None:
    """And nothing that comes up on the way has more than 30 bits."""
    steps = in_two_steps(factor, Fraction(most))
    assert steps is not None
    assert not in_one_step(factor, Fraction(most))
    code = compile("\n".join(steps.lines(rounding, has_negative=True)), "lines", "exec")
    for number in numbers(factor, most):
        names = {"value": number}
        exec(code, {}, names)  # noqa: S102
        assert names["value"] == rounded(number * factor, rounding), number
        above = abs(number >> steps.bits) * steps.rest
        assert above in SMALL
        assert names["low"] in SMALL


@pytest.mark.parametrize("machine", ["", "@micropython.viper"])
@pytest.mark.parametrize("rounding", list(Rounding))
def test_micropython_does_the_same(rounding: Rounding, machine: str, tmp_path: Path) -> None:
    """In machine code, too."""
    for factor, most in FACTORS:
        steps = in_two_steps(factor, Fraction(most))
        assert steps is not None
        lines = ["value = int(number)", *steps.lines(rounding, has_negative=True)]
        text = SCRIPT % (f"import micropython\n{machine}" if machine else "", "\n".join(indented(lines)))
        given = numbers(factor, most)
        (tmp_path / "numbers.json").write_text(json.dumps(given))
        command = [str(Path(sys.executable).parent / "micropython"), "-c", text]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert not done.returncode, done.stderr
        assert list(map(int, done.stdout.split())) == [rounded(number * factor, rounding) for number in given]


def test_the_largest_number_is_one_that_is_taken() -> None:
    """It is what a hint names, so a limit there has to do."""
    for factor, most in ((DEGREES, 10**9), (Fraction(1, 1800000), 2**31), (Fraction(3, 10**7), 10**12)):
        last = most_in_steps(factor, Fraction(most))
        assert in_one_step(factor, Fraction(last)) or in_two_steps(factor, Fraction(last))
        more = Fraction(math.ceil(last * 1.01) + 1)
        assert last == most or not (in_one_step(factor, more) or in_two_steps(factor, more))
