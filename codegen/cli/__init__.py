"""The command line: reads the arguments, runs one command and says how it went.

Nothing heavy is imported before a command runs, so that ``--help`` and ``--version`` answer at once.
"""

import argparse
import os
import sys
from functools import cache
from importlib import import_module

from codegen import __version__

TYPE_CHECKING = False  # typing takes longer to import than --help may take
if TYPE_CHECKING:
    from typing import Any, TextIO

COMMANDS = {
    "build": "generate the firmware, mocks, tests and documents",
    "check": "check the specification against the dialect, and what documents claim",
    "diff": "say what changed between two versions, and who breaks",
    "explain": "tell the whole story of a message, a field, a parameter or a rule",
    "trace": "what answers to each requirement: rows, symbols, tests and their results",
    "import": "make a population table from a requirement document",
    "codec": "make MicroPython encoders and decoders for any dialect, without a specification",
    "sim": "run the generated firmware on this host against a scenario",
}
"""The commands in the order of ``--help``, and what it says of them; each is a module of this package with
``add_command``."""

_MODULES = {"import": "importing"}
"""Modules of commands that are words of Python."""

EXIT_USAGE = 2
EXIT_INTERNAL = 3
EXIT_INTERRUPTED = 130
EXIT_BROKEN_PIPE = 141


def main(argv: list[str]) -> int:
    """Run one command line (without the program's name) and return its exit code.

    0 clean; 1 findings, stale output or a difference; 2 usage, configuration or unreadable input; 3 an error of
    codegen itself; 130 and 141 as the shell reports an interrupt and a reader that went away.
    """
    for stream in (sys.stdout, sys.stderr):
        _accept_every_character(stream)
    try:
        code = _run(argv)
        print(end="", flush=True)  # a reader that went away, or a full disk, may show only now
    except BrokenPipeError:
        _abandon_stdout()
        return EXIT_BROKEN_PIPE
    except KeyboardInterrupt:
        return EXIT_INTERRUPTED
    except OSError as fault:
        _abandon_stdout()
        _show_traceback(fault, argv)
        print(f"codegen: the system refuses to go on: {fault}", file=sys.stderr)
        return EXIT_USAGE
    except Exception as fault:
        _show_traceback(fault, argv)
        text = " ".join(f"{type(fault).__name__}: {fault}".split())
        advice = "please report it with the files that lead to it; --debug shows where it is"
        print(f"codegen: internal error ({text}); {advice}", file=sys.stderr)
        return EXIT_INTERNAL
    return code


def _run(argv: list[str]) -> int:
    try:
        arguments = _parser(argv).parse_args(argv)
    except SystemExit as leaving:  # after --help, --version or wrong usage
        return leaving.code if isinstance(leaving.code, int) else EXIT_USAGE
    code = int(arguments.run(arguments))
    if "codegen.tool" in sys.modules:  # some commands have no use for it
        from codegen.tool import keep_what_is_new

        keep_what_is_new()
    return code


class _Formatter(argparse.HelpFormatter):
    """Asks for the terminal's width itself: argparse does so at each argument, and reads a large module for it."""

    def __init__(self, prog: str) -> None:
        super().__init__(prog, width=_columns() - 2)


class _Parser(argparse.ArgumentParser):
    """A parser, and by that also those of the commands, with that formatter."""

    def __init__(self, **options: "Any") -> None:
        super().__init__(formatter_class=_Formatter, **options)


@cache
def _columns() -> int:
    try:
        return int(os.environ.get("COLUMNS") or os.get_terminal_size().columns) or 80
    except (ValueError, OSError):
        return 80


def _parser(argv: list[str]) -> argparse.ArgumentParser:
    """The parser with every command, or only with the one that ``argv`` begins with.

    For ``--help`` alone, which lists them, a command is its name and its line.
    """
    common = _Parser(add_help=False, argument_default=argparse.SUPPRESS)
    common.add_argument(
        "--project",
        metavar="FILE",
        help="the codegen.yaml to work on (default: the nearest specs/codegen.yaml or codegen.yaml, "
        "from the working directory upwards)",
    )
    common.add_argument("--debug", action="store_true", help="show the traceback of an internal error")
    parser = _Parser(
        prog="codegen",
        description="Generate MicroPython telemetry firmware, mocks and tests from requirement documents, "
        "field tables and MAVLink dialects.",
        epilog="Exit codes: 0 clean; 1 findings, stale output or a breaking change; 2 usage, configuration or "
        "unreadable input; 3 internal error.",
        parents=[common],
    )
    parser.add_argument("--version", action="version", version=f"codegen {__version__}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True, prog="codegen")
    if argv in (["--help"], ["-h"]):
        for command, line in COMMANDS.items():
            commands.add_parser(command, help=line, add_help=False)
        return parser
    for command in argv[:1] if argv[:1] and argv[0] in COMMANDS else COMMANDS:
        import_module(f"codegen.cli.{_MODULES.get(command, command)}").add_command(commands, common)
    return parser


def _show_traceback(fault: Exception, argv: list[str]) -> None:
    if "--debug" in argv or os.environ.get("CODEGEN_DEBUG", "") not in ("", "0"):
        import traceback

        traceback.print_exception(fault)


def _accept_every_character(stream: "TextIO | None") -> None:
    """File names and quoted input may hold what the terminal's encoding lacks: such characters are escaped."""
    reconfigure = getattr(stream, "reconfigure", None)
    if reconfigure is not None:
        reconfigure(errors="backslashreplace")


def _abandon_stdout() -> None:
    """Let what is still buffered go nowhere, or the interpreter would complain about it when it ends."""
    from contextlib import suppress

    with suppress(AttributeError, OSError):  # there may be no stdout, or one that is no file
        descriptor = os.open(os.devnull, os.O_WRONLY)
        os.dup2(descriptor, sys.stdout.fileno())
        os.close(descriptor)
