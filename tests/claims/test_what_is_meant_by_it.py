"""What names, numbers, units and sizes are taken for, on both sides of where that changes."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction
from functools import cache
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.claims import LIKELY, truncation
from codegen.claims.arithmetic import _is_right
from codegen.claims.known_names import Names, near_fields, near_message, same_field
from codegen.claims.limit import _in_own_unit, _is_limit
from codegen.claims.parts.code_spans import _places
from codegen.claims.reading import merged
from codegen.claims.rules import UNIT
from codegen.claims.size import SizeClaim, is_possible
from codegen.claims.statements.scaling.factors import has_scale
from codegen.claims.statements.scaling.field_units import has_unit, is_same_unit, of_field
from codegen.claims.unknown_value import number_of
from codegen.commands.codec import read_codec_dialect
from codegen.diagnostics import Diagnostic, Report
from codegen.model.dialect.dialect import Dialect, WireField, WireMessage
from codegen.model.units.unit import Unit, unit_named
from codegen.source import Place


@cache
def dialect() -> Dialect:
    """The common dialect."""
    found = read_codec_dialect("common", Report())
    assert found is not None
    return found


def message(name: str) -> WireMessage:
    return dialect().messages[name]


def field(name: str) -> WireField:
    """A field, written as MESSAGE.field."""
    of, _, own = name.partition(".")
    found = message(of).field(own)
    assert found is not None
    return found


@pytest.mark.parametrize(
    ("name", "known", "near"),
    [
        ("VFRAS", "VFRA", "VFRA"),
        ("VFRS", "VFR", None),  # so short a name may be anything
        ("ABCDX", "ABCDE", "ABCDE"),
        ("ABCXX", "ABCDE", None),
        ("ONETWO", "ONE_TWO", "ONE_TWO"),
        ("ONETWO", "SIX_SIX ONE_TWO", "ONE_TWO"),
        ("ONETWO", "ONETWO_X ONETWA", "ONETWA"),
        ("ON_ETWO", "ONE_TWO", "ONE_TWO"),
        ("TWO_ONE", "ONE_TWO", "ONE_TWO"),
        ("TWO_ONE", "ONE_TWO ONE_TWO_X TWO_X_ONE", "ONE_TWO"),
        ("ONE_TWO_SIX", "SIX_ONE_TWO TWO_ONE_SIX", None),  # both have its words
        ("FRONT_ABC", "FRONT_ABCDEFGHIJKLMN", "FRONT_ABCDEFGHIJKLMN"),
        ("FRONT_AB", "FRONT_ABCDEFGHIJKLMN", None),
        ("FRONT_ABCDEFGHIJKLMN", "FRONT_ABC", "FRONT_ABC"),
        ("OTHER_ABC", "FRONT_ABCDEFGHIJKLMN", None),
        ("ABC_UVWXYZ", "ABCD_UVWXYZ", "ABCD_UVWXYZ"),
        ("ABCD_UVWXYZ", "ABC_UVWXYZ", "ABC_UVWXYZ"),
        ("AB_UVWXYZ", "ABC_UVWXYZ", None),
        ("XAB_UVWXYZ", "ABC_UVWXYZ", None),
        ("ONE_TWO", "ONE_TWO_A_B_C ONE_TWO_B_C_D ONE_TWO_C_D_E ONE_TWO_D_E_F", "ONE_TWO_A_B_C"),
        ("ONE_TWO", "ONE_TWO_A_B_C ONE_TWO_B_C_D ONE_TWO_C_D_E ONE_TWO_D_E_F ONE_TWO_E_F_G", None),  # their family
        ("ONE_TWO_UVWXYZ_A", "ONE_TWO_UVWXYZ", None),  # a successor
        ("ONE_TWO_UVWXYZA", "ONE_TWO_UVWXYZ", "ONE_TWO_UVWXYZ"),
    ],
)
def test_the_message_that_a_name_is_meant_for(name: str, known: str, near: str | None) -> None:
    """One with the same letters or the same words, or of the same family and much like it; else it is of its own."""
    messages: Any = dict.fromkeys(known.split())
    assert near_message(name, Names(messages, (), (), (), {})) == near


@pytest.mark.parametrize(
    ("name", "same", "near"),
    [
        ("longitude", ["lon"], ["lon"]),
        ("target_type", ["type"], ["type"]),
        ("other_type", [], []),
        ("type_base", [], ["base_type"]),
        ("base_typo", [], ["base_type"]),
        ("typo", [], ["type"]),
        ("ty", [], []),
    ],
)
def test_the_field_that_a_name_is_meant_for(name: str, same: list[str], near: list[str]) -> None:
    """By words that mean the same, with a word of the message before it, by its letters, or its words turned round."""
    fields = [SimpleNamespace(name=each) for each in ("lon", "type", "base_type")]
    own: Any = SimpleNamespace(name="TARGET_POINT", fields=fields)
    assert same_field(name, own) == same
    assert near_fields(name, own) == near


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("ATTITUDE_QUATERNION.repr_offset_q", "of which what is unknown is 0"),
        ("WIND_COV.horiz_accuracy", "which is 0 when it is unknown"),
        ("RC_CHANNELS.chancount", "which its description sets to 0"),
        ("RAW_IMU.id", "an extension, which is 0 when a sender does not know it"),
        ("HEARTBEAT.base_mode", "a uint8_t whose highest byte is 0 for small values"),
        ("PING.seq", "a uint32_t whose highest byte is 0 for small values"),
        ("HEARTBEAT.type", None),
        ("ATTITUDE.yawspeed", None),
    ],
)
def test_why_the_last_byte_of_a_field_can_be_zero(name: str, reason: str | None) -> None:
    """None is known of a byte with a value of an enum, nor of a float: nothing is said of these."""
    assert truncation._why_zero(field(name)) == reason


@pytest.mark.parametrize(
    ("words", "is_version_1", "possible"),
    [
        ("payload", False, {31, 43}),
        ("payload", True, {31}),
        ("MAVLink 1", False, {31, 39}),
        ("", True, {31, 39}),
        ("a frame", False, set(range(9, 69))),
        ("", False, {31, 39, 43, 44, 55, 56, 57, 68} - {44, 57} | {31 + 12 + 13, 43 + 12 + 13, 43, 55}),
    ],
)
def test_the_sizes_that_a_message_can_have(words: str, is_version_1: bool, possible: set[int]) -> None:
    """31 bytes and 43 with extensions; a head takes 8 bytes or 12, and a signature 13; frames lose zeros at the end."""
    own = message("SYS_STATUS")
    claims = [SizeClaim(own, size, 0, 0, words, is_version_1) for size in range(100)]
    assert {claim.bytes for claim in claims if is_possible(claim)} == possible


@pytest.mark.parametrize(
    ("written", "is_limit"),
    [("65", True), ("64", False), ("66", False), ("65.5", True), ("65.6", False), ("65.53", True), ("65.535", True),
     ("65.534", False), ("65.536", False)],
)  # fmt: skip
def test_a_limit_is_the_maximum_to_its_own_decimals(written: str, is_limit: bool) -> None:
    volts = _in_own_unit(field("BATTERY_STATUS.voltages"), unit_named("V"))
    assert volts == 1000
    assert _is_limit(0xFFFF, written, volts) is is_limit
    assert not _is_limit(0xFFFF, written, _in_own_unit(field("BATTERY_STATUS.voltages"), unit_named("A")))
    assert _in_own_unit(field("HEARTBEAT.type"), unit_named("V")) is None


@pytest.mark.parametrize(("many", "said"), [(1, []), (9, 8 * ["stated again"]),
                                            (11, [*7 * ["stated again"], "stated again, and 2 times more below"])])  # fmt: skip
def test_a_claim_is_told_once_with_up_to_eight_places_more(many: int, said: list[str]) -> None:
    """In the document's order, each place once; another claim is told by itself."""
    found = [Diagnostic(Place("a.md", line, 1), UNIT, "wrong", fingerprint="f") for line in range(many, 0, -1)]
    other = replace(found[0], fingerprint="g", place=Place("a.md", 99, 1))
    first, second = merged([*found, found[-1], other])
    assert [text for _, text in first.related] == said
    assert [place.line for place, _ in first.related] == list(range(2, 2 + len(said)))
    assert (first.place.line, second.place.line, second.related) == (1, 99, ())


@pytest.mark.parametrize(
    ("text", "value"),
    [("0xFFFF", 65535), ("0Xff", 255), ("0x" + "F" * 16, 2**64 - 1), ("0x" + "F" * 17, None), ("-1", -1),
     ("UINT16_MAX", 65535), ("sixteen", None)],
)  # fmt: skip
def test_the_number_that_a_text_names(text: str, value: int | None) -> None:
    assert number_of(text) == value


def scaled(name: str, factor: Fraction) -> Unit:
    own = unit_named(name)
    return Unit(own.name, own.dimension, own.scale * factor, own.pi, own.zero)


@pytest.mark.parametrize(
    ("name", "unit", "is_right"),
    [
        ("GPS_STATUS.satellite_azimuth", unit_named("deg"), True),
        ("GPS_STATUS.satellite_azimuth", scaled("deg", Fraction(24, 17)), True),
        ("GPS_STATUS.satellite_azimuth", scaled("deg", Fraction(2)), False),
        ("GPS_STATUS.satellite_azimuth", unit_named("rad"), False),
        ("ATTITUDE.roll", unit_named("rad"), True),
        ("ATTITUDE.roll", unit_named("deg"), False),
        ("HIGHRES_IMU.xmag", unit_named("gauss"), True),
        ("HIGHRES_IMU.xmag", unit_named("mgauss"), False),
        ("HEARTBEAT.type", unit_named("V"), True),  # it has none to compare
    ],
)
def test_the_units_that_a_field_is_rightly_said_to_have(name: str, unit: Unit, is_right: bool) -> None:
    """That of the field, and where the dialect has a factor beside it that of one step, too."""
    assert has_unit(field(name), unit) is is_right


@pytest.mark.parametrize(
    ("name", "written", "meant"),
    [
        ("HIGHRES_IMU.xmag", "G", "gauss"),
        ("HIGHRES_IMU.xmag", "mG", "mgauss"),
        ("SCALED_IMU.xmag", "G", "gauss"),
        ("SCALED_IMU.xmag", "mG", "mgauss"),
        ("SCALED_IMU.xacc", "G", None),
        ("BATTERY_STATUS.temperature", "deg", "degC"),
        ("BATTERY_STATUS.temperature", "C", "degC"),
        ("BATTERY_STATUS.current_battery", "C", None),
        ("ATTITUDE.roll", "deg", None),
    ],
)
def test_a_unit_is_meant_as_its_field_has_it(name: str, written: str, meant: str | None) -> None:
    """G are gauss of a magnetic field and degrees are those of Celsius of a temperature; elsewhere they are not."""
    unit = Unit.parse(written)
    assert unit is not None
    found = of_field(unit, field(name))
    assert is_same_unit(found, unit if meant is None else unit_named(meant))


@pytest.mark.parametrize(
    ("units", "factor"),
    [("m/s*5", 5), ("degE7", 10**7), ("mm", 1000), ("cdeg", 100), ("dm/s", 10), ("us", 10**6), ("cA", 100)],
)
def test_the_factor_of_a_field_is_that_to_its_unit_without_a_prefix(units: str, factor: int) -> None:
    own: Any = SimpleNamespace(definition=SimpleNamespace(units=units))
    assert [value for value in (1, 5, 6, 10, 100, 1000, 10**6, 10**7) if has_scale(own, value)] == [factor]


@pytest.mark.parametrize(
    ("value", "written", "sign", "about", "is_right"),
    [
        (Fraction(105), "104", "=", "", False),
        (Fraction(105), "104", "\u2248", "", True),
        (Fraction(105), "100", "=", "", True),
        (Fraction(100), "105", "=", "about", True),
        (Fraction(100), "106", "\u2248", "", False),
        (Fraction(1, 3), "0.33", "=", "", True),
        (Fraction(1, 3), "0.34", "=", "", True),
        (Fraction(1, 3), "0.35", "=", "", False),
        (Fraction(1000), "1,000", "=", "", True),
        (Fraction(1499), "1,000", "=", "", True),
        (Fraction(1501), "1,000", "=", "", False),
        (Fraction(300), "44", "=", "", True),
        (Fraction(300), "45", "=", "", False),
        (Fraction(-1), "65535", "=", "", True),
        (Fraction(-5), "\u22125", "=", "", True),
    ],
)
def test_a_result_is_right_as_exactly_as_it_is_written(
    value: Fraction, written: str, sign: str, about: str, is_right: bool
) -> None:
    """To its last digit, which may be cut, in hundreds if it ends so; within a twentieth if it is about; or wrapped."""
    result: Any = {"number": written, "sign": sign, "about": about}
    assert _is_right(value, result) is is_right


ROWS = "| Field | Type |\n| --- | --- |\n| `time_boot_ms` | uint32_t |\n| `roll` | float |\n| `{}` | float |\n| `yaw` | float |\n"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("## ATTITUDE\n\n" + ROWS.format("pich"), "ATTITUDE has no field pich"),
        ("## ATTITUDE\n\n" + ROWS.format("pitch"), None),
        ("ATTITUDE_V2 is to follow.\n\n## ATTITUDE\n\n" + ROWS.format("pich"), None),
        ("GPS_RAW_INT_V2 is to follow.\n\n## ATTITUDE\n\n" + ROWS.format("pich"), "ATTITUDE has no field pich"),
        ("`load` of SYS_STATUS is at most 32767.", "SYS_STATUS.load is uint16_t: its maximum is 65535 d%, not 32767"),
        ("`load` of SYS_STATUS is at most 126.", "SYS_STATUS.load is uint16_t: its maximum is 65535 d%, not 126"),
        ("`load` of SYS_STATUS is at most 100.", None),
        ("`load` of SYS_STATUS is at most 65534.", None),
        ("`message_type` of V2_EXTENSION is at most 32767.", None),  # its description has the number
        (
            "`message_type` of V2_EXTENSION is at most 255.",
            "V2_EXTENSION.message_type is uint16_t: its maximum is 65535, not 255",
        ),
        ("10 bytes of HEARTBEAT are sent.", "HEARTBEAT has a payload of 9 bytes, not 10"),
        ("9 bytes of HEARTBEAT are sent.", None),
        ("A frame of 40 bytes of HEARTBEAT.", "HEARTBEAT has a payload of 9 bytes, not 40"),
        ("5 bytes for the HEARTBEAT.", "HEARTBEAT has a payload of 9 bytes, not 5"),
        ("`lat`, `alt` of GPS_RAW_INT are in degE7 and cm.", "GPS_RAW_INT.alt is in mm, not cm"),
        ("`lat`, `alt` of GPS_RAW_INT are in degE7 and mm.", None),
        ("EFI_STATUS: all fields but the health are floats.", None),
        ("EFI_STATUS: all fields except for `health` are floats.", None),
        ("EFI_STATUS: `health` is a float.", "EFI_STATUS.health is uint8_t, not float"),
        ("`vel`, `cog` of GPS_RAW_INT are uint16_t (cm/s and deg).", "GPS_RAW_INT.cog is in cdeg, not deg"),
        ("SCALED_IMU.xmag is in G.", "SCALED_IMU.xmag is in mgauss, not G"),
        ("SCALED_IMU.xmag is in mG.", None),
        ("-1 means unknown for `eph` of GPS_RAW_INT.", "GPS_RAW_INT.eph is unknown when it is UINT16_MAX, not -1"),
        ("65535 means unknown for `eph` of GPS_RAW_INT.", None),
        (
            "HIGH_LATENCY2.airspeed is m/s multiplied by 10.",
            "HIGH_LATENCY2.airspeed is in m/s*5, which multiplied by 10 does not agree with",
        ),
        ("HIGH_LATENCY2.airspeed is m/s multiplied by 5.", None),
    ],
)  # fmt: skip
def test_a_statement_and_its_neighbour(text: str, said: str | None, check: Callable[[str], list[Diagnostic]]) -> None:
    """What is right, or may be, is not found; what is beside it is, once."""
    found = [each.message.removesuffix(f" ({LIKELY})") for each in check(f"MAVLink.\n\n{text}\n")]
    assert found == ([] if said is None else [said])


def test_a_place_in_lines_of_code_is_in_the_line_that_has_it() -> None:
    """Lines are joined by one character, which belongs to the line that it ends."""
    lines: Any = [
        SimpleNamespace(text=text, place=Place("a.md", 5 + at, 3)) for at, text in enumerate(("ab", "", "cd"))
    ]
    place_at = _places(lines)
    found = [(place.line, place.column) for place in map(place_at, range(6))]
    assert found == [(5, 3), (5, 4), (5, 5), (6, 3), (7, 3), (7, 4)]
