"""Scenarios of the simulation, resolved to plain numbers."""

from collections.abc import Mapping
from dataclasses import field
from fractions import Fraction
from typing import Any, TypeGuard

from codegen.frozen import dataclass
from codegen.model.quantities.precision import Precision
from codegen.model.quantities.simulated import SimulatedInput

GROUND_STATION = 255
"""The system id as which a scenario sends."""

Truth = float | bool | str | None
"""The true value of a quantity: a number in its unit, a boolean, a text; None is nothing that could be known."""


@dataclass(frozen=True, slots=True)
class Point:
    """A value at a time in milliseconds since the start."""

    at_ms: int
    value: Truth


@dataclass(frozen=True, slots=True)
class Course:
    """The true values of one quantity over time, ascending in time.

    ``label`` is the path of the quantity with the number of the instance, ``battery[1].voltage``, where there are
    several. Single values deviate by up to ``noise``. Code that sets it does so every ``every_ms``. Between two points
    lies a line where ``is_line``, else a step.
    """

    label: str
    points: tuple[Point, ...]
    through: SimulatedInput
    noise: float = 0.0
    every_ms: int = 100
    is_line: bool = True

    def value(self, at_ms: float) -> Truth:
        """Return what is true at a time in ms: straight lines between two numbers, else steps; the ends stay."""
        before = self.points[0]
        for point in self.points:
            if point.at_ms > at_ms:
                start, end = before.value, point.value
                if at_ms <= before.at_ms or not self.is_line or not is_number(start) or not is_number(end):
                    return start
                return start + (end - start) * (at_ms - before.at_ms) / (point.at_ms - before.at_ms)
            before = point
        return before.value


@dataclass(frozen=True, slots=True)
class Arming:
    """The vehicle is armed, or disarmed."""

    at_ms: int
    is_armed: bool


@dataclass(frozen=True, slots=True)
class Reboot:
    """The vehicle is restarted."""

    at_ms: int


@dataclass(frozen=True, slots=True)
class Fault:
    """A fault of what a course goes through, from ``at_ms`` to ``until_ms`` (None: to the end).

    ``of`` is the label of the course, ``words`` say for people what happens, ``delay_us`` is that of slow readings.
    """

    at_ms: int
    kind: str
    of: str
    until_ms: int | None
    words: str
    delay_us: int = 0


@dataclass(frozen=True, slots=True)
class Swap:
    """A board is taken out, and another one is in its place from ``until_ms`` on.

    ``courses`` are those of the new board; None: the old ones go on.
    """

    at_ms: int
    program: str
    until_ms: int
    courses: tuple[Course, ...] | None = None


@dataclass(frozen=True, slots=True)
class Sending:
    """A ground station sends a message, once, or ``every_ms`` to ``until_ms`` (None: to the end)."""

    at_ms: int
    message: str
    id: int
    crc_extra: int
    payload: bytes
    every_ms: int | None = None
    until_ms: int | None = None


Event = Arming | Reboot | Fault | Swap | Sending


@dataclass(frozen=True, slots=True)
class Stretch:
    """A time in which one board runs a program: to ``end_ms``, or to the end. ``number`` counts the boards from 1."""

    number: int
    start_ms: int
    end_ms: int | None
    courses: tuple[Course, ...]

    def course(self, label: str) -> Course | None:
        """The course of a quantity; None where the scenario states none."""
        return next((course for course in self.courses if course.label == label), None)


@dataclass(frozen=True, slots=True)
class Expectation:
    """A condition that must hold ``at_ms``, or at the end for None.

    ``told``: a quantity as it went out last; else as the state has it, with ``precision``. ``low`` and ``high`` bound a
    number in its unit, ``value`` is what it has to be otherwise, a number exactly. With ``text`` a text that contains
    it has to be said by then, or, if ``is_absent``, must not be said.
    """

    written: str
    at_ms: int | None
    label: str = ""
    told: bool = False
    low: Fraction | None = None
    high: Fraction | None = None
    value: Truth | Fraction = None
    precision: Precision = Precision()
    text: str = ""
    is_absent: bool = False


@dataclass(frozen=True, slots=True)
class Beside:
    """Another program of the project that runs at the same time, and what is true of it."""

    program: str
    courses: tuple[Course, ...]
    parameters: Mapping[str, float] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class Scenario:
    """One scenario in plain numbers: ``parameters`` are stored before the first start.

    ``beside`` are the other programs that run. Without ``has_code`` the user's code is left out.
    """

    name: str
    doc: str
    duration_ms: int
    seed: int
    courses: tuple[Course, ...] = ()
    events: tuple[Event, ...] = ()
    parameters: Mapping[str, float] = field(default_factory=dict)
    beside: tuple[Beside, ...] = ()
    expected: tuple[Expectation, ...] = ()
    has_code: bool = True

    def stretches(self, program: str | None = None) -> tuple[Stretch, ...]:
        """The boards that run a program, one after the other; None is the vehicle's own, which is never swapped."""
        found = next((beside for beside in self.beside if beside.program == program), None)
        courses = self.courses if found is None else found.courses
        swaps = [event for event in self.events if isinstance(event, Swap) and event.program == program]
        stretches: list[Stretch] = []
        start_ms = 0
        for number, swap in enumerate(swaps, 1):
            stretches.append(Stretch(number, start_ms, swap.at_ms, courses))
            courses = courses if swap.courses is None else swap.courses
            start_ms = swap.until_ms
        return (*stretches, Stretch(len(stretches) + 1, start_ms, None, courses))


def is_number(value: Truth) -> TypeGuard[float]:
    """Return whether lines can be drawn to it: it is known, and neither a text nor a boolean."""
    return isinstance(value, float | int) and not isinstance(value, bool)


def course_data(course: Course, seed: int) -> dict[str, Any]:
    """A course as the mocks have it: times in ms; ``seed`` starts its noise."""
    return {
        "label": course.label,
        "kind": course.through.kind,
        "settings": dict(course.through.settings),
        "seed": seed,
        "points": [[point.at_ms, point.value] for point in course.points],
        "noise": course.noise,
        "every_ms": course.every_ms,
        "is_line": course.is_line,
    }


def event_data(event: Event) -> dict[str, Any] | None:
    """An event as the mocks have it: times in ms, delays in us; None for what does not happen on the board itself."""
    match event:
        case Arming():
            return {"at_ms": event.at_ms, "arm": event.is_armed}
        case Reboot():
            return {"at_ms": event.at_ms, "reboot": True}
        case Fault():
            return {
                "at_ms": event.at_ms,
                "fault": event.kind,
                "of": event.of,
                "until_ms": event.until_ms,
                "delay_us": event.delay_us,
            }
        case Sending():
            return {
                "at_ms": event.at_ms,
                "send": event.message,
                "id": event.id,
                "crc_extra": event.crc_extra,
                "payload": event.payload.hex(),
                "every_ms": event.every_ms,
                "until_ms": event.until_ms,
            }
        case Swap():
            return None
