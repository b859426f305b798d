"""Waivers meet findings: which findings are waived, and which waivers are of no use any more."""

import os
import re
from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace
from datetime import date

from codegen.diagnostics import Diagnostic, Report, Rule, Severity
from codegen.findings.fingerprint import LENGTH
from codegen.frozen import dataclass
from codegen.model.spec.waiver import WaiverSpec
from codegen.pattern import pattern

WAIVER_UNUSED = Rule(
    "waiver-unused",
    "Nothing is found any more that the waiver is for: what it excused was corrected, or reworded and then counts "
    "again. Remove the waiver, or give it the fingerprint of the new finding. Only waivers for rules and documents "
    "that the run looked at are reported.",
    Severity.WARNING,
)
WAIVER_EXPIRED = Rule(
    "waiver-expired",
    "The day of the waiver has come, so what it excused counts again. Correct that, or decide anew and give the waiver "
    "a later day.",
    Severity.WARNING,
    remedy="correct what it excuses, or give it a later day with a new reason",
)
WAIVER_DUPLICATE = Rule(
    "waiver-duplicate",
    "Two waivers have the same id, or are for the same finding. It would be unclear which reason and which day hold; "
    "the first one does. Remove one, or rename it.",
    remedy="remove one of the two, or rename it",
)
WAIVER_RULE = Rule(
    "waiver-unknown-rule",
    "A waiver is for a rule that does not exist, so it would never be used. The id of a rule stands after 'error' or "
    "'warning' of a finding, and 'codegen explain RULE_ID' tells about it.",
    remedy="write the id that stands behind error or warning of the finding",
)
WAIVER_FORM = Rule(
    "waiver-form",
    "A waiver names a fingerprint of 12 hex digits, the day from which the finding counts again, as in 2027-06-30, a "
    "reason and an owner; a severity that is set has a reason. One that lacks something of that is not applied.",
)

_FINGERPRINT = pattern(rf"[0-9a-f]{{{LENGTH}}}", re.IGNORECASE)
_DAY = pattern(r"\d{4}-\d\d-\d\d", re.ASCII)


@dataclass(frozen=True, slots=True)
class LookedAt:
    """The scope of a run: the ids of its rules, and its files (absolute paths)."""

    rules: Collection[str]
    files: Collection[str]

    def covers(self, waiver: WaiverSpec) -> bool:
        """Return whether the run would have found what the waiver is for."""
        return waiver.rule in self.rules and any(_is_about(waiver.document, file) for file in self.files)


@dataclass(frozen=True, slots=True)
class _Readable:
    """A waiver with its day."""

    waiver: WaiverSpec
    day: date

    @property
    def key(self) -> tuple[str, str]:
        return self.waiver.rule, self.waiver.fingerprint.lower()


def apply_waivers(
    findings: Iterable[Diagnostic],
    waivers: Sequence[WaiverSpec],
    today: date,
    looked_at: LookedAt,
    is_rule: Callable[[str], bool],
) -> list[Diagnostic]:
    """The findings, those with a waiver marked as waived, and what is wrong with the waivers, at their own lines.

    A waiver is for the findings of its rule that have its fingerprint and stand in its document. ``is_rule`` says
    whether a rule exists; it is asked only about rules that ``looked_at`` does not have.
    """
    report = Report()
    usable = _usable(waivers, looked_at, is_rule, report)
    used: set[tuple[str, str]] = set()
    told = []
    for finding in findings:
        readable = usable.get((finding.rule.id, finding.fingerprint or ""))
        if readable is None or not _is_about(readable.waiver.document, finding.place.file):
            told.append(finding)
            continue
        used.add(readable.key)
        told.append(_judged(finding, readable, today, report))
    for key, readable in usable.items():
        if key not in used and looked_at.covers(readable.waiver):
            message = f"{readable.waiver.id} is not used: {readable.waiver.rule} finds no such thing any more"
            report.add(WAIVER_UNUSED, readable.waiver.place, message, "remove it")
    return [*told, *report]


def _usable(
    waivers: Sequence[WaiverSpec], looked_at: LookedAt, is_rule: Callable[[str], bool], report: Report
) -> dict[tuple[str, str], _Readable]:
    """The waivers that can be applied by rule and fingerprint; of two for one finding the first."""
    usable: dict[tuple[str, str], _Readable] = {}
    names: dict[str, WaiverSpec] = {}
    for waiver in waivers:
        first = names.setdefault(waiver.id, waiver)
        if first is not waiver:
            related = [(first.at("id"), "the first one")]
            report.add(WAIVER_DUPLICATE, waiver.at("id"), f"there is a waiver {waiver.id} already", related=related)
        readable = _read(waiver, report)
        if waiver.rule not in looked_at.rules and not is_rule(waiver.rule):
            report.add(WAIVER_RULE, waiver.at("rule"), f"there is no rule {waiver.rule}")
        elif readable is not None:
            other = usable.setdefault(readable.key, readable).waiver
            if other is not waiver and other.id != waiver.id:
                related = [(other.place, "the first one")]
                message = f"{other.id} is for the same finding"
                report.add(WAIVER_DUPLICATE, waiver.at("fingerprint"), message, related=related)
    return usable


def _read(waiver: WaiverSpec, report: Report) -> _Readable | None:
    """The waiver with its day, or None after a diagnostic."""
    is_readable = _FINGERPRINT.fullmatch(waiver.fingerprint) is not None
    if not is_readable:
        message = f"{waiver.fingerprint!r} is no fingerprint"
        report.add(
            WAIVER_FORM, waiver.at("fingerprint"), message, f"it has {LENGTH} hex digits; --format json prints it"
        )
    try:
        day = date.fromisoformat(waiver.expires) if _DAY.fullmatch(waiver.expires) else None
    except ValueError:
        day = None
    if day is None:
        report.add(WAIVER_FORM, waiver.at("expires"), f"{waiver.expires!r} is no day", "write it as in 2027-06-30")
    for key in ("reason", "owner"):
        if not getattr(waiver, key).strip():
            report.add(WAIVER_FORM, waiver.at(key), f"{waiver.id} has no {key}", f"write the {key}, in words")
            is_readable = False
    return _Readable(waiver, day) if is_readable and day is not None else None


def _judged(finding: Diagnostic, readable: _Readable, today: date, report: Report) -> Diagnostic:
    """The finding as waived, or as it is where the waiver has expired."""
    waiver = readable.waiver
    if today >= readable.day:
        related = [(finding.place, f"{finding.rule.id} counts again")]
        report.add(WAIVER_EXPIRED, waiver.at("expires"), f"{waiver.id} ended on {readable.day}", related=related)
        return finding
    reason = " ".join(waiver.reason.split())
    return replace(finding, waived=f"{waiver.id}, {waiver.owner}, until {readable.day}: {reason}")


def _is_about(document: str, file: str) -> bool:
    """Return whether ``file`` (absolute) is the one that a waiver calls ``document``: the last parts of its path."""
    wanted = [part for part in pattern(r"[/\\]").split(document) if part not in ("", ".")]
    return bool(wanted) and file.replace(os.sep, "/").split("/")[-len(wanted) :] == wanted
