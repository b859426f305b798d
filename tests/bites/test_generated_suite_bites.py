"""The generated suite notices a fault in the generated firmware: each mutation below makes its part of it fail."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import run_suite, suite_is_green

ROOT = Path(__file__).resolve().parents[2]

FRAMES = "tests/test_frames.py"
BEHAVIOUR = "tests/test_behaviour.py"

WRONG_FRAMES = [
    ("sentinel-of-temperature", "telemetry_plain.py", "value = 32767 if", "value = 32766 if"),
    ("sentinel-of-temperature-in-machine-code", "telemetry_viper.py", "value = 32767 if", "value = 32766 if"),
    ("sentinel-of-unused-cells", "telemetry_viper.py", "wire16[14] = 65535", "wire16[14] = 0"),
    ("collision-with-the-sentinel", "telemetry_plain.py", "value = -2  #", "value = -1  #"),
    ("collision-with-the-sentinel-in-machine-code", "telemetry_viper.py", "value = -2  #", "value = -1  #"),
    ("upper-limit", "telemetry_viper.py", "value > 100:\n        value = 100\n", "value > 101:\n        value = 101\n"),
    ("lower-limit", "telemetry_plain.py", "_UNKNOWN else -32768", "_UNKNOWN else -32767"),
    ("limit-of-a-cell", "telemetry_viper.py", "while value > 65534 and", "while value > 65535 and"),
    ("spilling", "telemetry_viper.py", "value -= 65534", "value -= 65535"),
    ("spilling-in-plain-python", "telemetry_plain.py", "value -= 65534", "value -= 65535"),
    (
        "word-of-another-quantity",
        "telemetry_viper.py",
        "_BATTERY_CURRENT_CA = const(1)",
        "_BATTERY_CURRENT_CA = const(2)",
    ),
    ("words-of-another-instance", "telemetry_plain.py", "_BATTERY_SIZE * instance", "_BATTERY_SIZE * 0"),
    (
        "sign-of-a-word",
        "telemetry_viper.py",
        "(battery[_BATTERY_CURRENT_CA] ^ sign) - sign",
        "battery[_BATTERY_CURRENT_CA]",
    ),
    ("factor-of-the-adc", "state_plain.py", "// 136500 * 11 +", "// 136500 * 10 +"),
    ("factor-of-the-adc-in-machine-code", "state_viper.py", "// 136500 * 11 +", "// 136500 * 10 +"),
    ("factor-of-volts", "state.py", '"voltage", 1000)', '"voltage", 1001)'),
    ("rounding", "state_viper.py", " + 68250) //", ") //"),
    ("constant", "telemetry_plain.py", "wire[34] = 1", "wire[34] = 2"),
    ("place-of-a-constant", "telemetry_viper.py", "wire[33] = 1", "wire[35] = 1"),
    ("wide-constant", "telemetry_viper.py", "wire32[4] = 16777216", "wire32[4] = 16777217"),
    ("what-is-cleared", "telemetry_viper.py", "wire32[9] = 0", "wire32[8] = 0"),
    (
        "flag",
        "telemetry_plain.py",
        "value != _UNKNOWN:\n        wire[11] |=",
        "value == _UNKNOWN:\n        wire[11] |=",
    ),
    ("flag-of-a-boolean", "telemetry_viper.py", "flags |= 0x80\n    wire[6]", "flags |= 0x40\n    wire[6]"),
    ("frame-of-another-message", "telemetry_viper.py", "frame[9] = 147", "frame[9] = 148"),
    ("crc-extra-in-machine-code", "telemetry_viper.py", "value ^ 154)", "value ^ 155)"),
    ("link-that-is-too-short", "sender.py", "else bytes(1)", "else None"),
    ("crc-extra", "messages.py", "CRC_EXTRA = 154", "CRC_EXTRA = 155"),
    ("crc-start", "frames_plain.py", "crc = 0xFFFF", "crc = 0xFFFE"),
    ("crc-start-in-machine-code", "frames_viper.py", "high[0xFF ^ length]", "high[0xFE ^ length]"),
    ("base-length", "messages.py", "BASE_LENGTH = 36", "BASE_LENGTH = 35"),
    ("truncation", "frames_plain.py", "data[3] - 1] == 0", "data[3] - 1] == 1"),
    ("truncation-in-machine-code", "frames_viper.py", "while last[0] == 0", "while last[0] == 1"),
    ("checksum-in-machine-code", "frames_viper.py", "last[1] = crc >> 8", "last[1] = crc >> 7"),
    ("table", "checksum.py", "0xFF)] ^ (TABLE[256 + _byte] >> 8)", "0xFF)]"),
    ("rounding-of-floats", "floats_plain.py", "(value + 1 + ((value >> 2) & 1)) >> 2", "value >> 2"),
    ("rounding-of-floats-in-machine-code", "floats_viper.py", "(value + 1 + ((value >> 2) & 1)) >> 2", "value >> 2"),
    ("divisor-of-a-float", "telemetry_viper.py", 'b"\\x00\\xfa', 'b"\\x00\\xfb'),
    ("unknown-float", "telemetry_viper.py", "wire16[1] = 0x7FC0", "wire16[1] = 0xFFC0"),
    ("samples", "samples_viper.py", "// 5", "// 4"),
]

WRONG_BEHAVIOUR = [
    ("length", "messages.py", "    LENGTH = 9", "    LENGTH = 8"),
    (
        "float-that-is-made",
        "floats_viper.py",
        "        top = 0\n",
        "        top = 0\n        made = [value]\n",
    ),
    ("failed-readings", "state_plain.py", "_FAILURES] >= 5", "_FAILURES] >= 6"),
    ("failed-readings-in-machine-code", "state_viper.py", "_FAILURES] >= 5", "_FAILURES] >= 6"),
    ("default-of-the-multiplier", "parameters.py", "batt_volt_mult = 39500", "batt_volt_mult = 39400"),
    ("default-rate", "parameters.py", "sr0_extra1 = 2", "sr0_extra1 = 3"),
    ("rounding-of-the-mean", "samples_plain.py", "(total + 2) // 5", "total // 5"),
    ("rounding-of-the-mean-in-machine-code", "samples_viper.py", "(total + 2) // 5", "total // 5"),
    ("warning-threshold", "state_plain.py", "> 13000", "> 12990"),
    ("warning-threshold-in-machine-code", "state_viper.py", "> 13000", "> 12990"),
    (
        "period",
        "streams.py",
        "self._numerator = 1000\n            self._denominator = 1\n",
        "self._numerator = 950\n            self._denominator = 1\n",
    ),
    ("burst", "streams.py", "due_ms = time.ticks_add(now_ms, parts // self._denominator)", "pass"),
    ("board-that-raises", "reading_turns.py", "words[count] = -1\n", "words[count] = 3000\n"),
    ("age", "state_plain.py", "now_ms - 1073740824", "now_ms - 1073740823"),
    ("age-in-machine-code", "state_viper.py", "now_ms - 1073740824", "now_ms - 1073740823"),
    ("reading-that-is-kept", "telemetry_viper.py", "battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN", "pass"),
    ("time-limit", "samples_plain.py", "us > 2000", "us > 2010"),
    ("time-limit-in-machine-code", "samples_viper.py", "took > 2000", "took > 2010"),
    (
        "failed-reading-of-the-board",
        "adc_inputs.py",
        "return self.tell(instance, took)",
        "return 0 * self.tell(instance, took)",
    ),
    ("told-again-and-again", "words.py", "if place not in self.beyond:", "if True:"),
    ("right-again", "words.py", "self.beyond.pop(place, None)", "self.beyond.get(place)"),
    ("limit-of-a-quantity", "state.py", '65534, "voltage"', '65535, "voltage"'),
    ("failure-that-is-over", "samples_plain.py", "failures[instance] = 0", "pass"),
    ("failure-that-is-over-in-machine-code", "samples_viper.py", "failures[instance] = 0", "pass"),
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


def mutated(folder: Path, file: str, old: str, new: str) -> tuple[Path, tuple[str, ...]]:
    """A copy with one change in its firmware, and the interpreters that run that form of it."""
    generated = copy_of_generated(folder)
    path = generated / "firmware" / file
    text = path.read_text()
    assert old in text, f"{old!r} is not in {file}"
    path.write_text(text.replace(old, new, 1))
    forms = {"_viper": ("micropython",), "_plain": ("cpython",)}
    return generated, forms.get(path.stem[-6:], ("cpython", "micropython"))


def answers(generated: Path, interpreter: str) -> str:
    """What the firmware makes of all cases, as the suite asks for it."""
    ask = "import sys; from interpreters import CASES, run_under; "
    ask += "print(run_under(sys.argv[1], 'runner.py', str(CASES), heap='64m'))"
    command = [sys.executable, "-c", ask, interpreter]
    done = subprocess.run(command, cwd=generated / "tests", capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-2000:]
    return done.stdout


@pytest.fixture(scope="module")
def untouched() -> dict[str, str]:
    """The answers of the committed firmware, by interpreter."""
    return {interpreter: answers(ROOT / "generated", interpreter) for interpreter in ("cpython", "micropython")}


@pytest.mark.parametrize(("file", "old", "new"), [pytest.param(*case[1:], id=case[0]) for case in WRONG_FRAMES])
def test_another_answer_is_given(file, old, new, tmp_path, untouched):
    """One change in the firmware, and it answers a case otherwise; the suite holds each answer to pymavlink's, exactly.

    That the committed firmware's answers are the right ones, and that another one fails, is shown beside this.
    """
    generated, interpreters = mutated(tmp_path, file, old, new)
    assert any(answers(generated, interpreter) != untouched[interpreter] for interpreter in interpreters)


@pytest.mark.parametrize(
    ("part", "file", "old", "new"),
    [
        pytest.param(part, *case[1:], id=case[0])
        for part, cases in ((FRAMES, WRONG_FRAMES[-1:]), (BEHAVIOUR, WRONG_BEHAVIOUR))
        for case in cases
    ],
)
def test_mutation_is_caught(part, file, old, new, tmp_path):
    """One change in the firmware, and the suite fails with a failed test (not with an error of the tests)."""
    generated, interpreters = mutated(tmp_path, file, old, new)
    ran = ("-k", interpreters[0]) if len(interpreters) == 1 else ()
    done = run_suite(generated, part, options=("-x", *ran))
    assert done.returncode == 1, done.stdout[-2000:]
    assert " failed" in done.stdout
