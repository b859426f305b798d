"""Failsafes that cannot be, and those that just can: each finding at its place, and nothing else with it."""

from pathlib import Path

import pytest
from edited_project import edited

PROJECT = Path(__file__).resolve().parents[1] / "projects" / "watched_boat" / "specs"
VEHICLE = PROJECT / "vehicle.yaml"
HOT = "        above: 100 degC\n"
OR = "        or: [{watches: motor.current, above: 40 A, after: 500 ms}]\n"
SHALLOW = "      shallow: {below: SHALLOW, action: stop, after: 1 s, requirement: FR-201.2}\n"
ARM = "    to_arm: [{below: DEPTH_ARM}]\n"
SILENT = "      silent: {after: FS_GCS_TIMEOUT, action: slow, requirement: FR-201.4}\n"
LOST = "      lost: {after: 20 s, action: stop, requirement: FR-201.4}\n"
GONE = "      gone: {after: 60 s, requirement: FR-201.4}\n"
SLACK = "    hysteresis: 5 degC\n"
LEVEL = "    level: level\n"
DEEPER = "      aground: {below: 1 m, requirement: FR-201.2}\n"
LOW = "      low: {below: 1 m, requirement: FR-201.2}\n"
CURRENT, DEPTH = "watches: motor.current, above: 40 A", "  depth:\n    watches: sounder.depth"
TITLED = "  depth:\n    title: "


def arming(count: int) -> str:
    """So many conditions to arm, beside the one of the level."""
    return f"    to_arm: [{', '.join(['{below: DEPTH_ARM}'] * count)}]\n"


# What is written instead, with § where the finding is; what it says, or nothing.
CASES = [
    ("  depth:\n", "  §Depth:\n", "'Depth' is no name of a failsafe: small letters, digits and _"),
    ("  depth:\n", "  d2_:\n", ""),
    (SHALLOW, SHALLOW.replace("shallow:", "§Shallow:"), "'Shallow' is no name of a level"),
    (SHALLOW, SHALLOW.replace("shallow:", "very shallow_2:"), ""),
    ("  depth:\n", TITLED + "§'{depth}'\n", "'{depth}' is no title"),
    ("  depth:\n", TITLED + "§'a\"b'\n", "is no title"),
    ("  depth:\n", TITLED + "§'a\\b'\n", "is no title"),
    ("  depth:\n", TITLED + "§\"a\\tb\"\n", "is no title"),
    ("  depth:\n", TITLED + "'Depth {number}'\n", ""),
    # levels
    (HOT, HOT + "        below: 5 degC\n", "a level says exactly one of below, above and unknown"),
    (HOT + OR, OR, "a level says exactly one of below, above and unknown"),
    (HOT + OR, HOT, ""),
    (SHALLOW, SHALLOW + DEEPER, ""),
    (SHALLOW, LOW + DEEPER.replace("1 m", "§1 m"), "aground is no worse than low, the level before it"),
    (SHALLOW, LOW.replace("1 m", "1.01 m") + DEEPER, ""),
    (LOST + GONE, LOST + GONE.replace("60 s", "§20 s"), "gone is no worse than lost, the level before it"),
    (LOST + GONE, LOST + GONE.replace("60 s", "20001 ms"), ""),
    # silence
    ("silence: ground_station", "silence: §the_pilot", "the_pilot is nobody to wait for, but ground_station is"),
    (GONE, GONE + "    health: §vehicle.load\n", "health is about a quantity, and silence has none"),
    (GONE, GONE + "    hysteresis: §5 s\n", "hysteresis is about a quantity, and silence has none"),
    (GONE, GONE + "    believed_above: §5 s\n", "believed_above is about a quantity, and silence has none"),
    (GONE, GONE + "    to_arm: §[{below: 1}]\n", "to_arm is about a quantity, and silence has none"),
    (GONE, GONE.replace("after: 60 s", "below: §5 s, after: 60 s"), "silence is compared with a time alone: after"),
    (GONE, GONE.replace("after: 60 s", "unknown: §true, after: 60 s"), "silence is compared with a time alone: after"),
    (GONE, "      §gone: {requirement: FR-201.4}\n", "how long it may be silent is not said"),
    (GONE, "      gone: {requirement: FR-201.4}\n    after: 61 s\n", ""),
    # what is compared, and with what
    (CURRENT, "watches: §sounder.depth, above: 40 m", "sounder.depth belongs to another component"),
    (CURRENT, "watches: §vehicle.armed, above: 40 A", "belongs to another component"),
    (DEPTH, DEPTH.replace("sounder.depth", "§vehicle.armed"), "vehicle.armed is not a number that can be compared"),
    (CURRENT, "watches: §motor.curent, above: 40 A", "motor has no quantity curent"),
    ("above: 40 A", "above: §TEMP_MAX", "TEMP_MAX is no threshold for motor.current: in whole cA"),
    ("above: 40 A", "above: §40.001 A", "40.001 A is not in whole cA, in which motor.current is kept"),
    ("above: 40 A", "above: 40.01 A", ""),
    ("above: 40 A", "above: §\u0664\u0660 A", "'\u0664\u0660 A' is not an amount"),
    ("above: 40 A", "above: §10737418.23 A", "motor.current is never above 10737418.23 A"),
    ("above: 40 A", "above: §10737418.24 A", "10737418.24 A is nothing to compare motor.current with"),
    ("above: 40 A", "above: §-10737418.24 A", "is nothing to compare motor.current with"),
    (SLACK, "    hysteresis: §-5 degC\n", "-5 degC is nothing to compare motor.temperature with"),
    (SLACK, "    hysteresis: 0 degC\n", ""),
    (SLACK, "    hysteresis: 5 K\n", ""),  # a difference, wherever the 0 of the unit is
    ("after: 500 ms", "after: 0 ms", ""),
    ("after: 500 ms", "after: 14400 s", ""),
    ("after: 500 ms", "after: §14400.001 s", "14400.001 s is not a time of whole ms, at most four hours"),
    ("after: 500 ms", "after: §-1 ms", "-1 ms is not a time of whole ms"),
    ("after: 500 ms", "after: §0.5 ms", "0.5 ms is not a time of whole ms"),
    ("after: 500 ms", "after: FS_GCS_TIMEOUT", ""),
    ("after: 500 ms", "after: §TEMP_MAX", "TEMP_MAX is not a time in whole milliseconds"),
    ("to_arm: [{below: DEPTH_ARM}]", "to_arm: [{below: DEPTH_ARM, after: §1 s}]", "has to hold for no time"),
    ("to_arm: [{below: DEPTH_ARM}]", "to_arm: [{below: DEPTH_ARM, hysteresis: §1 m}]", "has to hold for no time"),
    (ARM, arming(29), ""),
    (ARM, arming(30), "it has 31 conditions, and at most 30 are told apart"),
    # latches, actions, and what is set
    (GONE + "    latch: false\n", GONE, "what is latched is never over"),
    ("    latch: false\n" + SLACK, SLACK.replace("5 degC", "§5 degC"), "what is latched does not end"),
    ("    latch: false\n" + SLACK, "", ""),
    ("{after: 20 s, action: stop", "{after: 20 s, action: §stopp", "there is no action stopp"),
    ("{after: 20 s, action: stop", "{after: 20 s, action: §SHALLOW", "of SHALLOW are none of the actions"),
    (LEVEL, "    level: §temperature\n", "motor.temperature is not a number with an initial value"),
    (LEVEL, "    level: level\n    health: §level\n", "motor.level has the level already"),
    (LEVEL, "    level: §vehicle.unheard\n", "vehicle.unheard belongs to another component than motor"),
    ("    level: vehicle.unheard\n", "    level: §motor.level\n", "motor.level goes to 2, and there are 3 levels"),
    ("    level: vehicle.unheard\n", "    level: §vehicle.load\n", ""),
    # texts
    ("{value:.1} C", "{valeu:.1} C", "a text has no {valeu} to show"),
    ("{value:.1} C", "{value:.1} [C]", "[C] shows no quantity, so that nothing leaves it out"),
    ("{value:.1} C", "{value:.1} [C {value}]", ""),
    ("{value:.1} C", "{value:.1} ]C", "has braces, brackets, quotes or characters that no text has"),
    ("{value:.1} C", "{value:.1} }C", "has braces, brackets, quotes or characters that no text has"),
    ("{value:.1} C", "{value:.1} \\\\C", "has braces, brackets, quotes or characters that no text has"),
    ("over: Ground station is heard again", "over: §'{value} again'", "a text has no {value} to show"),
]  # fmt: skip


@pytest.mark.parametrize(("old", "new", "said"), CASES)
def test_a_failsafe(old: str, new: str, said: str, folder: Path) -> None:
    system, findings = edited(folder, ("vehicle.yaml", old, new.replace("§", "")))
    errors = [finding for finding in findings if finding.is_error]
    if not said:
        assert not errors
        assert system.program is not None
        assert len(system.program.failsafes) == 8
        return
    assert [said in finding.message for finding in errors] == [True], errors
    if "§" in new:
        before = VEHICLE.read_text().replace(old, new).partition("§")[0]
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        assert (errors[0].place.line, errors[0].place.column) == (line, column)
