"""docs/benchmarks.md, of the stored results and nothing else."""

from collections.abc import Iterable, Mapping

import cost
from figure import Figure, number
from results import Result

TITLES = {
    "cost": "What a board will need",
    "frame": "From values to a frame",
    "parse": "From bytes to messages",
    "generator": "The generator",
    "size": "What it takes on a board",
    "heap": "The heap of the whole program",
    "heap_modules": "Where the heap goes",
    "simulation": "The simulation",
}
"""The benchmarks in the order of the page: the name of each script, and its heading."""

INTRODUCTION = """\
# Benchmarks

<!-- Written by benchmarks/report.py (make benchmarks) from benchmarks/results: a change by hand does not last. -->

Every figure is a ratio of two runs on one and the same computer, a number of instructions, or a number of bytes; times
of one computer would say nothing about another, and only how fast the simulation is has to be one. Contestants take
turns, and the best of several rounds counts. Before anything is timed, all contestants have to make the same bytes, or
find the same values.

"Machine code" is what the codec and the firmware have by default, "bytecode" is `codegen codec --bytecode` and
`machine_code: false`. MicroPython is its unix port on a 64-bit computer, with a heap of 512 KiB; no board was measured.

![Times against other programs on a logarithmic scale](benchmarks.svg)
"""


def page(results: Mapping[str, Result], versions: Mapping[str, str]) -> str:
    """Return the page in Markdown."""
    parts = [INTRODUCTION, summary(results)]
    for name, title in TITLES.items():
        # A time in itself depends on the computer: it stays on the screen of who asked for it.
        figures = [figure for figure in results[name].figures if figure.unit != "ms"]
        table = predictions(figures) if name == "cost" else comparisons(figures)
        parts.append(f"## {title}\n\n{results[name].compares.strip()}\n\n`benchmarks/{name}.py`:\n\n{table}")
    parts.append("## Versions\n\n" + "\n".join(f"- {name} {version}" for name, version in versions.items()) + "\n")
    return "\n".join(parts)


def summary(results: Mapping[str, Result]) -> str:
    """Return how many targets are met, and which are not."""
    judged = [figure for result in results.values() for figure in result.figures if figure.is_met is not None]
    missed = [figure for figure in judged if not figure.is_met]
    text = f"{len(judged) - len(missed)} of {len(judged)} targets are met."
    if missed:
        text += " Not met:\n"
    for one in missed:
        text += f"\n- {one.measure}, against {one.against}: {one.shown} instead of {one.target}"
    return text + "\n"


def comparisons(figures: Iterable[Figure]) -> str:
    """Return a table of what was compared."""
    lines = ["| measure | against | result | target | |", "| --- | --- | ---: | ---: | --- |"]
    for one in figures:
        lines.append(f"| {one.measure} | {one.against} | {one.shown} | {one.target} | {one.verdict} |")
    return "\n".join(lines) + "\n"


def predictions(figures: Iterable[Figure]) -> str:
    """Return a table of counted instructions, and what they predict for a board."""
    lines = ["| workload | instructions | target | | board: cycles | us | at most us |"]
    lines.append("| --- | ---: | ---: | --- | ---: | ---: | ---: |")
    for one in figures:
        cells = [one.measure, one.shown.removesuffix(f" {one.unit}"), one.target, one.verdict]
        if one.value is None:
            cells += [""] * 3
        else:
            likely, most = cost.cycles(one.value)
            cells += [f"{likely:.0f}", number(likely / cost.MEGAHERTZ), number(most / cost.MEGAHERTZ)]
        lines.append("| " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"
