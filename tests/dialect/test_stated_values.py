"""Numbers to which the words of a dialect give a meaning of their own are told apart from values, and from lists."""

import pytest

from codegen.decode.dialect.files import decode_dialect_files
from codegen.decode.shipped_corrections import shipped_corrections
from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_path
from codegen.model.dialect.dialect import Kind, WireField
from codegen.model.dialect.stated_values import stated_nan, stated_values
from codegen.resolve.dialect.dialect import resolve_dialect
from codegen.resolve.dialect.sentinel import number_on_wire

STATED = {
    "A value of UINT16_MAX means to ignore this field. A value of 0 means to release it.": {
        "UINT16_MAX": True,
        "0": False,
    },
    "A value of 0 or UINT16_MAX means to ignore this field, UINT16_MAX-1 to release it.": {
        "0": True,
        "UINT16_MAX": True,
        "UINT16_MAX-1": False,
    },
    "Baudrate of transfer. Zero means no change.": {"0": True},
    "Speed (-1 indicates no change, -2 indicates return to default vehicle speed)": {"-1": True, "-2": False},
    "-1 or 0 to ignore": {"-1": True, "0": True},
    "0: Ignore, 1: Clear, 2: Keep": {"0": True, "2": True},
    "If unknown, set to: 65535": {"65535": False},
    "If unknown: 25500 cm/s. If speed is larger than 25425 cm/s, use 25425 cm/s.": {"25500": False},
    "Loiter radius. A value of zero or NaN is ignored.": {"0": True},
    "-1 = it has failed, 0 = unknown, 1 = worst quality": {"-1": False, "0": False},
}
PLAIN = (
    "0: Satellite not used, 1: used for localization",
    "0: idle, 1: capture in progress",
    "Control output -1 .. 1",
    "Collective thrust, normalized to 0 .. 1 (-1 .. 1 for vehicles capable of reverse thrust)",
    "Starts at zero. Increases monotonically for each waypoint.",
    "X-axis, normalized to the range [-1000,1000].",
    "1 for pressed, 0 for released",
    "0 for all components, 1 to 6 for others",
    "Values: [1-100].",
    "-100 to 100 //Zooming step value to offset zoom from the current position.",
    "Output value: 1 means maximum positive output, 0 to center servos, -1 for maximum negative",
    "Use UTC where known; ignored by vehicles without GPS.",
    "Bitmap. Value of 0: not present. Value of 1: present.",
    "Yaw, use 36000 for north",
    "Values smaller than -1000 should be interpreted as unknown.",
)


@pytest.mark.parametrize("text", STATED)
def test_a_number_with_a_meaning_of_its_own_is_found(text):
    """Each, and whether it leaves things as they are."""
    assert {each.text: each.is_left for each in stated_values(text)} == STATED[text]


@pytest.mark.parametrize("text", PLAIN)
def test_what_is_a_value_is_not(text):
    """Ranges, lists of what numbers stand for, units, indices, and values below a limit."""
    assert list(stated_values(text)) == []


@pytest.mark.parametrize(
    ("text", "words", "is_left"),
    [
        (
            "Desired yaw angle. NaN to use the current system yaw heading mode (e.g. yaw to home).",
            "NaN to use the current system yaw heading mode",
            False,
        ),
        ("Landing gear position (Down: 0, Up: 1, NaN for no change)", "NaN for no change", True),
        ("Radius. A value of zero or NaN is ignored.", "A value of zero or NaN is ignored", True),
        ("Pitch angle (positive: up, NAN to be ignored).", "NAN to be ignored", True),
        ("Accuracy. Set to NaN if not known.", "Set to NaN if not known", False),
    ],
)
def test_words_about_nan_are_found(text, words, is_left):
    """In any case, with what is said of it, and whether it leaves things as they are."""
    found = stated_nan(text)
    assert found is not None
    assert (found.words, found.is_left, found.is_nan) == (words, is_left, True)


@pytest.mark.parametrize("text", ["Smaller than 0 maps to NaN.", "Banana, nano and finance.", "-1 to ignore"])
def test_no_words_about_nan_are_none(text):
    """What becomes of another number says nothing of what NaN means, and a part of a word is none."""
    assert stated_nan(text) is None


# Every field of common.xml with a number that neither an attribute nor a correction that comes with codegen speaks of.
OPEN = {
    "CAMERA_FOV_STATUS.alt_image": ["INT32_MIN"],
    "CAMERA_FOV_STATUS.lat_image": ["INT32_MIN"],
    "CAMERA_FOV_STATUS.lon_image": ["INT32_MIN"],
    "COMMAND_ACK.progress": ["255"],
    "DISTANCE_SENSOR.signal_quality": ["1"],
    "MANUAL_CONTROL.s": ["0"],
    "MANUAL_CONTROL.t": ["0"],
    "MESSAGE_INTERVAL.interval_us": ["-1", "0"],
    "MISSION_CURRENT.total": ["0"],
    "MISSION_REQUEST_PARTIAL_LIST.end_index": ["-1"],
    "ODOMETRY.quality": ["-1"],
    "PARAM_MAP_RC.param_index": ["-2"],
}


def test_of_common_xml_only_what_its_words_say_is_open():
    """A project that takes any other field as a plain value hears nothing."""
    report = Report()
    files = decode_dialect_files(shipped_dialect_path("common", DISK), DISK, report)
    dialect = resolve_dialect("common", files, (), report, shipped_corrections(files, DISK, report))
    found = {}
    for message in dialect.messages.values():
        for field in message.fields:
            if field.type.kind is Kind.CHAR or field.definition.enum:
                continue
            texts = [
                each.text for each in stated_values(field.definition.description) if not _is_spoken_of(each.text, field)
            ]
            if texts:
                found[f"{message.name}.{field.name}"] = texts
    assert found == OPEN, found


def _is_spoken_of(text: str, field: WireField) -> bool:
    number = number_on_wire(text, field.type, None)
    lists = f"{field.definition.unchanged or ''},{field.definition.unknown or ''}".split(",")
    return text in [each.strip() for each in lists] or bool(field.sentinel and number in field.sentinel.values)
