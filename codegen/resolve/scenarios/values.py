"""The amounts of a scenario: times in whole milliseconds, and what is true of a quantity in its unit."""

import sys
from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.measure import DAY_S, read_amount, read_exactly
from codegen.model.dialect.dialect import EnumDefinition
from codegen.model.dialect.literals import exact_number
from codegen.model.scenario import Truth
from codegen.model.units.unit import unit_named
from codegen.model.vehicle import Quantity, QuantityKind
from codegen.source import Place

SCENARIO_POINTS = Rule(
    "scenario-points",
    "A course is one value, or points of a time and a value, [5 s, 12.6 V], whose times do not go back. A value is an "
    "amount in a unit that fits the quantity, a number where it has no unit, an entry of its enum, true or false, a "
    "text, or unknown. Noise is from 0 on, and that of a number.",
    remedy="write an entry that the enum has in the dialect, or unknown",
)
SCENARIO_TIME = Rule(
    "scenario-time",
    "The times of a scenario are whole milliseconds from 0 to a day; its duration, and how long a fault lasts, are "
    "above 0. What happens after the end never happens.",
)
UNKNOWN = "unknown"
_LARGEST = Fraction(sys.float_info.max)
_WHOLE_FLOATS = 2**53
"""Up to which a float is any whole number."""


class ScenarioValues:
    """Reads what one scenario states; ``is_good`` falls with the first error."""

    def __init__(self, report: Report, enums: Mapping[str, EnumDefinition]) -> None:
        """Report to ``report``; ``enums`` are those of the dialect."""
        self.report = report
        self.enums = enums
        self.is_good = True

    def milliseconds(self, text: str, place: Place, least: int) -> int | None:
        """A time of whole ms, at least ``least``; None after an error."""
        time = self.amount(text, "ms", place)
        if time is None:
            return None
        if not least <= time <= DAY_S * 1000 or time.denominator != 1:
            self.say(
                SCENARIO_TIME,
                place,
                f"{text} is not a time of whole ms, from {least} ms to a day",
                hint="write a time such as 500 ms or 5 s",
            )
            return None
        return int(time)

    def amount(self, text: str, unit: str, place: Place) -> Fraction | None:
        """An amount in a unit; None after an error."""
        value = read_amount(text, unit_named(unit), place, self.report)
        if value is None:
            self.is_good = False
        return value

    def truth(self, text: str, quantity: Quantity, place: Place) -> tuple[Truth] | None:
        """A value of a quantity in its unit, alone in a tuple, as it may be None for unknown; None after an error."""
        if text == UNKNOWN:
            return (None,)
        match quantity.kind:
            case QuantityKind.TEXT:
                return (text,)
            case QuantityKind.BOOLEAN:
                if text in ("true", "false"):
                    return (text == "true",)
                self.say(
                    SCENARIO_POINTS,
                    place,
                    f"{quantity.path} is true or false, not {text!r}",
                    hint="write true, false or unknown",
                )
                return None
            case QuantityKind.ENUM:
                return self._entry(text, quantity, place)
        exact = self.exact(text, quantity, place)
        if exact is None:
            return None
        is_beyond_floats = exact.denominator == 1 and abs(exact) > _WHOLE_FLOATS
        return (int(exact) if is_beyond_floats else float(exact),)

    def number(self, text: str, quantity: Quantity, place: Place) -> float | None:
        """A number in the unit of a quantity; None after an error."""
        exact = self.exact(text, quantity, place)
        return None if exact is None else float(exact)

    def exact(self, text: str, quantity: Quantity, place: Place) -> Fraction | None:
        """The same before it becomes a float, which holds whole numbers of 53 bits; None after an error."""
        if quantity.unit.name:
            value = read_exactly(text, quantity.unit, place, self.report)
            self.is_good = self.is_good and value is not None
            return value
        value = exact_number(text)
        if value is not None and abs(value) <= _LARGEST:
            return value
        message = f"{quantity.path} is a number without a unit, not {text!r}"
        self.say(SCENARIO_POINTS, place, message, "write the number alone")
        return None

    def say(self, rule: Rule, place: Place, message: str, hint: str | None = None) -> None:
        """Report an error."""
        self.is_good = False
        self.report.add(rule, place, message, hint)

    def _entry(self, text: str, quantity: Quantity, place: Place) -> tuple[Truth] | None:
        assert quantity.enum is not None
        entry = quantity.enum.entry(text)
        if entry is None:
            hint = did_you_mean(text, [each.name for each in quantity.enum.entries])
            self.say(SCENARIO_POINTS, place, f"{quantity.enum.name} has no entry {text}", hint)
            return None
        return (entry.value,)
