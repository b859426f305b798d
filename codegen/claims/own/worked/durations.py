"""Statements about times and rates: periods, shares of a time, how often one fits into another."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.own.worked.amount import Amount, of_unit
from codegen.claims.own.worked.examples import Examples, Statement
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.model.units.unit import Unit, unit_named
from codegen.pattern import pattern

SECOND, HERTZ, PERCENT = (unit_named(name) for name in ("s", "Hz", "%"))
_DAY = Fraction(86400)
_TURN = {"ticks_us": Fraction(2**30, 10**6), "ticks_ms": Fraction(2**30, 10**3)}
"""Seconds after which the clocks of MicroPython begin anew. Source: its documentation of ``time.ticks_ms()``."""
_PERIOD = pattern(r"period of ", re.IGNORECASE)
_LOOP = pattern(r"\b(?:control slots?|main loop|passes|(?:one )?pass|slots)\b", re.IGNORECASE)
_NAMED_LOOP = pattern(r"\bmain loop\b", re.IGNORECASE)
_SHARE = pattern(r"(?:share|load) of ", re.IGNORECASE)
_WITHIN = pattern(r"\bwithin ", re.IGNORECASE)
_FITS = pattern(r"\b(?P<word>holds|fit|takes)$", re.IGNORECASE)
_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")
_ORDINAL = pattern(rf"\bfrom the last .{{1,40}} to the (?P<ordinal>{'|'.join(_ORDINALS)}) \w+ at ", re.IGNORECASE)
_RATE_OF = pattern(r"\bof (?P<count>\d{1,9}) (?P<what>[a-z]+) at (?P<rate>\d{1,9}) (?P=what) per second\b")
_BAUD = pattern(r"\b(?P<baud>\d{3,7}) baud, (?P<bits>[1-9]\d?) bits per byte\b")
_THAT = pattern(r"% of that ")
_UPDATE = pattern(r"\b(?P<component>[a-z_]+) update\b")
_ADDS = pattern(r"\bloop that adds (?=\d)")
_ONE_DAY = pattern(r"\b(?:in|of) (?:one|a) day\b")
_ONE_TURN = pattern(r"\b(?:one|a) turn of (?P<clock>ticks_[mu]s)\b")
BYTES_PER_SECOND = unit_named("bytes/s")


@dataclass(frozen=True, slots=True)
class _Said:
    """A label with its times in seconds and its rates in Hz."""

    label: str
    times: tuple[Fraction, ...]
    rates: tuple[Fraction, ...]

    def periods(self, examples: Examples) -> list[Fraction]:
        """The seconds of the rates that it states, or of the main loop where it is about that."""
        stated = [1 / rate for rate in self.rates if rate]
        return stated or (_periods(examples) if _LOOP.search(self.label) else [])


def check(examples: Examples) -> Iterator[Diagnostic]:
    """Every statement about times; a link's bytes per second hold for "of that link" in statements below."""
    link: Fraction | None = None
    for statement in examples.statements:
        value = statement.value.alone
        if value is None:
            continue
        baud = _BAUD.search(statement.label.text)
        if baud is not None and value.like(BYTES_PER_SECOND):
            link = Fraction(int(baud["baud"]), int(baud["bits"]))
            yield from _judged(examples, statement, value, link, BYTES_PER_SECOND, "a link")
        elif link is not None and _THAT.search(statement.value.text) and value.like(BYTES_PER_SECOND):
            share = of_unit(statement.value.amounts, PERCENT)[:1]
            taken = value.in_unit(BYTES_PER_SECOND) or Fraction(0)
            for each in share:
                yield from _judged(
                    examples, statement, each, 100 * taken / link, PERCENT, f"{value.written} of that link"
                )
        else:
            yield from _timed(examples, statement, value)


def _timed(examples: Examples, statement: Statement, value: Amount) -> Iterator[Diagnostic]:
    label = statement.label.text
    said = _Said(
        label,
        tuple(each.in_unit(SECOND) or Fraction(0) for each in of_unit(statement.label.amounts, SECOND)),
        tuple(each.in_unit(HERTZ) or Fraction(0) for each in of_unit(statement.label.amounts, HERTZ)),
    )
    for rate in of_unit(statement.label.amounts, HERTZ) if _NAMED_LOOP.search(label) else ():
        own = [HERTZ.scale / (period * rate.unit.scale) for period in _periods(examples)]
        yield from examples.judged(statement.passage, rate, own, "the rate of the main loop")
    if value.like(SECOND):
        yield from _any(examples, statement, value, _seconds(examples, said), SECOND)
    elif value.like(PERCENT) and _SHARE.match(label) and len(said.times) == 1:
        shares = [100 * said.times[0] / period for period in said.periods(examples)]
        yield from _any(examples, statement, value, shares, PERCENT)
    elif value.is_plain and _WITHIN.search(label) and len(said.times) == len(said.rates) == 1:
        yield from _any(examples, statement, value, [said.times[0] * said.rates[0]], value.unit)
    elif value.is_plain and (fits := _FITS.search(label)):
        yield from _fitting(examples, statement, value, is_whole=fits["word"].lower() != "takes")
    elif value.is_plain and _LOOP.search(label) and not statement.label.amounts:
        yield from _any(examples, statement, value, _slots(examples, label), value.unit)


def _seconds(examples: Examples, said: _Said) -> list[Fraction]:
    """The seconds that a label states in other words; none where it does not."""
    counted, ordinal = _RATE_OF.search(said.label), _ORDINAL.search(said.label)
    if _PERIOD.match(said.label) and not said.times:
        return said.periods(examples)
    if counted is not None and int(counted["rate"]):
        return [Fraction(int(counted["count"]), int(counted["rate"]))]
    if ordinal is not None and len(said.rates) == 1 and said.rates[0]:
        return [(_ORDINALS.index(ordinal["ordinal"].lower()) + 1) / said.rates[0]]
    if len(said.times) == 1 and _ADDS.search(said.label) and _ONE_DAY.search(said.label):
        return [_DAY / period * said.times[0] for period in _periods(examples)]
    return []


def _slots(examples: Examples, label: str) -> list[Fraction]:
    """Return how often the main loop runs in a day, in one turn of a clock, or between updates of a component."""
    turn, update = _ONE_TURN.search(label), _UPDATE.search(label)
    if _ONE_DAY.search(label):
        return [_DAY / each for each in _periods(examples)]
    if turn is not None:
        return [_TURN[turn["clock"]] / each for each in _periods(examples)]
    found = []
    for system in examples.systems:
        component = system.components.get(update["component"]) if update else None
        if component is not None and component.period_ms and system.program:
            found.append(Fraction(component.period_ms * 1000, system.program.control_us))
    return found


def _fitting(examples: Examples, statement: Statement, value: Amount, *, is_whole: bool) -> Iterator[Diagnostic]:
    """ "Frames (48 bytes) that a buffer of 1024 bytes holds | 21": how often the first fits into the second."""
    if len(statement.label.amounts) != 2:
        return
    one, whole = statement.label.amounts
    part = one.in_unit(whole.unit)
    if part and not one.is_plain:
        count = whole.value // part if is_whole else -(-whole.value // part)
        yield from _any(examples, statement, value, [Fraction(count)], value.unit)


def _any(
    examples: Examples, statement: Statement, value: Amount, expected: list[Fraction], unit: Unit
) -> Iterator[Diagnostic]:
    """A finding where a value is none of what is expected, in ``unit``."""
    factor = unit.scale / value.unit.scale if not value.is_plain else Fraction(1)
    words = statement.label.text[:1].lower() + statement.label.text[1:]
    yield from examples.judged(statement.passage, value, [each * factor for each in expected], words)


def _judged(
    examples: Examples, statement: Statement, value: Amount, expected: Fraction, unit: Unit, of: str
) -> Iterator[Diagnostic]:
    yield from examples.judged(statement.passage, value, [expected * unit.scale / value.unit.scale], of)


def _periods(examples: Examples) -> list[Fraction]:
    """The seconds of one pass of the main loop of each program."""
    found = (system.program.control_us for system in examples.systems if system.program is not None)
    return [Fraction(each, 10**6) for each in dict.fromkeys(found)]
