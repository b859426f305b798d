"""The mock of an I2C bus has the devices that drivers of one's own talk to: registers of 8 bits, and none at all."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = [ROOT / "codegen" / "sources" / "i2c" / "mocks", ROOT / "templates" / "mocks"]
MICROPYTHON = Path(sys.executable).with_name("micropython")

SCRIPT = """
import mock_time
mock_time.install()
import json, machine, mock_i2c

bus = machine.I2C(0)
found = {}

def failed(call, *arguments):
    try:
        call(*arguments)
    except OSError:
        return True
    return False

barometer = mock_i2c.attach(0, 0x76, mock_i2c.Bytes({0xD0: 0x58, 0x88: bytes(range(24)), 0xF4: 0}, read_only=(0xD0,)))
found["id"] = list(bus.readfrom_mem(0x76, 0xD0, 1))
found["row"] = list(bus.readfrom_mem(0x76, 0x88, 25))
bus.writeto_mem(0x76, 0xF4, b"\\x27")
bus.writeto_mem(0x76, 0xD0, b"\\x11\\x22")
found["set"] = [barometer.registers[each] for each in (0xF4, 0xD0, 0xD1)]
found["taken"] = bus.writeto(0x76, b"\\x89")
found["goes on"] = [list(bus.readfrom(0x76, 2)), list(bus.readfrom(0x76, 1))]
bus.writeto(0x76, b"\\xF4\\x2F")
buffer = bytearray(1)
bus.writeto(0x76, b"\\xF4")
bus.readfrom_into(0x76, buffer)
found["written"] = buffer[0]

light = mock_i2c.attach(0, 0x23, mock_i2c.Commands({b"\\x10": b"\\x12\\x34", b"\\x24\\x00": b"\\x66\\x67"}))
found["nothing yet"] = failed(bus.readfrom, 0x23, 2)
bus.writeto(0x23, b"\\x10")
found["light"] = list(bus.readfrom(0x23, 3))
bus.writeto(0x23, b"\\x24\\x00")
found["of two"] = list(bus.readfrom(0x23, 2))
bus.writeto(0x23, b"\\x99")
found["unknown"] = failed(bus.readfrom, 0x23, 2)
found["commands"] = [list(each) for each in light.written]
light.absent = True
found["gone"] = failed(bus.writeto, 0x23, b"\\x10")
found["scan"] = bus.scan()

wide = mock_i2c.attach(1, 0x40, mock_i2c.Device({0: 0x4127, 1: 0x8001}))
other = machine.I2C(1)
other.writeto(0x40, b"\\x01")
found["wide"] = list(other.readfrom(0x40, 2))
other.writeto(0x40, b"\\x00\\x12\\x34")
found["wide set"] = wide.registers[0]
found["half"] = failed(other.writeto_mem, 0x40, 0, b"\\x12")
found["one byte"] = list(other.readfrom_mem(0x40, 1, 1))
print(json.dumps(found))
"""

EXPECTED = {
    "id": [0x58],
    "row": [*range(24), 0xFF],
    "set": [0x27, 0x58, 0x22],
    "taken": 1,
    "goes on": [[1, 2], [3]],
    "written": 0x2F,
    "nothing yet": True,
    "light": [0x12, 0x34, 0xFF],
    "of two": [0x66, 0x67],
    "unknown": True,
    "commands": [[0x10], [0x24, 0], [0x99]],
    "gone": True,
    "scan": [0x76],
    "wide": [0x80, 0x01],
    "wide set": 0x1234,
    "half": True,
    "one byte": [0x80],
}


@pytest.mark.parametrize("interpreter", [sys.executable, str(MICROPYTHON)], ids=["cpython", "micropython"])
def test_devices_answer_as_they_are(interpreter: str, tmp_path: Path) -> None:
    """Each kind of device is read and written with and without the number of a register, on both interpreters."""
    script = tmp_path / "devices.py"
    script.write_text(SCRIPT)
    path = os.pathsep.join(map(str, FOLDERS))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": f"{path}:.frozen"}
    done = subprocess.run([interpreter, script], capture_output=True, text=True, env=environment, check=False)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == EXPECTED
