"""Scenarios set parameters of a program that takes them as the bytes of their types."""

import re
import shutil
import struct
from pathlib import Path

import pytest
from packs import ROOT

from codegen.cli import main
from codegen.decode.scenario import decode_scenarios
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.scenario import Sending
from codegen.project.systems import read_system
from codegen.resolve.scenarios.scenario import resolve_scenarios

PROJECTS = ROOT / "tests" / "projects"
HEAD = "scenarios:\n  a:\n    doc: d\n    duration: 20 s\n    events:\n"


def resolved(tmp_path: Path, fields: str) -> tuple[bytes, list[tuple[str, str, str | None]]]:
    """The payload of a PARAM_SET with these fields, and the findings: rule, message and hint."""
    path = tmp_path / "own.yaml"
    path.write_text(f"{HEAD}      - {{at: 1 s, send: PARAM_SET, fields: {{{fields}}}}}\n")
    report = Report()
    system = read_system(str(PROJECTS / "guarded" / "specs" / "codegen.yaml"), report)
    assert system is not None
    report = Report()
    written = decode_scenarios(str(path), DISK, report)
    scenarios = {} if written is None else resolve_scenarios(written, system, report)
    (event,) = scenarios["a"].events if "a" in scenarios else (None,)
    payload = event.payload if isinstance(event, Sending) else b""
    return payload, [(each.rule.id, each.message, each.hint) for each in report]


@pytest.mark.parametrize(
    ("fields", "code", "value", "kind"),
    [
        ("param_id: GATE_SPEED, param_value: 50, param_type: MAV_PARAM_TYPE_UINT8", "B3x", 50, 1),
        ("param_id: GATE_SPEED, param_value: 50", "B3x", 50, 1),
        ("param_id: GATE_WIND, param_value: -1", "b3x", -1, 2),
        ("param_id: GATE_COUNT, param_value: 65535, param_type: 3", "H2x", 65535, 3),
        ("param_id: GATE_ANGLE, param_value: -300", "h2x", -300, 4),
        ("param_id: GATE_LIFE, param_value: 4294966784", "I", 4294966784, 5),
        ("param_id: GATE_OFFSET, param_value: -1", "i", -1, 6),
        ("param_id: GATE_OFFSET, param_value: 16777215", "i", 16777215, 6),
        ("param_id: GATE_FORCE, param_value: 12.5", "f", 12.5, 9),
        ("param_id: GATE_SPEED, param_value: 50, param_type: MAV_PARAM_TYPE_REAL32", "f", 50, 9),
        ("param_id: NO_SUCH, param_value: 50", "f", 50, 0),
    ],
)
def test_bytes_are_those_of_the_type(tmp_path: Path, fields: str, code: str, value: float, kind: int) -> None:
    """The type that is written, else that of the parameter."""
    payload, findings = resolved(tmp_path, fields)
    assert findings == []
    assert payload.ljust(23, b"\0")[:4] == struct.pack(f"<{code}", value)
    assert payload.ljust(23, b"\0")[22] == kind


@pytest.mark.parametrize(
    ("fields", "message", "hint"),
    [
        (
            "param_id: GATE_SPEED, param_value: 256",
            "MAV_PARAM_TYPE_UINT8 carries whole numbers of its range, not 256",
            "write 0 to 255, or another param_type",
        ),
        (
            "param_id: GATE_WIND, param_value: 0.5",
            "MAV_PARAM_TYPE_INT8 carries whole numbers of its range, not 0.5",
            "write -128 to 127, or another param_type",
        ),
    ],
)
def test_what_the_type_does_not_carry(tmp_path: Path, fields: str, message: str, hint: str) -> None:
    assert resolved(tmp_path, fields)[1] == [("scenario-send", message, hint)]


def test_the_program_does_what_it_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """A stream of 5 Hz has another rate from the middle on, and the answer comes once."""
    shutil.copytree(PROJECTS / "slow_readings" / "specs", tmp_path / "specs")
    path = tmp_path / "own.yaml"
    path.write_text(
        f"{HEAD}      - {{at: 10 s, send: PARAM_SET, fields: {{param_id: RANGE_RATE, param_value: 1}}}}\n"
        "    courses: {range.distance: {value: 3 m}, motor.oil: {value: 60 degC}, motor.speed: {value: 1000 rpm}}\n"
    )
    monkeypatch.chdir(tmp_path)
    assert main(["build"]) == 0
    capsys.readouterr()
    options = ["--speed", "max", "--out", "udp:127.0.0.1:9", "--quiet"]
    assert main(["sim", str(path), *options]) == 0, capsys.readouterr().out
    out = capsys.readouterr().out
    assert re.search(r"\n    PARAM_VALUE +1 frames ", out), out
    sent = re.search(r"\n    DISTANCE_SENSOR +(\d+) frames ", out)
    assert sent is not None, out
    assert 50 <= int(sent[1]) <= 62, "5 Hz all the time would be 90 and more"
