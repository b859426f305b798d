"""Runs codegen on an input in this process, and judges what it did: which exit code, which findings, which files."""

import io
import os
import re
import shutil
import signal
import sys
import sysconfig
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path

from results import ROOT

from codegen.load.files import DISK
from codegen.load.shipped import is_shipped
from fuzzing.case import Case
from fuzzing.made import faults_of_made
from fuzzing.watch import Seen, watched

HIDDEN = "nobody is to quote this"
"""The content of a file beside the project: no output may have it."""
KEPT = "generated/kept.txt"
"""A file in the output folder that is nobody's."""
LONGEST_S = 10.0
"""Seconds of the processor for one input."""

_FINDING = re.compile(r"^(\S.*?):(\d+):(\d+): (error|warning|info|waived) [a-z0-9-]+: ")
_LINE_END = re.compile(r"\r\n?|\n")
_FINDINGS_ALONE = ("check", "build", "codec", "import")
"""Commands that end with 1 or 2 for nothing but errors that they print."""

Main = Callable[[list[str]], int]


@dataclass(frozen=True)
class Outcome:
    """The result of codegen for an input: its exit code, the seconds that it took, and its faults."""

    code: int
    seconds: float
    faults: tuple[str, ...]
    printed: str


class TooLong(BaseException):
    """The time is over; no ``except Exception`` takes it for something else."""


def judged(case: Case, folder: Path, main: Main, longest_s: float = LONGEST_S) -> Outcome:
    """Run a case in an empty folder, which is left empty."""
    project = folder / "project"
    _write(case, folder)
    inputs = _contents(project)
    out, err = (io.TextIOWrapper(io.BytesIO(), "utf-8", newline="\n") for _ in range(2))
    faults: list[str] = []
    before = os.getcwd()
    os.chdir(project)
    started = time.process_time()
    code = -1
    try:
        with watched() as seen, redirect_stdout(out), redirect_stderr(err), _limited(longest_s):
            code = main(list(case.command))
    except TooLong:
        faults.append(f"it takes more than {longest_s:g} s")
    except BaseException as fault:  # an exit as well
        faults.append(f"it raises {type(fault).__name__}: {fault}"[:300])
    finally:
        seconds = time.process_time() - started
        os.chdir(before)
    texts = []
    for stream in (out, err):
        stream.flush()
        texts.append(stream.buffer.getvalue().decode("utf-8", "replace"))  # type: ignore[attr-defined]
    if not faults:
        faults += _faults(case, folder, code, texts, seen, inputs)
    with suppress(OSError):
        shutil.rmtree(folder)
    folder.mkdir(exist_ok=True)
    return Outcome(code, seconds, tuple(faults), "\n".join(texts))


def _faults(
    case: Case, folder: Path, code: int, texts: list[str], seen: Seen, inputs: dict[str, bytes | None]
) -> Iterator[str]:
    project = folder / "project"
    if code not in (0, 1, 2) or "Traceback (most recent" in "".join(texts):
        yield f"it ends with {code}: {texts[1].strip().splitlines()[-1:]}"
    if HIDDEN in "".join(texts):
        yield "it quotes a file outside of the project"
    yield from _faults_of_findings(case, folder if case.before else project, code, texts)
    yield from _faults_of_files(case, folder, seen)
    after = _contents(project)
    for path, content in inputs.items():
        if after.get(path) != content:
            yield f"{path} is not as it was"
    if code:
        yield from (f"{path} was written in spite of errors" for path in sorted(after.keys() - inputs.keys())[:3])
    elif case.command[0] in ("build", "codec"):
        yield from faults_of_made(project)


def _faults_of_findings(case: Case, whole: Path, code: int, texts: list[str]) -> Iterator[str]:
    findings = [found for line in texts[0].splitlines() if (found := _FINDING.match(line))]
    if code and case.command[0] in _FINDINGS_ALONE and not any(found[4] == "error" for found in findings):
        yield f"it ends with {code} without an error at a place: {texts[1].strip()[-200:]}"
    for found in findings:
        place = found.group(1, 2, 3)
        reason = _wrong_place(whole, whole / "project" if case.before else whole, *place, is_compared=bool(case.before))
        if reason:
            yield f"{':'.join(place)} is no place: {reason}: {found.string[:200]}"


def _wrong_place(
    whole: Path, project: Path, file: str, line: str, column: str, *, is_compared: bool = False
) -> str | None:
    """Return why nobody can go to a place, which has to lie in ``whole``, or in a dialect that is compared."""
    if not file.isascii() or "\\" in file:
        return None  # printed in a form for terminals
    path = Path(os.path.normpath(project / file))
    if is_compared and is_shipped(str(path), DISK):
        return None  # what a dialect says once a correction of it is gone stands there
    if path != whole and whole not in path.parents:
        return "outside of the project"
    if not os.path.isfile(path):  # Path.is_file() raises an error for a name that is too long
        return None if (line, column) == ("1", "1") else "a line of what is no file"
    if path.suffix == ".xml" or b"\0" in path.read_bytes():
        return None  # in other encodings
    lines = _LINE_END.split(path.read_bytes().decode("utf-8-sig", "surrogateescape"))
    if not 1 <= int(line) <= len(lines):
        return f"it has {len(lines)} lines"
    length = len(lines[int(line) - 1])
    return None if 1 <= int(column) <= length + 1 else f"the line has {length} characters"


def _faults_of_files(case: Case, folder: Path, seen: Seen) -> Iterator[str]:
    project = os.path.realpath(folder / "project")
    for path in sorted(seen.written):
        if not _is_below(path, project, _cache()):
            yield f"it writes {path}"
    if case.before:
        project = os.path.realpath(folder)
    for path in sorted(seen.read):
        if not _is_below(path, project, *_own()) and path not in (*sys.path, str(folder)):
            yield f"it reads {path}"
    yield from (f"it starts {each}" for each in seen.started)


def _is_below(path: str, *folders: str) -> bool:
    real = os.path.realpath(path)
    return any(real == folder or real.startswith(folder + os.sep) for folder in folders if folder)


@cache
def _cache() -> str:
    return os.path.realpath(os.environ["CODEGEN_CACHE"]) if os.path.isabs(os.environ.get("CODEGEN_CACHE", "")) else ""


@cache
def _own() -> tuple[str, ...]:
    """Return the folders of Python, of its packages and of codegen."""
    found = find_spec("pymavlink")
    packages = list(found.submodule_search_locations or ()) if found else []
    python = [sysconfig.get_path(name) for name in ("stdlib", "platstdlib", "purelib", "platlib")]
    places = (*python, *packages, sys.prefix, sys.base_prefix, ROOT / "codegen", ROOT / "templates", _cache())
    return tuple(os.path.realpath(place) for place in places if place)


def _contents(project: Path) -> dict[str, bytes | None]:
    """Return the files of a folder; links and what is no file are there with None."""
    found: dict[str, bytes | None] = {}
    for where, _, names in os.walk(project):
        for name in names:
            path = os.path.join(where, name)
            is_file = os.path.isfile(path) and not os.path.islink(path)
            found[os.path.relpath(path, project)] = Path(path).read_bytes() if is_file else None
    return found


def _write(case: Case, folder: Path) -> None:
    (folder / "secret").write_text(f"a: [ {HIDDEN}\n")
    (folder / "outside").mkdir()
    (folder / "outside" / "secret.yaml").write_text(f"a: [ {HIDDEN}\n")
    for below, files in (("project", {**case.files, KEPT: b"mine\n"}), ("before", case.before)):
        for path, data in files.items():
            target = folder / below / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(data)
    for path, odd in case.odd.items():
        _put(folder / "project" / path, odd, folder)


def _put(path: Path, odd: str, folder: Path) -> None:
    """Put something odd at a path."""
    if path.is_dir():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)
    if odd == "folder":
        path.mkdir()
    elif odd == "empty":
        path.touch()
    elif odd == "pipe":
        os.mkfifo(path)
    elif odd != "missing":
        inside = folder / "project" / "specs" / "codegen.yaml"
        targets = {"link out": folder / "secret", "link to folder": folder / "outside", "link to itself": path.name}
        path.symlink_to(targets.get(odd, inside))


@contextmanager
def _limited(seconds: float) -> Iterator[None]:
    """Raise TooLong once this process has worked for so long, or has waited for ten times as long."""

    def end(_number: int, _frame: object) -> None:
        raise TooLong

    kept = [(number, signal.signal(number, end)) for number in (signal.SIGPROF, signal.SIGALRM)]
    signal.setitimer(signal.ITIMER_PROF, seconds)
    signal.setitimer(signal.ITIMER_REAL, 10 * seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.setitimer(signal.ITIMER_REAL, 0)
        for number, handler in kept:
            signal.signal(number, handler)
