"""What a user can get wrong about cells, pages, limits that booleans follow, and messages about one of several."""

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


STATUS, SYS, CELLS = (f"messages/{name}.yaml" for name in ("battery_status", "sys_status", "battery_cell_voltages"))
EXTENDED = "voltages_ext: {each: battery.cells, from: 10,"
WHOLE = "{each: battery.cells, state: battery.voltage, split: true,"

CASES = [
    Case("bad-elements", "state.yaml", "elements: cells", "elements: §cell", "did you mean cells"),
    Case("bad-elements", "state.yaml", "elements: cells", "elements: §chemistry", "not a whole number"),
    Case("bad-elements", "state.yaml", "elements: cells", "elements: cells\n        initial: §3", "no initial"),
    Case("bad-following", "state.yaml", "follows: current", "follows: §curent", "did you mean current"),
    Case("bad-following", "state.yaml", "follows: current", "follows: §cells", "not a single number"),
    Case("bad-following", "state.yaml", "follows: current", "follows: §monitored", "not a single number"),
    Case("bad-following", "state.yaml", "        below: 0\n", "        below: 0\n        at_least: 1\n", "both limits"),
    Case("bad-following", "state.yaml", "        below: 0\n", "", "no limit"),
    Case("bad-following", "state.yaml", "        below: 0\n", "        below: §0.001\n", "whole number"),
    Case(
        "bad-quantity", "state.yaml", "follows: current", "initial: true\n        follows: §current", "without initial"
    ),
    Case("bad-source", STATUS, WHOLE, "{state: §battery.cells, split: true,", "each: battery.cells"),
    Case("bad-each", STATUS, WHOLE, "{each: battery.cells, state: §battery.voltage,", "split: true"),
    Case("bad-each", STATUS, WHOLE, "{each: §battery.voltage, state: battery.voltage, split: true,", "one value"),
    Case("bad-each", STATUS, EXTENDED, "voltages_ext: {each: battery.cells, from: 9,", "from: 10"),
    Case("bad-each", STATUS, EXTENDED, "voltages_ext: {each: battery.cells, from: §-1,", "from is -1"),
    Case("pointless-key", SYS, "load: {state: vehicle.load}", "load: {state: vehicle.load, from: §2}", "without each"),
    Case("pointless-key", STATUS, EXTENDED, "voltages_ext: {each: battery.cells, split: §true, from: 10,", "split"),
    Case("bad-pages", CELLS, "pages: battery.cells", "pages: §battery.voltage", "one value"),
    Case("bad-pages", CELLS, "pages: battery.cells\n", "", "no pages"),
    Case("bad-pages", CELLS, "{page: true, note", "{constant: 0, note", "tell the pages apart"),
    Case("bad-pages", CELLS, "voltages: {each: battery.cells}", "voltages: {unknown: true}", "no field takes"),
    Case("bad-each", CELLS, "voltages: {each: battery.cells}", "voltages: {each: battery.cells, from: §1}", "on pages"),
    Case("unclear-instance", SYS, "represents: {battery: {parameter: BATT_SYS_STATUS}}\n", "", "first: true"),
    Case(
        "bad-representation", SYS, "{parameter: BATT_SYS_STATUS}", "{parameter: §BATT_LOW_TIMER}", "number of a battery"
    ),
    Case("bad-representation", SYS, "{parameter: BATT_SYS_STATUS}", "{lowest: §healthy}", "single number"),
    Case("bad-representation", SYS, "{parameter: BATT_SYS_STATUS}", "{lowest: §remainin}", "did you mean remaining"),
    Case("bad-representation", SYS, "{battery: {parameter", "{batery: §{parameter", "did you mean battery"),
    Case("one-of-keys", SYS, "{parameter: BATT_SYS_STATUS}", "{first: true, §lowest: remaining}"),
    Case("bad-constant", SYS, "errors_comm: {constant: 0}", "errors_comm: {board: §unique_id}", "a text"),
]


@pytest.mark.parametrize("case", [pytest.param(case, id=f"{case.rule}-{index}") for index, case in enumerate(CASES)])
def test_fault_is_reported(case, tmp_path, capsys):
    """Each fault has its rule, at its place where the case marks one, and says what to do."""
    specs = tmp_path / "specs"
    shutil.copytree(ROOT / "specs", specs)
    path = specs / case.file
    text = path.read_text()
    assert text.count(case.old) >= 1, case.old
    changed = text.replace(case.old, case.new, 1)
    place = ""
    if "§" in case.new:
        before = changed[: changed.index("§")]
        place = f"{case.file}:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}"
    path.write_text(changed.replace("§", ""))
    code = main(["check", "--project", str(specs / "codegen.yaml")])
    said = capsys.readouterr()
    found = said.out + said.err
    assert code == 1, found
    lines = [line for line in found.splitlines() if f" {case.rule}: " in line]
    assert lines, found
    assert any(place in line for line in lines), found
    assert case.says in found, found
    assert "Traceback" not in found
