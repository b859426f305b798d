"""Resolves the expectations of a scenario: the quantity, the time and the bounds of each."""

from collections.abc import Sequence
from fractions import Fraction

from codegen.diagnostics import Rule
from codegen.model.quantities.precision import Precision, kept_with
from codegen.model.scenario import Expectation, Truth
from codegen.model.spec.scenario import ExpectSpec
from codegen.model.system import System
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.resolve.scenarios.courses import Courses
from codegen.resolve.scenarios.values import SCENARIO_TIME, UNKNOWN, ScenarioValues
from codegen.source import Place

SCENARIO_EXPECT = Rule(
    "scenario-expect",
    "What is expected of a quantity is either is, one value, or between, the least and the largest; what is expected "
    "of a text has neither. A list cannot be expected, and told is a number that some message carries.",
)


class Expectations:
    """Reads what one scenario expects of the vehicle's own program."""

    def __init__(
        self, courses: Courses, values: ScenarioValues, duration_ms: int | None, system: System | None
    ) -> None:
        """Report through ``values``; ``courses`` know the quantities."""
        self._courses = courses
        self._values = values
        self._duration_ms = duration_ms
        self._system = system

    def read(self, written: Sequence[ExpectSpec]) -> tuple[Expectation, ...]:
        """Return the expectations without errors."""
        found = [self._expectation(spec) for spec in written]
        return tuple(expectation for expectation in found if expectation is not None)

    def _expectation(self, spec: ExpectSpec) -> Expectation | None:
        at_ms = self._at_ms(spec)
        key = next(name for name in ("state", "told", "text", "no_text") if getattr(spec, name) is not None)
        subject: str = getattr(spec, key)
        has_bounds = "between" in spec.places
        when = f" at {spec.at_}" if spec.at_ else " at the end"
        if key in ("text", "no_text"):
            if spec.is_ is not None or has_bounds:
                self._values.say(
                    SCENARIO_EXPECT,
                    spec.at("is" if spec.is_ else "between"),
                    "a text is said, or not",
                    hint="leave is and between out",
                )
            by = f" by {spec.at_}" if spec.at_ else ""
            what = f"{'no ' if key == 'no_text' else 'a '}text with {subject!r}{by}"
            return Expectation(what, at_ms, text=subject, is_absent=key == "no_text")
        found = self._courses.subject(subject, spec.at(key))
        if (spec.is_ is None) is not has_bounds:
            self._values.say(
                SCENARIO_EXPECT,
                spec.place,
                "exactly one of is and between is wanted",
                hint="write is: 12.6 V, or between: [12 V, 13 V]",
            )
            return None
        if found is None:
            return None
        label, quantity, _ = found
        if not self._can_be(quantity, spec.at(key), told=key == "told"):
            return None
        what = f"{key} {label} {{}}{when}"
        if spec.is_ is not None:
            value = self._value(spec, quantity)
            words = what.format(f"is {spec.is_}")
            if value is None:
                return None
            return Expectation(words, at_ms, label, key == "told", value=value[0], precision=_precision(quantity))
        bounds = self._bounds(spec, quantity)
        if bounds is None:
            return None
        words = what.format(f"between {spec.between[0]} and {spec.between[1]}")
        return Expectation(words, at_ms, label, key == "told", *bounds, precision=_precision(quantity))

    def _value(self, spec: ExpectSpec, quantity: Quantity) -> tuple[Truth | Fraction] | None:
        """The value that it has to be, alone in a tuple; None after an error."""
        assert spec.is_ is not None
        if quantity.kind is not QuantityKind.NUMBER or spec.is_ == UNKNOWN:
            return self._values.truth(spec.is_, quantity, spec.at("is"))
        exact = self._values.exact(spec.is_, quantity, spec.at("is"))
        return None if exact is None else (exact,)

    def _at_ms(self, spec: ExpectSpec) -> int | None:
        if spec.at_ is None:
            return None
        at_ms = self._values.milliseconds(spec.at_, spec.at("at"), 0)
        if at_ms is not None and self._duration_ms is not None and at_ms > self._duration_ms:
            self._values.say(
                SCENARIO_TIME,
                spec.at("at"),
                f"{spec.at_} lies after the end",
                hint="expect it earlier, or give the scenario a longer duration",
            )
        return at_ms

    def _can_be(self, quantity: Quantity, place: Place, *, told: bool) -> bool:
        """Return whether the quantity can be looked at, with a finding where not."""
        if quantity.elements is not None:
            self._values.say(
                SCENARIO_EXPECT,
                place,
                f"{quantity.path} is a list",
                hint="expect a single quantity, such as the lowest of the list",
            )
            return False
        if told and not self._is_told(quantity):
            what = f"no message carries {quantity.path} as a number, of an instance that is known"
            self._values.say(SCENARIO_EXPECT, place, what, "write state:")
            return False
        return True

    def _is_told(self, quantity: Quantity) -> bool:
        assert self._system is not None
        return any(
            told.path == quantity.path
            for message in self._system.messages
            if message.tells_of(quantity.component)
            for answer in message.answers
            for told in answer.told_quantities
        )

    def _bounds(self, spec: ExpectSpec, quantity: Quantity) -> tuple[Fraction, Fraction] | None:
        if quantity.kind is not QuantityKind.NUMBER or len(spec.between) != 2:
            self._values.say(
                SCENARIO_EXPECT,
                spec.at("between"),
                "between has the least and the largest number",
                hint="write between: [12 V, 13 V], or is: and what is no number",
            )
            return None
        low, high = (
            self._values.exact(text, quantity, spec.places.get(f"between[{index}]", spec.at("between")))
            for index, text in enumerate(spec.between)
        )
        if low is None or high is None:
            return None
        if low > high:
            self._values.say(
                SCENARIO_EXPECT, spec.at("between"), f"{spec.between[0]} is above {spec.between[1]}", hint="swap them"
            )
        return low, high


def _precision(quantity: Quantity) -> Precision:
    """The precision of the state; entries of an enum, texts and booleans have none."""
    if quantity.kind is not QuantityKind.NUMBER:
        return Precision()
    return kept_with(quantity.storage, quantity.steps)
