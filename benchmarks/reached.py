# ruff: noqa: S607, T201  it runs tests, and says how far it is
"""Finds the lines of a stage that each file of tests reaches, by marks in its blocks, and keeps them in build/mutation.

Each file of tests runs in a process of its own: what one file asks and keeps in memory hides no line from the next. It
runs in a copy of the repository whose stages are written anew (`marks.py`), so that a file of tests that fails is one
that looks at the text of the sources or at their history, or one that does not pass by itself: it is left out.
"""

import hashlib
import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path

from marks import MODULE, VARIABLE, Marker, module
from process_group import outcome
from results import ROOT

KEPT = ROOT / "build" / "mutation" / "reached.json"
OPTIONS = ("-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist", "-W", "ignore")
SUITES = (
    *("access", "boards", "broken", "cache", "claims", "cli", "codec", "dialect", "diff", "emit", "importing", "loop"),
    *("markdown", "pages", "population", "programs", "projects", "receiver", "resolve", "rover", "sim", "sources"),
    *("spec", "start", "trace"),
)
"""Folders of tests/ that judge what the generator does. Others judge its form, what was stored, or the templates."""


@dataclass(frozen=True)
class Reached:
    """The reach of a file of tests: by file of codegen its lines, the time that it took, and whether it passed."""

    passed: bool
    seconds: float
    lines: dict[str, list[int]]


def copy_of_repository(folder: Path) -> Path:
    """Copy what git knows of the repository, and what it does not ignore; the environment is a link to its own."""
    listed = subprocess.run(
        ["git", "ls-files", "-coz", "--exclude-standard"], cwd=ROOT, capture_output=True, check=True
    )
    for name in filter(None, listed.stdout.decode().split("\0")):
        source, target = ROOT / name, folder / name
        if source.is_file():
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, target)
    (folder / ".venv").symlink_to(ROOT / ".venv")
    return folder


def surroundings(copy: Path) -> dict[str, str]:
    """Return an environment in which all processes take codegen from the copy, and keep nothing elsewhere."""
    temporary = copy.parent / f"{copy.name}-tmp"
    temporary.mkdir(exist_ok=True)
    known = {key: value for key, value in os.environ.items() if key not in ("CODEGEN_CACHE", "CODEGEN_TEST_RUN")}
    return {**known, "PYTHONPATH": str(copy), "TMPDIR": str(temporary), "XDG_CACHE_HOME": str(temporary / "cache")}


def reached(suites: Iterable[str], stages: Iterable[str], place: Path, longest: float) -> dict[str, Reached]:
    """Return by path of a file of tests what it reaches of the stages, which are folders of codegen.

    What is known of the same stages is not run again. One that takes longer than ``longest`` seconds is left out, as
    one is that fails. The copy is made in the folder ``place``.
    """
    paths = sorted(path for stage in stages for path in (ROOT / "codegen" / stage).rglob("*.py"))
    sources = hashlib.sha256()
    for path in paths:
        sources.update(path.read_bytes())
    known = json.loads(KEPT.read_text()) if KEPT.exists() else {}
    files = [path for suite in suites for path in sorted((ROOT / "tests" / suite).glob("test_*.py"))]
    names = {
        str(path.relative_to(ROOT)): hashlib.sha256(sources.digest() + path.read_bytes()).hexdigest() for path in files
    }
    wanted = [name for name, key in names.items() if known.get(name, {}).get("key") != key]
    if wanted:
        KEPT.parent.mkdir(parents=True, exist_ok=True)
        copy = copy_of_repository(place / "marked")
        blocks = _mark(copy, [str(path.relative_to(ROOT)) for path in paths])
    for name in wanted:
        found = _reached_by(copy, name, blocks, longest)
        known[name] = {"key": names[name], **asdict(found)}
        KEPT.write_text(json.dumps(known), encoding="utf-8")  # after each: it takes long, and may be ended
        state = "" if found.passed else ": it fails in a copy, or takes too long, and is left out"
        print(f"{name}: {found.seconds:.0f} s{state}", flush=True)
    return {name: Reached(known[name]["passed"], known[name]["seconds"], known[name]["lines"]) for name in names}


def _mark(copy: Path, names: Iterable[str]) -> list[tuple[str, list[int]]]:
    """Mark modules of a copy, and return by the number of a byte what it stands for."""
    marker = Marker()
    for name in names:
        text = (copy / name).read_text(encoding="utf-8")
        (copy / name).write_text(marker.marked(name, text), encoding="utf-8")
    (copy / f"{MODULE}.py").write_text(module(len(marker.blocks)), encoding="utf-8")
    return marker.blocks


def _reached_by(copy: Path, name: str, blocks: list[tuple[str, list[int]]], longest: float) -> Reached:
    marks = copy.parent / "marks"
    marks.write_bytes(bytes(len(blocks)))
    environment = {**surroundings(copy), VARIABLE: str(marks)}
    begun = time.monotonic()
    done = tests_of(copy, [name], environment, longest)
    seconds = time.monotonic() - begun
    lines: dict[str, set[int]] = {}
    for (file, own), mark in zip(blocks, marks.read_bytes(), strict=True):
        if mark:
            lines.setdefault(file, set()).update(own)
    passed = done is not None and done.returncode == 0
    return Reached(passed, round(seconds, 1), {file: sorted(found) for file, found in sorted(lines.items()) if found})


def tests_of(
    copy: Path, tests: Iterable[str], environment: dict[str, str], longest: float
) -> subprocess.CompletedProcess[str] | None:
    """Run tests in a copy until one fails; return how it went, or None where it takes longer than ``longest`` seconds.

    Whatever the tests have started ends with them.
    """
    return outcome([sys.executable, "-m", "pytest", *OPTIONS, *tests], copy, longest, environment)
