"""put_float(): a quotient of whole numbers as the nearest float of 32 bits, by a board's small integers alone.

What is right is worked out here with fractions, by the definition of the format (IEEE 754 binary32, ties to even).
"""

import importlib.util
import json
import random
import re
import struct
import subprocess
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from firmware_runs import tool
from hypothesis import example, given, settings
from hypothesis import strategies as st
from stated_units import STATED

from codegen.model.scaling import FLOAT_DIVISOR_MAX
from codegen.model.unit import ratio, unit_named
from codegen.model.vehicle import SMALL_INT_MAX

TEMPLATES = Path(__file__).resolve().parents[2] / "templates" / "firmware"

UNITS = [unit_named(name) for name in (*STATED, "Wh", "mWh", "J", "kJ", "C", "mW", "uV", "min", "km/h", "l/min", "mg")]

FACTORS = sorted(
    {
        step * factor
        for unit in UNITS
        for other in UNITS
        if (factor := ratio(unit, other)) is not None
        for step in (Fraction(1), Fraction(1, 2), Fraction(1, 20), Fraction(1, 10000))  # those of parameters
        if (step * factor).denominator <= FLOAT_DIVISOR_MAX and (step * factor).numerator <= SMALL_INT_MAX
    }
)
"""What stored steps are multiplied with on their way to the wire, for every pair of units that goes without a float."""


@pytest.fixture(scope="module")
def plain() -> ModuleType:
    """The plain form, under CPython."""
    return loaded("floats_plain")


def loaded(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, TEMPLATES / f"{name}.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def nearest(value: Fraction) -> bytes:
    """The float of 32 bits that is nearest to a value in the range of the normal numbers, or to 0."""
    if value == 0:
        return bytes(4)
    exponent = value.numerator.bit_length() - value.denominator.bit_length() - 1
    if abs(value) >= Fraction(2) ** (exponent + 1):
        exponent += 1
    significand = round(abs(value) / Fraction(2) ** (exponent - 23))  # a half to the even number
    bits = ((exponent + 127) << 23) + significand - (1 << 23)  # a carry goes into the exponent, as it has to
    assert -126 <= exponent <= 126
    return struct.pack("<I", bits | (0x80000000 if value < 0 else 0))


def put(module: ModuleType, value: int, divisor: int) -> bytes:
    """What is written, in the middle of other bytes."""
    wire = bytearray(b"\xa5" * 9)
    module.put_float(memoryview(wire), 3, value, divisor)
    assert wire[:3] + wire[7:] == b"\xa5" * 5
    return bytes(wire[3:7])


def near_a_tie(significand: int, exponent: int, divisor: int, beside: int) -> int:
    """A value whose quotient lies as close as can be to the middle between two floats, or in it."""
    return int(significand * Fraction(2) ** exponent * divisor) + beside


values = st.integers(-SMALL_INT_MAX, SMALL_INT_MAX) | st.builds(
    lambda value, bits: value >> bits, st.integers(-SMALL_INT_MAX, SMALL_INT_MAX), st.integers(0, 29)
)
ties = st.tuples(st.integers(1 << 24, (1 << 25) - 1).map(lambda n: n | 1), st.integers(-50, 5), st.integers(-1, 2))


@settings(max_examples=2000, deadline=None)
@given(st.sampled_from(FACTORS), values)
@example(Fraction(1), SMALL_INT_MAX)
@example(Fraction(1), -SMALL_INT_MAX)
@example(Fraction(1), (1 << 24) + 1)
@example(Fraction(1), (1 << 24) + 3)
@example(Fraction(1), (1 << 25) - 1)
@example(Fraction(1, FLOAT_DIVISOR_MAX), 1)
@example(Fraction(1, FLOAT_DIVISOR_MAX - 1), 1)
@example(Fraction(1, 1 << 15), 1)
@example(Fraction(1, (1 << 15) + 1), 1)
@example(Fraction(1, 1000), 0)
def test_every_factor_over_all_steps(plain: ModuleType, factor: Fraction, steps: int) -> None:
    """The whole range of steps and every factor that is used: the nearest float, as CPython's struct packs it."""
    largest = SMALL_INT_MAX // factor.numerator
    steps = max(-largest, min(largest, steps))
    written = put(plain, steps * factor.numerator, factor.denominator)
    assert written == nearest(steps * factor)
    assert written == struct.pack("<f", float(steps * factor))


@settings(max_examples=2000, deadline=None)
@given(st.integers(1, FLOAT_DIVISOR_MAX) | st.sampled_from([factor.denominator for factor in FACTORS]), ties)
def test_ties_and_what_lies_beside_them(plain: ModuleType, divisor: int, tie: tuple[int, int, int]) -> None:
    """Where rounding is decided by the last of all digits."""
    significand, exponent, beside = tie
    value = near_a_tie(significand, exponent, divisor, beside)
    if abs(value) <= SMALL_INT_MAX:
        assert put(plain, value, divisor) == nearest(Fraction(value, divisor))
        assert put(plain, -value, divisor) == nearest(Fraction(-value, divisor))


class Small(int):
    """An integer as a board of 32 bits keeps it without the heap: nothing that is made of it may be larger."""

    def __new__(cls, value: int) -> "Small":
        """Refuse what would be allocated."""
        assert -SMALL_INT_MAX - 1 <= value <= SMALL_INT_MAX, value
        return super().__new__(cls, value)


def _kept_small(name: str) -> None:
    operation = getattr(int, name)

    def checked(self: int, *others: int) -> Any:
        result = operation(self, *others)
        return result if result is NotImplemented else Small(result)

    setattr(Small, name, checked)


for _name in ("add", "sub", "mul", "floordiv", "mod", "lshift", "rshift", "and", "or"):
    _kept_small(f"__{_name}__")
    _kept_small(f"__r{_name}__")
_kept_small("__neg__")


class Bytes:
    """Memory as machine code writes it: the lowest byte of whatever it is given."""

    def __init__(self, memory: memoryview) -> None:
        self.memory = memory

    def __setitem__(self, place: int, value: int) -> None:
        self.memory[place] = value & 0xFF


@pytest.fixture(scope="module")
def viper() -> ModuleType:
    """The form for machine code as Python, because a PC computes with 64 bits what a board has 32 for."""
    text = (TEMPLATES / "floats_viper.py").read_text(encoding="utf-8")
    for old, new in (
        ("import micropython\n", ""),
        ("@micropython.viper\n", ""),
        (": ptr8", ""),
        ("ptr8(int(wire) + offset)", "Bytes(wire[offset:])"),
    ):
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    module = ModuleType("floats_viper")
    module.__dict__["Bytes"] = Bytes
    exec(text, module.__dict__)  # noqa: S102  the project's own file
    return module


@settings(max_examples=1000, deadline=None)
@given(st.integers(1, FLOAT_DIVISOR_MAX) | st.sampled_from([factor.denominator for factor in FACTORS]), values)
@example(FLOAT_DIVISOR_MAX, SMALL_INT_MAX)
@example(1 << 15, -SMALL_INT_MAX)
@example((1 << 15) + 1, SMALL_INT_MAX)
@example(1, SMALL_INT_MAX)
def test_no_large_integer_comes_about(plain: ModuleType, viper: ModuleType, divisor: int, value: int) -> None:
    """Every intermediate result stays below 2 ** 30, in both forms."""
    for form in (plain, viper):
        assert put(form, Small(value), Small(divisor)) == nearest(Fraction(value, divisor))


SCRIPT = """
import json, sys
from floats_plain import put_float as plain
from floats_viper import put_float as viper
from micropython import mem_total

with open(sys.argv[1]) as file:
    cases = json.load(file)
wire = memoryview(bytearray(9))
for form in (plain, viper):
    for value, divisor, expected in cases:
        form(wire, 3, value, divisor)
        assert bytes(wire[3:7]).hex() == expected, (form, value, divisor, expected)
        assert wire[2] == wire[7] == 0

def run():
    for case in cases:
        plain(wire, 3, case[0], case[1])
        viper(wire, 3, case[0], case[1])

run()
before = mem_total()
run()
print(mem_total() - before)
"""


def test_both_forms_under_micropython(tmp_path: Path) -> None:
    """The same floats in plain Python and in machine code, and nothing is allocated for them."""
    chance = random.Random(754)
    divisors = [factor.denominator for factor in FACTORS] + [FLOAT_DIVISOR_MAX]
    cases = [
        (value, divisor)
        for divisor in divisors
        for value in (0, 1, -1, divisor, -divisor, SMALL_INT_MAX, -SMALL_INT_MAX)
    ]
    for _ in range(3000):
        divisor = chance.choice(divisors)
        value = near_a_tie(
            chance.randrange(1 << 24, 1 << 25) | 1, chance.randint(-40, 5), divisor, chance.randint(0, 1)
        )
        cases += [(value, divisor)] if value <= SMALL_INT_MAX else []
        cases.append((chance.randint(-SMALL_INT_MAX, SMALL_INT_MAX) >> chance.randint(0, 29), divisor))
    listed = [(value, divisor, nearest(Fraction(value, divisor)).hex()) for value, divisor in cases]
    (tmp_path / "cases.json").write_text(json.dumps(listed), encoding="utf-8")
    (tmp_path / "script.py").write_text(SCRIPT, encoding="utf-8")
    command = [tool("micropython"), "-X", "heapsize=8m", str(tmp_path / "script.py"), str(tmp_path / "cases.json")]
    done = subprocess.run(
        command, env={"MICROPYPATH": str(TEMPLATES)}, capture_output=True, text=True, check=False, timeout=60
    )
    assert (done.returncode, done.stdout) == (0, "0\n"), done.stdout + done.stderr


def test_functions_are_small_enough_for_the_stack() -> None:
    """MicroPython keeps the variables of a function on its stack up to 11 words, those of others on the heap."""
    command = [tool("micropython"), "-v", "-v", str(TEMPLATES / "floats_plain.py")]
    done = subprocess.run(command, env={}, capture_output=True, text=True, check=True, timeout=60)
    words = [int(number) for number in re.findall(r"\(N_STATE (\d+)\)", done.stdout)]
    assert len(words) == 4
    assert max(words) <= 11
