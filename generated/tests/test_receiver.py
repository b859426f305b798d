# Generated from templates/tests/receiver/test_receiver.py: do not edit.
# Inputs: beb75cc968e4a2f2
"""The receiver gives back what the firmware's cases were made of, within one unit of the wire, on both interpreters."""

import json
import os
import sys

import pytest
from interpreters import HERE, SILENT_S, heard, micropython, path_of
from oracle import dialects
from test_frames import DATA, encoded

FACTS = json.loads((HERE / "receiver_facts.json").read_text())
CASES = [
    case
    for case in DATA["messages"]
    if case["message"] in FACTS["messages"]
    and {about["stored"] for about in FACTS["messages"][case["message"]]["attributes"].values()}
    <= {setting[1] for setting in case["set"]}
]
CHECKS = 4


def shows(*aspects):
    """Mark a test with the criteria that the specification names for aspects of the receiver."""
    criteria = [FACTS["criteria"][aspect] for aspect in aspects if aspect in FACTS["criteria"]]
    return pytest.mark.requirement(*dict.fromkeys(criteria))


@pytest.fixture(scope="session")
def frames():
    """Each case's frames by pymavlink, in MAVLink 2 and, where it can be, in MAVLink 1."""
    modules = dialects(DATA["dialect"], set(FACTS["messages"]), HERE)
    return [
        (case, version, frame)
        for case in CASES
        for version, module in zip((2, 1), modules, strict=True)
        if (frame := encoded(module, case))
    ]


@pytest.fixture(scope="session", params=["cpython", "micropython"])
def results(request, frames, tmp_path_factory):
    """Return the answers of the receiver, in one run of each interpreter."""
    path = tmp_path_factory.mktemp("receiver") / "frames.txt"
    path.write_text("".join(f"{case['message']} {frame}\n" for case, _, frame in frames))
    folder = os.pathsep.join([str(HERE.parent / "receiver"), ".frozen"])
    program = micropython() if request.param == "micropython" else sys.executable
    command = [program, str(path_of("tests", "receiver_run.py")), str(HERE / "receiver_facts.json"), str(path)]
    environment = {**os.environ, "MICROPYPATH": folder, "PYTHONPATH": folder, "PYTHONUNBUFFERED": "1"}
    printed, said, code = heard(command, environment, SILENT_S)
    assert code == 0, f"receiver_run.py ended with {code}: {printed[-2000:]}{said[-4000:]}"
    answers = [json.loads(line) for line in printed.splitlines()]
    return {"said": answers[: len(frames)], "checks": answers[len(frames) :]}


def agrees(value, stored, about):
    """Return whether an attribute is what the state kept, as far as the wire carries it."""
    if about.get("boolean"):
        return value == bool(stored)
    if stored is None:
        stored = about["stands_in"] and about["stands_in"] * about["steps"]
    if stored is None or value is None:
        return value is None and stored is None
    expected = min(max(stored / about["steps"], about["low"]), about["high"])
    return abs(value - expected) <= about["within"] + abs(expected) * 1e-6


def test_cases_are_here():
    """A comparison of nothing would find nothing."""
    assert {case["message"] for case in CASES} == set(FACTS["messages"])


@shows("units", "wire")
def test_the_state_comes_back(results, frames):
    """Every quantity of every case, and None for what was unknown."""
    assert len(results["said"]) == len(frames)
    for (case, version, _), said in zip(frames, results["said"], strict=True):
        kept = {setting[1]: setting[2] for setting in case["set"] if setting[0] == FACTS["component"]}
        assert said is not None, case["name"]
        for name, about in FACTS["messages"][case["message"]]["attributes"].items():
            if version == 1 and about["is_extension"]:
                continue  # MAVLink 1 has no extension fields
            if kept.get(about.get("unless")):
                continue  # single values go out in its place
            assert agrees(said[name], kept[about["stored"]], about), (case["name"], name, said[name], kept)


@shows("views", "age", "interpreters")
@pytest.mark.parametrize("check", range(CHECKS))
def test_frames_together(check, results):
    """Cut frames, noise, silence, and one view for all messages, under both interpreters."""
    assert len(results["checks"]) == CHECKS
    assert results["checks"][check] is None
