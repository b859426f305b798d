"""put_real(): a whole number times any factor as the nearest float of 32 or 64 bits, by a board's small integers alone.

What is right is what Python's fractions become as floats, which is rounded once, and for 32 bits the definition of the
format. All interpreters get the same cases in one run each.
"""

import json
import os
import random
import struct
import subprocess
import sys
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import pytest
from firmware_runs import tool
from test_firmware_floats import UNITS, nearest

from codegen.model.answers.answer import Elements
from codegen.model.answers.scaling import DIVISOR_MAX, NUMERATOR_MAX, float_parts
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.units.unit import ratio
from codegen.targets.firmware.messages.payload import real_about

TEMPLATES = Path(__file__).resolve().parents[2] / "templates" / "firmware"
STEPS = (Fraction(1), Fraction(1, 20), Fraction(1, 10000))  # those of parameters
EVERY = sorted(
    {step * factor for unit in UNITS for other in UNITS if (factor := ratio(unit, other)) is not None for step in STEPS}
)


def is_made(factor: Fraction) -> bool:
    """Return whether the function makes floats with the factor."""
    return float_parts(factor).numerator <= NUMERATOR_MAX and float_parts(factor).divisor <= DIVISOR_MAX


FACTORS = [factor for factor in EVERY if is_made(factor)]
LARGEST = [
    Fraction(NUMERATOR_MAX, DIVISOR_MAX),
    Fraction(1, DIVISOR_MAX),
    Fraction(NUMERATOR_MAX),
    Fraction((1 << 15) - 1, (1 << 15) - 1 << 3),
    Fraction((1 << 25) - 1, (1 << 15) + 1),
    Fraction(1, (1 << 25) + 1),
    Fraction((1 << 15) + 1, (1 << 27) + 1),
    Fraction(3, 1 << 60),
]
# One of both forms, in the middle of other bytes; what was ever allocated is counted where that is possible.
SCRIPT = """
import json
import sys
try:
    from micropython import mem_total
except ImportError:
    def mem_total():
        return 0
import reals_plain
with open(sys.argv[1]) as file:
    cases = json.loads(file.read())
if sys.argv[2] == "viper":
    import reals_viper
    from uctypes import addressof
found = []
for value, about, packed in cases[:1] + cases:  # the first call is not counted: names are looked up in it
    wire = bytearray(11)
    for place in range(11):
        wire[place] = 0xA5
    about = tuple(about)
    packed = bytes(packed)
    at = addressof(wire) + 1 if sys.argv[2] == "viper" else 0
    before = mem_total()
    if sys.argv[2] == "viper":
        reals_viper.put_real(at, value, packed)
    else:
        reals_plain.put_real(wire, 1, value, about)
    found.append("allocated" if mem_total() != before else "".join("%02x" % byte for byte in wire))
print(json.dumps(found[1:]))
"""


class _Field:
    """As much of a field as the function asks for."""

    def __init__(self, size: int):
        self.type = self
        self.size = size


def made() -> list[tuple[int, Fraction, int]]:
    """Values, factors and sizes: ends, random ones of any length, and those that lie close to a tie."""
    chance = random.Random(17)
    ends = (0, 1, -1, 2, 3, SMALL_INT_MAX, -SMALL_INT_MAX, (1 << 24) + 1, (1 << 25) - 1)
    cases = []
    for factor in (*FACTORS, *LARGEST):
        for size, bits in ((4, 24), (8, 53)):
            values = [*ends, *(chance.randrange(1 << chance.randrange(1, 31)) for _ in range(4))]
            for _ in range(3):  # the middle between two floats, as close as a value comes to it
                middle = (chance.randrange(1 << bits, 2 << bits) | 1) * Fraction(2) ** -chance.randrange(bits - 4, bits)
                values += [int(middle / factor) + beside for beside in (0, 1)]
            cases += [(value, factor, size) for value in values if abs(value) <= SMALL_INT_MAX]
    return [*cases, *ties(chance)]


def ties(chance: random.Random) -> Iterator[tuple[int, Fraction, int]]:
    """Products in the middle between two floats of 64 bits, and quotients as close beside a middle as can be."""
    yield (1 << 27) - 1, Fraction((1 << 27) + 1), 8
    yield -((1 << 26) - 1), Fraction((1 << 27) + 1), 8
    for _ in range(20):
        value, numerator = (chance.randrange(1 << 26, 1 << 27) * 2 + 1 for _ in range(2))
        yield value, Fraction(numerator >> 1 | 1), 8
    for size, bits in ((4, 24), (8, 53)):
        for _ in range(40):
            divisor = chance.randrange(1 << 28, 1 << 29) | 1
            for beside in (1, -1):  # value * 2 ** bits = middle * divisor + beside
                middle = -beside * pow(divisor, -1, 1 << bits) % (1 << bits) + (1 << bits)
                value = (middle * divisor + beside) >> bits
                if value <= SMALL_INT_MAX:
                    yield value, Fraction(1, divisor), size


def exact(value: int, factor: Fraction, size: int) -> bytes:
    """The nearest float, as it is on the wire."""
    return nearest(value * factor) if size == 4 else struct.pack("<d", float(value * factor))


@pytest.fixture(scope="module")
def cases(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, list[str]]:
    """A file with all cases, and what must come of them."""
    rows, expected = [], []
    for value, factor, size in made():
        covers = Elements(_Field(size), 0, 1, None, None)  # type: ignore[arg-type]
        about = real_about(covers, float_parts(factor))
        rows.append((value, about, list(struct.pack("<IIH2B", *about))))
        wire = b"\xa5" + exact(value, factor, size)
        expected.append((wire + b"\xa5" * (11 - len(wire))).hex())
    file = tmp_path_factory.mktemp("reals") / "cases.json"
    file.write_text(json.dumps(rows))
    return file, expected


@pytest.mark.parametrize(
    ("interpreter", "form", "every"),
    [("micropython", "viper", 1), ("micropython", "plain", 1), ("micropython32", "plain", 7), ("python", "plain", 1)],
)
def test_every_float_is_the_nearest(interpreter: str, form: str, every: int, cases: tuple[Path, list[str]]) -> None:
    """Both forms on all interpreters, whatever the factor; and nothing is allocated. The slow one has some of them."""
    file, expected = cases
    script = file.with_name("script.py")
    script.write_text(SCRIPT)
    some = file.with_name(f"some-{every}.json")
    some.write_text(json.dumps(json.loads(file.read_text())[::every]))
    command = [tool(interpreter) if interpreter != "python" else sys.executable]
    command += [] if interpreter == "python" else ["-X", "heapsize=64m"]
    path = f"{TEMPLATES}{os.pathsep}.frozen"
    if interpreter == "micropython32":
        script.with_name("reals_plain.py").write_text((TEMPLATES / "reals_plain.py").read_text())
        path = str(script.parent)
    environment = {**os.environ, "MICROPYPATH": path, "PYTHONPATH": str(TEMPLATES)}
    done = subprocess.run(
        [*command, str(script), str(some), form],
        capture_output=True,
        text=True,
        env=environment,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    found = json.loads(done.stdout)
    wrong = [
        (case, got, wanted)
        for case, got, wanted in zip(made()[::every], found, expected[::every], strict=True)
        if got != wanted
    ]
    assert len(found) > 900
    assert wrong == []


def test_every_pair_of_units_has_a_factor_that_is_made() -> None:
    """No conversion between units that a dialect states is refused; of parameters steps of 0.1 ps in longer times."""
    beyond = [factor for factor in EVERY if not is_made(factor)]
    assert beyond == [Fraction(1, 600000000000000), Fraction(1, 10000000000000)]
