"""Sensors and quantities that cannot be: each is reported at its place, with what to do."""

import shutil
from pathlib import Path

import pytest

from codegen.cli import main

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "minimal"

SONAR = "sonar: {driver: user, class: sonar.Sonar, unit: m, stored: mm, min: 0, max: 100}"
DEPTH = "depth: {doc: Depth., unit: m, stored: mm, source: sonar}"
IMU = "imu: {driver: user, class: imu.Imu, outputs: {roll: {unit: rad, stored: mrad}, pitch: {unit: rad}}}"

# What board.yaml says under sources, what the component boat of state.yaml has, and what is found.
CASES = [
    ("nothing is wrong", SONAR, DEPTH, []),
    ("a driver", SONAR.replace("user", "usr"), DEPTH, ["2:19: error unknown-driver: there is no driver usr", "user"]),
    ("a key", SONAR.replace("min", "mni"), "", ["error unknown-key: unknown key 'mni'", "did you mean min"]),
    ("a class", SONAR.replace("sonar.Sonar", "Sonar"), DEPTH, ["bad-source-driver: Sonar is no class of a module"]),
    ("a name", SONAR.replace("sonar:", "Sonar:"), "", ["2:3: error bad-source-driver: Sonar cannot be the name"]),
    ("a rate", SONAR.replace("}", ", rate: 2000 Hz}"), DEPTH, ["bad-time: 2000 Hz is not a rate"]),
    ("a slow rate", SONAR.replace("}", ", rate: 0.001 Hz}"), DEPTH, ["bad-source-driver: sonar is asked less than"]),
    ("a step", SONAR.replace("mm", "ms"), DEPTH, ["error unit-mismatch: m cannot be rounded to ms"]),
    ("a limit", SONAR.replace("100", "0.1234"), DEPTH, ["bad-source-driver: max is 617/5 steps of mm"]),
    ("limits", SONAR.replace("100", "-1"), DEPTH, ["bad-source-driver: max is below min"]),
    ("both", IMU.replace("outputs", "unit: m, outputs"), "",
     ["unit is that of a single number, and there are outputs"]),
    ("an output", IMU.replace("roll:", "Roll:"), "", ["Roll cannot be the name of an output"]),
    ("an aspect", SONAR.replace("}", ", criteria: {speed: FR-1}}"), DEPTH,
     ["unknown-aspect: there is no aspect speed"]),
    ("a source", SONAR, DEPTH.replace("source: sonar", "source: sonr"),
     ["error unknown-source: board.yaml has no sensor sonr", "did you mean sonar?"]),
    ("no part", IMU, "roll: {doc: d, unit: rad, source: imu}",
     ["error unknown-source: imu gives several numbers: roll, pitch", "hint: imu.roll"]),
    ("a part", IMU, "roll: {doc: d, unit: rad, source: imu.rol}", ["imu gives no rol", "did you mean roll?"]),
    ("a part of one", SONAR, DEPTH.replace("source: sonar", "source: sonar.depth"),
     ["gives no depth", "hint: sonar\n"]),
    ("a list", SONAR, DEPTH.replace("source: sonar", "source: [sonar, sonar]"),
     ["boat has 1 instances, and depth 2 sources"]),
    ("a unit", SONAR, "depth: {doc: d, unit: s, stored: ms, source: sonar}",
     ["unit-mismatch: sonar is in mm, not in ms"]),
    ("a boolean", SONAR, "wet: {doc: d, boolean: true, initial: false, source: sonar}",
     ["error bad-sourced: wet is a boolean quantity, and a sensor gives numbers"]),
    ("elements", SONAR, "depth: {doc: d, unit: m, stored: mm, elements: 3, source: sonar}",
     ["bad-elements: a quantity with elements has numbers that other code sets, and no source"]),
    ("initial and stale", SONAR, "depth: {doc: d, unit: m, stored: mm, initial: 0, stale_after: 1 s, source: sonar}",
     ["bad-quantity: depth has an initial value in place of unknown, so stale_after says nothing"]),
    ("too fine", SONAR.replace("mm", "km").replace("100", "1000"),
     "depth: {doc: d, unit: m, stored: nm, source: sonar, min: 0, max: 0.1}",
     ["bad-sourced: sonar * 1000000000000 needs numbers of more than 30 bits"]),
    ("two derivations", SONAR, "depth: {doc: d, unit: m, stored: mm, source: sonar, trend_of: depth, window: 1 s}",
     ["the value of depth has one source, not both"]),
]  # fmt: skip


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return Path(shutil.copytree(PROJECT, tmp_path_factory.mktemp("broken") / "project"))


@pytest.mark.parametrize(("sources", "quantity", "expected"), [case[1:] for case in CASES], ids=[c[0] for c in CASES])
def test_is_reported(sources, quantity, expected, folder, monkeypatch, capsys):
    """The place, the rule, the words and the hint; no other error follows from it."""
    specs = PROJECT / "specs"
    (folder / "specs" / "board.yaml").write_text(f"sources:\n  {sources}\n")
    own = f"  boat:\n    doc: d\n    quantities:\n      {quantity or 'x: {doc: d, initial: 0}'}\n"
    (folder / "specs" / "state.yaml").write_text((specs / "state.yaml").read_text() + own)
    monkeypatch.chdir(folder)
    code = main(["check"])
    told = capsys.readouterr().out
    assert code == (1 if expected else 0), told
    for words in expected:
        assert words in told
    assert told.count(": error ") == bool(expected), told
