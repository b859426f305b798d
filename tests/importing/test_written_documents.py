"""Documents as MAVLink, ArduPilot and PX4 write them: what is read of each, and what is asked instead of guessed."""

from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.importing.answer import Sources
from codegen.importing.document import find_fields
from codegen.importing.proposal import check_declarations, propose

DOCUMENTS = Path(__file__).parent / "documents"

EXPECTED: dict[str, tuple[str | None, dict[str, str], list[tuple[str, int]]]] = {
    "attitude": (
        "ATTITUDE",
        {"rollspeed": "{constant: 0}"},
        [("document-prose", 12), ("document-prose", 13), ("document-prose", 14), ("document-prose", 15)],
    ),
    "battery": (
        "BATTERY_STATUS",
        {"id": "{constant: 0}", "temperature": "unknown", "current_consumed": "unknown", "energy_consumed": "unknown"},
        [
            ("document-prose", 8),
            ("document-prose", 9),
            ("document-prose", 11),
            ("document-prose", 12),
            ("document-prose", 15),
        ],
    ),
    "esc": (None, {}, [("document-without-fields", 3)]),
    "made-up-numbers": (
        "DISTANCE_SENSOR",
        {
            "min_distance": "{constant: 20}",
            "type": "{enum: MAV_DISTANCE_SENSOR_LASER}",
            "orientation": "{enum: MAV_SENSOR_ROTATION_PITCH_270}",
        },
        [
            ("document-placeholder", 9),
            ("document-prose", 7),
            ("document-range", 12),
            ("document-range", 14),
            ("document-sentinel", 10),
        ],
    ),
    "named-below": (
        "GLOBAL_POSITION_INT",
        {
            "lat": "{state: position.latitude}",
            "lon": "{state: position.longitude}",
            "vx": "{constant: 0}",
            "hdg": "unknown",
        },
        [("document-field", 9)],
    ),
    "obstacles": (
        "OBSTACLE_DISTANCE",
        {
            "sensor_type": "{enum: MAV_DISTANCE_SENSOR_UNKNOWN}",
            "increment": "{constant: 5}",
            "min_distance": "{constant: 20}",
            "max_distance": "{constant: 4500}",
            "angle_offset": "{constant: 0}",
            "frame": "{enum: MAV_FRAME_BODY_FRD}",
        },
        [("document-prose", 7), ("document-prose", 9), ("document-sentinel", 13)],
    ),
    "odometry": ("ODOMETRY", {}, [("document-field", 10), ("document-without-values", 5)]),
    "other-message": (
        "VFR_HUD",
        {
            "airspeed": "{constant: 0}",
            "groundspeed": "{state: boat.speed}",
            "heading": "{constant: 0}",
            "throttle": "{constant: 0}",
            "alt": "{constant: 0}",
            "climb": "{constant: 0}",
        },
        [],
    ),
    "pairs": (
        "HEARTBEAT",
        {"type": "{enum: MAV_TYPE_GROUND_ROVER}", "base_mode": "{flags: []}"},
        [("column-twice", 3), ("column-twice", 3)],
    ),
    "position": (
        "GLOBAL_POSITION_INT",
        {
            "time_boot_ms": "{clock: boot}",
            "lat": "{state: position.latitude}",
            "alt": "{constant: 0}",
            "hdg": "unknown",
        },
        [],
    ),
    "rangefinder": ("DISTANCE_SENSOR", {}, [("document-without-values", 3)]),
    "reference": ("GPS_RAW_INT", {}, [("document-without-values", 5)]),
    "set-to": (
        "SYSTEM_TIME",
        {"time_unix_usec": "{constant: 0}"},
        [("document-placeholder", 6), ("document-type", 5), ("document-unit", 5)],
    ),
    "side-by-side": (
        "BATTERY_STATUS",
        {"id": "{constant: 0}", "temperature": "unknown"},
        [("column-twice", 3), ("column-twice", 3), ("document-element", 7)],
    ),
    "two-messages": (None, {}, [("document-message", 3)]),
    "wind": (
        "WIND_COV",
        {
            "wind_x": "unknown",
            "wind_y": "unknown",
            "wind_z": "unknown",
            "wind_alt": "{constant: 0 m}",
            "horiz_accuracy": "unknown",
            "vert_accuracy": "unknown",
        },
        [("document-placeholder", 15), ("document-placeholder", 16)],
    ),
}
"""By document: the message, the answers that are read, and every finding but what is not mentioned, by line."""


def read(name: str, plain: Sources) -> tuple[str | None, dict[str, str], list[tuple[str, int]]]:
    path = DOCUMENTS / f"{name}.md"
    report = Report()
    found = find_fields(path.read_text(encoding="utf-8"), str(path), None, plain.dialect, report)
    answers: dict[str, str] = {}
    if found is not None:
        made = propose(found.lists, found.message, plain, report)
        for fields in found.lists:
            check_declarations(fields, found.message, report)
        answers = {each.target.label: each.reading.answer for each in made.answers if each.reading.answer is not None}
    return (found.message.name if found else None), answers, sorted((each.rule.id, each.place.line) for each in report)


def test_every_document_has_its_row() -> None:
    assert set(EXPECTED) == {path.stem for path in DOCUMENTS.glob("*.md")}
    assert len(EXPECTED) >= 14


@pytest.mark.parametrize("name", EXPECTED)
def test_what_is_read_and_what_is_asked(name: str, plain: Sources) -> None:
    assert read(name, plain) == EXPECTED[name]
