"""Severities that users set: how bad a kind of change is, of some files, messages or versions."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from fnmatch import fnmatchcase

from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.diff.change import Area, Change, Weight
from codegen.diff.report.grouping import Group
from codegen.diff.report.review import Review
from codegen.diff.rules import CHANGE_RULES
from codegen.findings.waivers import WAIVER_FORM
from codegen.model.spec.waiver import SetSeverity, SeveritySpec

UNKNOWN_KIND = Rule(
    "severity-unknown-kind",
    "A severity is set for a kind of change that does not exist, so it would never be used. Kinds are the ids of the "
    "rules of codegen diff, its areas (wire, behaviour, trace, documentation), its weights (silent, breaking, person, "
    "harmless), and any.",
    remedy="write the id of a rule of codegen diff, an area such as wire, or a weight such as silent",
)
SEVERITY_VERSION = Rule(
    "severity-version",
    "The versions for which a severity is set are numbers with points between them, such as 2.4.43.",
    remedy="write versions like 2.4.43",
)

_ANY = "any"
_KINDS = frozenset({_ANY, *CHANGE_RULES, *map(str, Area), *map(str, Weight)})
_VERSION = re.compile(r"(?<![\w.])v?(\d{1,9}(?:\.\d{1,9})+)(?![\w])")
_WRITTEN = re.compile(r"\d{1,9}(?:\.\d{1,9})*")

Version = tuple[int, ...]


def usable(specs: Iterable[SeveritySpec], report: Report) -> list[SeveritySpec]:
    """The settings that can be applied; what is wrong with the others is reported at their lines."""
    found = []
    for spec in specs:
        versions = [text for text in (spec.since, spec.until) if text is not None]
        if spec.kind not in _KINDS:
            hint = did_you_mean(spec.kind, _KINDS)
            report.add(UNKNOWN_KIND, spec.at("kind"), f"codegen diff knows no kind {spec.kind}", hint)
        elif not all(_WRITTEN.fullmatch(text) for text in versions):
            report.add(SEVERITY_VERSION, spec.place, f"{' and '.join(versions)}: no version is written so")
        elif not spec.reason.strip():
            report.add(
                WAIVER_FORM, spec.at("reason"), f"the severity of {spec.kind} has no reason", "write it, in words"
            )
        else:
            found.append(spec)
    return found


def with_severities(found: Review, specs: Sequence[SeveritySpec]) -> Review:
    """The review with the severities that are set: of several for one change the last one holds.

    What is off is left out and counted. The versions are those of the new side, as far as its name has one.
    """
    version = version_of(found.head)
    kept: list[Group] = []
    off = 0
    for group in found.groups:
        following = group.following
        for spec, changes in _by_spec(group, specs, version):
            if spec is not None and spec.severity is SetSeverity.OFF:
                off += len(changes)
                continue
            part = replace(group, changes=changes, following=following)
            following = ()  # it is told once, below the first that is shown
            if spec is not None:
                part = replace(part, severity=Severity(spec.severity.value), reason=" ".join(spec.reason.split()))
            kept.append(part)
    return replace(found, groups=tuple(kept), off=off)


def _by_spec(
    group: Group, specs: Sequence[SeveritySpec], version: Version | None
) -> list[tuple[SeveritySpec | None, tuple[Change, ...]]]:
    """The changes of a group by the setting that holds for each: a setting may be about some of them alone."""
    found: dict[int | None, list[Change]] = {}
    for change in group.changes:
        about = (at for at in reversed(range(len(specs))) if _is_about(specs[at], change, version))
        found.setdefault(next(about, None), []).append(change)
    return [(None if at is None else specs[at], tuple(changes)) for at, changes in found.items()]


def version_of(label: str) -> Version | None:
    """The version in the name of a side: of ``pymavlink-2.4.43-py3-none-any.whl:common``, of ``v1.2``."""
    found = _VERSION.search(label.rpartition("/")[2].replace("-", " ").replace(".tar.gz", ""))
    return None if found is None else _numbers(found[1])


def _numbers(text: str) -> Version:
    return tuple(int(part) for part in text.split("."))


def _is_about(spec: SeveritySpec, change: Change, version: Version | None) -> bool:
    if spec.kind not in (_ANY, change.rule.id, change.rule.area.value, change.weight.value):
        return False
    if spec.subject is not None and not _has(spec.subject, change.subject):
        return False
    if spec.file is not None and not any(
        _is_at(spec.file, place.file) for place in (change.place, change.was_at) if place
    ):
        return False
    if spec.since is None and spec.until is None:
        return True
    if version is None:
        return False
    return (spec.since is None or version >= _numbers(spec.since)) and (
        spec.until is None or version <= _numbers(spec.until)
    )


def _has(pattern: str, subject: str) -> bool:
    """Return whether a subject is meant by its whole name, or by that of its message, enum or program."""
    plain = subject.rpartition(": ")[2]
    return any(fnmatchcase(name, pattern) for name in (subject, plain, plain.partition(".")[0]))


def _is_at(pattern: str, file: str) -> bool:
    path = file.replace("\\", "/")
    return fnmatchcase(path, pattern) or fnmatchcase(path, f"*/{pattern}")
