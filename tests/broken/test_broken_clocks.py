"""Clocks that a table cannot have: each fault is reported at its place.

The cases are written as those of ``test_broken_tables``.
"""

import shutil
from pathlib import Path

import pytest
from test_broken_tables import Case, about_their_drafts, check_place, name_of

from codegen.cli import main

ROOT = Path(__file__).resolve().parents[2]
V2 = "messages/battery_status_v2.yaml"
SYS = "messages/sys_status.yaml"

CASES = [
    Case("bad-source", V2, "current: {state: battery.current", "current: {clock: §boot", "a clock is a whole number"),
    Case(
        "unit-mismatch",
        SYS,
        "errors_comm: {constant: 0}",
        "errors_comm: {clock: §boot}",
        "counts ns, us, ms, cs, ds or s",
    ),
    Case("unit-mismatch", SYS, "errors_comm: {constant: 0}", "errors_comm: {clock: §boot}", "can set its units"),
    Case("unit-mismatch", SYS, "load: {state: vehicle.load}", "load: {clock: §boot}", "answer it with a quantity"),
]


@pytest.mark.parametrize("case", about_their_drafts(CASES), ids=name_of)
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """The rule, the place and the words are right, the exit code is not 0, and nothing is written."""
    check_place(case, tmp_path, monkeypatch, capsys)


def test_the_name_of_the_clocks_is_taken(tmp_path, monkeypatch, capsys):
    """A component of the project's own cannot be called clock in a project whose tables have one."""
    shutil.copytree(ROOT / "specs", tmp_path / "specs")
    table = tmp_path / "specs" / "messages" / "battery_status.yaml"
    text = table.read_text()
    assert "time_remaining: {state: battery.time_left" in text
    table.write_text(text.replace("time_remaining: {state: battery.time_left", "time_remaining: {clock: boot"))
    state = tmp_path / "specs" / "state.yaml"
    own = "components:\n  clock:\n    doc: d\n    quantities:\n      turn: {doc: d, initial: 0, min: 0, max: 1}\n"
    state.write_text(state.read_text().replace("components:\n", own, 1))
    monkeypatch.chdir(tmp_path)
    assert main(["build"]) == 1
    told = capsys.readouterr().out
    assert "specs/state.yaml:3:3: error bad-component: clock is the component of what tables name as clock" in told
    assert "hint: choose another name" in told
