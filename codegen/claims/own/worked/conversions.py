"""Statements that say one amount in another way: in another unit, as a float of 32 bits, in parts of a unit."""

import re
import struct
from collections.abc import Iterator
from fractions import Fraction
from math import prod

from codegen.claims.own.worked.amount import Amount
from codegen.claims.own.worked.examples import Examples, Statement
from codegen.diagnostics import Diagnostic
from codegen.model.units.nearest_unit import worded_unit
from codegen.pattern import pattern

_FLOAT = pattern(r"\bas a float of 32 bits$")
_VALUE = pattern(r"value|result", re.IGNORECASE)
_EXACT = pattern(r", exact\b")
_PARTS = pattern(
    r"parts of an? (?P<units>[a-z]+(?: times an? [a-z]+)*) for an? (?P<time>[a-z]+) in ", re.IGNORECASE, needs="parts"
)
_FORCED = pattern(r"\bforce\b.*\barming\b|\barming\b.*\bforce\b", re.IGNORECASE)


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every such statement."""
    for statement in examples.statements:
        value, label = statement.value.alone, statement.label
        if value is None:
            continue
        parts = _PARTS.match(label.text)
        if _FLOAT.search(label.text):
            yield from _float(examples, statement, value)
        elif parts is not None and value.is_plain:
            yield from _parts(examples, statement, value, parts)
        elif len(label.amounts) == 1 and label.amounts[0].like(value.unit):
            amount = label.amounts[0]
            expected = amount.in_unit(value.unit)
            is_alone = label.only is not None and _VALUE.fullmatch(statement.table.heads[1]) is not None
            if expected is not None and amount.unit != value.unit and (is_alone or "^" in amount.written):
                words = f"{amount.written} {amount.unit.name}"
                yield from examples.judged(statement.passage, value, [expected], words)


def _float(examples: Examples, statement: Statement, value: Amount) -> Iterator[Diagnostic]:
    """ "3.95 as a float of 32 bits | 3.9500000477", and numbers that are one exactly."""
    first = statement.label.alone
    if first is not None:
        nearest = _nearest(first.value)
        yield from examples.judged(statement.passage, value, [nearest], f"{first.written} as a float of 32 bits")
    elif _EXACT.match(statement.passage.text, value.end):
        forces = (s.program.spec.arming for s in examples.systems if s.program is not None)
        known = [Fraction(arming.force) for arming in forces if arming is not None]
        if _FORCED.search(statement.label.text):
            yield from examples.judged(statement.passage, value, known, "the number that forces arming")
        nearest = _nearest(value.value)
        if nearest != value.value:
            text = f"{value.written} is no float of 32 bits: {float(nearest):.0f} is nearest"
            yield examples.wrong(statement.passage, value.start, text)


def _nearest(value: Fraction) -> Fraction:
    """The float of 32 bits that is nearest; of what is beyond them the value itself."""
    return Fraction(struct.unpack("<f", struct.pack("<f", float(value)))[0]) if abs(value) < 1 << 127 else value


def _parts(examples: Examples, statement: Statement, value: Amount, said: "re.Match[str]") -> Iterator[Diagnostic]:
    """ "Parts of a centiampere for a millisecond in 1 mAh | 360000"."""
    whole = statement.label.amounts[-1:]
    names = [*pattern(r" times an? ").split(said["units"]), said["time"]]
    units = [worded_unit(name) for name in names]
    if whole and None not in units and not whole[0].is_plain:
        part = prod((unit.scale for unit in units if unit is not None), start=Fraction(1))
        yield from examples.judged(
            statement.passage, value, [whole[0].value * whole[0].unit.scale / part], statement.label.text
        )
