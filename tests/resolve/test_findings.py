"""What else cannot be, in projects that are small: each finding at its place, once."""

import shutil
from pathlib import Path

import pytest
from edited_project import edited

PROJECTS = Path(__file__).resolve().parents[1] / "projects"
FIRST = "first_number: CAM_FIRST"
TWO_CAMERAS = "    - {doc: Astern., facts: {view: astern}}\n    - {doc: Down., facts: {view: down}}\n"
CAMERA = "    - {doc: Down., facts: {view: down}}\n"
LEFT_PACK = "    - {prefix: LEFT_, doc: The left one.}\n"
RIGHT_PACK = "    - prefix: RIGHT_\n"
TUNE = "  tune: {state: tune.notes}\n"

# The project and its file, what is written in place of what, with § where the finding is; what it says, or nothing.
CASES = [
    # numbers of instances
    (
        "three_cameras",
        "parameters.yaml",
        "max: 200, step: 1",
        "max: 255, step: 1",
        "stream_id cannot carry an instance number up to 257",
    ),
    ("three_cameras", "parameters.yaml", "max: 200, step: 1", "max: 253, step: 1", ""),
    (
        "three_cameras",
        "parameters.yaml",
        "type: uint8, default: 1, min: 1, max: 200",
        "default: 1, min: 1, max: 256",
        "CAM_FIRST is not a whole number from 0 to 255",
    ),
    ("three_cameras", "parameters.yaml", "min: 1, max: 200", "min: 0, max: 200", ""),
    (
        "three_cameras",
        "parameters.yaml",
        "type: uint8, default: 1, min: 1",
        "default: 1, min: -1",
        "CAM_FIRST is not a whole number from 0 to 255",
    ),
    (
        "three_cameras",
        "parameters.yaml",
        "type: uint8, default: 1, min: 1, max: 200, step: 1",
        "default: 1, min: 1, max: 200, step: 0.5",
        "CAM_FIRST is not a whole number",
    ),
    ("three_cameras", "state.yaml", FIRST, "first_number: §CAM_LAST", "there is no parameter CAM_LAST"),
    ("three_cameras", "parameters.yaml", ", reboot: true", "", "CAM_FIRST is looked at when the board starts"),
    (
        "power_monitor",
        "state.yaml",
        "enabled_by: BATT_MONITOR",
        "enabled_by: §BATT_CAPACITY",
        "BATT_CAPACITY is looked at when the board starts",
    ),
    ("three_cameras", "board.yaml", CAMERA, CAMERA * 14, ""),
    ("three_cameras", "board.yaml", CAMERA, CAMERA * 15, "camera has 17 instances, not 1 to 16"),
    ("three_cameras", "board.yaml", "  camera:\n", "  cameras:\n", "the state has no component cameras"),
    # prefixes
    (
        "two_batteries",
        "board.yaml",
        LEFT_PACK,
        LEFT_PACK.replace("LEFT_", "§left_"),
        "left_ cannot be the front of a parameter's name",
    ),
    ("two_batteries", "board.yaml", RIGHT_PACK, "    - prefix: §LEFT_\n", "LEFT_ is the prefix of another pack"),
    (
        "two_batteries",
        "board.yaml",
        LEFT_PACK,
        "    - §{doc: The left one.}\n",
        "this pack has no prefix for its parameters",
    ),
    # represented instances
    (
        "two_batteries",
        "messages/smart_battery_info.yaml",
        "represents: {pack: {first: true}}",
        "represents: {pack: {first: true}, house: §{first: true}}",
        "",
    ),
    (
        "two_batteries",
        "messages/battery_status.yaml",
        "for_each: pack\n",
        "for_each: pack\nrepresents: {pack: §{first: true}}\n",
        "the message is sent for each pack, and represents all of them",
    ),
    (
        "two_batteries",
        "messages/battery_status.yaml",
        "  voltages[0]:",
        "  §voltages[0:",
        "'voltages[0' is not a field",
    ),
    (
        "two_batteries",
        "messages/battery_status.yaml",
        "  voltages[5..9]: unknown",
        "  §voltages[4..9]: unknown",
        "is answered twice",
    ),
    (
        "two_batteries",
        "messages/battery_status.yaml",
        "  voltages[5..9]: unknown",
        "  §voltages[5..10]: unknown",
        "has the elements 0 to 9",
    ),
    (
        "two_batteries",
        "messages/battery_status.yaml",
        "  voltages[5..9]: unknown",
        "  §voltages[9..5]: unknown",
        "has the elements 0 to 9",
    ),
    (
        "two_batteries",
        "messages/smart_battery_info.yaml",
        "  device_name: {",
        "  §device_name[0]: {",
        "is answered as a whole, without an index",
    ),
    # texts, floats and lists that are received
    (
        "received",
        "receives/play_tune.yaml",
        TUNE,
        TUNE.replace("}", ", requirement: §FR-9}"),
        "no requirement document is called FR-9",
    ),
    (
        "received",
        "receives/gps_input.yaml",
        "  hdop: {state: fix.hdop, unchanged: [99.99]}\n",
        "  hdop: {state: §stick.pressed}\n",
        "hdop is a float, and stick.pressed a boolean quantity",
    ),
    (
        "received",
        "receives/gps_input.yaml",
        "  vn: {state: fix.north}\n",
        "  vn: {state: fix.north, rounding: §up}\n",
        "vn is a float, of which whole numbers are rounded to the nearest only",
    ),
    ("received", "receives/gps_input.yaml", "where: {gps_id: 0}", "where: {gps_id: §GPS}", "gps_id has no entry GPS"),
    # programs
    (
        "guarded",
        "vehicle.yaml",
        "links: 50 Hz",
        "links: §51 Hz",
        "links are served in a pass of the main loop, and that runs at 50 Hz only",
    ),
    (
        "guarded",
        "vehicle.yaml",
        "setup: [cable]",
        "setup: §[wifi]",
        "a key that comes over wifi is known to all that hear its network",
    ),
    (
        "guarded",
        "vehicle.yaml",
        "setup: [cable]",
        "setup: §[radio]",
        "radio is not open: whoever has no key yet could not bring one",
    ),
    ("guarded", "vehicle.yaml", "setup: [cable]", "setup: §[cabel]", "the board has no link cabel"),
    ("guarded", "vehicle.yaml", "wifi: signed", "wfi: signed", "the board has no link wfi"),
    ("guarded", "vehicle.yaml", "[255, 254]", "[1, 255]", ""),
    ("guarded", "vehicle.yaml", "[255, 254]", "[255, 256]", "256 is not a system id from 1 to 255"),
    ("guarded", "vehicle.yaml", "[255, 254]", "[255, 0]", "0 is not a system id from 1 to 255"),
    ("guarded", "vehicle.yaml", "chunk: 64", "chunk: 16", ""),
    ("guarded", "vehicle.yaml", "chunk: 64", "chunk: 256", ""),
    ("guarded", "vehicle.yaml", "chunk: 64", "chunk: §15", "a step writes 16 to 256 bytes, not 15"),
    ("guarded", "vehicle.yaml", "chunk: 64", "chunk: §257", "a step writes 16 to 256 bytes, not 257"),
    (
        "watched_boat",
        "vehicle.yaml",
        "value: 1, call: slow",
        "value: §0, call: slow",
        "0 stands for another action already, or for none",
    ),
    (
        "watched_boat",
        "vehicle.yaml",
        "value: 2, call: stop",
        "value: §1, call: stop",
        "1 stands for another action already, or for none",
    ),
    (
        "watched_boat",
        "vehicle.yaml",
        "call: slow, mode: 5",
        "call: slow, mode: §1001",
        "1001 is not a mode that vehicle.mode can have",
    ),
    ("watched_boat", "vehicle.yaml", "call: slow, mode: 5", "call: slow, mode: 1000", ""),
    ("watched_boat", "vehicle.yaml", "call: slow, mode: 5", "call: slow, mode: 0", ""),
    (
        "watched_boat",
        "vehicle.yaml",
        "  - {value: 2, call: stop",
        "  - {value: 2, call: §arm",
        "arm cannot be the name of a call of its own",
    ),
    # receivers
    (
        "three_cameras",
        "receiver.yaml",
        "stale_after: 20 s",
        "stale_after: §20 V",
        "20 V is a voltage, but a time is needed",
    ),
    ("three_cameras", "receiver.yaml", "component: camera", "component: §camra", "the state has no component camra"),
    (
        "three_cameras",
        "messages/video_stream_information.yaml",
        "  stream_id: {state: camera.instance}",
        "  stream_id: {constant: 1}",
        "no message is sent for each camera with its number",
    ),
    # quantities
    (
        "watched_boat",
        "state.yaml",
        "  sounder:\n",
        "  §update_sounder:\n",
        "update_sounder cannot be the name of a component",
    ),
    (
        "watched_boat",
        "state.yaml",
        "      depth: {doc: To the ground., unit: m",
        "      depth: {doc: To the ground., invalid_after: §0, unit: m",
        "invalid_after of depth is 0, not 1 to 1000",
    ),
    ("watched_boat", "codegen.yaml", "project:", "system_id: §256\nproject:", "system id 256 is not 1 to 255"),
    ("watched_boat", "codegen.yaml", "project:", "protocol: §3\nproject:", "protocol 3 is not 1 or 2"),
]


@pytest.mark.parametrize(("project", "file", "old", "new", "said"), CASES)
def test_what_is_found(project: str, file: str, old: str, new: str, said: str, tmp_path: Path) -> None:
    folder = Path(shutil.copytree(PROJECTS / project / "specs", tmp_path / "specs"))
    before = (folder / file).read_text().partition(old)[0]
    _, findings = edited(folder, (file, old, new.replace("§", "")))
    errors = [finding for finding in findings if finding.is_error]
    if not said:
        assert not errors
        return
    (found,) = [finding for finding in errors if said in finding.message]
    if "§" in new:
        text, place = before + new.partition("§")[0], found.place
        assert place.file.endswith(file)
        assert (place.line, place.column) == (text.count("\n") + 1, len(text) - text.rfind("\n"))
