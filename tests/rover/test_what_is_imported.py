"""The rover's program does without the modules that are for people, tests and other projects: they take heap."""

import os
import subprocess
import sys
from pathlib import Path

from pymavlink.dialects.v20 import common
from whole_program import module_folders

GENERATED = Path(__file__).resolve().parents[2] / "generated"
ANSWERED = (
    common.MAVLink_heartbeat_message(common.MAV_TYPE_GCS, common.MAV_AUTOPILOT_INVALID, 0, 0, 4, 3),
    common.MAVLink_ping_message(5, 1, 0, 0),
    common.MAVLink_param_request_list_message(1, 1),
    common.MAVLink_param_request_read_message(1, 1, b"BATT_LOW_VOLT", -1),
    common.MAVLink_param_request_read_message(1, 1, b"NONE", -1),
    common.MAVLink_param_set_message(1, 1, b"BATT_LOW_VOLT", 10.8, common.MAV_PARAM_TYPE_REAL32),
    common.MAVLink_param_set_message(1, 1, b"BATT_LOW_VOLT", -1.0, common.MAV_PARAM_TYPE_REAL32),
    common.MAVLink_command_long_message(1, 1, common.MAV_CMD_GET_MESSAGE_INTERVAL, 0, 147, 0, 0, 0, 0, 0, 0),
    common.MAVLink_command_int_message(1, 1, 0, common.MAV_CMD_COMPONENT_ARM_DISARM, 0, 0, 1, 0, 0, 0, 0, 0, 0),
    common.MAVLink_request_data_stream_message(1, 1, common.MAV_DATA_STREAM_ALL, 2, 1),
    common.MAVLink_file_transfer_protocol_message(0, 1, 1, [0] * 251),
)
SCRIPT = """
import sys
import mock_time
mock_time.install()
import main
vehicle = main.vehicle_class()()
class Port:
    is_up, name, sent, arrived = True, "port", 0, [bytes.fromhex(line) for line in sys.stdin]
    def write(self, frame):
        self.sent += 1
        return len(frame)
    def readinto(self, buffer):
        data = self.arrived.pop(0) if self.arrived else b""
        buffer[: len(data)] = data
        return len(data)
    def poll(self, now_ms):
        pass
port = Port()
vehicle.connections.append(vehicle._connect(port))
for _ in range(300):
    vehicle.run_pass()
    mock_time.advance_us(10000)
assert not port.arrived and port.sent > 40 and not vehicle.connections[-1].faults
print(" ".join(sys.modules))
"""


def test_names_of_fields_are_not_read() -> None:
    """Not by the vehicle that has started, reported and answered: services and telemetry know the places of fields."""
    link = common.MAVLink(None, srcSystem=255, srcComponent=190)
    path = os.pathsep.join(map(str, module_folders(GENERATED, "firmware", "mocks")))
    done = subprocess.run(
        [sys.executable, "-B", "-c", SCRIPT],
        input="\n".join(message.pack(link).hex() for message in ANSWERED),
        capture_output=True,
        text=True,
        env={"PYTHONPATH": path},
        check=False,
    )
    assert done.returncode == 0, done.stderr
    loaded = set(done.stdout.splitlines()[-1].split())
    assert "messages" in loaded
    assert not loaded & {"fields", "message_fields", "live_fields", "nearest", "dialect", "serial_port"}
