"""A waiver excuses one finding for a time; one that excuses nothing is told."""

import time
from datetime import UTC, date, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from codegen.cli import main
from codegen.commands.waived import with_waivers
from codegen.decode.waivers import decode_waivers
from codegen.diagnostics import Diagnostic, Report, Rule
from codegen.findings.catalogue import rule_catalogue
from codegen.findings.waivers import LookedAt, apply_waivers
from codegen.load.files import DISK
from codegen.source import Place

SIZE = Rule("claim-size", "It is wrong.")
DOCUMENT = "/project/docs/notes.md"
FOUND = Diagnostic(Place(DOCUMENT, 7, 3), SIZE, "41 bytes: 54", fingerprint="0123456789ab")
WAIVER = """\
waivers:
  - id: W-1
    rule: claim-size
    document: notes.md
    fingerprint: 0123456789ab
    reason: It quotes another document,
      which we cannot change.
    owner: Ada
    expires: 2030-01-31
"""


def judged(tmp_path: Path, text: str, findings: Any = (FOUND,), day: str = "2030-01-30", **looked: Any) -> Report:
    """Return the report on findings and the waivers of a text on a day."""
    (tmp_path / "waivers.yaml").write_text(text)
    report = Report()
    waivers = decode_waivers(str(tmp_path / "waivers.yaml"), DISK, report)
    looked_at = LookedAt(**{"rules": {"claim-size"}, "files": {DOCUMENT}, **looked})
    rules = ("claim-size", "claim-rate")
    report.extend(apply_waivers(findings, waivers, date.fromisoformat(day), looked_at, rules.__contains__))
    return report


def told(report: Report) -> list[tuple[str, int, int]]:
    """Rule, line and column of what counts, sorted: in which folder the test runs shall not matter."""
    return sorted((found.rule.id, found.place.line, found.place.column) for found in report if found.waived is None)


def test_a_waived_finding_stays_but_does_not_count(tmp_path: Path) -> None:
    report = judged(tmp_path, WAIVER)
    assert told(report) == []
    (found,) = report
    assert (found.place, found.message) == (FOUND.place, FOUND.message)
    assert found.waived == "W-1, Ada, until 2030-01-31: It quotes another document, which we cannot change."
    assert (report.has_errors, report.exit_code) == (False, 0)


@pytest.mark.parametrize(
    ("written", "instead"),
    [("0123456789ab", "0123456789ac"), ("notes.md", "other/notes.md"), ("claim-size", "claim-rate")],
)
def test_a_waiver_is_for_one_finding_in_one_document_of_one_rule(tmp_path: Path, written: str, instead: str) -> None:
    assert ("claim-size", 7, 3) in told(judged(tmp_path, WAIVER.replace(written, instead)))


@pytest.mark.parametrize("document", ["docs/notes.md", "/project/docs/notes.md", "./docs/notes.md", "docs\\notes.md"])
def test_folders_make_a_document_clear(tmp_path: Path, document: str) -> None:
    assert told(judged(tmp_path, WAIVER.replace("notes.md", document))) == []


@pytest.mark.parametrize("day", ["2030-01-31", "2031-01-01"])
def test_from_its_day_on_the_finding_counts_again(tmp_path: Path, day: str) -> None:
    report = judged(tmp_path, WAIVER, day=day)
    assert told(report) == [("claim-size", 7, 3), ("waiver-expired", 9, 14)]
    assert report.exit_code == 1


def test_one_without_a_finding_is_told_at_its_own_line(tmp_path: Path) -> None:
    assert told(judged(tmp_path, WAIVER, ())) == [("waiver-unused", 2, 5)]
    assert told(judged(tmp_path, WAIVER, (), day="2031-01-01")) == [("waiver-unused", 2, 5)]


@pytest.mark.parametrize("looked", [{"files": {"/project/docs/others.md"}}, {"rules": {"claim-rate"}}])
def test_what_the_run_did_not_look_at_is_not_called_unused(tmp_path: Path, looked: Any) -> None:
    assert told(judged(tmp_path, WAIVER, (), **looked)) == []


def test_two_for_one_finding_or_with_one_name(tmp_path: Path) -> None:
    second = WAIVER.partition("\n")[2].replace("W-1", "W-2")
    assert told(judged(tmp_path, WAIVER + second)) == [("waiver-duplicate", 13, 18)]
    same_name = second.replace("W-2", "W-1").replace("0123456789ab", "aaaaaaaaaaaa")
    assert told(judged(tmp_path, WAIVER + same_name)) == [("waiver-duplicate", 10, 9), ("waiver-unused", 10, 5)]


@pytest.mark.parametrize(
    ("written", "instead", "finding"),
    [
        ("claim-size", "claim-seize", ("waiver-unknown-rule", 3, 11)),
        ("0123456789ab", "0123", ("waiver-form", 5, 18)),
        ("2030-01-31", "2030-02-30", ("waiver-form", 9, 14)),
        ("2030-01-31", "20300131x", ("waiver-form", 9, 14)),
        ("2030-01-31", "next year", ("waiver-form", 9, 14)),
        ("owner: Ada", 'owner: " "', ("waiver-form", 8, 12)),
    ],
)
def test_what_cannot_be_applied_is_told_and_excuses_nothing(
    tmp_path: Path, written: str, instead: str, finding: tuple[str, int, int]
) -> None:
    report = judged(tmp_path, WAIVER.replace(written, instead))
    assert told(report) == [("claim-size", 7, 3), finding]


def test_a_finding_without_fingerprint_cannot_be_waived(tmp_path: Path) -> None:
    bare = Diagnostic(FOUND.place, SIZE, "m")
    assert told(judged(tmp_path, WAIVER, (bare,))) == [("claim-size", 7, 3), ("waiver-unused", 2, 5)]


def test_a_broken_file_of_waivers_is_told_by_the_command(pipeline: Any, run: Any) -> None:
    folder = Path(pipeline.folder).parent / "specs"
    (folder / "waivers.yaml").write_text(WAIVER.replace("owner: Ada", "ower: Ada").replace("claim-size", "no-such"))
    code, out, err = run("check")
    assert code == 1
    assert out.splitlines()[0] == "specs/waivers.yaml:8:5: error unknown-key: unknown key 'ower'"
    assert err == "1 error\n"


@pytest.fixture
def every_module() -> None:
    """All modules are there before some are stood in for: what is imported then would miss what these do not have."""
    rule_catalogue()


@pytest.mark.usefixtures("every_module")
def test_the_command_says_which_rule_does_not_exist(pipeline: Any, run: Any) -> None:
    folder = Path(pipeline.folder).parent / "specs"
    (folder / "waivers.yaml").write_text(WAIVER.replace("claim-size", "no-such"))
    found, hint = run("check")[1].splitlines()
    assert found == "specs/waivers.yaml:3:11: error waiver-unknown-rule: there is no rule no-such"
    assert hint == "  hint: write the id that stands behind error or warning of the finding"
    assert main(["explain", "waiver-unknown-rule"]) == 0


@pytest.mark.parametrize("zone", ["Pacific/Kiritimati", "Pacific/Niue"])
def test_a_waiver_ends_everywhere_at_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, zone: str) -> None:
    """The day is that of UTC: a commit would be green on one computer and red on another one."""
    path = tmp_path / "waivers.yaml"
    today = datetime.now(UTC).date()
    found = Report()
    found.extend([FOUND])
    monkeypatch.setenv("TZ", zone)
    time.tzset()
    try:
        counts = []
        for day in (today, today + timedelta(days=1)):
            path.write_text(WAIVER.replace("2030-01-31", day.isoformat()))
            counts.append(bool(told(with_waivers(found, str(path), {"claim-size"}, {DOCUMENT}, DISK))))
    finally:
        monkeypatch.undo()
        time.tzset()
    assert counts == [True, False]
