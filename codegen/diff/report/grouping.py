"""Changes as reports show them: those that say the same about several things are one line."""

from collections.abc import Iterable, Sequence

from codegen.diagnostics import Severity, shortened_list
from codegen.diff.change import MOST_NAMES, Area, Change, Notice, Reach, Weight, joined
from codegen.diff.dialect.wire_rules import DESCRIPTION
from codegen.diff.judging.wording import is_reworded
from codegen.diff.system.behaviour_rules import TOLD
from codegen.findings.fingerprint import fingerprint
from codegen.frozen import dataclass
from codegen.source import Place

AREAS = tuple(Area)


@dataclass(frozen=True, slots=True)
class Group:
    """Changes of one rule that say the same, of one message, enum or family; ``first`` stands for all of them.

    ``waived`` says who waived them, why and until when: then they count no more. ``severity`` is one that somebody set,
    for a ``reason``. ``following`` is what comes of them and is not counted again.
    """

    changes: tuple[Change, ...]
    waived: str | None = None
    severity: Severity | None = None
    reason: str = ""
    following: tuple["Group", ...] = ()

    @property
    def first(self) -> Change:
        """The first of them."""
        return self.changes[0]

    @property
    def is_lowered(self) -> bool:
        """Return whether somebody set that it is no error."""
        return self.severity is not None and self.severity is not Severity.ERROR

    @property
    def is_raised(self) -> bool:
        """Return whether it is an error only because somebody set it."""
        change = self.first
        return self.severity is Severity.ERROR and change.weight is Weight.HARMLESS and not change.is_lost

    @property
    def subject(self) -> str:
        """``RC_CHANNELS.chan1_raw``, or ``RC_CHANNELS: chan1_raw, chan2_raw, chan3_raw and 9 more``."""
        if len(self.changes) == 1:
            return self.first.subject
        whole, dot, _ = self.first.subject.rpartition(".")
        if not dot:
            return shortened_list([change.subject for change in self.changes], MOST_NAMES)
        names = [change.subject.removeprefix(f"{whole}.") for change in self.changes]
        return f"{whole}: {shortened_list(names, MOST_NAMES)}"

    @property
    def reach(self) -> Reach:
        """Return what any of them touches, or what follows from them."""
        return joined(change.reach for group in (self, *self.following) for change in group.changes)

    @property
    def count(self) -> int:
        """Return how many changes they are: parameters of a family stand at one place and are one."""
        return len({change.place for change in self.changes})

    @property
    def fingerprint(self) -> str:
        """Return what a waiver of them names: the same in another run as long as they say the same."""
        change = self.first
        said = f"{' '.join(each.subject for each in self.changes)}: {change.old} -> {change.new}"
        return fingerprint(change.rule.id, change.place.file, said)


def grouped(changes: Iterable[Change]) -> list[Group]:
    """The groups, first what breaks somebody and nobody notices, among those of one weight by area; then as found."""
    found: dict[object, list[Change]] = {}
    for change in changes:
        found.setdefault(_key(change), []).append(change)
    return sorted((Group(tuple(each)) for each in found.values()), key=_gravity)


def _key(change: Change) -> object:
    whole, dot, _ = change.subject.rpartition(".")
    if change.rule.area is Area.TRACE:
        return change.subject, change.rule.id, change.old, change.new
    said = change.old, change.new, change.effect, change.notice, change.breaks
    where = change.place.file if dot else change.place  # parameters of a family stand at one place
    return whole, change.rule.id, *said, change.doubt, change.softened, where


def _gravity(group: Group) -> tuple[int, bool, int]:
    change = group.first
    return change.weight.rank, not change.is_lost, AREAS.index(change.rule.area)


@dataclass(frozen=True, slots=True)
class Numbers:
    """The numbers of changes: those not waived, and of these the ones that break somebody silently or noticed, that a
    person has to judge, that lose part of a requirement, and that somebody set to be errors; then the waived ones.
    """

    changes: int
    silent: int
    noticed: int
    doubtful: int
    lost: int
    raised: int
    waived: int


def numbers_of(groups: Sequence[Group]) -> Numbers:
    """The numbers that the summaries show."""
    counting = [group for group in groups if group.waived is None]
    graded = [group for group in counting if not group.is_lowered]
    return Numbers(
        changes=sum(group.count for group in counting),
        silent=sum(group.count for group in graded if group.first.is_silent),
        noticed=sum(group.count for group in graded if group.first.weight is Weight.BREAKING),
        doubtful=sum(group.count for group in graded if group.first.weight is Weight.PERSON),
        lost=sum(group.count for group in graded if group.first.is_lost),
        raised=sum(group.count for group in counting if group.is_raised),
        waived=sum(group.count for group in groups if group.waived is not None),
    )


def counted(groups: Sequence[Group]) -> str:
    """``7 changes, 2 of which break somebody silently``: the head line of every report. Waived ones are told apart."""
    found = numbers_of(groups)
    told = [
        f"{found.silent} {'breaks' if found.silent == 1 else 'break'} somebody silently" if found.silent else "",
        f"{found.noticed} {'breaks' if found.noticed == 1 else 'break'} somebody who notices" if found.noticed else "",
        f"{found.doubtful} {'needs' if found.doubtful == 1 else 'need'} a person" if found.doubtful else "",
        f"{found.lost} {'loses' if found.lost == 1 else 'lose'} what a requirement asks for" if found.lost else "",
        f"{found.raised} set to be {'an error' if found.raised == 1 else 'errors'}" if found.raised else "",
    ]
    words = [word for word in told if word]
    if not words:
        otherwise = sum(group.count for group in groups if group.waived is None and group.first.rule in TOLD)
        alters = "alters" if otherwise == 1 else "alter"
        words = [f"{otherwise} {alters} what is told"] if otherwise else ["none of them breaks anybody"]
    reworded = sum(group.count for group in groups if group.waived is None and _is_reworded(group.first))
    if reworded:
        words.append(f"{reworded} {'describes' if reworded == 1 else 'describe'} it in other words, to be read")
    if found.waived:
        words.append(f"{found.waived} waived")
    return f"{found.changes} {'change' if found.changes == 1 else 'changes'}: {', '.join(words)}"


def _is_reworded(change: Change) -> bool:
    return change.rule is DESCRIPTION and is_reworded(change.old, change.new)


def line_text(place: Place) -> str:
    """``specs/state.yaml:12``: reports name lines, as a change is one of what begins there."""
    return place.shown().rpartition(":")[0]


def notice_text(change: Change) -> str:
    """Return whether the other side notices, as reports say it; empty where nothing of it is on the wire."""
    if change.notice is Notice.SILENT and not change.is_breaking:
        return "not in CRC_EXTRA"
    return change.notice.value


def consequence(change: Change) -> str:
    """Return who breaks, what a person has to judge, or why it counts as no break;
    empty where there is none of these.
    """
    if change.breaks:
        return f"breaks {' and '.join(change.breaks)}"
    if change.doubt:
        return f"needs a person: {change.doubt}"
    return f"breaks nobody who was told: {change.softened}" if change.softened else ""
