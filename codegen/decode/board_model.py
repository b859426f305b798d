"""Finds the file of a kind of board: among those that come with codegen, or in the folder of the project."""

import os
from collections.abc import Sequence

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.load.files import Files
from codegen.source import Place

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "boards")
"""The absolute path of the folder of those that come with codegen, one YAML file for each."""
OWN = "boards"
"""The folder beside board.yaml with those of the project."""

UNKNOWN_BOARD = Rule(
    "unknown-board",
    "board.yaml names a board that nobody describes: neither does one of the files that come with codegen, nor one in "
    "the folder boards of the specification. Write the name of such a file without its ending.",
)


def board_model_path(name: str, folders: Sequence[str], place: Place, files: Files, report: Report) -> str | None:
    """The absolute path of the file about a board, from the first of the ``folders`` or from codegen's own.

    None after the finding at ``place`` that there is none.
    """
    searched = (*(os.path.join(folder, OWN) for folder in folders), FOLDER)
    for folder in searched:
        path = os.path.join(folder, f"{name}.yaml")
        if os.path.basename(path) == f"{name}.yaml" and files.is_file(path):
            return path
    known = {each.removesuffix(".yaml"): folder for folder in reversed(searched) for each in _names(folder, files)}
    own = sorted(each.removesuffix(".yaml") for each in _names(FOLDER, files))
    hint = _called(name, known, files) or did_you_mean(name, known) or f"codegen knows {', '.join(own)}"
    report.add(UNKNOWN_BOARD, place, f"there is no description of a board {name}", hint)
    return None


def _names(folder: str, files: Files) -> list[str]:
    return [name for name in files.names(folder, Report()) if name.endswith(".yaml")]


def _called(written: str, known: dict[str, str], files: Files) -> str | None:
    """The board that is called so for people, as board.yaml once had it."""
    for name, folder in known.items():
        path = os.path.join(folder, f"{name}.yaml")
        text = files.read_text(path, Report())
        if text is not None and f"\nname: {written}\n" in f"\n{text}":
            return f"did you mean {name}?"
    return None
