"""Several batteries and several programs in one simulation: pace, restarts, swaps, counts, parameters."""

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from in_process import build, codegen
from packs import FULL, SECOND, VOLTAGE, program, steady, volts
from pymavlink.dialects.v20 import common

from codegen.model.scenario import Beside, Fault, Scenario, Swap
from codegen.sim.address import Address
from codegen.sim.chart import WIDE, concerns, draw_chart
from codegen.sim.process import FirmwareProcess, Runtime, find_interpreter
from codegen.sim.program import unique_id
from codegen.sim.record import Recording
from codegen.sim.run import TURN_MS, Simulation, simulate
from codegen.sim.sample import Happening, Kind
from codegen.sim.verdict import verdict

PROJECTS = Path(__file__).resolve().parents[1] / "projects"
RUNTIMES = pytest.mark.parametrize("runtime", list(Runtime))


def scenario(*events: Any, duration_ms: int = 5_000, **rest: Any) -> Scenario:
    """A vehicle with 12 V and a smart battery with 11 V."""
    beside = (Beside("smart", (steady(11.0),)),)
    return Scenario("own", "d", duration_ms, 1, (steady(12.0),), events, **{"beside": beside, **rest})


def simulation(project: Path, station: Any, played: Scenario, runtime: Runtime, **rest: Any) -> Simulation:
    """Two times the same stand-in, with one rover.py each."""
    folder = str(project / "generated")
    programs = []
    for name, key in (("rover", None), ("smart", "smart")):
        own = project / f"{name}.py"
        parameters = next((b.parameters for b in played.beside if b.program == key), played.parameters)
        code = str(own) if own.exists() else None
        programs.append(program(played, folder, key, name=name, parameters=parameters, code=code))
    interpreter = find_interpreter(runtime)
    assert interpreter is not None
    port = station.socket.getsockname()[1]
    values: dict[str, Any] = {"duration_ms": played.duration_ms, "speed": 0.0, "flash": None, **rest}
    return Simulation(
        scenario=played,
        runtime=runtime,
        interpreter=interpreter,
        to=Address("127.0.0.1", port, ""),
        programs=tuple(programs),
        **values,
    )


@pytest.fixture
def play(project: Path, station: Any) -> Callable[..., Recording]:
    """Plays a scenario with both programs and returns what was recorded."""

    def played(own: Scenario, runtime: Runtime = Runtime.MICROPYTHON, **rest: Any) -> Recording:
        run = simulation(project, station, own, runtime, **rest)
        recording = run.recording()
        simulate(run, recording, lambda *_: None)
        return recording

    return played


def heard(station: Any) -> dict[int, list[Any]]:
    """The messages by the port that they came from."""
    found: dict[int, list[Any]] = {}
    parsers: dict[int, Any] = {}
    for data, port in station.received():
        parser = parsers.setdefault(port, common.MAVLink(None))
        found.setdefault(port, []).extend(parser.parse_buffer(data) or [])
    return found


@RUNTIMES
def test_each_program_has_its_own_battery_socket_and_counts(play: Any, station: Any, runtime: Runtime) -> None:
    recording = play(scenario(), runtime)
    assert [record.problem for record in recording.all] == [None, None]
    by_port = heard(station)
    assert len(by_port) == 2
    voltages = [
        {message.voltages[0] for message in messages if message.get_type() == "BATTERY_STATUS"}
        for messages in by_port.values()
    ]
    assert sorted(round(min(each) / 1000) for each in voltages) == [11, 12]
    counted = sorted(sum(record.traffic.frames.values()) for record in recording.all)
    assert counted == sorted(len(messages) for messages in by_port.values())
    sizes = sorted(sum(record.traffic.sizes.values()) for record in recording.all)
    assert sizes == sorted(sum(len(m.get_msgbuf()) for m in messages) for messages in by_port.values())
    assert all(record.at_ms >= 5_000 for record in recording.all)


@RUNTIMES
def test_no_program_is_ever_a_tenth_of_a_second_ahead(
    play: Any, monkeypatch: pytest.MonkeyPatch, project: Path, runtime: Runtime
) -> None:
    """Though one of them is slow and nothing holds back the other: as it is at --speed max."""
    (project / "smart.py").write_text(
        "import main\n"
        "class Rover(main.Vehicle):\n"
        "    def control(self):\n"
        "        total = 0\n"
        "        for number in range(2000):\n"
        "            total += number\n"
    )
    times: dict[int, int] = {}
    apart: list[int] = []
    take = Recording.take

    def watched(recording: Recording, record: Any) -> Any:
        times[id(recording)] = record["at"]
        if record["kind"] in ("sample", "turn") and len(times) == 2:
            apart.append(abs(max(times.values()) - min(times.values())))
        return take(recording, record)

    monkeypatch.setattr(Recording, "take", watched)
    play(scenario(duration_ms=3_000), runtime)
    assert len(apart) > 50
    # A record is read a turn late at most, in which its program has not gone on.
    assert max(apart) <= 2 * TURN_MS


def test_a_turn_ends_where_it_has_to(project: Path, tmp_path: Path) -> None:
    """A program that gets no turn stays within the first one, and ends when it is told that there will be none."""
    played = scenario()
    played_program = program(played, str(project / "generated"))
    flash = tmp_path / "flash"
    flash.mkdir()
    (flash / "wifi.json").write_text(json.dumps({"host": "127.0.0.1", "port": 9, "local_port": 0}))
    settings = tmp_path / "s.json"
    values = {"start_ms": 0, "duration_ms": 5_000, "until_ms": 70, "speed": 0}
    settings.write_text(json.dumps(played_program.settings(played.stretches()[0], is_first_start=True) | values))
    interpreter = find_interpreter(Runtime.MICROPYTHON)
    assert interpreter is not None
    process = FirmwareProcess(
        Runtime.MICROPYTHON, interpreter, played_program.paths, str(flash),
        played_program.script, str(settings), takes_turns=True,
    )  # fmt: skip
    try:
        ends = []
        for until_ms in (170, 300):
            records = wait_for_turn(process)
            ends.append(records[-1]["at"])
            process.give_turn(until_ms)
        ends.append(wait_for_turn(process)[-1]["at"])
        rest = process.interrupt()
        assert all(at <= until < at + 20 for at, until in zip(ends, (70, 170, 300), strict=True)), ends
        assert [record["reason"] for record in rest if isinstance(record, dict) and record["kind"] == "end"] == [
            "stopped"
        ]
    finally:
        process.close()


def wait_for_turn(process: FirmwareProcess) -> list[Any]:
    records: list[Any] = []
    deadline = time.monotonic() + 30
    while not (records and records[-1]["kind"] == "turn"):
        assert time.monotonic() < deadline
        records += [item for item in process.read(0.2) if isinstance(item, dict)]
    return records


@RUNTIMES
def test_a_restart_of_one_does_not_disturb_the_other(play: Any, station: Any, project: Path, runtime: Runtime) -> None:
    (project / "smart.py").write_text(
        "import main, machine, time, os\n"
        "class Rover(main.Vehicle):\n"
        "    def control(self):\n"
        "        if time.ticks_ms() >= 2000 and 'been.txt' not in os.listdir():\n"
        "            open('been.txt', 'w').close()\n"
        "            machine.reset()\n"
    )
    recording = play(scenario(), runtime)
    main, smart = recording.all
    assert (main.restarts, smart.restarts) == (0, 1)
    assert main.traffic.gaps == 0
    assert "The board of smart restarted once." in verdict(recording)
    battery_times = [reading.at_ms for reading in main.readings_of[VOLTAGE]]
    assert max(after - before for before, after in pairwise(battery_times)) <= 520
    assert len(heard(station)) == 2, "it comes back at its port"


def test_a_failure_of_one_ends_all_and_is_told_with_its_name(play: Any, project: Path) -> None:
    (project / "smart.py").write_text(
        "import main, time\nclass Rover(main.Vehicle):\n    def control(self):\n"
        "        if time.ticks_ms() > 1000:\n            raise ValueError('cells')\n"
    )
    recording = play(scenario())
    main, smart = recording.all
    assert smart.problem is not None
    assert "ValueError: cells" in smart.problem
    assert main.problem is None
    assert main.at_ms < 1_000 + 2 * TURN_MS
    assert verdict(recording)[0].startswith("It failed at 1.0 s: smart: the firmware stopped")
    assert main.traffic.frames["HEARTBEAT"] >= 1, "what the other one had sent is counted"


@RUNTIMES
def test_a_swap_brings_another_board(play: Any, station: Any, project: Path, runtime: Runtime) -> None:
    """Off for the time, another unique id, a flash of its own, the new voltage; the vehicle goes on meanwhile."""
    (project / "smart.py").write_text(
        "import binascii, machine, main, os\n"
        "class Rover(main.Vehicle):\n"
        "    def __init__(self):\n"
        "        main.Vehicle.__init__(self)\n"
        "        print(binascii.hexlify(machine.unique_id()).decode(), 'been.txt' in os.listdir())\n"
        "        open('been.txt', 'w').close()\n"
    )
    swap = Swap(2_000, "smart", 3_000, (steady(10.0),))
    recording = play(scenario(swap, duration_ms=6_000), runtime)
    main, smart = recording.all
    assert smart.problem is None
    ids = [happening.text for happening in recording.happenings if happening.kind is Kind.CONSOLE]
    assert ids == [f"{unique_id('smart', 1)} False", f"{unique_id('smart', 2)} False"]
    assert unique_id("smart", 1) != unique_id("smart", 2) != unique_id("", 1)
    swaps = [(happening.at_ms, happening.program) for happening in recording.happenings if happening.kind is Kind.SWAP]
    assert swaps == [(2_000, "smart"), (3_000, "smart")]
    known = [reading for reading in smart.readings_of[VOLTAGE] if reading.value is not None]
    assert not [reading for reading in known if 2_000 < reading.at_ms < 3_000]
    assert {round(reading.value or 0) for reading in known if reading.at_ms < 2_000} == {11}
    assert {round(reading.value or 0) for reading in known if reading.at_ms > 3_000} == {10}
    assert main.restarts == smart.restarts == 0
    assert len([reading for reading in main.readings_of[VOLTAGE] if 2_000 <= reading.at_ms <= 3_000]) >= 2
    assert "The board of smart was swapped once." in verdict(recording)
    assert len(heard(station)) == 3, "the new board has a port of its own"
    chart = draw_chart(smart, recording.happenings, WIDE, "wide", smart.lines[0])
    assert chart.true.count("M") == chart.reported.count("M") == 2, "both lines break"
    assert [band.label for band in chart.bands] == ["no board"]
    assert len(chart.markers) == 2


def test_a_kept_flash_has_a_folder_for_each_board(play: Any, project: Path) -> None:
    (project / "smart.py").write_text("import main\nopen('mine.txt', 'w').close()\nRover = main.Vehicle\n")
    play(scenario(Swap(1_000, "smart", 1_500), duration_ms=2_000), flash=str(project / "flash"))
    assert sorted(os.listdir(project / "flash")) == ["smart", "smart.2"]
    assert os.listdir(project / "flash" / "smart") == ["mine.txt"]
    assert os.listdir(project / "flash" / "smart.2") == ["mine.txt"]


@RUNTIMES
def test_parameters_are_stored_before_the_first_start_only(play: Any, project: Path, runtime: Runtime) -> None:
    """The program finds them in its storage, and what it stores itself is not put back by a restart."""
    (project / "rover.py").write_text(
        "import main, machine, time\n"
        "from parameters import Parameters\n"
        "from storage import Storage\n"
        "class Rover(main.Vehicle):\n"
        "    def __init__(self):\n"
        "        main.Vehicle.__init__(self)\n"
        "        self.storage = Storage(('parameters.0', 'parameters.1'), 64)\n"
        "        stored = Parameters()\n"
        "        stored.restore(self.storage.load() or b'')\n"
        "        self.first = stored.get('BATT_LOW_VOLT') == 11.25\n"
        "        print(stored.get('BATT_LOW_VOLT'), stored.get('BATT_CAPACITY'))\n"
        "        stored.set('BATT_LOW_VOLT', 9.5)\n"
        "        self.storage.begin(stored.dump())\n"
        "        while self.storage.step():\n"
        "            pass\n"
        "    def control(self):\n"
        "        if self.first and time.ticks_ms() > 500:\n"
        "            machine.reset()\n"
    )
    own = scenario(duration_ms=2_000, parameters={"BATT_LOW_VOLT": 11.25, "BATT_CAPACITY": 5000.0})
    recording = play(own, runtime)
    said = [happening.text for happening in recording.happenings if happening.kind is Kind.CONSOLE]
    assert [[float(word) for word in line.split()] for line in said] == [[11.25, 5000], [9.5, 5000]]


def test_faults_of_one_input_leave_the_other_alone(project: Path, station: Any) -> None:
    """Two batteries on two pins; the stand-in measures the first, and its board has a second input."""
    (project / "rover.py").write_text(
        "import machine, main, time\n"
        "class Rover(main.Vehicle):\n"
        "    def __init__(self):\n"
        "        main.Vehicle.__init__(self)\n"
        "        self.second = machine.ADC(machine.Pin(27))\n"
        "        self.seen = set()\n"
        "    def control(self):\n"
        "        try:\n"
        "            count = self.second.read_u16() >> 4\n"
        "        except OSError:\n"
        "            count = -1\n"
        "        if count not in self.seen:\n"
        "            self.seen.add(count)\n"
        "            print('second', count)\n"
    )
    fault = Fault(1_000, "fail", SECOND, 3_000, "ADC readings fail")
    played = Scenario("own", "d", 4_000, 1, (steady(12.0), steady(6.0, label=SECOND, gpio=27)), (fault,))
    run = simulation(project, station, Scenario("x", "d", 1, 1, (steady(0.001),)), Runtime.MICROPYTHON)
    both = program(played, str(project / "generated"), code=str(project / "rover.py"))
    run = Simulation(played, 4_000, 0.0, run.runtime, run.interpreter, run.to, None, (both,))
    recording = run.recording()
    simulate(run, recording, lambda *_: None)
    assert recording.problem is None
    said = [happening.text.split()[1] for happening in recording.happenings if happening.kind is Kind.CONSOLE]
    assert said == [str(round(6 / FULL * 4095)), "-1"]
    assert all(reading.value for reading in recording.readings_of[VOLTAGE] if reading.at_ms > 1_000), (
        "the first goes on"
    )
    assert [happening.text for happening in recording.happenings if happening.kind is Kind.FAULT] == [
        "battery[1].voltage: ADC readings fail for 2 s"
    ]
    assert [recording.true(label, 4_000) for label in (VOLTAGE, SECOND)] == [12.0, 6.0]


def test_a_failsafe_is_told_and_marked_with_its_battery() -> None:
    """The level of the failsafe tells it, and no text."""
    played = Scenario("own", "d", 10_000, 1, (steady(12.0), steady(7.0, label=SECOND)))
    recording = Recording(played, program(played))
    recording.at_ms = 500
    recording.take_told(volts(7.1, 1))
    counts = {"counts": {}, "dropped": 0, "received": 0, "crc_errors": 0, "gaps": 0}
    levels = {"BATT_LOW_VOLT": 10.5, "BATT2_LOW_VOLT": 7.0}
    recording.take({"kind": "messages", "at": 10_000, "parameters": levels, **counts})
    text = recording.take({"kind": "text", "at": 10_000, "severity": 4, "text": "Battery 1 is low 6.95V used 0 mAh"})
    assert text is not None
    assert text.kind is Kind.TEXT
    assert "The failsafe did not fire." in verdict(recording)
    fired = {"name": "battery_failsafes", "index": 1, "title": "Akku 2", "level": 1}
    happening = recording.take({"kind": "failsafe", "at": 10_000, **fired})
    assert isinstance(happening, Happening)
    assert (happening.kind, happening.of, happening.word) == (Kind.FAILSAFE, SECOND, "low")
    assert [concerns(happening, recording, label) for label in (VOLTAGE, SECOND)] == [False, True]
    sentences = verdict(recording)
    assert "The failsafe fired: Akku 2 low at 10.0 s." in sentences
    assert "battery[1].voltage was told at most 0.10 V from what was true, at 0.5 s." in sentences
    assert "battery.voltage was never told." in sentences
    assert [line.label for line in recording.lines] == [VOLTAGE, SECOND]
    charts = [draw_chart(recording, [happening], WIDE, "wide", line) for line in recording.lines]
    assert [[level.label for level in chart.levels] for chart in charts] == [
        ["BATT_LOW_VOLT 10.5 V"],
        ["BATT2_LOW_VOLT 7 V"],
    ]
    assert [len(chart.markers) for chart in charts] == [0, 1]


OWN = """
scenarios:
  own:
    doc: d
    duration: 20 s
    courses: {battery.voltage: {value: 12 V}, battery.current: {points: [[0 s, 1 A], [20 s, 3 A]]}}
    with: {smart_battery: {courses: {battery.voltage: {value: 11 V}}, parameters: {BATT_CAPACITY: 4000}}}
    events: [{at: 5 s, swap: smart_battery, for: 2 s, courses: {battery.voltage: {value: 10 V}}}]
"""


def with_smart_battery(project: Path) -> None:
    """The stand-in is the firmware of the smart battery as well."""
    (project / "own.yaml").write_text(OWN)
    (project / "generated" / "smart_battery").mkdir()
    for part in ("firmware", "mocks"):
        (project / "generated" / "smart_battery" / part).symlink_to(project / "generated" / part)


def test_the_command_names_the_programs(project: Path, run: Any) -> None:
    with_smart_battery(project)
    code, out, err = run("own.yaml", "--report", "r.html")
    assert code == 0, err
    assert "pico-trail, smart_battery run" in err
    assert re.search(r"^    5\.0 s  smart_battery  swap      The board was taken out$", out, re.M)
    assert re.search(r"^    7\.0 s  smart_battery  swap      Another board was put in$", out, re.M)
    assert re.search(r"^  \d+ frames of pico-trail, \d+ bytes went out, [\d.]+ bytes/s$", out, re.M)
    assert re.search(r"^  \d+ frames of smart_battery, ", out, re.M)
    page = (project / "r.html").read_text()
    for title in ("battery.voltage of pico-trail", "battery.current of pico-trail",
                  "battery.voltage of smart_battery", "Link and loop of smart_battery"):  # fmt: skip
        assert title in page
    assert "goes from 1.0 A to 3.0 A" in page


def test_the_result_is_the_same_with_each_run(project: Path, run: Any) -> None:
    """At full speed the programs still meet at the same times."""
    with_smart_battery(project)
    first, again = (run("own.yaml", "--quiet") for _ in range(2))
    assert first[:2] == again[:2]


def test_a_program_that_was_not_built_is_told(project: Path, run: Any) -> None:
    (project / "own.yaml").write_text(OWN)
    code, out, err = run("own.yaml")
    assert (code, out) == (2, "")
    assert err == "codegen sim: there is no firmware in generated/smart_battery: run codegen build first\n"


@RUNTIMES
def test_ctrl_c_ends_all_of_them(project: Path, station: Any, runtime: str) -> None:
    with_smart_battery(project)
    command = [sys.executable, "-m", "codegen", "sim", "own.yaml", "--duration", "forever", "--out", station.address]
    running = subprocess.Popen(
        [*command, "--runtime", runtime], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )
    station.socket.settimeout(30)
    senders = set()
    while len(senders) < 2:
        senders.add(station.socket.recvfrom(2048)[1])
    children = Path(f"/proc/{running.pid}/task/{running.pid}/children").read_text().split()
    assert len(children) == 2
    running.send_signal(signal.SIGINT)
    out, err = running.communicate(timeout=30)
    assert running.returncode == 0, err
    assert "It was interrupted at" in out
    assert "Traceback" not in out + err
    assert not [child for child in children if Path(f"/proc/{child}").exists()]


def test_a_cable_says_nothing_of_wi_fi(tmp_path: Path) -> None:
    """A UART is simulated over UDP, whose port tells of its network: the vehicle has none."""
    shutil.copytree(PROJECTS / "radio_rover" / "specs", tmp_path / "specs")
    build(tmp_path)
    done = codegen(tmp_path, "sim", "--list")
    name = done.stdout.split()[0]
    done = codegen(tmp_path, "sim", name, "--duration", "3 s", "--speed", "max", "--out", "udp:127.0.0.1:9")
    assert "frames" in done.stdout, done.stdout + done.stderr
    assert "Wi-Fi" not in done.stdout + done.stderr
