"""Results of tests written by hand say with which specification they were made; those of another one show nothing."""

import re
import subprocess
import sys
from collections.abc import Callable

import pytest
from generated_suite import ALONE
from trace_project import Project

from codegen.cli import main
from codegen.project.built_specification import built_specification
from codegen.trace.generated_tests import inputs_of

Junit = Callable[..., str]
SEVEN = ("tests.test_beat.TestMode", "test_seven", "passed", ("FR-1.2",), None)
BEATS = [("tests.test_beat", f"test_beats[{n}]", "passed", ("FR-1.1", "FR-old.3"), None) for n in (1, 2)]
OTHER = "0123456789abcdef"


def status(project: Project, capsys: pytest.CaptureFixture[str], criterion: str, *files: str) -> str:
    """Return the state of a criterion in the tree, in brackets behind its name."""
    capsys.readouterr()
    project.run(criterion, *(each for file in files for each in ("--results", file)))
    found = re.search(rf"  {re.escape(criterion)}  \[(.*)\]", capsys.readouterr().out)
    assert found
    return found[1]


def test_results_of_this_specification_count(
    project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    own = inputs_of(project.trace()[1])
    path = junit("r.xml", *BEATS, specification=own)
    assert status(project, capsys, "FR-1.3", path) == "passed; 2 passed"
    project.run("--results", path, "--fail-on", "none")
    said = capsys.readouterr().out
    assert "results-outdated" not in said
    assert "results-undated" not in said


def test_results_of_another_one_show_nothing(
    project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    """Neither passed nor partly passed comes of them, nor failed; the file is told, with what to do."""
    path = junit("r.xml", *BEATS, SEVEN, specification=OTHER)
    assert status(project, capsys, "FR-1.3", path) == "stale; 2 of another specification"
    failed = junit("f.xml", *[(*each[:2], "failure", *each[3:]) for each in BEATS], specification=OTHER)
    assert status(project, capsys, "FR-1.3", failed) == "stale; 2 of another specification"
    capsys.readouterr()
    assert project.run("--results", path) == 1
    said = capsys.readouterr().out
    assert "r.xml:1:1: warning results-outdated: 3 results of tests written by hand: made with another spec" in said
    assert "error trace-uncovered: FR-1.3 is shown by no test: 2 of another specification" in said
    assert "tests/test_beat.py:4:36: tests/test_beat.py::test_beats: 2 of another specification" in said


def test_a_file_of_tests_that_is_gone_is_told(
    project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    """What it showed goes on counting, as tests can lie elsewhere: then nothing is said of it."""
    own = inputs_of(project.trace()[1])
    elsewhere = ("bench.test_motor", "test_it", "passed", ("FR-1.1",), None)
    path = junit("r.xml", *BEATS, elsewhere, specification=own)
    project.run("--results", path, "--fail-on", "none")
    assert "results-without-test" not in capsys.readouterr().out
    (project.folder / "tests" / "test_beat.py").rename(project.folder / "tests" / "test_pulse.py")
    project.run("--results", path, "--fail-on", "none")
    said = capsys.readouterr().out
    assert (
        "r.xml:1:1: warning results-without-test: there is no tests/test_beat.py any more, and its results cou" in said
    )
    assert said.count("results-without-test") == 1


def test_a_changed_table_outdates_them(project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]) -> None:
    path = junit("r.xml", *BEATS, specification=inputs_of(project.trace()[1]))
    assert status(project, capsys, "FR-1.3", path) == "passed; 2 passed"
    streams = project.folder / "specs" / "streams.yaml"
    streams.write_text(streams.read_text().replace("rate: 1 Hz", "rate: 2 Hz"))
    assert status(project, capsys, "FR-1.3", path) == "stale; 2 of another specification"


def test_a_new_result_does_not_make_an_old_one_good(
    project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    """One parameter was run again, the other was not: that is partly, by the one that was."""
    new = junit("new.xml", BEATS[0], specification=inputs_of(project.trace()[1]))
    old = junit("old.xml", BEATS[1], specification=OTHER)
    assert status(project, capsys, "FR-1.3", new, old) == "partly passed; 1 passed, 1 of another specification"
    assert status(project, capsys, "FR-1.3", old) == "stale; 1 of another specification"


def test_results_that_say_nothing_of_it_are_told(
    project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    """Another tool, or an old run: they count, as nothing speaks against them, and the report says so."""
    path = junit("r.xml", *BEATS)
    assert status(project, capsys, "FR-1.3", path) == "passed; 2 passed"
    project.run("--results", path, "--fail-on", "none")
    assert "warning results-undated: 2 results of tests written by hand: no word of the" in capsys.readouterr().out


def test_what_was_not_built_has_no_hash(project: Project) -> None:
    """Nor has what cannot be read; a build gives it the one that the trace expects."""
    assert built_specification(project.file) is None
    assert main(["build", "--project", project.file]) == 0
    assert built_specification(project.file) == inputs_of(project.trace()[1])
    cases = project.folder / "generated" / "tests" / "cases.json"
    for text in ("", "[]", "{}", '{"generated": {"inputs": 7}}', "[" * 100_000):
        cases.write_text(text)
        assert built_specification(project.file) is None
    assert built_specification(str(project.folder / "none.yaml")) is None


@pytest.mark.parametrize("processes", [[], ["-p", "xdist", "-n", "2"]])
def test_pytest_notes_what_was_built(
    processes: list[str], project: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    """Also in several processes: what was generated counts, not what the tables say by now."""
    assert main(["build", "--project", project.file]) == 0
    (project.folder / "pytest.ini").write_text("[pytest]\naddopts = --strict-markers\n")
    options = ["-q", "-p", "no:cacheprovider", "-p", "codegen.pytest_plugin", *processes]
    command = [sys.executable, "-m", "pytest", *options, "--junit-xml=r.xml", "tests"]
    done = subprocess.run(command, cwd=project.folder, env=ALONE, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
    written = (project.folder / "r.xml").read_text()
    own = inputs_of(project.trace()[1])
    assert written.count(f'name="codegen-specification" value="{own}"') == 3
    assert status(project, capsys, "FR-1.3", "r.xml") == "passed; 2 passed"
    if processes:
        return
    streams = project.folder / "specs" / "streams.yaml"
    streams.write_text(streams.read_text().replace("rate: 1 Hz", "rate: 2 Hz"))
    done = subprocess.run(command, cwd=project.folder, env=ALONE, capture_output=True, text=True, check=False)
    assert f'value="{own}"' in (project.folder / "r.xml").read_text(), "it was not built again"
    assert status(project, capsys, "FR-1.3", "r.xml") == "stale; 2 of another specification"
