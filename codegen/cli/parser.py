"""The parsers of the command line. They import argparse, for which ``--help`` need not wait."""

import argparse
import os
from functools import cache
from importlib import import_module

from codegen import __version__
from codegen.cli.usage import COMMANDS, HELP

TYPE_CHECKING = False  # typing takes longer to import than a command that does nothing may take
if TYPE_CHECKING:
    from typing import Any

_MODULES = {"import": "importing"}
"""Modules of commands that are words of Python."""


class _Formatter(argparse.HelpFormatter):
    """Asks for the terminal's width itself: argparse does so at each argument, and reads a large module for it."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, width=_columns() - 2)


class _Parser(argparse.ArgumentParser):
    """A parser, and by that also those of the commands, with that formatter."""

    def __init__(self, **options: "Any") -> None:
        super().__init__(formatter_class=_Formatter, **options)


class _Program(_Parser):
    """The parser of the program itself, whose help is written out."""

    def format_help(self) -> str:
        """Called by argparse for ``--help``."""
        return HELP


@cache
def _columns() -> int:
    try:
        return int(os.environ.get("COLUMNS") or os.get_terminal_size().columns) or 80
    except (ValueError, OSError):
        return 80


def parser_for(argv: list[str]) -> argparse.ArgumentParser:
    """The parser with every command, or only with the one that ``argv`` begins with."""
    common = _Parser(add_help=False, argument_default=argparse.SUPPRESS)
    common.add_argument(
        "--project",
        metavar="FILE",
        help="the codegen.yaml to work on (default: the nearest specs/codegen.yaml or codegen.yaml, "
        "from the working directory upwards)",
    )
    common.add_argument("--debug", action="store_true", help="show the traceback of an internal error")
    parser = _Program(prog="codegen", parents=[common])
    parser.add_argument("--version", action="version", version=f"codegen {__version__}")
    commands = parser.add_subparsers(
        title="commands", metavar="COMMAND", required=True, prog="codegen", parser_class=_Parser
    )
    for command in argv[:1] if argv[:1] and argv[0] in COMMANDS else COMMANDS:
        import_module(f"codegen.cli.{_MODULES.get(command, command)}").add_command(commands, common)
    return parser
