"""The plan of one build: what every file of the output folder is, before anything is written."""

import os
import stat
from collections.abc import Container, Iterable, Mapping
from enum import Enum

from codegen.diagnostics import Report, Rule
from codegen.emit.folder import MANIFEST, link_outside, other_files
from codegen.emit.manifest import Manifest, read_manifest, sha256, stays_inside, with_lf
from codegen.frozen import dataclass
from codegen.source import Place

OUTPUT_BLOCKED = Rule(
    "output-blocked",
    "Something is in the way of a generated file: a folder where the file belongs, a file where a folder belongs, a "
    "link that leads out of the output folder, or a file that may not be read. Nothing is written until it is gone: "
    "move or delete it.",
    unreadable=True,
)


class Change(Enum):
    """The status of a file in the output folder, compared with the manifest and with the rendered text."""

    UNCHANGED = "unchanged"
    NEW = "new"
    CHANGED = "changed"
    EDITED = "edited by hand"
    FOREIGN = "not written by codegen"
    ORPHAN = "no longer generated"
    EDITED_ORPHAN = "no longer generated, and edited by hand"


@dataclass(frozen=True, slots=True)
class PlannedFile:
    """One file: ``old`` is its content on the disk (None: not there), ``new`` what was rendered (None: nothing)."""

    path: str
    change: Change
    old: bytes | None
    new: bytes | None


@dataclass(frozen=True, slots=True)
class Plan:
    """The plan of a build in ``folder`` (absolute), with or without ``force`` and ``clean``.

    ``files`` are in the order of their paths and end with the manifest, unless it is unchanged. ``strays`` are paths
    that neither the manifest nor the rendering knows; ``leftovers`` are unfinished files of an interrupted build.
    ``manifest`` is the one on the disk. ``vacated`` are the beginnings of paths of which nothing may be left, as
    plan_output() has them.
    """

    folder: str
    files: tuple[PlannedFile, ...]
    manifest: Manifest
    strays: tuple[str, ...]
    leftovers: tuple[str, ...]
    force: bool
    clean: bool
    vacated: tuple[str, ...] = ()

    def place(self, path: str) -> Place:
        """The place of a file as diagnostics show it."""
        return Place(os.path.join(self.folder, path))

    def those(self, *changes: Change) -> tuple[PlannedFile, ...]:
        """The files that are one of ``changes``."""
        return tuple(file for file in self.files if file.change in changes)

    @property
    def writes(self) -> tuple[PlannedFile, ...]:
        """The files to write; those that were edited by hand, and foreign ones, only with ``force``."""
        forced = (Change.EDITED, Change.FOREIGN) if self.force else ()
        return self.those(Change.NEW, Change.CHANGED, *forced)

    @property
    def removals(self) -> tuple[PlannedFile, ...]:
        """The files to remove: without ``clean`` vacated ones alone, edited ones only with ``force`` too."""
        return tuple(file for file in self.files if _is_removed(file, self.force, self.clean, self.vacated))


def plan_output(
    rendered: Mapping[str, str | bytes],
    folder: str,
    report: Report,
    *,
    force: bool = False,
    clean: bool = False,
    vacated: tuple[str, ...] = (),
) -> Plan | None:
    """Compare ``rendered`` (relative posix path -> text, or bytes) with ``folder``; None if the folder cannot be used.

    ``vacated`` are the beginnings of paths, such as ``firmware/``, at which everything is taken for a part of the
    program: what an earlier build has left there, and nobody has edited, is removed without ``clean``, too.

    Whatever is in the way is reported, all of it; nothing is written here. ValueError for paths that no target may
    render: absolute, with ``..``, the manifest's own, or one that is the folder of another.
    """
    _verify_paths(rendered)
    folder = os.path.abspath(folder)
    if os.path.lexists(folder) and not os.path.isdir(folder):
        report.add(OUTPUT_BLOCKED, Place(folder), "the output folder is not a folder", "move it away or delete it")
        return None
    content, blocked = _content(folder, MANIFEST, report)
    read = None if blocked else read_manifest(content, Place(os.path.join(folder, MANIFEST)), report)
    manifest = read or Manifest()
    files = []
    for path in sorted({*rendered, *manifest.paths}):
        text = rendered.get(path)
        file = _planned(folder, path, text, manifest.written(path), report)
        if file is not None:
            files.append(file)
    removed = {file.path for file in files if _is_removed(file, force, clean, vacated)}
    new = _next_manifest(files, manifest, removed).text().encode("utf-8")
    if content is None or with_lf(content) != new:
        change = Change.NEW if content is None else Change.FOREIGN if read is None else Change.CHANGED
        files.append(PlannedFile(MANIFEST, change, content, new))
    strays, leftovers = other_files(folder, {*rendered, *manifest.paths, MANIFEST})
    return Plan(folder, tuple(files), manifest, strays, leftovers, force, clean, vacated)


def _planned(
    folder: str, path: str, rendered: str | bytes | None, written: tuple[str, ...], report: Report
) -> PlannedFile | None:
    """The comparison of one file; None if it is blocked, and for a file that is neither generated nor there.

    The line ends of a text do not count: git may have checked it out with those of another system.
    """
    new = rendered.encode("utf-8") if isinstance(rendered, str) else rendered
    old, blocked = _content(folder, path, report, is_wanted=new is not None)
    if blocked or (old is None and new is None):
        return None
    if old is not None and isinstance(rendered, str) and with_lf(old) == new:
        return PlannedFile(path, Change.UNCHANGED, old, new)
    is_whole = old is not None and not {sha256(old), sha256(with_lf(old))}.isdisjoint(written)
    if new is None:
        return PlannedFile(path, Change.ORPHAN if is_whole else Change.EDITED_ORPHAN, old, new)
    if old is None:
        return PlannedFile(path, Change.NEW, old, new)
    if old == new:
        return PlannedFile(path, Change.UNCHANGED, old, new)
    if is_whole:
        return PlannedFile(path, Change.CHANGED, old, new)
    return PlannedFile(path, Change.EDITED if written else Change.FOREIGN, old, new)


def _content(folder: str, path: str, report: Report, *, is_wanted: bool = True) -> tuple[bytes | None, bool]:
    """The content of a file (None: not there) and whether something is in its way, which is then reported.

    For a file that nothing renders any more (not ``is_wanted``) a folder of its name only means that it is gone.
    """
    full = os.path.join(folder, path)
    link = link_outside(folder, path)
    if link is not None:
        report.add(OUTPUT_BLOCKED, Place(link), "a link leads out of the output folder here", "delete the link")
        return None, True
    try:
        mode = os.stat(full).st_mode
        if stat.S_ISREG(mode):
            with open(full, "rb") as stream:
                return stream.read(), False
    except FileNotFoundError:
        return None, False
    except NotADirectoryError:
        fault = "there is a file where a folder of this path belongs"
    except OSError as error:
        fault = f"it cannot be read: {error.strerror}"
    else:
        fault = "there is a folder in its place" if stat.S_ISDIR(mode) else "what is in its place is not a file"
    if is_wanted:
        report.add(OUTPUT_BLOCKED, Place(full), fault, "move it away or delete it")
    return None, is_wanted


def _is_removed(file: PlannedFile, force: bool, clean: bool, vacated: tuple[str, ...]) -> bool:
    if not (clean or file.path.startswith(vacated)):
        return False
    return file.change is Change.ORPHAN or (file.change is Change.EDITED_ORPHAN and force)


def _next_manifest(files: Iterable[PlannedFile], manifest: Manifest, removed: Container[str]) -> Manifest:
    """The manifest once the plan is carried out: orphans that stay on the disk stay recorded."""
    generated, orphans = {}, {}
    for file in files:
        if file.new is not None:
            generated[file.path] = sha256(file.new)
        elif file.path not in removed:
            found = sha256(file.old or b"")
            written = manifest.written(file.path)
            orphans[file.path] = found if found in written else written[0]
    return Manifest(generated, orphans)


def _verify_paths(rendered: Mapping[str, str | bytes]) -> None:
    for path in rendered:
        if not stays_inside(path) or path == MANIFEST:
            raise ValueError(f"a target rendered {path!r}, which is not a path inside the output folder")
        parents = path.split("/")[:-1]
        for depth in range(1, len(parents) + 1):
            if "/".join(parents[:depth]) in rendered:
                raise ValueError(f"a target rendered {path!r} below a file")
