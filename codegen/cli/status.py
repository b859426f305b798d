"""What ``codegen sim`` prints: the line that shows the state as it goes, what happens, and the result."""

import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from codegen.sim.record import Happening, Recording
    from codegen.sim.run import Simulation

_LIVE_S = 0.2
_PLAIN_S = 5.0
_CLEAR = "\r\x1b[K"


class StatusLine:
    """Shows on stderr how the simulation goes: one line that changes on a terminal, else a line every few seconds."""

    def __init__(self, simulation: "Simulation", *, is_quiet: bool) -> None:
        """Say where the vehicle sends to."""
        self._is_quiet = is_quiet
        self._is_live = sys.stderr.isatty() and os.environ.get("TERM") != "dumb"
        self._next_s = 0.0 if self._is_live else time.monotonic() + _PLAIN_S
        self._is_shown = False
        self._name = simulation.scenario.name
        self._started_s: float | None = None
        if not is_quiet:
            print(
                f"{simulation.scenario.name}: {simulation.scenario.doc}\n"
                f"sending to {simulation.to.written}; Ctrl-C ends it",
                file=sys.stderr,
            )

    def watch(self, recording: "Recording", happening: "Happening | None") -> None:
        """Show what happened, or once in a while the state."""
        if self._is_quiet:
            return
        if happening is not None:
            self.clear()
            print(happening_line(happening), flush=True)
            return
        now_s = time.monotonic()
        if now_s < self._next_s:
            return
        self._next_s = now_s + (_LIVE_S if self._is_live else _PLAIN_S)
        self._started_s = now_s if self._started_s is None else self._started_s
        line = f"{self._name} {state_line(recording)}"
        if self._is_live:
            width = os.get_terminal_size(sys.stderr.fileno()).columns
            print(_CLEAR + line[: width - 1], end="", file=sys.stderr, flush=True)
            self._is_shown = True
        else:
            print(line, file=sys.stderr, flush=True)

    def clear(self) -> None:
        """Take the line away, so that other lines can be printed."""
        if self._is_shown:
            print(_CLEAR, end="", file=sys.stderr, flush=True)
            self._is_shown = False


def state_line(recording: "Recording") -> str:
    """The state in one line."""
    from codegen.sim.verdict import seconds, volts

    sample = recording.sample
    true = "" if sample.true_mv is None else volts(sample.true_mv)
    reported = "unknown" if sample.reported_mv is None else volts(sample.reported_mv)
    armed = "armed" if sample.is_armed else "disarmed"
    rate = sample.size / max(1, sample.at_ms) * 1000
    return (
        f"{seconds(recording.at_ms)}  battery {true}, reported {reported}  {armed}, {sample.state_name}  "
        f"{sample.frames} frames, {rate:.0f} bytes/s"
    )


def happening_line(happening: "Happening") -> str:
    """One happening in one line."""
    from codegen.sim.record import SEVERITIES
    from codegen.sim.verdict import seconds

    severity = happening.severity
    what = happening.kind.value if severity is None else SEVERITIES[severity] if severity < 8 else str(severity)
    return f"{seconds(happening.at_ms):>9}  {what:8}  {_printable(happening.text)}".rstrip()


def _printable(text: str) -> str:
    """What a terminal would obey is shown instead."""
    return "".join(
        character if character.isprintable() or character == "\t" else f"\\x{ord(character):02x}" for character in text
    )


def print_result(simulation: "Simulation", recording: "Recording", report: str | None) -> None:
    """Print what came of the simulation."""
    from codegen.sim.verdict import seconds, verdict

    traffic = recording.traffic
    name = simulation.scenario.name
    print(f"{name}: {seconds(recording.at_ms)} under {recording.runtime or simulation.runtime}")
    for sentence in verdict(recording):
        print(f"  {sentence}")
    counts = ", ".join(f"{message} {count}" for message, count in sorted(traffic.frames.items()))
    frames, size = sum(traffic.frames.values()), sum(traffic.sizes.values())
    print(f"  {frames} frames, {size} bytes went out" + (f": {counts}" if counts else ""))
    if traffic.dropped or traffic.crc_errors:
        print(f"  {traffic.dropped} frames were dropped, {traffic.crc_errors} arrived damaged")
    if report is not None:
        print(f"  {report} shows it")


@contextmanager
def ended_by_signals() -> Iterator[None]:
    """Let SIGTERM end the block as Ctrl-C does."""

    def interrupt(_number: int, _frame: FrameType | None) -> None:
        raise KeyboardInterrupt

    try:
        before = signal.signal(signal.SIGTERM, interrupt)
    except ValueError:  # not the main thread
        yield
        return
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)
