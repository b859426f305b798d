"""Scenarios as they are written into plain numbers."""

from collections.abc import Mapping, Sequence

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.scenario import Arming, Beside, Course, Event, Fault, Reboot, Scenario, Swap
from codegen.model.spec.scenario import EventSpec, ScenarioSpec, ScenariosSpec
from codegen.model.system import System
from codegen.resolve.scenarios.board import stored_parameters
from codegen.resolve.scenarios.courses import Courses
from codegen.resolve.scenarios.expectations import Expectations
from codegen.resolve.scenarios.sendings import sending
from codegen.resolve.scenarios.values import SCENARIO_TIME, ScenarioValues

SCENARIO_EVENT = Rule(
    "scenario-event",
    "An event has a key that it has no use for, or lacks one: of and delay belong to faults, for to these and to a "
    "swap, which needs it, as slow readings need a delay of 1 us to 1 s. A fault is at a quantity that has a course, "
    "and one of those that this can have. What is absent is so from the start, and a reboot is not false.",
)
SCENARIO_PROGRAM = Rule(
    "scenario-program",
    "Under with stand other programs of the project (programs of codegen.yaml), and a swap is that of one of them. "
    "What the vehicle itself has is swapped by its course: unknown, or 0 V, while it is out.",
)
SCENARIO_SWAP = Rule(
    "scenario-swap",
    "A swap begins after the start, when there is something to take out, and not before the last one of that program "
    "has ended.",
)
ABSENT, SLOW = "absent", "slow"


def resolve_scenarios(
    spec: ScenariosSpec, system: System | None, report: Report, programs: Mapping[str, System] | None = None
) -> dict[str, Scenario]:
    """The scenarios by name, those with errors left out; ``programs`` are those that may run beside ``system``.

    Without a system, which had errors, only what needs no knowledge of it is checked.
    """
    known = {} if programs is None else programs
    resolved = {
        name: _Resolver(name, written, system, known, report).resolve() for name, written in spec.scenarios.items()
    }
    return {name: scenario for name, scenario in resolved.items() if scenario is not None}


class _Resolver:
    """Resolves one scenario."""

    def __init__(
        self, name: str, spec: ScenarioSpec, system: System | None, programs: Mapping[str, System], report: Report
    ) -> None:
        self._name = name
        self._spec = spec
        self._programs = programs
        # One that is listed but could not be read has errors of its own.
        self._known = None if system is None else {*programs, *system.spec.project.programs}
        self._system = system
        self._values = ScenarioValues(report, {} if system is None else system.dialect.enums)
        self._duration_ms: int | None = None
        self._courses: tuple[Course, ...] = ()

    def resolve(self) -> Scenario | None:
        spec, values = self._spec, self._values
        self._duration_ms = values.milliseconds(spec.duration, spec.at("duration"), 1)
        parameters = stored_parameters(spec, self._system, values)
        courses = Courses(self._system, values)
        self._courses = courses.read(spec, parameters)
        beside = {name: self._beside(name) for name in spec.with_}
        pairs = [(event, written) for written in spec.events if (event := self._event(written, beside)) is not None]
        events = sorted(pairs, key=lambda pair: pair[0].at_ms)
        self._check_swaps(events)
        expected = Expectations(courses, values, self._duration_ms, self._system).read(spec.expect)
        if not values.is_good or self._duration_ms is None:
            return None
        return Scenario(
            name=self._name,
            doc=spec.doc,
            duration_ms=self._duration_ms,
            seed=spec.seed,
            courses=self._courses,
            events=tuple(event for event, _ in events),
            parameters=parameters,
            beside=tuple(beside.values()),
            expected=expected,
            has_code=spec.code,
        )

    def _beside(self, name: str) -> Beside:
        spec = self._spec.with_[name]
        if self._known is not None and name not in self._known:
            hint = did_you_mean(name, self._known) or "name it under programs of codegen.yaml"
            self._values.say(SCENARIO_PROGRAM, spec.place, f"the project has no program {name}", hint)
        system = self._programs.get(name)
        parameters = stored_parameters(spec, system, self._values)
        return Beside(name, Courses(system, self._values).read(spec, parameters), parameters)

    def _event(self, event: EventSpec, beside: Mapping[str, Beside]) -> Event | None:
        values = self._values
        at_ms = values.milliseconds(event.at_, event.at("at"), 0)
        for_ms = None if event.for_ is None else values.milliseconds(event.for_, event.at("for"), 1)
        self._check_keys(event)
        courses = None if event.swap is None else self._swapped(event, beside)
        fault = None if event.fault is None else self._fault(event, at_ms, for_ms)
        if at_ms is None:
            return None
        if self._duration_ms is not None and at_ms > self._duration_ms:
            values.say(
                SCENARIO_TIME,
                event.at("at"),
                f"{event.at_} lies after the end, {self._spec.duration}",
                hint="let it happen earlier, or give the scenario a longer duration",
            )
        if event.swap is not None:
            if at_ms == 0:
                values.say(
                    SCENARIO_SWAP,
                    event.at("at"),
                    "at the start there is nothing that could be swapped",
                    hint="write a later time, such as at: 10 s",
                )
            return None if for_ms is None else Swap(at_ms, event.swap, at_ms + for_ms, courses)
        if event.arm is not None:
            return Arming(at_ms, event.arm)
        if event.send is not None:
            return None if self._system is None else sending(event, at_ms, self._system, values)
        return Reboot(at_ms) if event.fault is None else fault

    def _fault(self, event: EventSpec, at_ms: int | None, for_ms: int | None) -> Fault | None:
        """The fault; None after an error."""
        say, kind = self._values.say, event.fault or ""
        delay = None if event.delay is None else self._values.amount(event.delay, "us", event.at("delay"))
        if delay is not None and not 1 <= delay <= 1_000_000:
            say(SCENARIO_EVENT, event.at("delay"), f"{event.delay} is not from 1 us to 1 s", hint="delay: 3 ms")
        if kind == ABSENT and at_ms != 0:
            say(SCENARIO_EVENT, event.at("at"), "what is absent is so from the start", "write at: 0 s")
        if event.of is None:
            say(SCENARIO_EVENT, event.at("fault"), "a fault is at a quantity that has a course", "add of:")
            return None
        course = next((each for each in self._courses if each.label == event.of.replace("[0]", "")), None)
        if course is None:
            if event.of not in self._spec.courses:  # else the course has an error of its own
                hint = did_you_mean(event.of, self._spec.courses) or f"courses: {{{event.of}: {{value: ...}}}}"
                say(SCENARIO_EVENT, event.at("of"), f"{event.of} has no course in this scenario", hint)
            return None
        words = course.through.faults.get(kind)
        if words is None:
            known = ", ".join(course.through.faults)
            hint = did_you_mean(kind, course.through.faults) or f"it can be {known}"
            say(SCENARIO_EVENT, event.at("fault"), f"{course.label} cannot have the fault {kind}", hint)
            return None
        until_ms = None if for_ms is None or at_ms is None else at_ms + for_ms
        return Fault(at_ms or 0, kind, course.label, until_ms, words, round(delay or 0))

    def _swapped(self, event: EventSpec, beside: Mapping[str, Beside]) -> tuple[Course, ...] | None:
        """The courses of the board that comes in; None where those of the old one go on."""
        name = event.swap or ""
        if name not in beside:
            hint = did_you_mean(name, beside) or "what the vehicle has is swapped by points of its course: unknown, 0 V"
            message = f"{name} does not run beside the vehicle, so it cannot be swapped"
            self._values.say(SCENARIO_PROGRAM, event.at("swap"), message, hint)
            return None
        if "courses" not in event.places:
            return None
        # A new board has the parameters that the first one was given: they are set up alike.
        return Courses(self._programs.get(name), self._values).read(event, beside[name].parameters)

    def _check_keys(self, event: EventSpec) -> None:
        say = self._values.say
        repeats = event.fault is not None or event.every is not None
        if event.for_ is not None and not repeats and event.swap is None:
            say(
                SCENARIO_EVENT,
                event.at("for"),
                "for belongs to a fault, to a swap, or to what is sent every so often",
                hint="leave for out, or add every: to send it again and again",
            )
        for key in ("fields", "every"):
            if key in event.places and event.send is None:
                say(
                    SCENARIO_EVENT,
                    event.at(key),
                    f"{key} belongs to send",
                    hint=f"leave {key} out, or add send: MESSAGE",
                )
        if event.for_ is None and event.swap is not None:
            say(SCENARIO_EVENT, event.at("swap"), "a swap needs the time that it takes", "add for: 5 s")
        if event.delay is not None and event.fault != SLOW:
            say(
                SCENARIO_EVENT,
                event.at("delay"),
                "delay belongs to fault: slow",
                hint="leave delay out, or write fault: slow",
            )
        if event.delay is None and event.fault == SLOW:
            say(SCENARIO_EVENT, event.at("fault"), "slow readings need a delay", "add delay: 3 ms")
        if event.of is not None and event.fault is None:
            say(SCENARIO_EVENT, event.at("of"), "of belongs to a fault", hint="leave of out, or say which fault it has")
        if event.reboot is False:
            say(SCENARIO_EVENT, event.at("reboot"), "a reboot that does not happen", "remove the event")
        if "courses" in event.places and event.swap is None:
            say(
                SCENARIO_EVENT,
                event.at("courses"),
                "courses belong to a swap",
                hint="leave courses out, or write swap: PROGRAM",
            )

    def _check_swaps(self, events: Sequence[tuple[Event, EventSpec]]) -> None:
        """Report each that begins before the one before it has ended."""
        ends: dict[str, int] = {}
        for swap, spec in events:
            if isinstance(swap, Swap):
                end_ms = ends.get(swap.program, -1)
                if swap.at_ms <= end_ms:
                    message = f"the swap before it ends at {end_ms / 1000:g} s"
                    self._values.say(
                        SCENARIO_SWAP,
                        spec.at("at"),
                        message,
                        hint="write a later time, or let the swap before it end earlier: for",
                    )
                ends[swap.program] = max(swap.until_ms, end_ms)


def unknown_scenario(name: str, known: Sequence[str]) -> str:
    """Return the message that there is no scenario of that name, with the one that may have been meant."""
    hint = did_you_mean(name, known)
    return f"there is no scenario {name!r}" + (f"; {hint}" if hint else "")
