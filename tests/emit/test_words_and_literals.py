"""What is said of a vehicle that is not armed, and lists of values in tests, as they are printed."""

from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.failsafe import Sense
from codegen.targets.firmware.failsafes.table import problem
from codegen.targets.firmware.program.main_loop import _has_load
from codegen.targets.firmware.readings.sources import _plausible
from codegen.targets.imports import order
from codegen.targets.naming import class_names, parameter_attribute
from codegen.targets.suite.cases.case import literal_of
from codegen.targets.suite.facts.commands import _is_within

VOLTAGE = SimpleNamespace(called="battery voltage")
LOW: Any = SimpleNamespace(name="low")


@pytest.mark.parametrize(
    ("quantity", "sense", "level", "said"),
    [
        (None, Sense.BELOW, None, ""),
        (None, Sense.BELOW, LOW, "low failsafe"),
        (VOLTAGE, Sense.BELOW, LOW, "low battery voltage failsafe"),
        (VOLTAGE, Sense.UNKNOWN, LOW, "low battery voltage failsafe"),
        (VOLTAGE, Sense.UNKNOWN, None, "battery voltage unknown"),
        (VOLTAGE, Sense.BELOW, None, "below minimum arming battery voltage"),
        (VOLTAGE, Sense.ABOVE, None, "above maximum arming battery voltage"),
    ],
)
def test_why_the_vehicle_is_not_armed(quantity: Any, sense: Sense, level: Any, said: str) -> None:
    """A ground station shows it: it names the level, or which side of the limit the quantity is on."""
    condition: Any = SimpleNamespace(quantity=quantity, sense=sense)
    assert problem(condition, level) == said


@pytest.mark.parametrize(("length", "is_one_line"), [(79, True), (80, False)])
def test_a_list_stands_in_its_line_below_80_characters(length: int, is_one_line: bool) -> None:
    """Its text without brackets; both forms mean the same."""
    values = (*(1,) * 25, 10 ** (length - 76))
    text = literal_of(values)
    assert len(", ".join(map(str, values))) == length
    assert (len(text.splitlines()) == 1) is is_one_line
    assert eval(text) == list(values)  # noqa: S307
    assert literal_of(Fraction(1, 2)) == "0.5"


@pytest.mark.parametrize(
    ("low", "high", "within", "beyond"),
    [(0, 10, (0, 5, 10), (-1, 11)), (None, 10, (-99, 10), (11,)), (0, None, (0, 99), (-1,)), (None, None, (0,), ())],
)
def test_which_values_a_parameter_takes(low: Any, high: Any, within: Any, beyond: Any) -> None:
    """Both ends are values; where one is missing the other one still counts."""
    param: Any = SimpleNamespace(minimum=low, maximum=high)
    assert all(_is_within(param, value) for value in within)
    assert not any(_is_within(param, value) for value in beyond)


@pytest.mark.parametrize(
    ("load", "many", "is_told"),
    [("load_dpct", 1, True), ("load_dpct", 2, False), ("load", 1, False), (None, 1, False)],
)
def test_the_load_is_told_to_a_vehicle_that_asks_for_it(load: str | None, many: int, is_told: bool) -> None:
    """In the form in which it is counted, where there is one vehicle to tell it to."""
    found = None if load is None else SimpleNamespace(attribute=load)
    system: Any = SimpleNamespace(
        quantity={"vehicle.load": found}.get, components={"vehicle": SimpleNamespace(instances=many)}
    )
    assert _has_load(system) is is_told


def test_each_message_has_a_class_of_its_own() -> None:
    """Its name is one of Python, no word of the language, not that of the base class and nobody else's."""
    names = class_names(["HEARTBEAT", "GPS_RAW_INT", "MESSAGE", "NONE", "_3D", "A__B", "A_B", "A_B_"])
    assert [*names.values()] == ["Heartbeat", "GpsRawInt", "Message_", "None_", "_3d", "AB", "AB_", "AB__"]


@pytest.mark.parametrize(
    ("name", "attribute"),
    [
        ("BATT_LOW_VOLT", "batt_low_volt"),
        ("CLASS", "class_"),
        ("GET", "get_"),
        ("VALUE", "value_"),
        ("VALUES", "values"),
    ],
)
def test_a_parameter_has_an_attribute_that_is_nothing_else(name: str, attribute: str) -> None:
    assert parameter_attribute(name) == attribute


def test_imports_are_in_the_order_of_the_linter() -> None:
    """Constants, then classes, then functions."""
    names = ["zone", "_private", "Zone", "A", "AT", "Link", "accept", "ZONE_1"]
    assert sorted(names, key=order) == ["A", "AT", "ZONE_1", "Link", "Zone", "_private", "accept", "zone"]


@pytest.mark.parametrize(
    ("low", "high", "taken"),
    [(-5, 5, (-5, 5)), (-SMALL_INT_MAX, SMALL_INT_MAX, (-SMALL_INT_MAX, SMALL_INT_MAX)), (0, SMALL_INT_MAX, (0, 9))],
)
def test_what_a_sensor_may_give(low: int, high: int, taken: tuple[int, ...]) -> None:
    """All within its limits; where every number is within them only the one that means unknown is none."""
    unknown = -SMALL_INT_MAX - 1
    output: Any = SimpleNamespace(low=low, high=high)
    text = _plausible(output, keeps_limits=True)
    assert all(eval(text, {"value": value, "_UNKNOWN": unknown}) for value in taken)  # noqa: S307
    assert not eval(text, {"value": unknown, "_UNKNOWN": unknown})  # noqa: S307
    assert ("_UNKNOWN" in text) is (low == -SMALL_INT_MAX)
