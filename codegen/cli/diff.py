"""``codegen diff``: what changed between two versions of a specification or of a dialect, and what that means."""

import argparse
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from contextlib import AbstractContextManager

    from codegen.diagnostics import Report
    from codegen.diff.review import Review
    from codegen.model.system import System
    from codegen.sides import Around, Side, Unreadable
    from codegen.trace.graph import Trace

FORMATS = ("text", "markdown", "json", "github", "sarif", "junit", "gitlab", "html")
KINDS = ("never", "any", "breaking", "silent", "person", "wire", "behaviour", "trace", "documentation")


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "diff",
        parents=[common],
        description="Compare two resolved specifications or dialects: what changes on the wire, in the meaning of "
        "bytes, in the behaviour of the vehicle, in requirements and in texts; who notices and who breaks.",
        epilog="A side is a git revision (main, HEAD~1, main... for where main parted; REVISION:path for a dialect or "
        "another project), a folder or project file, an XML file, a dialect of the installed pymavlink (common), or of "
        "another: a wheel, source archive or folder of it, with :DIALECT.",
    )
    parser.add_argument("base", metavar="BASE", nargs="?", help="the old version")
    parser.add_argument("head", metavar="HEAD", nargs="?", help="the new version (default: the project as it is)")
    parser.add_argument("--format", choices=FORMATS, default="text", help="how the report is written")
    parser.add_argument(
        "--fail-on",
        metavar="KIND[,KIND]",
        default="breaking,person",
        help=f"what makes the exit code 1: {', '.join(KINDS)}, or the id of a rule (default: breaking,person)",
    )
    parser.add_argument(
        "--waivers", metavar="FILE", help="waivers and severities of changes (default: waivers.yaml of the project)"
    )
    parser.add_argument(
        "--allow-errors", action="store_true", help="compare sides that have errors as far as they can be read"
    )
    parser.add_argument(
        "--all", action="store_true", help="show changes of the dialect that do not concern the project"
    )
    parser.add_argument(
        "--bandwidth", metavar="PERCENT", default="5", help="growth of the telemetry that is a change (default: 5)"
    )
    parser.add_argument("--dialect", metavar="NAME", help="the dialect of a pymavlink for which none is named")
    parser.add_argument("--base-pymavlink", metavar="PATH", help="pymavlink to read the old version with")
    parser.add_argument("--head-pymavlink", metavar="PATH", help="pymavlink to read the new version with")
    parser.add_argument("--schema", action="store_true", help="print the JSON Schema of --format json and end")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Print the report to stdout, and return the exit code."""
    from fractions import Fraction

    if arguments.schema:
        from codegen.diff.as_json import review_schema

        print(review_schema())
        return 0
    kinds = [kind.strip() for kind in arguments.fail_on.split(",") if kind.strip()]
    try:
        threshold = Fraction(arguments.bandwidth.strip().rstrip("%"))
    except (ValueError, ZeroDivisionError):
        return _usage(f"--bandwidth is a number of percent, not {arguments.bandwidth!r}")
    if arguments.base is None:
        return _usage("name the old version: BASE is a revision, a folder, an XML file or a dialect")
    if threshold < 0:
        return _usage(f"--bandwidth is at least 0 %, not {arguments.bandwidth}")
    known = KINDS if set(kinds) <= set(KINDS) else (*KINDS, *_change_rules())
    for kind in kinds or [""]:
        if kind not in known:
            from codegen.diagnostics import did_you_mean

            return _usage(f"--fail-on knows no {kind or 'empty list'}", did_you_mean(kind, known))
    return _compared(arguments, kinds, threshold)


def _change_rules() -> list[str]:
    from codegen.diff.rules import CHANGE_RULES

    return list(CHANGE_RULES)


def _usage(message: str, hint: str | None = None) -> int:
    print(f"codegen diff: {message}{f' ({hint})' if hint else ''}", file=sys.stderr)
    return 2


def _compared(arguments: argparse.Namespace, kinds: Sequence[str], threshold: Any) -> int:
    from contextlib import ExitStack

    from codegen.cli.diff_report import print_review
    from codegen.cli.progress import working
    from codegen.cli.project import project_file
    from codegen.diff.review import fails
    from codegen.sides import Unreadable, default_head, opened

    project = project_file(arguments)
    base_around = _around(project, arguments.dialect, arguments.base_pymavlink)
    head_around = _around(project, arguments.dialect, arguments.head_pymavlink)
    with ExitStack() as sides:
        with working(f"reading {arguments.base}"):
            base = sides.enter_context(opened(arguments.base, base_around))
        if isinstance(base, Unreadable):
            return _unreadable(base)
        with working("reading the other side"):
            head = sides.enter_context(opened(arguments.head or default_head(base), head_around))
        if isinstance(head, Unreadable):
            return _unreadable(head)
        with working("comparing"):
            found = _review(base, head, threshold, is_all=arguments.all)
        waivers = _waivers(arguments.waivers, project, head)
        with _within(project if arguments.waivers is None else None):
            found, code = _with_severities(found, waivers)
            found, wrong = _waived(found, waivers, head)
        code = max(code, wrong)
        print_review(found, arguments.format)
        if found.faults and not arguments.allow_errors:
            because = f"{found.fault_line} (--allow-errors compares all the same)"
            whatever = ", whatever --fail-on says" if "never" in kinds else ""
            print(f"codegen diff: the exit code is 1{whatever}: {because}", file=sys.stderr)
            return 1
        return 1 if fails(found, kinds) else code


def _around(project: str | None, dialect: str | None, pymavlink: str | None) -> "Around":
    from codegen.sides import Around

    return Around(project, dialect or "common", _read_systems, pymavlink)


def _read_systems(project: str, report: "Report") -> "tuple[System, ...]":
    """Read a project: only then is what that needs imported."""
    from codegen import pipeline

    return pipeline.read_systems(project, report)


def _unreadable(side: "Unreadable") -> int:
    """Say why there is nothing to compare."""
    from codegen.findings.text import finding_text

    for finding in side.findings:
        print(finding_text(finding), file=sys.stderr)
    return _usage(side.message, side.hint)


def _review(base: "Side", head: "Side", threshold: Any, *, is_all: bool) -> "Review":
    """The review of both sides: of two projects with what changes reach, else of their dialects."""
    from dataclasses import replace

    from codegen.diff.reach import traces, with_reach
    from codegen.diff.requirements import renamed_ids
    from codegen.diff.review import review
    from codegen.diff.system import compare_dialects, compare_systems
    from codegen.diff.tested import tested_changes

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
    """What hangs together on one side; of a specification with errors nothing is known."""
    from codegen import pipeline
    from codegen.diagnostics import Report
    from codegen.trace.graph import linked

    return linked((), (), ()) if side.findings else pipeline.read_trace(side.systems, Report())


def _waivers(given: str | None, project: str | None, head: "Side") -> str | None:
    """The file of waivers and severities: the one that is given, or else that of the project."""
    if given is not None or project is None or not head.is_project:
        return given
    from codegen.cli.waived import waivers_of

    return waivers_of(project)


def _within(project: str | None) -> "AbstractContextManager[None]":
    """Let only files of a project be read; any where there is none, since the user has named the file."""
    from contextlib import nullcontext

    from codegen.decode.reach import folders_of
    from codegen.load.confined import confined

    return nullcontext() if project is None else confined(folders_of(project))


def _with_severities(found: "Review", waivers: str | None) -> "tuple[Review, int]":
    """The review with the severities that are set, and the exit code of what is wrong with them."""
    if waivers is None:
        return found, 0
    from codegen.decode.waivers import decode_severities
    from codegen.diagnostics import Report
    from codegen.diff.severities import usable, with_severities
    from codegen.findings.text import finding_text

    report, ignored = Report(), Report()
    specs = usable(decode_severities(waivers, ignored), report)
    for finding in report:
        print(finding_text(finding), file=sys.stderr)
    return with_severities(found, specs), 1 if report.has_errors else 0


def _waived(found: "Review", waivers: str | None, head: "Side") -> "tuple[Review, int]":
    """The review with waivers applied, and the exit code of what is wrong with them."""
    if waivers is None:
        return found, 0
    from codegen.cli.waived import with_waivers
    from codegen.diagnostics import Report
    from codegen.diff.review import as_finding, with_waived
    from codegen.findings.text import finding_text

    report = Report()
    report.extend(as_finding(group) for group in found.groups)
    rules = _change_rules()
    files = [*head.dialect.files]
    files += [path for system in head.systems for path in (*system.spec.files, *system.dialect.files)]
    # Whether the rules of other waivers exist is what codegen check says, which knows them all.
    judged = list(with_waivers(report, waivers, rules, files, lambda _: True))
    code = 0
    for finding in judged:
        if finding.rule.id not in rules:
            print(finding_text(finding), file=sys.stderr)
            code = 1 if finding.is_error else code
    return with_waived(found, judged), code
