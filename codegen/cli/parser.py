"""The parsers of the command line. They import argparse, for which ``--help`` need not wait."""

import argparse
import os
import re
from functools import cache
from importlib import import_module

from codegen import __version__
from codegen.cli.usage import COMMANDS, HELP
from codegen.pattern import pattern

TYPE_CHECKING = False  # typing takes longer to import than a command that does nothing may take
if TYPE_CHECKING:
    from typing import Any, NoReturn

_INVALID = pattern(r"invalid choice: '?(.*?)'? \(choose from (.*)\)", re.DOTALL)
_UNRECOGNIZED = "unrecognized arguments: "
_MODULES = {"import": "importing"}
"""Modules of commands that are words of Python."""


class _Formatter(argparse.HelpFormatter):
    """Asks for the terminal's width itself: argparse does so at each argument, and reads a large module for it."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, width=_columns() - 2)


class _Parser(argparse.ArgumentParser):
    """A parser, and by that also those of the commands, with that formatter, which says what may have been meant."""

    def __init__(self, **options: "Any") -> None:
        super().__init__(formatter_class=_Formatter, **options)

    def parse_args(self, args: "Any" = None, namespace: "Any" = None) -> "Any":
        """Parse as argparse does, but let the parser of a command report unknown options."""
        found, unknown = self.parse_known_args(args, namespace)
        if unknown:
            getattr(found, "parser", self).error(f"unrecognized arguments: {' '.join(unknown)}")
        return found

    def error(self, message: str) -> "NoReturn":
        """Called by argparse for wrong usage: it ends the program."""
        wrong = _INVALID.search(message)
        if wrong is not None:
            known = re.findall(r"[\w.-]+", wrong[2])
            hint = _near(wrong[1], known) or f"known: {', '.join(known)}"
            message = f"{message[: wrong.start()]}there is no {wrong[1]} ({hint})"
        elif message.startswith(_UNRECOGNIZED):
            options = [name for name in self._option_string_actions if name.startswith("--")]
            hint = _near(message.removeprefix(_UNRECOGNIZED).split()[0].partition("=")[0], options)
            message += f" ({hint})" if hint else ""
        super().error(message)


def _near(written: str, known: list[str]) -> str:
    """Return what may have been meant by a word; empty where nothing is near."""
    from difflib import get_close_matches

    near = get_close_matches(written, known, n=2)
    return f"did you mean {' or '.join(near)}?" if near else ""


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
        commands.choices[command].set_defaults(parser=commands.choices[command])
    return parser
