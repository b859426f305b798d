"""An input with faults, and the command that gets it; each can be stored in a folder and read again."""

import json
import random
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from fuzzing.by_bytes import by_bytes
from fuzzing.by_elements import by_elements
from fuzzing.by_nodes import by_nodes
from fuzzing.by_tables import by_tables
from fuzzing.hostile import PATHS
from fuzzing.samples import Sample, kind_of, kinds

ODD = ("folder", "empty", "missing", "link out", "link to folder", "link to itself", "link inside", "pipe")
"""Odd things in place of a file, or of a folder."""

_STRUCTURED: dict[str, Callable[[bytes, random.Random], bytes]] = {
    ".yaml": by_nodes,
    ".xml": by_elements,
    ".md": by_tables,
    ".py": by_bytes,
}
_MANY_FILES = 30
_TOPICS = ("HEARTBEAT", "BATTERY_STATUS", "battery.voltage", "BATT_MONITOR", "FR-1.1", "EXTRA1", "gps")


@dataclass(frozen=True)
class Case:
    """Files by their paths, what else is in places of them, and a command line of codegen that is run beside them.

    ``name`` is seed and number, from which the same is drawn again. ``before`` has the files without faults, where the
    command compares with them.
    """

    name: str
    kind: str
    command: tuple[str, ...]
    files: dict[str, bytes]
    odd: dict[str, str] = field(default_factory=dict)
    before: dict[str, bytes] = field(default_factory=dict)


def drawn(seed: int, number: int, *, is_small: bool = False) -> Case:
    """Draw one input, of a small project where that is asked for; seed and number decide which."""
    lot = random.Random(f"{seed}:{number}")
    by_kind = _small_kinds() if is_small else kinds()
    kind = lot.choice(sorted(by_kind))
    sample, path = lot.choice(by_kind[kind])
    files, odd = dict(sample.files), {}
    if lot.random() < 0.04 and kind != "dialect alone":
        odd[_place(sample, path, lot)] = lot.choice(ODD)
    elif kind == "project file" and lot.random() < 0.4:
        files[path] = _with_path(files[path], lot)
    else:
        for _ in range(lot.choice((1, 1, 1, 2, 3, 8))):
            files[path] = _with_fault(files[path], path, lot)
        while lot.random() < 0.15:  # in several files at once
            other = lot.choice(sorted(files))
            files[other] = _with_fault(files[other], other, lot)
    command = _command(sample, path, lot)
    before = dict(sample.files) if any(word.startswith("../before") for word in command) else {}
    return Case(f"{seed}-{number}", kind, command, files, odd, before)


def _small_kinds() -> dict[str, list[tuple[Sample, str]]]:
    small = {
        kind: [(sample, path) for sample, path in files if len(sample.files) < _MANY_FILES and sample.name != "boat"]
        for kind, files in kinds().items()
    }
    return {kind: files for kind, files in small.items() if files}


def _with_fault(data: bytes, path: str, lot: random.Random) -> bytes:
    structured = _STRUCTURED.get(Path(path).suffix, by_bytes)
    return (structured if lot.random() < 0.75 else by_bytes)(data, lot)


def _with_path(data: bytes, lot: random.Random) -> bytes:
    """Return a project file with a path that somebody may write."""
    path = json.dumps(lot.choice(PATHS))
    lists = ("overlays", "corrections", "known", "outside", "tests")
    key = lot.choice((*lists, "output", "dialect", "programs", "output"))
    value = f"[{path}]" if key in lists else f"{{x: {path}}}" if key == "programs" else path
    lines = [line for line in data.decode().splitlines() if not line.startswith(f"{key}:")]
    return "\n".join((*lines, f"{key}: {value}", "")).encode()


def _place(sample: Sample, path: str, lot: random.Random) -> str:
    """Return a file of a sample, or a folder with files."""
    folders = {parent.as_posix() for each in sample.files for parent in Path(each).parents} - {".", "specs"}
    return lot.choice((path, path, lot.choice(sorted({*folders, path})), lot.choice(sorted(sample.files))))


def _command(sample: Sample, path: str, lot: random.Random) -> tuple[str, ...]:
    if kind_of(path) == "dialect alone":
        codec = ("codec", "--dialect", path, "--messages", "all", "--out", "made")
        return lot.choice(
            (codec, codec, (*codec[:-3], "HEARTBEAT", "--out", "made"), ("diff", "../before/" + path, path))
        )
    always = (
        [("check",)] * 6 + [("build",)] * 6 + [("trace",), ("diff", "../before", "."), ("explain", lot.choice(_TOPICS))]
    )
    if path.endswith(".md"):
        always += [("import", path), ("check", path)]
        if len(sample.files) < _MANY_FILES:  # it looks at each number of each document by itself
            always.append(("check", "--examples"))
    return lot.choice(always)


def store(case: Case, folder: Path) -> None:
    """Write a case into a folder that is not there yet."""
    for below, files in (("input", case.files), ("before", case.before)):
        for path, data in files.items():
            target = folder / below / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
    told = {"name": case.name, "kind": case.kind, "command": case.command, "odd": case.odd}
    (folder / "case.json").write_text(json.dumps(told, indent=1) + "\n")


def stored(folder: Path) -> Case:
    """Read a case from a folder that store() has written."""
    told = json.loads((folder / "case.json").read_text())
    files, before = _read(folder / "input"), _read(folder / "before")
    return Case(told["name"], told["kind"], tuple(told["command"]), files, told["odd"], before)


def _read(folder: Path) -> dict[str, bytes]:
    paths = sorted(path for path in folder.rglob("*") if path.is_file())
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}
