"""MAVSDK and MAVProxy read and set whole parameters of vehicles that have them bytewise, and as C casts."""

import shutil
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from in_process import build
from programs import BIN, Program, wait_until
from test_mavproxy import mavproxy
from test_mavsdk import STATION, Station

from codegen.sim.address import free_port

pytestmark = pytest.mark.timeout(150)

MINIMAL = Path(__file__).resolve().parents[2] / "templates" / "start" / "minimal"
WHOLE = {
    "SMALL": ("uint8", 5, 0, 200),
    "SIGNED": ("int8", -5, -128, 127),
    "MIDDLE": ("uint16", 60000, 0, 65535),
    "BELOW": ("int16", -30000, -32768, 32767),
    "LARGE": ("uint32", 16000000, 0, 16777215),
    "DEEP": ("int32", -16000000, -16777215, 16777215),
}
"""Type, default and limits of the parameters."""


@contextmanager
def vehicle(folder: Path, autopilot: str, encoding: str, port: int) -> Iterator[None]:
    """The vehicle that codegen init begins with, with whole parameters, in real time."""
    project = folder / "project"
    shutil.copytree(MINIMAL, project)
    parameters = project / "specs" / "parameters.yaml"
    text = parameters.read_text().replace("encoding: bytewise", f"encoding: {encoding}")
    for name, (kind, default, low, high) in WHOLE.items():
        text += f"  {name}: {{doc: A number., type: {kind}, default: {default}, min: {low}, max: {high}, step: 1}}\n"
    parameters.write_text(text)
    heartbeat = project / "specs" / "messages" / "heartbeat.yaml"
    heartbeat.write_text(heartbeat.read_text().replace("MAV_AUTOPILOT_GENERIC", autopilot))
    build(project)
    command = [str(BIN / "codegen"), "sim", "nominal", "--duration", "forever", "--out", f"udp:127.0.0.1:{port}"]
    with Program("codegen sim", command, project):
        yield


@pytest.mark.parametrize(
    ("autopilot", "encoding", "settable"),
    [
        ("MAV_AUTOPILOT_GENERIC", "bytewise", {"DEEP"}),
        ("MAV_AUTOPILOT_PX4", "bytewise", {"DEEP"}),
        ("MAV_AUTOPILOT_ARDUPILOTMEGA", "c_cast", set(WHOLE)),
    ],
)
def test_mavsdk_reads_and_sets_whole_parameters(
    autopilot: str, encoding: str, settable: set[str], tmp_path: Path
) -> None:
    """What it reads is right; what it sets is right or refused.

    MAVSDK 4.1.0 reads no whole type without a sign. Bytewise it sets int32 alone, as PX4 has them: of other types it
    sends a NaN, of which the first byte would be 0.
    """
    port = free_port()
    with Program("MAVSDK", [sys.executable, str(STATION), str(port)], tmp_path) as program:
        program.wait_for("=ready=")
        with vehicle(tmp_path, autopilot, encoding, port):
            program.wait_for("=system=")
            station = Station(program)
            signed = {name: default for name, (kind, default, _, _) in WHOLE.items() if kind.startswith("int")}
            found = {each["name"]: each["value"] for each in station.do("param.get_all_params")["int_params"]}
            assert found == signed
            for name, (_, _, low, high) in WHOLE.items():
                for value in (low, high, 1) if name in settable else ():
                    station.do("param.set_param_int", name, value)
                    assert name not in signed or station.do("param.get_param_int", name) == value, name
            for name in WHOLE.keys() - settable:
                _, error = station.outcome("param.set_param_int", name, 7)
                assert error is not None, name
                if name in signed:  # it may take a late answer to the one for that to the other
                    wait_until(lambda name=name: station.outcome("param.get_param_int", name)[1] is None, name)
                    assert station.do("param.get_param_int", name) == signed[name]


@pytest.mark.parametrize(
    ("autopilot", "encoding"), [("MAV_AUTOPILOT_PX4", "bytewise"), ("MAV_AUTOPILOT_ARDUPILOTMEGA", "c_cast")]
)
def test_mavproxy_reads_and_sets_whole_parameters(autopilot: str, encoding: str, tmp_path: Path) -> None:
    """MAVProxy takes them bytewise of PX4 alone."""
    port = free_port()
    with mavproxy(port, tmp_path) as proxy, vehicle(tmp_path, autopilot, encoding, port):
        proxy.wait_for(r"Received \d+ parameters")
        position = proxy.say("param show *")
        for name, (_, default, _, _) in WHOLE.items():
            proxy.wait_for(rf"{name} +{default}\b", position)
        for name, (_, _, low, _) in WHOLE.items():
            proxy.say(f"param set {name} {low + 1}")
            proxy.repeat(f"param show {name}", rf"{name} +{low + 1}\b")


def test_mavproxy_is_refused_by_others(tmp_path: Path) -> None:
    """It sends a float to a vehicle of MAV_AUTOPILOT_GENERIC: nothing is set, and a text says why."""
    port = free_port()
    with mavproxy(port, tmp_path) as proxy, vehicle(tmp_path, "MAV_AUTOPILOT_GENERIC", "bytewise", port):
        proxy.wait_for(r"Received \d+ parameters")
        proxy.say("param set SMALL 7")
        proxy.wait_for("SMALL is not sent as bytes of type 1")
