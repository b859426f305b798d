"""The largest value that a converter can show: "16.8 V is beyond the 13.035 V that the shipped divider shows"."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.own.worked.amount import amounts
from codegen.claims.own.worked.readings import measured
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule
from codegen.model.system import System
from codegen.model.units.unit import Unit, decimal
from codegen.pattern import pattern

FULL_SCALE = Rule(
    "claim-full-scale",
    "A document gives a measurement another full scale than its converter has with the default factor. Correct it, or "
    "the factor that it was computed with.",
    remedy="write the full scale that follows, or correct the reference, the bits or the factor",
)

_SAID = pattern(
    r"\bfull[- ]scale(?: is| of| at|,| value of)? (?=\d)"
    r"|\b(?:beyond|above|over|up to|at most|no more than) (?:the )?"
    r"(?=\d{1,6}\.?\d{0,9} ?[A-Za-z%]{1,3} (?:that|which) (?:it|the) [^.;]{0,40}?"
    r"\b(?:shows?|measures?|reads?|can (?:show|measure|read)))"
)  # fmt: skip
_NEAR = 24


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every full scale in the text of a project's document."""
    for passage in reading.prose.passages if reading.reference.systems else ():
        for said in _SAID.finditer(passage.text):
            for amount in amounts(passage.text, said.end(), said.end() + _NEAR)[:1]:
                values = full_scales(reading.reference.systems, amount.unit)
                precision = Fraction(1, 10**amount.places)
                if values and all(abs(value - amount.value) >= precision for value in values):
                    shown = " or ".join(
                        f"{decimal(round(value, amount.places))} {amount.unit.name}" for value in values
                    )
                    text = f"full scale is {shown}, not {amount.written}"
                    place = passage.place_at(amount.start)
                    yield reading.found(FULL_SCALE, place, f"full scale {amount.written}", text)


def full_scales(systems: tuple[System, ...], unit: Unit) -> list[Fraction]:
    """Return, for each quantity in a unit, its value at the converter's highest count with the default factor."""
    found = []
    for each in measured(systems, unit):
        value = each.value(Fraction(each.conversion.channel.full_scale), {}, unit)
        if value is not None and value not in found:
            found.append(value)
    return found
