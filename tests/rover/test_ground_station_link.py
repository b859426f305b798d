"""The firmware under MicroPython and pymavlink's ground side talk over a real UDP link."""

import os
import subprocess
import sys
from pathlib import Path

from pymavlink import mavutil
from whole_program import module_folders

GENERATED = Path(__file__).resolve().parents[2] / "generated"

ROVER = """
import socket, sys
import mock_time
mock_time.install()
import time
from mock_board import MockBoard, scenario
from state import SystemState
from streams import Streams, open_link

class Datagrams:
    def __init__(self, port):
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.address = socket.getaddrinfo("127.0.0.1", port)[0][-1]

    def write(self, frame):
        return self.socket.sendto(frame, self.address)

board = MockBoard()
board.set_adc_waveform(scenario("falling", 100))
state = SystemState()
streams = Streams(state, open_link(Datagrams(int(sys.argv[1]))))
for step in range(4000):
    if step % 40 == 0:
        state.update_battery(board)
    streams.run(time.ticks_ms())
    mock_time.advance_us(2500)
"""


def test_ten_seconds_of_telemetry_arrive(tmp_path):
    """1 Hz HEARTBEAT and SYS_STATUS, 2 Hz BATTERY_STATUS, without a gap, with a falling voltage."""
    ground = mavutil.mavlink_connection("udpin:127.0.0.1:0", dialect="common")
    try:
        port = ground.port.getsockname()[1]
        (tmp_path / "rover.py").write_text(ROVER)
        path = os.pathsep.join(map(str, module_folders(GENERATED, "firmware", "mocks")))
        command = [str(Path(sys.executable).with_name("micropython")), str(tmp_path / "rover.py"), str(port)]
        subprocess.run(command, check=True, env={**os.environ, "MICROPYPATH": path}, timeout=60)
        received = []
        while (message := ground.recv_match(blocking=True, timeout=1)) is not None:
            received.append(message)
    finally:
        ground.close()
    counts = {name: sum(message.get_type() == name for message in received) for name in ("HEARTBEAT", "SYS_STATUS")}
    assert counts == {"HEARTBEAT": 10, "SYS_STATUS": 10}
    batteries = [message for message in received if message.get_type() == "BATTERY_STATUS"]
    assert len(batteries) == 20
    assert len(received) == 40
    assert ground.mav_loss == 0
    voltages = [message.voltages[0] for message in batteries]
    assert voltages == sorted(voltages, reverse=True)
    assert voltages[0] > voltages[-1] > 8000
    assert {message.current_battery for message in batteries} == {-1}
