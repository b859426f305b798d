"""Names, curves and limits that nothing looked at: what has no effect is told, and what cannot be meant is refused."""

import os

import pytest
from test_broken_generations import changed

from codegen.cli import main

pytestmark = pytest.mark.usefixtures("without_output")

LION = "3.92 V: 70"
CASES = {
    "a misspelt name beside a right one": (
        [("receiver.yaml", "[current, current_battery]", "[current, curent_battery]")],
        0,
        "specs/receiver.yaml:9:22: warning unplayed-role: no message of the dialect has curent_battery\n"
        "  hint: did you mean current_battery?",
    ),
    "a name that is empty": (
        [("receiver.yaml", "[current, current_battery]", '[current, ""]')],
        0,
        "warning unplayed-role: no message of the dialect has ''\n  hint: leave it out",
    ),
    "charging that no enum has": (
        [("receiver.yaml", "[MAV_BATTERY_CHARGE_STATE_CHARGING, MAV_BATTERY_STATUS_FLAGS_CHARGING]", "[abc]")],
        0,
        "warning unplayed-role: no enum of what is received has abc",
    ),
    "charging misspelt": (
        [("receiver.yaml", "[MAV_BATTERY_CHARGE_STATE_CHARGING, ", "[MAV_BATTERY_CHARGE_STATE_CHARGIN, ")],
        0,
        "no enum of the dialect has MAV_BATTERY_CHARGE_STATE_CHARGIN\n"
        "  hint: did you mean MAV_BATTERY_CHARGE_STATE_CHARGING?",
    ),
    "a curve that nothing names": (
        [("board.yaml", "    spare: true", "    #")],
        0,
        "specs/board.yaml:71:3: warning unused-curve: nothing is estimated by the curve discharge\n"
        "  hint: curve: discharge at a quantity with estimate_from; spare: true",
    ),
    "a choice of nothing": (
        [("board.yaml", "    choice: chemistry", "    choice: chemystry")],
        1,
        "specs/board.yaml:73:13: error bad-curve: board.yaml states no chemystry of any component\n"
        "  hint: did you mean chemistry?",
    ),
    "a count of nothing": (
        [("board.yaml", "    per: cells", "    per: nothing")],
        1,
        "specs/board.yaml:74:10: error bad-curve: board.yaml states no nothing of any component",
    ),
    "a choice without points": (
        [("board.yaml", "    choice: chemistry\n", "")],
        1,
        "error bad-curve: the curve discharge has neither points alone, nor a choice",
    ),
    "points that turn back": ([("board.yaml", LION, "3.92 V: -1")], 1, "whose values rise or fall throughout"),
    "no amount": ([("board.yaml", LION, "high: 70")], 1, "error bad-curve: 'high' is no amount with a unit"),
    "another kind": ([("board.yaml", LION, "3.92 A: 70")], 1, "amounts of the curve discharge are of several kinds"),
    "a limit that nothing passes": (
        [("board.yaml", "read_limit: 2 ms", "read_limit: 1 s")],
        0,
        "warning idle-limit: a mean of battery_voltage may take 1000 ms, and it is read every 100 ms",
    ),
    "a parameter that a second instance does not look at": (
        [
            (
                "parameters.yaml",
                "  BATT_CAPACITY:\n    doc: Charge of the full pack.\n    for_each: battery\n",
                "  BATT2_CAPACITY: {doc: Of the second., type: int32, unit: mAh, default: 9, min: 0, max: 99, step: 1}\n"
                "  BATT_CAPACITY:\n    doc: Charge of the full pack.\n",
            )
        ],
        0,
        "warning idle-parameter: BATT2_CAPACITY is no parameter of battery 2, which goes by BATT_CAPACITY\n"
        "  hint: write for_each: battery at BATT_CAPACITY, and leave BATT2_CAPACITY out, or call it otherwise",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_it_is_told(name, tmp_path, monkeypatch, capsys):
    """At its place, with what to write."""
    edits, code, said = CASES[name]
    changed(tmp_path, *edits)
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == code
    assert said in capsys.readouterr().out


def test_points_that_no_instance_chooses_are_looked_at(tmp_path, monkeypatch, capsys):
    """Of a curve that is used, too: another pack may choose them."""
    used = ("state.yaml", "        left_of: BATT_CAPACITY\n        after: consumed\n", "")
    changed(tmp_path, used, ("state.yaml", "        doc: Charge that is left, of a", "        estimate_from: voltage\n"
            "        curve: discharge\n        doc: Charge that is left, of a"), ("board.yaml", LION, "3.92 V: -1"))  # fmt: skip
    monkeypatch.chdir(tmp_path)
    main(["check"])
    found = capsys.readouterr().out
    assert "specs/board.yaml:80:9: error bad-curve: a curve has two points" in found, found
    assert "specs/board.yaml:71:3: warning unused-curve" not in found


def test_a_folder_that_leads_back_is_not_looked_into(tmp_path, monkeypatch, capsys):
    """What lies there is read at its own place; a link that leads nowhere is told as one."""
    changed(tmp_path)
    monkeypatch.chdir(tmp_path)
    os.symlink(".", tmp_path / "specs" / "messages" / "self")
    os.symlink("..", tmp_path / "specs" / "requirements" / "above")
    assert main(["check"]) == 0
    assert "unread-file" not in capsys.readouterr().out
    os.symlink("nowhere.yaml", tmp_path / "specs" / "messages" / "gone.yaml")
    assert main(["check"]) == 2
    found = capsys.readouterr().out
    assert "file-not-found: specs/messages/gone.yaml is a link to nowhere.yaml, which does not exist" in found
    assert "let it lead to a file, or remove the link" in found
