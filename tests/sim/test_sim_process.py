"""The firmware as a process: what goes over the wire, restarts, crashes, and every way to end."""

import json
import os
import re
import signal
import subprocess
import sys
import time
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from packs import VOLTAGE, program, steady, volts
from pymavlink.dialects.v20 import common

from codegen.model.scenario import Scenario
from codegen.sim.address import Address
from codegen.sim.flash import flash_folder
from codegen.sim.process import Runtime, find_interpreter
from codegen.sim.record import Recording
from codegen.sim.run import Simulation, simulate
from codegen.sim.sample import Kind

RUNTIMES = pytest.mark.parametrize("runtime", [str(runtime) for runtime in Runtime])


def decoded(datagrams: list[tuple[bytes, int]]) -> list[Any]:
    """The messages of the datagrams, as pymavlink reads them."""
    parser = common.MAVLink(None)
    return [message for data, _ in datagrams for message in parser.parse_buffer(data) or []]


@RUNTIMES
def test_the_ground_station_gets_what_is_counted(run: Any, station: Any, runtime: str) -> None:
    code, out, err = run("nominal", "--duration", "3 s", "--runtime", runtime)
    assert (code, "warning" in out) == (0, False), err
    messages = decoded(station.received())
    counts = {name: sum(message.get_type() == name for message in messages) for name in
              ("BATTERY_STATUS", "HEARTBEAT", "SYS_STATUS")}  # fmt: skip
    assert sum(counts.values()) == len(messages)
    assert {name: int(count) for name, count in re.findall(r"\n    (\w+) +(\d+) frames ", out)} == counts
    size = re.search(r"(\d+) frames, (\d+) bytes", out)
    assert size is not None
    assert int(size[1]) == len(messages)
    assert int(size[2]) == sum(len(message.get_msgbuf()) for message in messages)
    voltages = [message.voltages[0] for message in messages if message.get_type() == "BATTERY_STATUS"]
    assert all(abs(voltage - 12_300) <= 30 for voltage in voltages)


@RUNTIMES
def test_both_runtimes_tell_the_same_story(run: Any, runtime: str) -> None:
    code, out, _ = run("critical", "--runtime", runtime)
    assert code == 0
    assert "The failsafe fired: low at 19.6 s, critical at 39.1 s." in out
    assert re.search(r"battery\.voltage was told at most 0\.0\d+ V from what was true", out)
    assert "\n    5.0 s  armed\n" in out
    assert "\n   19.6 s  warning   Battery 1 is low 10.19V used 0 mAh\n" in out
    assert "\n   19.6 s  failsafe  Battery 1 low\n" in out


def test_faults_of_the_adc_reach_the_firmware(run: Any, station: Any) -> None:
    code, out, _ = run("adc_fault")
    assert code == 0
    assert "took too long to read, in us: 15000" in out
    assert "cannot be read" in out
    battery = [message for message in decoded(station.received()) if message.get_type() == "BATTERY_STATUS"]
    known = [message.voltages[0] != 0xFFFF for message in battery]
    assert known[:10] == [True] * 10
    assert not any(known[2 * 22 : 2 * 29])
    assert all(known[2 * 32 : 2 * 44])
    assert not any(known[2 * 47 :])


@RUNTIMES
def test_a_restart_keeps_port_flash_and_time(project: Path, run: Any, station: Any, runtime: str) -> None:
    (project / "rover.py").write_text(
        "import main, machine, time, os\n"
        "class Rover(main.Vehicle):\n"
        "    def control(self):\n"
        "        if time.ticks_ms() >= 2000 and 'been.txt' not in os.listdir():\n"
        "            open('been.txt', 'w').close()\n"
        "            machine.reset()\n"
    )
    flash = project / "flash"
    arguments = ("--duration", "8 s", "--runtime", runtime, "--code", "rover.py", "--flash", str(flash))
    code, out, err = run("nominal", *arguments)
    assert code == 0, err
    assert "The board restarted once." in out
    assert "\n    2.0 s  reboot    The board restarted\n" in out
    datagrams = station.received()
    assert len({port for _, port in datagrams}) == 1
    heartbeats = [message for message in decoded(datagrams) if message.get_type() == "HEARTBEAT"]
    assert len(heartbeats) >= 2 + 6, "both starts send them"
    assert [bool(heartbeat.base_mode & 128) for heartbeat in heartbeats][-2:] == [True, True], "armed at 5 s"
    assert os.listdir(flash) == ["been.txt"]


def test_a_scenario_restarts_the_board_once(project: Path, run: Any) -> None:
    (project / "own.yaml").write_text(
        "scenarios:\n  own:\n    doc: d\n    duration: 4 s\n    courses: {battery.voltage: {value: 12 V}}\n"
        "    events: [{at: 1 s, arm: true}, {at: 2 s, reboot: true}]\n"
    )
    code, out, _ = run("own.yaml")
    assert code == 0
    assert out.count("armed") == 1
    assert "The board restarted once." in out
    assert "own: 4.0 s" in out


def test_restarts_without_end_are_given_up(project: Path, run: Any) -> None:
    (project / "mine.py").write_text("import machine\nmachine.reset()\n")
    code, out, err = run("nominal", "--code", "mine.py")
    assert code == 1
    assert "over and over" in err
    assert "Traceback" not in out + err


@RUNTIMES
def test_a_crash_is_an_error_line_and_stands_in_the_report(project: Path, run: Any, runtime: str) -> None:
    (project / "mine.py").write_text(
        "import main\nclass Rover(main.Vehicle):\n    def control(self):\n        raise ValueError('wheels <off>')\n"
    )
    code, out, err = run("nominal", "--code", "mine.py", "--runtime", runtime, "--report", "r.html", "--quiet")
    assert code == 1
    assert re.search(
        r"^codegen sim: error: the firmware stopped: ValueError: wheels <off> \(.*rover\.py:4\)$", err, re.M
    )
    assert "Traceback" not in out + err
    report = (project / "r.html").read_text()
    assert "wheels &lt;off&gt;" in report
    assert "Traceback" in report


@pytest.mark.parametrize(
    ("program", "says"),
    [
        ("class Rover(\n", "SyntaxError"),
        ("import sys\nsys.exit(0)\n", "main() returned"),
        ("import sys\nsys.exit(7)\n", "main() returned"),
    ],
)
def test_a_program_that_does_not_even_start(project: Path, run: Any, program: str, says: str) -> None:
    """One that is given for this run alone: that of vehicle.yaml is looked at before, as `unfit-code`."""
    (project / "mine.py").write_text(program)
    code, out, err = run("nominal", "--code", "mine.py", "--quiet")
    assert code == 1
    assert says in err
    assert "Traceback" not in out + err


@RUNTIMES
def test_code_of_the_user_finds_pwm_and_spi(project: Path, run: Any, runtime: str) -> None:
    """Whatever the file is called: a servo at 1.5 ms of 20 ms, and a bus on which nobody answers."""
    (project / "anything.py").write_text(
        "from machine import PWM, SPI, Pin\nimport main\n"
        "class Rover(main.Vehicle):\n"
        "    def __init__(self):\n"
        "        main.Vehicle.__init__(self)\n"
        "        servo, bus, buffer = PWM(Pin(5), freq=50), SPI(0, 1000000, sck=Pin(2)), bytearray(b'xx')\n"
        "        servo.duty_ns(1500000)\n"
        "        bus.write_readinto(b'\\x01\\x02', buffer)\n"
        "        print(servo.freq(), servo.duty_u16(), servo.duty_ns(), bytes(bus.sent), bytes(buffer), bus.read(1))\n"
    )
    code, out, err = run("nominal", "--duration", "1 s", "--code", "anything.py", "--runtime", runtime)
    assert code == 0, err
    assert r"console   50 4915 1499961 b'\x01\x02' b'\x00\x00' b'\x00'" in out


def test_what_the_program_prints_is_shown(project: Path, run: Any) -> None:
    (project / "rover.py").write_text("from main import Vehicle as Rover\nprint('hello <there>')\n")
    code, out, _ = run("nominal", "--code", "rover.py", "--duration", "1", "--report", "r.html")
    assert code == 0
    assert "console   hello <there>" in out
    assert "hello &lt;there&gt;" in (project / "r.html").read_text()


OWN = Scenario("own", "d", 1_000, 1, (steady(12.0),))


def simulation(project: Path, code: str | None = None, **other: Any) -> Simulation:
    scenario = OWN
    interpreter = find_interpreter(Runtime.MICROPYTHON)
    assert interpreter is not None
    folder = str(project / "generated")
    values: dict[str, Any] = {
        "scenario": scenario,
        "duration_ms": 1_000,
        "speed": 0.0,
        "runtime": Runtime.MICROPYTHON,
        "interpreter": interpreter,
        "to": Address("127.0.0.1", 9, "udp:127.0.0.1:9"),
        "flash": None,
        "programs": (program(scenario, folder, code=code),),
    }
    return Simulation(**values | other)


def test_a_program_that_blocks_is_given_up(project: Path) -> None:
    (project / "rover.py").write_text(
        "import main\nclass Rover(main.Vehicle):\n    def control(self):\n        while True:\n            pass\n"
    )
    blocked = simulation(project, code=str(project / "rover.py"))
    recording = blocked.recording()
    simulate(blocked, recording, lambda *_: None, silence_s=0.5)
    assert recording.problem is not None
    assert "does not let time pass" in recording.problem


def test_time_passes_at_the_speed_that_is_asked_for(project: Path) -> None:
    """Virtual time is not ahead of real time; how late it is depends on the host, so only one side is held."""
    paced = simulation(project, duration_ms=4_000, speed=4.0)
    started = time.monotonic()
    recording = paced.recording()
    simulate(paced, recording, lambda *_: None)
    assert recording.at_ms >= 4_000
    assert time.monotonic() - started >= 1.0
    assert recording.problem is None


@RUNTIMES
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_ctrl_c_ends_it_and_the_report_is_written(project: Path, station: Any, runtime: str, number: int) -> None:
    command = [sys.executable, "-m", "codegen", "sim", "nominal", "--duration", "forever", "--report", "r.html"]
    options = ["--out", station.address, "--runtime", runtime, "--flash", "flash"]
    running = subprocess.Popen([*command, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    station.socket.settimeout(30)
    for _ in range(4):
        station.socket.recvfrom(2048)  # three at the start, one half a second later
    time.sleep(0.2)  # and it waits for the next one
    running.send_signal(number)
    out, err = running.communicate(timeout=30)
    assert running.returncode == 0, err
    assert "It was interrupted at" in out
    assert f" {4 + len(station.received())} frames" in out, "what it sent last is counted, too"
    assert "Traceback" not in out + err
    assert "It was interrupted at" in (project / "r.html").read_text()
    assert os.listdir(project / "flash") == []


def test_the_board_s_own_wifi_settings_come_back(tmp_path: Path) -> None:
    own = json.dumps({"ssid": "home", "password": "secret"})
    (tmp_path / "wifi.json").write_text(own)
    to = Address("127.0.0.1", 5, "")
    with flash_folder(str(tmp_path), to, 6) as folder:
        settings = json.loads((tmp_path / "wifi.json").read_text())
        assert folder == str(tmp_path)
        assert settings == {"ssid": "sim", "password": "", "host": "127.0.0.1", "port": 5, "local_port": 6}
    assert (tmp_path / "wifi.json").read_text() == own
    assert os.listdir(tmp_path) == ["wifi.json"]


def test_they_come_back_after_a_run_that_could_not_end(tmp_path: Path) -> None:
    (tmp_path / "wifi.json").write_text("of the killed run")
    (tmp_path / "wifi.json.kept").write_text("own")
    with flash_folder(str(tmp_path), Address("127.0.0.1", 5, ""), 6):
        pass
    assert (tmp_path / "wifi.json").read_text() == "own"
    assert os.listdir(tmp_path) == ["wifi.json"]


def test_a_long_run_keeps_a_bounded_record() -> None:
    recording = Recording(OWN, program(OWN))
    for at_ms in range(0, 40_000_000, 500):
        recording.at_ms = at_ms
        recording.take_told(volts(12 + at_ms % 7))
    readings = recording.readings_of[VOLTAGE]
    assert 5_000 < len(readings) <= 20_000
    assert readings[-1].at_ms > 39_900_000
    spans = [after.at_ms - before.at_ms for before, after in pairwise(readings)]
    assert max(spans) <= 4 * Fraction(sum(spans), len(spans))


def test_counters_go_on_over_restarts() -> None:
    recording = Recording(OWN, program(OWN))
    for at_ms in (0, 1_000):
        recording.take({"kind": "start", "at": at_ms, "runtime": "x"})
        counts = {"HEARTBEAT": [3, 63]}
        totals = {"counts": counts, "parameters": {}, "dropped": 1, "received": 2, "crc_errors": 3, "gaps": 0}
        recording.take({"kind": "messages", "at": at_ms, **totals})
    traffic = recording.traffic
    assert (traffic.frames, traffic.sizes) == ({"HEARTBEAT": 6}, {"HEARTBEAT": 126})
    assert (traffic.dropped, traffic.received, traffic.crc_errors) == (2, 4, 6)
    assert [happening.kind for happening in recording.happenings] == []
    assert Kind("armed") is Kind.ARMED
