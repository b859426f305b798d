# Generated from templates/mocks/mock_ticks_viper.py: do not edit.
# Inputs: 006fc7cdfe046ef9
"""The clock of mock_time by MicroPython's viper emitter: a simulation asks and moves it many times in each pass.

The words are those of mock_time. Where there is no machine code this cannot be imported, and mock_time does it itself.
"""

# ptr32 is viper's own name.
# ruff: noqa: F821

import micropython

words = slowly = followers = None  # of mock_time, which puts them here
start_ms = 0  # what loop_ms() begins with


@micropython.viper
def ticks_us() -> int:
    """Return microseconds, 0 to 2**30 - 1."""
    return ptr32(words)[0]


@micropython.viper
def ticks_ms() -> int:
    """Return milliseconds, 0 to 2**30 - 1."""
    return ptr32(words)[1]


@micropython.viper
def ticks_diff(end: int, start: int) -> int:
    """Return the signed time from `start` to `end`, right as long as it is under half a period."""
    return ((end - start + 0x20000000) & 0x3FFFFFFF) - 0x20000000


@micropython.viper
def ticks_add(ticks: int, delta: int) -> int:
    """Return `ticks` moved by `delta`; OverflowError from half a period on, as on boards."""
    if delta >= 0x20000000 or delta < -0x20000000:
        raise OverflowError("ticks interval overflow")
    return (ticks + delta) & 0x3FFFFFFF


@micropython.viper
def move(duration: int):
    """Let microseconds pass, less than half a period."""
    clock = ptr32(words)
    now = clock[0] + duration
    if now > 0x3FFFFFFF:
        now -= 0x40000000
        clock[3] += 1
    clock[0] = now
    rest = clock[2] + duration
    if rest >= 1000:
        clock[1] = (clock[1] + rest // 1000) & 0x3FFFFFFF
        clock[4] += rest // 1000
        rest = rest % 1000
    clock[2] = rest
    clock[5] -= duration


@micropython.viper
def advance_us(duration: int):
    """Let microseconds pass."""
    clock = ptr32(words)
    if duration < 0 or duration >= clock[5] or followers:
        slowly(duration)
    else:
        move(duration)


@micropython.viper
def elapsed_us() -> int:
    """Return the microseconds since the start, not wrapped."""
    clock = ptr32(words)
    return clock[3] * 0x40000000 + clock[0]


@micropython.viper
def loop_ms() -> int:
    """Return the milliseconds of the event loop."""
    return int(start_ms) + ptr32(words)[4]
