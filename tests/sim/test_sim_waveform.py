"""A battery of a scenario in the mocks: the same under both interpreters, and exact."""

import json
import os
import random
import subprocess
from fractions import Fraction
from pathlib import Path

import pytest

from codegen.model.scenario import Battery, Point, battery_data
from codegen.sim.process import Runtime, find_interpreter

MOCKS = Path(__file__).resolve().parents[2] / "templates" / "mocks"

SCRIPT = """
import json, sys
from waveform import Waveform
with open(sys.argv[1]) as file:
    data, times = json.load(file)
waveform = Waveform(data, 3300)
print(json.dumps([[waveform.millivolts(at), waveform.count(at)] for at in times]))
"""


def readings(tmp_path: Path, runtime: str, pack: Battery, times: list[int], seed: int = 1) -> list[list[int]]:
    """The true voltage and the count at each time."""
    interpreter = find_interpreter(Runtime(runtime))
    assert interpreter is not None
    script, data = tmp_path / "script.py", tmp_path / "data.json"
    script.write_text(SCRIPT)
    data.write_text(json.dumps([battery_data(pack, seed), times]))
    environment = {**os.environ, "MICROPYPATH": str(MOCKS), "PYTHONPATH": str(MOCKS), "PYTHONDONTWRITEBYTECODE": "1"}
    command = [interpreter, str(script), str(data)]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, timeout=60, check=True)
    found: list[list[int]] = json.loads(done.stdout)
    return found


def battery(points: list[tuple[int, int]], noise_mv: int = 0) -> Battery:
    return Battery(tuple(Point(*point) for point in points), noise_mv, 3_950_000)


@pytest.mark.parametrize("runtime", Runtime)
def test_voltage_and_counts_are_exact(tmp_path: Path, runtime: str) -> None:
    """Against exact arithmetic, forwards and backwards in time."""
    rolls = random.Random(5)
    points = [(0, 12_600), (1_000, 12_345), (1_000, 9_000), (77_777, 13_033), (90_000, 0), (99_000, 20_000)]
    times = [0, 1, 999, 1_000, 1_001, 89_999, 98_999, 99_000, 200_000, *(rolls.randrange(100_000) for _ in range(200))]
    for at_ms, (millivolts, count) in zip(times, readings(tmp_path, runtime, battery(points), times), strict=True):
        before = [point for point in points if point[0] <= at_ms][-1]
        after = next((point for point in points if point[0] > at_ms), before)
        share = Fraction(at_ms - before[0], after[0] - before[0] or 1)
        true = before[1] + share * (after[1] - before[1])
        assert abs(millivolts - true) <= Fraction(1, 2)
        full = Fraction(millivolts, 3300) / Fraction("3.95") * 4095
        assert abs(count - min(full, 4095)) <= Fraction(1, 2)


def test_noise_is_the_same_everywhere_and_within_its_limit(tmp_path: Path) -> None:
    times = list(range(0, 4_000, 2))
    quiet = battery([(0, 12_000)])
    noisy = battery([(0, 12_000)], noise_mv=100)
    first, again, other = (
        readings(tmp_path, runtime, noisy, times) for runtime in ("cpython", "cpython", "micropython")
    )
    assert first == again == other
    assert readings(tmp_path, "cpython", battery([(0, 12_000)], 100), times, seed=2) != first
    still = readings(tmp_path, "cpython", quiet, times[:1])[0][1]
    deviations = {count - still for _, count in first}
    most = 100 / 3.95 / 3300 * 4095 + 1
    assert max(deviations) <= most
    assert min(deviations) >= -most
    assert len(deviations) > 40
    assert abs(sum(count - still for _, count in first) / len(first)) < 2
    assert {millivolts for millivolts, _ in first} == {12_000}, "what is true has no noise"
