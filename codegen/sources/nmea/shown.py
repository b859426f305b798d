"""The lines of NMEA 0183 of a receiver of satellites in the generated suite about a place, and its amounts."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from codegen.model.quantities.device import Exact, Shown
from codegen.model.units.unit import NUMBER, unit_named


class _Scene(NamedTuple):
    """A fix: its quality in GGA and as GPS_FIX_TYPE, millionths of degrees to the north and the east, and the rest."""

    quality: int
    fix: int
    north: int
    east: int
    height_mm: int
    knots: int
    course_cdeg: int
    hdop: int
    vdop: int
    satellites: int


def _scenes(number: int) -> Iterator[_Scene]:
    yield _Scene(
        1, 3, -33853910 + 1000000 * number, 151209300 - 3000000 * number, 38123 + number, 18, 12345, 123, 234, 9
    )
    yield _Scene(4, 6, 64146580 - 1000000 * number, -21942330 + 1000000 * number, -12345, 27, 31459, 87, 156, 17)


def shown(number: int) -> Iterator[Shown]:
    """The lines of each scene, without dollar and checksum; ``number`` makes them other ones.

    Knots are multiples of 9, which are whole centimetres per second (9 kn are 4.63 m/s), and no number has more digits
    than the receiver keeps.
    """
    for scene in _scenes(number):
        yield Shown({"lines": list(_lines(scene, number))}, _amounts(scene, number))


def _lines(scene: _Scene, number: int) -> Iterator[str]:
    place = f"{_angle(scene.north, 2, 'NS')},{_angle(scene.east, 3, 'EW')}"
    course, hdop, vdop = (_decimal(value, 2) for value in (scene.course_cdeg, scene.hdop, scene.vdop))
    knots, height, seen = f"{scene.knots}.000", _decimal(scene.height_mm, 3), scene.satellites + number
    yield f"GNGSA,A,3,{',' * 13}{hdop},{vdop}"
    yield f"GNRMC,123456.00,A,{place},{knots},{course},270326,,,A"
    yield f"GNVTG,{course},T,,M,{knots},N,,K,A"
    yield f"GNGGA,123456.00,{place},{scene.quality},{seen:02},{hdop},{height},M,,M,,"


def _amounts(scene: _Scene, number: int) -> Mapping[str, Exact]:
    degrees, metres = unit_named("deg"), unit_named("m")
    return {
        "fix": Exact(Fraction(scene.fix), NUMBER),
        "satellites": Exact(Fraction(scene.satellites + number), NUMBER),
        "latitude": Exact(Fraction(scene.north, 1000000), degrees),
        "longitude": Exact(Fraction(scene.east, 1000000), degrees),
        "altitude": Exact(Fraction(scene.height_mm, 1000), metres),
        "speed": Exact(Fraction(scene.knots * 1852, 3600), unit_named("m/s")),
        "course": Exact(Fraction(scene.course_cdeg, 100), degrees),
        "hdop": Exact(Fraction(scene.hdop, 100), NUMBER),
        "vdop": Exact(Fraction(scene.vdop, 100), NUMBER),
    }


def _angle(millionths: int, digits: int, sides: str) -> str:
    """Degrees and minutes with their side; a millionth of a degree is six hundred-thousandths of a minute."""
    size = abs(millionths)
    minutes = size % 1000000 * 6
    return f"{size // 1000000:0{digits}}{minutes // 100000:02}.{minutes % 100000:05},{sides[millionths < 0]}"


def _decimal(steps: int, digits: int) -> str:
    one = 10**digits
    return f"{'-' if steps < 0 else ''}{abs(steps) // one}.{abs(steps) % one:0{digits}}"
