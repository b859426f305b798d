"""The inputs that are right: projects of this repository and dialects of pymavlink, by the kinds of their files."""

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from results import ROOT

PROJECTS = {
    "rover": ".",
    "boat": "examples/boat",
    **{
        name: f"tests/projects/{name}"
        for name in ("commanded", "guarded", "minimal", "radio_rover", "received", "rows", "sensors", "texts")
    },
    **{name: f"tests/projects/{name}" for name in ("three_cameras", "two_batteries", "watched_boat")},
}
"""Folders with a folder specs/, by name: together they have every kind of file."""

DIALECTS = ("minimal", "test", "python_array_test", "uAvionix", "loweheiser", "ualberta", "icarous")
"""Small ones that pymavlink ships, for the commands that need no project."""

BOARD = "specs/boards/own.yaml"
"""A board of the project's own, which each project gets: a copy of the one that it has."""

_KINDS = (
    (r"specs/messages/.*\.yaml", "table"),
    (r"specs/receives/.*\.yaml", "reception"),
    (r"specs/boards/.*\.yaml", "board model"),
    (r"specs/drivers/.*\.yaml", "driver"),
    (r"specs/requirements/.*\.md", "requirement"),
    (r"specs/dialects/.*\.xml", "dialect"),
    (r"specs/dialects/.*\.yaml", "corrections"),
    (r"specs/trace\.lock\.yaml", "lock"),
    (r"specs/(\w+/)?codegen\.yaml", "project file"),
    (r"specs/smart_battery/.*\.yaml", "program"),
    (r"specs/(\w+)\.yaml", ""),  # called as it is: state, board, streams
    (r"[^/]*\.xml", "dialect alone"),
)


@dataclass(frozen=True)
class Sample:
    """An input by the paths of its files."""

    name: str
    files: dict[str, bytes]


def kind_of(path: str) -> str:
    """Return what kind of file lies at a path of a sample."""
    for pattern, kind in _KINDS:
        found = re.fullmatch(pattern, path)
        if found:
            return kind or found[1]
    return "other"


@cache
def samples() -> tuple[Sample, ...]:
    """Return all samples."""
    return (*(_project(name, ROOT / folder) for name, folder in PROJECTS.items()), *map(_dialect, DIALECTS))


@cache
def kinds() -> dict[str, tuple[tuple[Sample, str], ...]]:
    """Return by kind the files that there are of it, each with its sample."""
    found: dict[str, list[tuple[Sample, str]]] = {}
    for sample in samples():
        for path in sorted(sample.files):
            found.setdefault(kind_of(path), []).append((sample, path))
    found.pop("other", None)
    return {kind: tuple(files) for kind, files in sorted(found.items())}


def _project(name: str, folder: Path) -> Sample:
    specs = folder / "specs"
    files = {f"specs/{path.relative_to(specs).as_posix()}": path for path in specs.rglob("*") if path.is_file()}
    files |= {path.name: path for path in folder.glob("*.py")}
    read = {path: file.read_bytes() for path, file in sorted(files.items())}
    board = re.search(rb"(?m)^board: (\w+)$", read["specs/board.yaml"])
    assert board is not None
    model = ROOT / "codegen" / "boards" / f"{board[1].decode()}.yaml"
    if model.exists():
        read[BOARD] = model.read_bytes()
        read["specs/board.yaml"] = read["specs/board.yaml"].replace(board[0], b"board: own")
    return Sample(name, read)


def _dialect(name: str) -> Sample:
    from codegen.load.files import DISK  # noqa: PLC0415  for whoever needs the projects alone
    from codegen.load.shipped import shipped_dialect_path  # noqa: PLC0415  for whoever needs the projects alone

    path = shipped_dialect_path(name, DISK)
    assert path is not None
    return Sample(f"dialect {name}", {f"{name}.xml": Path(path).read_bytes()})
