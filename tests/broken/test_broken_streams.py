"""Streams and messages that do not fit the links, the protocol or the dialect of the project."""

from pathlib import Path

import pytest
from test_broken_generations import changed
from test_broken_reaches import check

import codegen
from codegen.cli import main

pytestmark = pytest.mark.usefixtures("without_output")

BOARDS = Path(codegen.__file__).parent / "boards"

CASES = {
    "a stream without messages": (
        [("streams.yaml", "streams:\n", "streams:\n  SPARE: {doc: Nothing., rate: 1 Hz}\n")],
        0,
        "specs/streams.yaml:3:3: warning unused-stream: no message belongs to the stream SPARE",
    ),
    "a stream that links cannot follow": (
        [("vehicle.yaml", "  links: 100 Hz", "  links: 40 Hz")],
        1,
        "specs/streams.yaml:3:3: error stream-beyond-links: HEARTBEAT goes up to 50 Hz",
    ),
    "the old protocol": (
        [("codegen.yaml", "protocol: 2", "protocol: 1")],
        1,
        "error needs-mavlink-2: BATTERY_STATUS_V2 has the id 369",
    ),
    "an unfinished message": (
        [
            (
                "dialects/corrections_rfc_0018.yaml",
                '    set: {wip: ""}',
                "    set: {description: Facts about a battery.}",
            )
        ],
        0,
        "warning unstable-message: BATTERY_INFO is work in progress",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_is_reported(name, tmp_path, monkeypatch, capsys):
    """The rule at its place; what only may go wrong is a warning."""
    changes, code, wanted = CASES[name]
    found, out = check(tmp_path, monkeypatch, capsys, changes)
    assert wanted in out
    assert found == code


def test_a_slot_in_which_more_is_due_than_there_is_time_for(tmp_path, monkeypatch, capsys):
    """On a board that is slow enough, at the rate of control; the shipped one has the time for its jobs."""
    changed(tmp_path, ("board.yaml", "board: pico_2_w", "board: slow"))
    model = (BOARDS / "pico_2_w.yaml").read_text()
    assert "clock: 150 MHz" in model
    (tmp_path / "specs" / "boards").mkdir()
    (tmp_path / "specs" / "boards" / "slow.yaml").write_text(model.replace("clock: 150 MHz", "clock: 5 MHz"))
    monkeypatch.chdir(tmp_path)
    assert main(["build"]) == 0
    out = capsys.readouterr().out
    wanted = "specs/vehicle.yaml:6:9: warning crowded-slot: battery take "
    assert [line[: len(wanted)] for line in out.splitlines() if " warning " in line] == [wanted], out
    assert "us on the Raspberry Pi Pico 2 W (RP2350), and control is due every 2500 us" in out
