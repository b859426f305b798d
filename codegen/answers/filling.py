"""Statements that bring a stored value into an integer field: scaling, limits, sentinel."""

import math

from codegen.model.answers.answer import Elements
from codegen.model.answers.known import shown_value
from codegen.model.answers.scaling import Scaling, rounded
from codegen.model.code.payload_code import UNKNOWN, PayloadCode, indented
from codegen.model.code.statements import scaled
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.vehicle import Parameter, Quantity


def comment(covers: Elements, words: str) -> str:
    """``# voltages [mV]: battery.voltage (FR-00068.3)``: field, unit, source and criterion."""
    units = covers.field.unit_text
    target = f"{covers.label} [{units}]" if units else covers.label
    return f"# {target}: {words} ({covers.citation})"


def origin(covers: Elements, source: Quantity | Parameter) -> str:
    """The path of a source, with the unit that it is kept in, where the field has another one."""
    kept = source.stored.name if isinstance(source, Quantity) else source.unit.name
    return f"{source.path} [{kept}]" if kept and kept != covers.field.unit_text else source.path


def read(code: PayloadCode, source: Quantity | Parameter, element: str = "") -> str:
    """The expression of what is stored of a source, of a list at the place ``element``."""
    return code.parameter(source) if isinstance(source, Parameter) else code.read(source, element)


def stand_in(source: Quantity | Parameter) -> list[str]:
    """Return what a quantity that has a value at all times is while it is unknown."""
    initial = source.initial if isinstance(source, Quantity) else None
    return [] if initial is None else [f"if value == {UNKNOWN}:", f"    value = {initial}  # until it is set"]


def fitted(scaling: Scaling, unknown: int | None, why: str = "unknown") -> list[str]:
    """Return the lines that turn stored steps in ``value`` into the number on the wire, ``unknown`` for an unknown one.

    Unknown lies below every limit, so a known value that is within them is compared with two numbers only. ``why`` is
    the comment beside what goes out instead.
    """
    if scaling.factor == 1:
        return _limited(scaling, unknown, why)
    low, high = scaling.steps
    ends = [rounded(end * scaling.factor, scaling.rounding) for end in (low, high)]
    if ends == [int(scaling.low), int(scaling.high)]:  # limited once, before it is scaled
        lines = [*_between(low, high), *scaled(scaling.factor, scaling.rounding), *_tested(_moved(scaling))]
    else:
        lines = [*_narrowed(scaling), *scaled(scaling.factor, scaling.rounding), *_limited(scaling, None, "")]
    if unknown is None:
        return lines
    return [f"if value == {UNKNOWN}:", f"    value = {unknown}  # {why}", "else:", *indented(lines)]


def apart(unknown: int | float, store: list[str], lines: list[str]) -> list[str]:
    """Return the lines that ``store`` an unknown value as a whole, and else what ``lines`` do."""
    return [
        f"if value == {UNKNOWN}:  # goes out as {shown_value(unknown)}",
        *indented(store),
        "else:",
        *indented(lines),
    ]


def _limited(scaling: Scaling, unknown: int | None, why: str) -> list[str]:
    low, high = math.ceil(scaling.low), math.floor(scaling.high)
    tests: list[tuple[str, str]] = []
    if low <= -SMALL_INT_MAX:
        tests += [] if unknown is None else [(f"value == {UNKNOWN}", f"value = {unknown}  # {why}")]
    elif unknown is None or unknown == low:
        tests.append((f"value < {low}", f"value = {low}"))
    else:
        tests.append((f"value < {low}", f"value = {unknown} if value == {UNKNOWN} else {low}  # {why}, or too small"))
    if high < SMALL_INT_MAX:
        tests.append((f"value > {high}", f"value = {high}"))
    return _tested([*tests, *_moved(scaling)])


def _moved(scaling: Scaling) -> list[tuple[str, str]]:
    """The test for the sentinel within the limits, and what goes out in its place."""
    if scaling.hole is None or not scaling.low <= scaling.hole <= scaling.high:
        return []
    return [(f"value == {scaling.hole}", f"value = {scaling.beside}  # {scaling.hole} would read as unknown")]


def _tested(tests: list[tuple[str, str]]) -> list[str]:
    lines: list[str] = []
    for test, statement in tests:
        lines += [f"{'elif' if lines else 'if'} {test}:", f"    {statement}"]
    return lines


def _narrowed(scaling: Scaling) -> list[str]:
    """Limits in stored steps, one step wider than the field, that keep the product of the scaling small."""
    low, high = math.floor(scaling.low / scaling.factor) - 1, math.ceil(scaling.high / scaling.factor) + 1
    return _between(low, high)


def _between(low: int, high: int) -> list[str]:
    return [f"if value < {low}:", f"    value = {low}", f"elif value > {high}:", f"    value = {high}"]
