"""Quantities read from frames that pymavlink makes: units, instances, sentinels, tables with one id."""

import math
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from packs import ROOT, rover
from pymavlink.dialects.v10 import common as old
from pymavlink.dialects.v20 import ardupilotmega, common

from codegen.diagnostics import Report
from codegen.model.system import Policy, System
from codegen.project.systems import read_own_scenarios, read_system, read_systems
from codegen.sim.told import Telling, told_paths

PROJECTS = Path(__file__).resolve().parents[1] / "projects"
UNKNOWN = [0xFFFF] * 10


def system_of(project: str) -> System:
    """The system of a project of the tests."""
    system = read_system(str(PROJECTS / project / "specs" / "codegen.yaml"), Report())
    assert system is not None
    return system


def told(system: System, frame: Any, **parameters: float) -> dict[str, float | None]:
    """Return the numbers that a frame tells, by path and instance."""
    telling = Telling(system.messages)
    return {f"{each.path}/{each.instance}": each.value for each in telling.read(bytes(frame), parameters)}


def battery_status(dialect: Any, number: int = 0, voltages: list[int] | None = None, **fields: int) -> bytes:
    """A frame of BATTERY_STATUS."""
    values = {"temperature": 32767, "current_battery": -1, "current_consumed": -1, "energy_consumed": -1, **fields}
    remaining = values.pop("battery_remaining", -1)
    message = dialect.MAVLink_battery_status_message(
        number, 0, 1, values["temperature"], voltages or UNKNOWN, values["current_battery"],
        values["current_consumed"], values["energy_consumed"], remaining,
    )  # fmt: skip
    frame: bytes = message.pack(dialect.MAVLink(None))
    return frame


@pytest.mark.parametrize("dialect", [common, old])
def test_values_come_in_the_units_of_the_quantities(dialect: Any) -> None:
    """12.345 V, 2.5 A, 36.5 degC; the rest has the dialect's sentinels. In MAVLink 1 and 2, trailing zeros cut."""
    voltages = [12_345, *UNKNOWN[1:]]
    frame = battery_status(dialect, 1, voltages, current_battery=250, temperature=3650, current_consumed=7)
    assert told(rover(), frame) == {
        "battery.voltage/1": 12.345,
        "battery.current/1": 2.5,
        "battery.temperature/1": 36.5,
        "battery.consumed/1": 7.0,
        "battery.energy/1": None,
        "battery.remaining/1": None,
        "battery.time_left/1": None,
    }


def test_a_voltage_is_the_sum_of_the_cells() -> None:
    """Of what spilled over, and of cells that went out together; of no cell it is unknown."""
    for voltages, value in (
        ([65_534, 1_000, *UNKNOWN[2:]], 66.534),
        ([4_100, 4_050, 4_000, *UNKNOWN[3:]], 12.15),
        ([0, *UNKNOWN[1:]], 0.0),
        (UNKNOWN, None),
    ):
        assert told(rover(), battery_status(common, 0, voltages))["battery.voltage/0"] == value


def test_the_number_of_the_first_instance_counts() -> None:
    """Of a program whose ids begin with a parameter; a number that none of its own has is not of it."""
    systems = read_systems(str(ROOT / "specs" / "codegen.yaml"), Report())
    smart = next(system for system in systems if system.spec.program == "smart_battery")
    frame = battery_status(common, 3, [11_000, *UNKNOWN[1:]])
    assert told(smart, frame, BATT_ID=3)["battery.voltage/0"] == 11.0
    assert told(rover(), battery_status(common, 2, [11_000, *UNKNOWN[1:]])) == {}
    # The rover's two batteries, as if their ids began with that parameter: 5 by its value, or with its default.
    (table,) = rover().tables("BATTERY_STATUS")
    assert table.component is not None
    counted = replace(table, component=replace(table.component, first_number=smart.parameters["BATT_ID"]))
    telling = Telling([counted])
    for number, parameters, instances in ((6, {"BATT_ID": 5.0}, {1}), (4, {"BATT_ID": 5.0}, set()), (2, {}, {0})):
        frame = battery_status(common, number, [11_000, *UNKNOWN[1:]])
        assert {each.instance for each in telling.read(frame, parameters)} == instances


def test_what_could_be_any_instance_is_not_taken() -> None:
    """SYS_STATUS has the voltage of the battery that represents all."""
    fields = (0, 0, 0, 500, 12_000, -1, -1, 0, 0, 0, 0, 0, 0)
    frame = common.MAVLink_sys_status_message(*fields).pack(common.MAVLink(None))
    assert told(rover(), frame) == {"vehicle.load/0": 50.0}
    assert "battery.voltage" in told_paths(rover())


def test_floats_and_multipliers_and_tables_that_share_a_message() -> None:
    """An hdop of 1.2 are 120 steps; NaN is unknown; RUDDER and BILGE are two quantities in one message."""
    boat = system_of("boat")
    link = ardupilotmega.MAVLink(None)
    position = ardupilotmega.MAVLink_gps_raw_int_message(
        1, 3, -353632621, 1396900000, 12500, 120, 65535, 65535, 35999, 255, -33250, 1750, 0, 0, 0
    ).pack(link)
    found = told(boat, position)
    assert found["gps.lat/0"] == pytest.approx(-35.3632621, abs=1e-12)
    assert found["gps.lon/0"] == pytest.approx(139.69, abs=1e-12)
    assert (found["gps.alt/0"], found["gps.hdop/0"], found["gps.course/0"]) == (12.5, 1.2, 359.99)
    assert (found["gps.speed/0"], found["gps.satellites/0"]) == (None, None)
    assert found["gps.accuracy/0"] == 1.75
    wind = ardupilotmega.MAVLink_wind_cov_message(1, math.nan, 0.5, *[math.nan] * 6).pack(link)
    assert told(boat, wind) == {"wind.north/0": None, "wind.east/0": 0.5}
    for name, expected in ((b"RUDDER", {"helm.angle/0": -12.5}), (b"BILGE", {"bilge.level/0": -12.5}), (b"OTHER", {})):
        frame = ardupilotmega.MAVLink_named_value_float_message(1, name, -12.5).pack(link)
        assert told(boat, frame) == expected


def test_others_tell_nothing() -> None:
    """A message that no table has."""
    frame = common.MAVLink_ping_message(1, 2, 3, 4).pack(common.MAVLink(None))
    assert told(rover(), frame) == {}


@pytest.mark.parametrize("policy", Policy)
def test_a_message_that_represents_the_first_tells_of_it(policy: Policy) -> None:
    """What is chosen while the program runs tells of nobody, for which instance it is about does not stand in it."""
    table = next(each for each in rover().messages if each.name == "SYS_STATUS")
    (choice,) = table.represents.values()
    chosen = replace(table, represents={"battery": replace(choice, policy=policy)})
    system = replace(rover(), messages=(chosen,))
    message = common.MAVLink_sys_status_message(0, 0, 0, 0, 12_345, 250, -1, 0, 0, 0, 0, 0, 0)
    found = told(system, message.pack(common.MAVLink(None)))
    assert found.get("battery.voltage/0") == (12.345 if policy is Policy.FIRST else None)
    assert ("battery.voltage" in told_paths(system)) is (policy is Policy.FIRST)
    assert {path.partition("/")[2] for path in found if path.startswith("battery.")} <= {"0"}


@pytest.mark.parametrize(("policy", "is_known"), [("first: true", True), ("lowest: voltage", False)])
def test_what_no_message_tells_of_one_instance_is_not_expected(policy: str, is_known: bool, tmp_path: Path) -> None:
    """Such an expectation could never be met; with represents of the first it can."""
    specs = Path(shutil.copytree(ROOT / "specs", tmp_path / "specs"))
    for table in (specs / "messages").glob("*.yaml"):
        if table.name != "sys_status.yaml":
            table.unlink()
    table = specs / "messages" / "sys_status.yaml"
    table.write_text(table.read_text().replace("{parameter: BATT_SYS_STATUS}", f"{{{policy}}}"))
    scenario = "scenarios:\n  one:\n    doc: d.\n    duration: 5 s\n    courses: {battery.voltage: {value: 12 V}}\n"
    (specs / "scenarios.yaml").write_text(f"{scenario}    expect: [{{at: 4 s, told: battery.voltage, is: 12 V}}]\n")
    report = Report()
    system = read_system(str(specs / "codegen.yaml"), Report())
    assert system is not None
    read_own_scenarios(str(specs / "codegen.yaml"), (system,), report)
    assert ("of an instance that is known" in str(list(report))) is not is_known
