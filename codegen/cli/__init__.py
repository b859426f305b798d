"""The command line: reads the arguments, runs one command and says how it went.

Nothing heavy is imported before a command runs, so that ``--help`` and ``--version`` answer at once.
"""

import os
import sys

TYPE_CHECKING = False  # typing takes longer to import than --help may take
if TYPE_CHECKING:
    from typing import TextIO

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
    if not argv:
        from codegen.cli.usage import BEGINNING

        print(BEGINNING, end="")
        return 0
    if argv == ["--version"]:
        from codegen import __version__

        print(f"codegen {__version__}")
        return 0
    if argv in (["--help"], ["-h"]):
        from codegen.cli.usage import HELP

        print(HELP, end="")
        return 0
    from codegen.cli.parser import parser_for

    try:
        arguments = parser_for(argv).parse_args(argv)
    except SystemExit as leaving:  # after --help, --version or wrong usage
        return leaving.code if isinstance(leaving.code, int) else EXIT_USAGE
    code = int(arguments.run(arguments))
    if "codegen.tool.digest" in sys.modules:  # some commands have no use for it
        from codegen.tool.digest import keep_what_is_new

        keep_what_is_new()
    return code


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
