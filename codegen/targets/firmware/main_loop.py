"""Views of what the main loop calls: the user's code, and each component that is measured."""

from codegen.frozen import dataclass
from codegen.model.program import Program
from codegen.model.system import System
from codegen.targets.firmware.failsafe import FailsafeView
from codegen.targets.firmware.sources import WATCH_US, turns_of


@dataclass(frozen=True, slots=True)
class CallView:
    """A method that the main loop calls every ``period_us``, under which name, and what asks for it."""

    period_us: int
    method: str
    name: str
    citation: str


@dataclass(frozen=True, slots=True)
class JobView:
    """A component that is measured, in which period, with its failsafe, if it has one.

    ``afterwards`` are the statements behind those that read it.
    """

    component: str
    period_us: int
    failsafe: FailsafeView | None
    afterwards: tuple[str, ...]


def job_views(system: System, program: Program, failsafes: tuple[FailsafeView, ...]) -> tuple[JobView, ...]:
    """The components that are measured, in the order of state.yaml."""
    watched = {failsafe.component: failsafe for failsafe in failsafes}
    names = [reading.component.name for reading in system.readings() if reading.is_first]
    return tuple(
        JobView(
            component=name,
            period_us=(system.components[name].period_ms or 100) * 1000,
            failsafe=watched.get(name),
            afterwards=(
                *([f"self._check_{name}(time.ticks_ms())"] if name in watched else []),
                *(_after_readings(system, program) if name == names[-1] else []),
            ),
        )
        for name in names
    )


def _after_readings(system: System, program: Program) -> tuple[str, ...]:
    """What the vehicle tells about itself as soon as everything is read."""
    can_arm = program.spec.arming is not None
    ready = (
        "self.state.vehicle.ready = False  # a check that fails does not leave an old answer",
        "self.state.vehicle.ready = self._is_ready()",
    )
    load = "self.state.vehicle.load_dpct = self.scheduler.load"
    return (*(ready if can_arm else ()), *([load] if can_arm or _has_load(system) else []))


def call_views(system: System, program: Program, jobs: tuple[JobView, ...]) -> tuple[CallView, ...]:
    """The user's code first, then the sensors, then each component that is measured."""
    measure = CallView(program.measure_us or 0, "measure", "measure", str(program.cited.get("measure", "")))
    readings = [
        CallView(
            job.period_us,
            f"_watch_{job.component}",
            job.component,
            str(system.components[job.component].citation or ""),
        )
        for job in jobs
    ]
    return (*([measure] if program.measure_us else []), *_sensors(system, program), *readings)


def _sensors(system: System, program: Program) -> list[CallView]:
    """What asks the sensors, and what notices that one is silent."""
    if not system.polled:
        return []
    calls = [CallView(turns_of(system, program.control_us).every_us, "sources.turn", "sensors", "")]
    if any(source.silence_ms is not None for source in system.polled):
        calls.append(CallView(WATCH_US, "sources.watch", "silence", ""))
    return calls


def _has_load(system: System) -> bool:
    """Whether the state asks for the load of the main loop, in the form in which the program tells it."""
    load = system.quantity("vehicle.load")
    return load is not None and load.attribute == "load_dpct" and system.components["vehicle"].instances == 1
