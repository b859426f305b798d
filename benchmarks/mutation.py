# ruff: noqa: T201  it prints what that has not noticed
"""Puts faults into the generated firmware, one at a time, and counts those that the generated suite notices.

`make mutation` draws a sample of the rover's; `--program boat` takes examples/boat. The same seed draws the same faults
from the same firmware. A fault that changes nothing that anybody can notice is listed in benchmarks/equivalents.yaml,
with the reason, and does not count.
"""

import argparse
import hashlib
import os
import random
import shutil
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Set
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from queue import Queue

from equivalents import Fault, fault_of, is_listed, listed
from measure import ROOT
from mutants import Mutant, mutants_of
from process_group import outcome
from quality_results import left_by, read, store
from whole_program import module_folders, whole_program

PROGRAMS = {
    "rover": ("generated", ""),
    "smart_battery": ("generated", "smart_battery"),
    "boat": ("examples/boat/generated", ""),
}
"""By program the output folder of its project, and its name there; what its tests read of the project lies above."""
LONGEST = 6
"""The largest multiple of the suite's time without a fault: a longer run says nothing, and is left for --again."""
GIVES_UP_S = 240
"""The seconds beside that: a check that hangs fails after two minutes, one that simulates days after four."""

NO_TESTS = 5
"""pytest's exit code for a part that has no tests: not every suite simulates days."""


def main() -> int:
    """Draw, try, print; 1 where fewer are noticed than `--least` asks for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--program", choices=PROGRAMS, default="rover")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="modules whose name has this in it")
    parser.add_argument("--store", action="store_true", help="keep the numbers for docs/quality.md")
    parser.add_argument(
        "--again",
        action="store_true",
        help="try only what the stored run of the same faults has not noticed: where the suite has more cases since",
    )
    parser.add_argument(
        "--judge",
        action="store_true",
        help="run nothing: keep for each stored run of the program how many of the faults it left are listed by now",
    )
    parser.add_argument("--least", type=float, default=0.0, metavar="PERCENT")
    arguments = parser.parse_args()
    output = PROGRAMS[arguments.program][0]
    if not (ROOT / output).is_dir():
        raise SystemExit(f"{output} is not there: run codegen build in {Path(output).parent}")
    texts = {
        name: text
        for name, text in firmware_of(arguments.program).items()
        if arguments.only in name.removesuffix(".py")
    }
    known = [mutant for name, text in texts.items() for mutant in mutants_of(name, text)]
    equivalent = listed(texts, arguments.program)
    if arguments.judge:
        _judge(arguments.program, equivalent)
        return 0
    drawn = random.Random(arguments.seed).sample(known, min(arguments.count, len(known)))
    tried = [mutant for mutant in drawn if not is_listed(fault_of(mutant, texts[mutant.file]), equivalent)]
    firmware_hash = hashlib.sha256("".join(texts.values()).encode()).hexdigest()
    drawing = {"seed": arguments.seed, "drawn": len(drawn), "firmware": firmware_hash}
    known_as = {mutant: list(fault_of(mutant, texts[mutant.file])) for mutant in tried}
    given = f"{arguments.program} {arguments.seed}"
    left = left_by("mutation", given, drawing) if arguments.again else list(known_as.values())
    asked = [mutant for mutant in tried if known_as[mutant] in left]
    print(
        f"{len(known)} faults known, {len(drawn)} drawn, {len(drawn) - len(tried)} of them without effect", flush=True
    )
    all_ = Counter[str](mutant.file for mutant in tried)
    noticed = Counter[str](mutant.file for mutant in tried if mutant not in asked)
    left = []
    with _copies(arguments.program, arguments.jobs) as copies, ThreadPoolExecutor(arguments.jobs) as pool:
        longest_s = _longest_s(copies.queue[0])
        for mutant, passes in zip(
            asked, pool.map(lambda each: _passes_with(each, texts, copies, longest_s), asked), strict=True
        ):
            noticed[mutant.file] += passes is False
            if passes is not False:
                left.append(known_as[mutant])
                what = "it takes too long" if passes is None else "not noticed"
                print(f"{what}: {mutant.shown(texts[mutant.file])}", flush=True)
    for name in sorted(all_, key=lambda name: (noticed[name] / all_[name], name)):
        print(f"{name:28} {noticed[name]:3} of {all_[name]:3}")
    score = 100 * sum(noticed.values()) / max(1, len(tried))
    print(f"{arguments.program}: {sum(noticed.values())} of {len(tried)} are noticed, {score:.1f} %")
    if arguments.store:
        modules = {name: [noticed[name], all_[name]] for name in sorted(all_)}
        found = {**drawing, "equivalent": len(drawn) - len(tried), "left": left}
        store("mutation", given, {**found, "modules": modules})
    return 1 if score < arguments.least else 0


def _judge(program: str, equivalent: Set[Fault]) -> None:
    """Keep for each stored run of a program how many of the faults that it left are known to have no effect by now.

    One whose line has been written anew since then counts as it did.
    """
    for given, run in read().get("mutation", {}).items():
        if given.split()[0] == program:
            left = [Fault(*each) for each in run["left"]]
            without = sum(is_listed(fault, equivalent) for fault in left)
            store("mutation", given, {**run, "listed_since": without})
            print(f"{given}: {without} of {len(left)} faults that were left have no effect")


def firmware_of(program: str) -> dict[str, str]:
    """Return the modules of the firmware of a program by the names of their files, in their order."""
    output, name = PROGRAMS[program]
    paths = [path for folder in module_folders(ROOT / output, "firmware", program=name) for path in folder.glob("*.py")]
    return {path.name: path.read_text(encoding="utf-8") for path in sorted(paths, key=lambda path: path.name)}


@contextmanager
def _copies(program: str, count: int) -> "Iterator[Queue[Path]]":
    """Copies of the project."""
    folder = Path(tempfile.mkdtemp(prefix="codegen-mutation-"))
    copies: Queue[Path] = Queue()
    try:
        for number in range(count):
            copy = folder / str(number)
            root = ROOT / "examples/boat" if program == "boat" else ROOT
            shutil.copytree(root / "specs", copy / "specs")
            for module in root.glob("*.py"):
                shutil.copy(module, copy)
            output, further = PROGRAMS[program]
            whole = whole_program(ROOT / output, copy / "generated" / further, further)
            if (ROOT / output / further / "receiver").exists():  # which the suite tests, too
                shutil.copytree(ROOT / output / further / "receiver", whole / "receiver")
            copies.put(whole)
        yield copies
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def _longest_s(copy: Path) -> float:
    """Return how long the suite of a copy may take with a fault: it passes without any."""
    begun = time.monotonic()
    if not _passes(copy, None):
        raise SystemExit("the suite fails without any fault")
    return LONGEST * (time.monotonic() - begun) + GIVES_UP_S


def _passes_with(mutant: Mutant, texts: dict[str, str], copies: "Queue[Path]", longest_s: float) -> bool | None:
    copy = copies.get()
    path = copy / "firmware" / mutant.file
    try:
        path.write_text(mutant.applied(texts[mutant.file]))
        return _passes(copy, longest_s)
    finally:
        path.write_text(texts[mutant.file])
        copies.put(copy)


def _passes(copy: Path, longest_s: float | None) -> bool | None:
    """Return whether the suite of a copy passes; None where a part of it takes longer than it may.

    What simulates days comes last: most faults are noticed without. No plugin is needed, and importing them takes time.
    """
    options = ["-c", "/dev/null", "--rootdir", str(copy), "-x", "-q", "-p", "no:cacheprovider", "-W", "ignore"]
    environment = {**os.environ, "PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1"}
    for part in ("not days", "days"):
        command = [sys.executable, "-B", "-m", "pytest", *options, "-m", part, str(copy / "tests")]
        done = outcome(command, copy.parent, longest_s, environment)
        if done is None or done.returncode not in (0, NO_TESTS):
            return None if done is None else False
    return True


if __name__ == "__main__":
    sys.exit(main())
