"""The generated suite notices a fault in the generated firmware: each mutation below makes its part of it fail."""

import json
import shutil
from ast import literal_eval
from pathlib import Path

import pytest
from generated_suite import run_suite, scripts_of, suite_is_green
from whole_program import whole_program

ROOT = Path(__file__).resolve().parents[2]

SCRIPTS = scripts_of(ROOT / "generated" / "tests")

FRAMES = "tests/test_frames.py"
BEHAVIOUR = "tests/test_behaviour.py"

INTERPRETERS = ("cpython", "micropython")

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
        "_BATTERY_CURRENT_MA = const(1)",
        "_BATTERY_CURRENT_MA = const(2)",
    ),
    ("words-of-another-instance", "telemetry_plain.py", "_BATTERY_SIZE * instance", "_BATTERY_SIZE * 0"),
    (
        "sign-of-a-word",
        "telemetry_viper.py",
        "(battery[_BATTERY_CURRENT_MA] ^ sign) - sign",
        "battery[_BATTERY_CURRENT_MA]",
    ),
    ("factor-of-the-adc", "state_plain.py", "// 136500 * 11 +", "// 136500 * 10 +"),
    ("factor-of-the-adc-in-machine-code", "state_viper.py", "// 136500 * 11 +", "// 136500 * 10 +"),
    ("factor-of-volts", "state.py", "voltage 1000 ", "voltage 1001 "),
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
    ("truncation-in-machine-code", "frames_viper.py", "int(payload) + 1", "int(payload) + 2"),
    ("checksum-in-machine-code", "frames_viper.py", "last[1] = crc >> 8", "last[1] = crc >> 7"),
    ("table", "checksum.py", "0xFF)] ^ (TABLE[256 + _byte] >> 8)", "0xFF)]"),
    ("rounding-of-floats", "floats_plain.py", "(value + 1 + ((value >> 2) & 1)) >> 2", "value >> 2"),
    ("rounding-of-floats-in-machine-code", "floats_viper.py", "(value + 1 + ((value >> 2) & 1)) >> 2", "value >> 2"),
    ("divisor-of-a-float", "telemetry_viper.py", 'b"\\x00\\xfa', 'b"\\x00\\xfb'),
    ("unknown-float", "telemetry_viper.py", "wire16[1] = 0x7FC0", "wire16[1] = 0xFFC0"),
    ("samples", "samples_viper.py", "// 5", "// 4"),
]

WRONG_BEHAVIOUR = [
    ("length", "heartbeat_stream_keeps_its_rate", "messages.py", "    LENGTH = 9", "    LENGTH = 8"),
    (
        "float-that-is-made",
        "battery_steady_cycle_allocates_nothing",
        "floats_viper.py",
        "        top = 0\n",
        "        top = 0\n        made = [value]\n",
    ),
    (
        "failed-readings",
        "battery_repeated_failures_make_it_unknown",
        "state_plain.py",
        "_FAILURES] >= 5",
        "_FAILURES] >= 6",
    ),
    (
        "failed-readings-in-machine-code",
        "battery_repeated_failures_make_it_unknown",
        "state_viper.py",
        "_FAILURES] >= 5",
        "_FAILURES] >= 6",
    ),
    (
        "default-of-the-multiplier",
        "parameters_start_with_their_defaults",
        "parameters.py",
        "batt_volt_mult = 39500",
        "batt_volt_mult = 39400",
    ),
    ("default-rate", "parameters_start_with_their_defaults", "parameters.py", "sr0_extra1 = 2", "sr0_extra1 = 3"),
    ("rounding-of-the-mean", "battery_mean", "samples_plain.py", "(total + 2) // 5", "total // 5"),
    ("rounding-of-the-mean-in-machine-code", "battery_mean", "samples_viper.py", "(total + 2) // 5", "total // 5"),
    ("warning-threshold", "battery_high_value_warns_now_and_then", "state_plain.py", "> 13000", "> 12990"),
    (
        "warning-threshold-in-machine-code",
        "battery_high_value_warns_now_and_then",
        "state_viper.py",
        "> 13000",
        "> 12990",
    ),
    (
        "period",
        "heartbeat_stream_keeps_its_rate",
        "streams.py",
        "(FR-00068.8)\n            return 1000, 1\n",
        "(FR-00068.8)\n            return 950, 1\n",
    ),
    (
        "burst",
        "late_pass_sends_no_burst",
        "scan_plain.py",
        "times[at] = now_ms + period & _MASK  # a pass",
        "pass  # a pass",
    ),
    (
        "board-that-raises",
        "battery_broken_board_does_not_raise",
        "reading_turns.py",
        "words[count] = -1\n",
        "words[count] = 3000\n",
    ),
    ("age", "battery_old_reading_is_unknown", "state_plain.py", "now_ms - 1073740824", "now_ms - 1073740823"),
    (
        "age-in-machine-code",
        "battery_old_reading_is_unknown",
        "state_viper.py",
        "now_ms - 1073740824",
        "now_ms - 1073740823",
    ),
    (
        "reading-that-is-kept",
        "battery_old_reading_is_unknown",
        "telemetry_viper.py",
        "battery[_BATTERY_VOLTAGE_MV] = _UNKNOWN",
        "pass",
    ),
    ("time-limit", "battery_late_reading_keeps_the_last_value", "samples_plain.py", "us > 2000", "us > 2010"),
    (
        "time-limit-in-machine-code",
        "battery_late_reading_keeps_the_last_value",
        "samples_viper.py",
        "took > 2000",
        "took > 2010",
    ),
    (
        "failed-reading-of-the-board",
        "battery_failed_reading_keeps_the_last_value",
        "adc_inputs.py",
        "return self.tell(instance, took)",
        "return 0 * self.tell(instance, took)",
    ),
    (
        "told-again-and-again",
        "what_is_limited_is_counted_and_told_once",
        "words.py",
        "if place not in self.beyond:",
        "if True:",
    ),
    (
        "right-again",
        "what_is_limited_is_counted_and_told_once",
        "words.py",
        "self.beyond.pop(place, None)",
        "self.beyond.get(place)",
    ),
    (
        "limit-of-a-quantity",
        "what_is_limited_is_counted_and_told_once",
        "state.py",
        "0 65534 voltage 1000",
        "0 65535 voltage 1000",
    ),
    ("longest", "battery_readings_are_timed", "samples_plain.py", "us > counts[_LONGEST_US]", "not us"),
    ("longest-in-machine-code", "battery_readings_are_timed", "samples_viper.py", "[_LONGEST_US] = took", "[1] = 7"),
    ("mean", "battery_readings_are_timed", "samples_plain.py", "[_READINGS] += 1", "[_READINGS] += 2"),
    ("mean-in-machine-code", "battery_readings_are_timed", "samples_viper.py", "[_TOTAL_US] > _LONG", "[0] > 9"),
    (
        "failure-that-is-over",
        "battery_failed_reading_keeps_the_last_value",
        "samples_plain.py",
        "counts[_FAILURES] = 0",
        "pass",
    ),
    (
        "failure-that-is-over-in-machine-code",
        "battery_failed_reading_keeps_the_last_value",
        "samples_viper.py",
        "counted[_FAILURES] = 0",
        "pass",
    ),
]
"""The name of a case, the check that notices it, and what is replaced by what in which file."""


def copy_of_generated(folder: Path) -> Path:
    """Copy what the suite needs of the committed output."""
    shutil.copytree(ROOT / "specs" / "dialects", folder / "specs" / "dialects")  # the suite makes pymavlink's from them
    return whole_program(ROOT / "generated", folder / "generated")


@pytest.mark.parametrize("part", [FRAMES, BEHAVIOUR])
def test_untouched_firmware_passes(part, tmp_path):
    """Without a mutation the copied suite is green: what fails below fails because of the mutation."""
    suite_is_green(copy_of_generated(tmp_path), part)


@pytest.mark.parametrize(
    ("part", "file", "old", "new"), [(FRAMES, *WRONG_FRAMES[-1][1:]), (BEHAVIOUR, *WRONG_BEHAVIOUR[0][2:])]
)
def test_the_suite_fails(part, file, old, new, tmp_path):
    """With a mutation each part fails, and by a failed test (not by an error of the tests)."""
    generated = copy_of_generated(tmp_path)
    (generated / "firmware" / file).write_text(mutation(file, old, new))
    done = run_suite(generated, part, options=("-x",))
    assert done.returncode == 1, done.stdout[-2000:]
    assert " failed" in done.stdout


def mutation(file: str, old: str, new: str) -> str:
    """The text of a file of the firmware with one change."""
    text = SCRIPTS.path_of("firmware", file).read_text()
    assert old in text, f"{old!r} is not in {file}"
    return text.replace(old, new, 1)


@pytest.fixture
def mutated(tmp_path, monkeypatch):
    """Let one change of a file hide the committed file; returns the interpreters that run that form of it."""

    def change(file: str, old: str, new: str) -> tuple[str, ...]:
        (tmp_path / file).write_text(mutation(file, old, new))
        monkeypatch.setattr(SCRIPTS, "PATHS", [str(tmp_path), *SCRIPTS.PATHS])
        return {"_viper": ("micropython",), "_plain": ("cpython",)}.get(file[-9:-3], INTERPRETERS)

    return change


def answers(interpreter: str, cases: Path) -> str:
    """Return what the firmware makes of cases, as the suite asks for it."""
    return SCRIPTS.run_under(interpreter, "runner.py", str(cases), heap="64m")


@pytest.fixture(scope="module")
def asked(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Path]:
    """Files with an eighth of the suite's cases, in which most changes are seen, and with all."""
    whole = json.loads(SCRIPTS.CASES.read_text())
    eighth = {name: whole[name][::8] for name in ("messages", "conversions")}
    path = tmp_path_factory.mktemp("asked") / "eighth.json"
    path.write_text(json.dumps({**whole, **eighth}))
    return path, SCRIPTS.CASES


@pytest.fixture(scope="module")
def untouched(asked) -> dict[tuple[str, Path], str]:
    """The answers of the committed firmware, by interpreter and cases."""
    return {(interpreter, cases): answers(interpreter, cases) for interpreter in INTERPRETERS for cases in asked}


@pytest.mark.parametrize(("file", "old", "new"), [pytest.param(*case[1:], id=case[0]) for case in WRONG_FRAMES])
def test_another_answer_is_given(file, old, new, asked, untouched, mutated):
    """One change in the firmware, and it answers a case otherwise; the suite holds each answer to pymavlink's, exactly.

    That the committed firmware's answers are the right ones, and that another one fails, is shown beside this.
    """
    interpreters = mutated(file, old, new)
    assert any(answers(each, cases) != untouched[each, cases] for cases in asked for each in interpreters)


def outcome(interpreter: str, check: str, folder: Path) -> str | None:
    """Return the fault that a check of the suite finds, or None."""
    script = folder / "one_check.py"
    script.write_text("import behaviour, sys\nprint(repr(behaviour.outcome(getattr(behaviour, sys.argv[1]))))\n")
    return literal_eval(SCRIPTS.run_under(interpreter, script, check))


@pytest.fixture(scope="module")
def passing(tmp_path_factory) -> set[str]:
    """The checks named above that find nothing in the committed firmware, on any interpreter."""
    folder, named = tmp_path_factory.mktemp("untouched"), {case[1] for case in WRONG_BEHAVIOUR}
    return {name for name in named if not any(outcome(each, name, folder) for each in INTERPRETERS)}


@pytest.mark.parametrize(
    ("check", "file", "old", "new"), [pytest.param(*case[1:], id=case[0]) for case in WRONG_BEHAVIOUR]
)
def test_check_notices(check, file, old, new, tmp_path, passing, mutated):
    """One change in the firmware, and the check that is about it fails; a test of the suite fails with each check."""
    assert check in passing
    assert any(outcome(interpreter, check, tmp_path) for interpreter in mutated(file, old, new))
