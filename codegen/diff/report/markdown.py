"""A review as Markdown, for a comment on a pull request: it can be understood without the files beside it."""

import re
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from codegen.diff.change import Area, Change, Weight
from codegen.diff.report.excerpt import difference
from codegen.diff.report.grouping import Group, consequence, line_text, notice_text, numbers_of
from codegen.diff.report.review import Review, elsewhere_text, off_text, tests_text
from codegen.diff.system.bandwidth import Bandwidth
from codegen.findings.comment import MOST_CHARACTERS

_TAIL = 400
_MOST_FAULTS = 40

_GRAVE: dict[str, Callable[[Change], bool]] = {
    "Breaks somebody silently": lambda change: change.weight is Weight.SILENT,
    "Breaks somebody who notices": lambda change: change.weight is Weight.BREAKING,
    "Needs a person": lambda change: change.weight is Weight.PERSON,
    "Loses what a requirement asks for": lambda change: change.is_lost,
}
"""The changes that need a word, under the titles of their sections."""

_MARKS = {
    Weight.SILENT: "**silent and breaking** · ",
    Weight.BREAKING: "**breaking** · ",
    Weight.PERSON: "**needs a person** · ",
    Weight.HARMLESS: "",
}

TITLES = {
    Area.WIRE: "Wire: ids, layout, CRC_EXTRA, enum values",
    Area.BEHAVIOUR: "Behaviour: units, sentinels, sources, rates, limits",
    Area.TRACE: "Requirements",
    Area.DOCUMENTATION: "Documentation",
}
_SPECIAL = re.compile(r"([\\`*_{}\[\]<>|#~@&])")
_CALLING = re.compile(r"([@#])(?=\w)")
"""Signs that forges turn into links to people and issues after they read the Markdown, even behind a backslash."""


def review_markdown(found: Review) -> str:
    """The report; empty where nothing changed.

    What breaks somebody stands first, and nothing of it is left out while anything harmless is shown.
    """
    if found.is_empty:
        return ""
    head = [
        f"## Specification: {code(found.base)} → {code(found.head)}",
        "",
        f"**{plain(found.head_line)}.**",
        "",
        *_summary(found),
    ]
    if found.faults:
        shown = found.faults[:_MOST_FAULTS]
        head += ["", f"> {plain(found.fault_line)}:"]
        head += [f"> - {code(fault.place.shown())}: {plain(fault.message)}" for _, fault in shown]
        head += [f"> - and {len(found.faults) - len(shown)} more"] if len(shown) < len(found.faults) else []
    for note in found.notes:
        head += ["", f"> {plain(note)}"]
    if found.off:
        head += ["", off_text(found.off)]
    if found.elsewhere:
        head += ["", elsewhere_text(found.elsewhere)]
    bandwidth = [line for program, each in found.bandwidth for line in _bandwidth(program, each)]
    return _limited(head, _sections(found), bandwidth)


class _Section(NamedTuple):
    """Groups under a title; ``is_folded`` where they are texts for people."""

    title: str
    groups: tuple[Group, ...]
    is_folded: bool = False


def _sections(found: Review) -> list[_Section]:
    """Return what breaks first, by weight; what is harmless or waived after it, by area."""
    grave = [
        _Section(title, tuple(group for group in found.counting if is_of(group.first) and not group.is_lowered))
        for title, is_of in _GRAVE.items()
    ]
    grave.append(_Section("Set to be errors", tuple(group for group in found.counting if group.is_raised)))
    told = {id(group) for section in grave for group in section.groups}
    rest = [
        _Section(
            TITLES[area],
            tuple(group for group in found.of_area(area) if id(group) not in told),
            is_folded=area is Area.DOCUMENTATION,
        )
        for area in Area
    ]
    return [section for section in (*grave, *rest) if section.groups]


def _limited(head: Sequence[str], sections: Sequence[_Section], bandwidth: Sequence[str]) -> str:
    """Return as much as a comment has room for, in the order of the sections, with a count of what is missing."""
    tables = "\n".join(bandwidth)
    room = MOST_CHARACTERS - _TAIL
    text = _cut("\n".join(head), room)
    left: list[Group] = []
    for section in sections:
        if tables and section.title not in _GRAVE and len(text) + len(tables) < room:
            text, tables = f"{text}\n{tables}", ""
        open_, close = ("", "")
        if section.is_folded:
            count = sum(len(group.changes) for group in section.groups)
            words = f"{count} texts for people changed; nothing on the vehicle or the wire does."
            open_, close = f"<details><summary>{words}</summary>\n\n", "\n\n</details>"
        opening = f"\n\n### {section.title}\n\n{open_}"
        entries: list[str] = []
        size = len(text) + len(opening) + len(close)
        for group in section.groups:
            entry = "\n".join(_entry(group))
            if left or size + len(entry) + 1 > room:
                left.append(group)
            else:
                entries.append(entry)
                size += len(entry) + 1
        if entries:
            text += opening + "\n".join(entries) + close
    if tables and len(text) + len(tables) < room:
        text = f"{text}\n{tables}"
    return f"{text}{_missing(left)}\n"


def _missing(left: Sequence[Group]) -> str:
    if not left:
        return ""
    grave = sum(
        any(is_of(group.first) for is_of in _GRAVE.values()) and group.waived is None and not group.is_lowered
        for group in left
    )
    words = f"{grave} of them among those that break or need a person" if grave else "none of which breaks anybody"
    are = "change does" if len(left) == 1 else "changes do"
    return (
        f"\n\n{len(left)} further {are} not fit into a comment, {words}: `codegen diff --format html` writes a "
        "page with all, `--format text` prints them."
    )


def _cut(text: str, room: int) -> str:
    return text if len(text) <= room else f"{text[: room - 4].rpartition(chr(10))[0]}\n..."


def _summary(found: Review) -> Iterator[str]:
    """A line for each question that a reviewer has, answered where nothing changed, too."""
    yield "| | changes | break silently | break, noticed | need a person |"
    yield "| --- | ---: | ---: | ---: | ---: |"
    for area in Area:
        count = numbers_of(found.of_area(area))
        numbers = [
            str(number) if number else "none" for number in (count.changes, count.silent, count.noticed, count.doubtful)
        ]
        shown = [f"**{numbers[1]}**" if count.silent else numbers[1], *numbers[2:]]
        if area is Area.TRACE:
            shown = ["", f"{count.lost} {'is' if count.lost == 1 else 'are'} lost" if count.lost else "", ""]
        if area is Area.DOCUMENTATION:
            shown = ["", "", ""]
        yield f"| {TITLES[area]} | {numbers[0]} | {' | '.join(shown)} |"
    for program, bandwidth in found.bandwidth:
        name = f"Bandwidth of {plain(program)}" if program else "Bandwidth"
        whole = bandwidth.whole
        words = f"{whole.old} → {whole.new} bytes/s" if bandwidth.is_changed else f"as before, {whole.new} bytes/s"
        yield f"| {name} at the default rates | {words} | | | |"


def _entry(group: Group) -> Iterator[str]:
    change = group.first
    marks = _MARKS[change.weight]
    waived = "waived · " if group.waived is not None else ""
    yield f"- {waived}{marks}**{plain(group.subject)}**: {_values(group)} (`{change.rule.id}`)"
    notice = notice_text(change)
    told = [change.effect, notice, consequence(change)]
    sentence = "; ".join(word for word in told if word)
    if sentence:
        yield f"  <br>{plain(sentence[0].upper() + sentence[1:])}."
    if group.severity is not None:
        yield f"  <br>Set to {group.severity}: {plain(group.reason)}"
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
    for other in group.following:
        yield f"  - follows: **{plain(other.subject)}**: {_values(other)} (`{other.first.rule.id}`)"


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
