"""Columns of rates in a project's own documents: | HEARTBEAT | 1 Hz |, beside the streams of its messages."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import groupby

from codegen.claims.field_notes import cells
from codegen.claims.own.stream_rate import RATE, SECONDS, rate_of
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic
from codegen.load.prose import Passage, PassageKind
from codegen.model.units.unit import decimal
from codegen.pattern import pattern

_HEAD = pattern(
    r"(?i)(?:(?:default|nominal|normal|stream|send(?:ing)?|transmi(?:t|ssion)|update|message) )?"
    r"(?P<what>rate|frequency|period|interval|cycle(?: time)?)(?:(?: in|,)? [\[(]?(?P<unit>Hz|ms|s)[\])]?)?"
)
_NUMBER = r"(?P<number>\d{1,5}(?:\.\d{1,3}|,\d{1,2})?)"
_CELL = pattern(
    rf"(?:{_NUMBER} ?(?P<unit>Hz|ms|s|/ ?s|min)?|(?P<times>once|twice) (?:per|a|each|every) (?P<per>second|minute))"
)
_NAME = pattern(r"[`*]*([A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*)[`*]*(?: \(#?\d{1,8}\))?")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every column of rates of which half of the known messages have that of their stream: the others are wrong."""
    rates = reading.reference.rates
    for kind, run in groupby(reading.prose.passages, lambda passage: passage.kind) if rates else ():
        if kind is PassageKind.ROW:
            yield from _table(reading, list(run))


def _table(reading: Reading, rows: Sequence[Passage]) -> Iterator[Diagnostic]:
    heads = [text.strip() for text, _ in cells(rows[0])]
    for column, head in enumerate(heads):
        if (said := _HEAD.fullmatch(head)) is None:
            continue
        told = list(_told(reading, rows[1:], len(heads), column, said["unit"]))
        wrong = [one for one in told if one[2] not in reading.reference.rates[one[0]]]
        for name, text, _, row, offset in wrong if 2 * len(wrong) <= len(told) else ():
            shown = " or ".join(f"{decimal(each)} Hz" for each in reading.reference.rates[name])
            yield reading.found(
                RATE, row.place_at(offset), f"{name} at {text}", f"{name} is sent at {shown}, not {text} ({head})"
            )


def _told(
    reading: Reading, rows: Sequence[Passage], width: int, column: int, unit: str | None
) -> Iterator[tuple[str, str, Fraction, Passage, int]]:
    """Yield the messages of the project with the rates that their rows state, and where."""
    for row in rows:
        own = cells(row)
        named = [found[1] for text, _ in own if (found := _NAME.fullmatch(text.strip()))]
        sent = [name for name in named if name in reading.reference.rates]
        if len(own) != width or len(sent) != 1:
            continue
        text, offset = own[column]
        rate = _rate(text.strip(), unit)
        if rate is not None:
            yield sent[0], text.strip(), rate, row, offset


def _rate(text: str, unit: str | None) -> Fraction | None:
    """Return in Hz what a cell states; None where it states no rate."""
    found = _CELL.fullmatch(text)
    if found is None:
        return None
    if found["times"]:
        return Fraction(2 if found["times"] == "twice" else 1, SECONDS[found["per"][0]])
    number, named = Fraction(found["number"].replace(",", ".")), (found["unit"] or unit or "").replace(" ", "")
    if named in ("Hz", "/s"):
        return number
    return rate_of(number, named) if named else None
