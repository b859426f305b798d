"""``codegen init``: a new project that builds as it is. It never overwrites and asks nothing."""

import argparse
import os
import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping

    from codegen.commands.init import Wish


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    kinds = start_kinds()
    parser = commands.add_parser(
        "init",
        parents=[common],
        description="Begin a project: a specification with comments, a requirement document, schemas for editors, a "
        "workflow that checks it. Nothing that is there is overwritten.",
    )
    parser.add_argument("folder", metavar="FOLDER", nargs="?", default=".", help="where (default: here)")
    parser.add_argument(
        "--from",
        dest="kind",
        choices=tuple(kinds),
        default="minimal",
        help=f"what it begins as: {'; '.join(f'{name}, {text}' for name, text in kinds.items())} (default: minimal)",
    )
    parser.add_argument("--board", metavar="B", help="a board of docs/boards.md, such as pico_2_w or esp32")
    parser.add_argument(
        "--dialect", metavar="D", help="a dialect that pymavlink ships, such as common, or an XML file, which is copied"
    )
    parser.set_defaults(run=run)


def start_kinds() -> "Mapping[str, str]":
    """Return each kind of ``templates/start/kinds.json``, and what it is, in a few words."""
    import json

    from codegen.tool.template_files import copied

    kinds: dict[str, str] = json.loads(copied("start/kinds.json"))
    return kinds


def run(arguments: argparse.Namespace) -> int:
    """Write the project, say what comes next, and return the exit code."""
    from codegen.cli.findings import print_findings
    from codegen.commands.init import (
        CODEC,
        Wish,
        check_wish,
        report_existing,
        schemas_for_editors,
        start_files,
        write_project,
    )
    from codegen.diagnostics import Report

    if arguments.kind == CODEC and arguments.board is not None:
        print("codegen init: --board says nothing about a codec: it runs on all of them", file=sys.stderr)
        return 2
    wish = Wish(arguments.kind, os.path.abspath(arguments.folder), arguments.board, arguments.dialect)
    report = Report()
    files = start_files(wish, report)
    schemas = {} if wish.kind == CODEC else schemas_for_editors()
    if files:
        report_existing(wish.folder, {**files, **{f"generated/{path}": "" for path in schemas}}, report)
    if not report.has_errors and (wish.board or wish.dialect) and schemas:
        check_wish(wish, files, report)
    if not report.has_errors:
        write_project(wish.folder, files, schemas, report)
    print_findings(report)
    if report.has_errors:
        print("codegen init: nothing was written", file=sys.stderr)
    else:
        _say_what_is_next(arguments.folder, wish, len(files))
    return report.exit_code


def _say_what_is_next(written: str, wish: "Wish", count: int) -> None:
    from codegen.commands.init import CODEC

    where = "here" if os.path.normpath(written) == "." else f"in {written}"
    into = "" if where == "here" else f"cd {written} && "
    print(f"{count} files of a new project ({wish.kind}) are {where}.", file=sys.stderr)
    if wish.kind == CODEC:
        print("README.md tells what they are. Next:", file=sys.stderr)
        print(f"  {into}codegen codec --dialect dialects/mine.xml --messages HEARTBEAT,TANK_LEVEL --out lib")
    else:
        print("specs/ is what is generated from; its comments tell what each file is. Next:", file=sys.stderr)
        print(f"  {into}codegen build && codegen sim")
