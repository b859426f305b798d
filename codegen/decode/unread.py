"""Files of a specification that nothing reads: what may have been meant by each."""

import os
from collections.abc import Collection, Iterator, Sequence

from codegen.decode.board_model import OWN
from codegen.decode.scenario import SCENARIOS
from codegen.decode.trace_lock import TRACE_LOCK
from codegen.decode.waivers import WAIVERS
from codegen.diagnostics import Report, Rule, Severity, did_you_mean
from codegen.load.files import Files
from codegen.pattern import pattern
from codegen.source import Place, shown_path

UNREAD_FILE = Rule(
    "unread-file",
    "A YAML file, or a document, lies where the files of the specification lie, but nothing reads it: its name or its "
    "ending is another one (.YAML, .yml), it lies in a folder below, or codegen.yaml does not name it.",
    Severity.WARNING,
    remedy="rename it to what it is meant to be, name it in codegen.yaml, or remove it",
)

READ_BY_OTHERS = (SCENARIOS, WAIVERS, TRACE_LOCK)
"""Files beside the project file that are no part of the specification."""
DRIVERS = "drivers"
"""The folder beside it with drivers of the project's own."""
TABLES = ("messages", "receives")
DOCUMENTS = "requirements"
READ_BY_ENDING = (*TABLES, DOCUMENTS)
"""The folders of which each file with the right ending is read; the files of others are named somewhere."""
_YAML = (".yaml", ".yml")
_MARKDOWN = (".md", ".markdown", ".mkd", ".mdown", ".mdx")
_TEXTS = (".rst", ".rest", ".txt", ".adoc", ".asciidoc", ".org", ".tex", ".html", ".htm", ".docx", ".odt")
"""Endings of documents that are no Markdown: they are told where requirements lie and their name begins with an id."""
_ID = pattern(r"[A-Z]{2,}-[0-9a-z]")
_DEEPEST = 8
"""The most folders below one another that are looked into."""


def report_unread(
    specification: str,
    read: Collection[str],
    beside: Sequence[str],
    *,
    files: Files,
    report: Report,
    in_program: bool,
) -> None:
    """Report the files of a specification that are none of ``read`` (absolute paths).

    ``beside`` are the names of files that have their place beside the project file, of which some are absent.
    """
    absent = [name for name in beside if os.path.join(specification, name) not in read]
    known = {*beside, *(() if in_program else READ_BY_OTHERS)}
    for folder, path in _seeming_files(specification, files, report):
        if path not in read and (folder or os.path.basename(path) not in known):
            hint = _hint(folder, path, specification, absent, in_program=in_program)
            report.add(UNREAD_FILE, Place(path), f"nothing reads {shown_path(path)}", hint)


def _seeming_files(specification: str, files: Files, report: Report) -> Iterator[tuple[str, str]]:
    """Return what seems to be a file of a specification, read or not: its folder there, and its absolute path.

    Endings count in letters of any case, and in folders that are read by the ending of their files also what lies in
    folders below. Hidden files (of editors) are left out.
    """
    for folder in ("", *TABLES, "dialects", DOCUMENTS, OWN, DRIVERS):
        endings = (*_YAML, *_MARKDOWN, *_TEXTS) if folder == DOCUMENTS else _YAML
        deepest = _DEEPEST if folder in READ_BY_ENDING else 0
        path = os.path.join(specification, folder).rstrip(os.sep)
        for found in _below(path, endings, deepest, files, report):
            name = os.path.basename(found)
            if not name.lower().endswith(_TEXTS) or _ID.match(name):
                yield folder, found


def _below(folder: str, endings: tuple[str, ...], deepest: int, files: Files, report: Report) -> Iterator[str]:
    for name in files.names(folder, report):
        path = os.path.join(folder, name)
        if name.startswith("."):
            continue
        if name.lower().endswith(endings):
            yield path
        elif deepest and files.is_folder(path) and not _leads_back(path, folder):
            yield from _below(path, endings, deepest - 1, files, report)


def _leads_back(path: str, folder: str) -> bool:
    """Return whether a path in a folder is a link to it, or to one above: what is there has been, or will be, told."""
    real, above = os.path.realpath(path), os.path.realpath(folder)
    return os.path.commonpath((real, above)) == real


def _hint(folder: str, path: str, specification: str, absent: Sequence[str], *, in_program: bool) -> str | None:
    """Return what may have been meant by a file in a folder of a specification; ``absent`` are the files that could be
    beside its project file and are not.
    """
    name = os.path.basename(path)
    stem, ending = os.path.splitext(name)
    read = ".md" if folder == DOCUMENTS and ending.lower() not in _YAML else ".yaml"
    if folder in READ_BY_ENDING and os.path.dirname(path) != os.path.join(specification, folder):
        return f"only what lies in {folder} itself is read: move it to {folder}/{stem}{read}"
    hints = {
        "messages": "the program does not list its message"
        if in_program and ending == ".yaml"
        else "population tables end in .yaml",
        "receives": "tables of received messages end in .yaml",
        "dialects": "name it under corrections in codegen.yaml",
        DOCUMENTS: "requirement documents are Markdown, and end in .md",
        DRIVERS: f"name it in board.yaml: driver: {stem}",
        OWN: f"name it in board.yaml: board: {stem}",
    }
    if folder:
        return hints[folder]
    if name in READ_BY_OTHERS:
        return f"{name} lies beside the project file that lists the program"
    return did_you_mean(f"{stem}{ending.lower()}", absent)
