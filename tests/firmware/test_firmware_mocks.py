"""The mocks of the board's modules behave as the board does, under both interpreters."""

import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest
from firmware_runs import interpret


def test_clock_moves_only_when_told(firmware: SimpleNamespace) -> None:
    """Virtual time: sleeping and advancing are the same, and nothing else passes."""
    clock = firmware.mock_time
    assert (clock.ticks_us(), clock.ticks_ms()) == (0, 0)
    clock.advance_us(1500)
    clock.sleep_us(500)
    clock.sleep_ms(3)
    clock.sleep(0.25)
    clock.sleep_ms(-1)
    assert (clock.ticks_us(), clock.ticks_ms(), clock.elapsed_us()) == (255000, 255, 255000)
    clock.set_ticks_us(42)
    assert clock.ticks_us() == 42
    for backwards in (lambda: clock.advance_us(-1), lambda: clock.set_ticks_us(-1)):
        with pytest.raises(ValueError, match=r"time|clock"):
            backwards()


def test_ticks_wrap_as_on_boards(firmware: SimpleNamespace) -> None:
    """Code that subtracts ticks instead of calling ticks_diff() fails here rather than after 12 days."""
    clock = firmware.mock_time
    clock.set_ticks_us(2**30 - 1)
    before = clock.ticks_us()
    clock.advance_us(3)
    assert clock.ticks_us() == 2
    assert clock.ticks_diff(clock.ticks_us(), before) == 3
    assert clock.ticks_diff(before, clock.ticks_us()) == -3
    assert clock.ticks_add(before, 3) == 2
    assert clock.ticks_add(2, -3) == before
    clock.set_ticks_us(2**30 * 1000 - 1)
    assert clock.ticks_ms() == 2**30 - 1
    clock.advance_us(1)
    assert clock.ticks_ms() == 0
    with pytest.raises(OverflowError):
        clock.ticks_add(0, 2**29)


def test_install_adds_to_the_time_of_cpython(firmware: SimpleNamespace, monkeypatch: pytest.MonkeyPatch) -> None:
    """The host's own names stay, the clock of an earlier import goes."""
    for name in ("ticks_ms", "ticks_us", "ticks_add", "ticks_diff", "sleep_ms", "sleep_us"):
        monkeypatch.setattr(time, name, None, raising=False)  # so that monkeypatch restores whatever there was
        monkeypatch.delattr(time, name)
    own = {name: getattr(time, name) for name in dir(time)}
    firmware.mock_time.install()
    firmware.mock_time.advance_us(7)
    assert time.ticks_us() == 7  # type: ignore[attr-defined]
    assert {name: getattr(time, name) for name in own} == own
    del sys.modules["mock_time"]
    import mock_time  # type: ignore[import-not-found]  # noqa: PLC0415 - a second copy

    mock_time.install()
    assert time.ticks_us() == 0  # type: ignore[attr-defined]


def test_install_replaces_the_time_of_micropython(tmp_path: Path) -> None:
    """Firmware that imports time afterwards sees the virtual clock, and an ADC reading takes virtual time."""
    script = tmp_path / "script.py"
    script.write_text(
        "import mock_time\nmock_time.install()\nimport time, machine\n"
        "adc = machine.ADC(machine.Pin(26))\nmachine.analog(26).source = [0, 2048, 4095]\n"
        "machine.analog(26).delay_us = 10\ntime.sleep_ms(2)\n"
        "print([adc.read_u16() for _ in range(4)], time.ticks_us(), time.time())\n",
        encoding="utf-8",
    )
    assert interpret("micropython", str(script)).strip() == "[0, 32776, 65535, 65535] 2040 0"


def test_adc_presents_12_bits_as_16(firmware: SimpleNamespace) -> None:
    """As the RP2 port does: >> 4 gives the count back, and full scale is 65535."""
    adc = firmware.machine.ADC(26)
    for count in (0, 1, 255, 256, 3000, 4095):
        firmware.machine.analog(26).source = count
        assert adc.read_u16() == (count << 4) | (count >> 8)
        assert adc.read_u16() >> 4 == count


def test_adc_is_named_by_pin_gpio_or_channel(firmware: SimpleNamespace) -> None:
    """All three reach the same input; a pin without an ADC is refused as on the board."""
    machine = firmware.machine
    machine.adc_pins = (26, 27, 28, 29)
    machine.analog(27).source = 9
    assert [machine.ADC(name).read_u16() >> 4 for name in (27, 1, machine.Pin(27))] == [9, 9, 9]
    for name in (25, 30, 4, -1, machine.Pin(1)):
        with pytest.raises(ValueError, match="has no ADC"):
            machine.ADC(name)


def test_source_is_number_list_or_function(firmware: SimpleNamespace) -> None:
    """A list plays once and stays at its end; a function follows the virtual time; a new source starts afresh."""
    machine, script = firmware.machine, firmware.machine.analog(26)
    adc = machine.ADC(26)

    def read(times: int) -> list[int]:
        return [adc.read_u16() >> 4 for _ in range(times)]

    script.source = counts = machine.ramp(1000, 1010, 3)
    assert read(5) == [1000, 1005, 1010, 1010, 1010]
    script.source = counts
    assert read(1) == [1000]
    script.source = lambda now: 100 + now // 10
    script.delay_us = 10
    assert read(3) == [101, 102, 103]
    assert machine.ramp(1010, 1000, 3) == [1010, 1005, 1000]
    script.source = 4096
    with pytest.raises(ValueError, match="12 bits"):
        adc.read_u16()


@pytest.mark.requirement("NFR-00062.3")
def test_faults_are_scripted(firmware: SimpleNamespace) -> None:
    """The next n readings fail, one reading in a list fails, the ADC is not there; a reset heals all of it."""
    machine, script = firmware.machine, firmware.machine.analog(26)
    adc = machine.ADC(26)
    script.source = [5, None, 6]
    script.failures = 2
    found: list[int | None] = []
    for _ in range(5):
        try:
            found.append(adc.read_u16() >> 4)
        except OSError:
            found.append(None)
    assert found == [None, None, 5, None, 6]
    assert script.reads == 5
    script.absent = True
    with pytest.raises(OSError, match="19"):
        machine.ADC(26)
    machine.reset_analog()
    assert machine.ADC(26).read_u16() == 0
    assert adc.read_u16() == 0
    assert script.reads == 2


def test_pin_keeps_its_level(firmware: SimpleNamespace) -> None:
    """The level that the firmware gives to an LED can be looked at."""
    pin = firmware.machine.Pin("LED", firmware.machine.Pin.OUT)
    levels = [pin.value()]
    for change in (pin.on, pin.toggle, pin.toggle, pin.off, lambda: pin.value(5)):
        change()
        levels.append(pin.value())
    assert levels == [0, 1, 0, 1, 0, 1]


def test_cpython_makes_no_machine_code(firmware: SimpleNamespace) -> None:
    """The mock leaves native functions alone, and knows nothing of viper: so that frames takes the plain form."""
    assert firmware.micropython.native(len) is len
    assert not hasattr(firmware.micropython, "viper")
    assert firmware.frames.encoder is firmware.frames_plain.encoder
