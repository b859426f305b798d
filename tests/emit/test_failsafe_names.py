"""Every name that failsafe.py uses is defined there, whichever of its parts the failsafes of a project need.

A column that all conditions have alike is a constant, and one that nothing uses is left out: a name that a statement
uses nevertheless would end each update in a NameError, and no failsafe would ever fire. Nor is a condition that waits
for an unknown value taken for one on the value.
"""

import re
import shutil
import subprocess
import sys
from itertools import product
from pathlib import Path

from codegen.diagnostics import Report
from codegen.project.systems import read_system
from codegen.render.rendered import rendered
from codegen.targets.firmware.failsafes.failsafe import failsafe_views
from codegen.targets.firmware.words import word_layout

SPECS = Path(__file__).resolve().parents[1] / "projects" / "watched_boat" / "specs"
RUFF = Path(sys.executable).parent / "ruff"

LEVELS = {
    "below": "{low: {below: 2 m}}",
    "above": "{low: {above: 90 m}}",
    "parameter": "{low: {below: SHALLOW}}",
    "parameters": "{low: {below: DEPTH_ARM}, lower: {below: SHALLOW}}",
    "both": "{low: {below: 2 m, or: [{above: 90 m, after: 2 s}]}}",
    "unknown": "{low: {unknown: true}}",
    "or-unknown": "{low: {below: 2 m, or: [{unknown: true}]}}",
}
AFTERWARDS = {
    "latched": "",
    "over": "    latch: false\n",
    "slack": "    latch: false\n    hysteresis: 50 cm\n",
}
BESIDE = {
    "alone": "",
    "to-arm": "    to_arm: [{below: DEPTH_ARM}]\n",
    "to-arm-known": "    to_arm: [{unknown: true}]\n",
    "silence": (
        "  silent:\n    silence: ground_station\n    levels: {silent: {after: FS_GCS_TIMEOUT}}\n"
        "    requirement: FR-201.4\n"
    ),
}


def vehicle(levels: str, afterwards: str, beside: str) -> str:
    """The vehicle with one failsafe of such levels, and perhaps another one."""
    text = (SPECS / "vehicle.yaml").read_text()
    failsafe = (
        f"  depth:\n    watches: sounder.depth\n    levels: {levels}\n    after: 1 s\n    requirement: FR-201.2\n"
    )
    found = f"failsafes:\n{failsafe}{afterwards}{beside}"
    return re.sub(r"failsafes:\n.*?(?=\nactions:)", lambda _: found, text, flags=re.DOTALL)


def test_no_name_is_left_undefined(tmp_path: Path) -> None:
    """In projects with each kind of level, alone and beside others; nor is a constant defined that nothing names."""
    specs, made = shutil.copytree(SPECS, tmp_path / "specs"), tmp_path / "made"
    made.mkdir()
    for kinds in product(LEVELS, AFTERWARDS, BESIDE):
        levels, afterwards, beside = kinds
        (specs / "vehicle.yaml").write_text(vehicle(LEVELS[levels], AFTERWARDS[afterwards], BESIDE[beside]))
        report = Report()
        system = read_system(str(specs / "codegen.yaml"), report)
        assert system is not None, kinds
        assert system.program is not None, kinds
        assert not report.has_errors, (kinds, *map(str, report))
        view = failsafe_views(system, system.program, word_layout(system))
        text = rendered("firmware/program/failsafe.py.j2", view)
        (made / f"{'_'.join(kinds).replace('-', '_')}.py").write_text(text)
        waits_for_unknown = "unknown" in levels or beside == "to-arm-known"
        assert ("= 2  # unknown" in text) == waits_for_unknown, kinds
        shared = re.findall(r"^(_\w+) = const.*# of all$", text, re.MULTILINE)
        assert all(len(re.findall(rf"\b{name}\b", text)) > 1 for name in shared), (kinds, shared)
    command = [str(RUFF), "check", "--isolated", "--select", "F821,F822,E9", str(made)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
