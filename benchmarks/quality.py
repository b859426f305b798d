# ruff: noqa: S603, T201  it starts pytest to count tests, and says what it does
"""Counts tests, criteria and lines, and writes docs/quality.md from these and from what other commands have stored.

`make quality` counts anew; `python benchmarks/quality.py --stored` only writes the page. `make fuzz`, `make mutation`
with FAULTS="--store ..." store what they find. A test holds the page to what is stored.
"""

import argparse
import ast
import json
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence

import quality_results
from quality_results import Found
from results import ROOT
from whole_program import module_folders

from codegen.model.program_folders import COMMON, SHARED_PARTS

PAGE = ROOT / "docs" / "quality.md"
FOLDERS = ("codegen", "templates", "tests")
"""Of which the lines are counted; documents that tests read, and what was generated, are none of them."""
CODE = (".py", ".j2", ".in", ".css", ".js", ".html")
PROGRAMS = {"rover": "", "smart_battery": "smart_battery"}
"""By how a program is called its name in the project."""


def main() -> int:
    """Count, store, write."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--stored", action="store_true", help="count nothing: write what is stored")
    arguments = parser.parse_args()
    if not arguments.stored:
        quality_results.store("counts", "tests", tests())
        quality_results.store("counts", "generated", generated())
        quality_results.store("counts", "criteria", criteria())
        quality_results.store("counts", "lines", {folder: lines(folder) for folder in FOLDERS})
        quality_results.store("counts", "programs", programs())
    PAGE.write_text(page(quality_results.read()), encoding="utf-8")
    print(f"{PAGE.relative_to(ROOT)} written")
    return 0


def tests() -> Found:
    """Return how many tests each folder of tests/ has, as pytest collects them."""
    command = [sys.executable, "-m", "pytest", "--collect-only", "-qq", "-p", "no:xdist", "tests"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    counts: Counter[str] = Counter()
    for folder, number in re.findall(r"(?m)^tests/(\w+)/.*: (\d+)$", done.stdout):
        counts[folder] += int(number)
    if not counts:
        raise SystemExit(done.stdout + done.stderr)
    return dict(sorted(counts.items()))


def generated() -> Found:
    """Return how many cases and checks the generated suite of each program has."""
    found = {}
    for program, name in PROGRAMS.items():
        own, common = module_folders(ROOT / "generated", "tests", program=name)
        cases = json.loads((own / "cases.json").read_text(encoding="utf-8"))["messages"]
        scripts = [*own.glob("*_checks.py"), *common.glob("*_checks.py")]
        checks = sum(_checks(path.read_text(encoding="utf-8")) for path in scripts)
        found[program] = {"cases": len(cases), "checks": checks}
    return found


def _checks(text: str) -> int:
    """Return how many checks a module lists as its CHECKS."""
    lists = [
        each.value
        for each in ast.parse(text).body
        if isinstance(each, ast.Assign) and ast.unparse(each.targets[0]) == "CHECKS"
    ]
    return sum(len(each.elts) for each in lists if isinstance(each, ast.List | ast.Tuple))


def criteria() -> Found:
    """Return how many criteria the requirement documents state, by how they are shown."""
    from codegen.commands.trace import read_trace, read_trace_lock  # noqa: PLC0415  the page alone needs no specification
    from codegen.diagnostics import Report  # noqa: PLC0415
    from codegen.project.systems import read_systems  # noqa: PLC0415  the page alone needs no specification
    from codegen.trace.coverage import coverage_of  # noqa: PLC0415
    from codegen.trace.link import suspects  # noqa: PLC0415
    from codegen.trace.lock import reviews  # noqa: PLC0415

    project = str(ROOT / "specs" / "codegen.yaml")
    report = Report()
    systems = read_systems(project, report)
    trace = read_trace(systems, report)
    found: Counter[str] = Counter()
    lock = read_trace_lock(project, report)
    for each in coverage_of(trace, reviews(trace, lock), suspects(trace, lock), None):
        if not each.is_decision:
            kinds = {bool(tested.test.inputs) for tested in each.tests}
            found[_shown_by(kinds, has_limit=each.host_limit is not None)] += 1
    return {"documents": len({each.place for system in systems for each in system.requirements.values()}), "by": found}


def _shown_by(kinds: set[bool], *, has_limit: bool) -> str:
    words = {
        frozenset({True, False}): "generated tests and tests written by hand",
        frozenset({True}): "generated tests",
        frozenset({False}): "tests written by hand",
        frozenset(): "no test on a host",
    }
    return words[frozenset(kinds)] + (", and in part on a bench" if has_limit else "")


def programs() -> Found:
    """Return how many modules, and lines in them, the programs of the rover's project have for themselves and alike."""
    found = {}
    for program, folder in (*PROGRAMS.items(), (COMMON, COMMON)):
        paths = [path for part in SHARED_PARTS for path in (ROOT / "generated" / folder / part).glob("*.py")]
        found[program] = {"modules": len(paths), "lines": sum(path.read_bytes().count(b"\n") for path in paths)}
    return found


def lines(folder: str) -> int:
    """Return how many lines the code below a folder has."""
    paths = [path for path in (ROOT / folder).rglob("*") if path.suffix in CODE and "__pycache__" not in path.parts]
    return sum(path.read_bytes().count(b"\n") for path in paths if "corpus" not in path.parts)


TEXT = """\
# How well it is tested

Every number here was counted by a command, which stands beside it, and is kept in `benchmarks/results/quality.json`;
`make quality` counts tests, criteria and lines anew and writes this page. Whether all tests pass, `make test` says.

## Tests

`make quality` counted {all_tests:,} tests of the generator and of what it generates, by the folder of `tests/`.

{tests}

The suites that are generated for users: cases are messages in a given state, compared byte by byte under CPython and
MicroPython; checks run a whole program.

{generated}

## Criteria

The {documents} requirement documents of the rover state {all_criteria} criteria that somebody has to show;
`codegen trace` follows each to its tests, and in `make test` to their results.

{criteria}

## Faults that the generated suite notices

`make mutation` puts small faults into the firmware, one at a time, drawn by lot from a seed, and runs the generated
suite. Faults without effect are listed in `benchmarks/equivalents.yaml` with the reason, and left out.
`make mutation FAULTS="--store"` keeps the numbers. Checks were written for what the run with seed 1 had not
noticed; other seeds are as they were drawn, faults without effect included that nobody had listed. How many of these
are listed by now, with a reason, stands behind (`--judge` counts them), and the share of those that are left.

{mutation}

## Faults that the tests of the generator notice

`make generator-mutation` puts faults of the same kinds into folders of `codegen/`, and runs the tests that reach the
line for a minute or two, first those that reach what few others do. What fails has to pass without the fault. Faults
without effect are listed in `benchmarks/equivalents.yaml`, too, and left out. Tests were written for what the run with
seed 1 had not noticed; other seeds are as they were drawn, and tests for what they left were written after that. Since
`targets` 6 and `claims` 7 tests also compare what is made of every project that there is, and all findings in the
corpus of documents. With these, and from `claims` 8, `diff` 4, `decode` 4, `rules` 4 and `resolve` 4 on, only the tests
of some folders were run (`--suites`), which can notice no more than all of them: with `resolve` 4 those of
`tests/resolve/` alone, which do not reach three of its faults. Seed 21 was drawn in all folders and tried with all
tests: 54 of 60. Of the six that are left nobody can notice two, which are listed since, one was in a condition that
another one implied, which is gone, and three have a test since.

{generator}

## Inputs with faults

`make fuzz` gives codegen inputs with faults of bytes, lines, YAML nodes, XML elements, tables and paths, and judges
what it does (`benchmarks/fuzz.py` says by what). A fault is anything that must not happen, such as a traceback or a
finding without a place. `make fuzz FUZZ="--seed 2 --store"` keeps the numbers of another seed.

{fuzz}

Of the two faults of seed 14 one was an internal error, which is mended (a driver whose outputs cannot be read); the
other input took more than 10 s in a process that had seen two thousand others, and takes a second alone. That of
seed 22 was a document with lines of 300,000 characters, for which 12 s were needed; it takes a third of that now.
Those of seed 23 are documents with a table of six thousand columns: each looked at all cells, which none does now.

Then it lets hostile bytes arrive at the receiver of a codec and at the rover's program, in machine code and in plain
Python, as bytes and as datagrams (`benchmarks/hostile.py`): each frame among them that is right has to be found.

{hostile}

## Lines

`make quality` counted the lines of code, with comments and empty ones, of these folders.

{lines}

The rover and its smart battery are two programs of one project. What they have alike is written once
([files.md](files.md#several-programs)): without that there would be {shared:,} lines more in `generated/`.

{programs}
"""


def page(found: dict[str, dict[str, Found]]) -> str:
    """Return the page about what is stored."""
    counts = found["counts"]
    criteria_by = counts["criteria"]["by"]
    mutation = found.get("mutation", {})
    return TEXT.format(
        all_tests=sum(counts["tests"].values()),
        tests=_table(("folder", "tests"), [(f"`{name}`", number) for name, number in counts["tests"].items()]),
        generated=_table(
            ("program", "cases", "checks"),
            [(name, each["cases"], each["checks"]) for name, each in counts["generated"].items()],
        ),
        documents=counts["criteria"]["documents"],
        all_criteria=sum(criteria_by.values()),
        criteria=_table(("shown by", "criteria"), sorted(criteria_by.items())),
        mutation=_mutation("program", {key: each for key, each in mutation.items() if not key.startswith("codegen/")}),
        generator=_mutation("folder", {key: each for key, each in mutation.items() if key.startswith("codegen/")}),
        fuzz=_table(
            ("run", "inputs", "clean (0)", "findings (1)", "unreadable (2)", "faults"),
            [
                (f"seed {seed}", run["inputs"], *(run["codes"].get(code, 0) for code in "012"), run["faults"])
                for seed, run in _by_seed(found.get("fuzz", {}))
            ],
        ),
        hostile=_table(
            ("run", "bytes for each", "receivers", "faults"),
            [
                (f"seed {seed}", run["bytes"], run["receivers"], run["faults"])
                for seed, run in _by_seed(found.get("hostile", {}))
            ],
        ),
        lines=_table(("folder", "lines"), [(f"`{name}/`", number) for name, number in counts["lines"].items()]),
        shared=counts["programs"][COMMON]["lines"] * (len(PROGRAMS) - 1),
        programs=_table(
            ("program", "modules of its own", "lines"),
            [(name, each["modules"], each["lines"]) for name, each in counts["programs"].items() if name != COMMON]
            + [("what both have alike", counts["programs"][COMMON]["modules"], counts["programs"][COMMON]["lines"])],
        ),
    )


def _by_seed(runs: dict[str, Found]) -> list[tuple[str, Found]]:
    return sorted(runs.items(), key=lambda run: int(run[0]))


def _mutation(what: str, parts: dict[str, Found]) -> str:
    rows: list[tuple[object, ...]] = []
    head = (what, "seed", "faults", "noticed", "share")
    is_judged = any("listed_since" in each for each in parts.values())
    for part, each in sorted(parts.items(), key=lambda found: (found[0].split()[0], found[1]["seed"])):
        noticed, tried = (sum(pair[index] for pair in each["modules"].values()) for index in (0, 1))
        name = part.split()[0]  # its seed stands behind it
        name = f"`{name}/`" if name.startswith("codegen/") else name
        row = (name, each["seed"], tried, noticed, _share(noticed, tried))
        without = each.get("listed_since", 0)
        rows.append((*row, without, _share(noticed, tried - without)) if is_judged else row)
    return _table((*head, "without effect", "of the others") if is_judged else head, rows)


def _share(part: int, whole: int) -> str:
    return f"{100 * part / max(1, whole):.0f} %"


def _table(head: tuple[str, ...], rows: Sequence[tuple[object, ...]]) -> str:
    """Return a table; where nothing is stored a sentence says so."""
    if not rows:
        return "No run is stored yet."
    lines = [f"| {' | '.join(head)} |", f"| --- |{' ---: |' * (len(head) - 1)}"]
    for row in rows:
        lines.append(f"| {' | '.join(f'{cell:,}' if isinstance(cell, int) else str(cell) for cell in row)} |")
    return "\n".join(lines)


if __name__ == "__main__":
    sys.exit(main())
