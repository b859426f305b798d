"""The way of one program through a simulation: its boards, their restarts, and what is heard of them."""

import json
import os
import re
import signal
import time
from collections.abc import Callable, Iterable
from contextlib import AbstractContextManager, ExitStack
from typing import TYPE_CHECKING

from codegen.model.program_folders import ProgramFolders
from codegen.model.scenario import Stretch
from codegen.sim.address import free_port
from codegen.sim.flash import code_folder, flash_folder
from codegen.sim.process import EXIT_RESET, Console, FirmwareProcess, Item
from codegen.sim.program import SimulatedProgram
from codegen.sim.record import Recording
from codegen.sim.sample import Happening, Kind
from codegen.source import shown_path

if TYPE_CHECKING:
    from codegen.sim.run import Simulation

_SHORT_MS = 100
_MOST_SHORT_RUNS = 5

Watch = Callable[[Recording, Happening | None], None]
"""Called with each happening, and with None several times a second."""


class Passage:
    """Runs one program: start() whenever is_due(), take_in() whenever a stream of its has something to read.

    ``waits`` is True while the program has come to the end of its turn and waits for the next one.
    """

    def __init__(
        self, simulation: "Simulation", program: SimulatedProgram, recording: Recording, work: str, stack: ExitStack
    ) -> None:
        """``work`` is a folder for settings; ``stack`` keeps the flash of the boards until the simulation is over."""
        self.recording = recording
        self.process: FirmwareProcess | None = None
        self.waits = False
        self._simulation = simulation
        self._program = program
        self._stack = stack
        self._settings = os.path.join(work, f"{program.folder or 'vehicle'}.json")
        end_ms = simulation.duration_ms
        self._boards = [each for each in program.stretches if end_ms is None or each.start_ms < end_ms]
        self._board: Stretch | None = None
        self._flash = ""
        self._start_ms = 0
        self._is_first_start = True
        self._short_runs = 0
        self._heard_s = 0.0
        self._code = stack.enter_context(code_folder(program.code, program.module))

    @property
    def is_done(self) -> bool:
        """Return whether nothing runs, and nothing will."""
        return self.process is None and self._board is None and not self._boards

    def is_due(self, until_ms: int | None) -> bool:
        """Return whether a board has to be started in the turn that ends at a time."""
        if self.process is not None:
            return False
        if self._board is not None:
            return True
        return bool(self._boards) and (until_ms is None or self._boards[0].start_ms < until_ms)

    def start(self, until_ms: int | None, watch: Watch) -> None:
        """Start the next board, or the same one again after a reset; its first turn ends at ``until_ms``."""
        if self._board is None:
            self._board = self._boards.pop(0)
            self._start_ms = self._board.start_ms
            self._is_first_start = True
            self._flash = self._stack.enter_context(self._flash_folder(self._board))
            if self._board.number > 1:
                watch(self.recording, self.recording.take_new_board(self._board.start_ms))
        simulation, program = self._simulation, self._program
        board_end_ms = self._board.end_ms
        ends = [end for end in (board_end_ms, simulation.duration_ms) if end is not None]
        settings = {
            **program.settings(self._board, is_first_start=self._is_first_start),
            "start_ms": self._start_ms,
            "duration_ms": min(ends, default=None),
            "until_ms": until_ms,
            "speed": simulation.speed,
        }
        with open(self._settings, "w", encoding="utf-8") as file:
            json.dump(settings, file)
        self._is_first_start = False
        self.waits = False
        self._heard_s = time.monotonic()
        self.recording.reason = ""
        self.process = FirmwareProcess(
            simulation.runtime,
            simulation.interpreter,
            [*program.paths, *self._code],
            self._flash,
            program.script,
            self._settings,
            takes_turns=until_ms is not None,
        )

    def give_turn(self, until_ms: int) -> None:
        """Let its time go on to the end of another turn."""
        if self.process is not None and self.waits:
            self.waits = False
            self._heard_s = time.monotonic()
            self.process.give_turn(until_ms)

    def take_in(self, watch: Watch, silence_s: float) -> None:
        """Take in what the program has said; what follows from its end shows in ``recording.problem`` and is_due()."""
        process = self.process
        if process is None:
            return
        items = process.read(0)
        for item in items:
            self._take(item, watch)
        now_s = time.monotonic()
        self._heard_s = now_s if items else self._heard_s
        if process.is_over:
            self._end(process, watch)
        elif not self.waits and now_s - self._heard_s > silence_s:
            problem = f"the firmware does not let time pass any more ({silence_s:g} s without a sign of it)"
            self.interrupt(watch)  # the traceback tells where the firmware hangs
            where = _place(self.recording.traceback, self._program.folders)
            self.recording.problem = problem + where

    def interrupt(self, watch: Watch) -> None:
        """End the program, and take in what it still has to say."""
        if self.process is not None:
            for item in self.process.interrupt():
                self._take(item, watch)
        self.close()

    def close(self) -> None:
        """End the program at once, if it runs, and start nothing more."""
        if self.process is not None:
            self.process.close()
        self.process = None
        self._board = None
        self._boards = []

    def _flash_folder(self, board: Stretch) -> AbstractContextManager[str]:
        given = self._simulation.flash
        if given is not None and self._program.folder:
            number = f".{board.number}" if board.number > 1 else ""
            given = os.path.join(given, self._program.folder + number)
        return flash_folder(given, self._simulation.to, free_port(), {**self._program.ends, **self._simulation.ends})

    def _take(self, item: Item, watch: Watch) -> None:
        recording = self.recording
        if isinstance(item, Console):
            happening: Happening | None = recording.add(Kind.CONSOLE, item.text)
        elif item.get("kind") == "turn":
            self.waits = True
            happening = recording.take(item)
        elif item.get("kind") == "caught":
            recording.take(item)
            what = _raised(item["traceback"].splitlines(), self._program.folders)
            happening = recording.add(Kind.FAILED, f"{item['name']}: {what}")
        else:
            happening = recording.take(item)
        if happening is not None:
            watch(recording, happening)

    def _end(self, process: FirmwareProcess, watch: Watch) -> None:
        """The process has ended: by a reset of the board, at the end of its time, or because something is wrong."""
        recording = self.recording
        code = process.wait()
        process.close()
        self.process = None
        self.waits = False
        if code == EXIT_RESET and recording.reason == "reset":
            watch(recording, recording.add(Kind.REBOOT, "The board restarted"))
            self._short_runs = self._short_runs + 1 if recording.at_ms - self._start_ms < _SHORT_MS else 0
            self._start_ms = recording.at_ms
            if self._short_runs == _MOST_SHORT_RUNS:
                recording.problem = "the firmware restarts the board over and over"
                self.close()
            return
        if code or recording.reason != "over":
            complaints = recording.traceback or list(process.complaints)
            recording.problem = _problem(code, complaints, self._program.folders)
            recording.add(Kind.STOPPED, recording.problem)
            for line in complaints:
                recording.add(Kind.CONSOLE, line)
            self.close()
            return
        if self._board is not None and self._board.end_ms is not None and self._board.end_ms <= recording.at_ms:
            watch(recording, recording.take_board_out(self._board.end_ms))
        self._board = None


def _problem(code: int, complaints: list[str], folders: ProgramFolders) -> str:
    """Return why the firmware ended, from its exit code and its traceback, or what it wrote to stderr."""
    if code == 0:
        return "the firmware's main() returned"
    if code < 0:
        return f"the firmware was ended by a signal: {signal.strsignal(-code)}"
    return f"the firmware stopped: {_raised(complaints, folders) or f'exit code {code}'}"


def _raised(traceback: Iterable[str], folders: ProgramFolders) -> str:
    """Return the exception of a traceback, which is its last line, with its place; empty where there is none."""
    lines = [line.strip() for line in traceback if line.strip()]
    return f"{lines[-1]}{_place(lines, folders)}" if lines else ""


def _place(traceback: Iterable[str], folders: ProgramFolders) -> str:
    """`` (rover.py:4)``: where a traceback ends in the program, not in what stands in for its board; or nothing."""
    places = re.findall(r'File "(.+?)", line (\d+)', "\n".join(traceback))
    mocks = folders.of("mocks")
    places = [each for each in places if os.path.dirname(each[0]) not in mocks] or places
    return f" ({shown_path(places[-1][0])}:{places[-1][1]})" if places else ""
