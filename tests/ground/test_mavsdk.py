"""MAVSDK, the library of many ground stations, against the running firmware."""

import json
import sys
from pathlib import Path
from typing import Any

import pytest
from programs import Program
from pymavlink.dialects.v20 import common

from codegen.sim.address import free_port

pytestmark = pytest.mark.timeout(120)

STATION = Path(__file__).with_name("mavsdk_station.py")


class Station:
    """A running mavsdk_station.py."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self._number = 0

    def do(self, method: str, *values: Any) -> Any:
        """Return the result of a plugin's method; the test fails if it reports an error."""
        result, error = self.outcome(method, *values)
        assert error is None, method
        return result

    def outcome(self, method: str, *values: Any) -> tuple[Any, str | None]:
        """Return the result of a plugin's method, and the name of the error that it reports."""
        self._number += 1
        since = self.program.say(json.dumps({"do": method, "with": values, "number": self._number}))
        found = self.program.wait_for(rf'\n=done= (\{{"number": {self._number},.*\}})\n', since)
        answer = json.loads(found[1])
        return answer["result"], answer["error"]

    def sees(self, kind: str, pattern: str = ".*", since: int | None = None) -> Any:
        """The next value of a kind, written as the pattern says."""
        position = self.program.position if since is None else since
        found = self.program.wait_for(rf'\n=seen= \{{"kind": "{kind}", "value": ({pattern})\}}\n', position)
        return json.loads(found[1])

    def batteries_per_second(self, seconds: int = 5) -> float:
        """BATTERY_STATUS in a second of the rover's time, of which each HEARTBEAT reports `armed`."""
        armed = r'\n=seen= \{"kind": "armed", .*\n'
        first = position = self.program.wait_for(armed, self.program.position).end() - 1
        for _ in range(seconds):
            position = self.program.wait_for(armed, position).end() - 1
        return self.program.written[first:position].count('=seen= {"kind": "battery"') / seconds


def connected(start: Any, program: Program, port: int, scenario: str) -> Station:
    program.wait_for("=ready=")
    start(port, scenario, "--speed", "4")
    program.wait_for("=system=")
    return Station(program)


def station_on(port: int, folder: Path) -> Program:
    return Program("MAVSDK", [sys.executable, str(STATION), str(port)], folder)


@pytest.fixture(scope="module")
def station(start_shared: Any, tmp_path_factory: pytest.TempPathFactory) -> Any:
    """MAVSDK connected to a rover with 12 V, at four times the speed."""
    port = free_port()
    with station_on(port, tmp_path_factory.mktemp("mavsdk")) as program:
        yield connected(start_shared, program, port, "steady")


@pytest.mark.requirement("FR-00068.8")
def test_system_is_found(station: Station) -> None:
    """Its HEARTBEAT makes it a system, and an ArduPilot rover."""
    found = json.loads(station.program.wait_for(r"=system= (\{.*\})\n")[1])
    assert (found["number"], found["components"]) == (1, [1])
    assert found["vehicle"] in (common.MAV_TYPE_GROUND_ROVER, 4)
    assert found["autopilot"] == 2, "Autopilot.ARDUPILOT"


@pytest.mark.requirement("FR-00068.3", "FR-00068.4", "FR-00068.5", "FR-00068.6", "FR-00068.8")
def test_battery(station: Station) -> None:
    """The voltage, and nothing that is not measured."""
    # Until the first BATTERY_STATUS is heard, MAVSDK makes a battery of SYS_STATUS, which has no function.
    battery = station.sees("battery", rf'.*"battery_function": {common.MAV_BATTERY_FUNCTION_ALL}.*')
    assert battery["id"] == 0
    assert battery["voltage_v"] == pytest.approx(12.0)
    assert battery["remaining_percent"] == -1, "MAVSDK hands the -1 of BATTERY_STATUS on"
    for name in ("current_battery_a", "capacity_consumed_ah", "temperature_degc", "time_remaining_s"):
        assert battery[name] != battery[name], f"{name} is NaN, unknown"


@pytest.mark.requirement("FR-00068.2", "FR-00070.3")
def test_rate_of_the_battery(station: Station) -> None:
    """2 Hz, 10 Hz when it is asked for, and 2 Hz again."""
    assert abs(station.batteries_per_second() - 2) <= 0.4
    station.do("telemetry.set_rate_battery", 10.0)
    assert abs(station.batteries_per_second() - 10) <= 1
    station.do("telemetry.set_rate_battery", 2.0)
    assert abs(station.batteries_per_second() - 2) <= 0.4


@pytest.mark.requirement("NFR-00061.5", "NFR-00061.6")
def test_parameters_are_written_and_read(station: Station) -> None:
    """Floats, and integers of every size, which travel as MAVSDK expects them from an ArduPilot."""
    for name, value, usual in (("BATT_LOW_VOLT", 10.8, 10.5), ("BATT_VOLT_MULT", 4.0158, 3.95)):
        assert station.do("param.get_param_float", name) == pytest.approx(usual)
        station.do("param.set_param_float", name, value)
        assert station.do("param.get_param_float", name) == pytest.approx(value)
        station.do("param.set_param_float", name, usual)
    for name, value, usual in (("BATT_CAPACITY", 500_000, 3300), ("SR0_EXTRA1", 3, 2), ("BATT_LOW_TIMER", 120, 10)):
        assert station.do("param.get_param_int", name) == usual
        station.do("param.set_param_int", name, value)
        assert station.do("param.get_param_int", name) == value
        station.do("param.set_param_int", name, usual)
        assert station.do("param.get_param_int", name) == usual


@pytest.mark.requirement("NFR-00061.5")
def test_parameters_that_are_refused(station: Station) -> None:
    """MAVSDK learns why, and the value stays."""
    assert station.outcome("param.set_param_float", "BATT_LOW_VOLT", 1000.0)[1] == "VALUE_OUT_OF_RANGE"
    assert station.do("param.get_param_float", "BATT_LOW_VOLT") == 10.5
    assert station.outcome("param.set_param_int", "BATT_LOW_TIMER", 121)[1] == "VALUE_OUT_OF_RANGE"
    assert station.do("param.get_param_int", "BATT_LOW_TIMER") == 10
    assert station.outcome("param.get_param_int", "NO_SUCH_PARAM")[1] == "DOES_NOT_EXIST"


@pytest.mark.requirement("NFR-00061.6")
def test_all_parameters(station: Station) -> None:
    """The whole list, each with its kind."""
    everything = station.do("param.get_all_params")
    floats = {one["name"]: one["value"] for one in everything["float_params"]}
    integers = {one["name"]: one["value"] for one in everything["int_params"]}
    each = ["AMP_OFFSET", "AMP_PERVLT", "ARM_VOLT", "CRT_MAH", "CRT_VOLT", "LOW_MAH", "LOW_VOLT", "VOLT_MULT"]
    assert sorted(floats) == [f"{prefix}_{name}" for prefix in ("BATT2", "BATT") for name in each]
    assert floats["BATT_VOLT_MULT"] == pytest.approx(3.95)
    assert len(integers) == 23
    assert integers["BATT_CAPACITY"] == 3300


@pytest.mark.requirement("FR-00070.13")
def test_there_are_no_missions_and_logs(station: Station) -> None:
    """MAVSDK runs into no time-out: what it clears is clear, and it fetches nothing without MISSION_INT."""
    assert station.outcome("mission.clear_mission")[1] is None
    assert station.outcome("geofence.clear_geofence")[1] is None
    assert station.outcome("log_files.get_entries") == (None, "NO_LOGFILES")
    assert station.outcome("mission.download_mission") == (None, "INT_MESSAGES_NOT_SUPPORTED")


@pytest.mark.requirement("FR-00070.5", "FR-00068.9")
def test_arming(station: Station) -> None:
    """Armable, armed, disarmed; with a reason where it is refused."""
    station.sees("health", r'\{[^{}]*"is_armable": true[^{}]*\}')  # a reading that a busy machine delays is none
    station.do("action.arm")
    station.sees("armed", "true")
    station.do("action.disarm")
    station.sees("armed", "false")
    station.do("param.set_param_float", "BATT_ARM_VOLT", 12.5)
    station.sees("health", '.*"is_armable": false.*')
    since = station.program.position
    assert station.outcome("action.arm")[1] == "FAILED"
    text = station.sees("status_text", r'.*"text": "PreArm.*', since)
    assert text["text"] == "PreArm: Battery 1 below minimum arming voltage"
    station.do("param.set_param_float", "BATT_ARM_VOLT", 0.0)
    station.sees("health", '.*"is_armable": true.*')


@pytest.mark.requirement("FR-00070.2")
def test_version(station: Station) -> None:
    """AUTOPILOT_VERSION, which MAVSDK asks for, answers its questions."""
    assert station.do("info.get_version")["flight_sw_major"] is not None
    station.do("info.get_product")
    station.do("info.get_identification")


@pytest.mark.requirement("FR-00070.6", "FR-00069.6")
def test_reboot(station: Station) -> None:
    """The calibration is in force after MAVSDK has restarted the rover."""
    station.do("param.set_param_float", "BATT_VOLT_MULT", 4.0158)
    station.do("action.reboot")
    station.sees("battery", r'.*"voltage_v": 12\.[12].*')
    assert station.do("param.get_param_float", "BATT_VOLT_MULT") == pytest.approx(4.0158)
    station.do("param.set_param_float", "BATT_VOLT_MULT", 3.95)
    station.do("action.reboot")
    station.sees("battery", r'.*"voltage_v": (12\.00|12\.0\b|11\.99).*')


@pytest.mark.requirement("FR-00020.10")
def test_low_pack_is_not_armable(start: Any, tmp_path: Path) -> None:
    """MAVSDK says so before anybody tries."""
    port = free_port()
    with station_on(port, tmp_path) as program:
        station = connected(start, program, port, "low")
        assert station.sees("health", '.*"is_armable".*')["is_armable"] is False
        assert station.outcome("action.arm")[1] == "FAILED"
        program.wait_for("PreArm: Battery 1 low voltage failsafe")


@pytest.mark.requirement("FR-00068.5", "FR-00021.5")
def test_remaining_charge(start: Any, tmp_path: Path, estimating: Path) -> None:
    """With the estimate switched on, 12 V are 77 %."""
    port = free_port()
    with station_on(port, tmp_path) as program:
        program.wait_for("=ready=")
        start(port, "steady", "--speed", "4", project=estimating)
        program.wait_for("=system=")
        assert Station(program).sees("battery")["remaining_percent"] == 77
