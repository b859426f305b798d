"""A whole simulation: every program of the scenario is started, followed, and started again when it restarts.

Several programs keep pace with each other: the time of each goes on in turns of TURN_MS, and the next turn begins when
all of them have come to the end of the last one. So no two are ever further apart than a turn and one wait of a task.
"""

import select
import tempfile
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import field

from codegen.frozen import dataclass
from codegen.model.scenario import Scenario
from codegen.sim.address import Address, LinkEnd
from codegen.sim.passage import Passage, Watch
from codegen.sim.process import Runtime
from codegen.sim.program import SimulatedProgram
from codegen.sim.record import Recording

SILENCE_S = 30.0
"""Seconds without a sign of the firmware after which it is given up."""
TURN_MS = 50
"""The length of a turn in the time of the scenario."""
_WAIT_S = 0.2


@dataclass(frozen=True, slots=True)
class Simulation:
    """A simulation to run: ``duration_ms`` None is without end, ``speed`` 0 as fast as it can.

    ``programs`` are the vehicle's own and those beside it; all send to ``to``, and ``ends`` are those of links over TCP
    that are somewhere else than usual, by their names.
    """

    scenario: Scenario
    duration_ms: int | None
    speed: float
    runtime: Runtime
    interpreter: str
    to: Address
    flash: str | None
    programs: tuple[SimulatedProgram, ...]
    ends: Mapping[str, LinkEnd] = field(default_factory=dict)

    def recording(self) -> Recording:
        """An empty record of it: that of the vehicle's own program, with those of the others beside it."""
        main, *others = self.programs
        name = main.name if others else ""
        return Recording(self.scenario, main, name, [Recording(self.scenario, other, other.name) for other in others])


def simulate(simulation: Simulation, recording: Recording, watch: Watch, silence_s: float = SILENCE_S) -> None:
    """Run the programs until their time is over, one fails, or KeyboardInterrupt; ``recording`` says how it went.

    OSError: a folder or file of the user cannot be used, or the interpreter cannot be started.
    """
    with ExitStack() as stack:
        work = stack.enter_context(tempfile.TemporaryDirectory(prefix="codegen-sim-"))
        passages = [
            Passage(simulation, program, record, work, stack)
            for program, record in zip(simulation.programs, recording.all, strict=True)
        ]
        try:
            _run(passages, recording, watch, silence_s)
        except KeyboardInterrupt:
            for record in recording.all:
                record.was_interrupted = True
            for passage in passages:
                passage.interrupt(watch)
        finally:
            for passage in passages:
                passage.close()


def _run(passages: Sequence[Passage], recording: Recording, watch: Watch, silence_s: float) -> None:
    until_ms = TURN_MS if len(passages) > 1 else None
    while not all(passage.is_done for passage in passages):
        for passage in passages:
            if passage.is_due(until_ms):
                passage.start(until_ms, watch)
        streams = [stream for passage in passages if passage.process for stream in passage.process.streams]
        if streams:
            select.select(streams, [], [], _WAIT_S)
        for passage in passages:
            passage.take_in(watch, silence_s)
        watch(recording, None)
        if any(record.problem for record in recording.all):
            for passage in passages:  # what the others have done so far is counted
                passage.interrupt(watch)
            return
        running = [passage for passage in passages if passage.process]
        if until_ms is not None and all(passage.waits for passage in running) and not _any_due(passages, until_ms):
            until_ms += TURN_MS
            for passage in running:
                passage.give_turn(until_ms)


def _any_due(passages: Sequence[Passage], until_ms: int) -> bool:
    return any(passage.is_due(until_ms) for passage in passages)
