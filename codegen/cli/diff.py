"""``codegen diff``: what changed between two versions of a specification or of a dialect, and what that means."""

import argparse
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from codegen.diff.sides import Unreadable

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

    from codegen.commands.diff import change_rules

    if arguments.schema:
        from codegen.diff.report.as_json import review_schema

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
    known = KINDS if set(kinds) <= set(KINDS) else (*KINDS, *change_rules())
    for kind in kinds or [""]:
        if kind not in known:
            from codegen.diagnostics import did_you_mean

            return _usage(f"--fail-on knows no {kind or 'empty list'}", did_you_mean(kind, known))
    if "never" in kinds and len(set(kinds)) > 1:
        return _usage(f"--fail-on {arguments.fail_on}: never goes with no other")
    return _compared(arguments, kinds, threshold)


def _usage(message: str, hint: str | None = None) -> int:
    print(f"codegen diff: {message}{f' ({hint})' if hint else ''}", file=sys.stderr)
    return 2


def _compared(arguments: argparse.Namespace, kinds: Sequence[str], threshold: Any) -> int:
    from contextlib import ExitStack

    from codegen.cli.diff_report import print_review
    from codegen.cli.progress import working
    from codegen.cli.project import project_file
    from codegen.commands.diff import around, files_of, graded, review_of, waived, waivers_for
    from codegen.diagnostics import Report
    from codegen.diff.report.review import fails
    from codegen.diff.sides import Unreadable, default_head, opened
    from codegen.findings.text import finding_text

    project = project_file(arguments)
    base_around = around(project, arguments.dialect, arguments.base_pymavlink)
    with ExitStack() as sides:
        with working(f"reading {arguments.base}"):
            base = sides.enter_context(opened(arguments.base, base_around))
        if isinstance(base, Unreadable):
            return _unreadable(base)
        head_around = around(project, arguments.dialect, arguments.head_pymavlink, base)
        with working("reading the other side"):
            head = sides.enter_context(opened(arguments.head or default_head(base), head_around))
        if isinstance(head, Unreadable):
            return _unreadable(head)
        with working("comparing"):
            found = review_of(base, head, threshold, is_all=arguments.all)
        waivers, told = waivers_for(arguments.waivers, project, head), Report()
        files = files_of(project if arguments.waivers is None else None)
        found = waived(graded(found, waivers, files, told), waivers, files, head, told)
        for finding in told:
            print(finding_text(finding), file=sys.stderr)
        print_review(found, arguments.format, head.files.on_disk, list(told))
        if found.faults and not arguments.allow_errors:
            because = f"{found.fault_line} (--allow-errors compares all the same)"
            whatever = ", whatever --fail-on says" if "never" in kinds else ""
            print(f"codegen diff: the exit code is 1{whatever}: {because}", file=sys.stderr)
            return max(told.exit_code, 1)
        return max(told.exit_code, int(fails(found, kinds)))


def _unreadable(side: "Unreadable") -> int:
    """Say why there is nothing to compare."""
    from codegen.findings.shortened import shortened
    from codegen.findings.text import finding_text

    for finding in shortened(side.findings):
        print(finding_text(finding), file=sys.stderr)
    return _usage(side.message, side.hint)
