"""The figures as a bar chart in SVG: what takes how many times as long as another program."""

import math
from collections.abc import Iterable

from figure import Figure, number

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


def chart(figures: Iterable[Figure]) -> str:
    """A bar chart in SVG: to the right of 1 how many times longer something takes than the other, to the left shorter.

    A green line is the target: a bar that ends to the left of it meets it.
    """
    by_key = {figure.key: figure for figure in figures}
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
        shown = number(time) if time >= 1 else f"1/{number(1 / time)}"
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
