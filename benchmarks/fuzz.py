# ruff: noqa: T201  it says what it finds
"""Gives codegen inputs with faults, thousands of them, and judges what it does with each, in children of this process.

`make fuzz` draws them by lot: the same seed draws the same from the same sources. No input may end in anything but the
exit codes 0, 1 and 2; findings have places in the project; nothing outside of it is read, quoted or written, and
nothing at all is written after an error; what is built compiles; each input has a few seconds. An input for which that
does not hold is stored below build/fuzz, and `benchmarks/fuzz.py --again build/fuzz/SEED-NUMBER` tries it again.
"""

import argparse
import faulthandler
import os
import resource
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

import quality_results
from fuzzing.children import EACH, in_children
from results import ROOT

if TYPE_CHECKING:
    from fuzzing.case import Case
    from fuzzing.judge import Outcome

FAILED = ROOT / "build" / "fuzz"
MEMORY = 4 << 30
"""Bytes that a process may have."""
HANGS_S = 300
"""Seconds after which an input in which no Python runs any more ends its process."""


def main() -> int:
    """Draw, judge, print; 1 where something was found."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=10_000, help="inputs")
    parser.add_argument("--first", type=int, default=0, help="the number of the first: a stored run goes on")
    parser.add_argument("--minutes", type=float, default=90, help="after which no further input is drawn")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="inputs that are judged at a time")
    parser.add_argument("--seconds", type=float, default=10, help="of the processor, for one input")
    parser.add_argument("--small", action="store_true", help="only of small projects")
    parser.add_argument("--out", type=Path, default=FAILED, help="the folder for inputs that fail")
    parser.add_argument("--store", action="store_true", help="keep the numbers for docs/quality.md")
    parser.add_argument("--again", type=Path, metavar="FOLDER", help="try one that was stored")
    arguments = parser.parse_args()
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    warnings.simplefilter("error")
    with tempfile.TemporaryDirectory(prefix="codegen-fuzz-") as folder:
        os.environ["CODEGEN_CACHE"] = str(Path(folder, "cache"))
        Path(folder, "inputs").mkdir()
        return (
            _again(arguments, Path(folder, "inputs")) if arguments.again else _drawn(arguments, Path(folder, "inputs"))
        )


def _again(arguments: argparse.Namespace, folder: Path) -> int:
    from fuzzing.case import stored  # noqa: PLC0415  codegen asks for its cache when it is imported
    from fuzzing.judge import judged  # noqa: PLC0415

    from codegen.cli import main as codegen  # noqa: PLC0415

    case = stored(arguments.again)
    outcome = judged(case, folder, codegen, arguments.seconds)
    print(f"codegen {' '.join(case.command)}: {outcome.code} after {outcome.seconds:.2f} s")
    print(outcome.printed.strip())
    for fault in outcome.faults:
        print(f"fault: {fault}")
    return 1 if outcome.faults else 0


def _drawn(arguments: argparse.Namespace, folder: Path) -> int:
    from fuzzing.case import store  # noqa: PLC0415  as above

    codes, failed, kinds = Counter[int](), Counter[str](), Counter[str]()
    slowest, seconds = (0.0, ""), 0.0
    started = time.monotonic()
    for case, outcome in _judged(arguments, folder):
        codes[outcome.code] += 1
        kinds[case.kind] += 1
        slowest = max(slowest, (outcome.seconds, case.name))
        seconds += outcome.seconds
        if outcome.faults:
            failed[case.kind] += 1
            target = arguments.out / case.name
            if not target.exists():
                store(case, target)
            print(f"{case.name} ({case.kind}, codegen {' '.join(case.command)}): {outcome.faults[0]}", flush=True)
    told = ", ".join(f"{number} with {code}" for code, number in sorted(codes.items()))
    print(f"seed {arguments.seed}: {codes.total()} inputs in {(time.monotonic() - started) / 60:.1f} minutes: {told}")
    print(f"the longest took {slowest[0]:.1f} s ({slowest[1]}), all {seconds:.0f} s; {failed.total()} have faults")
    if arguments.store:
        numbers = {str(code): number for code, number in sorted(codes.items())}
        found: quality_results.Found = {"inputs": codes.total(), "codes": numbers, "faults": failed.total()}
        found["kinds"] = dict(sorted(kinds.items()))
        before = quality_results.read().get("fuzz", {}).get(str(arguments.seed), {})
        quality_results.store("fuzz", str(arguments.seed), run_on(before, arguments.first, found))
    return 1 if failed else 0


def run_on(before: quality_results.Found, first: int, found: quality_results.Found) -> quality_results.Found:
    """Return what two runs of a seed have found, where the second one began behind the last input of the first."""
    if not first:
        return found
    if before.get("inputs") != first:
        raise SystemExit(
            f"the stored run of this seed has {before.get('inputs', 0)} inputs: --first begins behind them"
        )
    return {
        **{name: before[name] + found[name] for name in ("inputs", "faults")},
        **{name: _added(before[name], found[name]) for name in ("codes", "kinds")},
    }


def _added(before: dict[str, int], found: dict[str, int]) -> dict[str, int]:
    return {name: before.get(name, 0) + found.get(name, 0) for name in sorted({*before, *found})}


def _judged(arguments: argparse.Namespace, folder: Path) -> Iterator[tuple["Case", "Outcome"]]:
    """Yield each input that is drawn, and what became of it."""
    from fuzzing.case import drawn  # noqa: PLC0415  as above
    from fuzzing.judge import Outcome, judged  # noqa: PLC0415

    from codegen.cli import main as codegen  # noqa: PLC0415

    def draw(number: int) -> "Case":
        return drawn(arguments.seed, number, is_small=arguments.small)

    def judge(case: "Case") -> Outcome:
        faulthandler.dump_traceback_later(HANGS_S, exit=True)
        with tempfile.TemporaryDirectory(dir=folder) as own:
            outcome = judged(case, Path(own), codegen, arguments.seconds)
        faulthandler.cancel_dump_traceback_later()
        return outcome

    for right in _right(is_small=arguments.small):
        judge(right)
    sys.dont_write_bytecode = True
    ended = Outcome(-1, 0.0, ("its process ended",), "")
    for number, outcome in in_children(lambda number: judge(draw(number)), _batches(arguments), arguments.jobs):
        yield draw(number), outcome or ended


def _batches(arguments: argparse.Namespace) -> Iterator[range]:
    """Yield the numbers of inputs for one child after the other, until the time is over."""
    started = time.monotonic()
    last = arguments.first + arguments.count
    for first in range(arguments.first, last, EACH):
        if time.monotonic() - started > 60 * arguments.minutes:
            print(f"{arguments.minutes:g} minutes are over")
            return
        yield range(first, min(first + EACH, last))


def _right(*, is_small: bool) -> Iterator["Case"]:
    """Yield inputs without faults: what they need is imported and kept once, for all children, bytecode included."""
    from fuzzing.case import Case  # noqa: PLC0415  as above
    from fuzzing.samples import samples  # noqa: PLC0415

    files = {each.name: each.files for each in samples()}
    project = files["minimal" if is_small else "rover"]
    for command in (("build",), ("trace",), ("explain", "HEARTBEAT"), ("diff", "../before", ".")):
        yield Case("right", "project file", command, project, before=project)
    codec = ("codec", "--dialect", "minimal.xml", "--messages", "all", "--out", "made")
    yield Case("right", "dialect alone", codec, files["dialect minimal"])


if __name__ == "__main__":
    sys.exit(main())
