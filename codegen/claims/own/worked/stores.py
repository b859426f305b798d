"""Tables of what is left of a store: what was taken of the parameter that says how large it is."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.own.worked.amount import Amount, amounts
from codegen.claims.own.worked.examples import Examples, Row, Table
from codegen.diagnostics import Diagnostic
from codegen.model.units.unit import Unit, unit_named
from codegen.pattern import pattern

_LEFT = pattern(r"\b(?:left|remaining|rest)\b", re.IGNORECASE)
_PERCENT, _SECOND = unit_named("%"), unit_named("s")


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every table below a text that names the parameter of a store with a value: "of NAME 3300 mAh"."""
    names = set(_stores(examples))
    for table in examples.tables:
        full = _full(table, names) if names else None
        for row in table.rows if full is not None else ():
            if full is not None:
                yield from _row(examples, table, row, full)


def _stores(examples: Examples) -> Iterator[str]:
    """The names of the parameters that say how much a store holds."""
    for system in examples.systems:
        for component in system.components.values():
            for quantity in component.quantities.values():
                if quantity.derivation.remains is not None:
                    full = quantity.derivation.remains.full
                    yield from full.siblings or (full.name,)


def _full(table: Table, names: set[str]) -> Amount | None:
    """The amount behind the one name in the text before a table."""
    text = table.intro.text if table.intro is not None else ""
    found = [(name, at) for name in sorted(names) if (at := text.find(f"{name} ")) >= 0]
    behind = amounts(text, found[0][1] + len(found[0][0]))[:1] if len(found) == 1 else ()
    return behind[0] if behind and not behind[0].is_plain else None


def _row(examples: Examples, table: Table, row: Row, full: Amount) -> Iterator[Diagnostic]:
    """Taken and left, in the unit of the store; then the share, and the time at a rate that makes one of both."""
    found = [each for index in range(len(row.entries)) if (each := table.amount(row, index)) is not None]
    store = [each for each in found if each.like(full.unit)]
    if len(store) != 2 or not full.value or not any(_LEFT.search(head) for head in table.heads):
        return
    taken, left = (each.in_unit(full.unit) or Fraction(0) for each in store)
    rest = max(full.value - taken, Fraction(0))
    factor = full.unit.scale / store[1].unit.scale
    yield from examples.judged(
        row.passage, store[1], [rest * factor], f"what {store[0].written} leaves of {full.written}"
    )
    drawn = Unit.parse(f"{full.unit.name}/s")
    rates = [each for each in found if drawn is not None and each.like(drawn)]
    for each in found:
        if each.like(_PERCENT):
            yield from examples.judged(row.passage, each, [100 * rest / full.value], f"the share of {store[1].written}")
        elif each.like(_SECOND) and len(rates) == 1 and rates[0].value:
            seconds = left * full.unit.scale / (rates[0].value * rates[0].unit.scale) / each.unit.scale
            yield from examples.judged(row.passage, each, [seconds], f"the time of {store[1].written}")
