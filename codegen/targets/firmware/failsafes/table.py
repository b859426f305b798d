"""Tables of failsafe.py: the conditions, levels and pairs of levels of each failsafe, as lines of tuples."""

import re
from collections.abc import Iterable, Sequence

from codegen.frozen import dataclass
from codegen.model.failsafe import Condition, Failsafe, FailsafeLevel, Sense, Setting
from codegen.model.vehicle import Parameter
from codegen.targets.firmware.words import Layout
from codegen.targets.naming import parameter_attribute, quoted

COLUMNS = ("PLACE", "LEVEL", "SIGN", "LIMIT", "FACTOR", "OFF", "FLOOR", "SLACK", "AFTER", "MS", "WHY", "ACTION")
"""The columns of a condition. FLOOR: values above it are believed, SLACK: the hysteresis, WHY: the reason not to arm,
ACTION: the action of its level.
"""

_TAKEN = {*COLUMNS, "NOT", "UNKNOWN", "UP", "DUE", "WORST", "HEAD", "ROW", "ARMED", "HEALTH"}
"""The constants of the module: a failsafe with the name of one has its own behind it."""

Row = dict[str, str]
"""The literals of a condition by its columns."""

_LOOKED_UP = ("LEVEL", "WHY", "ACTION")
"""The columns that a row always has: they are looked for by the level."""

_NAME = re.compile(r"\b_[A-Z]+\b")
"""A constant in a statement."""

_SIGNS = {Sense.BELOW: -1, Sense.ABOVE: 1, Sense.UNKNOWN: 0, Sense.SILENT: 0}


def condition_rows(failsafe: Failsafe, layout: Layout, instance: int) -> list[Row]:
    """The conditions for arming, and then those of the levels, as they are for an instance; of columns without a
    meaning for a condition nothing."""
    levels = {id(condition): level for level in failsafe.levels for condition in level.conditions}
    rows = []
    for condition in (*failsafe.to_arm, *failsafe.conditions):
        level, quantity = levels.get(id(condition)), condition.quantity
        row = {"PLACE": "None", "LEVEL": str(level.number if level else 0)}
        if failsafe.can_arm:
            row["WHY"] = quoted(problem(condition, level))
        if quantity is not None:
            row["PLACE"] = str(layout.blocks[quantity.component].offsets[quantity.attribute])
            row["SIGN"] = str(_SIGNS[condition.sense])
        if condition.limit is not None:
            row["LIMIT"], row["FACTOR"] = _setting(condition.limit, instance)
            row["OFF"] = "0" if condition.limit.is_off_at_zero else "None"
            row["SLACK"] = str(condition.hysteresis)
        if level is not None:
            row["AFTER"], row["MS"] = _setting(condition.after, instance)
            row["ACTION"] = _does(level, instance)
        if level is not None and condition.limit is not None:
            floor = failsafe.floor(condition)
            row["FLOOR"] = "_UNKNOWN" if floor is None else str(floor)
        rows.append(row)
    return rows


def table_constant(failsafe: Failsafe) -> str:
    """Return the constant that has the conditions of a failsafe: ``_DEPTH``, ``_LEVEL_FAILSAFE``."""
    name = failsafe.name.upper()
    return f"_{name}_FAILSAFE" if name in _TAKEN else f"_{name}"


@dataclass(frozen=True, slots=True)
class Columns:
    """The columns that the conditions of a module need: ``same`` are those with one value, and no place in a row."""

    rows: tuple[Row, ...]
    same: dict[str, str]

    @staticmethod
    def of(rows: Sequence[Row]) -> "Columns":
        """Return the columns of all conditions of all failsafes."""
        values = {column: {row[column] for row in rows if column in row} for column in COLUMNS}
        shared = {column: next(iter(found)) for column, found in values.items() if len(found) == 1}
        # A name stays in the rows: it is looked up by what they have.
        plain = {column: value for column, value in shared.items() if not value.startswith('"')}
        return Columns(tuple(rows), {column: value for column, value in plain.items() if column not in _LOOKED_UP})

    @property
    def kept(self) -> list[str]:
        """The columns of a row."""
        return [column for column in COLUMNS if column not in self.same and any(column in row for row in self.rows)]

    def constants(self, statements: Iterable[str]) -> list[str]:
        """Return the constants: the position of each column in a row, and of the values that all rows have in common
        those that the statements name."""
        said = set(_NAME.findall("\n".join(statements)))
        places = [f"_{column} = const({place})" for place, column in enumerate(self.kept)]
        same = [
            f"_{column} = const({value})  # of all"
            for column, value in self.same.items()
            if _is_number(value) and f"_{column}" in said
        ]
        return [*places, *same]

    def values(self, column: str) -> set[str]:
        """All that a column has."""
        return {row[column] for row in self.rows if column in row}

    def __call__(self, column: str, condition: str = "condition") -> str:
        """The expression for what a condition has."""
        value = self.same.get(column)
        if value is None:
            return f"{condition}[_{column}]"
        return f"_{column}" if _is_number(value) else value

    def printed(self, row: Row) -> str:
        """A row as a tuple."""
        fillers = {"LIMIT": "None", "AFTER": "None", "OFF": "None", "FLOOR": "_UNKNOWN"}
        return f"({', '.join(row.get(column, fillers.get(column, '0')) for column in self.kept)})"


def _is_number(value: str) -> bool:
    return value.removeprefix("-").isdigit()


def _setting(setting: Setting | None, instance: int) -> tuple[str, str]:
    """The literals of a parameter's attribute and of what a step of it is; None and an amount."""
    if setting is None:
        return "None", "0"
    parameter = setting.parameter
    return ("None" if parameter is None else quoted(attribute_of(parameter, instance))), str(setting.count)


def attribute_of(parameter: Parameter, instance: int) -> str:
    """The attribute of a parameter, of a family that of the instance."""
    return parameter_attribute(parameter.siblings[instance] if parameter.siblings else parameter.name)


def problem(condition: Condition, level: FailsafeLevel | None) -> str:
    """Return why the vehicle is not armed while a condition holds, behind the title."""
    if condition.quantity is None:
        return f"{level.name} failsafe" if level else ""
    if level is not None:
        return f"{level.name} {condition.quantity.called} failsafe"
    if condition.sense is Sense.UNKNOWN:
        return f"{condition.quantity.called} unknown"
    beyond = "below minimum" if condition.sense is Sense.BELOW else "above maximum"
    return f"{beyond} arming {condition.quantity.called}"


def _does(level: FailsafeLevel, instance: int) -> str:
    """The literal of a level's action: a parameter's attribute, or a value, 0 for none."""
    action = level.action
    if isinstance(action, Parameter):
        return quoted(attribute_of(action, instance))
    return "0" if action is None else str(action.value)


def inverted_rows(failsafe: Failsafe) -> list[tuple[int, int, str]]:
    """Return what there is for each two levels whose thresholds are parameters: the places of both conditions, and the
    words.

    The firmware looks before arming whether the second is worse than the first; there are none where nothing is armed.
    """
    if not failsafe.can_arm:
        return []
    places = {id(condition): at for at, condition in enumerate((*failsafe.to_arm, *failsafe.conditions))}
    rows: list[tuple[int, int, str]] = []
    for milder, worse in zip(failsafe.levels, failsafe.levels[1:], strict=False):
        for one in milder.conditions:
            for other in worse.conditions:
                if one.sense is not other.sense or one.quantity is not other.quantity or one.quantity is None:
                    continue
                if one.limit and other.limit and one.limit.parameter and other.limit.parameter:
                    sign = ">=" if one.sense is Sense.BELOW else "<="
                    words = f"{one.quantity.called} failsafe {worse.name} {sign} {milder.name}"
                    rows.append((places[id(one)], places[id(other)], quoted(words)))
    return rows


def table_lines(constant: str, by_instance: Sequence[Sequence[str]], *, is_shared: bool = False) -> Iterable[str]:
    """A constant with the rows of each instance, or with the rows alone where it is for all."""
    if is_shared:
        yield f"{constant} = ("
        yield from (f"    {row}," for row in by_instance[0])
        yield ")"
        return
    yield f"{constant} = ("
    for rows in by_instance:
        yield "    ("
        yield from (f"        {row}," for row in rows)
        yield "    ),"
    yield ")"
