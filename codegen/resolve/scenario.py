"""Scenarios as they are written into plain numbers."""

from collections.abc import Sequence
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.model.scenario import AdcFault, Arming, Event, Fault, Point, Reboot, Scenario
from codegen.model.scenario_spec import BatterySpec, EventSpec, ScenarioSpec, ScenariosSpec
from codegen.model.unit import UNITS
from codegen.resolve.measure import DAY_S, read_amount
from codegen.source import Place

SCENARIO_POINTS = Rule(
    "scenario-points",
    "The voltage of a scenario is one voltage, or points of a time and a voltage, [5 s, 12.6 V], whose times do not go "
    "back. The battery has 0 V to 100 V.",
)
SCENARIO_TIME = Rule(
    "scenario-time",
    "The times of a scenario are whole milliseconds from 0 to a day; its duration, and how long a fault lasts, are "
    "above 0. What happens after the end never happens.",
)
SCENARIO_EVENT = Rule(
    "scenario-event",
    "An event has a key that it has no use for, or lacks one: for and delay belong to faults of the ADC, a slow ADC "
    "needs a delay of 1 us to 1 s, an absent one is so from the start, and a reboot is not false.",
)
SCENARIO_BATTERY = Rule("scenario-battery", "A divider is above 0 and at most 1000, and noise is 0 V to 10 V.")

LARGEST_MV = 100_000


def resolve_scenarios(spec: ScenariosSpec, divider: Fraction, report: Report) -> dict[str, Scenario]:
    """The scenarios by name, those with errors left out; ``divider`` is that of scenarios that state none."""
    resolved = {name: _Resolver(name, written, divider, report).resolve() for name, written in spec.scenarios.items()}
    return {name: scenario for name, scenario in resolved.items() if scenario is not None}


class _Resolver:
    """Resolves one scenario; ``_is_good`` falls with the first error."""

    def __init__(self, name: str, spec: ScenarioSpec, divider: Fraction, report: Report) -> None:
        self._name = name
        self._spec = spec
        self._divider = divider
        self._report = report
        self._is_good = True
        self._duration_ms: int | None = None

    def resolve(self) -> Scenario | None:
        spec = self._spec
        self._duration_ms = self._milliseconds(spec.duration, spec.at("duration"), 1)
        points = self._points(spec.battery)
        noise_mv = self._noise(spec.battery)
        divider = self._divider if spec.battery.divider is None else spec.battery.divider
        if not 0 < divider <= 1000:
            self._say(SCENARIO_BATTERY, spec.battery.at("divider"), "a divider is above 0 and at most 1000")
        events = [event for written in spec.events if (event := self._event(written)) is not None]
        if not self._is_good or self._duration_ms is None or not points:
            return None
        return Scenario(
            name=self._name,
            doc=spec.doc,
            duration_ms=self._duration_ms,
            seed=spec.seed,
            points=tuple(points),
            noise_mv=noise_mv,
            divider_millionths=round(divider * 1_000_000),
            events=tuple(sorted(events, key=lambda event: event.at_ms)),
        )

    def _points(self, battery: BatterySpec) -> list[Point]:
        voltage, place = battery.voltage, battery.at("voltage")
        if isinstance(voltage, str):
            millivolts = self._millivolts(voltage, place)
            return [] if millivolts is None else [Point(0, millivolts)]
        if not voltage and "voltage[0]" not in battery.places:  # else its points were wrong, which has been said
            self._say(SCENARIO_POINTS, place, "voltage has no point", "write [[0 s, 12.6 V]]")
        points: list[Point] = []
        for index, pair in enumerate(voltage):
            at = battery.at(f"voltage[{index}]")
            if len(pair) != 2:
                self._say(SCENARIO_POINTS, at, "a point is a time and a voltage", "write [5 s, 12.6 V]")
                continue
            inner = [battery.places.get(f"voltage[{index}][{part}]", at) for part in (0, 1)]
            at_ms = self._milliseconds(pair[0], inner[0], 0)
            millivolts = self._millivolts(pair[1], inner[1])
            if at_ms is None or millivolts is None:
                continue
            if points and at_ms < points[-1].at_ms:
                self._say(SCENARIO_POINTS, inner[0], f"{pair[0]} lies before the point in front of it")
            points.append(Point(at_ms, millivolts))
        return points

    def _noise(self, battery: BatterySpec) -> int:
        if battery.noise is None:
            return 0
        noise = self._amount(battery.noise, "mV", battery.at("noise"))
        if noise is not None and not 0 <= noise <= 10_000:
            self._say(SCENARIO_BATTERY, battery.at("noise"), f"{battery.noise} is not from 0 V to 10 V")
        return round(noise or 0)

    def _event(self, event: EventSpec) -> Event | None:
        at_ms = self._milliseconds(event.at_, event.at("at"), 0)
        for_ms = None if event.for_ is None else self._milliseconds(event.for_, event.at("for"), 1)
        self._check_keys(event)
        delay = None if event.delay is None else self._amount(event.delay, "us", event.at("delay"))
        if delay is not None and not 1 <= delay <= 1_000_000:
            self._say(SCENARIO_EVENT, event.at("delay"), f"{event.delay} is not from 1 us to 1 s")
        if at_ms is None:
            return None
        if self._duration_ms is not None and at_ms > self._duration_ms:
            self._say(SCENARIO_TIME, event.at("at"), f"{event.at_} lies after the end, {self._spec.duration}")
        if event.adc is AdcFault.ABSENT and at_ms != 0:
            self._say(SCENARIO_EVENT, event.at("at"), "an absent ADC is absent from the start", "write at: 0 s")
        if event.arm is not None:
            return Arming(at_ms, event.arm)
        if event.adc is None:
            return Reboot(at_ms)
        return Fault(at_ms, event.adc, None if for_ms is None else at_ms + for_ms, round(delay or 0))

    def _check_keys(self, event: EventSpec) -> None:
        if event.for_ is not None and event.adc is None:
            self._say(SCENARIO_EVENT, event.at("for"), "for belongs to a fault of the ADC")
        if event.delay is not None and event.adc is not AdcFault.SLOW:
            self._say(SCENARIO_EVENT, event.at("delay"), "delay belongs to adc: slow")
        if event.delay is None and event.adc is AdcFault.SLOW:
            self._say(SCENARIO_EVENT, event.at("adc"), "a slow ADC needs a delay", "add delay: 3 ms")
        if event.reboot is False:
            self._say(SCENARIO_EVENT, event.at("reboot"), "a reboot that does not happen", "remove the event")

    def _milliseconds(self, text: str, place: Place, least: int) -> int | None:
        time = self._amount(text, "ms", place)
        if time is None:
            return None
        if not least <= time <= DAY_S * 1000 or time.denominator != 1:
            self._say(SCENARIO_TIME, place, f"{text} is not a time of whole ms, from {least} ms to a day")
            return None
        return int(time)

    def _millivolts(self, text: str, place: Place) -> int | None:
        voltage = self._amount(text, "mV", place)
        if voltage is None:
            return None
        if not 0 <= voltage <= LARGEST_MV:
            self._say(SCENARIO_POINTS, place, f"{text} is not from 0 V to {LARGEST_MV // 1000} V")
            return None
        return round(voltage)

    def _amount(self, text: str, unit: str, place: Place) -> Fraction | None:
        value = read_amount(text, UNITS[unit], place, self._report)
        if value is None:
            self._is_good = False
        return value

    def _say(self, rule: Rule, place: Place, message: str, hint: str | None = None) -> None:
        self._is_good = False
        self._report.add(rule, place, message, hint)


def unknown_scenario(name: str, known: Sequence[str]) -> str:
    """That there is no scenario of that name, with what may have been meant."""
    hint = did_you_mean(name, known)
    return f"there is no scenario {name!r}" + (f"; {hint}" if hint else "")
