"""put_float(): a quotient of whole numbers as the nearest float of 32 bits, by a board's small integers alone.

What is right is worked out here with fractions, by the definition of the format (IEEE 754 binary32, ties to even).
"""

import importlib.util
import json
import os
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

from codegen.model.answers.scaling import FLOAT_DIVISOR_MAX
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.units.unit import ratio, unit_named

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
"""The factors of stored steps on their way to the wire, for every pair of units that goes without a float."""


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
    """Return the bytes written, in the middle of others."""
    if hasattr(module, "put_floats"):
        return machine_put(module, value, divisor)
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


@settings(max_examples=600, deadline=None)
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


@settings(max_examples=600, deadline=None)
@given(st.integers(1, FLOAT_DIVISOR_MAX) | st.sampled_from([factor.denominator for factor in FACTORS]), ties)
def test_ties_and_what_lies_beside_them(plain: ModuleType, divisor: int, tie: tuple[int, int, int]) -> None:
    """The last of all digits decides how these are rounded."""
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


def machine_put(module: ModuleType, value: int, divisor: int) -> bytes:
    """Return what the form for machine code makes of the middle one of three words."""
    memory = bytearray(b"\xa5" * 4) + struct.pack("<i", value) + b"\xa5" * 4
    module.__dict__["memory"] = memory
    module.put_floats(0, named((1, int(divisor))))
    assert memory[:4] + memory[8:] == b"\xa5" * 8
    return bytes(memory[4:8])


def named(*floats: tuple[int, int]) -> bytes:
    """Return the input of put_floats() that names the words that are floats: the place and the divisor of each."""
    return struct.pack(f"<{len(floats) + 1}I", *(place | divisor << 6 for place, divisor in floats), 0)


@pytest.fixture(scope="module")
def viper() -> ModuleType:
    """The form for machine code as Python, because a PC computes with 64 bits what a board has 32 for."""
    text = (TEMPLATES / "floats_viper.py").read_text(encoding="utf-8")
    for old, new, count in (
        ("import micropython\n", "", 1),
        ("@micropython.viper\n", "", 1),
        (": ptr8", "", 1),
        ("        word = ptr32(at + 4 * (floats[0] & 63))\n", "        place = at + 4 * (floats[0] & 63)\n", 1),
        ("(word[0] ^ sign) - sign", 'Small(unpack_from("<i", memory, place)[0])', 1),
        ("            half = ptr16(word)\n", "", 1),
        ("half[0] = value", 'pack_into("<H", memory, place, value & 0xFFFF)', 1),
        ("half[1] = top", 'pack_into("<H", memory, place + 2, top', 1),
        ("(value >> 16)\n", "(value >> 16))\n", 1),
        ("divisor = floats[0]", "divisor = Small(floats[0]", 2),
        ("floats[3] << 18\n", "floats[3] << 18)\n", 2),
        ("floats = ptr8(int(floats) + 4)", "floats = floats[4:]", 1),
    ):
        assert text.count(old) == count, old
        text = text.replace(old, new)
    module = ModuleType("floats_viper")
    module.__dict__.update(Small=Small, pack_into=struct.pack_into, unpack_from=struct.unpack_from)
    exec(text, module.__dict__)  # noqa: S102  the project's own file
    return module


@settings(max_examples=400, deadline=None)
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
import json, struct, sys
from floats_plain import put_float
from floats_viper import put_floats
from frames import address
from micropython import mem_total

with open(sys.argv[1]) as file:
    cases = [(value, divisor, expected, bytes(named)) for value, divisor, expected, named in json.loads(file.read())]
wire = memoryview(bytearray(12))
at = address(wire)
for value, divisor, expected, named in cases:
    put_float(wire, 3, value, divisor)
    assert bytes(wire[3:7]).hex() == expected, ("plain", value, divisor, expected)
    assert wire[2] == wire[7] == 0
    wire[3:7] = bytes(4)
    struct.pack_into("<i", wire, 4, value)
    put_floats(at, named)
    assert bytes(wire[4:8]).hex() == expected, ("viper", value, divisor, expected, bytes(wire[4:8]).hex())
    assert wire[3] == wire[8] == 0
    wire[4:8] = bytes(4)
for stays in ("0000c07f", "ffff7f7f", "000080bf", "0000807f"):
    wire[4:8] = bytes(int(stays[at : at + 2], 16) for at in range(0, 8, 2))
    put_floats(at, cases[0][3])
    assert bytes(wire[4:8]).hex() == stays

def run():
    for case in cases:
        put_float(wire, 4, case[0], case[1])
        put_floats(at, case[3])

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
    listed = [
        (value, divisor, nearest(Fraction(value, divisor)).hex(), list(named((1, divisor)))) for value, divisor in cases
    ]
    (tmp_path / "cases.json").write_text(json.dumps(listed), encoding="utf-8")
    (tmp_path / "script.py").write_text(SCRIPT, encoding="utf-8")
    command = [tool("micropython"), "-X", "heapsize=32m", str(tmp_path / "script.py"), str(tmp_path / "cases.json")]
    path = os.pathsep.join([str(TEMPLATES), str(TEMPLATES.parent / "codec")])
    done = subprocess.run(command, env={"MICROPYPATH": path}, capture_output=True, text=True, check=False, timeout=60)
    assert (done.returncode, done.stdout) == (0, "0\n"), done.stdout + done.stderr


def test_functions_are_small_enough_for_the_stack() -> None:
    """MicroPython keeps the variables of a function on its stack up to 11 words, those of others on the heap."""
    command = [tool("micropython"), "-v", "-v", str(TEMPLATES / "floats_plain.py")]
    done = subprocess.run(command, env={}, capture_output=True, text=True, check=True, timeout=60)
    words = [int(number) for number in re.findall(r"\(N_STATE (\d+)\)", done.stdout)]
    assert len(words) == 4
    assert max(words) <= 11
