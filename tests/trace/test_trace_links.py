"""A changed text makes the links from its criterion suspect, each of which is looked at and accepted."""

import re

import pytest
from trace_project import Project

from codegen.cli import main
from codegen.commands.build import render_systems
from codegen.commands.trace import read_trace_lock
from codegen.diagnostics import Report
from codegen.project.systems import read_systems
from codegen.trace.link import Link, chosen_link, suspects
from codegen.trace.lock import Review, reviews, text_fingerprint

ROWS = (
    "message HEARTBEAT",
    *(f"field HEARTBEAT.{name}" for name in ("type", "autopilot", "base_mode", "system_status", "mavlink_version")),
)
ALL = (*ROWS, "test tests/test_beat.py::test_beats", "criterion FR-1.2")


@pytest.fixture
def changed(project: Project) -> Project:
    """All was reviewed; since then the beat, on which the mode depends, has another rate."""
    project.change("nobody reads.", "nobody reads (depends on criterion 1).")
    assert project.run("accept", "--all", "--reason", "first") == 0
    project.change("once a second", "twice a second")
    return project


def suspect(project: Project) -> dict[str, tuple[str, ...]]:
    """The names of the suspect links by criterion."""
    lock = read_trace_lock(project.file, Report())
    return {name: tuple(each.name for each in links) for name, links in suspects(project.trace()[0], lock).items()}


def review(project: Project) -> dict[str, Review]:
    """Return the lock's state of each criterion."""
    return dict(reviews(project.trace()[0], read_trace_lock(project.file, Report())))


def test_exactly_its_links_are_suspect(changed: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """A row, a test and a criterion, each with its place; nothing of any other criterion."""
    assert suspect(changed) == {"FR-1.1": ALL}
    capsys.readouterr()
    assert changed.run() == 1
    said = capsys.readouterr().out
    assert said.count("trace-suspect") == 1
    assert "specs/messages/heartbeat.yaml:1:1: message HEARTBEAT cites it\n" in said
    assert "tests/test_beat.py:4:26: test tests/test_beat.py::test_beats shows it\n" in said
    assert "specs/requirements/FR-1.md:11:1: criterion FR-1.2 depends on it\n" in said
    assert '--reason "...", with --link for single ones' in said


def test_one_by_one(changed: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """A link that was looked at is suspect no longer; with the last one the criterion is reviewed, by the lock, too."""
    before = changed.lock.read_text().splitlines()
    for number, link in enumerate(ALL):
        assert suspect(changed) == {"FR-1.1": ALL[number:]}
        assert changed.run() == 1
        assert changed.run("accept", "FR-1.1", "--link", link, "--reason", f"seen {number}", "--by", "Jo") == 0
    assert suspect(changed) == {}
    assert review(changed)["FR-1.1"] is Review.REVIEWED
    assert changed.run() == 0
    after = changed.lock.read_text().splitlines()
    assert len(after) == len(before)
    assert [line for line in after if line not in before] == [line for line in after if line.startswith("  FR-1.1:")]
    lock = read_trace_lock(changed.file, Report())
    assert lock is not None
    kept = lock.criteria["FR-1.1"]
    assert kept.text == text_fingerprint("It beats twice a second.")
    assert {name: (each.reason, each.by) for name, each in kept.links.items()} == {
        link: (f"seen {number}", "Jo") for number, link in enumerate(ALL)
    }
    said = capsys.readouterr().err
    assert "specs/trace.lock.yaml: 1 of the links from FR-1.1 accepted" in said
    assert "next: codegen build" in said, "build --check would find the page of the trace out of date"


def test_some_together_and_the_rest_with_the_criterion(changed: Project) -> None:
    """The short name of a link does as well; to accept the criterion is to accept what is left."""
    arguments = ["--link", "HEARTBEAT", "--link", "FR-1.2", "--reason", "seen"]
    assert changed.run("accept", "FR-1.1", *arguments) == 0
    assert suspect(changed) == {"FR-1.1": ALL[1:-1]}
    assert changed.run("accept", "FR-1.1", "--reason", "all of it") == 0
    assert suspect(changed) == {}
    assert "links" not in changed.lock.read_text()


def test_another_change_makes_all_suspect_again(changed: Project) -> None:
    """A link that was looked at with the text in between counts no more than one that never was."""
    assert changed.run("accept", "FR-1.1", "--link", ALL[0], "--reason", "seen") == 0
    changed.change("twice a second", "ten times a second")
    assert suspect(changed) == {"FR-1.1": ALL}
    assert changed.run("accept", "FR-1.1", "--link", ALL[-1], "--reason", "seen") == 0
    assert suspect(changed) == {"FR-1.1": ALL[:-1]}
    assert ALL[0] not in changed.lock.read_text()
    changed.change("ten times a second", "once a second")
    assert suspect(changed) == {}, "the text is the reviewed one again"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (
            ["FR-1.1", "--link", "HEARTBEET"],
            "HEARTBEET is none of its suspect links; did you mean message HEARTB",
        ),
        (["FR-1.2", "--link", "x"], "the text of FR-1.2 is the one that was reviewed: none of its links is suspect"),
        (["FR-1.1", "FR-1.2", "--link", "x"], "accept --link takes one criterion"),
        (["FR-1", "--link", "x"], "accept --link takes one criterion"),
        (["--all", "--link", "x"], "accept --link takes one criterion"),
    ],
)
def test_what_cannot_be_accepted(
    arguments: list[str], said: str, changed: Project, capsys: pytest.CaptureFixture[str]
) -> None:
    before = changed.lock.read_text()
    assert changed.run("accept", *arguments, "--reason", "x") == 2
    assert said in capsys.readouterr().err
    assert changed.lock.read_text() == before


def test_what_was_never_reviewed_is_accepted_as_a_whole(project: Project, capsys: pytest.CaptureFixture[str]) -> None:
    assert project.run("accept", "FR-1.1", "--link", "HEARTBEAT", "--reason", "x") == 2
    assert "FR-1.1 was never reviewed: accept it without --link" in capsys.readouterr().err
    assert project.run("--link", "HEARTBEAT") == 2
    assert "--link belongs to codegen trace accept" in capsys.readouterr().err


def test_reports_mark_what_is_suspect(changed: Project, capsys: pytest.CaptureFixture[str]) -> None:
    """The tree, the page and the Markdown; what was looked at is not marked."""
    assert changed.run("accept", "FR-1.1", "--link", "message HEARTBEAT", "--reason", "seen") == 0
    capsys.readouterr()
    changed.run("FR-1.1")
    said = capsys.readouterr().out
    assert re.search(r"message HEARTBEAT +specs/messages/heartbeat.yaml:1\n", said)
    assert re.search(r"field HEARTBEAT.type +specs/messages/heartbeat.yaml:5  suspect\n", said)
    assert "test_beats  suspect\n" in said
    assert "      FR-1.2  suspect\n" in said
    changed.run("--format", "html")
    page = capsys.readouterr().out
    assert page.count('<span class="bad">suspect</span>') == len(ALL) - 1
    changed.run("--format", "markdown")
    said = capsys.readouterr().out
    assert "needed by FR-1.2 (suspect)" in said
    assert "HEARTBEAT (`specs/messages/heartbeat.yaml:1`)<br>" in said


def test_the_page_of_a_build_marks_rows(changed: Project) -> None:
    """It knows the lock and nothing of tests by hand."""
    text = render_systems(read_systems(changed.file, Report())).files["docs/trace.html"]
    assert text.count('<span class="bad">suspect</span>') == len(ALL) - 1
    assert "test_beats" not in text


def test_the_lock_of_before_is_read(project: Project) -> None:
    """An entry without links is what every lock had so far; its line changes only when something is accepted."""
    old = "criteria:\n" + "".join(
        f'  FR-1.{number}: {{text: "{text_fingerprint(text)}", reason: "first"}}\n'
        for number, text in enumerate(("It beats once a second.", "other"), 1)
    )
    project.lock.write_text(old)
    assert review(project)["FR-1.1"] is Review.REVIEWED
    assert suspect(project)["FR-1.2"] == (
        "field HEARTBEAT.custom_mode",
        "test tests/test_beat.py::TestMode::test_seven",
    )
    assert project.run("accept", "FR-1.2", "--link", "HEARTBEAT.custom_mode", "--reason", "seen") == 0
    after = project.lock.read_text()
    assert after.startswith(old.splitlines(keepends=True)[0] + old.splitlines(keepends=True)[1])
    assert f'  FR-1.2: {{text: "{text_fingerprint("other")}", reason: "first", links: {{"field HEART' in after


def test_rows_of_two_programs_are_told_apart(project: Project) -> None:
    """One table of each program, called the same: either can be accepted without the other."""
    other = project.folder / "specs" / "small"
    (other / "messages").mkdir(parents=True)
    (other / "codegen.yaml").write_text("base: ..\nproject: small\n")
    table = (project.folder / "specs" / "messages" / "heartbeat.yaml").read_text()
    (other / "messages" / "heartbeat.yaml").write_text(table)
    listed = project.folder / "specs" / "codegen.yaml"
    listed.write_text(f"{listed.read_text()}programs: {{small: small/codegen.yaml}}\n")
    assert project.run("accept", "--all", "--reason", "first") == 0
    project.change("once a second", "twice a second")
    names = [name for name in suspect(project)["FR-1.1"] if name.startswith("message")]
    assert names == [
        "message HEARTBEAT in specs/messages/heartbeat.yaml",
        "message HEARTBEAT in small/messages/heartbeat.yaml",
    ]
    assert project.run("accept", "FR-1.1", "--link", names[1], "--reason", "seen") == 0
    assert names[1] not in suspect(project)["FR-1.1"]
    assert names[0] in suspect(project)["FR-1.1"]


def test_a_short_name_of_several_links() -> None:
    place = next(iter(Report()), None)
    links = [Link(f"{kind} GPS", place, "cites it") for kind in ("message", "received message")]  # type: ignore[arg-type]
    assert chosen_link("GPS", links) == "GPS can be message GPS or received message GPS"
    assert chosen_link("received message GPS", links) == links[1]


def test_the_shipped_lock_holds(capsys: pytest.CaptureFixture[str]) -> None:
    """It was written before links were told apart, and nothing in it had to change for that."""
    assert main(["trace", "--fail-on", "suspect"]) == 0
    assert "trace-suspect" not in capsys.readouterr().out
