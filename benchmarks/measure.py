# ruff: noqa: S603, T201  a benchmark starts the programs that it compares, and prints what it found
"""The common part of the benchmarks: contestants that take turns, processes that are weighed, their command line.

Times mean little on their own: another machine has others. Every figure here is a ratio of two runs on one machine, or
a number of bytes. Contestants take turns for several rounds, so that a busy moment hits all of them, and of each the
best round counts: what disturbs a run only ever makes it slower.
"""

import argparse
import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import results
from figure import Figure, table
from results import HERE, ROOT
from whole_program import whole_program

TOOLS = Path(sys.executable).parent

Result = dict[str, Any]


def best(contestants: Mapping[str, Callable[[], float]], rounds: int) -> dict[str, float]:
    """The lowest value that each contestant returns in `rounds` rounds; each round begins with the next one."""
    names = list(contestants)
    lowest = dict.fromkeys(names, float("inf"))
    for turn in range(rounds):
        for name in names[turn % len(names) :] + names[: turn % len(names)]:
            lowest[name] = min(lowest[name], contestants[name]())
    return lowest


def once(rounds: int) -> Callable[[Callable[[], "Weighed"]], Callable[[], "Weighed"]]:
    """Return a decorator that lets a contestant run once in a quick run, whoever asks: that shows that it runs."""
    return cache if rounds == 1 else lambda contestant: contestant


def tool(name: str) -> str:
    """The path of a command that the development dependencies install."""
    path = TOOLS / name
    if not path.exists():
        raise SystemExit(f"{name} is not installed: make build installs it")
    return str(path)


def said(command: Iterable[str], **options: Any) -> str:
    """Return the output of a command; the benchmark ends with that output if the command fails."""
    command = list(command)
    done = ended(command, **options)
    if done.returncode:
        raise SystemExit(f"{' '.join(command)} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


def ended(command: Iterable[str], **options: Any) -> "subprocess.CompletedProcess[str]":
    """Return the output of a command, and how it ended."""
    return subprocess.run(list(command), capture_output=True, text=True, check=False, **options)


def micropython(script: str, folder: Path, *arguments: object) -> Result:
    """Return the answer of a script of benchmarks/micropython under MicroPython, with modules from `folder`."""
    path = os.pathsep.join((str(folder), str(HERE / "micropython")))
    # As much heap as a large board has, so that garbage costs what it costs there.
    command = [tool("micropython"), "-X", "heapsize=512k", str(HERE / "micropython" / script)]
    return _answer([*command, *map(str, arguments)], {"MICROPYPATH": path})


def cpython(script: str, folder: Path | None, *arguments: object) -> Result:
    """Return the answer of a script of benchmarks/cpython under CPython; with `folder`, of benchmarks/micropython."""
    path = os.pathsep.join((str(folder or ""), str(HERE / "micropython")))
    home = HERE / ("micropython" if folder else "cpython")
    return _answer([sys.executable, "-B", str(home / script), *map(str, arguments)], {"PYTHONPATH": path})


def c_program(name: str, folder: Path) -> Path | None:
    """Compile benchmarks/c/`name`.c with mavgen's headers of common.xml; None where there is no C compiler."""
    if not has_cc():
        return None
    headers = folder / "headers"
    if not headers.exists():
        said([tool("mavgen.py"), "--lang", "C", "--wire-protocol", "2.0", "--no-validate", "-o", headers, dialect()])
    program = folder / name
    # The headers take addresses of packed members, which the compiler remarks on.
    said(["cc", "-O2", "-w", "-I", str(headers), "-o", str(program), str(HERE / "c" / f"{name}.c")])
    return program


def has_cc() -> bool:
    """Return whether this system has a C compiler."""
    return shutil.which("cc") is not None


NO_CC = "" if has_cc() else "this system has no cc"


def c_answer(program: Path, *arguments: object) -> Result:
    """Return the answer of a compiled program."""
    return _answer([str(program), *map(str, arguments)], {})


def _answer(command: list[str], environment: dict[str, str]) -> Result:
    answer: Result = json.loads(said(command, env={**os.environ, **environment}))
    return answer


def dialect(name: str = "common") -> str:
    """The path of a dialect's XML, as pymavlink ships it."""
    found = find_spec("pymavlink")
    if found is None or found.origin is None:
        raise SystemExit("pymavlink is not installed: make build installs it")
    return str(Path(found.origin).parent / "dialects" / "v20" / f"{name}.xml")


def codec(folder: Path, messages: str, *options: str, dialect_name: str = "common") -> Path:
    """Write a codec into a folder and return it."""
    command = [tool("codegen"), "codec", "--dialect", dialect_name, "--messages", messages, "--out", str(folder)]
    said([*command, *options], cwd=folder.parent)
    return folder


def rover_specs(folder: Path) -> Path:
    """Copy the rover's specification into a folder of its own, with nothing generated yet; return the folder."""
    shutil.copytree(ROOT / "specs", folder / "specs")
    return folder


def project(source: Path, folder: Path, changes: Mapping[str, Iterable[tuple[str, str]]] | None = None) -> None:
    """Build a project in a folder of its own, once, with texts in place of others in some of its files."""
    if not folder.exists():
        shutil.copytree(source / "specs", folder / "specs")
        for name, texts in (changes or {}).items():
            written = (folder / name).read_text(encoding="utf-8")
            for old, new in texts:
                if old not in written:
                    raise SystemExit(f"{name} has no {old!r} any more")
                written = written.replace(old, new)
            (folder / name).write_text(written, encoding="utf-8")
        said([tool("codegen"), "build"], cwd=folder)


def rover(folder: Path, machine_code: bool = True) -> Path:
    """Return a folder below another one with the whole program of the rover: as it is in generated/, or built without.

    `codegen build --check` holds generated/ to the specification.
    """
    if not machine_code:
        return without_machine_code(ROOT, folder)
    return whole_program(ROOT / "generated", folder / "whole")


def without_machine_code(source: Path, folder: Path) -> Path:
    """Build a project in a folder of its own, with plain Python only; return the folder of its program, whole."""
    shutil.copytree(source / "specs", folder / "specs")
    with (folder / "specs" / "codegen.yaml").open("a", encoding="utf-8") as file:
        file.write("machine_code: false\n")
    said([tool("codegen"), "build"], cwd=folder)
    return whole_program(folder / "generated", folder / "whole")


@dataclass(frozen=True)
class Weighed:
    """The cost of one process: seconds, its largest memory, in the system's unit, and processor time.

    ``processor`` are the seconds of user and system, those of processes that it has started and waited for included.
    """

    seconds: float
    memory: int
    said: str
    processor: float


def weighed(command: Iterable[str], folder: Path) -> Weighed:
    """Run a command in a folder, and weigh it.

    The system counts a process's memory from where its parent stood, so benchmarks that weigh import little themselves.
    """
    with tempfile.TemporaryFile() as log:
        start = time.perf_counter()
        process = subprocess.Popen(list(command), cwd=folder, stdout=log, stderr=log)
        _, status, usage = os.wait4(process.pid, 0)
        seconds = time.perf_counter() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        log.seek(0)
        text = log.read().decode("utf-8", "replace")
    if process.returncode:
        raise SystemExit(f"{' '.join(map(str, command))} failed:\n{text}")
    return Weighed(seconds, usage.ru_maxrss, text, usage.ru_utime + usage.ru_stime)


IN_MEMORY = "/dev/shm"  # noqa: S108  where Linux keeps a file system in memory


@contextmanager
def scratch(in_memory: bool = False) -> Iterator[Path]:
    """A folder that is gone afterwards; one in memory if it is asked for and this system has such a file system."""
    where = IN_MEMORY if in_memory and os.access(IN_MEMORY, os.W_OK) else None
    with tempfile.TemporaryDirectory(prefix="benchmark-", dir=where) as folder:
        yield Path(folder)


def agree(answers: Mapping[str, object]) -> None:
    """End the benchmark unless all contestants did the same."""
    first, *_ = answers.values()
    for name, answer in answers.items():
        if answer != first:
            raise SystemExit(f"{name} does something else than {next(iter(answers))}:\n{answer}\n{first}")


def allocated(key: str, name: str, answer: Result, most: float | None, frames: int = 1) -> Figure:
    """The bytes that a contestant allocated for a frame; both ways of counting have to say the same."""
    count = answer["allocated"] / frames
    if (count == 0) != answer["runs_locked"]:
        raise SystemExit(f"{name}: {count} bytes, but with the heap locked it runs: {answer['runs_locked']}")
    return Figure(key, name, "bytes allocated for a frame, even for a moment", count, "bytes", most=most)


def pymavlink(function: str) -> str:
    """The name of pymavlink's contestant: its CRC depends on what is installed."""
    try:
        import fastcrc  # noqa: F401, PLC0415
    except ImportError:
        return f"pymavlink's {function}; fastcrc is not installed"
    return f"pymavlink's {function} with fastcrc, as installed"


def run(compares: str, figures_of: Callable[[bool], list[Figure]]) -> None:
    """The command line of a benchmark: print its figures, and write them as JSON if asked to."""
    parser = argparse.ArgumentParser(description=compares)
    parser.add_argument("--quick", action="store_true", help="do as little as shows that everything works")
    parser.add_argument("--json", metavar="FILE", type=Path, help="write the figures to a file too")
    arguments = parser.parse_args()
    figures = figures_of(arguments.quick)
    print(compares.strip())
    if arguments.quick:
        print("(one short round: the ratios say little)")
    print()
    print(table(figures))
    if arguments.json:
        results.write(arguments.json, results.Result(compares, tuple(figures), results.fingerprint()))
