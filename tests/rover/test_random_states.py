"""Frames for thousands of random states equal pymavlink's, under CPython and under MicroPython.

What the fields must carry is worked out here by hand, from the requirement and the dialect's text, independently of the
generator; pymavlink encodes it.
"""

import json
import os
import random
import subprocess
import sys
from pathlib import Path

import pytest
from pymavlink.dialects.v10 import common as v10
from pymavlink.dialects.v20 import common as v20
from whole_program import module_folders

ROOT = Path(__file__).resolve().parents[2]
GENERATED = ROOT / "generated"
STATES = 3000

QUANTITIES = {
    "voltage_mv": (0, 65534, 65535, 131068, 655340, 655341),
    "current_ma": (-327690, -327680, -14, -5, -4, 4, 0, 327670, 327680),
    "consumed_mah": (-2, -1, 0, 2**30 - 1, -(2**30) + 1),
    "energy_hj": (-2, -1, 0, 2**30 - 1, -(2**30) + 1),
    "remaining_pct": (-2, -1, 0, 1, 99, 100, 101, 127, 128, 255),
    "temperature_cdegc": (-32769, -32768, -1, 0, 32766, 32767, 32768),
}

SCRIPT = """
import json, sys
import mock_time
mock_time.install()
from mavlink import Link
from state import SystemState
import telemetry

class Sink:
    def write(self, data):
        return len(data)

with open(sys.argv[1]) as file:
    states = json.loads(file.read())
links = [Link(Sink(), version=2), Link(Sink(), version=1)]
state = SystemState(log=lambda *words: None)
for values in states:
    for name, value in values["battery"].items():
        setattr(state.battery[0], name, value)
    for name, value in values["vehicle"].items():
        setattr(state.vehicle, name, value)
    built = (telemetry.build_heartbeat(state), telemetry.build_sys_status(state))
    frames = [bytes(link.encode(message)).hex() for message in built for link in links]
    message = telemetry.build_battery_status(state)
    frames += [bytes(link.encode(message)).hex() for link in links]
    print(" ".join(frames))
"""


def random_states() -> list[dict]:
    """States over the whole range of every quantity, with the interesting values often."""
    chance = random.Random(68)

    def value(edges):
        kind = chance.random()
        if kind < 0.15:
            return None
        if kind < 0.55:
            return chance.choice(edges)
        return chance.randint(-(2**30) + 1, 2**30 - 1) if kind < 0.65 else chance.randint(min(edges), max(edges))

    return [
        {
            "battery": {name: value(edges) for name, edges in QUANTITIES.items()},
            "vehicle": {
                "armed": chance.random() < 0.5,
                "ready": chance.random() < 0.5,
                "mode": chance.randint(0, 1000000),
                "status": chance.randint(0, 8),
                "load_dpct": chance.randint(-5, 1005),
            },
        }
        for _ in range(STATES)
    ]


def limited(value, low, high, sentinel):
    """By hand: unknown is the sentinel, everything else lies in the range and is not the sentinel."""
    if value is None:
        return sentinel
    value = min(max(value, low), high)
    if value != sentinel:
        return value
    return sentinel - 1 if sentinel < 0 else sentinel + 1


def cells(millivolts):
    """By hand: ten cells of at most 65534 mV."""
    if millivolts is None:
        return [65535] * 10
    rest, filled = min(max(millivolts, 0), 655340), []
    while rest > 65534:
        filled.append(65534)
        rest -= 65534
    filled.append(rest)
    return filled + [65535] * (10 - len(filled))


def faults(millivolts, temperature, milliamperes):
    """By hand: deep discharge from 1.0 to below 3.0 V a cell, 132 A or more, and from 60 and below -20 degC."""
    bits = 1 if millivolts is not None and 3 * 1000 <= millivolts < 3 * 3000 else 0
    bits |= 8 if milliamperes is not None and milliamperes >= 132000 else 0
    if temperature is not None:
        bits |= 16 if temperature >= 6000 else 32 if temperature < -2000 else 0
    return bits


def centiamperes(milliamperes):
    """The nearest, a half away from zero."""
    if milliamperes is None:
        return None
    return (abs(milliamperes) + 5) // 10 * (1 if milliamperes > 0 else -1)


def extensions(battery):
    """The time that is left, the state of charge, further cells, the mode and the faults."""
    current = battery["current_ma"]
    is_charging = current is not None and current < 0
    found = faults(battery["voltage_mv"], battery["temperature_cdegc"], current)
    return [0, 7 if is_charging else 0, [0] * 4, 0, found]


def expected_frames(state) -> list[str]:
    """The six frames of a state by pymavlink: three messages, each in MAVLink 2 and MAVLink 1."""
    battery, vehicle = state["battery"], state["vehicle"]
    voltage, sensor, prearm, fence = battery["voltage_mv"], 1 << 25, 1 << 28, 1 << 20
    current = limited(centiamperes(battery["current_ma"]), -32768, 32767, -1)
    remaining = -1 if battery["remaining_pct"] is None else min(max(battery["remaining_pct"], 0), 100)
    frames = []
    for dialect in (v20, v10):
        mode = 64 + 1 + (128 if vehicle["armed"] else 0)
        heartbeat = dialect.MAVLink_heartbeat_message(10, 3, mode, vehicle["mode"], vehicle["status"], 3)
        frames.append(heartbeat)
    for dialect in (v20, v10):
        frames.append(
            dialect.MAVLink_sys_status_message(
                sensor | prearm,
                sensor | prearm,
                (0 if voltage is None else sensor) | (prearm if vehicle["ready"] else 0) | fence,
                min(max(vehicle["load_dpct"], 0), 1000),
                65535 if voltage is None else min(max(voltage, 0), 65534),
                current,
                remaining,
                *[0] * 6,
            )
        )
    temperature = battery["temperature_cdegc"]
    for dialect in (v20, v10):
        frames.append(
            dialect.MAVLink_battery_status_message(
                0,
                1,
                1,
                32767 if temperature is None else min(max(temperature, -32768), 32766),
                cells(voltage),
                current,
                limited(battery["consumed_mah"], -(2**31), 2**31 - 1, -1),
                limited(battery["energy_hj"], -(2**31), 2**31 - 1, -1),
                remaining,
                *([] if dialect is v10 else extensions(battery)),
            )
        )
    senders = [v20.MAVLink(None, srcSystem=1, srcComponent=1), v10.MAVLink(None, srcSystem=1, srcComponent=1)]
    return [frame.pack(senders[index % 2]).hex() for index, frame in enumerate(frames)]


@pytest.mark.parametrize("interpreter", ["cpython", "micropython"])
def test_frames_equal_pymavlinks(interpreter, tmp_path):
    """Every frame of every state, byte for byte."""
    states = random_states()
    (tmp_path / "states.json").write_text(json.dumps(states))
    (tmp_path / "script.py").write_text(SCRIPT)
    micropython = [str(Path(sys.executable).with_name("micropython")), "-X", "heapsize=8m"]  # for all states at once
    program = [sys.executable] if interpreter == "cpython" else micropython
    path = os.pathsep.join(map(str, module_folders(GENERATED, "firmware", "mocks")))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": path}
    command = [*program, str(tmp_path / "script.py"), str(tmp_path / "states.json")]
    done = subprocess.run(command, capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == 0, done.stderr
    lines = done.stdout.split("\n")[:-1]
    assert len(lines) == STATES
    for state, line in zip(states, lines, strict=True):
        assert line.split(" ") == expected_frames(state), state
