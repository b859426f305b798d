"""Thresholds and times of failsafes: parameters, or amounts."""

from collections.abc import Mapping
from fractions import Fraction

from codegen.diagnostics import Report
from codegen.measure import read_amount
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.dialect.literals import exact_number
from codegen.model.failsafe import Setting
from codegen.model.spec.spec import ParametersSpec
from codegen.model.units.unit import NUMBER, ratio, unit_named
from codegen.model.vehicle import Component, Parameter, Quantity
from codegen.pattern import pattern
from codegen.resolve.failsafes.finding import BAD_FAILSAFE
from codegen.resolve.families import is_single
from codegen.resolve.in_force import check_at_once
from codegen.resolve.vehicle import find_parameter
from codegen.source import Place

LONGEST_MS = 4 * 3600 * 1000
"""The longest time that a condition has to hold: the firmware does not count much further."""


class SettingReader:
    """Reads them for the failsafes of a project."""

    def __init__(self, written: ParametersSpec, parameters: Mapping[str, Parameter], report: Report) -> None:
        self._written = written
        self._parameters = parameters
        self._report = report

    def parameter(self, name: str, place: Place, component: Component | None) -> Parameter | None:
        """A parameter that counts at once, one for all or one of a family of the component; None after a finding."""
        found = self._parameter(name, place, component)
        if found is not None:
            self._follow(found, place)
        return found

    def _follow(self, parameter: Parameter, place: Place) -> None:
        check_at_once(parameter, "a failsafe", BAD_FAILSAFE, place, self._report)

    def _parameter(self, name: str, place: Place, component: Component | None) -> Parameter | None:
        found = find_parameter(name, place, self._written, self._parameters, self._report)
        if found is not None and (component is None or found.component != component.name):
            return found if is_single(found, place, self._report) else None
        return found

    def threshold(self, text: str, place: Place, quantity: Quantity, component: Component) -> Setting | None:
        """Return what a quantity is compared with, in its stored units."""
        if not _is_parameter(text):
            count = self.amount(text, place, quantity)
            return None if count is None else Setting(None, count, quantity.stored)
        parameter = self._parameter(text, place, component)
        if parameter is None:
            return None
        steps = ratio(parameter.unit, quantity.stored)
        steps = None if steps is None else steps * parameter.step
        if steps is None or steps.denominator != 1:
            message = f"{parameter.name} is no threshold for {quantity.path}: in whole {quantity.stored.name}"
            hint = f"declare {parameter.name} in such a unit, with a step of whole {quantity.stored.name or 'numbers'}"
            self._report.add(BAD_FAILSAFE, place, message, hint)
            return None
        if max(-parameter.minimum, parameter.maximum) * steps > SMALL_INT_MAX:
            message = f"{parameter.name} goes to more {quantity.stored.name} than can be compared"
            self._report.add(BAD_FAILSAFE, place, message, "narrow its range")
            return None
        self._follow(parameter, place)
        return Setting(parameter, int(steps), quantity.stored)

    def difference(self, text: str, place: Place, quantity: Quantity) -> int | None:
        """A difference of at least 0 between two values of a quantity, in its stored units; None after a finding."""
        return self.amount(text, place, quantity, is_difference=True)

    def amount(self, text: str, place: Place, quantity: Quantity, *, is_difference: bool = False) -> int | None:
        """An amount in whole stored units of a quantity; None after a finding."""
        value = exact_number(text) if quantity.unit.dimension == NUMBER.dimension else None
        if value is None:
            value = read_amount(text, quantity.unit, place, self._report, is_difference=is_difference)
        if value is None:
            return None
        steps: Fraction = value * quantity.steps
        if steps.denominator != 1:
            message = f"{text} is not in whole {quantity.stored.name or 'numbers'}, in which {quantity.path} is kept"
            self._report.add(BAD_FAILSAFE, place, message, "give stored: a finer unit in state.yaml")
            return None
        if abs(steps) > SMALL_INT_MAX or (is_difference and steps < 0):
            self._report.add(
                BAD_FAILSAFE,
                place,
                f"{text} is nothing to compare {quantity.path} with",
                hint="write less; a difference is 0 or more"
                if is_difference
                else "write an amount that the quantity can have",
            )
            return None
        return int(steps)

    def time(self, text: str | None, place: Place, component: Component | None) -> Setting | None:
        """A time in ms, None where there is none, or after a finding."""
        if text is None:
            return None
        unit = unit_named("ms")
        if not _is_parameter(text):
            time = read_amount(text, unit, place, self._report)
            if time is None:
                return None
            if time.denominator != 1 or not 0 <= time <= LONGEST_MS:
                self._report.add(
                    BAD_FAILSAFE,
                    place,
                    f"{text} is not a time of whole ms, at most four hours",
                    hint="write a time such as 500 ms or 5 s",
                )
                return None
            return Setting(None, int(time), unit)
        parameter = self._parameter(text, place, component)
        if parameter is None:
            return None
        steps = ratio(parameter.unit, unit)
        steps = None if steps is None else steps * parameter.step
        if steps is None or steps.denominator != 1 or parameter.minimum < 0 or parameter.maximum * steps > LONGEST_MS:
            message = f"{parameter.name} is not a time in whole milliseconds, from 0 to at most four hours"
            hint = f"declare {parameter.name} with unit: s, step: 1, min: 0 and max: 14400 at most"
            self._report.add(BAD_FAILSAFE, place, message, hint)
            return None
        self._follow(parameter, place)
        return Setting(parameter, int(steps), unit)


def _is_parameter(text: str) -> bool:
    return pattern(r"[A-Z][A-Z0-9_]*").fullmatch(text) is not None
