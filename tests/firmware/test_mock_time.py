"""The clock of the mocks: in machine code, in plain MicroPython and in CPython it is the same."""

import json

import pytest
from firmware_runs import interpret

SCRIPT = """
import json
import sys

if sys.stdin.read() == "plain":
    sys.modules["mock_ticks_viper"] = None

import mock_time

random = 1
found = [sys.implementation.name == "micropython" and mock_time.machine_code is not None]
rung = []
mock_time.set_ticks_us(0)
for number in range(3000):
    random = (random * 1103515245 + 12345) & 0x7FFFFFFF
    if number % 500 == 250:
        mock_time.set_ticks_us((1 << 30) * (number + 1) - 1000)
    if number % 100 == 50:
        mock_time.set_alarm(random & 0x3FFFFF, lambda left_us: rung.append([number, left_us]))
    if number % 1000 == 990:
        mock_time.set_alarm(0, None)
    before_us, before_ms = mock_time.ticks_us(), mock_time.ticks_ms()
    step = random >> (number % 29) if number % 7 else (random & 0x7FF)
    mock_time.advance_us(step)
    found.append([mock_time.elapsed_us(), mock_time.ticks_us(), mock_time.ticks_ms(), mock_time.alarm_left_us()])
    found.append([mock_time.ticks_diff(mock_time.ticks_us(), before_us), mock_time.ticks_diff(before_ms, random >> 1)])
    found.append([mock_time.ticks_add(before_us, (random >> 2) - 0x10000000)])
for delta in (1 << 29, -(1 << 29) - 1, 1 << 40):
    try:
        mock_time.ticks_add(5, delta)
    except OverflowError:
        found.append("overflow")
try:
    mock_time.advance_us(-1)
except ValueError:
    found.append("backwards")
followed = []
mock_time.follow(followed.append)
mock_time.advance_us(7)
print(json.dumps([found, rung, followed]))
"""


@pytest.fixture(scope="module")
def script(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The path of the script above."""
    path = tmp_path_factory.mktemp("clock") / "clock.py"
    path.write_text(SCRIPT)
    return str(path)


def test_the_clock_is_the_same_everywhere(script: str) -> None:
    """Ticks and their sums and differences, over wraps and leaps, alarms that ring, and what it refuses."""
    python, rung, followed = json.loads(interpret("cpython", script))
    assert len(rung) > 3
    assert python[-4:] == ["overflow", "overflow", "overflow", "backwards"]
    assert followed == [7]
    plain = json.loads(interpret("micropython", script, "plain"))
    assert plain == [python, rung, followed]
    fast = json.loads(interpret("micropython", script))
    assert fast[0][0] is True
    assert [fast[0][1:], *fast[1:]] == [python[1:], rung, followed]
