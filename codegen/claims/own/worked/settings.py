"""Values of parameters in worked examples: what they mean, whether they are accepted, where they stand."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.own.worked.amount import amounts
from codegen.claims.own.worked.examples import Entry, Examples, Row, Table
from codegen.diagnostics import Diagnostic
from codegen.load.prose import Passage
from codegen.model.vehicle import Parameter
from codegen.pattern import pattern

_SET = pattern(r"(?P<name>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+) (?=-?\d)")
_ANSWERED = pattern(r"(?:value )?answered|answer", re.IGNORECASE)
_REFUSED = pattern(r"the old one\b")
_ONLY = pattern(r"\bonly (?P<numbers>\d{1,6}(?:, \d{1,6})*,? (?:and|or) \d{1,6}) (?:are|is) accepted")
_FROM = pattern(r"\b(?P<prefix>[A-Z][A-Z0-9]*_)\)? from (?P<low>\d{1,4}) to (?P<high>\d{1,4})\b")
_NUMBERED = pattern(r"\bparameters are numbered\b", re.IGNORECASE)
_DEFAULT = pattern(r"default of (?P<name>[A-Z][A-Z0-9_]+)", re.IGNORECASE, needs="default")
_ENTRY = pattern(r"(?P<name>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+){2,}), (?=\d)")
_WORDS = pattern(r",? ?(?P<words>[^(]*)")


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every table and text about parameters; entries of enums in tables that have their number behind them."""
    said = any(_ENTRY.match(entry.text) for table in examples.tables for row in table.rows for entry in row.entries)
    enums = examples.reading.enums.values() if said else ()
    entries = {entry.name: entry.value for enum in enums for entry in enum.entries}
    for table in examples.tables:
        for row in table.rows:
            for index, entry in enumerate(row.entries):
                yield from _entry(examples, row, entry, entries)
                head = table.heads[index] if index < len(table.heads) else ""
                for parameter in _parameters(examples, head):
                    yield from _meaning(examples, row, entry, parameter)
            yield from _set(examples, table, row)
            yield from _defaults(examples, table, row)
    for passage in examples.texts:
        yield from _places(examples, passage)


def _parameters(examples: Examples, name: str) -> tuple[Parameter, ...]:
    return tuple(system.parameters[name] for system in examples.systems if name in system.parameters)


def _entry(examples: Examples, row: Row, entry: Entry, entries: dict[str, int]) -> Iterator[Diagnostic]:
    """ "MAV_PARAM_TYPE_REAL32, 9"."""
    named = _ENTRY.match(entry.text)
    number = entry.amounts[0] if entry.amounts else None
    is_value = number is not None and number.is_plain and number.end == entry.start + len(entry.text)
    if named is not None and named["name"] in entries and number is not None and is_value:
        yield from examples.judged(row.passage, number, [Fraction(entries[named["name"]])], named["name"])


def _meaning(examples: Examples, row: Row, entry: Entry, parameter: Parameter) -> Iterator[Diagnostic]:
    """ "3, analog voltage only" below the name of a parameter: the number of the choice of these words."""
    number = entry.alone
    if number is None or not parameter.choices:
        return
    words = _WORDS.match(entry.text, number.end - entry.start)
    said = words["words"].strip().casefold() if words else ""
    meant = [steps * parameter.step for steps, meaning in parameter.choices.items() if meaning.casefold() == said]
    yield from examples.judged(row.passage, number, meant, f"{parameter.name}, {said},")


def _set(examples: Examples, table: Table, row: Row) -> Iterator[Diagnostic]:
    """ "BATT_VOLT_MULT 4.01583 | 4.0158", "BATT_LOW_TIMER 121 | the old one": below "PARAM_SET" and "answered"."""
    named = _SET.match(row.entries[0].text)
    answered = row.at(table.column(_ANSWERED))
    if named is None or answered is None or table.heads[0] != "PARAM_SET":
        return
    value = next(iter(row.entries[0].amounts), None)
    for parameter in _parameters(examples, named["name"])[:1] if value is not None else ():
        assert value is not None
        steps = round(value.value / parameter.step)
        taken = parameter.minimum <= steps <= parameter.maximum and steps in (parameter.choices or (steps,))
        if answered.alone is not None and not taken:
            yield examples.wrong(row.passage, value.start, f"{parameter.name} does not accept {value.written}")
        elif answered.alone is not None:
            nearest = [steps * parameter.step]
            yield from examples.judged(row.passage, answered.alone, nearest, f"the answer to {row.entries[0].text}")
        elif _REFUSED.match(answered.text) and taken:
            yield examples.wrong(row.passage, value.start, f"{parameter.name} accepts {value.written}")
        yield from _only(examples, row, answered, parameter)


def _only(examples: Examples, row: Row, entry: Entry, parameter: Parameter) -> Iterator[Diagnostic]:
    """ "only 0, 3 and 4 are accepted"."""
    said = _ONLY.search(entry.text)
    if said is None or not parameter.choices:
        return
    accepted = {steps * parameter.step for steps in parameter.choices}
    if {each.value for each in amounts(said["numbers"])} != accepted:
        shown = ", ".join(f"{float(each):g}" for each in sorted(accepted))
        at = entry.start + said.start("numbers")
        yield examples.wrong(row.passage, at, f"{parameter.name} accepts {shown}, not only {said['numbers']}")


def _defaults(examples: Examples, table: Table, row: Row) -> Iterator[Diagnostic]:
    """ "Default of NAME" below a heading that counts what its default is for one of."""
    for index, head in enumerate(table.heads):
        named, found = _DEFAULT.fullmatch(head), row.only(index)
        for parameter in _parameters(examples, named["name"])[:1] if named and found is not None else ():
            fact = parameter.spec.per
            place = next((each for each, title in enumerate(table.heads) if title.casefold() == fact), None)
            counted = row.only(place)
            own = _count(examples, parameter)
            value = found.in_unit(parameter.unit) if found is not None else None
            if counted is not None and own and value is not None and found is not None:
                default = parameter.default * parameter.step / own * counted.value
                factor = found.value / value if value else Fraction(1)
                words = f"the default of {parameter.name} for {counted.written} {fact}"
                yield from examples.judged(row.passage, found, [default * factor], words)


def _count(examples: Examples, parameter: Parameter) -> int | None:
    """Return how many things the default of a parameter is for (those of its ``per``); None where it has no ``per``."""
    for system in examples.systems:
        component = system.components.get(parameter.component or "")
        if component is not None and parameter.spec.per is not None:
            return component.parts[parameter.instance].count(parameter.spec.per)
    return None


def _places(examples: Examples, passage: Passage) -> Iterator[Diagnostic]:
    """ "those of the second one (BATT2_) from 1 to 16": places in the sorted list."""
    for said in _FROM.finditer(passage.text) if _NUMBERED.search(passage.text) else ():
        for key in ("low", "high"):
            expected = []
            for system in examples.systems:
                indexes = [i for i, name in enumerate(sorted(system.parameters)) if name.startswith(said["prefix"])]
                expected += [Fraction(indexes[0] if key == "low" else indexes[-1])] if indexes else []
            number = amounts(passage.text, said.start(key), said.end(key))[0]
            place = "first" if key == "low" else "last"
            yield from examples.judged(passage, number, expected, f"the {place} index of {said['prefix']}")
