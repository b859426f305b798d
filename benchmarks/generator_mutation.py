# ruff: noqa: T201  it prints what tests have not noticed
"""Puts faults into the generator itself, one at a time, and counts those that its tests notice.

`make generator-mutation` draws some of each stage's folder; the same seed draws the same faults from the same sources.
A fault goes into a copy of the repository, which is imported from there and keeps nothing anywhere else. The tests that
reach its line are run (`reached.py`), first those that reach what few others do of its module, and are quick or in the
stage's own folder, until one fails or they would take more than `--most` seconds. The test that failed then has to pass
without the fault. A fault without effect is listed in benchmarks/equivalents.yaml, with the reason.
"""

import argparse
import ast
import hashlib
import os
import random
import resource
import shutil
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
from quality_results import left_by, store
from reached import SUITES, Reached, copy_of_repository, reached, surroundings, tests_of
from results import ROOT

FOLDERS = ("resolve", "rules", "decode", "targets", "diff", "claims")
"""Of codegen, the stages that are looked at in this way."""
BATCHES = (1, 3, None)
"""So many files of tests run in one process, and then the next: most faults are noticed by the first one."""
NOT_FOUND = "exit code 4"
"""pytest's exit code for a test that it does not know."""
MEMORY = 4_000_000_000
"""Bytes that a process may take: there are faults that make endless lists."""
_NUMBERS = count(1)


def main() -> int:
    """Draw, try, print; 1 where fewer are noticed than `--least` asks for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--folders", nargs="+", choices=FOLDERS, default=list(FOLDERS))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=10, help="how many faults of each folder")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="modules whose path has this in it")
    parser.add_argument(
        "--most",
        type=float,
        default=120.0,
        metavar="S",
        help="how long the tests of one fault may take",
    )
    parser.add_argument("--suites", nargs="+", default=list(SUITES), help="folders of tests/ to choose from")
    parser.add_argument("--reach", action="store_true", help="only find out which lines each file of tests reaches")
    parser.add_argument(
        "--again",
        action="store_true",
        help="try only what the stored run of the same faults has not noticed: where there are more tests since",
    )
    parser.add_argument("--store", action="store_true", help="keep the numbers for docs/quality.md")
    parser.add_argument("--least", type=float, default=0.0, metavar="PERCENT")
    arguments = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_DATA, (MEMORY, resource.getrlimit(resource.RLIMIT_DATA)[1]))
    with _place() as place:
        found = reached(arguments.suites, FOLDERS, place, arguments.most)
        if arguments.reach:
            return 0
        suites = {name: each for name, each in found.items() if each.passed}
        if not suites:
            raise SystemExit("every file of tests fails in a copy: that none notices a fault would say nothing")
        copies = _copies(place, arguments.jobs)
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
    sources = hashlib.sha256("".join(texts.values()).encode()).hexdigest()
    drawing = {"seed": arguments.seed, "drawn": len(drawn), "sources": sources}
    given = f"codegen/{folder} {arguments.seed}"
    known_as = {mutant: list(fault_of(mutant, texts[mutant.file])) for mutant in tried}
    left = left_by("mutation", given, drawing) if arguments.again else list(known_as.values())
    asked = [mutant for mutant in tried if known_as[mutant] in left]
    noticed = Counter(mutant.file for mutant in tried if mutant not in asked)
    left = []

    def one(mutant: Mutant) -> None:
        text = texts[mutant.file]
        chosen, more = chosen_tests(mutant, text, suites, arguments.most)
        begun = time.monotonic()
        by = _noticed_by(mutant, text, chosen, suites, copies)
        seconds = time.monotonic() - begun
        noticed[mutant.file] += by is not None
        if by is None:
            left.append(known_as[mutant])
        of = f"by {len(chosen)} of the {len(chosen) + more} files of tests that reach it"
        state = f"noticed by {by}" if by is not None else f"NOT NOTICED {of if chosen else 'no test reaches it'}"
        print(f"  {mutant.shown(text)}: {state}, {seconds:.0f} s", flush=True)

    with ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(one, asked))
    print(f"{folder}: {noticed.total()} of {len(tried)} are noticed", flush=True)
    if arguments.store:
        all_ = Counter(mutant.file for mutant in tried)
        modules = {name: [noticed[name], all_[name]] for name in sorted(all_)}
        store("mutation", given, {**drawing, "equivalent": without, "left": sorted(left), "modules": modules})
    return noticed.total(), len(tried)


def chosen_tests(mutant: Mutant, text: str, suites: Mapping[str, Reached], most: float) -> tuple[list[str], int]:
    """Return the files of tests to run for a fault, in their order, and how many more reach it but take too long."""
    lines = set(_statement(text, mutant.line))
    reaching = {name: each for name, each in suites.items() if lines.intersection(each.lines.get(mutant.file, ()))}
    reach = Counter(line for each in reaching.values() for line in each.lines[mutant.file])
    begin = 2.0  # seconds, before the first test
    own = f"tests/{mutant.file.split('/')[1]}/"

    def worth(name: str) -> float:
        """Return the worth of a file of tests: more where it is about the module or reaches lines that others miss."""
        rare = sum(1 / reach[line] for line in reaching[name].lines[mutant.file])
        return rare * (4 if name.startswith(own) else 1) / (begin + reaching[name].seconds)

    chosen: list[str] = []
    spent = 0.0
    for name in sorted(reaching, key=worth, reverse=True):
        if spent + reaching[name].seconds <= most:
            chosen.append(name)
            spent += reaching[name].seconds
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
def _place() -> Iterator[Path]:
    folder = Path(tempfile.mkdtemp(prefix="codegen-mutation-"))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _copies(place: Path, number: int) -> "Queue[Path]":
    """Return copies of the repository, compiled."""
    copies: Queue[Path] = Queue()
    for each in range(number):
        copy = copy_of_repository(place / str(each))
        tests_of(copy, ["--collect-only"], surroundings(copy), 600)
        copies.put(copy)
    return copies


def _noticed_by(
    mutant: Mutant, text: str, tests: list[str], suites: Mapping[str, Reached], copies: "Queue[Path]"
) -> str | None:
    """Return the test that fails with a fault and passes without it; None where all pass.

    A file of tests that fails without the fault says nothing, and is left out.
    """
    copy = copies.get()
    left = list(tests)
    sizes = iter(BATCHES)
    try:
        while left:
            batch = left[: next(sizes, None)]
            with _put_in(mutant, text, copy):
                by = _failed(copy, batch, sum(suites[name].seconds for name in batch))
            if by is None:
                left = left[len(batch) :]
            elif "::" not in by or _passes(copy, by, suites):
                return by
            else:
                print(f"  {by} fails without the fault, too", flush=True)
                left.remove(by.split("::")[0])
        return None
    finally:
        copies.put(copy)


def _passes(copy: Path, test: str, suites: Mapping[str, Reached]) -> bool:
    """Return whether a test passes by itself; one that cannot be named has to in its file."""
    file = test.split("::", maxsplit=1)[0]
    failed = _failed(copy, [test], suites[file].seconds)
    return failed is None or (failed == NOT_FOUND and _failed(copy, [file], suites[file].seconds) is None)


@contextmanager
def _put_in(mutant: Mutant, text: str, copy: Path) -> Iterator[None]:
    path = copy / mutant.file
    times = path.stat()
    try:
        path.write_text(mutant.applied(text), encoding="utf-8")
        # Compiled modules are taken for those of a source with the same time and size, and none are written.
        os.utime(path, (times.st_atime, times.st_mtime + next(_NUMBERS)))
        yield
    finally:
        path.write_text(text, encoding="utf-8")
        os.utime(path, (times.st_atime, times.st_mtime))


def _failed(copy: Path, tests: list[str], seconds: float) -> str | None:
    """Return the test that fails, or what else ended the run; ``seconds`` is how long the tests take by themselves."""
    longest = 30 + 5 * seconds
    environment = {**surroundings(copy), "PYTHONDONTWRITEBYTECODE": "1"}
    done = tests_of(copy, [f"--timeout={longest:.0f}", *tests], environment, 2 * longest)
    if done is None:
        return "that it hangs"
    if done.returncode == 0:
        return None
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED ", "ERROR "))]
    return failed[0].partition(" ")[2].split(" - ")[0] if failed else f"exit code {done.returncode}"


if __name__ == "__main__":
    sys.exit(main())
