"""Criteria that depend on others: how documents say it, what is wrong with it, and what it tells of the tests."""

import re
from collections.abc import Callable

import pytest
from trace_project import Project

from codegen.cli import main
from codegen.decode.criterion_dependency import dependencies_of
from codegen.diagnostics import Report
from codegen.rules.criterion_dependency import _circles
from codegen.source import Place

Junit = Callable[..., str]
BEATS = ("tests.test_beat", "test_beats[1]")


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("It beats (depends on FR-1.2).", ["FR-1.2"]),
        ("It (depends on criterion 12) beats (depends on FR-1.2).", ["FR-9.12", "FR-1.2"]),
        ("(depends on criteria 1, 2 and 3, FR-2.1)", ["FR-9.1", "FR-9.2", "FR-9.3", "FR-2.1"]),
        ("(depends on FR-2.1, and FR-old.3)", ["FR-2.1", "FR-old.3"]),
        ("(Depends on FR-2.1, FR-2.1)", ["FR-2.1"]),
        ("It depends on FR-2.1. (depends on the load) (as FR-2.1 asks)", []),
    ],
)
def test_what_a_text_says(text: str, names: list[str]) -> None:
    """Only in parentheses, and only where these name criteria: all else is prose."""
    report = Report()
    assert list(dependencies_of(text, "FR-9", Place("/d.md"), report)) == names
    assert list(report) == []


@pytest.mark.parametrize(
    ("clause", "rest"),
    [
        ("FR-1.2 and the board", "and the board"),
        ("FR-1.2 FR-1.3", "FR-1.3"),
        ("FR-1.2, 3", "3"),
        ("criteria 2, 3 4", "4"),
        ("FR-1.2.3", "FR-1.2.3"),
        ("criterion 1a", "criterion 1a"),
    ],
)
def test_what_is_no_list(clause: str, rest: str, project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """It stops a build as every finding in a document does, at the criterion."""
    project.change("It beats once a second.", f"It beats once a second (depends on {clause}).")
    assert main(["check", "--project", project.file]) == 1
    said = capsys.readouterr().out
    assert f"specs/requirements/FR-1.md:10:1: error criterion-depends: {rest!r} is no criterion" in said


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("FR-1.9", "unknown-dependency: FR-1.1 depends on FR-1.9, which no document has"),
        ("FR-7.1", "unknown-dependency: FR-1.1 depends on FR-7.1, which no document has"),
        ("FR-1", "unknown-dependency: FR-1.1 depends on FR-1, which is a whole document"),
        ("FR-old", "unknown-dependency: FR-1.1 depends on FR-old, which is a whole document"),
        ("FR-7", "unknown-dependency: FR-1.1 depends on FR-7, which no document has"),
        ("FR-1.1", "dependency-cycle: FR-1.1 on FR-1.1: they depend on one another"),
        ("FR-old.1", "dependency-cycle: FR-1.1 on FR-1.1: they depend on one another"),
    ],
)
def test_what_depends_on_nothing(name: str, message: str, project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    project.change("It beats once a second.", f"It beats once a second (depends on {name}).")
    assert project.run() == 1
    said = capsys.readouterr().out
    assert f"specs/requirements/FR-1.md:10:1: error {message}" in said
    assert ("hint: name one of its criteria, such as FR-1.1\n" in said) is message.endswith("a whole document")


def test_what_only_looks_like_a_document(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """Its front is that of no document: it is a word of the prose."""
    project.change("It beats once a second.", "It beats once a second (depends on UTF-8).")
    assert project.run() == 0
    assert main(["explain", "--project", project.file, "FR-1.1"]) == 0
    assert "\n  depends on" not in capsys.readouterr().out


def test_a_circle_of_three(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """It is told once, with each of its places."""
    project.change("It beats once a second.", "It beats once a second (depends on criterion 3).")
    project.change("It is heard at 10 m.", "It is heard at 10 m (depends on criterion 4).")
    project.change("Nobody has written", "(depends on criterion 1) Nobody has written")
    assert project.run() == 1
    said = capsys.readouterr().out
    assert said.count("dependency-cycle") == 1
    assert "FR-1.md:10:1: error dependency-cycle: FR-1.1 on FR-1.3 on FR-1.4 on FR-1.1" in said
    assert "FR-1.md:13:1: FR-1.3 depends on FR-1.4" in said
    assert "FR-1.md:14:1: FR-1.4 depends on FR-1.1" in said


def test_circles_that_share_a_criterion_and_long_ways() -> None:
    """Each criterion is looked at once, and 10,000 in a row need no recursion."""
    assert list(_circles({"a": ["b"], "b": ["c", "d"], "c": ["a"], "d": ["d"]})) == [["a", "b", "c"], ["d"]]
    assert list(_circles({"a": ["b", "c"], "b": ["d"], "c": ["d"]})) == []
    ways = {f"{number}": [f"{number + 1}"] for number in range(10_000)}
    assert list(_circles(ways)) == []
    assert [len(each) for each in _circles(ways | {"10000": ["0"]})] == [10_001]


@pytest.fixture
def chained(project: Project) -> Project:
    """The mode depends on the beat, and that on what nobody has written a test for."""
    project.change("nobody reads.", "nobody reads (depends on FR-old.1).")
    project.change("It beats once a second.", "It beats once a second (depends on criterion 4).")
    return project


def test_the_tree_and_explain_show_them(chained: Project, capsys: pytest.CaptureFixture[str]) -> None:
    assert chained.run("FR-1.1") == 0
    said = capsys.readouterr().out
    assert "    depends on\n      FR-1.4\n    is needed by\n      FR-1.2\n" in said
    assert main(["explain", "--project", chained.file, "FR-1.1"]) == 0
    said = capsys.readouterr().out
    assert "  depends on FR-1.4\n  FR-1.2 depends on it\n" in said


def test_page_and_markdown_show_them(chained: Project, capsys: pytest.CaptureFixture[str]) -> None:
    assert chained.run("--format", "html") == 0
    said = re.sub(r'<span class="whole">(.*?)</span>', r"\1", capsys.readouterr().out)
    assert '<p>depends on <a href="#FR-1.4">FR-1.4</a></p>' in said
    assert '<p>needed by <a href="#FR-1.2">FR-1.2</a></p>' in said
    assert chained.run("--format", "markdown") == 0
    assert "; depends on FR-1.4; needed by FR-1.2 |" in capsys.readouterr().out


def test_a_criterion_is_told_that_what_it_depends_on_has_no_test(
    chained: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    """By detours, too; without results a test that is there is enough."""
    chained.change("- Criteria 3 and 4: the radio", "- Criterion 3: the radio")
    assert chained.run("--fail-on", "none") == 0
    said = capsys.readouterr().out
    assert "FR-1.md:10:1: warning trace-dependency: FR-1.1 depends on FR-1.4, which has no test" in said
    assert "FR-1.md:11:1: warning trace-dependency: FR-1.2 depends by way of others on FR-1.4, which has no" in said
    assert re.search(r"\n  depends on what is not shown +2\n", said)
    assert chained.run("--fail-on", "dependency") == 1
    assert "error trace-dependency: FR-1.1" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("outcome", "told"),
    [
        ("failure", "FR-1.2 depends on FR-1.1, which has failed"),
        ("skipped", "FR-1.2 depends on FR-1.1, which has passed only partly"),
        ("passed", "FR-1.2 depends by way of others on FR-1.4, which only the bench shows"),
    ],
)
def test_a_criterion_is_told_that_what_it_depends_on_has_not_passed(
    outcome: str, told: str, chained: Project, junit: Junit, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its own tests have all passed; what they show holds only where the other criterion is met."""
    trace, _ = chained.trace()
    suite = [test for test in trace.tests if not test.place]
    cases = [
        (f"{test.file[:-3].replace('/', '.')}", f"{test.function}[{case}]", "passed", (), test.inputs)
        for test in suite
        for case in test.cases
    ]
    beats = [(BEATS[0], f"test_beats[{n}]", outcome, ("FR-1.1", "FR-1.3"), None) for n in (1, 2)]
    path = junit("r.xml", *cases, ("tests.test_beat.TestMode", "test_seven", "passed", ("FR-1.2",), None), *beats)
    chained.run("--results", path)
    assert f"warning trace-dependency: {told}" in capsys.readouterr().out
    chained.run("--results", path, "FR-1.2")
    assert "FR-1.2  [passed;" in capsys.readouterr().out
    chained.run("--results", path, "--format", "html")
    assert '<span class="badge warn">passed</span>' in capsys.readouterr().out


def test_however_long_the_way_is(chained: Project, capsys: pytest.CaptureFixture[str]) -> None:
    chained.change("- Criteria 3 and 4: the radio", "- Criterion 3: the radio")
    chained.change("It is heard at 10 m.", "It is heard at 10 m (depends on criterion 2).")
    chained.run("--fail-on", "none")
    assert "trace-dependency: FR-1.3 depends by way of others on FR-1.4, which has no test" in capsys.readouterr().out
