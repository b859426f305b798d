"""MAVLink's documents on battery messages hold, as far as the generated suite leaves them open."""

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from generated_suite import suite_is_green
from in_process import build
from test_smart_battery import run
from whole_program import module_folders

ROOT = Path(__file__).resolve().parents[2]
CHECKED = 9
SYS_STATUS = "specs/messages/sys_status.yaml"
POLICY = "represents: {battery: {parameter: BATT_SYS_STATUS}}"


def check(generated: Path, interpreter: str, cells: int) -> None:
    """Run the checks on the rover's program in a folder."""
    folders = map(str, module_folders(generated, "firmware", "mocks", "tests"))
    outcomes = json.loads(run(interpreter, folders, "protocol_checks.py", str(cells), seconds=200))
    assert len(outcomes) == CHECKED
    assert {name: outcome for name, outcome in outcomes.items() if outcome is not None} == {}


def built(folder: Path, *changes: tuple[str, str, str]) -> Path:
    """The shipped project with changes (file, old, new), built; its generated files."""
    shutil.copytree(ROOT / "specs", folder / "specs")
    for file, old, new in changes:
        text = (folder / file).read_text()
        assert text.count(old) == 1
        (folder / file).write_text(text.replace(old, new))
    build(folder)
    return folder / "generated"


def frames_are_green(folder: Path, selection: str) -> None:
    """Run the frames of one message in the suite of a project, against pymavlink."""
    suite_is_green(folder, "generated/tests/test_frames.py", only=selection)


@pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")
@pytest.mark.requirement(
    "FR-00074.8", "FR-00076.7", "FR-00076.8", "FR-00072.1", "FR-00072.4", "FR-00072.6", "FR-00068.9", "FR-00077.6"
)
@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_the_rover_reports_its_batteries(interpreter: str) -> None:
    """Ids, cells, sizes, amounts."""
    check(ROOT / "generated", interpreter, 3)


@pytest.mark.draft("battery_upstream", "battery_cell_voltages_rfc_0018")
@pytest.mark.requirement("FR-00076.7", "FR-00068.3")
@pytest.mark.parametrize(("cells", "interpreter"), [(14, "cpython"), (28, "micropython")])
def test_cells_of_a_large_pack(cells: int, interpreter: str, tmp_path: Path) -> None:
    """14 cells are what BATTERY_STATUS has room for, and two pages; 28 are three pages.

    Behind a divider of its own: one that shows less than 1 V of each cell would be no pack at all.
    """
    divider = ("specs/parameters.yaml", "    default: 3.95\n", "    default: 10\n")
    generated = built(tmp_path, ("specs/board.yaml", "    cells: 3\n", f"    cells: {cells}\n"), divider)
    check(generated, interpreter, cells)
    frames_are_green(tmp_path, "BATTERY_STATUS or BATTERY_CELL_VOLTAGES")


def shown(case: dict[str, Any], policy: str) -> tuple[int, int]:
    """By hand: voltage and charge of the battery that a case of SYS_STATUS has to show."""
    packs: dict[int, dict[str, Any]] = {0: {}, 1: {}}
    for component, name, value, *instance in case["set"]:
        if component == "battery":
            packs[instance[0] if instance else 0][name] = value
    candidates = [packs[0]]
    if policy == "lowest: remaining":
        on = [pack for pack in packs.values() if pack["monitored"]]
        known = [pack for pack in on if pack["remaining_pct"] is not None]
        candidates = sorted(known, key=lambda pack: pack["remaining_pct"]) or on or candidates
    pack = candidates[0]
    return pack["voltage_mv"], -1 if pack["remaining_pct"] is None else pack["remaining_pct"]


@pytest.mark.requirement("FR-00073.6")
@pytest.mark.parametrize("policy", ["first: true", "lowest: remaining"])
def test_which_battery_sys_status_shows(policy: str, tmp_path: Path) -> None:
    """The other two policies that a table can declare, the first one or the one with the least charge."""
    generated = built(tmp_path, (SYS_STATUS, POLICY, f"represents: {{battery: {{{policy}}}}}"))
    cases = json.loads((generated / "tests" / "cases.json").read_text())["messages"]
    about = [case for case in cases if case["name"].startswith("SYS_STATUS.represents")]
    found = {case["name"]: (case["expect"]["voltage_battery"], case["expect"]["battery_remaining"]) for case in about}
    assert found == {case["name"]: shown(case, policy) for case in about}
    assert (len(set(found.values())) > 1) == (policy != "first: true")
    frames_are_green(tmp_path, "represents")
