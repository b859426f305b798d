"""``codegen import`` of ReqIF and needs.json: requirement documents in Markdown."""

import argparse
import os
import re
import sys
from collections.abc import Sequence
from contextlib import redirect_stdout
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from codegen.diagnostics import Report
    from codegen.exchanged.arranged import Arranged
    from codegen.exchanged.stated import StatedFile

ENDINGS = (".reqif", ".json")
"""Ends of the names of files that have requirements, not fields."""
OPTIONS = ("prefix", "status", "text", "heading", "id", "specification", "type", "version")
"""Options of this alone."""
OF_FIELDS = ("message", "dialect", "for_each", "stream", "requirement", "merge", "compare")
"""Options of the import of fields alone."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of this import."""
    group = parser.add_argument_group(
        "requirements",
        "of a FILE.reqif or needs.json; --out is then a folder, in which no document may be that has one of the ids",
    )
    group.add_argument("--prefix", metavar="FR", help="what goes before an id that is none of a document: FR-12 of 12")
    group.add_argument("--status", metavar="TEXT", help="status of documents that have none (default: Imported)")
    group.add_argument("--text", metavar="NAME", help="ReqIF: the attribute with texts (default: ReqIF.Text)")
    group.add_argument("--heading", metavar="NAME", help="ReqIF: that with headings (default: ReqIF.ChapterName)")
    group.add_argument("--id", metavar="NAME", help="ReqIF: that with ids (default: ReqIF.ForeignID)")
    group.add_argument("--specification", metavar="NAME", help="ReqIF: the one to import of several (default: all)")
    group.add_argument("--type", metavar="NAME", action="append", help="needs.json: a type to import (default: req)")
    group.add_argument("--version", metavar="NAME", help="needs.json: the version (default: the current one)")


def import_requirements(arguments: argparse.Namespace) -> int:
    """Print or write the documents and return the exit code."""
    from codegen.diagnostics import Report
    from codegen.exchanged.arranged import arranged
    from codegen.exchanged.document_text import document_text

    fault = _nonsense(arguments)
    if fault:
        print(f"codegen import: {fault}", file=sys.stderr)
        return 2
    report = Report()
    path = os.path.abspath(arguments.document)
    stated = _read(path, arguments, report)
    if stated is None:
        return _finish(report)
    documents = arranged(stated.objects, arguments.prefix, report)
    status, source = arguments.status or "Imported", os.path.basename(path)
    texts = [(each, document_text(each, status, source, report)) for each in documents]
    made = [(each, text) for each, text in texts if text is not None]
    _tell(stated)
    if arguments.out == "-":
        print("\n".join(text for _, text in made), end="", flush=True)
        with redirect_stdout(sys.stderr):
            return _finish(report)
    return _write(made, arguments.out, report)


def _nonsense(arguments: argparse.Namespace) -> str | None:
    given = next((name for name in OF_FIELDS if getattr(arguments, name)), None)
    if given is not None:
        return f"--{given.replace('_', '-')} belongs to the import of fields from a document"
    if arguments.prefix is not None and not re.fullmatch("[A-Z]+", arguments.prefix):
        return f"--prefix takes capital letters, not {arguments.prefix!r}"
    if arguments.out != "-" and os.path.lexists(arguments.out) and not os.path.isdir(arguments.out):
        return f"{arguments.out} is no folder"
    return None


def _read(path: str, arguments: argparse.Namespace, report: "Report") -> "StatedFile | None":
    if path.lower().endswith(".json"):
        from codegen.exchanged.needs import read_needs

        return read_needs(path, arguments.type or ["req"], arguments.version, report)
    from codegen.exchanged.reqif import Attributes, read_reqif

    given = {name: getattr(arguments, name) for name in ("text", "heading", "id", "specification")}
    return read_reqif(path, Attributes(**{name: value for name, value in given.items() if value}), report)


def _tell(stated: "StatedFile") -> None:
    """Tell in one line what is no requirement: everything else of a file is in the documents or has a finding."""
    if stated.left_out:
        listed = ", ".join(f"{number} {what}" for what, number in sorted(stated.left_out.items()))
        print(f"not imported, as it is no requirement: {listed}", file=sys.stderr)


def _write(made: "Sequence[tuple[Arranged, str]]", folder: str, report: "Report") -> int:
    """Write documents that are not there yet: all of them or, where one would replace something, none."""
    from codegen.emit.file import write_file
    from codegen.exchanged.document_text import file_name
    from codegen.exchanged.present import check_absent
    from codegen.source import shown_path

    wanted = {document.id: (file_name(document), document.place) for document, _ in made}
    if check_absent(folder, wanted, report):
        written = 0
        for document, text in made:
            if not write_file(os.path.join(folder, wanted[document.id][0]), text, report):
                break
            written += 1
        documents = "document" if written == 1 else "documents"
        print(f"{shown_path(os.path.abspath(folder))}: {written} {documents} written", file=sys.stderr)
    return _finish(report)


def _finish(report: "Report") -> int:
    from codegen.cli.findings import print_findings

    print_findings(report)
    return report.exit_code
