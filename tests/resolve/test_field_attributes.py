"""Attributes of fields beside units and invalid: multiplier, minValue, maxValue, increment, default, display,
print_format and instance, each with the line of the dialect that states it.
"""

import json
import re
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import pytest
from in_process import build

from codegen.answers.limits import Bounds, dialect_bounds
from codegen.cli import main
from codegen.diagnostics import Report
from codegen.explain.story import explain
from codegen.load.files import DISK
from codegen.load.shipped import shipped_dialect_names, shipped_dialect_path
from codegen.model.dialect.dialect import Dialect, WireField
from codegen.model.dialect.literals import exact_number
from codegen.model.dialect.wire_unit import wire_unit
from codegen.model.units.unit import NUMBER, Unit, ratio
from codegen.project.systems import read_system
from codegen.targets.codec.layout import messages_text
from codegen.targets.codec.page import page_text
from codegen.targets.pages.value_text import value_text

PROJECT = Path(__file__).parents[1] / "projects" / "satellites"


@pytest.fixture(scope="module")
def dialect() -> Dialect:
    """common, as a project has it."""
    system = read_system(str(PROJECT / "specs" / "codegen.yaml"), Report())
    assert system is not None
    return system.dialect


def stated(dialect: Dialect, name: str, attribute: str) -> WireField:
    """The field, whose element in the XML has the attribute as it is written here."""
    message, _, field_name = name.partition(".")
    field = dialect.messages[message].field(field_name)
    assert field is not None
    place = field.definition.place
    line = Path(place.file).read_text(encoding="utf-8").splitlines()[place.line - 1]
    assert f'name="{field_name}"' in line
    assert attribute in line, line
    return field


MULTIPLIERS = [
    ("GPS_RAW_INT.eph", "1E-2", Fraction(1, 100)),
    ("GPS_RAW_INT.epv", "1E-2", Fraction(1, 100)),
    ("HIL_GPS.eph", "1E-2", Fraction(1, 100)),
    ("HIL_GPS.epv", "1E-2", Fraction(1, 100)),
    ("GPS_STATUS.satellite_azimuth", "360/255", Fraction(24, 17)),
]


def shipped_texts() -> list[str]:
    """The XML of every dialect that pymavlink ships."""
    paths = (shipped_dialect_path(name, DISK) for name in shipped_dialect_names(DISK))
    return [Path(path).read_text(encoding="utf-8") for path in paths if path]


@pytest.mark.parametrize(("name", "text", "multiplier"), MULTIPLIERS)
def test_a_multiplier_is_exact(name: str, text: str, multiplier: Fraction, dialect: Dialect) -> None:
    """A value in the units is the number on the wire times the multiplier."""
    field = stated(dialect, name, f'multiplier="{text}"')
    assert field.multiplier == multiplier
    unit = wire_unit(field)
    whole = Unit.parse(field.definition.units) if field.definition.units else NUMBER
    assert unit is not None
    assert whole is not None
    assert ratio(unit, whole) == multiplier
    assert field.unit_text == f"steps of {text} {field.definition.units or ''}".rstrip()


def test_no_other_field_of_pymavlink_has_one() -> None:
    """All that are written are in the list above."""
    found = re.compile(r'<field[^>]*name="(\w+)"[^>]*multiplier="([^"]+)"|<field[^>]*multiplier')
    texts = shipped_texts()
    names = [match.groups() for text in texts for match in found.finditer(text)]
    assert sorted(names) == sorted((name.partition(".")[2], text) for name, text, _ in MULTIPLIERS)


@pytest.fixture(scope="module")
def satellites(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The project, built."""
    folder = tmp_path_factory.mktemp("satellites")
    shutil.copytree(PROJECT / "specs", folder / "specs")
    build(folder)
    return folder


def test_values_go_out_and_come_back_times_the_multiplier(satellites: Path) -> None:
    """pymavlink decodes the frames; hdop 1.2 is 120 there, and 120 degrees of azimuth are 85."""
    from pymavlink.dialects.v20 import common  # noqa: PLC0415  the oracle

    script = [sys.executable, str(PROJECT / "multiplied.py"), str(satellites / "generated")]
    ran = subprocess.run(script, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr
    decoder = common.MAVLink(None)
    for one in json.loads(ran.stdout):
        raw, status, hil = (decoder.decode(bytearray.fromhex(frame)) for frame in one["frames"])
        hdop = one["hdop"]
        assert raw.eph == (65535 if hdop is None else min(hdop * 100, 65534))
        assert (raw.epv, hil.eph) == (120, 120), "a parameter of 1.2, and a constant"
        assert hil.epv == (65535 if hdop is None else min(max(hdop, 1), 2) * 100), "min and max are hdop"
        exact = Fraction(one["bearing"]) * 255 / 360
        assert abs(status.satellite_azimuth[0] - exact) <= Fraction(1, 2)
        assert abs(status.satellite_azimuth[0] * Fraction(360, 255) - one["bearing"]) <= Fraction(360, 510)
        assert status.satellite_azimuth[1:3] == [51, 85], "72 degrees, and 120"
        assert one["read"] == [1.2, None if hdop is None else min(max(hdop, 1), 2)]


def test_documents_explain_and_codec_say_it(satellites: Path, dialect: Dialect) -> None:
    """A reader of each is told what a number counts."""
    assert "steps of 360/255 deg" in (satellites / "generated" / "docs" / "telemetry.md").read_text()
    assert "85 steps of 360/255 deg" in (satellites / "generated/docs/messages/gps_status.html").read_text()
    system = read_system(str(PROJECT / "specs" / "codegen.yaml"), Report())
    story = explain("GPS_RAW_INT.eph", system, Report())
    assert "unit         steps of 1E-2" in story
    assert "kept in steps of 1E-2" in story
    assert "steps of 360/255 deg" in messages_text([dialect.messages["GPS_STATUS"]], 3)
    assert "| eph | uint16 | steps of 1E-2 |" in page_text("common", [dialect.messages["GPS_RAW_INT"]], [])


@pytest.mark.parametrize(
    ("answer", "finding"),
    [
        ("eph: {constant: 1.234}", "1.234 is not a whole number of steps of 1E-2"),
        ("eph: {constant: 655.35}", "65535 means unknown in eph"),
        ("eph: {constant: 655.36}", "655.36 is 65536, but eph (uint16_t) carries 0 to 65535"),
        ("eph: {constant: 1.2 V}", "1.2 V is a voltage, but a number is needed"),
        ("eph: {state: gps.hdop, max: 656}", "max of eph is 65600, but it carries 0 to 65534 only"),
    ],
)
def test_what_a_multiplied_field_cannot_carry(
    answer: str, finding: str, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """In the units of the field, not in its steps."""
    shutil.copytree(PROJECT / "specs", tmp_path / "specs")
    table = tmp_path / "specs" / "messages" / "gps_raw_int.yaml"
    table.write_text(table.read_text().replace("eph: {state: gps.hdop, max: 655.34}", answer))
    monkeypatch.chdir(tmp_path)
    assert main(["check"]) == 1
    assert finding in capsys.readouterr().out


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("1E-2", Fraction(1, 100)),
        ("360/255", Fraction(24, 17)),
        (" 2E-3 ", Fraction(1, 500)),
        ("-.5", Fraction(-1, 2)),
        ("1/0", None),
        ("1e999999999", None),
        ("1//2", None),
        ("one", None),
        ("", None),
        ("1/", None),
    ],
)
def test_numbers_of_attributes(text: str, number: Fraction | None) -> None:
    """Decimals and quotients, and nothing that would take long to compute."""
    assert exact_number(text) == number


def test_minimum_and_maximum_limit_what_is_sent(
    dialect: Dialect, tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A camera of an autopilot is 1 to 6, and 0 is none: 7 is refused, and a number that may be larger is limited."""
    stated(dialect, "VIDEO_STREAM_INFORMATION.camera_device_id", 'minValue="0" maxValue="6"')
    shutil.copytree(PROJECT.parent / "three_cameras" / "specs", tmp_path / "specs")
    table = tmp_path / "specs" / "messages" / "video_stream_information.yaml"
    text = table.read_text()
    monkeypatch.chdir(tmp_path)
    table.write_text(text.replace("camera_device_id: {constant: 0}", "camera_device_id: {constant: 7}"))
    assert main(["check"]) == 1
    assert "7 is 7, but camera_device_id (uint8_t) carries 0 to 6" in capsys.readouterr().out
    table.write_text(text.replace("camera_device_id: {constant: 0}", "camera_device_id: {parameter: CAM_FIRST}"))
    assert main(["explain", "VIDEO_STREAM_INFORMATION.camera_device_id"]) == 0
    assert "limits       1..6" in capsys.readouterr().out, "the parameter begins with 1"


def test_a_minimum_above_zero(dialect: Dialect) -> None:
    """The number of a stream begins with 1, and tells the instances apart."""
    field = stated(dialect, "CAMERA_THERMAL_RANGE.stream_id", 'minValue="1"')
    assert dialect_bounds(field) == Bounds(Fraction(1), None)
    assert stated(dialect, "CAMERA_THERMAL_RANGE.stream_id", 'instance="true"').definition.is_instance


def test_display_and_print_format(dialect: Dialect) -> None:
    """Bits are bits without an enum, too, and a page prints them as the dialect says."""
    field = stated(dialect, "TERRAIN_REQUEST.mask", 'display="bitmask" print_format="0x%07x"')
    assert field.definition.is_bitmask
    assert value_text(field, 255, {}) == "0x00000ff"
    assert value_text(stated(dialect, "TERRAIN_REQUEST.grid_spacing", 'units="m"'), 255, {}) == "255 m"


def test_a_default_is_what_nobody_sets(dialect: Dialect) -> None:
    """All of pymavlink's are 0, as fields of a message are that nobody set."""
    field = stated(dialect, "LANDING_TARGET.position_valid", 'default="0"')
    assert field.definition.default == "0"
    defaults = [match[1] for text in shipped_texts() for match in re.finditer(r'<field[^>]* default="([^"]*)"', text)]
    assert set(defaults) == {"0"}


def test_no_field_has_an_increment() -> None:
    """docs/tables.md says that none has one, and that it means nothing."""
    texts = shipped_texts()
    assert not [match for text in texts for match in re.findall(r"<field[^>]* increment=", text)]


def test_explain_tells_all_of_them() -> None:
    """Of fields that no table populates, too."""
    system = read_system(str(PROJECT / "specs" / "codegen.yaml"), Report())
    told = {
        "CAMERA_SETTINGS.camera_device_id": ["range        0..6", "default      0"],
        "CAMERA_THERMAL_RANGE.stream_id": ["range        1..", "instance     tells apart"],
        "TERRAIN_REQUEST.mask": ["printed as   0x%07x", "display      bits"],
    }
    for name, lines in told.items():
        story = explain(name, system, Report())
        assert [line for line in lines if line not in story] == [], story
