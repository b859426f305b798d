"""The expected value of a field for a stored one: one number, or for floats the ends of those near enough."""

import math
import struct
from dataclasses import dataclass
from fractions import Fraction

from population.answer import SMALL, Answer

LARGEST = {"f": 3.4028234663852886e38, "d": 1.7976931348623157e308}


@dataclass(frozen=True)
class Carried:
    """The smallest and the largest number that is right; both are one but for floats set in other units. Or a text."""

    low: float
    high: float
    text: str | None = None

    def is_met_by(self, value: object) -> bool:
        """Return whether a value that pymavlink decoded is right."""
        if self.text is not None:
            return value == self.text
        if not isinstance(value, int | float):
            return False
        if math.isnan(self.low):
            return math.isnan(value)
        same_sign = math.copysign(1, value) == math.copysign(1, self.low) or self.low != 0 or value != 0
        return self.low <= value <= self.high and same_sign


def carried(answer: Answer, value: Fraction | float | str | None) -> Carried:
    """Return the value of a field's element for that of its source; None is unknown, and sent as the sentinel."""
    if answer.kind == "text":
        if answer.steps is None:
            return Carried(0, 0, answer.written.split('"')[1])
        return Carried(0, 0, cut(str(value or ""), answer.field.count))
    if answer.kind == "fixed":
        unknown = answer.unknown if answer.written == "unknown" else 0
        assert unknown is not None
        return Carried(unknown, unknown)
    if answer.kind == "flags":
        fixed = sum(number for name, number in answer.flags if not name)
        return _exactly(fixed + int(value or 0))
    assert not isinstance(value, str)
    if value is None:
        assert answer.unknown is not None, answer.label
        return Carried(answer.unknown, answer.unknown)
    if answer.kind == "clock":
        return _exactly(int(value) // answer.microseconds & (1 << answer.field.bits) - 1, answer)
    if answer.field.is_float:
        return _float(answer, value)
    return _exactly(_whole(answer, Fraction(value)))


def cut(text: str, size: int) -> str:
    """Return as many whole characters of a text as so many bytes of UTF-8 hold, up to a NUL."""
    return text.partition("\0")[0].encode()[:size].decode(errors="ignore")


def _exactly(number: int, answer: Answer | None = None) -> Carried:
    if answer is not None and answer.field.code.islower() and number >> answer.field.bits - 1:
        number -= 1 << answer.field.bits
    return Carried(number, number)


def _whole(answer: Answer, steps: Fraction) -> int:
    """Rounded and limited, and never the sentinel, but the step beside it that is further from zero."""
    low, high = answer.whole_ends
    number = max(low, min(high, answer.rounded(steps)))
    if answer.kind == "number" and number == answer.unknown:
        number += 1 if number >= 0 else -1
    return number


def _float(answer: Answer, value: Fraction | float) -> Carried:
    """The nearest float; of a value in another unit, what a rounding of a double on the way may make of that."""
    code = answer.field.code
    if answer.steps is not None:
        steps = max(Fraction(-SMALL), min(Fraction(SMALL), Fraction(value)))
        exact = steps * answer.factor
        if exact == answer.unknown:
            exact += (1 if exact >= 0 else -1) * answer.factor
        low, high = exact, exact
    else:
        exact = Fraction(value) * answer.wire
        slack = abs(exact) / 2**51 if answer.wire != 1 else Fraction(0)
        low, high = exact - slack, exact + slack
        if value == 0:
            return _beside(answer, value, value)
    return _beside(answer, nearest(low, code), nearest(high, code))


def _beside(answer: Answer, low: float, high: float) -> Carried:
    """The next float where a number would be read as unknown."""
    if answer.steps is None and low <= (answer.unknown if answer.unknown is not None else math.nan) <= high:
        low = high = _after(low, answer.field.code)
    return Carried(low, high)


def _after(number: float, code: str) -> float:
    """The next float that is further from zero; of zero, with whatever sign, the smallest normal one above it."""
    if number == 0:
        return float.fromhex({"f": "0x1p-126", "d": "0x1p-1022"}[code])
    whole = {"f": "<I", "d": "<Q"}[code]
    bits = struct.unpack(whole, struct.pack(f"<{code}", number))[0] + 1
    return float(struct.unpack(f"<{code}", struct.pack(whole, bits))[0])


def nearest(exact: Fraction, code: str) -> float:
    """The float that is nearest to a fraction, a half to the even one; beyond the largest, that one."""
    largest = LARGEST[code]
    if abs(exact) >= Fraction(largest):
        return math.copysign(largest, exact)
    if code == "d":
        return float(exact)
    size = abs(exact)
    exponent = -149
    if size >= Fraction(1, 1 << 126):
        exponent = (size.numerator.bit_length() - size.denominator.bit_length()) - 24
        while size / Fraction(2) ** exponent >= 1 << 24:
            exponent += 1
        exponent = max(exponent, -149)
    number = round(size / Fraction(2) ** exponent) * Fraction(2) ** exponent
    return math.copysign(float(number), exact)
