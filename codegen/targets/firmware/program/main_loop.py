"""Views of what the main loop calls: the user's code, each component that is measured, and what is checked."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from codegen.frozen import dataclass
from codegen.model.program import Program
from codegen.model.sensor_turns import WATCH_US, turns_of
from codegen.model.system import System
from codegen.targets.firmware.failsafes.failsafe import FailsafeView


@dataclass(frozen=True, slots=True)
class CallView:
    """A method that the main loop calls every ``period_us``, under which name, and what asks for it."""

    period_us: int
    method: str
    name: str
    citation: str


@dataclass(frozen=True, slots=True)
class JobView:
    """A job that is done every ``period_us``: a component is measured, or quantities that nothing measures are checked.

    ``name`` is what texts call it where it fails, ``component`` None where nothing is measured.
    """

    name: str
    method: str
    component: str | None
    period_us: int
    statements: tuple[str, ...]


def job_views(system: System, program: Program, failsafes: tuple[FailsafeView, ...]) -> tuple[JobView, ...]:
    """The components that are measured, in the order of state.yaml, and behind them what is checked beside them."""
    names = [reading.component.name for reading in system.readings() if reading.is_first]
    jobs = [
        JobView(
            name=name,
            method=f"_watch_{name}",
            component=name,
            period_us=system.components[name].read_every_ms * 1000,
            statements=(
                f"self.state.update_{name}(self.board)",
                *_checks(each for each in failsafes if each.is_measured and each.component == name),
            ),
        )
        for name in names
    ]
    checked = tuple(_checks(each for each in failsafes if not each.is_measured))
    told = _about_itself(system, program)
    is_often = bool(names) and program.reads_often(system.components[names[-1]])
    if checked or (told and not is_often):
        jobs.append(JobView("checks", "_watch", None, program.checks_us, checked))
    return (*jobs[:-1], *(replace(job, statements=(*job.statements, *told)) for job in jobs[-1:]))


def _checks(failsafes: Iterable[FailsafeView]) -> Iterator[str]:
    return (f"self._check(self.{failsafe.attribute})" for failsafe in failsafes)


def _about_itself(system: System, program: Program) -> tuple[str, ...]:
    """Return what the vehicle tells about itself as soon as everything is read and checked."""
    told = own_words(system, program)
    ready = (
        "words[_VEHICLE_READY] = 0  # a check that fails does not leave an old answer",
        "words[_VEHICLE_READY] = 1 if self._is_ready() else 0",
    )
    return (
        *(["words = self.state.vehicle.words"] if told else []),
        *(ready if "ready" in told else ()),
        *(["words[_VEHICLE_LOAD_DPCT] = self.scheduler.load"] if "load_dpct" in told else []),
    )


def own_words(system: System, program: Program) -> set[str]:
    """Return the words of the vehicle that the main loop itself sets, not through their attributes, which take long."""
    can_arm = program.spec.arming is not None
    return {*(["ready"] if can_arm else []), *(["load_dpct"] if can_arm or _has_load(system) else [])}


def call_views(system: System, program: Program, jobs: tuple[JobView, ...]) -> tuple[CallView, ...]:
    """The user's code first, then the sensors, then what is measured and checked."""
    measure = CallView(program.measure_us or 0, "measure", "measure", str(program.cited.get("measure", "")))
    readings = [
        CallView(
            job.period_us,
            job.method,
            job.name,
            str(system.components[job.component].citation or "") if job.component else "",
        )
        for job in jobs
    ]
    return (*([measure] if program.measure_us else []), *_sensors(system, program), *readings)


def _sensors(system: System, program: Program) -> list[CallView]:
    """Return what asks the sensors, and what notices that one is silent."""
    if not system.polled:
        return []
    calls = [CallView(turns_of(system, program.control_us).every_us, "sources.turn", "sensors", "")]
    if any(source.silence_ms is not None for source in system.polled):
        calls.append(CallView(WATCH_US, "sources.watch", "silence", ""))
    return calls


def _has_load(system: System) -> bool:
    """Return whether the state asks for the load of the main loop, in the form in which the program tells it."""
    load = system.quantity("vehicle.load")
    return load is not None and load.attribute == "load_dpct" and system.components["vehicle"].instances == 1
