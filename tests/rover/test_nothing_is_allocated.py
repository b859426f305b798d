"""The whole way from a reading to the bytes on the wire allocates nothing, not even for a moment."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
from whole_program import whole_program

GENERATED = Path(__file__).resolve().parents[2] / "generated"

# heap_lock() does not notice the variables of large functions, which go elsewhere while the heap is locked: all that
# was ever allocated is counted instead. What runs while it counts makes no objects of its own, and the call of
# passes() itself, the same for any number of passes, is taken off.
SCRIPT = """
import mock_time
mock_time.install()
from micropython import mem_total
from mock_board import MockBoard
from state import SystemState
from streams import Streams, open_link
import telemetry
import time

class Sink:
    frames = 0
    def write(self, frame):
        self.frames += 1
        return len(frame)

VALUES = (None, 0, 1, -1, 100, 255, 32767, -32768, 65534, 65535, 131068, 655341, 1073741823, -1073741823)
sink = Sink()
link = open_link(sink)
state = SystemState(log=lambda *words: None)
board = MockBoard()
streams = Streams(state, link)
battery, vehicle = state.battery[0], state.vehicle

aside = 0

def build_and_send():
    global aside
    for value in VALUES:
        before = mem_total()
        set_all(value)  # what is beyond its limits is told, which takes memory: once
        aside += mem_total() - before
        set_all(value)
        vehicle.armed = not vehicle.armed
        link.send(telemetry.build_heartbeat(state))
        link.send(telemetry.build_sys_status(state))
        link.send(telemetry.build_battery_status(state))

def set_all(value):
    battery.voltage_mv = battery.current_ma = battery.consumed_mah = battery.energy_hj = value
    battery.remaining_pct = battery.temperature_cdegc = value
    vehicle.mode_number = vehicle.status = vehicle.load_dpct = value

def sample():
    for count in range(950, 3600, 5):  # texts of their own tell of a pack that is away, below, and of a high voltage
        board.set_adc_value(count)
        state.update_battery(board)

def stream():
    for _ in range(900):
        streams.run(time.ticks_ms())
        mock_time.advance_us(2500)

def repeat(function, number):
    for _ in range(number):
        function()

def counted(function):
    repeat(function, 1)
    start = mem_total()
    repeat(function, 0)
    middle = mem_total()
    told = aside
    repeat(function, 3)
    return (mem_total() - middle) - (middle - start) - (aside - told)

for function in (build_and_send, sample, stream):
    before = sink.frames
    failed = board.battery_inputs.figures(0)[0] + board.battery_inputs.figures(1)[0]
    print(counted(function), sink.frames - before, battery.voltage_mv or 0, failed)
"""


@pytest.fixture(scope="module", params=["viper", "plain"])
def counts(request, tmp_path_factory):
    """Return the output of the script, lists of numbers: with all modules in machine code, and in plain Python."""
    folder = tmp_path_factory.mktemp(request.param)
    whole_program(GENERATED, folder)
    for path in (folder / "firmware").glob("*_viper.py") if request.param == "plain" else ():
        path.unlink()
    (folder / "script.py").write_text(SCRIPT)
    path = os.pathsep.join([str(folder / "firmware"), str(folder / "mocks")])
    command = [str(Path(sys.executable).with_name("micropython")), str(folder / "script.py")]
    done = subprocess.run(command, capture_output=True, text=True, env={**os.environ, "MICROPYPATH": path}, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return [[int(word) for word in line.split()] for line in done.stdout.splitlines()]


def test_building_and_sending(counts):
    """Every builder with None, all limits and sentinels."""
    allocated, frames, *_ = counts[0]
    assert allocated == 0
    assert frames == 4 * 3 * 14


def test_sampling(counts):
    """Readings over the whole range of the ADC, none of which fails."""
    allocated, _, millivolts, failures = counts[1]
    assert allocated == 0
    assert millivolts > 11000
    assert failures == 0


def test_streams(counts):
    """A loop that runs at 400 Hz for some seconds."""
    allocated, frames, *_ = counts[2]
    assert allocated == 0
    assert frames > 30
