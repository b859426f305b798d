"""The pin of a host has what classes of the user call of a board's: each runs there as it is, without a driver."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
MOCKS = ROOT / "templates" / "mocks"
PULSE = ROOT / "codegen" / "sources" / "pulse" / "mocks"
MICROPYTHON = Path(sys.executable).with_name("micropython")

KEPT = """
import mock_time
mock_time.install()
from machine import Pin

edges = []
pin = Pin(27, Pin.IN, Pin.PULL_UP)
assert pin.irq(edges.append, Pin.IRQ_FALLING) is pin
pin.handler(pin)
assert edges == [pin] and pin.trigger == Pin.IRQ_FALLING
"""
PULSES = """
import mock_time
mock_time.install()
import mock_pulse
from machine import Pin

rising, both = [], []
Pin(3).irq(rising.append, Pin.IRQ_RISING)
Pin(4).irq(both.append, Pin.IRQ_RISING | Pin.IRQ_FALLING)
mock_pulse.pulse(3, 10, 10, 2)
mock_pulse.pulse(4, 10, 10, 2)
assert (len(rising), len(both)) == (2, 4)
"""


@pytest.mark.parametrize("interpreter", [sys.executable, str(MICROPYTHON)], ids=["cpython", "micropython"])
@pytest.mark.parametrize("script", [KEPT, PULSES], ids=["kept", "pulses"])
def test_a_pin_takes_what_is_to_be_called_at_its_edges(interpreter: str, script: str) -> None:
    """Nothing comes in by itself; with the mock of pulses it does, at the edges that were asked for."""
    path = os.pathsep.join(map(str, (MOCKS, PULSE)))
    environment = {**os.environ, "PYTHONPATH": path, "MICROPYPATH": f"{path}:.frozen"}
    done = subprocess.run([interpreter, "-c", script], env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
