"""A pack of which voltage and current are measured, and a tank with a float: what was worked out by hand comes out.

What a count stands for: 3.3 V / 4095 are 0.80586 mV. Voltages times 5; amperes are 17 for each volt above 0.33 V;
percent are 40 for each volt above 0.4 V, and end at 0 and 100.
"""

import json
import subprocess
import sys
from fractions import Fraction
from math import floor
from pathlib import Path

import pytest
from in_process import build

HERE = Path(__file__).resolve().parent
BIN = Path(sys.executable).parent

# mV, cA, hundredths of a percent.
EXPECTED = {
    # 1.649597 V: 8.247985 V; 1.319597 * 17 = 22.433150 A; 1.249597 * 40 = 49.983883 %.
    "half": [8248, 2243, 4998],
    # 16.5 V; 410 counts are 0.330403 V, 0.006850 A; 496 are 0.399707 V, below empty.
    "no current": [16500, 1, 0],
    # -0.33 V * 17 = -5.61 A.
    "charging, empty": [0, -561, 0],
    # (3.3 - 0.33) * 17 = 50.49 A; 2.9 * 40 = 116 %.
    "full scale": [16500, 5049, 10000],
    # 3000 counts are 2.417582 V; 1000 are 0.805861 V, 16.234432 %.
    "one fails": [12088, 5049, 1623],
    "and again": [12092, 5049, None],
    "for the fourth time": [12088, None, 8070],
    # 0.805861 - 0.33 = 0.475861 V: 8.089634 A.
    "and comes back": [12088, 809, 8070],
    # (0.805861 - 1.65) * -20 = 16.882784 A.
    "the other way round, from the middle, at once": [12088, 1688, 8070],
    # The sum of the cells is the voltage: what is estimated of it and what warns of it see no other one.
    "full cells, and no ADC": [19000, 100, ["warning: the pack's voltage is above 15 V:"]],
    "cells, and an ADC that shows more": [16500, 86, []],
    "other cells, and an ADC that shows more": [12000, 60, []],
    "cells that rise, and no ADC": [12330, 300],  # 30 mV in 100 ms
    "ADC alone": [12088, 61, []],
    # Two failures would make it unknown, or 2 s, whichever comes first: no message was built meanwhile.
    "one fails, and the last one is too old": [12088, 1688, None],
    "voltage only": [12088, None, 8070],
    "nothing of the pack": [None, None, 8070],
    # What code sets is a reading, with what is estimated of it, though no channel is read; None is none of either.
    "code sets": [[12000, 60], [None, None], [12000, 60], [None, None]],
    # 3300 mAh at 0.01 A and, less 5, at 0.06 A: the mean of a minute comes up to what is drawn, to the last step.
    "next to nothing": [1, 3300, 1000000],
    "a little more, for five minutes": [6, 3295, 197700],
}


CELLS = (
    ("board.yaml", "facts:", "curves:\n  pack: {points: {9 V: 0, 12 V: 60, 19 V: 100}}\nfacts:"),
    ("state.yaml", "over: 1 s", "over: 60 s"),
    ("parameters.yaml", "max: 4, step: 1, values: {", "max: 29, step: 1, values: {29: Code, "),
    (
        "parameters.yaml",
        "  BATT_VOLT_PIN:",
        "  BATT_VOLT_USED: {doc: d, default: 1, min: 0, max: 1, step: 1, reboot: true}\n  BATT_VOLT_PIN:",
    ),
    (
        "board.yaml",
        "multiplier: BATT_VOLT_MULT, samples",
        "multiplier: BATT_VOLT_MULT, when: {BATT_VOLT_USED: 1}, samples",
    ),
    (
        "state.yaml",
        "stale_after: 1 s}",
        "stale_after: 1 s, prefers: cells, warn_above: 15, warn_every: 10 s,\n"
        "         set_at: {BATT_MONITOR: 29}, set_stale_after: 1 s}\n"
        "      cells: {doc: Of its cells., unit: V, stored: mV, elements: cells, stale_after: 5 s}\n"
        '      guess: {doc: Of the charge., unit: "%", min: 0, max: 100, estimate_from: voltage, curve: pack}\n'
        "      trend: {doc: Of the voltage., unit: V/s, stored: mV/s, trend_of: voltage, window: 1 s}",
    ),
)
"""A pack whose cells another system may tell, and a mean over a minute: file, what stands there, and what does then."""


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project, built."""
    folder = tmp_path_factory.mktemp("power") / "monitor"
    subprocess.run(["cp", "-r", str(HERE / "power_monitor"), str(folder)], check=True)
    for name, old, new in CELLS:
        path = folder / "specs" / name
        path.write_text(path.read_text().replace(old, new, 1))
    build(folder)
    return folder


@pytest.mark.parametrize("interpreter", ["micropython", "micropython32", "python"])
def test_what_was_measured_is_kept(project: Path, interpreter: str) -> None:
    """In machine code, and in plain Python with words of 32 bits and under CPython."""
    done = subprocess.run(
        [str(BIN / interpreter), "voyage.py"], cwd=project, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == EXPECTED


def test_with_words_of_32_bits_nothing_is_allocated(project: Path) -> None:
    """The checks of single readings, over all counts with the factors that make the largest numbers."""
    script = """
import json, sys
sys.path[:0] = ["generated/firmware", "generated/mocks", "generated/tests"]
import behaviour
checks = [check for _, check in behaviour.CHECKS if "pack_current_" in check.__name__ or "tank_" in check.__name__]
print(json.dumps({check.__name__: behaviour.outcome(check) for check in checks}))
"""
    (project / "on_32_bits.py").write_text(script)
    command = [str(BIN / "micropython32"), "on_32_bits.py"]
    done = subprocess.run(command, cwd=project, capture_output=True, text=True, check=False)
    found = json.loads(done.stdout)
    assert len(found) == 11
    assert set(found.values()) == {None}, found


STEPS_MS = (7, 100, 100, 1900, 20000, 59999, 60000, 60001, 40000, 3)
HALF = Fraction(1, 2)


def by_fractions(days: int) -> list[list[int]]:
    """Return the expected counts: exact sums of the rounded readings, each for the time since the one before.

    More than 60 s are a gap, and so are failures from the fourth on.
    """
    charge = energy = Fraction(0)
    number, turn, passed_ms, since_ms, failures, counted = 1, 0, 0, None, 0, []
    while len(counted) < days:
        number = (number * 1103 + 12345) % 65536
        passed_ms += STEPS_MS[number % 10]
        turn += 1
        if number % 13 == 0:
            failures += 1
            since_ms = None if failures >= 4 else since_ms
        else:
            failures = 0
            volts = floor(Fraction(3200 + number % 800, 4095) * 3300 * 5 + HALF)
            at_pin = Fraction(350 + number * 7 % 3700, 4095) * Fraction(33, 10) - Fraction(33, 100)
            amperes = floor(at_pin * 1700 + HALF)
            if since_ms is not None and passed_ms - since_ms <= 60000:
                hours = Fraction(passed_ms - since_ms, 3600000)
                charge += amperes * 10 * hours
                energy += Fraction(amperes, 100) * Fraction(volts, 1000) * hours * 36
            since_ms = passed_ms
        if passed_ms >= (len(counted) + 1) * 86400000:
            counted.append([turn, floor(charge + HALF), floor(energy + HALF)])
    return counted


@pytest.mark.parametrize(("interpreter", "days"), [("micropython", 30), ("micropython32", 3), ("python", 3)])
def test_what_is_counted_does_not_drift(project: Path, interpreter: str, days: int) -> None:
    """After every day charge and energy are the nearest to their exact sums, to the last mAh and hJ."""
    state = project / "specs" / "state.yaml"
    if "500 ms" in state.read_text():  # readings that may be a minute apart make a month short
        state.write_text(state.read_text().replace("stale_after: 500 ms", "stale_after: 60 s"))
        build(project)
    command = [str(BIN / interpreter), "days.py", str(days)]
    done = subprocess.run(command, cwd=project, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    counted = json.loads(done.stdout)
    assert [each[:3] for each in counted] == by_fractions(days)
    assert counted[0][1] > 1000
