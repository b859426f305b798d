"""Received numbers are kept in the steps of their field where nothing is stated, or it is told that they are rounded.

GPS_STATUS has azimuths in steps of 360/255 degrees: kept in whole degrees, 100 of them were 141 and not 141.18.
"""

import shutil
from pathlib import Path

import pytest

from codegen.diagnostics import Report
from codegen.model.system import System
from codegen.project.systems import read_systems
from codegen.rules import coarse_quantity

SPECS = Path(__file__).resolve().parents[1] / "projects" / "received" / "specs"
FIRST = "      left: {doc: Left wheel., unit: m}\n"


def received(folder: Path, message: str, field: str, quantity: str, table: str = "") -> tuple[System | None, Report]:
    """Return the project with a quantity that one field sets, and what was found on the way."""
    specs = Path(shutil.copytree(SPECS, folder / "specs"))
    state = specs / "state.yaml"
    state.write_text(state.read_text().replace(FIRST, f"      near: {{doc: d, {quantity}}}\n{FIRST}"))
    text = f"receive: {message}\nrequirement: FR-1.8\nfields:\n  {field}: {{state: wheels.near{table}}}\n"
    (specs / "receives" / "more.yaml").write_text(text)
    report = Report()
    systems = read_systems(str(specs / "codegen.yaml"), report)
    return (systems[0] if systems else None), report


AZIMUTH = "GPS_STATUS", "satellite_azimuth[0]"


@pytest.mark.parametrize(
    ("field", "quantity", "kept", "told"),
    [
        (AZIMUTH, "unit: deg", "steps of 360/255 deg", ""),
        (AZIMUTH, "unit: deg, min: 0, max: 360", "steps of 360/255 deg", ""),
        (AZIMUTH, "unit: deg, min: 0, max: 359", "deg", "comes as uint8_t in steps of 360/255 deg"),
        (AZIMUTH, "unit: deg, stored: deg", "deg", ""),
        (AZIMUTH, "unit: rad", "rad", "comes as uint8_t in steps of 360/255 deg"),
        (("VFR_HUD", "heading"), "unit: rad", "rad", "comes as int16_t in deg"),
        (("VFR_HUD", "heading"), "unit: deg", "deg", ""),
        (("GPS_RAW_INT", "vel"), "unit: km/h", "cm/s", ""),
        (("BATTERY_STATUS", "time_remaining"), "unit: ms", "ms", ""),
    ],
)
def test_no_part_of_a_step_is_lost_without_a_word(
    field: tuple[str, str], quantity: str, kept: str, told: str, tmp_path: Path
) -> None:
    """Each whole number of the field is one of the quantity, or the warning says what it comes in."""
    system, report = received(tmp_path, *field, quantity)
    assert system is not None, list(report)
    near = system.components["wheels"].quantities["near"]
    assert near.stored.name == kept
    found = [each.message for each in coarse_quantity.check(system) if "wheels.near" in each.message]
    assert [message.rpartition(f"{field[1]} ")[2] for message in found] == [told] * bool(told)


@pytest.mark.parametrize(
    ("message", "field", "quantity"),
    [
        ("VFR_HUD", "heading", "unit: rad, stored: mrad"),
        ("ADSB_VEHICLE", "heading", "unit: rad, stored: mrad"),
        ("SCALED_IMU2", "xacc", "unit: m/s/s, stored: mm/s/s"),
    ],
)
def test_a_product_that_is_wide_on_the_way_is_no_reason_to_refuse(
    message: str, field: str, quantity: str, tmp_path: Path
) -> None:
    """Of 16 bits each number fits, and the hint spoke of a heading of up to 1 rad."""
    system, report = received(tmp_path, message, field, quantity)
    assert [each.message for each in report if each.rule.id == "cannot-receive"] == []
    assert system is not None
    (taken,) = (each for table in system.receptions for each in table.fields if each.quantity.name == "near")
    assert (taken.low, taken.high) == (taken.field.type.minimum, taken.field.type.maximum)


@pytest.mark.parametrize(
    ("field", "quantity", "hint"),
    [
        (
            ("GLOBAL_POSITION_INT", "lat"),
            "unit: deg, stored: cdeg",
            "a max (and a min) of up to 107 deg, or keep it in degE7",
        ),
        (("SCALED_IMU2", "time_boot_ms"), "unit: h, stored: min", "a max (and a min) of up to 298 h, or keep it in ms"),
        (("GPS_RAW_INT", "hdg_acc"), "unit: rad, stored: mrad", "keep it in degE5"),
        (("GPS_RAW_INT", "time_usec"), "unit: h, stored: h", "keep it in us"),
    ],
)
def test_a_limit_is_named_where_it_is_of_use(field: tuple[str, str], quantity: str, hint: str, tmp_path: Path) -> None:
    """No course ends before a whole turn."""
    _, report = received(tmp_path, *field, quantity)
    assert [each.hint for each in report if each.rule.id == "cannot-receive"] == [hint]


def test_what_code_sets_is_kept_in_units_though_a_field_is_coarser(tmp_path: Path) -> None:
    """A whole degree is one, and not the nearest 360/255 of a turn."""
    specs = Path(shutil.copytree(SPECS, tmp_path / "specs"))
    state = specs / "state.yaml"
    state.write_text(state.read_text().replace(FIRST, f"      near: {{doc: d, unit: deg, initial: 0}}\n{FIRST}"))
    fields = {f"satellite_azimuth[{at}]": "{state: wheels.near}" for at in range(20)}
    lines = "".join(f"  {name}: {answer}\n" for name, answer in fields.items())
    text = "message: GPS_STATUS\nrequirement: FR-1.8\nothers: unknown\nfields:\n  satellites_visible: {constant: 1}\n"
    for name in ("prn", "used", "elevation", "snr"):
        text += f"  satellite_{name}: {{constant: 0}}\n"
    (specs / "messages" / "more.yaml").write_text(text.replace("others: unknown\n", "") + lines)
    report = Report()
    system = read_systems(str(specs / "codegen.yaml"), report)[0]
    assert system.components["wheels"].quantities["near"].stored.name == "deg"
