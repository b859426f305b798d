"""Statements of generated functions that machine code and plain Python have alike: rounding, and long conditions."""

import re
from fractions import Fraction

from codegen.model.code.payload_code import indented
from codegen.model.spec.population import Rounding

LONGEST = 112
"""Characters of a line in the body of a function."""


def scaled(factor: Fraction, rounding: Rounding) -> list[str]:
    """``value * factor``, rounded: by divisions of positive numbers, which all interpreters round alike."""
    numerator, denominator = factor.numerator, factor.denominator
    product = f"value * {numerator}" if numerator != 1 else "value"
    if denominator == 1:
        return [f"value = {product}"]
    half = denominator // 2
    if rounding is Rounding.DOWN:
        return [f"value = {product} // {denominator}"]
    if rounding is Rounding.UP:
        return [f"value = 0 - (0 - {product}) // {denominator}"]
    if rounding is Rounding.TOWARD_ZERO:
        half = 0
    below = f"0 - ({half} - {product}) // {denominator}" if half else f"0 - (0 - {product}) // {denominator}"
    above = f"({product} + {half}) // {denominator}" if half else f"{product} // {denominator}"
    return ["if value < 0:", f"    value = {below}", "else:", f"    value = {above}"]


def tested(keyword: str, condition: str, remark: str) -> list[str]:
    """``if condition:``, over several lines where it is long, as the formatter has them."""
    line = f"{keyword} {condition}:  # {remark}"
    if len(line) <= LONGEST:
        return [line]
    inner = [condition] if len(condition) <= LONGEST else re.sub(r" (and|or) ", r"\n\1 ", condition).split("\n")
    return [f"{keyword} (  # {remark}", *indented(inner), "):"]
