"""Broken specifications: each is reported at its line and column, and generated/ stays as it was.

A case changes one file of the shipped specification: ``old`` becomes ``new``, in which ``§`` marks the place that the
diagnostic must point at (it is taken out before the file is written).
"""

import shutil
from dataclasses import dataclass
from pathlib import Path

import pytest

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Case:
    rule: str
    file: str
    old: str
    new: str
    says: str = ""
    exit_code: int = 1


BATTERY, SYS, HEARTBEAT = (f"messages/{name}.yaml" for name in ("battery_status", "sys_status", "heartbeat"))

CASES = [
    # a value that contradicts the dialect
    Case(
        "sentinel-contradiction",
        BATTERY,
        "voltages: {state: battery.voltage, split: true, ",
        "voltages: {constant: §0, ",
        "UINT16_MAX",
    ),
    Case(
        "sentinel-contradiction", BATTERY, "temperature: {state: battery.temperature, ", "temperature: {constant: §-1, "
    ),
    Case(
        "sentinel-as-constant",
        BATTERY,
        "temperature: {state: battery.temperature, ",
        "temperature: {constant: §32767, ",
    ),
    Case("no-sentinel", SYS, "load: {state: vehicle.load}", "load: §unknown", "corrections"),
    Case("no-sentinel", "state.yaml", "        max: 100\n        initial: 0", "        max: 100"),
    Case("unit-mismatch", BATTERY, "{state: battery.consumed, ", "{state: §battery.current, ", "current (A)"),
    Case("unit-mismatch", "state.yaml", "stored: cA", "stored: §mAh"),
    Case("constant-out-of-range", SYS, "drop_rate_comm: {constant: 0", "drop_rate_comm: {constant: §70000 c%", "65535"),
    Case("bad-constant", SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: §0.5}"),
    Case("bad-constant", SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: §none}"),
    Case("bad-amount", SYS, "drop_rate_comm: {constant: 0", "drop_rate_comm: {constant: §1 percent"),
    Case(
        "unknown-enum-entry",
        HEARTBEAT,
        "enum: MAV_TYPE_GROUND_ROVER",
        "enum: §MAV_TYPE_GROUND_ROVR",
        "did you mean MAV_TYPE_GROUND_ROVER",
    ),
    Case(
        "unknown-enum-entry",
        HEARTBEAT,
        "enum: MAV_TYPE_GROUND_ROVER",
        "enum: §MAV_STATE_STANDBY",
        "belongs to MAV_STATE",
    ),
    Case(
        "unknown-enum-entry",
        "board.yaml",
        "chemistry: MAV_BATTERY_TYPE_LIPO",
        "chemistry: MAV_BATTERY_TYPE_LEAD",
        "MAV_BATTERY_TYPE",
    ),
    Case(
        "unknown-enum",
        "state.yaml",
        "enum: MAV_STATE\n        initial: MAV_STATE_STANDBY",
        "enum: §MAV_STAT\n        initial: MAV_STATE_STANDBY",
    ),
    Case("not-an-enum-field", SYS, "errors_comm: {constant: 0}", "errors_comm: {enum: §MAV_STATE_STANDBY}"),
    Case(
        "not-an-enum-field", BATTERY, "mode: {enum: MAV_BATTERY_MODE_UNKNOWN, ", "mode: {flags: §[], ", "not a bitmask"
    ),
    Case(
        "not-a-boolean",
        SYS,
        "MAV_SYS_STATUS_SENSOR_BATTERY if battery.healthy",
        "MAV_SYS_STATUS_SENSOR_BATTERY if vehicle.mode",
    ),
    Case(
        "empty-limits",
        BATTERY,
        "battery_remaining: {state: battery.remaining, min: 0, max: 100",
        "battery_remaining: {state: battery.remaining, min: §101, max: 100",
    ),
    Case(
        "bad-source",
        BATTERY,
        "voltages: {state: battery.voltage, split: true, ",
        "voltages: {state: §battery.voltage, ",
        "split: true",
    ),
    Case(
        "bad-split",
        SYS,
        "voltage_battery: {state: battery.voltage}",
        "voltage_battery: {state: battery.voltage, split: §true}",
    ),
    Case("bad-source", HEARTBEAT, "custom_mode: {state: vehicle.mode}", "custom_mode: {state: §vehicle.armed}"),
    # elements
    Case(
        "answered-twice", BATTERY, "  voltages: {state", "  voltages[3]: unknown\n  §voltages: {state", "answered twice"
    ),
    Case("unanswered-field", SYS, "  errors_comm: {constant: 0}\n", "", "errors_comm"),
    Case(
        "unanswered-field",
        BATTERY,
        "  voltages_ext: {unknown: true, ",
        "  voltages_ext[0..2]: {unknown: true, ",
        "element 3",
    ),
    Case(
        "unknown-element",
        BATTERY,
        "  voltages_ext: {unknown: true, ",
        "  §voltages_ext[0..4]: {unknown: true, ",
        "0 to 3",
    ),
    Case("unknown-element", SYS, "  load: {", "  §load[0]: {"),
    Case("unknown-field", SYS, "  load: {", "  §laod: {", "did you mean load"),
    # references
    Case("unknown-message", SYS, "message: SYS_STATUS", "message: §SYS_STATS", "did you mean SYS_STATUS"),
    Case("unknown-stream", SYS, "stream: EXTENDED_STATUS", "stream: §EXTENDED_STATE"),
    Case("unknown-component", BATTERY, "for_each: battery", "for_each: §batery"),
    Case("bad-instance", BATTERY, "for_each: battery\n", "", "for_each"),
    Case("unknown-quantity", SYS, "load: {state: vehicle.load}", "load: {state: §vehicle.laod}", "vehicle.load"),
    Case("unknown-parameter", "streams.yaml", "parameter: SR0_EXTRA1", "parameter: §SR0_EXTRA2", "SR0_EXTRA1"),
    Case("unknown-adc", "state.yaml", "adc: battery_voltage", "adc: §batery_voltage"),
    Case("unknown-fact", BATTERY, "{board: battery.chemistry, ", "{board: §battery.chemstry, "),
    Case("unknown-fact", HEARTBEAT, "{dialect: version}", "{dialect: §versoin}"),
    Case("unknown-requirement", SYS, "requirement: FR-00068.9", "requirement: §FR-00068.99"),
    Case("unknown-requirement", SYS, "requirement: FR-00068.9", "requirement: §FR-00086"),
    Case("unknown-unit", "state.yaml", "unit: degC", "unit: §celsius"),
    # the vehicle
    Case("bad-adc", "board.yaml", "pin: BATT_VOLT_PIN", "gpio: §25"),
    Case("bad-adc", "board.yaml", "samples: 5", "samples: §0"),
    Case("bad-parameter", "parameters.yaml", "default: 3.95", "default: §13.95"),
    Case("bad-parameter", "parameters.yaml", "step: 0.0001", "step: §0"),
    Case("bad-stream", "streams.yaml", "    rate: 1 Hz\n    fastest: 50 Hz", "    fastest: 50 Hz"),
    Case("bad-time", "streams.yaml", "rate: 1 Hz", "rate: §0 Hz"),
    Case("bad-time", "streams.yaml", "rate: 1 Hz", "rate: §2 kHz"),
    Case("bad-amount", "streams.yaml", "rate: 1 Hz", "rate: §1e99999999 Hz"),
    Case("bad-time", "board.yaml", "read_limit: 2 ms", "read_limit: §0.1 us"),
    Case("bad-time", "state.yaml", "stale_after: 1 s", "stale_after: §90000 s"),
    Case("bad-stream", "parameters.yaml", "max: 50", "max: 5000"),
    Case("unknown-aspect", "board.yaml", "samples: FR-00066.2", "sample: §FR-00066.2"),
    Case("bad-quantity", "state.yaml", "max: 1000000", "max: §-1"),
    Case("bad-quantity", "state.yaml", "while_known: voltage", "while_known: voltage\n        initial: true"),
    Case("allocating-arithmetic", "parameters.yaml", "step: 0.0001", "step: 0.00001"),
    Case("bad-project", "codegen.yaml", "protocol: 2", "system_id: §0\nprotocol: 2"),
    Case("bad-project", "codegen.yaml", "protocol: 2", "protocol: §3"),
    Case("bad-project", "codegen.yaml", "output: ../generated", "output: §."),
    Case("bad-project", "codegen.yaml", "output: ../generated", "output: §.."),
    Case("bad-component", "state.yaml", "  vehicle:\n", "  §payload:\n"),
    Case("bad-quantity", "state.yaml", "      armed:\n", "      §lambda:\n"),
    Case("bad-quantity", "state.yaml", "      energy:\n", "      §voltage_mv: {doc: d}\n      energy:\n"),
    Case("bad-stream", "streams.yaml", "  EXTRA1:\n", "  §EXTRA-1:\n"),
    Case("bad-parameter", "parameters.yaml", "  SR0_EXTRA1:\n", "  §sr0_extra1:\n"),
    Case("bad-quantity", "state.yaml", "invalid_after: 5", "invalid_after: §0"),
    Case("bad-quantity", "state.yaml", "while_known: voltage", "while_known: §healthy"),
    Case(
        "pointless-key",
        BATTERY,
        "voltages: {state: battery.voltage, split: true, ",
        "voltages: {constant: 12.6 V, split: §true, ",
    ),
    Case("pointless-key", SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: 0, max: §3}"),
    Case("bad-project", "codegen.yaml", "component_id: MAV_COMP_ID_AUTOPILOT1", "component_id: §MAV_COMP_ID_ALL"),
    Case("not-an-enum-value", BATTERY, "  mode: {enum: MAV_BATTERY_MODE_UNKNOWN, ", "  §mode: {constant: 77, "),
    Case(
        "limit-beyond-field",
        SYS,
        "battery_remaining: {state: battery.remaining, min: 0, max: 100",
        "battery_remaining: {state: battery.remaining, min: 0, max: §300",
    ),
    Case(
        "limit-beyond-field",
        SYS,
        "battery_remaining: {state: battery.remaining, min: 0",
        "battery_remaining: {state: battery.remaining, min: §-1",
    ),
    Case("stale-before-update", "state.yaml", "stale_after: 1 s", "stale_after: §50 ms"),
    Case("bad-component", "state.yaml", "  vehicle:\n", "  §update_battery:\n"),
    Case(
        "corrected-twice",
        "dialects/corrections.yaml",
        "corrections:\n",
        "corrections:\n  §- {message: BATTERY_STATUS, field: time_remaining, set: {invalid: 7}, reason: r, source: s}\n".replace(
            "§", ""
        ),
    ),
    Case("unknown-dialect", "codegen.yaml", "dialect: common", "dialect: §comon", "did you mean common", 2),
]


def changed_copy(case: Case, folder: Path) -> tuple[Path, str | None]:
    """Copy the project with the change; return the changed file and the marked ``line:col``."""
    shutil.copytree(ROOT / "specs", folder / "specs")
    path = folder / "specs" / case.file
    text = path.read_text()
    assert text.count(case.old) >= 1, f"{case.old!r} is not in {case.file}"
    text = text.replace(case.old, case.new, 1)
    before, mark, after = text.partition("§")
    path.write_text(before + after)
    if not mark:
        return path, None
    return path, f"{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"


@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case.rule}-{case.file.rpartition('/')[2]}")
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    path, place = changed_copy(case, tmp_path)
    (tmp_path / "generated").mkdir()
    (tmp_path / "generated" / "keep.txt").write_text("as it was")
    monkeypatch.chdir(tmp_path)
    exit_code = main(["build"])
    out, err = capsys.readouterr()
    found = [line for line in out.splitlines() if f" {case.rule}: " in line]
    assert found, out + err
    if place is not None:
        assert any(line.startswith(f"{path.relative_to(tmp_path)}:{place}: error ") for line in found), (place, found)
    assert case.says in out
    assert exit_code == case.exit_code
    assert [item.name for item in (tmp_path / "generated").iterdir()] == ["keep.txt"]


def test_everything_is_reported_in_one_run(tmp_path, monkeypatch, capsys):
    """Faults in different files are all shown, ordered by place."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    wanted = []
    for case in (CASES[0], CASES[3], CASES[11], CASES[33], CASES[40]):
        path = tmp_path / "specs" / case.file
        path.write_text(path.read_text().replace(case.old, case.new.replace("§", ""), 1))
        wanted.append(case.rule)
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 1
    out = capsys.readouterr().out
    assert all(f" error {rule}: " in out for rule in wanted), out
    places = [line.split(" ")[0] for line in out.splitlines() if " error " in line and not line.startswith(" ")]
    assert places == sorted(places, key=lambda place: (place.split(":")[0], int(place.split(":")[1])))


FOLLOW_UPS = [
    ("board.yaml", "samples: 5", "samples: 0", "bad-adc"),
    ("state.yaml", "invalid_after: 5", "invalid_after: -3", "bad-quantity"),
    (BATTERY, "  voltages_ext: {unknown: true, ", "  voltages_ext[0..12]: {unknown: true, ", "unknown-element"),
    (SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: .nan}", "unusable-number"),
    (SYS, "errors_comm: {constant: 0}", "errors_comm: {constant: 0, unknown: true}", "one-of-keys"),
]


@pytest.mark.parametrize(("file", "old", "new", "rule"), FOLLOW_UPS, ids=[case[3] for case in FOLLOW_UPS])
def test_one_fault_is_one_finding(file, old, new, rule, tmp_path, monkeypatch, capsys):
    """What depends on something broken is not reported as well: the cause stands alone."""
    changed_copy(Case(rule, file, old, new), tmp_path)
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) in (1, 2)
    errors = [line for line in capsys.readouterr().out.splitlines() if ": error " in line]
    assert len({line.split(" error ")[1].split(":")[0] for line in errors}) == 1, errors
    assert f" error {rule}: " in errors[0]


def test_two_instances_with_one_id(tmp_path, monkeypatch, capsys):
    """Two batteries that receivers could not tell apart are an error; that one of them is never measured a warning."""
    changed_copy(Case("same-instance", "state.yaml", "instances: 1", "instances: 2"), tmp_path)
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 0
    assert " warning unmeasured-instance: " in capsys.readouterr().out
    table = tmp_path / "specs" / BATTERY
    table.write_text(table.read_text().replace("id: {state: battery.instance", "id: {constant: 0"))
    assert main(["check"]) == 1
    assert " error same-instance: " in capsys.readouterr().out
