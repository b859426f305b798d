"""Rates that passes of the main loop cannot keep are refused where they are stated: faster-than-control."""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "watched_boat"
SONAR = "{driver: user, class: sonar.Sonar, unit: m, stored: mm, min: 0, max: 100"
DEPTH = "depth: {doc: d, unit: m, stored: mm, source: own, stale_after: 9 s}"
VOLTS = "volts: {doc: d, unit: V, stored: mV, source: own, stale_after: 9 s}"
INPUT = "{driver: adc, gpio: 26, multiplier: 1"
BEYOND = "error faster-than-control: "
COME = "and passes of the main loop come at 50 Hz only"

# What vehicle.yaml says instead, the sensor, what it gives, and what is found.
CASES = [
    ("a sensor", {}, f"{SONAR}, rate: 500 Hz}}", DEPTH,
     ["board.yaml:4:", f"{BEYOND}own is asked at 500 Hz, {COME}", "hint: rate: 50 Hz, or a higher rate of control"]),
    ("a sensor in each pass", {}, f"{SONAR}, rate: 50 Hz}}", DEPTH, []),
    ("a sensor by a little", {}, f"{SONAR}, rate: 51 Hz}}", DEPTH, [f"{BEYOND}own is asked at 51 Hz"]),
    ("an input", {}, f"{INPUT}, rate: 200 Hz}}", VOLTS,
     ["board.yaml:4:", f"{BEYOND}extra is measured at 200 Hz, {COME}", "hint: rate: 50 Hz, or a higher"]),
    ("an input in each pass", {}, f"{INPUT}, rate: 50 Hz}}", VOLTS, []),
    ("a slow loop", {"rate: 50 Hz, links: 50 Hz": "rate: 5 Hz, links: 5 Hz, checks: 5 Hz"}, f"{SONAR}}}", DEPTH,
     [f"{BEYOND}own is asked at 10 Hz, and passes of the main loop come at 5 Hz only", "hint: rate: 5 Hz"]),
    ("failsafes", {"links: 50 Hz": "links: 50 Hz, checks: 100 Hz"}, f"{SONAR}}}", DEPTH,
     ["vehicle.yaml:1:", f"{BEYOND}failsafes look at 100 Hz, {COME}", "hint: checks: 50 Hz"]),
    ("code", {"arming: {force: 21196}": "arming: {force: 21196}\ncode: {module: app, class: App, measure: 60 Hz}"},
     f"{SONAR}}}", DEPTH, [f"{BEYOND}measure() is called at 60 Hz, {COME}", "hint: measure: 50 Hz"]),
    ("an uneven rate", {"rate: 50 Hz, links: 50 Hz": "rate: 400 Hz, links: 50 Hz"}, f"{INPUT}, rate: 400 Hz}}", VOLTS,
     []),
]  # fmt: skip


@pytest.mark.parametrize(
    ("vehicle", "sensor", "quantity", "expected"), [c[1:] for c in CASES], ids=[c[0] for c in CASES]
)
def test_is_reported(vehicle, sensor, quantity, expected, tmp_path, monkeypatch, capsys):
    """Each at its place with the rate that is possible; what can be kept is accepted."""
    specs = Path(shutil.copytree(PROJECT / "specs", tmp_path / "specs"))
    board = (specs / "board.yaml").read_text()
    assert "sources:" not in board
    (specs / "board.yaml").write_text(f"board: pico_2\n# 2\nsources:\n  own: {sensor}\n" + board.partition("\n")[2])
    text = (specs / "vehicle.yaml").read_text()
    for old, new in vehicle.items():
        assert old in text
        text = text.replace(old, new, 1)
    (specs / "vehicle.yaml").write_text(text)
    with (specs / "state.yaml").open("a") as state:
        state.write(f"  extra:\n    doc: d\n    quantities:\n      {quantity}\n")
    monkeypatch.chdir(tmp_path)
    main(["check"])
    told = capsys.readouterr().out
    for words in expected:
        assert words in told
    assert told.count("faster-than-control") == bool(expected), told
