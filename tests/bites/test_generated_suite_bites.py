"""The generated suite notices a fault in the generated firmware: each mutation below must make it fail."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]

MUTATIONS = [
    ("sentinel-of-temperature", "telemetry.py", "value = 32767 if value is None", "value = 32766 if value is None"),
    ("sentinel-of-unused-cells", "telemetry.py", "65534, 65535)", "65534, 0)"),
    ("collision-with-the-sentinel", "telemetry.py", "value = -2  #", "value = -1  #"),
    ("limit", "telemetry.py", "limited(value, 0, 100)", "limited(value, 0, 101)"),
    ("factor-of-the-adc", "state.py", "multiplier, 11, 136500)", "multiplier, 11, 136501)"),
    ("factor-of-volts", "state.py", "to_steps(value, 1000)", "to_steps(value, 1001)"),
    (
        "rounding",
        "conversion.py",
        "numerator + denominator // 2) // denominator\n\n\ndef s",
        "numerator) // denominator\n\n\ndef s",
    ),
    ("field-order", "telemetry.py", 'pack_into("<h", payload, 30, value)', 'pack_into("<h", payload, 8, value)'),
    ("constant", "telemetry.py", "# type: MAV_BATTERY_TYPE_LIPO", "+ 1  # type: MAV_BATTERY_TYPE_LIPO"),
    ("flag", "telemetry.py", "0x02 if battery.healthy", "0x02 if not battery.healthy"),
    ("crc-extra", "messages.py", "CRC_EXTRA = 154", "CRC_EXTRA = 155"),
    ("crc-start", "crc.py", "0xFFFF", "0xFFFE"),
    ("length", "messages.py", "BASE_LENGTH = 36", "BASE_LENGTH = 35"),
    ("truncation", "crc_plain.py", "payload[length - 1] == 0", "payload[length - 1] == 1"),
    ("samples", "board.py", "// 5", "// 4"),
    ("failed-readings", "state.py", "failures >= 5", "failures >= 6"),
    ("default-of-the-multiplier", "parameters.py", "batt_volt_mult = 39500", "batt_volt_mult = 39400"),
    ("default-rate", "parameters.py", "sr0_extra1 = 2", "sr0_extra1 = 3"),
    ("rounding-of-the-mean", "board.py", "(total + 2) // 5", "total // 5"),
    ("warning-threshold", "state.py", "> 13000", "> 12990"),
    ("period", "streams.py", "now_ms, 1000):", "now_ms, 950):"),
    ("burst", "streams.py", "due_ms = time.ticks_add(now_ms, period_ms)", "pass"),
    ("board-that-raises", "state.py", "            is_good = False\n", "            return\n"),
    ("age", "state.py", "> 1000:", "> 1001:"),
    ("time-limit", "board.py", "took > 2000", "took > 2010"),
]


def run_suite(folder: Path) -> subprocess.CompletedProcess[str]:
    """Run the generated suite of ``folder`` as a user does."""
    options = ["-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist"]
    command = [sys.executable, "-m", "pytest", *options, str(folder / "tests")]
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    return subprocess.run(command, capture_output=True, text=True, cwd=folder, env=environment, check=False)


def copy_of_generated(folder: Path) -> Path:
    """Copy the committed output."""
    return Path(shutil.copytree(ROOT / "generated", folder / "generated", ignore=shutil.ignore_patterns("__pycache__")))


def test_untouched_firmware_passes(tmp_path):
    """Without a mutation the copied suite is green: what fails below fails because of the mutation."""
    done = run_suite(copy_of_generated(tmp_path))
    assert done.returncode == 0, done.stdout[-2000:]


@pytest.mark.parametrize(("file", "old", "new"), [case[1:] for case in MUTATIONS], ids=[case[0] for case in MUTATIONS])
def test_mutation_is_caught(file, old, new, tmp_path):
    """One change in the firmware, and the suite fails with a failed test (not with an error of the tests)."""
    generated = copy_of_generated(tmp_path)
    path = generated / "firmware" / file
    text = path.read_text()
    assert old in text, f"{old!r} is not in {file}"
    path.write_text(text.replace(old, new, 1))
    done = run_suite(generated)
    assert done.returncode == 1, done.stdout[-2000:]
    assert " failed" in done.stdout
