"""A whole simulation: every program of the scenario is started, followed, and started again when it restarts.

Several programs keep pace with each other: the time of each goes on in turns of TURN_MS, and the next turn begins when
all of them have come to the end of the last one. So no two are ever further apart than a turn and one wait of a task.
"""

import select
import tempfile
from collections.abc import Sequence
from contextlib import ExitStack

from codegen.frozen import dataclass
from codegen.model.scenario import Scenario
from codegen.sim.address import Address
from codegen.sim.course import Course, Watch
from codegen.sim.process import Runtime
from codegen.sim.program import SimulatedProgram
from codegen.sim.record import Recording

SILENCE_S = 30.0
"""Seconds without a sign of the firmware after which it is given up."""
TURN_MS = 50
"""How long a turn is in the time of the scenario."""
_WAIT_S = 0.2


@dataclass(frozen=True, slots=True)
class Simulation:
    """What is run: ``duration_ms`` None is without end, ``speed`` 0 as fast as it can.

    ``programs`` are the vehicle's own and those beside it; all send to ``to``.
    """

    scenario: Scenario
    duration_ms: int | None
    speed: float
    runtime: Runtime
    interpreter: str
    to: Address
    flash: str | None
    programs: tuple[SimulatedProgram, ...]

    def recording(self) -> Recording:
        """An empty record of it: that of the vehicle's own program, with those of the others beside it."""
        main, *others = self.programs
        name = main.name if others else ""
        return Recording(
            self.scenario,
            name,
            None,
            _prefixes(main),
            [Recording(self.scenario, other.name, other.key, _prefixes(other)) for other in others],
        )


def simulate(simulation: Simulation, recording: Recording, watch: Watch, silence_s: float = SILENCE_S) -> None:
    """Run the programs until their time is over, one fails, or KeyboardInterrupt; ``recording`` says how it went.

    OSError: a folder or file of the user cannot be used, or the interpreter cannot be started.
    """
    with ExitStack() as stack:
        work = stack.enter_context(tempfile.TemporaryDirectory(prefix="codegen-sim-"))
        courses = [
            Course(simulation, program, record, work, stack)
            for program, record in zip(simulation.programs, recording.all, strict=True)
        ]
        try:
            _run(courses, recording, watch, silence_s)
        except KeyboardInterrupt:
            for record in recording.all:
                record.was_interrupted = True
            for course in courses:
                course.interrupt(watch)
        finally:
            for course in courses:
                course.close()


def _run(courses: Sequence[Course], recording: Recording, watch: Watch, silence_s: float) -> None:
    until_ms = TURN_MS if len(courses) > 1 else None
    while not all(course.is_done for course in courses):
        for course in courses:
            if course.is_due(until_ms):
                course.start(until_ms, watch)
        streams = [stream for course in courses if course.process for stream in course.process.streams]
        if streams:
            select.select(streams, [], [], _WAIT_S)
        for course in courses:
            course.take_in(watch, silence_s)
        watch(recording, None)
        if any(record.problem for record in recording.all):
            for course in courses:  # what the others have done so far is counted
                course.interrupt(watch)
            return
        running = [course for course in courses if course.process]
        if until_ms is not None and all(course.waits for course in running) and not _any_due(courses, until_ms):
            until_ms += TURN_MS
            for course in running:
                course.give_turn(until_ms)


def _any_due(courses: Sequence[Course], until_ms: int) -> bool:
    return any(course.is_due(until_ms) for course in courses)


def _prefixes(program: SimulatedProgram) -> tuple[str, ...]:
    return tuple(connection.prefix for connection in program.connections)
