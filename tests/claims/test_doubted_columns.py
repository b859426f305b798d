"""Columns, lists and blocks that mostly differ from the dialect: the reading is doubted, and not each of their lines."""

from typing import Any

import pytest

from codegen.claims.statements.columns import rows

UNITS = (("vel", "m/s"), ("cog", "deg"), ("eph", "-"), ("alt", "m"))
SCALED = "## GPS_RAW_INT\n\n| Field | Unit |\n| --- | --- |\n" + "".join(
    f"| {name} | {unit} |\n" for name, unit in UNITS
)
FACTORS = (
    "## GPS_RAW_INT\n\n| Field | {head} | Result |\n| --- | --- | --- |\n| vel | {vel} | m/s |\n| cog | {cog} | deg |\n"
)


def test_a_column_that_mostly_differs_is_one_likely_finding_at_its_heading(check: Any) -> None:
    (found,) = check(SCALED)
    assert not found.is_error
    assert (found.place.line, found.place.column) == (3, 11)
    assert found.message.startswith('3 of 3 units in column "Unit" are not those of the dialect: GPS_RAW_INT.vel is in')
    assert [place.line for place, _ in found.related] == [5, 6, 8]


def test_a_column_of_which_half_is_right_is_wrong_in_its_rows(check: Any) -> None:
    right = "| lat | degE7 |\n| lon | degE7 |\n| v_acc | mm |\n"
    assert [one.place.line for one in check(SCALED + right) if one.is_error] == [5, 6, 8]


def test_two_rows_are_too_few_to_doubt_a_column(check: Any) -> None:
    assert [one.is_error for one in check(SCALED.replace("| alt | m |\n", ""))] == [True, True]


def test_a_list_that_mostly_differs_is_one_likely_finding(check: Any) -> None:
    text = "## GPS_RAW_INT\n\n" + "".join(f"- `{name}`: {unit}\n" for name, unit in UNITS)
    (found,) = check(text)
    assert not found.is_error
    assert found.message.startswith("3 of 3 units here are not those of the dialect")


def test_another_list_is_not_doubted_with_it(check: Any) -> None:
    text = "## GPS_RAW_INT\n\n" + "".join(f"- `{name}`: {unit}\n" for name, unit in UNITS)
    text += "\nText.\n\n## POWER_STATUS\n\n- `Vcc`: V\n- `Vservo`: mV\n"
    assert [one.is_error for one in check(text)] == [False, True]


@pytest.mark.parametrize(
    ("head", "vel", "cog"), [("Factor", "0.01", "0.01"), ("Divisor", "100", "100"), ("Scale", "/ 100", "/ 100")]
)
def test_a_unit_beside_a_factor_is_the_one_after_scaling(check: Any, head: str, vel: str, cog: str) -> None:
    assert check(FACTORS.format(head=head, vel=vel, cog=cog)) == []
    (found,) = check(FACTORS.format(head=head, vel=vel.replace("0.01", "0.001").replace("100", "1000"), cog=cog))
    assert found.message.startswith("GPS_RAW_INT.vel is in cm/s, ")


def test_the_field_of_a_row_is_looked_for_once(check: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    """A table of six thousand columns took ten seconds: each column looked at all cells of all rows."""
    looked_at: list[tuple[int, ...]] = []

    class Counted:
        """The pattern of a cell that is a field's name, which notes what it is asked for."""

        def fullmatch(self, text: str, *bounds: int) -> Any:
            looked_at.append(bounds)
            return field.fullmatch(text, *bounds)

    field = rows._FIELD
    monkeypatch.setattr(rows, "_FIELD", Counted())
    columns, others = 300, 3
    line = "|" + "1|" * columns + "\n"
    check(f"MAVLink GPS_RAW_INT.\n\n{line}|{'-|' * columns}\n{line * others}")
    assert len(looked_at) <= columns * (others + 1)
