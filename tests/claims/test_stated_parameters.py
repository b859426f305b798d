"""Defaults, ranges, steps and units of parameters in a project's own documents, in the words that people use."""

from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

import pytest

from codegen.claims.own.parameters import check
from codegen.claims.reading import Reading, read_document
from codegen.model.stated_parameter import StatedParameter
from codegen.model.units.unit import unit_named

HEIGHT = StatedParameter(
    "TANK_HEIGHT", unit_named("m"), Fraction(9, 2), Fraction(1), Fraction(6), Fraction(1, 10), "REAL32", 0, 2
)
RATE = StatedParameter("TANK_RATE", unit_named("Hz"), Fraction(2), Fraction(0), Fraction(10), Fraction(1), "INT8", 1, 2)
TABLE = "| Parameter | Default | Min | Max | Step | Unit |\n| - | - | - | - | - | - |\n"
ROW = "| `TANK_RATE` | 2 | 0 | 10 | 1 | Hz |\n"

Read = Callable[[str], Reading]


def told(text: str, reading: Reading) -> list[str]:
    """Return what is said of a text in a project with two parameters."""
    reference = replace(reading.reference, parameters={each.name: (each,) for each in (HEIGHT, RATE)})
    return [each.message for each in check(read_document(text, "/documents/notes.md", reference))]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("4,0 m by default", "has the default 4.5 m, not 4,0"),
        ("default value 4 m", "default 4.5 m, not 4"),
        ("default = 4 m", "default 4.5 m, not 4"),
        ("defaults to 400 cm", "default 4.5 m, not 400 cm"),
        ("range 1-8 m", "maximum 6 m, not 8"),
        ("range [0, 6] m", "minimum 1 m, not 0"),
        ("range 1 m to 8 m", "maximum 6 m, not 8"),
        ("range 10 cm to 600 cm", "minimum 1 m, not 10 cm"),
        ("between 1 and 8 m", "maximum 6 m, not 8"),
        ("4.5 m by default, from 1 m to 8 m", "maximum 6 m, not 8"),
        ("default 4.5 m, min 1 m, max 8 m", "maximum 6 m, not 8"),
        ("minimum: 0,5 m", "minimum 1 m, not 0,5"),
        ("step 0.5 m", "step 0.1 m, not 0.5"),
    ],
)
def test_a_fact_in_other_words_is_compared(read: Read, text: str, said: str) -> None:
    """Only "default 4 m", "range 1 to 6 m" and "steps of 0.1 m" were."""
    (message,) = told(f"`TANK_HEIGHT`, {text}.", read(""))
    assert message.endswith(said)


@pytest.mark.parametrize(
    "text",
    [
        "`TANK_HEIGHT` is 4,5 m by default, between 1,0 and 6,0 m, step 10 cm.",
        "`TANK_HEIGHT` (default value = 450 cm, min. 1 m, max. 6 m).",
        "`TANK_HEIGHT`, range 100 cm\u2026600 cm, [see below].",
        "`TANK_HEIGHT` is set once; the level, from 0 m to 5 m, is measured.",
        "`TANK_HEIGHT` is asked for, and between 1 and 3 messages are lost.",
        "`TANK_RATE`, from 1 s to 3 s after the start, is not used.",
        "`TANK_HEIGHT` of the tank with a pump, max 3 m deep.",
        "`TANK_HEIGHT`, minimum 3 readings.",
        "`TANK_HEIGHT`, step 2 of the calibration.",
        TABLE + ROW + "| `TANK_HEIGHT` | 450 | 100 | 600 | 10 | cm |",
        TABLE + ROW + "| `TANK_HEIGHT` | 4,5 m | 1 m | 6 m | 0,1 m | |",
        TABLE + ROW + "| `TANK_HEIGHT` | 4.5 | 1 | 6 | 0.1 | metres |",
        TABLE + ROW + "| `TANK_HEIGHT` | 4.5 | 1 | 6 | 0.1 | - |",
        TABLE + ROW + "| `PUMP_HEIGHT` | 3 | 1 | 6 | 0.1 | m |",
    ],
)
def test_what_is_right_or_of_something_else_is_left_alone(read: Read, text: str) -> None:
    assert told(text, read("")) == []


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("| `TANK_HEIGHT` | 4,6 | 1 | 6 | 0.1 | m |", ["TANK_HEIGHT has the default 4.5 m, not 4,6"]),
        ("| `TANK_HEIGHT` | 4.5 | 1 | 6 | 0.1 | cm |", ["TANK_HEIGHT is in m, not in cm"]),
        ("| `TANK_HEIGHT` | 4.5 | 1 | 6 | 0.1 | Hz |", ["TANK_HEIGHT is in m, not in Hz"]),
        ("| `TANK_HEIGHT` | 400 | 100 | 600 | 10 | cm |", ["TANK_HEIGHT has the default 4.5 m, not 400 cm"]),
        ("| `TANK_HIGHT` | 4.5 | 1 | 6 | 0.1 | m |", ["there is no parameter TANK_HIGHT"]),
    ],
)
def test_rows_are_compared_with_their_units(read: Read, row: str, said: list[str]) -> None:
    """A column of units was not looked at: what was right in centimetres was wrong, and metres that are none right."""
    assert told(TABLE + ROW + row, read("")) == said


@pytest.mark.timeout(40)
def test_numbers_without_end_are_read_once(read: Read) -> None:
    """ "1 is" can be a number with a unit and a number before a word: to try both for each takes 2 to the power of 400."""
    assert told("`TANK_HEIGHT` " + "1 is " * 400 + "far, min 2", read("")) == []
