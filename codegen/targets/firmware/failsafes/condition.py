"""Conditions of failsafes: the expressions and statements that hold values against the columns of their tables."""

from collections.abc import Iterable

from codegen.model.code.payload_code import UNKNOWN
from codegen.targets.firmware.failsafes.table import Columns

_SENSE_UNKNOWN = "2  # unknown"
_SENSE_SILENT = "3  # nobody is heard"
"""As scan_plain has them."""

_IN_A_ROW = {"_ROW_SENSE": 1, "_ROW_LIMIT": 2, "_ROW_FLOOR": 3, "_ROW_AFTER": 4, "_ROW_LEVEL": 6}
"""The places of values in a row, as scan_plain has them."""


def limit_lines(columns: Columns) -> Iterable[str]:
    """Yield the statements that find out what a value is compared with."""
    has_amounts, has_parameters = _kinds(columns, "LIMIT")
    own = f"getattr(self._parameters, {columns('LIMIT')})"
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


def after_lines(columns: Columns) -> Iterable[str]:
    """Yield the statements that return for how many ms a condition has to hold, where that is not a plain number."""
    has_amounts, has_parameters = _kinds(columns, "AFTER")
    if not has_parameters:
        return
    own = f"getattr(self._parameters, {columns('AFTER')}) * {columns('MS')}"
    if has_amounts:
        yield f"if {columns('AFTER')} is None:"
        yield f"    return {columns('MS')}"
    yield f"return {own} or _NOT  # 0 switches it off"


def _kinds(columns: Columns, column: str) -> tuple[bool, bool]:
    """Return whether there are amounts, and whether there are parameters."""
    values = columns.values(column)
    return "None" in values, bool(values - {"None"})


def of_parameter(columns: Columns, condition: str) -> str:
    """Return the threshold that a parameter has, of the condition that the generated code calls so."""
    factor = "" if columns.same.get("FACTOR") == "1" else f" * {columns('FACTOR', condition)}"
    return f"getattr(self._parameters, {columns('LIMIT', condition)}){factor}"


def inverted(columns: Columns) -> str:
    """Return whether ``second``, the threshold of the worse level, is no worse than ``first``, and both are on."""
    offs, signs = columns.values("OFF"), columns.values("SIGN") - {"0"}
    if offs == {"0"} and len(signs) == 1:
        return "0 < first <= second" if signs == {"-1"} else "0 < second <= first"
    off = f"first != {columns('OFF', 'milder')} and second != {columns('OFF', 'worse')} and "
    return f"{'' if offs == {'None'} else off}(second - first) * {columns('SIGN', 'worse')} <= 0"


def follow_lines(columns: Columns, *, has_silence: bool, has_unknown: bool) -> Iterable[str]:
    """Yield the statements that put a condition into its row of those that scan_plain describes."""
    place = columns("PLACE")
    signs = columns.values("SIGN") - {"0"}
    yield f"rows[at + _ROW_AFTER] = {'self._after_ms(condition)' if _kinds(columns, 'AFTER')[1] else columns('MS')}"
    yield f"rows[at + _ROW_LEVEL] = {columns('LEVEL')}"
    if has_silence:
        if columns.values("PLACE") == {"None"}:
            yield f"rows[at + _ROW_SENSE] = {_SENSE_SILENT}"
            return
        yield f"if {place} is None:"
        yield f"    rows[at + _ROW_SENSE] = {_SENSE_SILENT}"
        yield "    continue"
    yield f"rows[at] = {place}"
    if has_unknown and not signs:
        yield f"rows[at + _ROW_SENSE] = {_SENSE_UNKNOWN}"
        return
    if has_unknown:
        yield f"if {columns('SIGN')} == 0:"
        yield f"    rows[at + _ROW_SENSE] = {_SENSE_UNKNOWN}"
        yield "    continue"
    yield "limit = self._limit(condition)"
    yield f"rows[at + _ROW_SENSE] = 0 if limit is None else {next(iter(signs)) if len(signs) == 1 else columns('SIGN')}"
    yield "rows[at + _ROW_LIMIT] = limit or 0"
    # Conditions for arming alone, which no time is counted of, have none.
    yield f"rows[at + _ROW_FLOOR] = {columns('FLOOR') if columns.values('FLOOR') else UNKNOWN}"


def row_constants(statements: Iterable[str]) -> Iterable[str]:
    """Yield the lines that say where a row has what the statements put there."""
    said = "\n".join(statements)
    yield from (f"{name} = const({place})" for name, place in _IN_A_ROW.items() if name in said)


def guarded(is_needed: bool, place: str, expression: str) -> str:
    """Return the expression, and before it, where that is needed, that there is a place at all."""
    return f"{place} is not None and {expression}" if is_needed else expression
