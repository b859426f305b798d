"""The lock: which texts count as the same, and what accepting writes."""

import pytest
from trace_project import Project

from codegen.commands.trace import read_trace_lock
from codegen.diagnostics import Report
from codegen.trace.lock import HEAD, Review, accepted, lock_line, reviews, text_fingerprint


def review(project: Project) -> dict[str, str]:
    trace, _ = project.trace()
    report = Report()
    lock = read_trace_lock(project.file, report)
    assert list(report) == []
    return {name: each.name for name, each in reviews(trace, lock).items()}


def test_accepting_all(project: Project) -> None:
    assert set(review(project).values()) == {"NO_LOCK"}
    assert project.run("accept", "--all", "--reason", "first") == 0
    assert set(review(project).values()) == {"REVIEWED"}
    lines = project.lock.read_text().splitlines()
    assert len([line for line in lines if line.startswith("  FR-1.")]) == 4


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("`custom_mode` is **7**, which\n   nobody", "custom_mode is 7,   which nobody"),
        ("2. Its `custom_mode`", "2. Its *custom_mode*"),
        ("# FR-1 | A heartbeat", "# FR-1 | Another title"),
    ],
)
def test_what_changes_no_text(old: str, new: str, project: Project) -> None:
    """Line breaks, spaces and markup, and whatever is not the criterion."""
    project.run("accept", "--all", "--reason", "first")
    project.change(old, new)
    assert set(review(project).values()) == {"REVIEWED"}


@pytest.mark.parametrize(
    ("old", "new"), [("is **7**", "is **8**"), ("nobody reads.", "nobody reads"), ("Its `custom", "its `custom")]
)
def test_what_changes_it(old: str, new: str, project: Project) -> None:
    """A figure, a sign, the case of a letter (mV is not MV): that one is suspect and no other."""
    project.run("accept", "--all", "--reason", "first")
    project.change(old, new)
    found = review(project)
    assert found.pop("FR-1.2") == "CHANGED"
    assert set(found.values()) == {"REVIEWED"}


INSIDE = """2. The limits are:
   - below 1.5 m: stop
     1. at once

   ```text
   v = a * b
   ```

   > at 5 m

   Or at 6 m."""


CHANGED = [
    ("1.5 m", "9.5 m"),
    (": stop", ": go"),
    ("at once", "later"),
    ("a * b", "a + b"),
    ("at 5 m", "at 7 m"),
    ("6 m", "8 m"),
]


@pytest.mark.parametrize(("old", "new"), CHANGED)
def test_all_that_is_in_the_item_counts(old: str, new: str, project: Project) -> None:
    """Lists, steps, code, quotations and further paragraphs: the figures of a limit stand there."""
    project.change("2. Its `custom_mode` is **7**, which\n   nobody reads.", INSIDE)
    project.run("accept", "--all", "--reason", "first")
    project.change("   - below", "   * below")
    assert set(review(project).values()) == {"REVIEWED"}
    project.change(old, new)
    found = review(project)
    assert found.pop("FR-1.2") == "CHANGED"
    assert set(found.values()) == {"REVIEWED"}


def test_a_change_is_a_finding_until_it_is_accepted(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """With the rows that cite it, and with the line that accepts it; everything else of the lock stays as it is."""
    project.run("accept", "--all", "--reason", "first")
    before = project.lock.read_text()
    project.change("once a second", "twice a second")
    capsys.readouterr()
    assert project.run("--fail-on", "suspect") == 1
    said = capsys.readouterr().out
    assert "specs/requirements/FR-1.md:10:1: error trace-suspect: FR-1.1 has another text than the one" in said
    assert 'codegen trace accept FR-1.1 --reason "..."' in said
    assert "specs/messages/heartbeat.yaml:1:1: message HEARTBEAT cites it" in said
    project.run("FR-1.1")
    assert "FR-1.1  [has tests; changed since it was reviewed]" in capsys.readouterr().out
    project.run("--format", "html")
    assert 'id="FR-1.1" data-tags="suspect by-hand"' in capsys.readouterr().out
    project.run("--format", "markdown")
    assert "FR-1.1 (suspect): " in capsys.readouterr().out
    assert project.run("accept", "FR-old.1", "--reason", "still 1 Hz", "--by", "Jo") == 0
    assert project.run("--fail-on", "suspect") == 0
    after = project.lock.read_text()
    assert [line for line in after.splitlines() if line not in before] == [
        lock_line("FR-1.1", "It beats twice a second.", "still 1 Hz", "Jo").rstrip("\n")
    ]
    assert len(after.splitlines()) == len(before.splitlines())


def test_a_criterion_that_is_new(project: Project) -> None:
    project.run("accept", "--all", "--reason", "first")
    project.change("\n## What", "5. It is blue.\n\n## What")
    assert review(project)["FR-1.5"] == "NEW"
    assert project.run("--fail-on", "suspect") == 1


def test_a_criterion_that_is_gone(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    project.run("accept", "--all", "--reason", "first")
    project.change("4. Nobody has written a test for this.\n", "")
    capsys.readouterr()
    assert project.run("--fail-on", "orphaned") == 1
    assert "specs/trace.lock.yaml:7:3: error trace-orphaned: the lock has FR-1.4" in capsys.readouterr().out
    assert project.run("accept", "FR-1.1", "--reason", "another") == 0
    assert "FR-1.4" in project.lock.read_text()
    assert project.run("accept", "FR-1.4", "--reason", "removed") == 0
    assert "FR-1.4" not in project.lock.read_text()
    assert project.run("--fail-on", "orphaned") == 0


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["accept", "FR-1.9", "--reason", "x"], "no document has FR-1.9; did you mean FR-1"),
        (["accept", "FR-1.1", "--reason", "  "], "accept needs --reason"),
        (["accept", "FR-1.1"], "accept needs --reason"),
        (["accept", "--reason", "x"], "either ids or --all"),
        (["accept", "FR-1.1", "--all", "--reason", "x"], "either ids or --all"),
        (["accept", "FR-1.1", "--reason", "x", "--out", "f"], "takes neither"),
        (["FR-1.1", "--reason", "x"], "--reason belongs to"),
        (["FR-2"], "no document has FR-2; did you mean FR-1"),
        (["--fail-on", "everything"], "everything is none of"),
        (["--fail-on", ""], "nothing is none of"),
        (["--fail-on", " ,"], "nothing is none of"),
        (["--fail-on", "none,uncovered"], "none goes with no other"),
    ],
)
def test_wrong_usage(arguments: list[str], said: str, project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    assert project.run(*arguments) == 2
    assert said in capsys.readouterr().err
    assert not project.lock.exists()


@pytest.mark.parametrize("text", ["criteria: [\n", "criteria:\n  FR-1.1: {txt: x}\n", "\x00"])
def test_a_lock_that_cannot_be_read_is_left_alone(text: str, project: Project) -> None:
    project.lock.write_text(text)
    assert project.run("accept", "--all", "--reason", "x") in (1, 2)
    assert project.lock.read_text() == text
    assert project.run() in (1, 2)


@pytest.mark.parametrize(
    "text",
    [
        'criteria: {FR-1.1: {text: "aaaaaaaaaaaa", reason: "a"}}\n',
        'criteria:\n    FR-1.1: {text: "aaaaaaaaaaaa", reason: "a"}\n',
        'criteria:\n  "FR-1.1": {text: "aaaaaaaaaaaa", reason: "a"}\n',
    ],
)
def test_a_lock_in_another_form_is_left_alone(text: str, project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """It can be read; adding lines to it would break it, or say the same thing twice."""
    project.lock.write_text(text)
    assert project.run("accept", "--all", "--reason", "x") == 1
    assert "specs/trace.lock.yaml:1:1: error trace-lock-form" in capsys.readouterr().out
    assert project.lock.read_text() == text


def test_what_people_write_into_the_lock_stays() -> None:
    """Comments, an entry over several lines, another order: only the lines of what is accepted change."""
    written = HEAD + (
        "  # the loop\n"
        '  FR-2.1: {text: "aaaaaaaaaaaa", reason: "a"}\n'
        "  FR-2.10:\n"
        '    text: "bbbbbbbbbbbb"\n'
        "    reason: >-\n"
        "      long\n"
        "  # the end\n"
    )
    lines = {name: lock_line(name, "t", "r", None) for name in ("FR-2.2", "FR-10.1", "FR-2.10")}
    text = accepted(written, lines)
    assert text == HEAD + (
        lines["FR-10.1"]
        + "  # the loop\n"
        + '  FR-2.1: {text: "aaaaaaaaaaaa", reason: "a"}\n'
        + lines["FR-2.2"]
        + lines["FR-2.10"]
        + "  # the end\n"
    )
    assert "long" not in text
    assert text.count("# the") == 2
    assert accepted(text, lines) == text


@pytest.mark.parametrize("start", [None, "", "criteria: {}\n", "criteria:\n", HEAD, "# mine\n"])
def test_wherever_one_begins(start: str | None) -> None:
    line = lock_line("FR-1.1", "t", 'a "b" \\ # {c}: é', None)
    assert accepted(start, {"FR-1.1": line}).endswith(f"criteria:\n{line}")
    assert line.count("\n") == 1


def test_what_is_struck_is_another_text() -> None:
    """Marks of emphasis are not; a criterion that was struck kept its review."""
    assert text_fingerprint("It *beats* `once`.") == text_fingerprint("It beats once.")
    assert (
        len({text_fingerprint(text) for text in ("It beats.", "~~It beats.~~", "~~It~~ beats.", "It ~~beats.~~")}) == 4
    )


def test_any_reason_is_read_as_it_was_given(project: Project) -> None:
    reason = 'a "b" \\ # {c}: é, \t- y'
    assert project.run("accept", "FR-1.1", "--reason", reason) == 0
    lock = read_trace_lock(project.file, Report())
    assert lock is not None
    assert lock.criteria["FR-1.1"].reason == " ".join(reason.split())
    assert lock.criteria["FR-1.1"].text == text_fingerprint("It beats once a second.")
    assert Review.NEW in reviews(project.trace()[0], lock).values()
