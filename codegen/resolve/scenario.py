"""Scenarios as they are written into plain numbers."""

from collections.abc import Mapping, Sequence

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.scenario import AdcFault, Arming, Battery, Beside, Event, Fault, Reboot, Scenario, Swap
from codegen.model.scenario_spec import EventSpec, ScenarioSpec, ScenariosSpec
from codegen.model.system import System
from codegen.resolve.scenario_board import ScenarioBoard
from codegen.resolve.scenario_values import SCENARIO_TIME, ScenarioValues

SCENARIO_EVENT = Rule(
    "scenario-event",
    "An event has a key that it has no use for, or lacks one: delay and instance belong to faults of the ADC, for to "
    "these and to a swap, which needs it, as a slow ADC needs a delay of 1 us to 1 s. An absent ADC is so from the "
    "start, and a reboot is not false.",
)
SCENARIO_PROGRAM = Rule(
    "scenario-program",
    "Under with stand other programs of the project (programs of codegen.yaml), and a swap is that of one of them. A "
    "battery that the vehicle itself measures is swapped by its voltage: 0 V while it is out.",
)
SCENARIO_SWAP = Rule(
    "scenario-swap",
    "A swap begins after the start, when there is something to take out, and not before the last one of that program "
    "has ended.",
)


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
        self._values = ScenarioValues(report)
        self._board = ScenarioBoard(system, self._values)
        self._duration_ms: int | None = None

    def resolve(self) -> Scenario | None:
        spec = self._spec
        self._duration_ms = self._values.milliseconds(spec.duration, spec.at("duration"), 1)
        parameters = self._board.parameters(spec)
        batteries = self._board.batteries(spec, parameters)
        beside = {name: self._beside(name) for name in spec.with_}
        pairs = [(event, written) for written in spec.events if (event := self._event(written, beside)) is not None]
        events = sorted(pairs, key=lambda pair: pair[0].at_ms)
        self._check_swaps(events)
        has_broken_ones = not batteries and not {"battery", "batteries"}.isdisjoint(spec.places)
        if not self._values.is_good or self._duration_ms is None or has_broken_ones:
            return None
        return Scenario(
            name=self._name,
            doc=spec.doc,
            duration_ms=self._duration_ms,
            seed=spec.seed,
            batteries=batteries,
            events=tuple(event for event, _ in events),
            parameters=parameters,
            beside=tuple(beside.values()),
        )

    def _beside(self, name: str) -> Beside:
        spec = self._spec.with_[name]
        if self._known is not None and name not in self._known:
            hint = did_you_mean(name, self._known) or "name it under programs of codegen.yaml"
            self._values.say(SCENARIO_PROGRAM, spec.place, f"the project has no program {name}", hint)
        board = ScenarioBoard(self._programs.get(name), self._values)
        parameters = board.parameters(spec)
        return Beside(name, board.batteries(spec, parameters), parameters)

    def _event(self, event: EventSpec, beside: Mapping[str, Beside]) -> Event | None:
        values = self._values
        at_ms = values.milliseconds(event.at_, event.at("at"), 0)
        for_ms = None if event.for_ is None else values.milliseconds(event.for_, event.at("for"), 1)
        self._check_keys(event)
        instance = self._board.instance(event)
        delay = None if event.delay is None else values.amount(event.delay, "us", event.at("delay"))
        if delay is not None and not 1 <= delay <= 1_000_000:
            values.say(SCENARIO_EVENT, event.at("delay"), f"{event.delay} is not from 1 us to 1 s")
        batteries = None if event.swap is None else self._swapped(event, beside)
        if at_ms is None:
            return None
        if self._duration_ms is not None and at_ms > self._duration_ms:
            values.say(SCENARIO_TIME, event.at("at"), f"{event.at_} lies after the end, {self._spec.duration}")
        if event.adc is AdcFault.ABSENT and at_ms != 0:
            values.say(SCENARIO_EVENT, event.at("at"), "an absent ADC is absent from the start", "write at: 0 s")
        if event.swap is not None:
            if at_ms == 0:
                values.say(SCENARIO_SWAP, event.at("at"), "at the start there is nothing that could be swapped")
            return None if for_ms is None else Swap(at_ms, event.swap, at_ms + for_ms, batteries)
        if event.arm is not None:
            return Arming(at_ms, event.arm)
        if event.adc is None:
            return Reboot(at_ms)
        return Fault(at_ms, event.adc, None if for_ms is None else at_ms + for_ms, round(delay or 0), instance)

    def _swapped(self, event: EventSpec, beside: Mapping[str, Beside]) -> tuple[Battery, ...] | None:
        """The batteries of the board that comes in; None where the course of the old ones goes on."""
        name = event.swap or ""
        if name not in beside:
            hint = did_you_mean(name, beside) or "a battery of the vehicle is swapped by points of 0 V in its voltage"
            message = f"{name} does not run beside the vehicle, so it cannot be swapped"
            self._values.say(SCENARIO_PROGRAM, event.at("swap"), message, hint)
            return None
        if event.battery is None and "batteries" not in event.places:
            return None
        if event.battery is not None and "batteries" in event.places:
            message = "battery and batteries are given, and only one of them can hold"
            self._values.say(SCENARIO_EVENT, event.at("batteries"), message)
            return None
        board = ScenarioBoard(self._programs.get(name), self._values)
        # A new board has the parameters that the first one was given: they are set up alike.
        return board.batteries(event, beside[name].parameters)

    def _check_keys(self, event: EventSpec) -> None:
        say = self._values.say
        if event.for_ is not None and event.adc is None and event.swap is None:
            say(SCENARIO_EVENT, event.at("for"), "for belongs to a fault of the ADC, or to a swap")
        if event.for_ is None and event.swap is not None:
            say(SCENARIO_EVENT, event.at("swap"), "a swap needs the time that it takes", "add for: 5 s")
        if event.delay is not None and event.adc is not AdcFault.SLOW:
            say(SCENARIO_EVENT, event.at("delay"), "delay belongs to adc: slow")
        if event.delay is None and event.adc is AdcFault.SLOW:
            say(SCENARIO_EVENT, event.at("adc"), "a slow ADC needs a delay", "add delay: 3 ms")
        if event.instance is not None and event.adc is None:
            say(SCENARIO_EVENT, event.at("instance"), "instance belongs to a fault of the ADC")
        if event.reboot is False:
            say(SCENARIO_EVENT, event.at("reboot"), "a reboot that does not happen", "remove the event")
        for key in ("battery", "batteries"):
            if key in event.places and event.swap is None:
                say(SCENARIO_EVENT, event.at(key), f"{key} belongs to a swap")

    def _check_swaps(self, events: Sequence[tuple[Event, EventSpec]]) -> None:
        """Whether each begins after the one before it has ended."""
        ends: dict[str, int] = {}
        for swap, spec in events:
            if isinstance(swap, Swap):
                end_ms = ends.get(swap.program, -1)
                if swap.at_ms <= end_ms:
                    message = f"the swap before it ends at {end_ms / 1000:g} s"
                    self._values.say(SCENARIO_SWAP, spec.at("at"), message)
                ends[swap.program] = max(swap.until_ms, end_ms)


def unknown_scenario(name: str, known: Sequence[str]) -> str:
    """That there is no scenario of that name, with what may have been meant."""
    hint = did_you_mean(name, known)
    return f"there is no scenario {name!r}" + (f"; {hint}" if hint else "")
