"""Monitors of voltage and current give a value after each conversion, however long their averages take."""

import json
import subprocess
import sys
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import pytest

from codegen.model.quantities.source_kind import Polling
from codegen.sources.i2c.monitor import Chip, Monitor, MonitorSpec
from codegen.sources.ina219.kind import CHIP as INA219
from codegen.sources.ina226.kind import CHIP as INA226
from codegen.sources.wires import Bus

ROOT = Path(__file__).resolve().parents[2]
BIN = Path(sys.executable).parent
FOLDERS = ("codegen/sources/i2c", "codegen/sources/ina219", "codegen/sources/ina226", "templates")

# The longest times of one conversion in us, by the data sheets: SBOS547A, 1.1 ms; SBOS448G, 12 bits.
LONGEST_US = {"ina226": 1210, "ina219": 586}

SCRIPT = """
import json, sys
sys.path[:0] = sys.argv[1:]
import mock_time
mock_time.install()
import machine, mock_i2c, sim_monitor, time
from ina219 import Ina219
from ina226 import Ina226
from polling import Poller

class Course:
    def __init__(self, output, value):
        self.settings = {"output": output, "steps": 1}
        self.value = value
    def seen(self, at_ms):
        return self.value
    def fault(self, kind, at_ms):
        return None

def turns(chip, made, period_us, count, is_stuck):
    mock_i2c.detach_all()
    outputs = {name: Course(name, 1000) for name in ("voltage", "current")}
    device = mock_i2c.attach(0, 0x40, sim_monitor.Monitor(chip, outputs, time.ticks_ms))
    kept, told = [], []
    keep = lambda words, values, now_ms: kept.append((now_ms, values[0]))
    log = lambda *words: told.append((time.ticks_ms(), ' '.join(map(str, words))))
    poller = Poller("power", eval(made), (None, keep, lambda words, failures: None), None, 1000, "", log)
    began_ms = time.ticks_ms()
    if is_stuck:
        device.conversion_ms = lambda: 1 << 28  # it does not convert
    for turn in range(count):
        poller.turn()
        mock_time.advance_us(period_us)
    return {name: [(at - began_ms, what) for at, what in each] for name, each in (("kept", kept), ("told", told))}

for line in open("cases.txt"):
    print(json.dumps(turns(*json.loads(line))))
"""


def monitor(chip: Chip, average: int, period_us: int) -> Monitor:
    spec = MonitorSpec.__new__(MonitorSpec)
    polling = Polling(None, {}, "power", period_us, None, 1000, spec)
    bus = Bus(0, 400000, 4, 5, frozenset(), frozenset(), "machine.I2C(0, freq=400000)")
    return Monitor(polling, chip, bus, 0x40, Fraction(1, 1000), average)


CASES = [
    (chip, average, period_us)
    for chip, averages in ((INA226, (1, 16, 128, 512, 1024)), (INA219, (1, 64, 128)))
    for average in averages
    for period_us in (2000, 10000, 40000, 100000, 1000000)
]


@pytest.mark.parametrize("interpreter", ["micropython", "python"])
def test_a_value_comes_as_often_as_the_data_sheet_says(tmp_path: Path, interpreter: str) -> None:
    """At each rate, with no failure; and one that converts no more is told, but not before its time."""
    cases, expected = [], []
    for chip, average, period_us in CASES:
        made = monitor(chip, average, period_us)
        for is_stuck in (False, True):
            count = 4 + 4 * made.renewed_us // period_us
            cases.append(json.dumps((chip.kind, made.opened, period_us, count, is_stuck)))
            expected.append((made, is_stuck))
    (tmp_path / "script.py").write_text(SCRIPT)
    (tmp_path / "cases.txt").write_text("\n".join(cases))
    paths = [str(ROOT / folder / part) for folder in FOLDERS for part in ("firmware", "mocks")]
    command = [str(BIN / interpreter), "script.py", *paths]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    for (made, is_stuck), line in zip(expected, done.stdout.splitlines(), strict=True):
        found, what = json.loads(line), (made.chip.kind, made.average, made.polling.period_us)
        longest_us = 2 * made.average * LONGEST_US[made.chip.kind]
        assert made.renewed_us % made.polling.period_us == 0
        assert longest_us <= made.renewed_us < longest_us + made.polling.period_us, what
        if not is_stuck:
            assert found["told"] == [], what
            times = [at for at, _ in found["kept"]]
            gaps = [later - earlier for earlier, later in pairwise(times)]
            assert times[0] * 1000 <= made.renewed_us + made.polling.period_us, what
            assert gaps, what
            assert max(gaps) * 1000 <= made.renewed_us, what
            assert {value for _, value in found["kept"]} == {1000}, what
        else:
            assert found["kept"] == [], what
            (after_ms, text), *_ = found["told"]
            assert text == "error: power: it does not convert", what
            assert after_ms * 1000 > longest_us, what
