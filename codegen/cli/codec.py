"""``codegen codec``: encoders and decoders for the messages of any dialect, no specification needed."""

import argparse
import os
import sys
from typing import Any

from codegen.cli.depfile import add_depfile_options, depfile_nonsense, write_depfile
from codegen.cli.output import ARCHITECTURES, add_output_options, nonsense


def add_command(commands: Any, common: argparse.ArgumentParser) -> None:
    """Add the command's arguments (``commands``: argparse's collection of sub-commands)."""
    parser = commands.add_parser(
        "codec",
        parents=[common],
        description="Make MicroPython modules that encode and decode messages of a MAVLink dialect: a link for both "
        "versions of the protocol with signing, the messages, their enums, and a page that says how to use them.",
    )
    parser.add_argument(
        "--dialect", required=True, metavar="X", help="a dialect that pymavlink ships, or the path of an XML file"
    )
    parser.add_argument(
        "--messages", required=True, metavar="A,B", help="names of messages, or all; only these take memory"
    )
    parser.add_argument("--out", required=True, metavar="DIR", help="the folder that the files go to")
    parser.add_argument(
        "--enums", metavar="A,B", help="names of enums, or none (default: those that the messages refer to)"
    )
    parser.add_argument(
        "--package",
        metavar="NAME",
        help="make a package of that name below DIR, which may lie anywhere, with stubs for type checkers and a "
        "package.json for mip (default: loose modules)",
    )
    parser.add_argument(
        "--bytecode", action="store_true", help="make no machine code, for ports of MicroPython without it"
    )
    parser.add_argument(
        "--mpy",
        metavar="ARCH",
        choices=ARCHITECTURES,
        help="write compiled modules instead of sources: " + ", ".join(ARCHITECTURES),
    )
    add_output_options(parser)
    add_depfile_options(parser)
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Do what the options ask for, and return the exit code."""
    names = _names(arguments.messages)
    enums = None if arguments.enums is None else [name for name in _names(arguments.enums) if name.lower() != "none"]
    fault = nonsense(arguments) or depfile_nonsense(arguments)
    if not names:
        fault = "--messages names no message; say all for every one"
    elif not arguments.out:
        fault = "--out names no folder"
    elif arguments.package is not None and not _is_package(arguments.package):
        fault = f"--package: {arguments.package} is no name of a package"
    if fault:
        print(f"codegen codec: {fault}", file=sys.stderr)
        return 2
    from codegen.cli.output import emit
    from codegen.cli.progress import working
    from codegen.commands.codec import codec_of, mip_list, read_codec_dialect
    from codegen.diagnostics import Report

    report = Report()
    machine_code = not (arguments.bytecode or arguments.mpy == "bytecode")
    dialect = read_codec_dialect(arguments.dialect, report)
    options = {"enums": enums, "machine_code": machine_code, "package": arguments.package}
    with working("making the codec"):
        files = {} if dialect is None else codec_of(dialect, names, report, **options)
        rendered: dict[str, str | bytes] = {**files}
        if rendered and arguments.mpy is not None:
            from codegen.emit.mpy import compiled

            rendered = compiled(rendered, arguments.mpy, report)
    if rendered and arguments.package is not None:
        rendered["package.json"] = mip_list(rendered)
    # A module that is left over would be imported instead of its successor; what was edited by hand stays all the same.
    arguments.clean = arguments.clean or not arguments.check
    code = emit(rendered or None, os.path.abspath(arguments.out), arguments, report)
    if arguments.depfile is None or code or dialect is None:
        return code
    from codegen.tool.digest import tool_files

    return write_depfile(arguments, [*dialect.files, *tool_files()])


def _is_package(name: str) -> bool:
    from keyword import iskeyword

    return all(part.isidentifier() and not iskeyword(part) for part in name.split("."))


def _names(text: str) -> list[str]:
    return [name.strip() for name in text.split(",") if name.strip()]
