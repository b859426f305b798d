"""The jobs of the main loop: how often each is due, and what it takes. Their order is that of a pass."""

from collections.abc import Iterable, Iterator

from codegen.frozen import dataclass
from codegen.loop.parts import Part, Work
from codegen.loop.pass_share import REMINDER_US, parts_links
from codegen.model.failsafe import Failsafe
from codegen.model.price import on_by_default
from codegen.model.program import Program
from codegen.model.sensor_turns import WATCH_US, turns_of
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, by_instance

LINKS = "links"
"""The name of the job that serves the links."""
_REPORT, _REMINDER = Work({Part.REPORT: 1}), Work({Part.REMINDER: 1})


@dataclass(frozen=True, slots=True)
class Job:
    """A job, due every ``period_us``: ``name`` is its name in texts of the firmware, ``words`` its description.

    ``work`` is what it takes with what is switched on by default, ``most`` with everything switched on; None where that
    is the user's code.
    """

    name: str
    words: str
    period_us: int
    work: Work | None
    most: Work | None


def loop_jobs(system: System, program: Program) -> tuple[Job, ...]:
    """Return all jobs of a program."""
    turns = len(system.links) if parts_links(system, program) else 1
    links = Work({Part.LINK: len(system.links) // turns})
    return (
        *([Job("measure", "code of yours measures", program.measure_us, None, None)] if program.measure_us else []),
        *_sensors(system, program),
        *_readings(system, program),
        *[Job(LINKS, "links are served" if turns == 1 else "a link is served", program.links_us, links, links)] * turns,
        Job("report", "missed slots are reported", program.report_ms * 1000, _REPORT, _REPORT),
        Job("reminder", "what stands is said again", REMINDER_US, _REMINDER, _REMINDER),
    )


def _can_arm(program: Program) -> bool:
    return program.spec.arming is not None


def _sensors(system: System, program: Program) -> Iterator[Job]:
    if not system.polled:
        return
    every_us, most = turns_of(system, program.control_us)
    work = Work({Part.SENSORS: most, Part.SENSOR: most * len(system.polled), Part.TURN: most})
    yield Job("sensors", "a sensor has its turn" if most == 1 else "sensors have their turns", every_us, work, work)
    if any(source.silence_ms is not None for source in system.polled):
        work = Work({Part.SENSOR: len(system.polled)})
        yield Job("silence", "silent sensors are noticed", WATCH_US, work, work)


def _readings(system: System, program: Program) -> Iterator[Job]:
    """Return the components that are read, with the failsafes on them; behind the last what is checked beside them."""
    measured = [component for component in system.components.values() if component.readings]
    with_readings = [each for each in program.failsafes if program.looks_with_readings(each)]
    for component in measured:
        guards = [each for each in with_readings if each.component is component]
        yield Job(
            component.name,
            f"{component.name} is read" + (", with its failsafe" if guards else ""),
            component.read_every_ms * 1000,
            _read(component, system) + _guarded(guards, system),
            _read(component, None) + _guarded(guards, None),
        )
    beside = [each for each in program.failsafes if not program.looks_with_readings(each)]
    is_often = bool(measured) and program.reads_often(measured[-1])
    if beside or (not is_often and (_can_arm(program) or _tells_load(system))):
        words = "failsafes look" if beside else "what the vehicle tells about itself is found out"
        yield Job("checks", words, program.checks_us, _guarded(beside, system), _guarded(beside, None))


def _tells_load(system: System) -> bool:
    load = system.quantity("vehicle.load")
    return load is not None and load.attribute == "load_dpct" and system.components["vehicle"].instances == 1


def _read(component: Component, system: System | None) -> Work:
    """Return what it takes to read a component, with what is on by default, or without ``system`` with all of it."""
    work = Work({Part.COMPONENT: 1})
    on = on_by_default(component, system) if system else (True,) * component.instances
    for number in range(component.instances):
        for reading in component.readings:
            channel = reading.conversion.channel
            if on[number] and (system is None or channel.when is None or _is(*channel.when, component, number, system)):
                work += Work({Part.READING: 1, Part.SAMPLE: channel.samples, Part.CONVERSION: channel.samples})
    return work


def _is(parameter: Parameter, steps: int, component: Component, number: int, system: System) -> bool:
    return by_instance(parameter, system.parameters, component.instances)[number].default == steps


def _guarded(failsafes: Iterable[Failsafe], system: System | None) -> Work:
    """Return what it takes to look at failsafes, and whether they let the vehicle be armed."""
    work = Work({Part.WATCH: 1})
    for failsafe in failsafes:
        count = sum(on_by_default(failsafe.component, system)) if system else failsafe.instances
        conditions = len(failsafe.conditions) + len(failsafe.to_arm)
        work += Work({Part.FAILSAFE: count, Part.CONDITION: count * conditions})
    return work
