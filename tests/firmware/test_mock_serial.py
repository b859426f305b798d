"""The mocks of UART, reset and Wi-Fi do what their scripts say."""

import importlib
import sys
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import pytest


@pytest.fixture
def network(firmware: SimpleNamespace) -> Iterator[Any]:
    """The mock, on the clock of `firmware`."""
    assert firmware.mock_time is sys.modules["mock_time"]
    sys.modules.pop("network", None)
    yield importlib.import_module("network")
    del sys.modules["network"]


def test_uart_gives_and_takes_in_parts(firmware: SimpleNamespace) -> None:
    """As a UART with timeout 0: None stands for nothing, a full buffer takes nothing, errors are those of the board."""
    machine = firmware.machine
    uart, line = machine.UART(1, 9600, tx=machine.Pin(4), rx=machine.Pin(5), timeout=0), machine.serial(1)
    assert (line.settings["baudrate"], line.settings["tx"].id) == (9600, 4)
    assert (uart.any(), uart.read(), uart.readinto(bytearray(4))) == (0, None, None)
    line.arrives(b"abc")
    line.arrives(b"def")
    assert (uart.any(), uart.read(2), uart.read(), uart.any()) == (6, b"ab", b"cdef", 0)
    line.parts = [2, 0, 9]
    assert [uart.write(b"12345"), uart.write(b"345"), uart.write(b"345")] == [2, None, 3]
    line.room = 4
    assert [uart.write(b"67"), uart.write(b"890"), uart.write(b"0")] == [2, 2, None]
    assert line.sent == b"123456789"
    line.failures = 2
    for fails in (uart.read, lambda: uart.write(b"x")):
        with pytest.raises(OSError, match="5"):
            fails()
    machine.reset_serial()
    assert (uart.write(b"x"), line.sent, uart.any()) == (1, b"x", 0)


def test_uart_may_be_absent(firmware: SimpleNamespace) -> None:
    """One that is not there is an OSError, as for an ADC. Which numbers a board has, the specification knows."""
    machine = firmware.machine
    machine.serial(0).absent = True
    with pytest.raises(OSError, match="19"):
        machine.UART(0)
    assert machine.UART(2).any() == 0


def test_reset_is_no_exception_that_firmware_catches(firmware: SimpleNamespace) -> None:
    """`except Exception` does not hold a reset up, and a program that does not expect it ends."""
    with pytest.raises(firmware.machine.Reset) as raised:
        firmware.machine.reset()
    assert isinstance(raised.value, SystemExit)
    assert len(firmware.machine.unique_id()) == 8


def test_wifi_connects_after_a_while(firmware: SimpleNamespace, network: Any) -> None:
    """On the virtual clock, until it drops; connecting is counted."""
    wlan, radio, clock = network.WLAN(network.STA_IF), network.radio, firmware.mock_time
    with pytest.raises(OSError, match="19"):
        wlan.connect("field", "key")
    wlan.active(True)
    assert wlan.active()
    radio.connect_after_ms = 300
    wlan.connect("field", "key")
    assert (wlan.isconnected(), wlan.status(), radio.credentials) == (False, network.STAT_CONNECTING, ("field", "key"))
    clock.advance_us(299_999)
    assert not wlan.isconnected()
    clock.advance_us(1)
    assert (wlan.isconnected(), wlan.status()) == (True, network.STAT_GOT_IP)
    radio.drop()
    assert (wlan.isconnected(), wlan.status(), radio.connects) == (False, network.STAT_IDLE, 1)
    radio.connect_after_ms, radio.failures = None, 1
    with pytest.raises(OSError, match="19"):
        wlan.connect("field")
    wlan.connect("field")
    clock.advance_us(10**9)
    assert (wlan.isconnected(), radio.connects) == (False, 3)
    radio.absent = True
    with pytest.raises(OSError, match="19"):
        network.WLAN()
