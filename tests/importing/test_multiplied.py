"""Documents about fields with a multiplier: its steps are in the factor, and a plain number is no answer."""

from collections.abc import Callable

import pytest

from codegen.importing.answer import Sources
from codegen.model.units.unit import NUMBER, unit_named


@pytest.fixture
def position(plain: Sources) -> Sources:
    """common, and a project with what a receiver of satellites measures."""
    quantities = {"gps.hdop": NUMBER, "gps.bearing": unit_named("deg")}
    return Sources(plain.dialect, quantities=quantities)


@pytest.mark.parametrize(
    ("text", "field", "answer"),
    [
        ("gps.hdop * 100", "GPS_RAW_INT.eph", "{state: gps.hdop}"),
        ("gps.hdop", "GPS_RAW_INT.eph", "{state: gps.hdop}"),
        ("gps.bearing * 17 / 24", "GPS_STATUS.satellite_azimuth[0]", "{state: gps.bearing}"),
        ("72 deg", "GPS_STATUS.satellite_azimuth[0]", "{constant: 72 deg}"),
        ("UINT16_MAX", "GPS_RAW_INT.eph", "unknown"),
        ("0", "HIL_GPS.eph", "{constant: 0}"),
        ("`{constant: 1.2}`", "GPS_RAW_INT.eph", "{constant: 1.2}"),
    ],
)
def test_what_says_one_thing(read: Callable, position: Sources, text: str, field: str, answer: str) -> None:
    reading, findings = read(text, field, position)
    assert (reading.answer, findings) == (answer, [])


@pytest.mark.parametrize(
    ("text", "field", "finding"),
    [
        (
            "120",
            "GPS_RAW_INT.eph",
            "document-steps: 120 leaves open whether GPS_RAW_INT.eph is 120 or 120 steps of 1E-2",
        ),
        (
            "85",
            "GPS_STATUS.satellite_azimuth[0]",
            "document-steps: 85 leaves open whether GPS_STATUS.satellite_azimuth[0] is 85 deg or 85 steps of 360/255 deg",
        ),
        ("gps.hdop * 10", "GPS_RAW_INT.eph", "document-factor: gps.hdop (a number) times 10 is not in steps of 1E-2"),
    ],
)
def test_what_does_not(read: Callable, position: Sources, text: str, field: str, finding: str) -> None:
    assert read(text, field, position)[1] == [finding]
