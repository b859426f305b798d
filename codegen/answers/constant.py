"""Constants of the tables, held against the type, the unit and the sentinel of their field."""

from fractions import Fraction

from codegen.answers.fitting import field_unit
from codegen.answers.letters import carries_text
from codegen.answers.limits import dialect_bounds
from codegen.diagnostics import Report, Rule
from codegen.measure import nearest_float, read_amount, read_real
from codegen.model.answers.answer import Elements
from codegen.model.answers.known import Value
from codegen.model.code.letters import NUL, cut, on_one_line
from codegen.model.code.storage import Storage
from codegen.model.dialect.dialect import Kind, WireField
from codegen.model.units.unit import NUMBER, Unit, decimal
from codegen.source import Place

CONSTANT_RANGE = Rule(
    "constant-out-of-range",
    "A constant is beyond what the field can carry; it would wrap.",
    remedy="write a number that it carries, in its unit, or answer with unknown",
)
BAD_CONSTANT = Rule(
    "bad-constant",
    "A constant does not fit its field: text for a number, a number for text, a fraction for an integer.",
    remedy="write what the field carries: a number in its unit, or a text in quotes",
)
SENTINEL_CONSTANT = Rule(
    "sentinel-as-constant",
    "A constant equals the sentinel of its field: receivers read it as unknown. Answer 'unknown' if that is meant.",
)
SENTINEL_CONTRADICTION = Rule(
    "sentinel-contradiction",
    "A constant that people use for unknown (0, -1 or the largest or smallest number of the type) is given where the "
    "dialect has another sentinel: receivers would take it for a real value. Answer 'unknown'; if the value is real, "
    "write it with its unit.",
)


def read_constant(covers: Elements, written: str | Fraction, key: str, report: Report) -> tuple[Value, str] | None:
    """A number in the field's unit, an amount converted to it, or a text: with words for it."""
    field, place = covers.field, covers.written.at(key)
    if field.type.kind is Kind.CHAR or (isinstance(written, str) and carries_text(covers)):
        return _text(written, field, place, report)
    unit = field_unit(field, report)
    if unit is None:
        return None
    if isinstance(written, str) and unit is NUMBER:
        report.add(
            BAD_CONSTANT, place, f"{written!r} is not a number, and {field.name} has no unit", hint="write a number"
        )
        return None
    number = _number(written, unit, field, place, report)
    if number is None:
        return None
    if not fits(covers, number, key, _shown(written), report):
        return None
    if not _agrees_with_sentinel(covers, number, isinstance(written, str), key, report):
        return None
    if isinstance(written, Fraction) and field.multiplier != 1:
        return number, _shown(written)
    return number, written if isinstance(written, str) else f"{number}"


def _text(written: str | Fraction, field: WireField, place: Place, report: Report) -> tuple[str, str] | None:
    """A text that the field holds as a whole: what is known now is not cut without a word."""
    problem, hint = "is no text", None
    fitting = "" if isinstance(written, Fraction) else on_one_line(cut(written, field.count))
    if isinstance(written, Fraction):
        hint = f"'{decimal(written)}'"
    elif NUL in written:
        problem, hint = "has a NUL in it, which ends a text", f"'{fitting}'"
    elif len(written.encode()) > field.count:
        problem, hint = f"is {len(written.encode())} bytes long in UTF-8", f"'{fitting}' would fit"
    else:
        return written, "text"
    report.add(BAD_CONSTANT, place, f"{field.name} is a text of at most {field.count} bytes, and this {problem}", hint)
    return None


def _number(written: str | Fraction, unit: Unit, field: WireField, place: Place, report: Report) -> int | float | None:
    """Return what is on the wire for a number in the units of the field, or an amount; whole, or the nearest float."""
    if not field.type.is_integer:
        if isinstance(written, Fraction):
            return nearest_float(written / field.multiplier)
        return read_real(written, unit, place, report)
    value = written / field.multiplier if isinstance(written, Fraction) else read_amount(written, unit, place, report)
    if value is None:
        return None
    if value.denominator != 1:
        shown = float(value * field.multiplier)
        report.add(
            BAD_CONSTANT,
            place,
            f"{shown} is not a whole number of {field.unit_text or 'steps'}",
            hint="write one that is, or answer with a quantity, which is rounded",
        )
        return None
    return int(value)


def _shown(written: str | Fraction) -> str:
    return written if isinstance(written, str) else decimal(written)


def fits(covers: Elements, value: int | float, key: str, written: str, report: Report) -> bool:
    """Return whether the field holds ``value`` by its type, minValue and maxValue; a finding if not."""
    field = covers.field
    of_type = (field.type.minimum, field.type.maximum) if field.type.is_integer else Storage(field.type.code).limits
    stated = dialect_bounds(field)
    low = max(number for number in (of_type[0], stated.low) if number is not None)
    high = min(number for number in (of_type[1], stated.high) if number is not None)
    sentinels = field.sentinel.values[covers.first : covers.first + covers.count] if field.sentinel else ()
    if low <= value <= high or value in sentinels:  # a sentinel has a finding of its own
        return True
    report.add(
        CONSTANT_RANGE,
        covers.written.at(key),
        f"{written} is {value}, but {field.name} ({field.type.name}) carries {_end(low)} to {_end(high)}",
        related=[(field.definition.place, f"{field.name} is declared here")],
    )
    return False


def _end(number: int | float | Fraction) -> str:
    """``255``; the ends of floats with the digits that tell them."""
    return str(number) if -(2**64) < number < 2**64 else f"{float(number):.7g}"


def _agrees_with_sentinel(covers: Elements, value: int | float, has_unit: bool, key: str, report: Report) -> bool:
    field = covers.field
    if field.sentinel is None:
        return True
    sentinels = field.sentinel.values[covers.first : covers.first + covers.count]
    related = [(field.sentinel.place, f"invalid={field.sentinel.written!r} is stated here")]
    place = covers.written.at(key)
    if value in sentinels:
        report.add(SENTINEL_CONSTANT, place, f"{value} means unknown in {field.name}", "write 'unknown'", related)
        return False
    usual = {0, -1, field.type.maximum, field.type.minimum}
    if not has_unit and field.definition.units and sentinels[0] is not None and value in usual:
        report.add(
            SENTINEL_CONTRADICTION,
            place,
            f"{field.name} is unknown when it is {field.sentinel.written}, not {value}",
            f"write 'unknown', or '{value} {field.definition.units}' if that is the real value",
            related,
        )
        return False
    return True
