"""Remarks in brackets behind a quantity: a unit, a factor, or words that make another number of it."""

from dataclasses import replace
from fractions import Fraction

from codegen.importing.answer import Sources, Target
from codegen.importing.number import stated_number
from codegen.importing.quantity import field_unit
from codegen.load.expression import Product
from codegen.model.dialect.literals import same_number
from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import ratio
from codegen.pattern import pattern

_COUNT = r"(?P<number>\d{1,12}(?:\.\d{1,12})?)"
_FACTOR = pattern(
    r"(?i)(?:(?P<times>[x\u00d7\u00b7*]|(?:multiplied |scaled )?by|times|multiplied by|scaled by|factor(?: of)?)"
    rf"|(?:/|\u00f7|divided by)) ?{_COUNT}"
)
_OTHERWISE = pattern(
    r"(?i)(?<!not )\b(?:negated|inverted|(?:sign|polarity) (?:changed|reversed|flipped|inverted))\b"
    r"|\boffset (?:of |by )?[-+\u2212]?\d|(?:^|\b(?:plus|minus|less) )[-+\u2212]? ?\d[\d.]*(?: \w+)?$|^[-+\u2212] ?\d"
)
_NUMBER = r"(?P<{}>[-+\u2212]?(?:0[xX][0-9a-fA-F]{{1,16}}|\d{{1,20}})|U?INT\d{{1,2}}_M(?:AX|IN)|[Nn]a[Nn])"
_ABSENT = r"(?:unknown|unavailable|unset|invalid|(?:not|no) (?:known|available|measured|set))"
_UNKNOWN = pattern(
    rf"{_NUMBER.format('first')} (?:(?:if|when|while|where|for|means|is) |= ?|: ?)?(?:it is )?{_ABSENT}\b"
    rf"|\b{_ABSENT}(?: is| means| as|:| =)? {_NUMBER.format('last')}(?![\w.])"
)


def remarked(product: Product, remark: str, target: Target, sources: Sources) -> Product | None:
    """Return the quantity that a remark is behind, times the factor that it states; None where it says something else.

    A unit is that of the quantity or that of the field, a number for unknown the sentinel. What is none of these is
    a remark for people.
    """
    unit = worded_unit(remark.removeprefix("in "))
    wire = field_unit(target)
    if unit is not None and wire is not None and ratio(unit, wire) is not None:
        own = (sources.quantities or {}).get(product.path)
        return product if unit in (wire, own) or (own is None and sources.quantities is None) else None
    if (factor := _FACTOR.fullmatch(remark)) is not None:
        number = Fraction(factor["number"])
        if not number:
            return None
        return replace(product, factor=product.factor * (number if factor["times"] else 1 / number))
    return None if _OTHERWISE.search(remark) or _names_another_sentinel(remark, target) else product


def _names_another_sentinel(remark: str, target: Target) -> bool:
    """Return whether a remark gives another number for unknown than the sentinel of the field."""
    found = _UNKNOWN.search(remark)
    if found is None:
        return False
    number = stated_number((found["first"] or found["last"]).replace("\u2212", "-"), target)
    return number is not None and (target.sentinel is None or not same_number(number, target.sentinel))
