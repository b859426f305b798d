"""Tables of received messages that cannot be: each fault is reported at its place, and all of them in one run.

The cases change tests/projects/received; ``§`` stands before what is reported.
"""

import shutil
from dataclasses import dataclass
from pathlib import Path

import pytest

from codegen.cli import main

SPECS = Path(__file__).resolve().parents[1] / "projects" / "received" / "specs"
RC, STICK, FIX = "receives/rc_channels_override.yaml", "receives/manual_control.yaml", "receives/gps_input.yaml"
WHEELS, TUNE, MODE = "receives/wheel_distance.yaml", "receives/play_tune.yaml", "receives/heartbeat.yaml"
STATE = "state.yaml"


@dataclass(frozen=True)
class Case:
    """A change of one file: the rule and the words that are reported; ``others`` findings follow from it."""

    rule: str
    file: str
    old: str
    new: str
    says: str
    others: int = 0


CASES = [
    Case("unknown-message", RC, "RC_CHANNELS_OVERRIDE\n", "§RC_CHANEL_OVERRIDE\n", "did you mean RC_CHANNELS_OVERRIDE or"),
    Case("unknown-field", RC, "  chan1_raw:", "  §chan1_row:", "did you mean chan1_raw or"),
    Case("unknown-field", FIX, "{gps_id: 0}", "{gps_idx: §0}", "did you mean gps_id?"),
    Case("unknown-field", STICK, "ahead}", "ahead, when: {enabled_extension: §1}}", "did you mean enabled_extensions"),
    Case("bad-proviso", STICK, "ahead}", "ahead, when: {x: §1}}", "x is the field itself, and no other field"),
    Case("bad-proviso", FIX, "fix.yaw,", "fix.yaw, unless: {hdop: §1},", "hdop is float, and no other field of whole numbers"),
    Case("bad-proviso", WHEELS, "wheels.count}", "wheels.count, unless: {distance: §1}}", "distance is double[], and no other field"),
    Case("bad-proviso", STICK, "ahead}", "ahead, when: {enabled_extensions: §bit 8}}", "enabled_extensions has the bits 0 to 7"),
    Case("bad-proviso", STICK, "ahead}", "ahead, when: {enabled_extensions: §256}}", "carries whole numbers from 0 to 255"),
    Case("bad-proviso", STICK, "ahead}", "ahead, when: {enabled_extensions: §[]}}", "nothing is listed that enabled_extensions could say"),
    Case("bad-proviso", STICK, "ahead}", "ahead, when: {enabled_extensions: §[bit 1, 1]}}", "flags and numbers are mixed"),
    Case("bad-proviso", STICK, "ahead}", "ahead, when: {enabled_extensions: bit 1}, unless: {enabled_extensions: §2}}", "when and unless mix flags and numbers"),
    Case("bad-proviso", STICK, "ahead}", "ahead, when: {enabled_extensions: bit 1}, unless: {enabled_extensions: §[bit 2, bit 1]}}", "never both: when enabled_extensions has bit 1 (2), unless"),
    Case("bad-proviso", STICK, "ahead}", "ahead, when: {y: [1, 2]}, unless: {y: §[1, 2, 3]}}", "never both: when y is 1 or 2"),
    Case("bad-proviso", FIX, "fix.yaw,", "fix.yaw, when: {gps_id: §1},", "where of the table takes messages with gps_id 0 only: never when gps_id is 1"),
    Case("bad-proviso", FIX, "fix.yaw,", "fix.yaw, unless: {ignore_flags: §0},", "0 is no flag of ignore_flags, which are 16 bits"),
    Case("bad-proviso", FIX, "fix.yaw,", "fix.yaw, unless: {time_week_ms: §1},", "time_week_ms is uint32_t: no number of up to 16 bits"),
    Case("bad-proviso", STICK, "ahead}", "ahead, otherwise: §unchanged}", "nothing says when it is no value"),
    Case("unknown-enum-entry", FIX, "fix.yaw,", "fix.yaw, unless: {ignore_flags: §GPS_INPUT_IGNORE_FLAG_ALTI},", "did you mean GPS_INPUT_IGNORE_FLAG_ALT"),
    Case("unknown-enum-entry", STICK, "ahead}", "ahead, when: {enabled_extensions: §half}}", "has no entry half"),
    Case("unknown-enum-entry", STICK, "ahead}", "ahead, when: {enabled_extensions: §\u00b2}}", "has no entry \u00b2"),
    Case("unknown-choice", STICK, "ahead}", "ahead, when: {y: 1}, otherwise: §unchangd}", "did you mean unchanged"),
    Case("unknown-quantity", RC, "{state: rc.rudder}", "{state: §rc.ruder}", "did you mean rc.rudder or"),
    Case("unknown-key", RC, "from:", "§form:", "did you mean from?"),
    Case("unknown-requirement", RC, "requirement: FR-1.3", "requirement: §FR-1.33", "FR-1 has no criterion 33"),
    Case("unknown-requirement", RC, "requirement: FR-1.4}", "requirement: §FR-1.34}", "FR-1 has no criterion 34"),
    Case("unknown-aspect", RC, "{range: FR-1.4", "{ranges: §FR-1.4", "did you mean range?"),
    Case("missing-key", STICK, "requirement: FR-1.6\n", "", "requirement"),
    Case("unknown-choice", RC, "ground_station", "§gcs", "known: any, ground_station, own_system"),
    Case("unknown-element", WHEELS, "distance[15]:", "§distance[16]:", "16 elements, from 0"),
    Case("unknown-element", WHEELS, "distance[15]:", "§distance:", "write distance[0]"),
    Case("unknown-element", TUNE, "tune: {", "§tune[0]: {", "a text, taken as a whole"),
    Case("answered-twice", WHEELS, "distance[15]:", "§distance[0..0]:", "WHEEL_DISTANCE.distance[0..0] is taken twice"),
    Case("received-elsewhere", WHEELS, "wheels.count}", "§stick.buttons}", "stick.buttons is set by MANUAL_CONTROL.buttons already"),
    Case("received-elsewhere", STICK, "stick.buttons}", "§clock.boot}", "clock.boot is not for a message to set: counted"),
    Case("received-elsewhere", STATE, "buttons: {doc: Which are pressed., min", "buttons: {doc: Which are pressed., restarts_with: §time, min", "begin anew", 1),
    Case("unit-mismatch", RC, "{state: rc.rudder}", "{state: §wheels.spare}", "chan1_raw is a time (us), wheels.spare is a length (m)"),
    Case("uncarried-conversion", FIX, "lat: {state: fix.lat}", "lat: {state: §fix.angle}", "keep it in degE7"),
    Case("cannot-receive", WHEELS, "{state: wheels.right}", "{state: §wheels.near}", "a whole number of one word in mm"),
    Case("cannot-receive", WHEELS, "{state: wheels.right}", "{state: §wheels.each}", "wheels.each is a list, and distance sets single values"),
    Case("cannot-receive", WHEELS, "{state: wheels.right}", "{state: §'wheels.each[1]'}", "declare a quantity for each value that arrives"),
    Case("cannot-receive", TUNE, "{state: tune.notes}", "{state: §tune.short}", "tune has 30 characters, and tune.short keeps 29 bytes only"),
    Case("cannot-receive", TUNE, "{state: tune.notes}", "{state: tune.notes, §min: 3}".replace("§min: 3", "min: §3"), "min says nothing of a text"),
    Case("cannot-receive", TUNE, "{state: tune.notes}", "{state: §tune.figure}", "tune is a text, and tune.figure a number"),
    Case("cannot-receive", STICK, "{state: stick.pressed}", "{state: stick.pressed, max: §3}", "is no number, so max says nothing"),
    Case("cannot-receive", FIX, "{state: fix.time}", "{state: §fix.seconds}", "time_usec is too wide to be converted to s"),
    Case("not-an-enum-field", MODE, "custom_mode: {state: tune.program,", "custom_mode: {state: §tune.kind,", "tune.kind is a MAV_TYPE, custom_mode is of no enum"),
    Case("limit-beyond-field", RC, "min: 1000 us", "min: §499 us", "from 500 to 2500 on the wire anyway"),
    Case("unit-mismatch", RC, "min: 1000 us", "min: §1 m", "1 m is a length, but a time is needed"),
    Case("empty-limits", RC, "min: 1000 us", "min: §2.1", "nothing of chan2_raw is left"),
    Case("special-value", MODE, "[0xFFFFFFFF]", "§[UINT64_MAX]", "uint32_t carries whole numbers from 0 to 4294967295"),
    Case("special-value", MODE, "[0xFFFFFFFF]", "§[0.5]", "a uint32_t cannot carry 0.5"),
    Case("special-value", RC, "chan1_raw: {", "chan1_raw: {unchanged: §[UINT16_MAXI], ", "did you mean UINT16_MAX"),
    Case("special-value", RC, "chan1_raw: {", "chan1_raw: {unchanged: [5], unknown: §[5], ", "5 leaves the quantity as it was, and makes it unknown"),
    Case("special-value", TUNE, "{state: tune.notes}", "{state: tune.notes, unknown: §[0]}", "unknown says nothing of a text"),
    Case("empty-limits", RC, "{state: rc.rudder}", "{state: §rc.rudder, unchanged: [7]}".replace("§rc.rudder", "rc.rudder, min: §7, max: 7"), "nothing of chan1_raw is left"),
    Case("bad-condition", FIX, "{gps_id: 0}", "{gps_id: §256}", "gps_id carries whole numbers from 0 to 255"),
    Case("bad-condition", FIX, "{gps_id: 0}", "{alt: §0}", "no whole number of up to 16 bits"),
    Case("bad-condition", MODE, "from: ground_station", "where: {base_mode: §MAV_MODE_FLAG_SAFETY_ARMED}", "and no other one"),
    Case("unknown-enum-entry", MODE, "from: ground_station", "where: {type: §MAV_TYPE_GCSS}", "did you mean MAV_TYPE_GCS or"),
    Case("bad-table-name", FIX, "as: fix", "as: §Fix", "is no name of a table"),
    Case("bad-table-name", FIX, "as: fix", "as: §heartbeat", "is the name of another message, HEARTBEAT"),
    Case("bad-table-name", FIX, "as: fix", "as: §gps_input", "says nothing"),
    Case("duplicate-table", "receives/gps_input_2.yaml", "as: second_receiver", "as: §fix", "fix has a table already"),
    Case("nothing-receives", MODE, "receive: HEARTBEAT", "receive: §FILE_TRANSFER_PROTOCOL", "read the beginning of", 1),
    Case("cannot-receive", RC, "{state: rc.rudder}", '{state: §"rc.rudder[0]"}', "a part of rc.rudder, and a field sets a whole quantity"),
]  # fmt: skip

MORE = {
    "      count: {doc: How many there are.": "      spare: {doc: Rolled., unit: m}\n      near: {doc: d, unit: m, stored: mm}\n      each: {doc: d, unit: m, elements: 3}\n",
    "      program: {doc:": "      short: {doc: d, text: 29}\n      figure: {doc: d}\n      kind: {doc: d, enum: MAV_TYPE}\n",
    "      yaw: {doc:": "      angle: {doc: d, unit: rad}\n      seconds: {doc: d, unit: s, stored: s}\n",
}
"""Quantities that only these ask for are added to the state."""


def batches():
    """The cases, so many at once as change different files: one check tells what is wrong in all of them."""
    found = []
    for case in CASES:
        files = (case.file, STATE) if case.file != STATE else (STATE, *(each.file for each in CASES))
        batch = next((each for each in found if not {other.file for other in each} & set(files)), None)
        if batch is None:
            found.append(batch := [])
        batch.append(case)
    return found


@pytest.fixture
def project(tmp_path, monkeypatch):
    """A copy of the project, with the quantities."""
    shutil.copytree(SPECS, tmp_path / "specs")
    state = tmp_path / "specs" / STATE
    text = state.read_text()
    for before, more in MORE.items():
        assert text.count(before) == 1
        text = text.replace(before, more + before)
    state.write_text(text)
    monkeypatch.chdir(tmp_path)
    return tmp_path


def change(project, case):
    """Change the file; return where the finding is to be."""
    path = project / "specs" / case.file
    text = path.read_text()
    assert text.count(case.old) == 1, (case.file, case.old)
    text = text.replace(case.old, case.new)
    before, mark, after = text.partition("§")
    path.write_text(before + after)
    if not mark:
        return f"specs/{case.file}:"
    return f"specs/{case.file}:{before.count(chr(10)) + 1}:{len(before) - before.rfind(chr(10))}: error "


def errors(capsys):
    """The exit code of a check, the lines of its errors, and all that it says."""
    code = main(["check"])
    out = capsys.readouterr().out
    return code, [line for line in out.splitlines() if ": error " in line], out


@pytest.mark.parametrize("batch", batches(), ids=lambda batch: batch[0].rule)
def test_all_are_reported_at_their_places(batch, project, capsys):
    """The rules, the places, and words that help; nothing else is found."""
    places = [change(project, case) for case in batch]
    code, lines, out = errors(capsys)
    assert code in (1, 2)
    for case, place in zip(batch, places, strict=True):
        assert [line for line in lines if line.startswith(place) and f" {case.rule}: " in line], (case, out)
        assert case.says in out, (case, out)
    assert len(lines) == sum(1 + case.others for case in batch), out


def test_without_a_program_nothing_receives(project, capsys):
    """The program of vehicle.yaml is the one that reads the links."""
    (project / "specs" / "vehicle.yaml").unlink()
    code, lines, out = errors(capsys)
    assert code == 1
    assert len([line for line in lines if " nothing-receives: " in line]) == 9, out
    assert "hint: describe the program in vehicle.yaml" in out


def test_a_table_with_another_ending_is_told(project, capsys):
    """It would never be read."""
    (project / "specs" / "receives" / "ping.yml").write_text("receive: PING\n")
    main(["check"])
    out = capsys.readouterr().out
    assert "specs/receives/ping.yml:1:1: warning unread-file: nothing reads" in out
    assert "tables of received messages end in .yaml" in out
