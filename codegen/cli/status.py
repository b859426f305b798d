"""The output of ``codegen sim``: a line with the state as it runs, the happenings, and the result."""

import os
import signal
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from codegen.sim.record import Recording
    from codegen.sim.run import Simulation
    from codegen.sim.sample import Happening

_LIVE_S = 0.2
_PLAIN_S = 5.0
_MOST_NUMBERS = 3
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
        self._width = max((len(program.name) for program in simulation.programs), default=0)
        if not is_quiet:
            names = [program.name for program in simulation.programs]
            running = f"{', '.join(names)} run, " if len(names) > 1 else ""
            print(
                f"{simulation.scenario.name}: {simulation.scenario.doc}\n"
                f"{running}sending to {simulation.to.written}; Ctrl-C ends it",
                file=sys.stderr,
            )

    def watch(self, recording: "Recording", happening: "Happening | None") -> None:
        """Show what happened, or once in a while the state."""
        if self._is_quiet:
            return
        if happening is not None:
            self.clear()
            print(happening_line(happening, self._width), flush=True)
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
    """The state in one line; of several programs one after the other, with their names."""
    from codegen.sim.amount import seconds

    states = [_state(record) for record in recording.all]
    return f"{seconds(recording.at_ms)}  " + "  |  ".join(states)


def _state(recording: "Recording") -> str:
    from codegen.sim.sample import state_words

    sample = recording.sample
    name = f"{recording.name}: " if recording.name else ""
    if recording.is_out:
        return f"{name}out"
    rate = sample.size / max(1, sample.at_ms) * 1000
    does = f"{state_words(sample)}  " if recording.tells_state else ""
    state = f"{does}{sample.frames} frames, {rate:.0f} bytes/s"
    return f"{name}{_numbers(recording)}{state}"


def _numbers(recording: "Recording") -> str:
    """Return what is true now of the first quantities with a course, and what was told of them last."""
    from codegen.sim.amount import amount

    texts, at_ms = [], recording.at_ms
    for line in [line for line in recording.lines if recording.has_course(line.label)][:_MOST_NUMBERS]:
        true, told = (
            amount(value, line.unit, None if value is None else 2)
            for value in (recording.true(line.label, at_ms), recording.told(line.label, at_ms))
        )
        texts.append(f"{line.label} {true}, told {told}")
    return "; ".join(texts) + "  " if texts else ""


def happening_line(happening: "Happening", width: int = 0) -> str:
    """One happening in one line; ``width`` is that of the longest name of a program."""
    from codegen.sim.amount import seconds
    from codegen.sim.sample import SEVERITIES

    severity = happening.severity
    what = happening.kind.value if severity is None else SEVERITIES[severity] if severity < 8 else str(severity)
    program = f"{happening.program:{width}}  " if happening.program else ""
    return f"{seconds(happening.at_ms):>9}  {program}{what:8}  {_printable(happening.text)}".rstrip()


def _printable(text: str) -> str:
    """Return what a terminal would obey is shown instead."""
    return "".join(
        character if character.isprintable() or character == "\t" else f"\\x{ord(character):02x}" for character in text
    )


def print_result(simulation: "Simulation", recording: "Recording", report: str | None) -> None:
    """Print what came of the simulation."""
    from codegen.sim.amount import seconds
    from codegen.sim.verdict import verdict

    name = simulation.scenario.name
    print(f"{name}: {seconds(recording.at_ms)} under {recording.runtime or simulation.runtime}")
    for sentence in verdict(recording):
        print(f"  {sentence}")
    for record in recording.all:
        _print_traffic(record, recording.at_ms)
    if report is not None:
        print(f"  {report} shows it")


def _print_traffic(recording: "Recording", length_ms: int) -> None:
    """The frames, bytes and bytes per second of each message; length_ms: how long it ran."""
    traffic = recording.traffic
    frames, size = sum(traffic.frames.values()), sum(traffic.sizes.values())
    length_s = max(length_ms, 1) / 1000
    of = f" of {recording.name}" if recording.name else ""
    print(f"  {frames} frames{of}, {size} bytes went out, {size / length_s:.1f} bytes/s")
    width = max(map(len, traffic.frames), default=0)
    for message, count in sorted(traffic.frames.items()):
        print(f"    {message:{width}}  {count:6} frames  {traffic.sizes.get(message, 0) / length_s:8.1f} bytes/s")
    if traffic.dropped or traffic.crc_errors:
        print(f"  {traffic.dropped} frames were dropped, {traffic.crc_errors} arrived damaged")


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
