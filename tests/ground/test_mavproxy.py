"""MAVProxy, as a user types into it, against the running firmware. Its default modules are loaded, FTP among them."""

import re
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from programs import BIN, Program

from codegen.sim.address import free_port

pytestmark = pytest.mark.timeout(150)


@contextmanager
def mavproxy(port: int, folder: Path, *options: str, kind: str = "udpin") -> Iterator[Program]:
    """A MAVProxy that listens at a port, or connects to it; its home is `folder`: no settings of the user count."""
    script = BIN / "mavproxy.py"
    assert script.exists(), "MAVProxy is not installed: make test does it"
    command = [str(script), f"--master={kind}:127.0.0.1:{port}", f"--state-basedir={folder}", *options]
    with Program("MAVProxy", command, folder, HOME=str(folder)) as program:
        program.wait_for("Waiting for heartbeat")
        yield program


@pytest.fixture(scope="module")
def station(start_shared: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Program]:
    """MAVProxy connected to a rover with 12 V, in real time."""
    port = free_port()
    with mavproxy(port, tmp_path_factory.mktemp("mavproxy")) as program:
        start_shared(port, "steady")
        program.wait_for(r"Received \d+ parameters")
        yield program


@pytest.mark.requirement("FR-00068.8")
def test_rover_is_online(station: Program) -> None:
    """Its HEARTBEAT makes it a vehicle, and a rover, whose mode 0 is called MANUAL."""
    station.wait_for("Detected vehicle 1:1")
    station.wait_for("online system 1")
    station.wait_for("Mode MANUAL")


@pytest.mark.requirement("NFR-00061.6", "FR-00070")
def test_all_parameters_are_fetched_though_there_are_no_files(station: Program) -> None:
    """FTP is refused at once, and the parameter messages bring all of them."""
    assert station.wait_for(r"Received (\d+) parameters")[1] == "39"
    assert "(ftp)" not in station.written
    position = station.say("param status")
    station.wait_for("Have 39/39 params", position)
    position = station.say("param show *")
    for name, value in (("BATT_CAPACITY", "3300"), ("BATT_LOW_VOLT", r"10\.5"), ("SYSID_THISMAV", "1")):
        station.wait_for(rf"{name} +{value}", position)


@pytest.mark.requirement("FR-00070.13")
def test_there_is_no_mission_and_no_log(station: Program) -> None:
    """The user's list is empty at once, in place of a request that is repeated for ever."""
    position = station.say("wp list")
    station.wait_for(r"Requesting 0 waypoints", position)
    position = station.say("log list")
    station.wait_for(r"No logs|numLogs 0", position)


@pytest.mark.requirement("FR-00068.3", "FR-00068.5")
def test_voltage_is_shown_and_charge_is_unknown(station: Program) -> None:
    """The user reads 12.000 V in cell 0; the battery module's charge is -1, unknown."""
    position = station.say("watch BATTERY_STATUS")
    battery = station.wait_for(r"< BATTERY_STATUS \{.*\}", position)[0]
    station.say("watch")
    cells = ", ".join(["12000"] + ["65535"] * 9)
    assert f"voltages : [{cells}], current_battery : -1" in battery
    assert "battery_remaining : -1," in battery
    position = station.say("bat")
    station.wait_for(r"Flight battery: +-1%", position)


@pytest.mark.requirement("FR-00068.3")
def test_voltage_in_the_battery_module(station: Program) -> None:
    """The module adds the cells up, and the unknown ones are none."""
    station.say("set numcells 0")
    position = station.say("bat")
    line = station.wait_for(r"Flight battery: .*\n(?:.*\n)?", position)[0]
    volts = re.findall(r"([\d.]+)V", line)
    assert all(volt in ("12.00", "12.0") for volt in volts), line
    position = station.say("status BATTERY_STATUS")
    station.wait_for(r"BATTERY_STATUS \{.*voltages : \[12000, 65535,", position)


@pytest.mark.requirement("NFR-00061.5")
def test_parameter_is_set(station: Program) -> None:
    """MAVProxy takes the value as set, and reads it back from the vehicle."""
    for value in ("10.8", "10.5"):
        station.say(f"param set BATT_LOW_VOLT {value}")
        station.repeat("param fetch BATT_LOW_VOLT", rf"BATT_LOW_VOLT = {value}0")
        station.repeat("param show BATT_LOW_VOLT", rf"BATT_LOW_VOLT +{value}")
    assert "Failed to set BATT_LOW_VOLT to 10." not in station.written


@pytest.mark.requirement("NFR-00061.5")
def test_parameter_out_of_range_is_refused(station: Program) -> None:
    """The user reads why, MAVProxy sees that it was not set, and the old value is in force."""
    position = station.say("param set BATT_CRT_VOLT 1000")
    station.wait_for(r"AP: BATT_CRT_VOLT: 1000 is not 0 to 100", position)
    station.wait_for(r"Failed to set BATT_CRT_VOLT to 1000 \(invalid returned value 9\.89", position)
    station.repeat("param fetch BATT_CRT_VOLT", r"BATT_CRT_VOLT = 9\.8999")


@pytest.mark.requirement("FR-00070.5")
def test_arming(station: Program) -> None:
    """Accepted while the pack is good, and the rover says so."""
    position = station.say("arm throttle")
    station.wait_for("COMPONENT_ARM_DISARM: ACCEPTED", position)
    station.wait_for("AP: Armed", position)
    station.wait_for(r"\bARMED\b", position)
    position = station.say("disarm")
    station.wait_for("COMPONENT_ARM_DISARM: ACCEPTED", position)
    station.wait_for("DISARMED", position)


@pytest.mark.requirement("FR-00070.10")
def test_link_loses_nothing(station: Program) -> None:
    """The sequence numbers have no gaps, whatever was asked for."""
    position = station.say("link")
    found = station.wait_for(r"link 1 OK \((\d+) packets, .* (\d+) lost,", position)
    assert int(found[1]) > 10
    assert found[2] == "0"


@pytest.mark.requirement("FR-00020.10", "FR-00070.5")
def test_arming_with_a_low_pack_is_refused(start: Any, tmp_path: Path) -> None:
    """Refused, and the user reads which check failed: at once after connecting, and when asked for."""
    port = free_port()
    with mavproxy(port, tmp_path) as station:
        start(port, "low")
        station.wait_for("AP: PreArm: Battery 1 low voltage failsafe")
        station.wait_for("Received 39 parameters")
        time.sleep(2.1)  # MAVProxy shows no text again within 2 s
        position = station.say("arm throttle")
        station.wait_for("AP: PreArm: Battery 1 low voltage failsafe", position)
        station.wait_for("COMPONENT_ARM_DISARM: FAILED", position)
        assert not re.search(r"\bARMED\b", station.written)
        assert "breach" not in station.written  # of a fence that there is not
        assert "checks disabled" not in station.written


@pytest.mark.requirement("FR-00068.5", "FR-00021.5")
def test_remaining_charge(start: Any, tmp_path: Path, estimating: Path) -> None:
    """With the estimate switched on, 12 V are 77 %, in the message and in the module."""
    port = free_port()
    with mavproxy(port, tmp_path) as station:
        start(port, "steady", project=estimating)
        station.wait_for("Received 39 parameters")
        position = station.say("watch BATTERY_STATUS")
        station.wait_for(r"< BATTERY_STATUS \{.*battery_remaining : 77,", position)
        position = station.say("bat")
        station.wait_for(r"Flight battery: +77%", position)


@pytest.mark.requirement("FR-00068.4", "FR-00068.5", "FR-00068.6", "FR-00077.5")
def test_current_and_charge(start: Any, tmp_path: Path) -> None:
    """With a current sensor the user sees what is drawn, what was, and what is left of it."""
    port = free_port()
    with mavproxy(port, tmp_path) as station:
        start(port, "drawing")
        station.wait_for("Received 39 parameters")
        position = station.say("watch BATTERY_STATUS")
        drawn = r"current_battery : 1200, current_consumed : (\d+), energy_consumed : \d+, battery_remaining : (\d+),"
        found = station.wait_for(rf"< BATTERY_STATUS \{{.*{drawn}", position)
        assert 0 < int(found[1]) == 100 - int(found[2])
        position = station.say("bat")
        station.wait_for(r"Flight battery: +\d\d%", position)


@pytest.mark.requirement("FR-00068.8")
def test_what_a_newcomer_types(tmp_path: Path) -> None:
    """`codegen sim` and `mavproxy.py --master=...`, with nothing but the port changed, find each other."""
    port = free_port()
    sim = [str(BIN / "codegen"), "sim", "--out", f"udp:127.0.0.1:{port}"]
    station = [str(BIN / "mavproxy.py"), f"--master=udp:127.0.0.1:{port}"]
    root = Path(__file__).resolve().parents[2]
    with Program("codegen sim", sim, root), Program("MAVProxy", station, tmp_path, HOME=str(tmp_path)) as program:
        program.wait_for("online system 1")
        program.wait_for("Received 39 parameters")
        position = program.say("watch BATTERY_STATUS")
        program.wait_for(r"< BATTERY_STATUS \{.*voltages : \[12[23]\d\d, 65535", position)
