"""The generated suite notices a sensor, a curve, a sum, a trend or a limit that is wrong: each change fails some cases.

The project beside this has monitors of both kinds as instances of one component, a receiver of satellites, pulses, and
curves that fall and rise. The cases that fail are named by their beginning.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from generated_suite import run_suite, suite_is_green
from in_process import build

PROJECT = Path(__file__).resolve().parent / "instruments"

OLDER = "warmth[_WARMTH_CHANGE_OLDER]"
WRITTEN = "pair[0] = value >> 8\n        pair[1] = value & 0xFF"
SWAPPED = "pair[1] = value >> 8\n        pair[0] = value & 0xFF"
LEFT = "]\n    if part < 0:"

CURVES = ("warmth.temp", "warmth.heat", "warmth.oil_heat", "tank.content")

FAULTS = [
    ("slope-of-a-curve", "curve", "(high[1] - low[1])", "(low[1] - high[1])", CURVES),
    ("steps-beside-a-curve", "curve", "// span\n", "// span + 60\n", CURVES),
    ("end-of-a-curve", "curve", "return curve[at - 1 if at else 0][1]", "return curve[0][1]", CURVES),
    ("point-of-a-curve", "state", "(900, 6000)", "(900, 6100)", ("warmth.temp",)),
    ("second-curve", "state", "_CURVE = ((300, 100)", "_CURVE = ((300, 60)", ("warmth.heat",)),
    ("curve-of-another-reading", "warmth_oil", "(1400, 7000)", "(900, 6000)", ("warmth.oil_heat",)),
    ("estimate-of-another-word", "warmth_oil", "[_WARMTH_OIL_HEAT_CDEGC] = ", "[_WARMTH_OIL_MV] = ", ("warmth.oil",)),
    (
        "sign-of-a-trend",
        "state_plain",
        f"value -= {OLDER}",
        f"value = {OLDER} - value",
        ("warmth.change",),
    ),
    (
        "sign-of-a-trend-in-machine-code",
        "state_viper",
        f"value -= ({OLDER} ^ sign) - sign",
        f"value = ({OLDER} ^ sign) - sign - value",
        ("warmth.change",),
    ),
    ("ten-times-the-charge", "sources", "part // 360000", "part // 36000", ("pack.consumed-1",)),
    ("sign-of-a-sum", "sources", "took = value * took", "took = -value * took", ("pack.consumed-1", "pack.energy-1")),
    ("ten-times-the-energy", "sources", " + part // 10000\n", " + part // 1000\n", ("pack.energy-1",)),
    ("part-of-the-energy", "sources", "part % 10000\n", "part % 1000\n", ("pack.energy-1",)),
    ("distance", "sources", "+ part // 100000\n", "+ part // 10000\n", ("path.distance",)),
    ("gap-that-counts", "sources", "if took > 3000 or", "if took > 9000 or", ("path.distance",)),
    (
        "sum-of-another-instance",
        "sources",
        "        _count_pack_current_2(",
        "        _count_pack_current_3(",
        ("pack.consumed-2",),
    ),
    (
        "what-is-left",
        "sources",
        f"_CONSUMED_MAH_1{LEFT}",
        f"_ENERGY_HJ_1{LEFT}",
        ("pack.consumed-1",),
    ),
    (
        "offset-of-an-ina226",
        "ina226",
        "values[0] = volts\n",
        "values[0] = volts + 7\n",
        ("pack.voltage-1", "pack.voltage-3", "load.volts"),
    ),
    (
        "sign-of-an-ina226",
        "ina226",
        "read_signed(_SHUNT)",
        "read(_SHUNT)",
        ("pack.current-1", "pack.current-3", "load.amps"),
    ),
    ("shift-of-an-ina219", "ina219", "volts >>= 3", "volts >>= 2", ("pack.voltage-2",)),
    ("sign-of-an-ina219", "ina219", "read_signed(_SHUNT)", "read(_SHUNT)", ("pack.current-2",)),
    (
        "order-of-bytes",
        "registers",
        "pair[0] << 8 | pair[1]",
        "pair[1] << 8 | pair[0]",
        ("pack.voltage", "pack.current"),
    ),
    (
        "order-of-written-bytes",
        "registers",
        WRITTEN,
        SWAPPED,
        ("pack.voltage", "pack.current"),
    ),
    ("address", "sources", "0x40, 2,", "0x44, 2,", ("pack.voltage-1", "pack.current-1")),
    ("address-of-another", "sources", "0x45, 11,", "0x40, 11,", ("pack.voltage-2", "pack.current-2")),
    ("bus-of-another", "sources", "machine.I2C(1,", "machine.I2C(0,", ("pack.voltage-3", "pack.current-3")),
    ("average", "sources", "0x40, 2,", "0x40, 3,", ("pack.voltage-1", "pack.current-1")),
    ("scale-of-a-current", "sources", "value // 3 + (value % 3 + 1) // 3", "value // 4", ("pack.current-1",)),
    (
        "count-of-pulses",
        "pulse",
        "[_COUNT] = pulses\n",
        "[_COUNT] = pulses * 2\n",
        ("pulses.l", "pulses.t"),
    ),
    ("frequency", "pulse", "for _ in range(9):", "for _ in range(8):", ("pulses.rate",)),
    (
        "width",
        "pulse",
        "self._edges[_FELL_US], self._edges[_ROSE_US]",
        "self._edges[_FELL_US], self._seen_us",
        ("pulses.width",),
    ),
    (
        "pin",
        "sources",
        "machine.Pin(16, machine.Pin.IN",
        "machine.Pin(15, machine.Pin.IN",
        ("pulses.turns", "pulses.width"),
    ),
    ("west-and-east", "sentences_plain", "words[field + 9] == 87:", "words[field + 9] == 69:", ("path.lon",)),
    ("half-of-a-longitude", "sources", "_LON_DEGE7 + 1] = values[4]", "_LON_DEGE7 + 1] = 0", ("path.lon",)),
    ("west-and-east-in-machine-code", "sentences_viper", "if east == 87:", "if east == 69:", ("path.lon",)),
    ("north-and-south", "sentences_plain", "words[field + 3] == 83", "words[field + 3] == 78", ("path.lat",)),
    ("kind-of-fix", "sources", "value = values[0]  # fix", "value = values[1]  # fix", ("path.fix",)),
    (
        "satellites",
        "sources",
        "value = values[1]  # satellites",
        "value = values[0]  # satellites",
        ("path.satellites",),
    ),
    ("altitude", "sources", "value = values[5]  # altitude", "value = values[6]  # altitude", ("path.alt",)),
    ("speed", "sources", "value = values[6]  # speed", "value = values[7]  # speed", ("path.speed",)),
    ("course", "sources", "value = values[7]  # course", "value = values[8]  # course", ("path.course",)),
    ("dilution", "sources", "value = values[8]  # hdop", "value = values[9]  # hdop", ("path.hdop",)),
    ("limit-in-whole-units", "state", " under_way: at_least 8 25", " under_way: at_least 8 0", ("path.under_way",)),
    ("other-limit-of-two", "state", " None -12500", " None -12", ("path.low",)),
    ("limit-of-steps", "state", " heavy: at_least 2 1000", " heavy: at_least 2 1", ("load.heavy",)),
    ("energy-of-steps", "sources", "+ part // 640000\n", "+ part // 64000\n", ("load.spent",)),
    ("charge-of-steps", "sources", "part // 2880000", "part // 2304000", ("load.used",)),
    (
        "shown",
        "state",
        "speed: aged_number 8 0 60000 speed 100",
        "speed: aged_number 8 0 60000 speed 10",
        ("path.speed",),
    ),
    ("mean-over-less", "sources", "- (part + 5) // 10", "- (part + 5) // 5", ("pack.consumed-1",)),
    ("sum-rounded-down", "sources", "[_PATH_DISTANCE_REST] = 50000", "[_PATH_DISTANCE_REST] = 0", ("path.distance",)),
    (
        "age-of-what-is-left",
        "sources",
        "words[_PACK_LEFT_MAH_EXPIRES_MS_1] = now_ms - 1073740824",
        "words[_PACK_LEFT_MAH_EXPIRES_MS_1] = now_ms - 1073640824",
        ("pack.consumed-1",),
    ),
    ("uart", "sources", "machine.UART(1,", "machine.UART(0,", ("path.lat", "path.speed")),
]
"""The name of a case, and what is replaced by what in which module."""


@pytest.fixture(scope="module")
def output(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project as it is built."""
    folder = Path(shutil.copytree(PROJECT, tmp_path_factory.mktemp("bites") / "instruments"))
    build(folder)
    return folder / "generated"


def failed(output: Path, *changed: Path, interpreter: str = sys.executable) -> set[str]:
    """The cases that fail; modules in ``changed`` go before those of the output."""
    path = os.pathsep.join(map(str, (*changed, *(output / name for name in ("firmware", "mocks", "tests")))))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": f"{path}:.frozen"}
    command = [interpreter, "amounts_run.py", "amounts.json"]
    done = subprocess.run(
        command, capture_output=True, text=True, env=environment, cwd=output / "tests", check=True, timeout=60
    )
    return {name for name, problem in json.loads(done.stdout).items() if problem is not None}


def test_untouched_firmware_passes(output: Path) -> None:
    """Without a change no case fails: what fails below fails because of the change."""
    suite_is_green(output, "tests/test_amounts.py")


def test_every_case_is_named(output: Path) -> None:
    """Each case of the project can fail: a change below is about it, or about the same of another instance."""
    cases = [case["name"] for case in json.loads((output / "tests" / "amounts.json").read_text())["cases"]]
    named = [name for fault in FAULTS for name in fault[4]]
    kinds = {case.partition("-")[0] for case in cases}
    assert {kind for kind in kinds if not any(kind.startswith(name.partition("-")[0]) for name in named)} == set()


def test_a_case_that_fails_is_a_failed_test(output: Path, tmp_path: Path) -> None:
    """What is wrong in a driver fails a test of the suite, by a failure and no error."""
    changed = Path(shutil.copytree(output, tmp_path / "generated"))
    driver = changed / "firmware" / "ina226.py"
    driver.write_text(driver.read_text().replace("values[0] = volts\n", "values[0] = volts + 7\n"))
    done = run_suite(changed, "tests/test_amounts.py")
    assert done.returncode == 1, done.stdout[-2000:]
    assert "6 failed" in done.stdout, done.stdout[-2000:]  # two of three monitors, one twice, on both interpreters


@pytest.mark.parametrize(("module", "old", "new", "cases"), [pytest.param(*case[1:], id=case[0]) for case in FAULTS])
def test_is_noticed(output: Path, tmp_path: Path, module: str, old: str, new: str, cases: tuple[str, ...]) -> None:
    """One change in the firmware, and of each of these cases one fails; what is in machine code is run as that."""
    right = (output / "firmware" / f"{module}.py").read_text()
    assert old in right
    (tmp_path / f"{module}.py").write_text(right.replace(old, new, 1))
    interpreter = str(Path(sys.executable).with_name("micropython")) if module.endswith("_viper") else sys.executable
    found = failed(output, tmp_path, interpreter=interpreter)
    assert [case for case in cases if not any(name.startswith(case) for name in found)] == [], found
