"""Findings that nobody would read to the end: of each kind as many are shown as tell what is wrong."""

from collections import Counter
from collections.abc import Iterable

from codegen.diagnostics import MOST, Diagnostic, Report


def shortened(findings: Iterable[Diagnostic]) -> Report:
    """The first ``MOST`` findings of each rule, and one that counts the others, at the place of their first."""
    report = Report()
    report.extend(findings)
    counts: Counter[str] = Counter()
    shown = Report()
    left_out: dict[str, Diagnostic] = {}
    for finding in report:
        counts[finding.rule.id] += 1
        if counts[finding.rule.id] <= MOST:
            shown.extend([finding])
        else:
            left_out.setdefault(finding.rule.id, finding)
    for rule, first in left_out.items():
        message = f"{counts[rule] - MOST:,} more of these, of which this is the first, are not shown"
        shown.extend(
            [Diagnostic(first.place, first.rule, message, hint="correct these first; what is left is shown then")]
        )
    return shown
