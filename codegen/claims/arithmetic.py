"""Worked examples: "(3000 / 4095.0 * 3.3) * 3.95 = 9.52V", with the assertion that a block of code makes of it."""

import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.expression import Expression, expression_before
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock
from codegen.model.units.unit import Unit, ratio
from codegen.pattern import pattern
from codegen.source import Place

RULE = Rule(
    "claim-arithmetic",
    "A worked example states another result than its own numbers have. Results may be rounded or cut at any digit, and "
    "'≈' or '~' allows for five percent. Correct the result, or the number that it was computed with.",
    remedy="write the result that its numbers have, or correct the number that it was computed with",
)

_RESULT = pattern(
    r"(?<![=<>!:+*/-])(?P<sign>=|≈|~=|=~)(?![=>~])\s*(?P<about>[~≈]|about\s|ca\.\s)?\s*"
    r"(?P<number>[-\u2212]?(?:\d{1,3}(?:,\d{3}){1,4}(?!\d)|\d{1,18})(?:\.\d{1,15})?)(?!\w*\(|[\d.,]*\d|[eE][-+]?\d)"
    r"(?:[ ]?(?P<unit>%|[A-Za-zµ°][A-Za-z°]{0,8}(?:/[A-Za-z]{1,3})?\b))?"
)
_GOES_ON = pattern(r"\s*(?:[*/^\u00d7\u00b7\u00f7]|[-+]\s?[\d(])")
_BEFORE = pattern(r"[*/\u00d7x] ?\d[\d.,]* ?(?:[a-z]+ )?$")  # "20 Hz x 23 bytes (11 + 12) = 460": an aside
_COMMENT = pattern(r"(?://|#|--|/\*|\*|;)(.*)")
_PLAIN = ("", "text", "txt", "plain", "console")
_TOLERANCE = r"[^\n]{0,40}?<=?\s*([0-9.]{1,20})"
_MULTIPLE = pattern(r"(?:thousand|million|billion|trillion|[kKMG])$", re.IGNORECASE)
_ABOUT = Fraction(1, 20)
_WRAPS = (1 << 8, 1 << 16, 1 << 32)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every equation of numbers in the text, in comments of code, and in blocks without a language."""
    for passage in reading.prose.passages:
        for expression, result in _examples(passage.text):
            place = passage.place_at(expression.start)
            yield _finding(reading, passage.text, expression, result, place, [])
    for code in reading.prose.code:
        for line in code.lines:
            start = 0
            if code.language not in _PLAIN:
                comment = _COMMENT.search(line.text)
                if comment is None:
                    continue
                start = comment.start(1)
            for expression, result in _examples(line.text, start):
                place = line.place._replace(column=line.place.column + expression.start)
                yield _finding(reading, line.text, expression, result, place, list(_assertions(code, line, result)))


def _examples(text: str, start: int = 0) -> Iterator[tuple[Expression, "re.Match[str]"]]:
    """Expressions with a result that is not theirs; their values are in the unit of the result."""
    for result in _RESULT.finditer(text, start) if "=" in text or "≈" in text else ():
        expression = expression_before(text, result.start())
        if expression is None or expression.start < start or _GOES_ON.match(text, result.end()):
            continue
        if text[expression.start] == "(" and _BEFORE.search(text, start, expression.start):
            continue
        value = _in_unit(expression, result)
        if value is not None and not _is_right(value, result) and not _is_right(_in_small(value, result), result):
            yield replace(expression, value=value), result


def _in_small(value: Fraction, result: "re.Match[str]") -> Fraction:
    """The value in the unit of the result where the numbers of the expression are in the one without a prefix.

    ``1/9600 = 104 us``: the quotient is in seconds.
    """
    unit = Unit.parse((result["unit"] or "").replace("kB", "kbytes").replace("MB", "Mbytes"))
    plain = Unit.parse(pattern(r"^[munkcdMG](?=[A-Za-z])").sub("", result["unit"] or "").replace("B", "bytes"))
    factor = ratio(plain, unit) if unit is not None and plain is not None else None
    return value if factor is None else value * factor


def _in_unit(expression: Expression, result: "re.Match[str]") -> Fraction | None:
    """The value of the expression in the unit of the result; None where that is not certain."""
    unit, value = result["unit"], expression.value
    if unit is not None and _MULTIPLE.match(unit):
        return None
    if unit is None or not expression.units:
        is_attached = unit is not None and result.string[result.start("unit") - 1].isdigit()
        if unit == "%":
            return value if abs(value) > 1 else value * 100
        return None if is_attached and Unit.parse(unit) is None else value
    if expression.units == {unit}:
        return value
    wanted, own = Unit.parse(unit), Unit.parse(next(iter(expression.units)))
    if len(expression.units) > 1 or wanted is None or own is None:
        return None
    factor = ratio(own, wanted)
    return None if factor is None else value * factor


def _is_right(value: Fraction, result: "re.Match[str]") -> bool:
    """Return whether a result is the value: rounded or cut at its last digit, roughly it if it says so, or wrapped."""
    written = result["number"].replace(",", "").replace("\u2212", "-")
    stated = Fraction(written)
    precision = Fraction(1, 10 ** len(written.partition(".")[2]))
    digits = written.partition(".")[0].lstrip("-")
    if "." not in written and stated and len(digits) > 2 and digits.endswith("00"):
        precision = Fraction(10 ** (len(digits) - len(digits.rstrip("0")))) / 2  # a round number
    if abs(value - stated) < precision:
        return True
    if (result["sign"] != "=" or result["about"]) and abs(value - stated) <= abs(value) * _ABOUT:
        return True
    return value.denominator == 1 and any((value - stated) % modulus == 0 for modulus in _WRAPS)


def _finding(
    reading: Reading,
    text: str,
    expression: Expression,
    result: "re.Match[str]",
    place: Place,
    assertions: list[tuple[Place, str, Fraction | None]],
) -> Diagnostic:
    unit = f" {result['unit']}" if result["unit"] else ""
    words = text[expression.start : result.end()]
    formula = " ".join(text[expression.start : expression.end].split())
    message = f"{formula} is {_rounded(expression.value)}{unit}, not {result['number']}"
    stated = Fraction(result["number"].replace(",", "").replace("\u2212", "-"))
    off = abs(expression.value - stated)
    tolerances = [tolerance for _, _, tolerance in assertions if tolerance is not None and tolerance < off]
    if tolerances:
        message += f": {_rounded(off)} away, and the assertion allows {float(tolerances[0]):g}"
    related = [(where, said) for where, said, _ in assertions]
    return reading.found(RULE, place, words, message, None, related)


def _assertions(code: CodeBlock, line: Line, result: "re.Match[str]") -> Iterator[tuple[Place, str, Fraction | None]]:
    """The assertions of a block that demand the stated result, with what they tolerate."""
    demanded = re.compile(rf"(?<![\d.]){re.escape(result['number'])}(?![\d.])(?:{_TOLERANCE})?")
    for other in code.lines:
        if other is line or "assert" not in other.text.lower():
            continue
        found = demanded.search(other.text)
        if found:
            place = other.place._replace(column=other.place.column + found.start())
            tolerance = Fraction(found[1]) if found[1] and pattern(r"\d+(\.\d+)?").fullmatch(found[1]) else None
            yield place, "asserted here", tolerance


def _rounded(value: Fraction) -> str:
    """Five significant digits, as a reader would compare them."""
    return f"{float(value):.5g}" if abs(value) < 100000 else f"{float(value):.0f}"
