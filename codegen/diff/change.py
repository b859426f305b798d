"""A change between two resolved models: what was and what is, who notices, who breaks, and what it reaches."""

from collections.abc import Iterable
from enum import StrEnum

from codegen.diagnostics import Rule, Severity
from codegen.frozen import dataclass
from codegen.source import Place


class Area(StrEnum):
    """The area of a change, the gravest first."""

    WIRE = "wire"
    BEHAVIOUR = "behaviour"
    TRACE = "trace"
    DOCUMENTATION = "documentation"


class Notice(StrEnum):
    """The way in which a receiver that was built from the other version notices a change, if it does."""

    NOTICED = "noticed: CRC_EXTRA differs, the frame is dropped"
    UNKNOWN_ID = "noticed: the id is unknown, the frame is passed over"
    SILENT = "silent on the wire"
    NONE = ""


class Weight(StrEnum):
    """The weight of a change, the worst first."""

    SILENT = "silent"
    BREAKING = "breaking"
    PERSON = "person"
    HARMLESS = "harmless"

    @property
    def is_harmless(self) -> bool:
        """Return whether nobody has to do anything."""
        return self is Weight.HARMLESS

    @property
    def rank(self) -> int:
        """0 for the worst."""
        return _WEIGHTS.index(self)


_WEIGHTS = tuple(Weight)


class Victim(StrEnum):
    """The side that a change breaks."""

    OLD_STATION = "old ground station with new vehicle"
    NEW_STATION = "new ground station with old vehicle"


MOST_NAMES = 4
"""So many names of fields a sentence lists."""

BOTH = (Victim.OLD_STATION, Victim.NEW_STATION)


@dataclass(frozen=True, slots=True)
class ChangeRule(Rule):
    """A kind of change: its area, and whom it breaks and who notices unless the change itself knows better."""

    area: Area = Area.DOCUMENTATION
    notice: Notice = Notice.NONE
    breaks: tuple[Victim, ...] = ()

    @property
    def standing(self) -> str:
        """``codegen diff, wire, silent on the wire; breaks old ground station with new vehicle``."""
        notice = f", {self.notice}" if self.notice is not Notice.NONE else ""
        breaks = f"; breaks {' and '.join(self.breaks)}" if self.breaks else ""
        return f"codegen diff, {self.area}{notice}{breaks}"


@dataclass(frozen=True, slots=True)
class Reach:
    """The reach of a change: ids of requirements and criteria, symbols of the firmware, and tests that it touches."""

    requirements: tuple[str, ...] = ()
    symbols: tuple[str, ...] = ()
    tests: tuple[str, ...] = ()


NOWHERE = Reach()


def builders_first(symbols: Iterable[str]) -> tuple[str, ...]:
    """The symbols, first what puts values into messages."""
    return tuple(sorted(symbols, key=lambda symbol: (": build_" not in symbol, symbol)))


def joined(reaches: Iterable[Reach]) -> Reach:
    """Return what any of several changes, or of the rows that one concerns, touches."""
    several = tuple(reaches)
    return Reach(
        requirements=_sorted(reach.requirements for reach in several),
        symbols=builders_first(_sorted(reach.symbols for reach in several)),
        tests=_sorted(reach.tests for reach in several),
    )


def _sorted(several: Iterable[Iterable[str]]) -> tuple[str, ...]:
    return tuple(sorted({one for each in several for one in each}))


@dataclass(frozen=True, slots=True)
class Change:
    """One change. ``subject`` is what changed: MESSAGE, MESSAGE.field, ENUM.ENTRY, component.quantity, PARAMETER, id.

    ``old`` and ``new`` are values as people write them, None where there is none; ``effect`` says in a sentence what
    comes of it. ``doubt`` is what a person has to judge, where it is not known whether somebody breaks; ``breaks`` is
    empty then. ``softened`` says why nobody breaks although it looks like it. ``place`` is in the new version, or in
    the old one if it is gone there; ``was_at`` is in the old one otherwise. ``messages`` are the names of the messages
    that are concerned, of the old or the new version; ``enum`` and ``entry`` are set where the change is one of an
    enum. ``rows`` are the names by which the trace knows what is touched; ``programs`` are those that it was found in,
    by their names ("" is the project's own), empty where it concerns whatever program has these.
    """

    rule: ChangeRule
    subject: str
    old: str | None
    new: str | None
    place: Place
    was_at: Place | None = None
    notice: Notice = Notice.NONE
    breaks: tuple[Victim, ...] = ()
    effect: str = ""
    doubt: str = ""
    softened: str = ""
    causes: tuple[str, ...] = ()
    messages: tuple[str, ...] = ()
    cited: tuple[str, ...] = ()
    enum: str | None = None
    entry: str | None = None
    rows: tuple[str, ...] = ()
    programs: tuple[str, ...] = ()
    reach: Reach = NOWHERE

    @property
    def has_moved(self) -> bool:
        """Return whether it stood at another line before."""
        return self.was_at is not None and self.was_at[1:] != self.place[1:]

    @property
    def is_breaking(self) -> bool:
        """Return whether somebody breaks who was not changed as well."""
        return bool(self.breaks)

    @property
    def weight(self) -> Weight:
        """Return how bad it is."""
        if self.is_breaking:
            return Weight.SILENT if self.is_silent else Weight.BREAKING
        return Weight.PERSON if self.doubt else Weight.HARMLESS

    @property
    def is_lost(self) -> bool:
        """Return whether a requirement loses what answered to it or showed it:
        nobody breaks, and yet it is an error.
        """
        return self.rule.severity is Severity.ERROR and not self.rule.breaks and self.rule.area is Area.TRACE

    @property
    def is_silent(self) -> bool:
        """Return whether bytes are believed that mean something else: the dangerous kind."""
        return self.is_breaking and self.notice is Notice.SILENT


def changed(
    rule: ChangeRule,
    subject: str,
    old: str | None,
    new: str | None,
    places: tuple[Place | None, Place | None],
    effect: str = "",
    *,
    notice: Notice | None = None,
    breaks: tuple[Victim, ...] | None = None,
    doubt: str = "",
    causes: Iterable[str] = (),
    messages: Iterable[str] = (),
    cited: Iterable[str] = (),
    rows: Iterable[str] | None = None,
) -> Change:
    """A change with what its rule says of it; ``places`` are the old and the new one, one of them at least."""
    was_at, place = places
    found = place or was_at
    assert found is not None
    return Change(
        rule=rule,
        subject=subject,
        old=old,
        new=new,
        place=found,
        was_at=was_at if place is not None else None,
        notice=rule.notice if notice is None else notice,
        breaks=rule.breaks if breaks is None else breaks,
        effect=effect,
        doubt=doubt,
        causes=tuple(causes),
        messages=tuple(messages),
        cited=tuple(cited),
        rows=(subject,) if rows is None else tuple(rows),
    )
