"""Results of formulas that a document states in code, with the values that a statement gives to their names."""

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import islice

from codegen.claims.own.worked.amount import Amount, amounts
from codegen.claims.own.worked.examples import Examples, Statement
from codegen.claims.own.worked.readings import measured
from codegen.diagnostics import Diagnostic
from codegen.load.expression import expression_before
from codegen.load.prose import Passage
from codegen.model.units.unit import decimal
from codegen.pattern import pattern

_FORMULA = pattern(r"(?P<name>[A-Za-z_]\w*) = (?P<expression>[\w\s.*/+()-]{3,200})")
_MOST = 50
"""The most formulas of a document that are looked at."""
_NAME = pattern(r"[A-Za-z_]\w*")
_LARGEST = pattern(r"largest (?:intermediate|product|value) of $", re.IGNORECASE)


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every statement that names all variables of a formula, and every "largest intermediate of" an expression."""
    formulas = list(islice(dict.fromkeys(_formulas(examples)), _MOST))
    for statement in examples.statements:
        value = statement.value.only
        if value is None:
            continue
        made = {each: _result(each, given) for each in formulas if (given := _given(statement, each)) is not None}
        if made:
            yield from _judged(examples, statement, value, list(made.values()), " or ".join(made))
        span = _code(statement)
        if span and _LARGEST.match(statement.label.text[: span[0] - statement.label.start]):
            formula = statement.passage.text[span[0] : span[1]]
            yield from _judged(
                examples, statement, value, [_result(formula, each) for each in _most(examples)], formula
            )


def _formulas(examples: Examples) -> Iterator[str]:
    """The right sides of the formulas of a document that have at least two names."""
    for passage in examples.reading.prose.passages:
        for low, high in passage.codes if " = " in passage.text else ():
            found = _FORMULA.fullmatch(passage.text[low:high])
            if found is not None and len(set(_NAME.findall(found["expression"]))) > 1:
                yield found["expression"]


def _given(statement: Statement, formula: str) -> Mapping[str, Fraction] | None:
    """The numbers that stand behind the names of a formula in a label; None where one of them has none."""
    found = {}
    for name in set(_NAME.findall(formula)):
        said = re.search(rf"\b{name} (?=[-\d])", statement.label.text)
        number = amounts(statement.label.text, said.end(), said.end() + 24)[:1] if said else ()
        if not number:
            return None
        found[name] = number[0].value
    return found


def _most(examples: Examples) -> Iterator[Mapping[str, Fraction]]:
    """The largest ``count`` and the most ``steps`` of a multiplier, for each conversion of the project."""
    for each in measured(examples.systems, None):
        full = each.conversion.channel.full_scale
        yield {"count": Fraction(full), "steps": Fraction(each.factors[0].maximum)}


def _result(formula: str, given: Mapping[str, Fraction]) -> Fraction | None:
    """Return the result of a formula with numbers for its names; None where it has other names, or is no arithmetic."""
    if not set(_NAME.findall(formula)) <= given.keys():
        return None
    text = _NAME.sub(lambda name: decimal(given[name[0]]), formula)
    found = expression_before(text, len(text))
    return found.value if found is not None and found.start == 0 else None


def _judged(
    examples: Examples, statement: Statement, value: Amount, results: list[Fraction | None], formula: str
) -> Iterator[Diagnostic]:
    expected = [each for each in results if each is not None]
    yield from examples.judged(statement.passage, value, expected, f"{statement.label.text}, by {formula},")


def _code(statement: Statement) -> tuple[int, int] | None:
    """The bounds of the one code span of a label."""
    passage: Passage = statement.passage
    end = statement.label.start + len(statement.label.text)
    spans = [span for span in passage.codes if statement.label.start <= span[0] < end]
    return spans[0] if len(spans) == 1 else None
