"""The amounts of a scenario as whole milliseconds, millivolts and milliamperes."""

from collections.abc import Callable
from fractions import Fraction

from codegen.diagnostics import Report, Rule
from codegen.measure import DAY_S, read_amount
from codegen.model.scenario import Battery, Point
from codegen.model.scenario_spec import BatterySpec, Points
from codegen.model.unit import unit_named
from codegen.source import Place

SCENARIO_POINTS = Rule(
    "scenario-points",
    "The voltage of a scenario is one voltage, or points of a time and a voltage, [5 s, 12.6 V], whose times do not go "
    "back. The battery has 0 V to 100 V. Its current is written alike, from -1000 A to 1000 A.",
)
SCENARIO_TIME = Rule(
    "scenario-time",
    "The times of a scenario are whole milliseconds from 0 to a day; its duration, and how long a fault lasts, are "
    "above 0. What happens after the end never happens.",
)
SCENARIO_BATTERY = Rule("scenario-battery", "A divider is above 0 and at most 1000, and noise is 0 V to 10 V.")

LARGEST_MV = 100_000
LARGEST_MA = 1_000_000


class ScenarioValues:
    """Reads what one scenario states; ``is_good`` falls with the first error."""

    def __init__(self, report: Report) -> None:
        """Report to ``report``."""
        self._report = report
        self.is_good = True

    def battery(self, spec: BatterySpec, divider: Fraction) -> Battery | None:
        """A battery; ``divider`` is that of one that states none. None after an error."""
        points = self._course(spec.voltage, spec, "voltage", self._millivolts, "12.6 V")
        currents = (
            [] if spec.current is None else self._course(spec.current, spec, "current", self._milliamperes, "2 A")
        )
        noise_mv = self._noise(spec)
        divider = divider if spec.divider is None else spec.divider
        if not 0 < divider <= 1000:
            self.say(SCENARIO_BATTERY, spec.at("divider"), "a divider is above 0 and at most 1000")
        if not points:
            return None
        return Battery(tuple(points), noise_mv, round(divider * 1_000_000), tuple(currents))

    def milliseconds(self, text: str, place: Place, least: int) -> int | None:
        """A time of whole ms, at least ``least``; None after an error."""
        time = self.amount(text, "ms", place)
        if time is None:
            return None
        if not least <= time <= DAY_S * 1000 or time.denominator != 1:
            self.say(SCENARIO_TIME, place, f"{text} is not a time of whole ms, from {least} ms to a day")
            return None
        return int(time)

    def amount(self, text: str, unit: str, place: Place) -> Fraction | None:
        """An amount in a unit; None after an error."""
        value = read_amount(text, unit_named(unit), place, self._report)
        if value is None:
            self.is_good = False
        return value

    def say(self, rule: Rule, place: Place, message: str, hint: str | None = None) -> None:
        """Report an error."""
        self.is_good = False
        self._report.add(rule, place, message, hint)

    def _course(
        self,
        written: str | Points,
        spec: BatterySpec,
        key: str,
        read: Callable[[str, Place], int | None],
        example: str,
    ) -> list[Point]:
        """The points of a voltage or a current, those with errors left out."""
        place = spec.at(key)
        if isinstance(written, str):
            value = read(written, place)
            return [] if value is None else [Point(0, value)]
        if not written and f"{key}[0]" not in spec.places:  # else its points were wrong, which has been said
            self.say(SCENARIO_POINTS, place, f"{key} has no point", f"write [[0 s, {example}]]")
        points: list[Point] = []
        for index, pair in enumerate(written):
            at = spec.at(f"{key}[{index}]")
            if len(pair) != 2:
                self.say(SCENARIO_POINTS, at, f"a point is a time and a {key}", f"write [5 s, {example}]")
                continue
            inner = [spec.places.get(f"{key}[{index}][{part}]", at) for part in (0, 1)]
            at_ms = self.milliseconds(pair[0], inner[0], 0)
            value = read(pair[1], inner[1])
            if at_ms is None or value is None:
                continue
            if points and at_ms < points[-1].at_ms:
                self.say(SCENARIO_POINTS, inner[0], f"{pair[0]} lies before the point in front of it")
            points.append(Point(at_ms, value))
        return points

    def _noise(self, spec: BatterySpec) -> int:
        if spec.noise is None:
            return 0
        noise = self.amount(spec.noise, "mV", spec.at("noise"))
        if noise is not None and not 0 <= noise <= 10_000:
            self.say(SCENARIO_BATTERY, spec.at("noise"), f"{spec.noise} is not from 0 V to 10 V")
        return round(noise or 0)

    def _millivolts(self, text: str, place: Place) -> int | None:
        voltage = self.amount(text, "mV", place)
        if voltage is None:
            return None
        if not 0 <= voltage <= LARGEST_MV:
            self.say(SCENARIO_POINTS, place, f"{text} is not from 0 V to {LARGEST_MV // 1000} V")
            return None
        return round(voltage)

    def _milliamperes(self, text: str, place: Place) -> int | None:
        current = self.amount(text, "mA", place)
        if current is None:
            return None
        if not -LARGEST_MA <= current <= LARGEST_MA:
            most = LARGEST_MA // 1000
            self.say(SCENARIO_POINTS, place, f"{text} is not from -{most} A to {most} A")
            return None
        return round(current)
