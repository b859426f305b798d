"""``codegen trace``: from criteria over rows and symbols to tests and their last results; and what was reviewed."""

import argparse
import sys
from datetime import datetime
from typing import Any

FORMATS = ("text", "markdown", "html", "needs", "reqif", "json", "github", "sarif", "junit", "gitlab")
KINDS = ("uncovered", "orphaned", "suspect", "unspecified", "uncited", "partly", "dependency")
COUNTED = ("uncovered", "orphaned", "suspect")
ACCEPT = "accept"
_NONE = "none"


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "trace",
        parents=[common],
        usage="codegen trace [ID ...] [--results FILE] [--format FORMAT] [--out FILE] [--fail-on KINDS]\n"
        "       codegen trace accept ID ... | ID --link LINK ... | --all  --reason TEXT [--by NAME]",
        description="Follow each criterion of the requirement documents over the rows of the tables and the generated "
        "symbols to the tests and their last results. accept notes that the rows and tests of a criterion were "
        "reviewed with its text as it is now.",
    )
    parser.add_argument("names", metavar="ID", nargs="*", help="only these: FR-00068 or FR-00068.3 (default: all)")
    parser.add_argument(
        "--results",
        metavar="FILE",
        action="append",
        help="results of tests in JUnit's format, as pytest --junit-xml=FILE writes them, or a .json of codegen bench; "
        "may be repeated",
    )
    parser.add_argument(
        "--format",
        choices=FORMATS,
        default="text",
        help="needs: needs.json of sphinx-needs; reqif: ReqIF 1.2; json, github, sarif, junit and gitlab have the "
        "findings alone",
    )
    parser.add_argument(
        "--last-change",
        metavar="TIME",
        type=_time,
        help="with reqif: when everything in it was last changed, such as 2026-11-25T12:00:00Z "
        "(default: 1970-01-01T00:00:00Z, so that an unchanged specification gives the same file)",
    )
    parser.add_argument("--out", metavar="FILE", help="where the report goes (default: stdout)")
    parser.add_argument(
        "--fail-on",
        metavar="KINDS",
        type=_kinds,
        default=COUNTED,
        help=f"what makes the exit code 1, separated by commas, of {', '.join(KINDS)}; or none "
        f"(default: {','.join(COUNTED)})",
    )
    parser.add_argument(
        "--link",
        metavar="LINK",
        action="append",
        help="with accept and one criterion: this link alone, by the name that the finding gives it, such as "
        "'parameter SR0_EXTRA1'; may be repeated",
    )
    parser.add_argument("--reason", metavar="TEXT", help="with accept: what was looked at, or why the links still hold")
    parser.add_argument("--by", metavar="NAME", help="with accept: who looked")
    parser.add_argument("--all", action="store_true", help="with accept: every criterion that is not the reviewed one")
    parser.set_defaults(run=run)


def _kinds(text: str) -> tuple[str, ...]:
    """The kinds that are named. An empty list is refused: it is what a variable that nobody has set leaves."""
    names = tuple(name for name in (part.strip() for part in text.split(",")) if name)
    unknown = [name for name in names if name not in (*KINDS, _NONE)]
    if unknown or not names:
        raise argparse.ArgumentTypeError(f"{unknown[0] if unknown else 'nothing'} is none of {', '.join(KINDS)}, none")
    if _NONE in names and len(set(names)) > 1:
        raise argparse.ArgumentTypeError(f"none goes with no other, as in {text}")
    return () if _NONE in names else names


def _time(text: str) -> str:
    """An xsd:dateTime with its zone."""
    try:
        found = datetime.fromisoformat(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text} is no time such as 2026-11-25T12:00:00Z") from None
    if found.tzinfo is None:
        raise argparse.ArgumentTypeError(f"{text} has no zone; write {text}Z for UTC")
    return found.isoformat()


def run(arguments: argparse.Namespace) -> int:
    """Print the trace, or note what was reviewed, and return the exit code."""
    is_accept = arguments.names[:1] == [ACCEPT]
    fault = _nonsense(arguments, is_accept)
    if fault:
        print(f"codegen trace: {fault}", file=sys.stderr)
        return 2
    from codegen.cli.findings import FORMATS as OF_FINDINGS
    from codegen.cli.findings import print_findings
    from codegen.cli.project import project_file, report_no_project
    from codegen.diagnostics import Report

    project = project_file(arguments)
    if project is None:
        return report_no_project(arguments.format if arguments.format in OF_FINDINGS else "text")
    from codegen.cli.progress import working
    from codegen.project.systems import read_systems

    reading = Report()
    with working("reading the specification"):
        systems = read_systems(project, reading)
    if not systems or reading.has_errors:
        print_findings(reading, arguments.format if arguments.format in OF_FINDINGS else "text")
        return reading.exit_code or 2
    if is_accept:
        from codegen.cli.trace_accept import accept

        return accept(arguments, project, systems)
    from codegen.cli.trace_report import report_trace

    return report_trace(arguments, project, systems, reading)


def _nonsense(arguments: argparse.Namespace, is_accept: bool) -> str:
    """Return what is wrong with how the options are used together, or nothing."""
    if arguments.last_change and (is_accept or arguments.format != "reqif"):
        return "--last-change belongs to --format reqif"
    if not is_accept:
        given = [name for name in ("reason", "by", "all", "link") if getattr(arguments, name)]
        return f"--{given[0]} belongs to codegen trace accept" if given else ""
    if arguments.results or arguments.out or arguments.format != "text":
        return "accept takes neither --results nor --format nor --out"
    if not (arguments.reason or "").strip():
        return 'accept needs --reason "...": what was looked at, or why the links still hold'
    if arguments.all == bool(arguments.names[1:]):
        return "accept takes either ids or --all"
    if arguments.link and len(arguments.names) != 2:
        return "accept --link takes one criterion"
    return ""
