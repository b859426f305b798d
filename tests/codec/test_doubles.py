"""Doubles are exact on boards whose floats have 32 bits, and are never infinity in silence there."""

import json
import os
import random
import struct
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from conformance_run import MICROPYTHON, MICROPYTHON32, SINGLE_FLOATS

from codegen.commands.codec import codec_files
from codegen.diagnostics import Report
from codegen.targets.codec.runtime import runtime_files, with_doubles
from codegen.tool.template_files import copied

CHECKS = Path(__file__).with_name("doubles_checks.py")
LARGEST = Fraction(sys.float_info.max)
HALF_STEP = Fraction(2) ** 970  # above the largest double; from there on there is none that is nearer
SMALLEST = Fraction(5e-324)

Answers = tuple[list[list[Any]], list[list[str]], bool]


def fractions() -> list[Fraction]:
    """Whole numbers, what lies just between two doubles, the ends of their range, and any."""
    chance = random.Random(64)
    found = [Fraction(0), Fraction(1), Fraction(-1), Fraction(1, 3), Fraction(123456789, 10000), Fraction(10**39)]
    found += [
        Fraction(sign * (2**bits + step)) for bits in (24, 53, 54, 64) for step in (-1, 0, 1, 3) for sign in (1, -1)
    ]
    found += [LARGEST, -LARGEST, LARGEST + HALF_STEP - 1, LARGEST + HALF_STEP, SMALLEST, SMALLEST / 2, SMALLEST * 3 / 2]
    found += [SMALLEST * 5001 / 10000, Fraction(2) ** -1022 - SMALLEST / 2, Fraction(2) ** -1022, Fraction(2) ** -1100]
    found += [Fraction(2**128 - 2**103), Fraction(2**128 - 2**103 - 1), Fraction(2**128)]  # what a float is still near
    for _ in range(300):
        exact = Fraction(chance.getrandbits(53) | 1 << 52) * Fraction(2) ** chance.randint(-1126, 971)
        found += [exact, exact + chance.choice((1, -1)) * exact / 2**54, -exact]
        found.append(Fraction(chance.randint(-(10**18), 10**18), chance.randint(1, 10**12)))
    return found


FRACTIONS = fractions()


@pytest.fixture(scope="module")
def codec(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The codec of WHEEL_DISTANCE, the one message of common with doubles."""
    folder = tmp_path_factory.mktemp("wheels")
    for path, text in codec_files("common", ["WHEEL_DISTANCE"], Report()).items():
        (folder / path).write_text(text, encoding="utf-8")
    return folder


@pytest.fixture(scope="module", params=["cpython", "micropython", "single floats"])
def answers(request: pytest.FixtureRequest, codec: Path) -> Answers:
    """Return the codec's answers to FRACTIONS with floats of 64 bits, and with a board's integers and floats of 32."""
    commands = {
        "cpython": [sys.executable],
        "micropython": [str(MICROPYTHON), "-X", "heapsize=64m"],
        "single floats": [str(MICROPYTHON32), "-X", "heapsize=64m"],
    }
    modules = [*([SINGLE_FLOATS] if request.param == "single floats" else []), codec]
    variable = "PYTHONPATH" if request.param == "cpython" else "MICROPYPATH"
    done = subprocess.run(
        [*commands[request.param], str(CHECKS)],
        input=json.dumps([[str(one.numerator), str(one.denominator)] for one in FRACTIONS]),
        env=os.environ | {variable: os.pathsep.join(map(str, modules))},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    told, errors, has_single_floats = json.loads(done.stdout)
    assert has_single_floats is (request.param == "single floats")
    return told, errors, has_single_floats


def test_each_fraction_becomes_the_nearest_double(answers: Answers) -> None:
    """CPython's division of whole numbers rounds once; beyond the largest double it raises."""
    for fraction, told in zip(FRACTIONS, answers[0], strict=True):
        try:
            nearest = fraction.numerator / fraction.denominator
        except OverflowError:
            assert told == [f"WHEEL_DISTANCE.distance cannot carry {fraction.numerator} / {fraction.denominator}"]
            continue
        payload = struct.pack("<d", nearest).hex()
        assert told[0] == payload, fraction
        assert told[1] == (payload if fraction.denominator == 1 else "00" * 8), fraction
        assert [int(part) for part in told[2]] == list(nearest.as_integer_ratio())


def test_what_no_float_of_the_board_is_near_reads_as_a_whole_number(answers: Answers) -> None:
    """Never as infinity; everything else is the nearest float that the interpreter has."""
    told, _, has_single_floats = answers
    whole = 0
    for one in told:
        if len(one) == 1:
            continue
        (exact,) = struct.unpack("<d", bytes.fromhex(one[0]))
        # 2 ** 128 - 2 ** 103 is half a step above the largest float of 32 bits.
        if has_single_floats and abs(exact) >= 2**128 - 2**103:
            whole += 1
            assert (one[3], int(one[4])) == ("int", int(exact))
        else:
            assert one[3] == "float"
            smallest = 2**-149 if has_single_floats else 5e-324
            assert abs(Fraction(float(one[4])) - Fraction(exact)) <= max(smallest, abs(Fraction(exact)) / 2**24)
    assert bool(whole) is has_single_floats


def test_errors_name_the_field(answers: Answers) -> None:
    """A number that is not finite is no fraction; a refused one changes nothing."""
    read, written = answers[1]
    assert read == [
        *["WHEEL_DISTANCE.distance is not finite"] * 3,
        "(0, 1)",
        "WHEEL_DISTANCE.distance has no element 16",
        "WHEEL_DISTANCE.distance has no element -1",
        "WHEEL_DISTANCE.count has no double",
        "WHEEL_DISTANCE has no field distanc; did you mean distance?",
    ]
    assert [text.partition(" 1")[0].partition(" -1")[0] for text in written] == [
        "WHEEL_DISTANCE.distance cannot carry"
    ] * 5


def test_only_messages_with_doubles_bring_the_module() -> None:
    """Everybody else's boards have no room for it."""
    names = codec_files("common", ["BATTERY_STATUS", "ATTITUDE"], Report())
    assert "doubles.py" not in names
    assert "doubles" not in names["fields.py"]


SET = """
from wide import floating
from words import Component

class Wheels(Component):
    NAME = "wheels"
    SIZE = 4
    distance = floating(0, 4, "distance")

wheels = Wheels()
wheels._log = lambda _: None
for value in (16777217, -(10**39), -(2**1024), 0.5, 2**1024):
    wheels.distance = value
    bits = 0
    for word in reversed(wheels.words):
        bits = bits << 16 | word
    print(bits, type(wheels.distance).__name__)
"""


@pytest.mark.parametrize("floats", [64, 32])
def test_quantities_that_are_doubles_are_set_exactly(tmp_path: Path, floats: int) -> None:
    """A whole number becomes the nearest double, and what is beyond all of them the largest, in firmware too."""
    texts = runtime_files("", [], "doubles") | {
        f"{name}.py": copied(f"firmware/{name}.py") for name in ("wide", "words", "conversion")
    }
    texts["wide.py"] = with_doubles(texts["wide.py"])
    for path, text in texts.items():
        (tmp_path / path).write_text(text, encoding="utf-8")
    (tmp_path / "script.py").write_text(SET, encoding="utf-8")
    path = os.pathsep.join(map(str, [SINGLE_FLOATS, tmp_path] if floats == 32 else [tmp_path]))
    command = [str(MICROPYTHON32), str(tmp_path / "script.py")]
    environment = os.environ | {"MICROPYPATH": path}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found = [line.split() for line in done.stdout.splitlines()]
    expected = [16777217.0, -1e39, -sys.float_info.max, 0.5, sys.float_info.max]
    assert [struct.unpack("<d", struct.pack("<Q", int(bits)))[0] for bits, _ in found] == expected
    whole = "int" if floats == 32 else "float"
    assert [kind for _, kind in found] == ["float", whole, whole, "float", whole]
