"""Statements of failsafe.py: what all conditions or failsafes have alike is written down, the rest is looked up."""

from fractions import Fraction
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.model.failsafe import Sense
from codegen.targets.firmware.failsafes.arguments import Settled
from codegen.targets.firmware.failsafes.condition import (
    after_lines,
    follow_lines,
    guarded,
    inverted,
    limit_lines,
    of_parameter,
)
from codegen.targets.firmware.failsafes.table import Columns, attribute_of, inverted_rows, problem
from codegen.targets.firmware.failsafes.watching import (
    flags,
    watching_lines,
    when_disabled,
    when_off_to_arm,
    while_watching,
)

OWN = "getattr(self._parameters, condition[_LIMIT])"
COMMON = {"SIGN": "-1", "LEVEL": "1", "OFF": "0", "FACTOR": "1", "SLACK": "0"}
BY_PARAMETER = {**COMMON, "LIMIT": '"low_volt"'}
SCALED = {**BY_PARAMETER, "FACTOR": "10"}
AMOUNT = {**COMMON, "LIMIT": "None", "FACTOR": "77", "OFF": "None"}


def columns(*rows: dict[str, str]) -> Columns:
    """The columns of some conditions."""
    return Columns.of(rows)


@pytest.mark.parametrize(
    ("rows", "lines"),
    [
        ([BY_PARAMETER], [f"limit = {OWN}", "if limit == _OFF:  # switched off", "    return None"]),
        ([SCALED], [f"limit = {OWN} * _FACTOR", "if limit == _OFF:  # switched off", "    return None"]),
        ([SCALED, BY_PARAMETER],
         [f"limit = {OWN} * condition[_FACTOR]", "if limit == _OFF:  # switched off", "    return None"]),
        ([AMOUNT], ["limit = _FACTOR"]),
        ([AMOUNT, BY_PARAMETER],
         ["limit = condition[_FACTOR]", "if condition[_LIMIT] is not None:", f"    limit *= {OWN}",
          "    if limit == condition[_OFF]:  # switched off", "        return None"]),
        ([{**AMOUNT, "SLACK": "5"}],
         ["limit = _FACTOR", "if self.level >= condition[_LEVEL]:  # it is over once the value is better by so much",
          "    limit -= _SIGN * _SLACK"]),
    ],
)  # fmt: skip
def test_what_a_value_is_compared_with(rows: Any, lines: list[str]) -> None:
    assert list(limit_lines(columns(*rows))) == lines


@pytest.mark.parametrize(
    ("rows", "lines"),
    [
        ([{"AFTER": "None", "MS": "500"}], []),
        ([{"AFTER": '"timer"', "MS": "1000"}],
         ["return getattr(self._parameters, condition[_AFTER]) * _MS or _NOT  # 0 switches it off"]),
        ([{"AFTER": '"timer"', "MS": "1000"}, {"AFTER": "None", "MS": "500"}],
         ["if condition[_AFTER] is None:", "    return condition[_MS]",
          "return getattr(self._parameters, condition[_AFTER]) * condition[_MS] or _NOT  # 0 switches it off"]),
    ],
)  # fmt: skip
def test_for_how_long_it_has_to_hold(rows: Any, lines: list[str]) -> None:
    assert list(after_lines(columns(*rows))) == lines


@pytest.mark.parametrize(
    ("rows", "expression"),
    [
        ([{"OFF": "0", "SIGN": "-1"}], "0 < first <= second"),
        ([{"OFF": "0", "SIGN": "1"}, {"OFF": "0", "SIGN": "0"}], "0 < second <= first"),
        ([{"OFF": "None", "SIGN": "1"}, {"OFF": "None", "SIGN": "-1"}], "(second - first) * worse[_SIGN] <= 0"),
        ([{"OFF": "0", "SIGN": "1"}, {"OFF": "None", "SIGN": "-1"}],
         "first != milder[_OFF] and second != worse[_OFF] and (second - first) * worse[_SIGN] <= 0"),
    ],
)  # fmt: skip
def test_whether_the_worse_threshold_is_no_worse(rows: Any, expression: str) -> None:
    assert inverted(columns(*rows)) == expression


def test_the_threshold_of_another_condition() -> None:
    assert of_parameter(columns(BY_PARAMETER), "worse") == "getattr(self._parameters, worse[_LIMIT])"
    assert of_parameter(columns(SCALED), "worse") == "getattr(self._parameters, worse[_LIMIT]) * _FACTOR"


ROW = {"PLACE": "3", "SIGN": "1", "AFTER": "None", "MS": "500", "LEVEL": "1", "FLOOR": "_UNKNOWN"}
OTHER = {**ROW, "PLACE": "4", "SIGN": "-1", "AFTER": '"timer"', "MS": "1000"}
FIRST = ["rows[at + _ROW_AFTER] = _MS", "rows[at + _ROW_LEVEL] = condition[_LEVEL]"]
LAST = ["rows[at + _ROW_LIMIT] = limit or 0", "rows[at + _ROW_FLOOR] = _UNKNOWN"]
SILENT = "    rows[at + _ROW_SENSE] = 3  # nobody is heard"


@pytest.mark.parametrize(
    ("rows", "has_silence", "has_unknown", "lines"),
    [
        ([ROW], False, False,
         [*FIRST, "rows[at] = _PLACE", "limit = self._limit(condition)",
          "rows[at + _ROW_SENSE] = 0 if limit is None else 1", *LAST]),
        ([ROW, OTHER], False, True,
         ["rows[at + _ROW_AFTER] = self._after_ms(condition)", FIRST[1], "rows[at] = condition[_PLACE]",
          "if condition[_SIGN] == 0:", "    rows[at + _ROW_SENSE] = 2  # unknown", "    continue",
          "limit = self._limit(condition)", "rows[at + _ROW_SENSE] = 0 if limit is None else condition[_SIGN]", *LAST]),
        ([{**ROW, "SIGN": "0"}], False, True, [*FIRST, "rows[at] = _PLACE", "rows[at + _ROW_SENSE] = 2  # unknown"]),
        ([{**ROW, "PLACE": "None"}], True, False, [*FIRST, SILENT.strip()]),
        ([ROW, {**ROW, "PLACE": "None"}], True, False,
         [*FIRST, "if condition[_PLACE] is None:", SILENT, "    continue", "rows[at] = condition[_PLACE]",
          "limit = self._limit(condition)", "rows[at + _ROW_SENSE] = 0 if limit is None else 1", *LAST]),
    ],
)  # fmt: skip
def test_the_row_of_a_condition(rows: Any, has_silence: bool, has_unknown: bool, lines: list[str]) -> None:
    assert list(follow_lines(columns(*rows), has_silence=has_silence, has_unknown=has_unknown)) == lines


def settled(kept: tuple[str, ...] = (), **same: str) -> Settled:
    """Arguments: those that each failsafe has for itself, and those that are the same in all."""
    return Settled((*kept, *same), same, {})


ENABLED = 'getattr(self._parameters, "enabled") == 0'
SOME = "(self._enabled_by is not None and getattr(self._parameters, self._enabled_by) == 0)"


@pytest.mark.parametrize(
    ("found", "disabled", "to_arm", "watching"),
    [
        (settled(), "", "", "self._vehicle_words[_ARMED]"),
        (settled(is_always="True"), "", "", ""),
        (settled(("is_always",)), "", "", "(self._is_always or self._vehicle_words[_ARMED])"),
        (settled(is_always="True", enabled_by='"enabled"'), ENABLED, ENABLED, ENABLED.replace("==", "!=")),
        (settled(enabled_by='"enabled"', switch_at="5"), ENABLED, f"(not self._words[_SWITCH_AT]) or {ENABLED}",
         f"self._vehicle_words[_ARMED] and {ENABLED.replace('==', '!=')}"),
        (settled(("enabled_by",)), SOME, SOME[1:-1], f"self._vehicle_words[_ARMED] and not {SOME}"),
        (settled(("switch_at",)), "", "self._switch_at is not None and not self._words[self._switch_at]",
         "self._vehicle_words[_ARMED]"),
    ],
)  # fmt: skip
def test_when_a_failsafe_is_off(found: Settled, disabled: str, to_arm: str, watching: str) -> None:
    """By its parameter, by the switch of its component, and while the vehicle is disarmed."""
    assert (when_disabled(found), when_off_to_arm(found), while_watching(found)) == (disabled, to_arm, watching)
    *before, last = watching_lines(found)
    assert before == (
        [f"if {disabled.strip('()') if disabled == SOME else disabled}:", "    return False"] if disabled else []
    )
    armed = "self._vehicle_words[_ARMED]"
    known = {True: "return True", False: f"return {armed}"}[found.is_same("is_always")]
    assert last == (f"return self._is_always or {armed}" if found.only_some("is_always") else known)


@pytest.mark.parametrize(
    ("watching", "has_silence", "expression"),
    [
        ("", False, "1"),
        ("armed", False, "1 if armed else 0"),
        ("", True, "3 if self._is_silent else 1"),
        ("armed", True, "(1 if armed else 0) | (2 if self._is_silent else 0)"),
    ],
)
def test_what_watch_is_told(watching: str, has_silence: bool, expression: str) -> None:
    assert flags(watching, has_silence=has_silence) == expression


def test_a_place_that_some_lack_is_asked_for_first() -> None:
    assert guarded(True, "at", "words[at]") == "at is not None and words[at]"
    assert guarded(False, "at", "words[at]") == "words[at]"


VOLTAGE: Any = SimpleNamespace(called="voltage")
LOW: Any = SimpleNamespace(name="low")


@pytest.mark.parametrize(
    ("quantity", "sense", "level", "words"),
    [
        (None, Sense.SILENT, LOW, "low failsafe"),
        (None, Sense.SILENT, None, ""),
        (VOLTAGE, Sense.BELOW, LOW, "low voltage failsafe"),
        (VOLTAGE, Sense.UNKNOWN, LOW, "low voltage failsafe"),
        (VOLTAGE, Sense.UNKNOWN, None, "voltage unknown"),
        (VOLTAGE, Sense.BELOW, None, "below minimum arming voltage"),
        (VOLTAGE, Sense.ABOVE, None, "above maximum arming voltage"),
    ],
)
def test_why_a_vehicle_is_not_armed(quantity: Any, sense: Sense, level: Any, words: str) -> None:
    condition: Any = SimpleNamespace(quantity=quantity, sense=sense)
    assert problem(condition, level) == words


def test_each_instance_has_its_parameter() -> None:
    family: Any = SimpleNamespace(name="BATT_LOW", siblings=("BATT_LOW", "BATT2_LOW"))
    alone: Any = SimpleNamespace(name="FS_GCS", siblings=())
    assert [attribute_of(family, 0), attribute_of(family, 1), attribute_of(alone, 1)] == [
        "batt_low",
        "batt2_low",
        "fs_gcs",
    ]


def condition(quantity: Any, sense: Sense, parameter: str | None) -> Any:
    limit = SimpleNamespace(parameter=parameter, count=Fraction(1))
    return SimpleNamespace(quantity=quantity, sense=sense, limit=limit)


def test_thresholds_of_neighbouring_levels_are_held_against_each_other() -> None:
    """Of one quantity and sense, where both are parameters; the places are those of the rows."""
    current: Any = SimpleNamespace(called="current")
    arm = condition(VOLTAGE, Sense.BELOW, "ARM")
    low = [condition(VOLTAGE, Sense.BELOW, "LOW"), condition(current, Sense.ABOVE, "HIGH")]
    critical = [
        condition(current, Sense.ABOVE, "HIGHER"),
        condition(current, Sense.BELOW, "NONE"),
        condition(VOLTAGE, Sense.BELOW, None),
        condition(VOLTAGE, Sense.BELOW, "LOWER"),
    ]
    levels = [SimpleNamespace(name=name, conditions=held) for name, held in (("low", low), ("critical", critical))]
    conditions = [*low, *critical]
    failsafe: Any = SimpleNamespace(to_arm=[arm], conditions=conditions, levels=levels, can_arm=True)
    assert inverted_rows(failsafe) == [
        (1, 6, '"voltage failsafe critical >= low"'),
        (2, 3, '"current failsafe critical <= low"'),
    ]
