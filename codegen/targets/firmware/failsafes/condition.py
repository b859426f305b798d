"""Conditions of failsafes: the expressions and statements that hold values against the columns of their tables."""

from collections.abc import Iterable

from codegen.targets.firmware.failsafes.table import Columns

_SENSE_UNKNOWN = "2  # unknown"
"""As scan_plain has it."""


def ignored(columns: Columns, *, has_silence: bool, has_unknown: bool) -> str:
    """Return the expression that says whether a condition does not count, as its quantity is unknown."""
    word = f"self._component.words[{columns('PLACE')}]"
    floors = columns.values("FLOOR")
    known = f"{word} == _UNKNOWN" if floors == {"_UNKNOWN"} else f"{word} <= {columns('FLOOR')}"
    if has_unknown:  # where there is silence, too, its conditions have no sign either
        return f"{columns('SIGN')} != 0 and {known}"
    return guarded(has_silence, columns("PLACE"), known)


def limit_lines(columns: Columns) -> Iterable[str]:
    """Yield the statements that find out what a value is compared with."""
    has_amounts, has_parameters = _kinds(columns, "LIMIT")
    own = f"getattr(self._vehicle.parameters, {columns('LIMIT')})"
    factor = "" if columns.same.get("FACTOR") == "1" else f" * {columns('FACTOR')}"
    offs = columns.values("OFF")
    off = [] if offs == {"None"} else [f"if limit == {columns('OFF')}:  # switched off", "    return None"]
    if not has_amounts:
        yield f"limit = {own}{factor}"
        yield from off
    elif not has_parameters:
        yield f"limit = {columns('FACTOR')}"
    else:
        yield f"limit = {columns('FACTOR')}"
        yield f"if {columns('LIMIT')} is not None:"
        yield f"    limit *= {own}"
        yield from (f"    {line}" for line in off)
    if columns.values("SLACK") != {"0"}:
        yield f"if self.level >= {columns('LEVEL')}:  # it is over once the value is better by so much"
        yield f"    limit -= {columns('SIGN')} * {columns('SLACK')}"


def due_lines(columns: Columns) -> Iterable[str]:
    """Yield the statements that return the condition once it has held for long enough."""
    has_amounts, has_parameters = _kinds(columns, "AFTER")
    if not has_amounts:
        yield f"limit_ms = getattr(self._vehicle.parameters, {columns('AFTER')}) * {columns('MS')}"
        yield "return condition if 0 < limit_ms <= held_ms else None  # 0 switches it off"
    elif not has_parameters:
        yield f"return condition if held_ms >= {columns('MS')} else None"
    else:
        yield "return condition if self._is_due(condition, held_ms) else None"


def is_due_lines(columns: Columns) -> Iterable[str]:
    """Yield the body of the method that says so, where some times are parameters and others are not."""
    if _kinds(columns, "AFTER") == (True, True):
        yield f"limit_ms = {columns('MS')}"
        yield f"if {columns('AFTER')} is not None:"
        yield f"    limit_ms *= getattr(self._vehicle.parameters, {columns('AFTER')})"
        yield "    if limit_ms == 0:  # switched off"
        yield "        return False"
        yield "return held_ms >= limit_ms"


def _kinds(columns: Columns, column: str) -> tuple[bool, bool]:
    """Return whether there are amounts, and whether there are parameters."""
    values = columns.values(column)
    return "None" in values, bool(values - {"None"})


def of_parameter(columns: Columns, condition: str) -> str:
    """Return the threshold that a parameter has, of the condition that the generated code calls so."""
    factor = "" if columns.same.get("FACTOR") == "1" else f" * {columns('FACTOR', condition)}"
    return f"getattr(self._vehicle.parameters, {columns('LIMIT', condition)}){factor}"


def inverted(columns: Columns) -> str:
    """Return whether ``second``, the threshold of the worse level, is no worse than ``first``, and both are on."""
    offs, signs = columns.values("OFF"), columns.values("SIGN") - {"0"}
    if offs == {"0"} and len(signs) == 1:
        return "0 < first <= second" if signs == {"-1"} else "0 < second <= first"
    off = f"first != {columns('OFF', 'milder')} and second != {columns('OFF', 'worse')} and "
    return f"{'' if offs == {'None'} else off}(second - first) * {columns('SIGN', 'worse')} <= 0"


def follow_lines(columns: Columns, *, has_silence: bool, has_unknown: bool) -> Iterable[str]:
    """Yield the statements that put a condition into its row of those that scan_plain describes."""
    signs = columns.values("SIGN") - {"0"}
    if has_silence:
        yield f"if {columns('PLACE')} is None:"
        yield "    continue"
    yield "at = 3 * index + 1"
    yield f"rows[at] = {columns('PLACE')}"
    if has_unknown and not signs:
        yield f"rows[at + 1] = {_SENSE_UNKNOWN}"
        return
    if has_unknown:
        yield f"if {columns('SIGN')} == 0:"
        yield f"    rows[at + 1] = {_SENSE_UNKNOWN}"
        yield "    continue"
    yield "limit = self._limit(condition)"
    yield f"rows[at + 1] = 0 if limit is None else {next(iter(signs)) if len(signs) == 1 else columns('SIGN')}"
    yield "rows[at + 2] = limit or 0"


def guarded(is_needed: bool, place: str, expression: str) -> str:
    """Return the expression, and before it, where that is needed, that there is a place at all."""
    return f"{place} is not None and {expression}" if is_needed else expression
