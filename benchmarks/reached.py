# ruff: noqa: S603, S607, T201  it runs tests, and says how far it is
"""Which lines of codegen each file of tests reaches, found once by coverage and kept in build/mutation.

Each file of tests runs in a process of its own, and so do the programs that it starts: what one file asks and keeps in
memory hides no line from the next. A file that fails in a copy of the repository, as those do that look at its history,
is left out.
"""

import hashlib
import json
import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import asdict, dataclass
from pathlib import Path
from queue import Queue
from threading import Lock

from coverage import CoverageData
from results import ROOT

KEPT = ROOT / "build" / "mutation" / "reached.json"
OPTIONS = ("-x", "-q", "-p", "no:cacheprovider", "-p", "no:xdist")
SUITES = (
    *("access", "boards", "broken", "claims", "cli", "codec", "dialect", "diff", "emit", "importing", "markdown"),
    *("loop", "programs", "projects", "receiver", "resolve", "rover", "sim", "sources", "spec", "start", "trace"),
)
"""Folders of tests/ that judge what the generator does. Others judge its form, what was stored, or the templates."""


@dataclass(frozen=True)
class Reached:
    """What a file of tests reaches: by file of codegen its lines, how long it took, and whether it passed."""

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


def reached(folders: Iterable[str], copies: "Queue[Path]", longest: float) -> dict[str, Reached]:
    """Return by path of a file of tests what it reaches; what is known of the same sources is not run again.

    One that takes longer than ``longest`` seconds is left out, as one is that fails.
    """
    sources = hashlib.sha256()
    for path in sorted((ROOT / "codegen").rglob("*.py")):
        sources.update(path.read_bytes())
    known = json.loads(KEPT.read_text()) if KEPT.exists() else {}
    files = [path for folder in folders for path in sorted((ROOT / "tests" / folder).glob("test_*.py"))]
    names = {
        str(path.relative_to(ROOT)): hashlib.sha256(sources.digest() + path.read_bytes()).hexdigest() for path in files
    }
    wanted = [name for name, key in names.items() if known.get(name, {}).get("key") != key]

    writing = Lock()

    def one(name: str) -> None:
        copy = copies.get()
        try:
            found = _reached_by(copy, name, longest)
        finally:
            copies.put(copy)
        with writing:  # after each: it takes long, and may be ended
            known[name] = {"key": names[name], **asdict(found)}
            KEPT.write_text(json.dumps(known), encoding="utf-8")
        state = "" if found.passed else ": it fails in a copy, or takes too long, and is left out"
        print(f"{name}: {found.seconds:.0f} s{state}", flush=True)

    KEPT.parent.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(copies.qsize()) as pool:
        list(pool.map(one, wanted))
    return {name: Reached(known[name]["passed"], known[name]["seconds"], known[name]["lines"]) for name in names}


def _reached_by(copy: Path, name: str, longest: float) -> Reached:
    folder = copy.parent / f"{copy.name}-{Path(name).stem}-{Path(name).parent.name}"
    folder.mkdir()
    (folder / "rc").write_text(
        f"[run]\nparallel = true\npatch = subprocess\nsource = {copy}/codegen\ndata_file = {folder}/data\n"
        "disable_warnings = no-data-collected, module-not-measured, couldnt-parse\n"
    )
    command = [sys.executable, "-m", "coverage", "run", f"--rcfile={folder}/rc", "-m", "pytest", *OPTIONS, name]
    begun = time.monotonic()
    try:
        done = subprocess.run(
            command, cwd=copy, env=surroundings(copy), capture_output=True, timeout=longest, check=False
        )
        passed = done.returncode == 0
    except subprocess.TimeoutExpired:
        passed = False
    seconds = time.monotonic() - begun
    lines: dict[str, set[int]] = {}
    for path in folder.glob("data*"):
        data = CoverageData(str(path))
        data.read()
        for file in data.measured_files():
            lines.setdefault(os.path.relpath(file, copy), set()).update(data.lines(file) or ())
    shutil.rmtree(folder)
    return Reached(passed, round(seconds, 1), {file: sorted(found) for file, found in sorted(lines.items()) if found})
