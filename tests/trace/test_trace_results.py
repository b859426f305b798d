"""Results meet tests: what passed, what counts for nothing, what is of another specification or another project."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from trace_project import Project

from codegen.decode.junit import decode_junit
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.trace.coverage import Verdict, coverage_of
from codegen.trace.generated_tests import inputs_of
from codegen.trace.results import Counts, results_of, unrelated, with_links_of

Junit = Callable[..., str]
BEATS = "tests.test_beat"


def verdicts(project: Project, *files: str) -> dict[str, tuple[Verdict, Counts | None]]:
    """Return the verdict on each criterion with the results of some files."""
    trace, _ = project.trace()
    found = [result for path in files for result in decode_junit(path, DISK, Report()) or ()]
    results = results_of(found, trace.tests, inputs_of(project.trace()[1]))
    return {
        each.name: (each.verdict, each.counts) for each in coverage_of(with_links_of(trace, results), {}, {}, results)
    }


def of_the_suite(project: Project, outcome: str = "passed", inputs: str | None = None) -> list[tuple[object, ...]]:
    """Results of every generated test that shows the second criterion."""
    trace, _ = project.trace()
    tests = [test for test in trace.tests_of["FR-1.2"] if not test.place]
    assert sum(len(test.cases) for test in tests) == 2
    return [
        ("generated.tests.test_frames", f"{test.function}[{case}]", outcome, ("FR-1.2",), inputs or test.inputs)
        for test in tests
        for case in test.cases
    ]


BY_HAND = (f"{BEATS}.TestMode", "test_seven", "passed", ("FR-1.2",), None)


def test_every_case_has_to_pass(project: Project, junit: Junit) -> None:
    path = junit("r.xml", *of_the_suite(project), BY_HAND)
    assert verdicts(project, path)["FR-1.2"] == (Verdict.PASSED, Counts(passed=3))


@pytest.mark.parametrize(
    ("outcome", "verdict"), [("failure", "failed"), ("error", "failed"), ("skipped", "partly passed")]
)
def test_one_that_did_not_pass(outcome: str, verdict: str, project: Project, junit: Junit) -> None:
    """One case of three failed, or was skipped."""
    first, *others = of_the_suite(project)
    path = junit("r.xml", (*first[:2], outcome, *first[3:]), *others, BY_HAND)
    assert verdicts(project, path)["FR-1.2"][0] == verdict


@pytest.mark.parametrize(("outcome", "verdict"), [("failure", "failed"), ("error", "failed"), ("skipped", "skipped")])
def test_what_did_not_pass_shows_nothing(outcome: str, verdict: str, project: Project, junit: Junit) -> None:
    path = junit("r.xml", *of_the_suite(project, outcome))
    assert verdicts(project, path)["FR-1.2"][0] == verdict


def test_a_suite_whose_results_have_lost_their_properties_shows_nothing(
    project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    """A tool that joins files of results may leave the properties out: results of last year's suite would pass."""
    cases = of_the_suite(project)
    bare = junit("r.xml", *((*case[:3], (), None) for case in cases))
    assert verdicts(project, bare)["FR-1.2"] == (Verdict.STALE, Counts(stale=2, missing=1))
    assert project.run("FR-1.2", "--results", bare) == 1
    told = capsys.readouterr().out
    assert "warning results-undated: 2 results of a generated suite: the property codegen-inputs is gone" in told
    project.run("FR-1.2", "--results", junit("whole.xml", *cases))
    assert "results-undated" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("outcome", "remedy"),
    [
        ("failure", "look at the tests that failed"),
        ("skipped", "run the tests where nothing makes them skip"),
        ("stale", "build, run the tests again"),
        ("missing", "run the tests, and give their results"),
    ],
)
def test_the_remedy_is_that_of_what_happened(
    outcome: str, remedy: str, project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    """Only where there is no test has anybody to write one."""
    cases = of_the_suite(project, "passed" if outcome == "stale" else outcome, "0" * 16 if outcome == "stale" else None)
    given = junit("r.xml", *(() if outcome == "missing" else cases))
    assert project.run("FR-1.2", "--results", given) == 1
    told = capsys.readouterr().out
    assert f"hint: {remedy}" in told
    assert "mark a test" not in told


def test_a_later_file_makes_no_failure_good(project: Project, junit: Junit) -> None:
    bad = junit("bad.xml", (*BY_HAND[:2], "failure", *BY_HAND[3:]))
    good = junit("good.xml", *of_the_suite(project), BY_HAND)
    assert verdicts(project, bad, good)["FR-1.2"] == (Verdict.FAILED, Counts(passed=2, failed=1))
    assert verdicts(project, good, bad)["FR-1.2"] == (Verdict.FAILED, Counts(passed=2, failed=1))


def test_a_test_that_fails_twice_in_one_file(project: Project, junit: Junit) -> None:
    """pytest writes a second case for what fails while a test is put away."""
    path = junit("r.xml", BY_HAND, (*BY_HAND[:2], "error", *BY_HAND[3:]), *of_the_suite(project))
    assert verdicts(project, path)["FR-1.2"][0] is Verdict.FAILED


def test_results_of_another_specification_are_stale(project: Project, junit: Junit) -> None:
    old = junit("old.xml", *of_the_suite(project, inputs="0123456789abcdef"))
    assert verdicts(project, old)["FR-1.2"] == (Verdict.STALE, Counts(stale=2, missing=1))


def test_a_changed_table_makes_results_stale(project: Project, junit: Junit) -> None:
    """The hash is that of the specification: results that were right for the old one show nothing for the new one."""
    path = junit("r.xml", *of_the_suite(project), BY_HAND)
    streams = project.folder / "specs" / "streams.yaml"
    streams.write_text(streams.read_text().replace("rate: 1 Hz", "rate: 2 Hz"))
    assert verdicts(project, path)["FR-1.2"] == (Verdict.PARTLY, Counts(passed=1, stale=2))


def test_without_its_result_a_case_is_missing(
    project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    path = junit("r.xml", of_the_suite(project)[0])
    assert verdicts(project, path)["FR-1.2"] == (Verdict.PARTLY, Counts(passed=1, missing=2))
    assert project.run("--results", path, "--fail-on", "partly") == 1
    assert "error trace-partly: FR-1.2: 1 passed, 2 without a result" in capsys.readouterr().out


def test_parameters_of_tests_by_hand_come_from_the_results(project: Project, junit: Junit) -> None:
    """Both have to pass, and the alias of the document counts as its id."""
    cases = [
        (BEATS, f"test_beats[{n}]", outcome, ("FR-1.1", "FR-old.3"), None)
        for n, outcome in enumerate(("passed", "failure"))
    ]
    found = verdicts(project, junit("r.xml", *cases))
    assert found["FR-1.3"] == (Verdict.FAILED, Counts(passed=1, failed=1))


def test_single_parameters_can_show_a_criterion(project: Project, junit: Junit) -> None:
    """Only the results know which: those that are marked count, the others do not."""
    cases = [
        (BEATS, "test_beats[1]", "passed", ("FR-1.3",), None),
        (BEATS, "test_beats[2]", "failure", ("FR-1.1",), None),
    ]
    found = verdicts(project, junit("r.xml", *cases))
    assert found["FR-1.3"] == (Verdict.PASSED, Counts(passed=1))
    assert found["FR-1.1"][0] is Verdict.FAILED


def test_links_that_only_results_know(project: Project, junit: Junit) -> None:
    """A test whose marks are computed, or that lies where nobody looked."""
    path = junit("r.xml", ("elsewhere.test_far", "test_far[a]", "passed", ("FR-1.4",), None))
    assert verdicts(project, path)["FR-1.4"] == (Verdict.PASSED, Counts(passed=1))


@pytest.mark.parametrize(
    ("module", "name"),
    [
        ("tests.a.test_x.TestOne", "tests/a/test_x.py::TestOne::test_far"),
        ("tests.a.test_x.TestOne.TestInner", "tests/a/test_x.py::TestOne::TestInner::test_far"),
        ("test_lib.beat_test.Mine", "test_lib/beat_test.py::Mine::test_far"),
        ("checks.beats.Mine", "checks/beats.py::Mine::test_far"),
        ("checks.beats", "checks/beats.py::test_far"),
        ("Checks", "Checks.py::test_far"),
    ],
)
def test_a_test_that_only_results_know_is_in_a_file_and_a_class(
    module: str, name: str, project: Project, junit: Junit
) -> None:
    """A class is no folder: inherited tests and those of unittest are named as pytest names them."""
    found = decode_junit(junit("r.xml", (module, "test_far[a]", "passed", ("FR-1.4",), None)), DISK, Report()) or ()
    trace, systems = project.trace()
    linked = with_links_of(trace, results_of(found, trace.tests, inputs_of(systems)))
    assert [test.name for test in linked.tests_of["FR-1.4"]] == [name]


def test_what_could_not_be_collected_has_failed(
    project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    """As pytest writes a module that it cannot import: it is about the project, and its tests ended with an error."""
    path = Path(junit("r.xml", ("", "tests.test_beat", "error", (), None), ("", "tests.test_far", "error", (), None)))
    path.write_text(path.read_text().replace('message="m"', 'message="collection failure"'))
    assert verdicts(project, str(path))["FR-1.3"] == (Verdict.FAILED, Counts(failed=1))
    assert project.run("--results", str(path)) == 1
    said = capsys.readouterr().out
    assert "error trace-uncovered: FR-1.3 has failed: 1 failed" in said
    assert "hint: look at the tests that failed, and at what they are about" in said
    for module in ("test_beat", "test_far"):
        assert f"warning results-uncollected: the tests of tests.{module} could not be collected" in said
    assert "results-unrelated" not in said


def test_pytest_writes_what_could_not_be_collected(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """The words of the pytest that is installed."""
    project.tests.write_text("import no_such_module\n\n" + project.tests.read_text())
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "--junit-xml=r.xml", "tests"]
    assert subprocess.run(command, cwd=project.folder, capture_output=True, check=False).returncode == 2
    assert project.run("FR-1.3", "--results", "r.xml") == 1
    assert "results-uncollected: the tests of tests.test_beat could not" in capsys.readouterr().out
    assert verdicts(project, str(project.folder / "r.xml"))["FR-1.3"][0] is Verdict.FAILED


@pytest.mark.parametrize("module", ["test_beat", "tests.test_beat", "work.here.tests.test_beat"])
def test_pytest_may_count_modules_from_another_folder(module: str, project: Project, junit: Junit) -> None:
    path = junit("r.xml", (f"{module}.TestMode", "test_seven", "passed", (), None))
    assert verdicts(project, path)["FR-1.2"] == (Verdict.PARTLY, Counts(passed=1, missing=2))


@pytest.mark.parametrize("module", ["", "other.test_beat", "tests.test_beat2", "tests"])
def test_a_test_of_that_name_elsewhere_is_another_one(module: str, project: Project, junit: Junit) -> None:
    path = junit("r.xml", (f"{module}.TestMode", "test_seven", "passed", (), None))
    assert verdicts(project, path)["FR-1.2"][0] is Verdict.NO_RESULT


def test_results_of_another_project(project: Project, junit: Junit, capsys: pytest.CaptureFixture[str]) -> None:
    """They are told from those of the project, and the report says so."""
    trace, _ = project.trace()
    other = junit(
        "other.xml",
        ("generated.tests.test_frames", "test_frames[cpython-X.nominal-FR-9.1]", "passed", ("FR-9.1",), "0" * 16),
        ("tests.test_x", "test_x", "passed", (), None),
    )
    assert unrelated(decode_junit(other, DISK, Report()) or (), trace)
    assert not unrelated(decode_junit(junit("own.xml", BY_HAND), DISK, Report()) or (), trace)
    project.run("--results", other)
    assert "other.xml:1:1: warning results-unrelated: none of its results" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "rule"),
    [
        ("<testsuite><testcase", "xml-syntax"),
        ("", "xml-syntax"),
        ("<html/>", "junit-format"),
        ('<!DOCTYPE a [<!ENTITY b "bbbb">]><testsuite name="&b;"/>', "xml-doctype"),
        ('<?xml version="1.0" encoding="utf-7"?><testsuite/>', "xml-encoding"),
        ("<testsuite>" * 5000, "xml-syntax"),
    ],
)
def test_files_that_are_no_results(text: str, rule: str, project: Project) -> None:
    path = project.folder / "r.xml"
    path.write_text(text)
    report = Report()
    assert decode_junit(str(path), DISK, report) is None
    assert [found.rule.id for found in report] == [rule]
    assert report.exit_code == 2


def test_other_tools_write_less(project: Project) -> None:
    """No classname, no properties, cases beside suites, suites in suites: whatever is there is read."""
    path = project.folder / "r.xml"
    path.write_text(
        '<testsuites><testsuite><testsuite><testcase name="a"/></testsuite></testsuite><testcase/></testsuites>'
    )
    found = decode_junit(str(path), DISK, Report())
    assert found is not None
    assert [(result.module, result.name, result.outcome) for result in found] == [
        ("", "a", "passed"),
        ("", "", "passed"),
    ]


def test_thousands_of_results(project: Project, junit: Junit) -> None:
    """A large project's results are no matter of minutes: each one is looked up, not searched for."""
    many = [(f"tests.test_{n % 50}", f"test_{n % 97}[{n}]", "passed", ("FR-1.4",), None) for n in range(10000)]
    found = verdicts(project, junit("r.xml", *many))["FR-1.4"]
    assert found == (Verdict.PASSED, Counts(passed=10000))
