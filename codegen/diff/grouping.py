"""Changes as reports show them: those that say the same about several things are one line."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from codegen.diff.change import Area, Change, Notice

AREAS = tuple(Area)
MOST_NAMES = 4


@dataclass(frozen=True, slots=True)
class Group:
    """Changes of one rule that say the same, of one message or enum; ``first`` stands for all of them."""

    changes: tuple[Change, ...]

    @property
    def first(self) -> Change:
        """The first of them."""
        return self.changes[0]

    @property
    def subject(self) -> str:
        """``RC_CHANNELS.chan1_raw``, or ``RC_CHANNELS: chan1_raw, chan2_raw, chan3_raw and 9 more``."""
        if len(self.changes) == 1:
            return self.first.subject
        whole = self.first.subject.rpartition(".")[0]
        names = [change.subject.removeprefix(f"{whole}.") for change in self.changes]
        more = f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else ""
        return f"{whole}: {', '.join(names[:MOST_NAMES])}{more}"


def grouped(changes: Iterable[Change]) -> list[Group]:
    """The groups, the gravest area first, within it what breaks somebody and nobody notices; then as found."""
    found: dict[object, list[Change]] = {}
    for change in changes:
        found.setdefault(_key(change), []).append(change)
    return sorted((Group(tuple(each)) for each in found.values()), key=_gravity)


def _key(change: Change) -> object:
    whole, dot, _ = change.subject.rpartition(".")
    if not dot or change.rule.area is Area.TRACE:
        return change.subject, change.rule.id, change.old, change.new
    said = change.old, change.new, change.effect, change.notice, change.breaks
    return whole, change.rule.id, *said, change.place.file


def _gravity(group: Group) -> tuple[int, int]:
    change = group.first
    rank = 2
    if change.is_silent:
        rank = 0
    elif change.is_breaking:
        rank = 1
    return AREAS.index(change.rule.area), rank


def counted(changes: Sequence[Change]) -> str:
    """``7 changes: 2 break silently, 1 breaks and is noticed``: the head line of every report."""
    silent = sum(change.is_silent for change in changes)
    noticed = sum(change.is_breaking and not change.is_silent for change in changes)
    told = [
        f"{silent} {'breaks' if silent == 1 else 'break'} silently" if silent else "",
        f"{noticed} {'breaks' if noticed == 1 else 'break'} noticed" if noticed else "",
    ]
    words = [word for word in told if word] or ["none of them breaks anybody"]
    count = len(changes)
    return f"{count} {'change' if count == 1 else 'changes'}: {', '.join(words)}"


def notice_text(change: Change) -> str:
    """Whether the other side notices, as reports say it; empty where nothing of it is on the wire."""
    if change.notice is Notice.SILENT and not change.is_breaking:
        return "not in CRC_EXTRA"
    return change.notice.value
