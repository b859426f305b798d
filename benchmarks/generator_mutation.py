# ruff: noqa: S603, T201  it runs tests, and prints what they have not noticed
"""Puts faults into the generator itself, one at a time, and counts those that its tests notice.

`make generator-mutation` draws some of each stage's folder; the same seed draws the same faults from the same sources.
A fault goes into a copy of the repository, which is imported from there and keeps nothing anywhere else. The tests that
reach its line are run (`reached.py`), first those that reach most of its module, then those of its own folder and the
quickest, until one fails or they would take more than `--most` seconds. A fault without effect is listed in
benchmarks/equivalents.yaml, with the reason.
"""

import argparse
import ast
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from itertools import count
from pathlib import Path
from queue import Queue

from equivalents import fault_of, is_listed, listed
from mutants import Mutant, mutants_of
from quality_results import store
from reached import OPTIONS, SUITES, Reached, copy_of_repository, reached, surroundings
from results import ROOT

FOLDERS = {
    "resolve": ("resolve", "broken", "spec"),
    "rules": ("broken", "resolve", "spec"),
    "decode": ("spec", "broken", "dialect"),
    "targets": ("emit", "projects", "programs"),
    "diff": ("diff",),
    "claims": ("claims",),
}
"""By folder of codegen the folders of tests/ that are about it, the nearest first."""
_NUMBERS = count(1)


def main() -> int:
    """Draw, try, print; 1 where fewer are noticed than `--least` asks for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--folders", nargs="+", choices=FOLDERS, default=list(FOLDERS))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=10, help="how many faults of each folder")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="modules whose path has this in it")
    parser.add_argument("--most", type=float, default=120.0, metavar="S", help="how long tests of one fault may take")
    parser.add_argument("--longest", type=float, default=900.0, metavar="S", help="how long one file of tests may take")
    parser.add_argument("--suites", nargs="+", default=list(SUITES), help="folders of tests/ to choose from")
    parser.add_argument("--reach", action="store_true", help="only find out which lines each file of tests reaches")
    parser.add_argument("--store", action="store_true", help="keep the numbers for docs/quality.md")
    parser.add_argument("--least", type=float, default=0.0, metavar="PERCENT")
    arguments = parser.parse_args()
    with _copies(arguments.jobs) as copies:
        suites = {
            name: each for name, each in reached(arguments.suites, copies, arguments.longest).items() if each.passed
        }
        if arguments.reach:
            return 0
        scores = [_tried(folder, arguments, suites, copies) for folder in arguments.folders]
    noticed, all_ = map(sum, zip(*scores, strict=True))
    score = 100 * noticed / max(1, all_)
    print(f"generator: {noticed} of {all_} are noticed, {score:.1f} %")
    return 1 if score < arguments.least else 0


def _tried(
    folder: str, arguments: argparse.Namespace, suites: Mapping[str, Reached], copies: "Queue[Path]"
) -> tuple[int, int]:
    """Try a sample of the faults of one folder; return how many were noticed, and of how many."""
    paths = sorted((ROOT / "codegen" / folder).rglob("*.py"))
    texts = {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for path in paths}
    texts = {name: text for name, text in texts.items() if arguments.only in name}
    known = [mutant for name, text in texts.items() for mutant in mutants_of(name, text)]
    drawn = random.Random(arguments.seed).sample(known, min(arguments.count, len(known)))
    equivalent = listed(texts)
    tried = [mutant for mutant in drawn if not is_listed(fault_of(mutant, texts[mutant.file]), equivalent)]
    without = len(drawn) - len(tried)
    print(f"{folder}: {len(known)} faults known, {len(drawn)} drawn, {without} of them without effect", flush=True)
    noticed, all_ = Counter[str](), Counter[str](mutant.file for mutant in tried)

    def one(mutant: Mutant) -> None:
        chosen, left = chosen_tests(mutant, texts[mutant.file], folder, suites, arguments.most)
        begun = time.monotonic()
        longest = 60 + 10 * sum(suites[name].seconds for name in chosen)
        by = _noticed_by(mutant, texts[mutant.file], chosen, copies, longest) if chosen else None
        seconds = time.monotonic() - begun
        noticed[mutant.file] += by is not None
        of = (
            f"by {len(chosen)} of the {len(chosen) + left} files of tests that reach it"
            if chosen
            else "no test reaches it"
        )
        state = f"noticed by {by}" if by is not None else f"NOT NOTICED {of}"
        print(f"  {mutant.shown(texts[mutant.file])}: {state}, {seconds:.0f} s", flush=True)

    with ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(one, tried))
    print(f"{folder}: {noticed.total()} of {len(tried)} are noticed", flush=True)
    if arguments.store:
        found = {"seed": arguments.seed, "drawn": len(drawn), "equivalent": without}
        modules = {name: [noticed[name], all_[name]] for name in sorted(all_)}
        store("mutation", f"codegen/{folder}", {**found, "modules": modules})
    return noticed.total(), len(tried)


def chosen_tests(
    mutant: Mutant, text: str, folder: str, suites: Mapping[str, Reached], most: float
) -> tuple[list[str], int]:
    """Return the files of tests to run for a fault, in their order, and how many more reach it but take too long."""
    lines = set(_statement(text, mutant.line))
    reaching = [name for name, each in suites.items() if lines.intersection(each.lines.get(mutant.file, ()))]
    near = FOLDERS[folder]

    def rank(name: str) -> tuple[int, int, float]:
        own = name.split("/")[1]
        reached = len(suites[name].lines[mutant.file])
        return -reached, near.index(own) if own in near else len(near), suites[name].seconds

    chosen: list[str] = []
    spent = 0.0
    for name in sorted(reaching, key=rank):
        if spent + suites[name].seconds <= most:
            chosen.append(name)
            spent += suites[name].seconds
    return chosen, len(reaching) - len(chosen)


def _statement(text: str, line: int) -> range:
    """The lines of the innermost statement around a line: of one with a body, those above it."""
    best = range(line, line + 1)
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.stmt) and node.lineno <= line <= (node.end_lineno or node.lineno):
            body = getattr(node, "body", None)
            end = body[0].lineno if body else (node.end_lineno or node.lineno) + 1
            if line < max(end, node.lineno + 1):
                best = range(node.lineno, max(end, node.lineno + 1))
    return best


@contextmanager
def _copies(number: int) -> "Iterator[Queue[Path]]":
    folder = Path(tempfile.mkdtemp(prefix="codegen-mutation-"))
    copies: Queue[Path] = Queue()
    try:
        for each in range(number):
            copies.put(copy_of_repository(folder / str(each)))
        yield copies
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _noticed_by(mutant: Mutant, text: str, tests: list[str], copies: "Queue[Path]", longest: float) -> str | None:
    """Return the test that fails with a fault, or that it hangs; None where all pass."""
    copy = copies.get()
    path = copy / mutant.file
    times = path.stat()
    try:
        path.write_text(mutant.applied(text), encoding="utf-8")
        # Compiled modules are taken for those of a source with the same time and size, and none are written.
        os.utime(path, (times.st_atime, times.st_mtime + next(_NUMBERS)))
        return _failed(copy, tests, longest)
    finally:
        path.write_text(text, encoding="utf-8")
        os.utime(path, (times.st_atime, times.st_mtime))
        copies.put(copy)


def _failed(copy: Path, tests: list[str], longest: float) -> str | None:
    command = [sys.executable, "-m", "pytest", *OPTIONS, "-W", "ignore", *tests]
    environment = {**surroundings(copy), "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        done = subprocess.run(
            command, cwd=copy, env=environment, capture_output=True, text=True, timeout=longest, check=False
        )
    except subprocess.TimeoutExpired:
        return "that it hangs"
    if done.returncode == 0:
        return None
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED ", "ERROR "))]
    return failed[0].split()[1] if failed else f"exit code {done.returncode}"


if __name__ == "__main__":
    sys.exit(main())
