"""A change as it is judged: it breaks a station, noticed or not, or a person has to say whether it does."""

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from codegen.diff.change import Change, Notice, Victim
from codegen.frozen import dataclass
from codegen.model.system import PopulatedMessage, System

Range = tuple[Fraction | int | None, Fraction | int | None]
"""The smallest and the largest value, in one unit."""

STATION = (Victim.OLD_STATION,)


@dataclass(frozen=True, slots=True)
class Sides:
    """Both versions of a program, and the fields into which the numbers of each source go, by its name."""

    old: System
    new: System
    fields: Mapping[str, tuple[str, ...]]


def table_of(system: System, name: str) -> PopulatedMessage | None:
    """Return the table of a message that is sent, by its name; None where a version has none."""
    return next((message for message in system.messages if message.name == name), None)


def breaking(change: Change, effect: str) -> Change:
    """The change: who was not changed as well hears or gets nothing any more."""
    return replace(change, effect=joined(effect, change.effect), breaks=STATION, doubt="")


def silent(change: Change, effect: str) -> Change:
    """The change: the same number is taken for something else, and nothing tells."""
    return replace(breaking(change, effect), notice=Notice.SILENT)


def doubtful(change: Change, doubt: str, effect: str = "") -> Change:
    """The change, with one question more for a person unless it breaks somebody anyway."""
    known = replace(change, effect=joined(effect, change.effect))
    return known if change.is_breaking else replace(known, doubt=", and ".join(filter(None, (change.doubt, doubt))))


def is_narrower(old: Range, new: Range) -> bool:
    """Return whether something that was within limits is not any more; None is no limit."""
    for sign, before, after in ((1, old[0], new[0]), (-1, old[1], new[1])):
        if after is not None and (before is None or sign * after > sign * before):
            return True
    return False


def joined(*texts: str) -> str:
    """Return what several texts say."""
    return "; ".join(text for text in texts if text)
