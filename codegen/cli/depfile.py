"""``--depfile``: what make and ninja have to watch."""

import argparse
from collections.abc import Iterable


def add_depfile_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of commands that write what they read."""
    parser.add_argument(
        "--depfile", metavar="FILE", help="after success, write for make and ninja what was read into this file"
    )
    parser.add_argument(
        "--depfile-target",
        metavar="NAME",
        help="what the rule calls the target (default: FILE without its ending .d)",
    )


def depfile_nonsense(arguments: argparse.Namespace) -> str | None:
    """Return why the options of add_depfile_options() cannot be obeyed, or None."""
    if arguments.depfile is None:
        return None if arguments.depfile_target is None else "--depfile-target says nothing without --depfile"
    if arguments.check or arguments.diff or arguments.dry_run:
        return "--depfile is written after a build; it does not go with --check, --diff or --dry-run"
    if arguments.depfile_target is None and not arguments.depfile.removesuffix(".d").strip("./"):
        return "--depfile names no file"
    if arguments.depfile_target is None and not arguments.depfile.endswith(".d"):
        return "--depfile FILE ends in .d, or --depfile-target names the target"
    return None


def write_depfile(arguments: argparse.Namespace, paths: Iterable[str]) -> int:
    """Write the file that --depfile names, if it was given, and return the exit code."""
    if arguments.depfile is None:
        return 0
    from codegen.cli.findings import print_findings
    from codegen.diagnostics import Report
    from codegen.emit.depfile import depfile_text
    from codegen.emit.file import write_file
    from codegen.source import shown_path

    target = arguments.depfile_target or arguments.depfile.removesuffix(".d")
    report = Report()
    write_file(arguments.depfile, depfile_text(target, [shown_path(path) for path in paths]), report)
    print_findings(report)
    return report.exit_code
