"""Two batteries, and a smart battery beside the autopilot, as MAVProxy, MAVSDK and pymavlink see them.

All programs send to one port of the station, which listens: two senders, both answered.
"""

from pathlib import Path
from typing import Any

import pytest
from ground_link import GroundLink
from programs import BIN, Program, wait_until
from pymavlink.dialects.v20 import common
from test_mavproxy import mavproxy
from test_mavsdk import Station, station_on

from codegen.sim.address import free_port

pytestmark = pytest.mark.timeout(150)

ROOT = Path(__file__).resolve().parents[2]
BATTERY = (1, 180)
"""System and component of the smart battery."""

SCENARIOS = """
scenarios:
  two:
    doc: Two packs.
    duration: 60 s
    parameters: {BATT2_MONITOR: 3}
    courses: {battery.voltage: {value: 12 V}, 'battery[1].voltage': {value: 11 V}}
  smart:
    doc: A pack, and a smart battery.
    duration: 60 s
    courses: {battery.voltage: {value: 12 V}}
    with: {smart_battery: {courses: {battery.voltage: {value: 11 V}}, parameters: {BATT_ID: 3}}}
"""


def sim(folder: Path, port: int, name: str, *options: str) -> Program:
    path = folder / "batteries.yaml"
    path.write_text(SCENARIOS)
    command = [str(BIN / "codegen"), "sim", f"{path}:{name}", "--duration", "forever", "--out", f"udp:127.0.0.1:{port}"]
    return Program(f"codegen sim {name}", [*command, *options], ROOT)


def voltage(status: Any) -> int:
    """The voltage of a BATTERY_STATUS in mV: the sum of the cells that are known."""
    return sum(cell for cell in status.voltages if cell != 0xFFFF)


@pytest.mark.requirement("FR-00073.4")
def test_both_batteries_come_with_their_ids(link: GroundLink, tmp_path: Path) -> None:
    """One message per battery, whose id is that of the battery."""
    with sim(tmp_path, link.port, "two"):
        for number, millivolts in ((0, 12_000), (1, 11_000)):
            status = link.wait_for("BATTERY_STATUS", 0, lambda message, number=number: message.id == number)
            assert abs(voltage(status) - millivolts) <= 5


@pytest.mark.requirement("FR-00074.1", "FR-00074.7")
def test_two_senders_are_one_system(link: GroundLink, tmp_path: Path) -> None:
    """The battery is a component of the rover's system, with a battery id of its own."""
    with sim(tmp_path, link.port, "smart"):
        beat = link.wait_for("HEARTBEAT", 0, lambda message: message.get_srcComponent() == BATTERY[1])
        assert (beat.get_srcSystem(), beat.type) == (BATTERY[0], common.MAV_TYPE_BATTERY)
        status = link.wait_for("BATTERY_STATUS", 0, lambda message: message.get_srcComponent() == BATTERY[1])
        assert (status.id, abs(voltage(status) - 11_000) <= 5) == (3, True)
        wait_until(lambda: link.take_in(0.05) > 0 and len(link.senders) == 2, "two senders")
        for component, name in ((1, "BATT_LOW_VOLT"), (180, "BATT_ID")):
            position = link.take_in()
            link.send.param_request_read_send(1, component, name.encode(), -1)
            answer = link.wait_for("PARAM_VALUE", position, lambda message, name=name: message.param_id == name)
            assert answer.get_srcComponent() == component, (
                "what is said reaches both, and the one that is meant answers"
            )


@pytest.mark.requirement("FR-00073.4")
def test_mavproxy_shows_two_batteries(tmp_path: Path) -> None:
    """The battery module and the messages have both."""
    port = free_port()
    with mavproxy(port, tmp_path) as station, sim(tmp_path, port, "two"):
        station.wait_for(r"Received \d+ parameters")
        position = station.say("watch BATTERY_STATUS")
        station.wait_for(r"< BATTERY_STATUS \{id : 0,.*voltages : \[12000,", position)
        station.wait_for(r"< BATTERY_STATUS \{id : 1,.*voltages : \[1(?:0999|1000|1001),", position)


@pytest.mark.requirement("FR-00074.1")
def test_mavproxy_hears_the_battery_beside_the_autopilot(tmp_path: Path) -> None:
    """One port, two senders; the battery does not take the vehicle's place, and both answer."""
    port = free_port()
    with mavproxy(port, tmp_path) as station, sim(tmp_path, port, "smart"):
        station.wait_for("online system 1")
        station.wait_for(r"Received \d+ parameters")
        station.wait_for("Detected vehicle 1:180")
        position = station.say("watch BATTERY_STATUS")
        station.wait_for(r"< BATTERY_STATUS \{id : 0,.*voltages : \[12000,", position)
        position = station.say("arm throttle")
        station.wait_for("COMPONENT_ARM_DISARM: ACCEPTED", position)


@pytest.mark.requirement("FR-00073.4", "FR-00074.7")
@pytest.mark.parametrize(("scenario", "number"), [("two", 1), ("smart", 3)])
def test_mavsdk_sees_both_batteries(tmp_path: Path, scenario: str, number: int) -> None:
    """One system with two batteries, from one sender or from two, and commands still work."""
    port = free_port()
    with station_on(port, tmp_path) as program:
        program.wait_for("=ready=")
        with sim(tmp_path, port, scenario, "--speed", "4"):
            program.wait_for("=system=")
            station = Station(program)
            for battery, volts in ((0, 12.0), (number, 11.0)):
                seen = station.sees("battery", rf'\{{[^}}]*"id": {battery}[,}}][^}}]*\}}?')
                assert seen["voltage_v"] == pytest.approx(volts, abs=0.005)
            assert station.do("param.get_param_int", "BATT_CAPACITY") == 3300


@pytest.mark.requirement("FR-00074.1")
def test_mavproxy_turns_to_the_battery(tmp_path: Path) -> None:
    """MAVProxy shows the component that it is turned to, here the battery."""
    port = free_port()
    with mavproxy(port, tmp_path) as station, sim(tmp_path, port, "smart"):
        station.wait_for("Detected vehicle 1:180")
        station.say("vehicle 1:180")
        position = station.say("watch BATTERY_STATUS")
        station.wait_for(r"< BATTERY_STATUS \{id : 3,.*voltages : \[1(?:0999|1000|1001),", position)
