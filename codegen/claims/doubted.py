"""Columns, lists and blocks of which most lines differ from the dialect in the same way: the reading is doubted then.

Faults are a minority among statements that are right. Where most of the cells of a column contradict the dialect, the
column more likely tells something else (the units after scaling, the sizes of another thing) than it is wrong in
every row. So it is one finding, of the lowest certainty, at its heading.
"""

from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import NamedTuple

from codegen.claims.evidence import spans_at
from codegen.claims.parts.span import Span
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.rules import as_sure
from codegen.diagnostics import Diagnostic
from codegen.load.prose import CodeBlock, PassageKind
from codegen.once import once
from codegen.source import Place

_KINDS = {
    "claim-unit": "units",
    "claim-scaling": "factors",
    "claim-struct": "types",
    "claim-message-size": "sizes",
    "claim-message-id": "ids",
    "claim-crc-extra": "CRC_EXTRA",
    "claim-offset": "offsets",
    "claim-sentinel": "values for unknown",
    "claim-extension": "extensions",
    "claim-enum-value": "values",
    "claim-enum-of-field": "enums",
}
"""Names for the subject of a comparison, by the rules whose findings stand in columns and lists."""
_FEWEST = 3
"""Lines that have to differ before a whole column or list is doubted."""


class _Where(NamedTuple):
    """A column of a table, a list or a block of code, and the letter of the terms in it that are compared."""

    run: int
    column: int | None
    rule: str
    letter: str


def told(reading: Reading, found: Sequence[Diagnostic]) -> Iterator[Diagnostic]:
    """The findings, those of a column, list or block that mostly differs from the dialect as one."""
    counted = Counter(finding.rule.id for finding in found if finding.rule.id in _KINDS)
    if max(counted.values(), default=0) < _FEWEST:
        yield from found
        return
    groups: dict[_Where, list[Diagnostic]] = defaultdict(list)
    for finding in found:
        if counted[finding.rule.id] >= _FEWEST and (where := _where(reading, finding)) is not None:
            groups[where].append(finding)
    doubted = {where: group for where, group in groups.items() if _is_doubted(reading, where, group)}
    whole = {finding for group in doubted.values() for finding in group}
    yield from (finding for finding in found if finding not in whole)
    for where, group in doubted.items():
        yield _as_one(reading, where, sorted(group, key=lambda finding: finding.place))


def _where(reading: Reading, finding: Diagnostic) -> _Where | None:
    run = _runs(reading).get(finding.place.line)
    if run is None:
        return None
    for span, at in spans_at(reading, finding):
        if span.place(at) == finding.place:
            return _Where(run, _column(span, at), finding.rule.id, span.text[at])
    return None


def _column(span: Span, at: int) -> int | None:
    return span.text.count("|", 0, at) if span.kind is PassageKind.ROW else None


def _is_doubted(reading: Reading, where: _Where, group: Sequence[Diagnostic]) -> bool:
    """Return whether more than half of the lines that could be compared differ, and some of them."""
    wrong = len({finding.place.line for finding in group})
    return wrong >= _FEWEST and 2 * wrong > len(_comparable(reading, where))


def _comparable(reading: Reading, where: _Where) -> set[int]:
    """The lines of a column, list or block that have a term of the kind that is compared."""
    runs = _runs(reading)
    return {
        span.place(at).line
        for span in spans(reading)
        for at, _ in span.sentence.within(0, len(span.text), where.letter)
        if _column(span, at) == where.column and runs.get(span.place(at).line) == where.run
    }


def _as_one(reading: Reading, where: _Where, group: Sequence[Diagnostic]) -> Diagnostic:
    first, lines = group[0], _comparable(reading, where)
    title, place = _heading(reading, where) or ("here", first.place)
    wrong = len({finding.place.line for finding in group})
    text = f"{wrong} of {len(lines)} {_KINDS[where.rule]} {title} are not those of the dialect: {first.message}"
    hint = "what differs in most of its lines may be about something else, such as values after scaling"
    related = [(finding.place, finding.message) for finding in group]
    return reading.found(as_sure(first.rule, is_sure=False), place, f"{title} {first.message}", text, hint, related)


def _heading(reading: Reading, where: _Where) -> tuple[str, Place] | None:
    """The words for a column and the place of its heading; None for a list or a block."""
    if where.column is None:
        return None
    for span in spans(reading):
        if span.kind is PassageKind.ROW and _runs(reading).get(span.place(0).line) == where.run:
            start = next((at for at in range(len(span.text)) if _column(span, at) == where.column), 0)
            head = span.heads[where.column - span.text.lstrip().startswith("|")]
            return f'in column "{head}"', span.place(start + 1)
    return None


@once
def _runs(reading: Reading) -> dict[int, int]:
    """The number of the table, list or block of code by each of its lines."""
    found: dict[int, int] = {}
    runs = groupby(reading.prose.parts, lambda part: id(part) if isinstance(part, CodeBlock) else part.kind)
    for number, (kind, run) in enumerate(runs):
        if isinstance(kind, int) or kind in (PassageKind.ROW, PassageKind.ITEM):
            for part in run:
                found.update(dict.fromkeys(range(part.place.line, part.last_line + 1), number))
    return found
