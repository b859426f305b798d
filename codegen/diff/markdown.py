"""A review as Markdown, for a comment on a pull request: it can be understood without the files beside it."""

import re
from collections.abc import Iterator, Sequence

from codegen.diff.bandwidth import Bandwidth
from codegen.diff.change import Area
from codegen.diff.grouping import Group, difference, line_text, notice_text, numbers_of
from codegen.diff.review import Review, elsewhere_text, tests_text

MOST_CHARACTERS = 60_000
"""A comment on GitHub has at most 65,536."""

TITLES = {
    Area.WIRE: "Wire: ids, layout, CRC_EXTRA, enum values",
    Area.BEHAVIOUR: "Behaviour: units, sentinels, sources, rates, limits",
    Area.TRACE: "Requirements",
    Area.DOCUMENTATION: "Documentation",
}
_SPECIAL = re.compile(r"([\\`*_{}\[\]<>|#~@&])")
_CALLING = re.compile(r"([@#])(?=\w)")
"""What forges make links to people and issues of after they read the Markdown, so whatever backslash was before it."""


def review_markdown(found: Review) -> str:
    """The report; empty where nothing changed."""
    if not found.groups:
        return ""
    lines = [
        f"## Specification: {code(found.base)} → {code(found.head)}",
        "",
        f"**{found.head_line}.**",
        "",
        *_summary(found),
    ]
    for note in found.notes:
        lines += ["", f"> {plain(note)}"]
    for area in Area:
        groups = found.of_area(area)
        if groups:
            lines += ["", f"### {TITLES[area]}", "", *_section(groups, area)]
        if area is Area.BEHAVIOUR:
            for program, bandwidth in found.bandwidth:
                lines += _bandwidth(program, bandwidth)
    if found.elsewhere:
        lines += ["", elsewhere_text(found.elsewhere)]
    return _limited(lines)


def _limited(lines: Sequence[str]) -> str:
    """The lines that a comment has room for."""
    total, kept = 0, []
    for line in lines:
        total += len(line) + 1
        if total > MOST_CHARACTERS:
            kept += ["", "The rest does not fit into a comment: `codegen diff` prints all of it.", ""]
            if sum(one.startswith("<details>") for one in kept) > sum(one == "</details>" for one in kept):
                kept.append("</details>")
            break
        kept.append(line)
    return "\n".join(kept) + "\n"


def _summary(found: Review) -> Iterator[str]:
    """A line for each question that a reviewer has, answered where nothing changed, too."""
    yield "| | changes | break silently | break, noticed |"
    yield "| --- | ---: | ---: | ---: |"
    for area in Area:
        count = numbers_of(found.of_area(area))
        numbers = [str(number) if number else "none" for number in (count.changes, count.silent, count.noticed)]
        shown = [f"**{numbers[1]}**" if count.silent else numbers[1], numbers[2]]
        if area in (Area.TRACE, Area.DOCUMENTATION):
            shown = ["", ""]
        yield f"| {TITLES[area]} | {numbers[0]} | {shown[0]} | {shown[1]} |"
    for program, bandwidth in found.bandwidth:
        name = f"Bandwidth of {plain(program)}" if program else "Bandwidth"
        whole = bandwidth.whole
        words = f"{whole.old} → {whole.new} bytes/s" if bandwidth.is_changed else f"as before, {whole.new} bytes/s"
        yield f"| {name} at the default rates | {words} | | |"


def _section(groups: Sequence[Group], area: Area) -> Iterator[str]:
    if area is Area.DOCUMENTATION:
        count = sum(len(group.changes) for group in groups)
        yield f"<details><summary>{count} texts for people changed; nothing on the vehicle or the wire does.</summary>"
        yield ""
    for group in groups:
        yield from _entry(group)
    if area is Area.DOCUMENTATION:
        yield ""
        yield "</details>"


def _entry(group: Group) -> Iterator[str]:
    change = group.first
    marks = "**silent and breaking** · " if change.is_silent else "**breaking** · " if change.is_breaking else ""
    waived = "waived · " if group.waived is not None else ""
    yield f"- {waived}{marks}**{plain(group.subject)}**: {_values(group)} (`{change.rule.id}`)"
    notice = notice_text(change)
    told = [change.effect, notice, f"breaks {' and '.join(change.breaks)}" if change.breaks else ""]
    sentence = "; ".join(word for word in told if word)
    if sentence:
        yield f"  <br>{plain(sentence[0].upper() + sentence[1:])}."
    if group.waived is not None:
        yield f"  <br>Waived: {plain(group.waived)}"
    reach = group.reach
    reached = [
        plain(", ".join(reach.requirements[:8])) + (" and more" if len(reach.requirements) > 8 else ""),
        ", ".join(code(symbol) for symbol in reach.symbols[:4]) + (" and more" if len(reach.symbols) > 4 else ""),
        plain(tests_text(reach.tests)),
    ]
    words = [word for word in reached if word]
    if words:
        yield f"  <br>Reaches {'; '.join(words)}."
    before = f", before at {code(line_text(change.was_at))}" if change.was_at and change.has_moved else ""
    yield f"  <br>{code(line_text(change.place))}{before}"


def _values(group: Group) -> str:
    old, new = difference(group.first.old, group.first.new)
    if old is None:
        return f"new: {code(new)}"
    return f"gone: {code(old)}" if new is None else f"{code(old)} → {code(new)}"


def _bandwidth(program: str, bandwidth: Bandwidth) -> list[str]:
    if not bandwidth.is_changed:
        return []
    lines = [
        "",
        f"### Bandwidth{f' of {plain(program)}' if program else ''}, bytes/s at the default rates",
        "",
        "| message | before | now |",
        "| --- | ---: | ---: |",
    ]
    for row in (*bandwidth.rows, bandwidth.whole):
        name = "**all**" if row is bandwidth.whole else plain(row.name)
        if row is bandwidth.whole or row.old != row.new:
            lines.append(f"| {name} | {row.old or '0'} | {row.new or '0'} |")
    for link in bandwidth.links:
        lines += ["", f"At most {float(link.share):.1f} % of {plain(link.name)} ({link.capacity} bytes/s)."]
    return lines


def plain(text: str) -> str:
    """``text`` on one line, as text: nothing in it is markup, calls a person or ends a cell."""
    return _CALLING.sub(r"\1&#8203;", _SPECIAL.sub(r"\\\1", " ".join(text.split())))


def code(text: str | None) -> str:
    """``text`` as a code span, whatever backticks it has."""
    stated = " ".join((text or "").split())
    longest = max((len(run) for run in re.findall("`+", stated)), default=0)
    fence = "`" * (longest + 1)
    space = " " if "`" in stated[:1] + stated[-1:] else ""
    return f"{fence}{space}{stated}{space}{fence}"
