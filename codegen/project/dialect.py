"""The dialect of a project: its file with all includes, overlays and corrections.

A build that finds the dialect in the cache does not import this.
"""

import os
from dataclasses import replace

from codegen.decode.dialect.files import decode_overlay, decode_project_dialect
from codegen.decode.dialect.known import decode_known_file, taken_elsewhere
from codegen.decode.shipped_corrections import shipped_corrections
from codegen.diagnostics import Report, Rule
from codegen.load.files import Files
from codegen.load.shipped import dialect_path
from codegen.model.dialect.dialect import Dialect, KnownMessage
from codegen.model.spec.spec import Spec
from codegen.resolve.dialect.dialect import resolve_dialect

UNKNOWN_DIALECT = Rule(
    "unknown-dialect",
    "codegen.yaml names a dialect that is neither shipped with pymavlink nor an XML file.",
    unreadable=True,
    remedy="name a dialect of pymavlink, such as common, or a path that ends in .xml",
)


def decode_dialect(spec: Spec, files: Files, report: Report) -> Dialect | None:
    """The dialect of a project with its includes, overlays and corrections; None where none can be read."""
    project = spec.project
    written, place = project.dialect, project.at("dialect")
    path = dialect_path(written, spec.folder, UNKNOWN_DIALECT, place, files, report, is_file=written.endswith(".xml"))
    if path is None:
        return None
    found = decode_project_dialect(path, files, report, place)
    for index, overlay in enumerate(project.overlays):
        overlay_path = os.path.normpath(os.path.join(spec.folder, overlay))
        found += decode_overlay(overlay_path, files, report, project.at(f"overlays[{index}]"), found)
    if not found:
        return None
    name = os.path.splitext(os.path.basename(path))[0]
    shipped = shipped_corrections(found, files, report)
    dialect = resolve_dialect(name, found, spec.corrections, report, shipped, spec.refusals)
    added = (message.definition for message in dialect.added_messages())
    listed = listed_messages(spec, files, report)
    return replace(dialect, known=taken_elsewhere(added, dialect.files, listed, files))


def listed_messages(spec: Spec, files: Files, report: Report) -> tuple[KnownMessage, ...]:
    """The messages of the dialects that a project names under known."""
    return tuple(
        message
        for index, known in enumerate(spec.project.known)
        for message in decode_known_file(
            os.path.normpath(os.path.join(spec.folder, known)), files, report, spec.project.at(f"known[{index}]")
        )
    )
