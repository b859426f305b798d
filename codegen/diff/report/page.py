"""A review as a page that opens from disk, in the look of the project's other pages."""

from collections.abc import Sequence

from codegen.diagnostics import shortened_list
from codegen.diff.change import Area, Reach, Weight
from codegen.diff.report.excerpt import difference
from codegen.diff.report.grouping import Group, consequence, line_text, notice_text, numbers_of
from codegen.diff.report.markdown import TITLES
from codegen.diff.report.review import Review, elsewhere_text, fault_findings, off_text
from codegen.diff.system.bandwidth import Bandwidth
from codegen.frozen import dataclass
from codegen.render.templates import render_page


@dataclass(frozen=True, slots=True)
class SummaryRow:
    """An area with its numbers; ``tag`` filters the table to it."""

    title: str
    changes: int
    silent: int
    noticed: int
    doubtful: int


@dataclass(frozen=True, slots=True)
class SymbolLine:
    """The symbols of one generated file."""

    file: str
    names: str


@dataclass(frozen=True, slots=True)
class ChangeRow:
    """A line of the table: what changed, from what to what, what comes of it, what it reaches, where it stands."""

    tags: str
    mark: str
    subject: str
    rule: str
    explanation: str
    old: str
    new: str
    told: tuple[str, ...]
    waived: str
    requirements: str
    more: str
    symbols: tuple[SymbolLine, ...]
    tests: tuple[str, ...]
    place: str
    was_at: str


@dataclass(frozen=True, slots=True)
class BandwidthRow:
    """A message and its bytes per second, before and now; the last row is the sum."""

    name: str
    old: str
    new: str
    is_sum: bool


@dataclass(frozen=True, slots=True)
class BandwidthTable:
    """The changes in the bandwidth of one program."""

    title: str
    rows: tuple[BandwidthRow, ...]
    shares: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class ReviewPage:
    """The page."""

    base: str
    head: str
    head_line: str
    mood: str
    notes: tuple[str, ...]
    summary: tuple[SummaryRow, ...]
    rows: tuple[ChangeRow, ...]
    bandwidth: tuple[BandwidthTable, ...]
    uncounted: tuple[str, ...]

    @property
    def has_reach(self) -> bool:
        """Return whether any change reaches something: those of dialects alone do not."""
        return any(row.requirements or row.more for row in self.rows)


def review_page(found: Review) -> str:
    """The text of the page; where nothing changed it says so."""
    changes = [change for group in found.counting for change in group.changes]
    mood = "calm"
    if found.faults or any(change.doubt or change.is_lost for change in changes):
        mood = "fired"
    if any(change.is_breaking for change in changes):
        mood = "failed" if any(change.is_silent for change in changes) else "fired"
    view = ReviewPage(
        base=found.base,
        head=found.head,
        head_line=f"{found.head_line[0].upper()}{found.head_line[1:]}.",
        mood=mood,
        notes=(*(f"{fault.place.shown()}: {fault.message}" for fault in fault_findings(found)), *found.notes),
        summary=tuple(_summary(found, area) for area in Area),
        rows=tuple(_row(each, group) for group in found.groups for each in (group, *group.following)),
        bandwidth=tuple(_table(program, each) for program, each in found.bandwidth if each.is_changed),
        uncounted=tuple(
            text(count) for text, count in ((off_text, found.off), (elsewhere_text, found.elsewhere)) if count
        ),
    )
    return render_page("pages/diff.html.j2", view)


def _summary(found: Review, area: Area) -> SummaryRow:
    count = numbers_of(found.of_area(area))
    return SummaryRow(TITLES[area], count.changes, count.silent, count.noticed + count.lost, count.doubtful)


def _row(group: Group, head: Group) -> ChangeRow:
    """A line for a group; below its ``head`` where it follows from that."""
    change = group.first
    old, new = difference(change.old, change.new)
    tags = [change.rule.area.value]
    tags += ["breaking"] if change.is_breaking or change.is_lost else []
    tags += [] if change.weight in (Weight.BREAKING, Weight.HARMLESS) else [change.weight.value]
    mark = "" if change.weight is Weight.HARMLESS else change.weight.value
    told = [_sentence(change.effect), _sentence(notice_text(change)), _sentence(consequence(change))]
    if group is not head:
        mark, told = "follows", [f"Follows from {head.subject}.", *told]
    reach = group.reach
    return ChangeRow(
        tags=" ".join(tags),
        mark="waived" if group.waived is not None else mark,
        subject=group.subject,
        rule=change.rule.id,
        explanation=change.rule.explanation,
        old=old or "",
        new=new or "",
        told=tuple(word for word in told if word),
        waived=group.waived or "",
        requirements=shortened_list(reach.requirements),
        more=_more(reach),
        symbols=_by_file(reach.symbols),
        tests=reach.tests,
        place=line_text(change.place),
        was_at=line_text(change.was_at) if change.was_at and change.has_moved else "",
    )


def _more(reach: Reach) -> str:
    """Return what the list of symbols and tests is called while it is folded."""
    told = [
        f"{len(names)} {noun}{'' if len(names) == 1 else 's'}"
        for names, noun in ((reach.symbols, "symbol"), (reach.tests, "test"))
        if names
    ]
    return ", ".join(told)


def _by_file(symbols: Sequence[str]) -> tuple[SymbolLine, ...]:
    files: dict[str, list[str]] = {}
    for symbol in symbols:
        file, _, name = symbol.partition(": ")
        files.setdefault(file, []).append(name)
    return tuple(SymbolLine(file, ", ".join(names)) for file, names in sorted(files.items()))


def _sentence(text: str) -> str:
    return f"{text[0].upper()}{text[1:]}." if text else ""


def _table(program: str, found: Bandwidth) -> BandwidthTable:
    changed = [row for row in found.rows if row.old != row.new]
    rows = [BandwidthRow(row.name, str(row.old or "0"), str(row.new or "0"), is_sum=False) for row in changed]
    rows.append(BandwidthRow("All messages", str(found.whole.old), str(found.whole.new), is_sum=True))
    shares = (f"At most {float(link.share):.1f} % of {link.name} ({link.capacity} bytes/s)." for link in found.links)
    return BandwidthTable(f"Bandwidth of {program}" if program else "Bandwidth", tuple(rows), tuple(shares))
