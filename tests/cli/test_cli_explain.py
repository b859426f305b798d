"""``codegen explain``: the argument part; what is told is tested with ``codegen.explain``."""

import sys
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.cli import main
from codegen.diagnostics import Report, Rule
from codegen.source import Place

UNKNOWN = Rule("unknown-topic", "", unreadable=True)


@pytest.fixture
def stories(monkeypatch: pytest.MonkeyPatch) -> dict[str, str]:
    """Stands in for codegen.explain.story: it tells these, by topic, and others only of a system that was read."""
    told = {"broken-table": "A rule.\n"}

    def explain(topic: str, system: object | None, report: Report) -> str | None:
        if topic not in told and system is not None:
            report.add(UNKNOWN, Place("/x"), f"nothing is called {topic}")
        return told.get(topic)

    fake = SimpleNamespace(explain=explain, own_story=lambda topic, _system: told.get(topic))
    monkeypatch.setitem(sys.modules, "codegen.explain.story", fake)
    return told


@pytest.mark.usefixtures("stories")
def test_the_story_goes_to_stdout(pipeline: Any, run: Any) -> None:
    assert pipeline.is_readable
    assert run("explain", "broken-table") == (0, "A rule.\n", "")


@pytest.mark.usefixtures("stories")
def test_an_unknown_topic_is_a_finding(pipeline: Any, run: Any) -> None:
    assert pipeline.is_readable
    assert run("explain", "FOO") == (2, "/x:1:1: error unknown-topic: nothing is called FOO\n", "1 error\n")


@pytest.mark.usefixtures("stories")
def test_a_rule_is_explained_to_whoever_breaks_it(pipeline: Any, run: Any) -> None:
    """The question comes up exactly when the specification cannot be read."""
    pipeline.is_readable = False
    pipeline.findings = [(Rule("broken-table", "", unreadable=True), 3, "it is wrong")]
    assert run("explain", "broken-table") == (0, "A rule.\n", "")
    code, out, _ = run("explain", "BATTERY_STATUS")
    assert (code, out) == (2, "specs/codegen.yaml:3:1: error broken-table: it is wrong\n")


@pytest.mark.usefixtures("stories")
def test_a_rule_is_explained_without_a_project(pipeline: Any, run: Any, project: Any) -> None:
    (project / "specs" / "codegen.yaml").unlink()
    assert run("explain", "broken-table") == (0, "A rule.\n", "")
    assert pipeline.projects == []


@pytest.mark.usefixtures("stories")
def test_anything_else_needs_a_project(pipeline: Any, run: Any, project: Any) -> None:
    (project / "specs" / "codegen.yaml").unlink()
    code, out, _ = run("explain", "BATTERY_STATUS")
    assert (code, pipeline.projects) == (2, [])
    assert "error file-not-found" in out
    assert "--project" in out


@pytest.mark.parametrize(
    ("project", "topic", "said"),
    [
        (
            "sensors",
            "power",
            ("a sensor: INA226 at 0x40", "sets         pack.voltage, pack.current, pack.power"),
        ),
        (
            *("watched_boat", "ground_station"),
            ("a failsafe: it watches the ground station", "FS_GCS_TIMEOUT, 5 s by default", "  does       slow()"),
        ),
        ("watched_boat", "motor", ("motor.temperature\n", "motor, a failsafe: it watches motor.temperature")),
        ("watched_boat", "motor", ("{name} is {level} {value:.2} degC",)),
    ],
)
def test_a_sensor_and_a_failsafe_are_explained(
    project: str, topic: str, said: tuple[str, ...], monkeypatch: Any, capsys: Any
) -> None:
    """With what they give, watch and do; of a component that is called as one, both are told."""
    monkeypatch.chdir(Path(__file__).resolve().parents[1] / "projects" / project)
    assert main(["explain", topic]) == 0
    found = capsys.readouterr().out
    assert [each for each in said if each not in found] == []
