"""Tables and statements of what counts of the converter stand for: "| 3000 | 3.95 | 9.549451 | 9549 |"."""

import re
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction

from codegen.claims.own.worked.amount import Amount, amounts, of_unit
from codegen.claims.own.worked.examples import Examples, Row, Statement, Table
from codegen.claims.own.worked.readings import Measured, factor_names, measured
from codegen.diagnostics import Diagnostic
from codegen.load.prose import Passage
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_COUNT = pattern(r"(?:ADC )?counts?", re.IGNORECASE)
_NEAREST = pattern(r"nearest (?:ADC )?count", re.IGNORECASE)
_KEPT = pattern(r"round|convert|stored|kept", re.IGNORECASE)
_SIDE = pattern(r"(?P<side>below|above) (?=[\d-])", re.IGNORECASE)
_ONE = pattern(r"\b(?:one|a single) (?:count|step)(?: of the (?:ADC|converter))?(?:,| is| =|:)? (?=\d)", re.IGNORECASE)
_SAID = pattern(r"\bcount (?P<before>\d{1,6})\b(?![.\d])|\b(?P<behind>\d{1,6}) counts\b", re.IGNORECASE)
_DEFAULT = pattern(r"\bdefault multiplier of (?=\d)", re.IGNORECASE)
_FULL = pattern(r"\bfull[- ]scale\b", re.IGNORECASE)


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every table with a column of counts, every statement about a count, the step of one and full scale."""
    if not examples.systems:
        return
    for table in examples.tables:
        yield from _table(examples, table)
        for row in table.rows:
            yield from _one(examples, row.passage)
    for passage in examples.texts:
        yield from _one(examples, passage)
    for statement in examples.statements:
        yield from _statement(examples, statement)


def _table(examples: Examples, table: Table) -> Iterator[Diagnostic]:
    nearest = table.column(_NEAREST)
    column = table.column(_COUNT) if nearest is None else nearest
    known = factor_names(examples.systems)
    named = {index: head for index, head in enumerate(table.heads) if head in known}
    stated = _stated(table, known)
    if table.intro is not None:
        yield from _default(examples, table.intro)
    for row in table.rows if column is not None else ():
        count = row.only(column)
        given = {name: row.only(index) for index, name in named.items()}
        if count is None or not count.is_plain or None in given.values():
            continue
        factors = {name: each.value for name, each in given.items() if each is not None} or stated
        for index in range(len(row.entries)):
            if index in (column, *named):
                continue
            if nearest is None or _KEPT.search(table.heads[index]):
                yield from _result(examples, table, row, index, count.value, factors)
            elif index == 0:
                yield from _nearest(examples, table, row, index, count)


def _stated(table: Table, names: Iterable[str]) -> Mapping[str, Fraction]:
    """Return the values that the text before a table gives to factors, by their names: "with NAME 4.0158"."""
    text = table.intro.text if table.intro is not None else ""
    found = {}
    for name in names:
        said = re.search(rf"\b{name} (?=\d)", text)
        number = amounts(text, said.end(), said.end() + 16)[:1] if said else ()
        if number:
            found[name] = number[0].value
    return found


def _default(examples: Examples, passage: Passage) -> Iterator[Diagnostic]:
    """ "at the default multiplier of 3.95"."""
    for said in _DEFAULT.finditer(passage.text):
        number = amounts(passage.text, said.end(), said.end() + 16)[:1]
        factors = [each.factors[0] for each in measured(examples.systems, None)]
        defaults = [each.default * each.step for each in factors]
        for amount in number:
            yield from examples.judged(passage, amount, defaults, "the default multiplier")


def _result(
    examples: Examples, table: Table, row: Row, index: int, count: Fraction, factors: Mapping[str, Fraction]
) -> Iterator[Diagnostic]:
    """An entry beside a count: an amount, or whether the count is below or above the one of the heading."""
    head, entry = table.heads[index], row.entries[index]
    found = table.amount(row, index)
    side = _SIDE.match(head)
    limit = amounts(head, side.end())[:1] if side else ()
    if found is not None and not found.is_plain:
        sources = measured(examples.systems, found.unit, factors)
        is_kept = _KEPT.search(head) is not None or not factors
        turned = ((each.kept if is_kept else each.value)(count, factors, found.unit) for each in sources)
        expected = [value for value in turned if value is not None]
        yield from examples.judged(row.passage, found, expected, f"count {count}")
    elif side is not None and limit and entry.text in ("yes", "no"):
        unit = limit[0].unit
        sources = measured(examples.systems, unit, factors)
        values = [value for each in sources if (value := each.kept(count, factors, unit)) is not None]
        is_below = side["side"].lower() == "below"
        answers = {"yes" if (value < limit[0].value) == is_below else "no" for value in values}
        if answers and entry.text not in answers:
            text = f"count {count} is {float(values[0]):g} {unit.name}, so that {head} is {answers.pop()}"
            yield examples.wrong(row.passage, entry.start, text)


def _nearest(examples: Examples, table: Table, row: Row, index: int, count: Amount) -> Iterator[Diagnostic]:
    """The count that comes nearest to an amount."""
    wanted = table.amount(row, index)
    if wanted is None:
        return
    expected = []
    for each in measured(examples.systems, wanted.unit):
        step = _step(each, wanted.unit)
        zero = each.value(Fraction(0), {}, wanted.unit)
        if step and zero is not None:
            expected.append(Fraction(round((wanted.value - zero) / step)))
    words = f"the count nearest to {wanted.written} {wanted.unit.name}"
    yield from examples.judged(row.passage, count, expected, words)


def _one(examples: Examples, passage: Passage) -> Iterator[Diagnostic]:
    """ "one count is 3.183 mV", "one count of the ADC, 3.183 mV": with the default factors."""
    for said in _ONE.finditer(passage.text):
        found = amounts(passage.text, said.end(), said.end() + 40)[:1]
        for amount in found:
            steps = [_step(each, amount.unit) for each in measured(examples.systems, amount.unit)]
            steps += [each.at_pin(Fraction(1), amount.unit) for each in measured(examples.systems, amount.unit)]
            yield from examples.judged(passage, amount, [step for step in steps if step], "one count")


def _step(each: Measured, unit: Unit) -> Fraction | None:
    one, zero = each.value(Fraction(1), {}, unit), each.value(Fraction(0), {}, unit)
    return None if one is None or zero is None else one - zero


def _statement(examples: Examples, statement: Statement) -> Iterator[Diagnostic]:
    """ "Count 3770 with the calibrated 4.0158 | 12200 mV", "Full scale at the default multiplier | 13.035 V"."""
    value, label = statement.value.alone, statement.label
    if value is None or value.is_plain:
        return
    said, full = _SAID.search(label.text), _FULL.search(label.text)
    plain = [each for each in label.amounts if each.is_plain and each.places]
    others = [each for each in label.amounts if not (each.is_plain and (each.places or said))]
    if (said is None and full is None) or len(plain) > 1 or of_unit(label.amounts, value.unit) or others:
        return
    expected = []
    for each in measured(examples.systems, value.unit):
        number = Fraction(said["before"] or said["behind"]) if said else Fraction(each.conversion.channel.full_scale)
        factors = {each.first: plain[0].value} if plain else {}
        exact = [each.value(number, factors, value.unit), each.kept(number, factors, value.unit)]
        exact += [each.at_pin(number, value.unit)] if full is not None else []
        expected += [found for found in exact if found is not None]
    words = f"count {said['before'] or said['behind']}" if said else "full scale"
    yield from examples.judged(statement.passage, value, expected, words)
