"""Two versions of a specification or of a dialect, compared: what the report says, and what waivers make of it."""

from typing import TYPE_CHECKING, Any

from codegen.load.files import DISK, Files

if TYPE_CHECKING:
    from codegen.diagnostics import Report
    from codegen.diff.report.review import Review
    from codegen.diff.sides import Around, Side
    from codegen.model.system import System
    from codegen.trace.graph import Trace


def around(project: str | None, dialect: str | None, pymavlink: str | None, beside: "Side | None" = None) -> "Around":
    """Return what a side is looked for in, by the options of the command line; ``beside`` is the other side."""
    from codegen.diff.sides import Around

    files = DISK if beside is None else Files(beside.files.trees)
    return Around(project, dialect or "common", _read_systems, pymavlink, files)


def _read_systems(project: str, report: "Report", files: Files) -> "tuple[System, ...]":
    """Read a project: only then is what that needs imported."""
    from codegen.project.systems import read_systems

    return read_systems(project, report, files)


def review_of(base: "Side", head: "Side", threshold: Any, *, is_all: bool) -> "Review":
    """The review of both sides: of two projects with what changes reach, else of their dialects."""
    from dataclasses import replace

    from codegen.diff.reach import traces, with_reach
    from codegen.diff.report.review import review
    from codegen.diff.system.requirements import renamed_ids
    from codegen.diff.system.system import compare_dialects, compare_systems
    from codegen.diff.system.tested import tested_changes

    if base.is_project and head.is_project:
        compared = compare_systems(base.systems, head.systems, threshold)
        if is_all:
            compared = replace(compared, changes=(*compared.changes, *compared.elsewhere), elsewhere=())
        old, new = _trace(base), _trace(head)
        ids = renamed_ids(base.systems[0], head.systems[0])
        tested = () if base.findings or head.findings else tested_changes(old, new, ids)
        found = traces(old, new, (*base.systems, *head.systems))
        compared = replace(compared, changes=with_reach((*compared.changes, *tested), found))
    else:
        compared = compare_dialects(base.dialect, head.dialect)
    faults = [(side.label, finding) for side in (base, head) for finding in side.findings]
    return review(base.label, head.label, compared, (), faults)


def _trace(side: "Side") -> "Trace":
    """Return what hangs together on one side; of a specification with errors nothing is known."""
    from codegen.commands.trace import read_trace
    from codegen.diagnostics import Report
    from codegen.trace.graph import linked

    return linked((), (), ()) if side.findings else read_trace(side.systems, Report(), side.files)


def waivers_for(given: str | None, project: str | None, head: "Side") -> str | None:
    """The file of waivers and severities: the one that is given, or else that of the project."""
    if given is not None or project is None or not head.is_project:
        return given
    from codegen.commands.waived import waivers_of

    return waivers_of(project)


def files_of(project: str | None) -> Files:
    """Return the files of a project; all where there is none, since the user has named the file."""
    from codegen.decode.reach import within

    return DISK if project is None else within(project, DISK)


def graded(found: "Review", waivers: str | None, files: Files, told: "Report") -> "Review":
    """Return the review with the severities that are set; ``told`` gets what is wrong with them."""
    if waivers is None:
        return found
    from codegen.decode.waivers import decode_severities
    from codegen.diagnostics import Report
    from codegen.diff.judging.severities import usable, with_severities

    return with_severities(found, usable(decode_severities(waivers, files, Report()), told))


def waived(found: "Review", waivers: str | None, files: Files, head: "Side", told: "Report") -> "Review":
    """Return the review with waivers applied; ``told`` gets what is wrong with them."""
    if waivers is None:
        return found
    from codegen.commands.waived import with_waivers
    from codegen.diagnostics import Report
    from codegen.diff.report.review import as_finding, with_waived

    report = Report()
    report.extend(as_finding(group) for group in found.groups)
    rules = change_rules()
    checked = [*head.dialect.files]
    checked += [path for system in head.systems for path in (*system.spec.files, *system.dialect.files)]
    judged = list(with_waivers(report, waivers, rules, checked, files))
    told.extend(finding for finding in judged if finding.rule.id not in rules)
    return with_waived(found, judged)


def change_rules() -> list[str]:
    """Return the ids of the rules about changes."""
    from codegen.diff.rules import CHANGE_RULES

    return list(CHANGE_RULES)
