"""The dialect of a project as it is with an overlay that it does not list, though something is written for it."""

import os
from dataclasses import replace

from codegen.decode.decoded import decoded_with_includes
from codegen.decode.dialect.files import decode_overlay
from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.load.files import Files
from codegen.model.dialect.dialect import Dialect
from codegen.model.spec.spec import Spec
from codegen.project.dialect import decode_dialect


@dataclass(frozen=True, slots=True)
class OtherDialect:
    """A dialect, and the messages in which it may differ from that of the project."""

    dialect: Dialect
    messages: frozenset[str]


def other_dialect(spec: Spec, dialect: Dialect, overlay: str, files: Files) -> OtherDialect | None:
    """The dialect with ``overlay`` in place of those that add one of its messages; None where it cannot be used.

    ``dialect`` is that of the project. Corrections are those of the overlays that the dialect has.
    """
    if not dialect.digest:
        return _other_dialect(spec, dialect, overlay, files)
    corrections = spec.corrections, spec.other_corrections, spec.refusals
    inputs = dialect.digest, spec.folder, spec.project, corrections, overlay

    def find(noting: Files, _report: Report) -> OtherDialect | None:
        return _other_dialect(spec, dialect, overlay, noting)

    return decoded_with_includes("overlay", inputs, find, files, Report())[0]


def _other_dialect(spec: Spec, dialect: Dialect, overlay: str, files: Files) -> OtherDialect | None:
    project = spec.project
    found = decode_overlay(_path(spec, overlay), files, Report(), project.at("overlays"), ())
    added = {message.name for file in found for message in file.messages}
    replaced = {dialect.messages[name].definition.place.file for name in added if name in dialect.messages}
    kept = tuple(name for name in project.overlays if _path(spec, name) not in replaced)
    listed = {_path(spec, name) for name in (*kept, overlay)}
    corrections = tuple(
        correction
        for correction in (*spec.corrections, *spec.other_corrections)
        if correction.overlay is None or _path(spec, correction.overlay) in listed
    )
    report = Report()
    changed = replace(spec, project=replace(project, overlays=(*kept, overlay)), corrections=corrections)
    other = decode_dialect(changed, files, report)
    if other is None or report.has_errors:
        return None
    gone = {message.name for message in dialect.added_messages() if message.definition.place.file in replaced}
    return OtherDialect(other, frozenset(added | gone))


def _path(spec: Spec, overlay: str) -> str:
    return os.path.normpath(os.path.join(spec.folder, overlay))
