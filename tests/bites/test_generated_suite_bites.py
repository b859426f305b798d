"""The generated suite notices a fault in the generated firmware: each mutation below makes its part of it fail."""

import shutil
from pathlib import Path

import pytest
from generated_suite import run_suite, suite_is_green

ROOT = Path(__file__).resolve().parents[2]

FRAMES = "tests/test_frames.py"
BEHAVIOUR = "tests/test_behaviour.py"

WRONG_FRAMES = [
    ("sentinel-of-temperature", "telemetry.py", "value = 32767  # unknown", "value = 32766  # unknown"),
    ("sentinel-of-unused-cells", "telemetry.py", "65534, 65535)", "65534, 0)"),
    ("collision-with-the-sentinel", "telemetry.py", "value = -2  #", "value = -1  #"),
    ("upper-limit", "telemetry.py", "value > 100:\n        value = 100\n", "value > 101:\n        value = 101\n"),
    (
        "lower-limit",
        "telemetry.py",
        "value < -32768:\n        value = -32768",
        "value < -32767:\n        value = -32767",
    ),
    ("shortcut-past-the-spill", "telemetry.py", " or live[4] != 65535:", ":"),
    ("limit-of-a-cell", "telemetry.py", "value > 65534 or live[4]", "value > 65535 or live[4]"),
    ("spilling", "conversion.py", "value -= most", "value -= most + 1"),
    ("order-of-live-values", "telemetry.py", "live[13] = value", "live[2] = value"),
    (
        "order-of-live-fields",
        "telemetry.py",
        '"energy_consumed",\n            "temperature"',
        '"temperature",\n            "energy_consumed"',
    ),
    ("factor-of-the-adc", "state.py", "multiplier, 11, 136500)", "multiplier, 11, 136501)"),
    ("factor-of-volts", "state.py", "to_steps(value, 1000)", "to_steps(value, 1001)"),
    ("rounding", "conversion.py", "% denominator * numerator + denominator // 2) //", "% denominator * numerator) //"),
    ("constant", "telemetry.py", "wire[34] = 1  # type", "wire[34] = 2  # type"),
    ("place-of-a-constant", "telemetry.py", "wire[33] = 1  # battery_function", "wire[35] = 1  # battery_function"),
    ("wide-constant", "telemetry.py", '"<I", wire, 16, 16777216', '"<I", wire, 16, 16777217'),
    ("flag", "telemetry.py", "0x02 if battery.healthy", "0x02 if not battery.healthy"),
    ("flag-of-a-live-field", "telemetry.py", "0x80 if vehicle.armed", "0x40 if vehicle.armed"),
    ("crc-extra", "messages.py", "CRC_EXTRA = 154", "CRC_EXTRA = 155"),
    ("crc-start", "frames_plain.py", "crc = 0xFFFF", "crc = 0xFFFE"),
    ("crc-start-in-machine-code", "frames_viper.py", "high[0xFF ^ length]", "high[0xFE ^ length]"),
    (
        "field-order",
        "messages.py",
        "current_consumed:i=-1 energy_consumed:i=-1",
        "energy_consumed:i=-1 current_consumed:i=-1",
    ),
    ("type-of-a-field", "messages.py", "temperature:h=32767", "temperature:b=127"),
    ("base-length", "messages.py", "BASE_LENGTH = 36", "BASE_LENGTH = 35"),
    ("truncation", "frames_plain.py", "data[3] - 1] == 0", "data[3] - 1] == 1"),
    ("truncation-in-machine-code", "frames_viper.py", "while last[0] == 0", "while last[0] == 1"),
    ("live-values", "frames_plain.py", "value >>= 8", "value >>= 7"),
    ("live-values-in-machine-code", "frames_viper.py", "halves[place[0]] = live", "halves[place[1]] = live"),
    ("checksum-in-machine-code", "frames_viper.py", "last[1] = crc >> 8", "last[1] = crc >> 7"),
    ("table", "checksum.py", "0xFF)] ^ (TABLE[256 + _byte] >> 8)", "0xFF)]"),
    ("rounding-of-floats", "floats_plain.py", "(value + 1 + ((value >> 2) & 1)) >> 2", "value >> 2"),
    ("rounding-of-floats-in-machine-code", "floats_viper.py", "(value + 1 + ((value >> 2) & 1)) >> 2", "value >> 2"),
    ("unknown-float", "telemetry.py", 'pack_into("<f", wire, 0, NAN)', 'pack_into("<f", wire, 0, -NAN)'),
    ("samples", "board.py", "// 5", "// 4"),
]

WRONG_BEHAVIOUR = [
    ("length", "messages.py", "    LENGTH = 9", "    LENGTH = 8"),
    ("float-that-is-made", "telemetry.py", "put_float(wire, 0, value, 1000)", 'pack_into("<f", wire, 0, value / 1000)'),
    ("failed-readings", "state.py", "failures >= 5", "failures >= 6"),
    ("default-of-the-multiplier", "parameters.py", "batt_volt_mult = 39500", "batt_volt_mult = 39400"),
    ("default-rate", "parameters.py", "sr0_extra1 = 2", "sr0_extra1 = 3"),
    ("rounding-of-the-mean", "board.py", "(total + 2) // 5", "total // 5"),
    ("warning-threshold", "state.py", "> 13000", "> 12990"),
    (
        "period",
        "streams.py",
        "self._numerator = 1000\n            self._denominator = 1\n",
        "self._numerator = 950\n            self._denominator = 1\n",
    ),
    ("burst", "streams.py", "due_ms = time.ticks_add(now_ms, parts // self._denominator)", "pass"),
    ("board-that-raises", "state.py", "            return False\n", "            return True\n"),
    ("age", "state.py", "time.ticks_ms(), 1000)", "time.ticks_ms(), 1001)"),
    (
        "reading-that-is-kept",
        "state.py",
        "self.forget()\n            self.expires_ms = None",
        "self.expires_ms = None",
    ),
    ("time-limit", "board.py", "took > 2000", "took > 2010"),
    ("what-is-gone-is-not-back", "state.py", "if self.gone or not was_gone", "if self.gone"),
]

MUTATIONS = [
    pytest.param(part, *case[1:], id=case[0])
    for part, cases in ((FRAMES, WRONG_FRAMES), (BEHAVIOUR, WRONG_BEHAVIOUR))
    for case in cases
]


def copy_of_generated(folder: Path) -> Path:
    """Copy what the suite needs of the committed output."""
    shutil.copytree(ROOT / "specs" / "dialects", folder / "specs" / "dialects")  # the suite makes pymavlink's from them
    for name in ("firmware", "mocks", "tests"):
        shutil.copytree(
            ROOT / "generated" / name, folder / "generated" / name, ignore=shutil.ignore_patterns("__pycache__")
        )
    return folder / "generated"


@pytest.mark.parametrize("part", [FRAMES, BEHAVIOUR])
def test_untouched_firmware_passes(part, tmp_path):
    """Without a mutation the copied suite is green: what fails below fails because of the mutation."""
    suite_is_green(copy_of_generated(tmp_path), part)


@pytest.mark.parametrize(("part", "file", "old", "new"), MUTATIONS)
def test_mutation_is_caught(part, file, old, new, tmp_path):
    """One change in the firmware, and the suite fails with a failed test (not with an error of the tests)."""
    generated = copy_of_generated(tmp_path)
    path = generated / "firmware" / file
    text = path.read_text()
    assert old in text, f"{old!r} is not in {file}"
    path.write_text(text.replace(old, new, 1))
    done = run_suite(generated, part, options=("-x",))
    assert done.returncode == 1, done.stdout[-2000:]
    assert " failed" in done.stdout
