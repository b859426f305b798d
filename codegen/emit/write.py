"""Carry out a plan: each file is replaced whole, and an interruption at any point leaves a folder to go on with."""

import errno
import os
from contextlib import suppress

from codegen.diagnostics import Report, Rule
from codegen.emit.file import replace_file
from codegen.emit.folder import MANIFEST, link_outside
from codegen.emit.manifest import Manifest, sha256
from codegen.emit.plan import Change, Plan
from codegen.frozen import dataclass

OUTPUT_UNWRITABLE = Rule(
    "output-unwritable",
    "The system refused to write or to remove a file of the output folder: no permission, a full disk. Every file "
    "is still whole, either as it was or as it is generated now; build again once the cause is gone.",
    unreadable=True,
    remedy="free the path: permissions, or space on the disk; then build again",
)


@dataclass(frozen=True, slots=True)
class Outcome:
    """The numbers of files (the manifest aside) that a build wrote, left unchanged, and removed."""

    written: int = 0
    unchanged: int = 0
    removed: int = 0


def write_output(plan: Plan, report: Report) -> Outcome:
    """Write and remove what ``plan`` says, the manifest last; a fault of the disk is reported and ends it.

    Before the first file the manifest notes what is about to be written: should the build be killed and the
    specification change before the next one, the files written so far are not mistaken for hand edits.
    """
    written = removed = 0
    unchanged = len(plan.those(Change.UNCHANGED))
    path = MANIFEST
    try:
        writes = [file for file in plan.writes if file.path != MANIFEST]
        # A manifest that stays as it is knows the hashes of what is written: of files that were lost or edited.
        if writes and len(writes) < len(plan.writes):
            os.makedirs(plan.folder, exist_ok=True)
            _replace(plan.folder, MANIFEST, _manifest_meanwhile(plan).text().encode("utf-8"))
        for file in writes:
            path = file.path
            _replace(plan.folder, path, file.new or b"")
            written += 1
        for path in (*(file.path for file in plan.removals), *(plan.leftovers if plan.clean else ())):
            _remove(plan.folder, path)
            removed += 1
        path = MANIFEST
        for file in plan.writes:
            if file.path == MANIFEST:
                os.makedirs(plan.folder, exist_ok=True)
                _replace(plan.folder, MANIFEST, file.new or b"")
    except OSError as error:
        report.add(OUTPUT_UNWRITABLE, plan.place(path), f"it cannot be written: {error.strerror}")
    return Outcome(written, unchanged, removed)


def _manifest_meanwhile(plan: Plan) -> Manifest:
    """The manifest while files are being written: what is known to be there, and what is about to be."""
    present = {file.path: sha256(file.old or b"") for file in plan.those(Change.UNCHANGED, Change.CHANGED)}
    pending = {file.path: sha256(file.new or b"") for file in plan.writes if file.path != MANIFEST}
    present.pop(MANIFEST, None)
    return Manifest({**plan.manifest.files, **present}, plan.manifest.orphans, pending)


def _replace(folder: str, path: str, content: bytes) -> None:
    """Put ``content`` at ``path`` in one step; the permissions of a file that was there are kept."""
    _verify(folder, path)
    replace_file(os.path.join(folder, path), content)


def _remove(folder: str, path: str) -> None:
    """Remove a file, and every folder inside ``folder`` that is empty without it."""
    _verify(folder, path)
    with suppress(FileNotFoundError):
        os.unlink(os.path.join(folder, path))
    parent = os.path.dirname(path)
    with suppress(OSError):
        while parent:
            os.rmdir(os.path.join(folder, parent))
            parent = os.path.dirname(parent)


def _verify(folder: str, path: str) -> None:
    """OSError if a link that appeared since the plan was made leads out of the folder."""
    if link_outside(folder, path):
        raise OSError(errno.ELOOP, "a link leads out of the output folder")
