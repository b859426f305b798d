"""receiver.yaml with a fault, or beside tables that do not suit it: one finding at its place, and nothing is written."""

import pytest
from test_broken_tables import Case, changed_copy, check_place

from codegen.cli import main

RECEIVER = "receiver.yaml"

CASES = [
    Case("bad-receiver", RECEIVER, "component: battery", "component: §batery", "did you mean battery"),
    # a component of the state that no message is sent for
    Case("bad-receiver", RECEIVER, "component: battery", "component: §vehicle", "for_each: vehicle"),
    Case("missing-key", RECEIVER, "component: battery\n", "", "component"),
    Case("unknown-key", RECEIVER, "stale_after: 10 s", "§stale_afer: 10 s", "stale_after"),
    Case("bad-time", RECEIVER, "stale_after: 10 s", "stale_after: §0 s"),
    Case("bad-time", RECEIVER, "stale_after: 10 s", "stale_after: §2000 min"),
    Case("wrong-type", RECEIVER, "stale_after: 10 s", "stale_after: §soon"),
    Case("unit-mismatch", RECEIVER, "rate_over: 30 s", "rate_over: §30 V"),
    Case("unknown-requirement", RECEIVER, "requirement: FR-00075", "requirement: §FR-00075.77"),
]


@pytest.mark.parametrize("case", CASES, ids=[f"{case.rule}-{case.new[:24]}" for case in CASES])
def test_is_reported_at_its_place(case, tmp_path, monkeypatch, capsys):
    """A wrong receiver.yaml is an error with a place; no half of a receiver is written."""
    check_place(case, tmp_path, monkeypatch, capsys)


def test_a_project_without_the_file_has_no_receiver(tmp_path, monkeypatch, capsys):
    """The file is optional: without it nothing is found, and no file of a receiver is written."""
    changed_copy(Case("", RECEIVER, "component", "component"), tmp_path)
    (tmp_path / "specs" / RECEIVER).unlink()
    monkeypatch.chdir(tmp_path)
    assert main(["build"]) == 0, capsys.readouterr().out
    assert not (tmp_path / "generated" / "receiver").exists()
    assert not list((tmp_path / "generated" / "tests").glob("*receiver*"))


def test_a_role_that_nothing_plays_is_told(tmp_path, monkeypatch, capsys):
    """unplayed-role: what is computed from it stays unknown, which nobody would notice."""
    changed_copy(Case("", RECEIVER, "serial: [serial_number]", "serial: [serial_numbr]"), tmp_path)
    monkeypatch.chdir(tmp_path)
    main(["check"])
    found = capsys.readouterr().out
    assert "specs/receiver.yaml:14:11: warning unplayed-role: no message that is received has serial_numbr" in found
    assert "did you mean serial_number?" in found


def test_two_tables_of_one_message_are_told(tmp_path, monkeypatch, capsys):
    """A receiver cannot tell of which of them a frame is."""
    changed_copy(Case("", RECEIVER, "component", "component"), tmp_path)
    messages = tmp_path / "specs" / "messages"
    table = (messages / "battery_info.yaml").read_text()
    (messages / "battery_info_again.yaml").write_text(table.replace("BATTERY_INFO\n", "BATTERY_INFO\nas: again\n", 1))
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 1
    found = capsys.readouterr().out
    assert "error bad-receiver: BATTERY_INFO has several tables, " in found, found
    assert "look alike to a receiver" in found
