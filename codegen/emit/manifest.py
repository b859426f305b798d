"""The manifest of an output folder: which files codegen wrote there, and what it wrote."""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import field
from functools import lru_cache
from posixpath import normpath
from string import hexdigits
from typing import Any

from codegen.conflict import line_of_conflict, sides_of_conflicts
from codegen.diagnostics import Report, Rule, Severity
from codegen.emit.folder import MANIFEST
from codegen.frozen import dataclass
from codegen.source import Place

MANIFEST_DAMAGED = Rule(
    "manifest-damaged",
    "The manifest of the output folder cannot be understood, so codegen no longer knows which files it wrote there. "
    "It goes on as if there were none: files that differ from what would be generated are then not overwritten. "
    "Restore manifest.json, or run build --force when nothing in the folder was edited by hand.",
    Severity.WARNING,
    remedy="restore manifest.json, or run build --force if nothing there was edited by hand",
)

_KEYS = ("files", "orphans", "pending")


@dataclass(frozen=True, slots=True)
class Manifest:
    """Relative posix path -> sha256 (hex) of the content that codegen wrote.

    ``orphans`` are files that an earlier build wrote and that nothing generates any more. ``pending`` is what a build
    is about to write: it is empty unless that build was interrupted, and then tells its files from hand edits.
    """

    files: Mapping[str, str] = field(default_factory=dict)
    orphans: Mapping[str, str] = field(default_factory=dict)
    pending: Mapping[str, str] = field(default_factory=dict)

    @property
    def paths(self) -> set[str]:
        """Every path that codegen has written, or was about to."""
        return {*self.files, *self.orphans, *self.pending}

    def written(self, path: str) -> tuple[str, ...]:
        """The hashes that ``path`` can have without having been edited by hand; none for an unknown path."""
        return tuple(kept[path] for kept in (self.files, self.orphans, self.pending) if path in kept)

    def text(self) -> str:
        """The manifest as its file holds it: sorted, one line a file, nothing that changes without the content."""
        held: dict[str, Mapping[str, str]] = {"files": self.files}
        held.update({key: kept for key in _KEYS[1:] if (kept := getattr(self, key))})
        return json.dumps(held, indent=2, sort_keys=True) + "\n"


@lru_cache(maxsize=4096)
def sha256(content: bytes) -> str:
    """The hash that the manifest keeps of a file's content, in hexadecimal.

    Kept: a build asks for that of each file when it plans, while it writes and when it is done.
    """
    return hashlib.sha256(content).hexdigest()


def with_lf(content: bytes) -> bytes:
    """A text with line ends of LF, as codegen writes it."""
    return content.replace(b"\r\n", b"\n")


def read_manifest(content: bytes | None, place: Place, report: Report) -> Manifest | None:
    """The manifest that ``content`` holds: an empty one for None and, with a warning, for what cannot be understood.

    The result is None for sound JSON that is not a manifest at all: that file belongs to somebody else.
    A path that does not stay in the folder makes the whole manifest unbelievable: files are removed by what it says.
    """
    if content is None:
        return Manifest()
    try:
        text = content.decode("utf-8")
        merged = None if line_of_conflict(text) is None else _of_both_sides(text)
        if merged is not None:
            return merged
        held = json.loads(text)
    except json.JSONDecodeError as fault:
        hint = "resolve the merge conflict in it, or delete it and build" if b"<<<<<<<" in content else None
        where = Place(place.file, fault.lineno, fault.colno)
        report.add(MANIFEST_DAMAGED, where, f"the manifest is not JSON: {fault.msg}", hint)
        return Manifest()
    except (ValueError, RecursionError):
        report.add(MANIFEST_DAMAGED, place, "the manifest is not UTF-8 text that holds JSON")
        return Manifest()
    if not isinstance(held, dict) or "files" not in held:
        return None
    damage = _damage(held)
    if damage:
        report.add(MANIFEST_DAMAGED, place, f"the manifest cannot be believed: {damage}")
        return Manifest()
    return Manifest(**held)


def _of_both_sides(text: str) -> Manifest | None:
    """Return what both branches of a merge have written, which git put into one manifest; None if it is not to be told.

    What is theirs is what a build was about to write: a file can be of either.
    """
    try:
        ours, theirs = (json.loads(side) for side in sides_of_conflicts(text))
    except json.JSONDecodeError:
        return None
    if any(not isinstance(side, dict) or "files" not in side or _damage(side) for side in (ours, theirs)):
        return None
    first, second = Manifest(**ours), Manifest(**theirs)
    return Manifest(
        first.files, {**second.orphans, **first.orphans}, {**second.pending, **first.pending, **second.files}
    )


def stays_inside(path: str) -> bool:
    """Return whether ``path`` is a plain relative posix path, which cannot lead out of the folder it is joined to."""
    plain = path.isprintable() and "\\" not in path and normpath(path) == path
    return plain and path != "." and not path.startswith("/") and ".." not in path.split("/")


def _damage(held: dict[str, Any]) -> str | None:
    """Return what is wrong with the JSON of a manifest, or None."""
    for key, kept in held.items():
        if key not in _KEYS:
            return f"it has the key {key!r}"
        if not isinstance(kept, dict):
            return f"{key} is not an object"
        for path, value in kept.items():
            if not stays_inside(path) or path == MANIFEST:
                return f"{path!r} is not a path that codegen writes"
            if not isinstance(value, str) or len(value) != 64 or not set(value) <= set(hexdigits):
                return f"the entry of {path!r} is not a sha256"
    return None
