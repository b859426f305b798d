"""The stored results of the benchmarks: one JSON file for each, which docs/benchmarks.md shows."""

import hashlib
import json
from collections.abc import Collection
from dataclasses import asdict, dataclass
from pathlib import Path

from figure import Figure

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent
FOLDER = HERE / "results"
VERSIONS = "versions.json"
MEASURED = ("codegen", "templates")
"""The folders of what is measured: when a file of theirs changes, the stored times are of something else."""


@dataclass(frozen=True)
class Result:
    """The result of a benchmark: its description, its figures, and the fingerprint of the sources that it measured."""

    compares: str
    figures: tuple[Figure, ...]
    sources: str


def read(path: Path) -> Result:
    """Read one stored result."""
    content = json.loads(path.read_text(encoding="utf-8"))
    figures = tuple(Figure(**figure) for figure in content["figures"])
    return Result(content["compares"], figures, content["sources"])


def write(path: Path, result: Result) -> None:
    """Store one result."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(asdict(result), indent=1) + "\n", encoding="utf-8")


def read_versions(folder: Path = FOLDER) -> dict[str, str]:
    """Read what took part when the results were made: names and versions."""
    versions: dict[str, str] = json.loads((folder / VERSIONS).read_text(encoding="utf-8"))
    return versions


def write_versions(versions: dict[str, str], folder: Path = FOLDER) -> None:
    """Store what took part."""
    (folder / VERSIONS).write_text(json.dumps(versions, indent=1) + "\n", encoding="utf-8")


def fingerprint(folders: Collection[str] = MEASURED, root: Path = ROOT) -> str:
    """Return the hash of all files of some folders of this repository, by their paths and contents."""
    digest = hashlib.sha256()
    for path in sorted(path for folder in folders for path in (root / folder).rglob("*") if path.is_file()):
        if path.suffix != ".pyc":
            content = path.read_bytes()
            digest.update(f"{path.relative_to(root).as_posix()} {len(content)}\n".encode() + content)
    return digest.hexdigest()[:16]
