"""The courses of a scenario: which quantity each is about, its points in the unit of that, and the way it takes."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Rule, did_you_mean
from codegen.model.program import VEHICLE_QUANTITIES
from codegen.model.scenario import Course, Point
from codegen.model.spec.scenario import BesideSpec, CourseSpec, EventSpec, ScenarioSpec
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.pattern import pattern
from codegen.resolve.scenarios.board import SCENARIO_PARAMETER
from codegen.resolve.scenarios.values import SCENARIO_POINTS, ScenarioValues
from codegen.source import Place

SCENARIO_COURSE = Rule(
    "scenario-course",
    "A course is that of a quantity of state.yaml, component.quantity, or component[1].quantity for the second "
    "instance. It is measured, or set by code of the vehicle: what the firmware makes of others, and what the program "
    "itself sets, follows by itself.",
    remedy="give a course to what is measured, or what code sets; the rest follows by itself",
)
_LABEL = pattern(r"(\w+)(?:\[([0-9]{1,3})\])?\.(\w+)")
_EVERY_MS = 100


class Courses:
    """Reads the courses of one program; without ``system`` only what needs no knowledge of it is checked."""

    def __init__(self, system: System | None, values: ScenarioValues) -> None:
        """Report through ``values``."""
        self._system = system
        self._values = values

    def read(
        self, source: ScenarioSpec | BesideSpec | EventSpec, parameters: Mapping[str, float]
    ) -> tuple[Course, ...]:
        """The courses in the order of the file, those with errors left out."""
        found: dict[str, Course] = {}
        for written, spec in source.courses.items():
            course = self._course(written, spec, parameters)
            if course is not None and course.label in found:
                self._values.say(
                    SCENARIO_COURSE,
                    spec.place,
                    f"there is another course of {course.label}",
                    hint="leave out one of them",
                )
            elif course is not None:
                found[course.label] = course
        return tuple(found.values())

    def subject(self, written: str, place: Place) -> tuple[str, Quantity, int] | None:
        """The label, the quantity and the instance that a path names; None after an error, or without a system."""
        system = self._system
        match = _LABEL.fullmatch(written)
        if match is None:
            self._values.say(SCENARIO_COURSE, place, f"{written} is no quantity", "write component.quantity")
            return None
        if system is None:
            return None
        quantity = system.quantity(f"{match[1]}.{match[3]}")
        if quantity is None:
            known = [each.path for part in system.components.values() for each in part.quantities.values()]
            hint = did_you_mean(f"{match[1]}.{match[3]}", known)
            self._values.say(SCENARIO_COURSE, place, f"the state has no quantity {match[1]}.{match[3]}", hint)
            return None
        instance, count = int(match[2] or 0), system.components[match[1]].instances
        if instance >= count:
            there = "one" if count == 1 else f"{match[1]}[0] to {match[1]}[{count - 1}]"
            self._values.say(
                SCENARIO_COURSE,
                place,
                f"there is no {match[1]}[{instance}]: there is {there}",
                hint=f"write {match[1]}.{match[3]} for the first one",
            )
            return None
        return quantity_label(quantity, instance), quantity, instance

    def _course(self, written: str, spec: CourseSpec, parameters: Mapping[str, float]) -> Course | None:
        subject = self.subject(written, spec.place)
        wired = self._wired(spec)
        every_ms = self._every_ms(spec)
        if subject is None:
            self._check_times(spec)
            return None
        label, quantity, instance = subject
        assert self._system is not None
        through = quantity.derivation.simulated(quantity, instance, self._system, {**parameters, **wired})
        who = _own(quantity, self._system) or ("" if through else quantity.derivation.words(quantity))
        if quantity.elements is not None:
            who = "it is a list"
        if who or through is None:
            hint = "an event sends the message: send, fields" if quantity.derivation.is_received else None
            self._values.say(SCENARIO_COURSE, spec.place, f"{label} has no course of its own: {who}", hint)
            return None
        points = self._points(spec, quantity)
        noise = self._noise(spec, quantity)
        is_line = quantity.kind is QuantityKind.NUMBER
        return Course(label, points, through, noise, every_ms, is_line) if points else None

    def _points(self, spec: CourseSpec, quantity: Quantity) -> tuple[Point, ...]:
        values = self._values
        if spec.value is not None:
            value = values.truth(spec.value, quantity, spec.at("value"))
            return () if value is None else (Point(0, *value),)
        points: list[Point] = []
        for index, at_ms in enumerate(self._check_times(spec)):
            if at_ms is None:
                continue
            place = spec.places.get(f"points[{index}][1]", spec.at(f"points[{index}]"))
            value = values.truth(spec.points[index][1], quantity, place)
            if value is not None:
                points.append(Point(at_ms, *value))
        return tuple(points)

    def _check_times(self, spec: CourseSpec) -> list[int | None]:
        """The time of each point in ms; None where there is an error."""
        values, found = self._values, list[int | None]()
        if spec.value is None and not spec.points and "points[0]" not in spec.places:
            values.say(SCENARIO_POINTS, spec.at("points"), "there is no point", "write [[0 s, 12.6 V]]")
        last = 0
        for index, pair in enumerate(spec.points):
            at = spec.at(f"points[{index}]")
            if len(pair) != 2:
                values.say(SCENARIO_POINTS, at, "a point is a time and a value", "write [5 s, 12.6 V]")
                found.append(None)
                continue
            place = spec.places.get(f"points[{index}][0]", at)
            at_ms = values.milliseconds(pair[0], place, 0)
            if at_ms is not None and at_ms < last:
                values.say(
                    SCENARIO_POINTS,
                    place,
                    f"{pair[0]} lies before the point in front of it",
                    hint="order the points by their times",
                )
            last = last if at_ms is None else at_ms
            found.append(at_ms)
        return found

    def _noise(self, spec: CourseSpec, quantity: Quantity) -> float:
        if spec.noise is None:
            return 0.0
        place = spec.at("noise")
        if quantity.kind is not QuantityKind.NUMBER:
            self._values.say(
                SCENARIO_POINTS, place, f"{quantity.path} is no number, so it has no noise", hint="leave noise out"
            )
            return 0.0
        text = str(spec.noise)
        noise = self._values.number(text, quantity, place)
        if noise is not None and noise < 0:
            self._values.say(
                SCENARIO_POINTS,
                place,
                f"noise is from 0 on, not {text}",
                hint="write how far readings are off at most, such as 0.02",
            )
        reach = (Fraction(quantity.maximum) - Fraction(quantity.minimum)) / quantity.steps
        if noise is not None and noise > reach:
            most = f"{decimal(reach)} {quantity.unit.name}".rstrip()
            self._values.say(
                SCENARIO_POINTS,
                place,
                f"noise of {text} is more than from the least to the most that {quantity.path} can be",
                hint=f"readings are off by noise at most: write {most} or less",
            )
        return noise or 0.0

    def _every_ms(self, spec: CourseSpec) -> int:
        if spec.rate is None:
            return _EVERY_MS
        rate = self._values.amount(spec.rate, "Hz", spec.at("rate"))
        if rate is not None and not 0 < rate <= 1000:
            self._values.say(
                SCENARIO_POINTS, spec.at("rate"), f"{spec.rate} is not a rate up to 1000 Hz", hint="rate: 10 Hz"
            )
            return _EVERY_MS
        return max(1, round(1000 / rate)) if rate else _EVERY_MS

    def _wired(self, spec: CourseSpec) -> dict[str, float]:
        known = None if self._system is None else self._system.parameters
        for name in spec.wired:
            if known is not None and name not in known:
                place, hint = spec.at(f"wired.{name}"), did_you_mean(name, known)
                self._values.say(SCENARIO_PARAMETER, place, f"there is no parameter {name}", hint)
        return {name: float(value) for name, value in spec.wired.items()}


def quantity_label(quantity: Quantity, instance: int) -> str:
    """``battery.voltage``, and ``battery[1].voltage`` for the second instance, as code writes it."""
    number = f"[{instance}]" if instance else ""
    return f"{quantity.component}{number}.{quantity.name}"


def _own(quantity: Quantity, system: System) -> str:
    """Return why the program itself sets a quantity; nothing where it does not."""
    program = system.program
    if program is None:
        return ""
    if quantity.component == "vehicle" and quantity.name in VEHICLE_QUANTITIES:
        return "the program sets it"
    for failsafe in program.failsafes:
        for name in ("health", "level"):
            own = getattr(failsafe, name, None)
            if isinstance(own, Quantity) and own.path == quantity.path:
                return "the failsafe sets it"
    return ""
