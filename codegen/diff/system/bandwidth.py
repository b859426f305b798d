"""The share of the links that telemetry takes, before and after: whole frames at the default rates of their streams."""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from codegen.diff.change import Change, changed
from codegen.diff.system.behaviour_rules import BANDWIDTH, OVERLOADED, STREAM_ORDER
from codegen.frozen import dataclass
from codegen.model.price import NOTHING, Range, capacity, message_price, price_on, sent_messages, total
from codegen.model.program import BoardLink
from codegen.model.system import System
from codegen.source import Place

_ALL = 100


@dataclass(frozen=True, slots=True)
class BandwidthRow:
    """Bytes per second of a message, or of all: None where it is not sent."""

    name: str
    old: Range | None
    new: Range | None


@dataclass(frozen=True, slots=True)
class LinkRow:
    """A serial link, its capacity in bytes per second, and the largest share of it that the telemetry takes, in %.

    ``taken`` are the bytes per second that make this share, with the signatures of a link that is signed.
    ``share_before`` is that of the old version, None where it had no such link.
    """

    name: str
    capacity: int
    taken: Range
    share: Fraction
    share_before: Fraction | None

    @property
    def is_overloaded(self) -> bool:
        """Return whether the link has to carry more than it can, and a greater share than before."""
        return self.share > _ALL and (self.share_before is None or self.share > self.share_before)


@dataclass(frozen=True, slots=True)
class Bandwidth:
    """The messages that are streamed by default in one of the versions, their sum, and the links of the new one."""

    rows: tuple[BandwidthRow, ...]
    whole: BandwidthRow
    links: tuple[LinkRow, ...]

    @property
    def growth(self) -> Fraction | None:
        """The change of the largest sum in %; None where nothing was sent before."""
        assert self.whole.old is not None
        assert self.whole.new is not None
        before, after = self.whole.old.high, self.whole.new.high
        return None if not before else (after - before) * 100 / before

    @property
    def is_changed(self) -> bool:
        """Return whether any message takes another part."""
        return any(row.old != row.new for row in self.rows)


def compare_bandwidth(old: System, new: System) -> Bandwidth:
    """Return both versions side by side."""
    before, after = _prices(old), _prices(new)
    rows = tuple(BandwidthRow(name, before.get(name), after.get(name)) for name in dict.fromkeys((*after, *before)))
    whole = BandwidthRow("all", total(before.values()), total(after.values()))
    assert whole.old is not None
    assert whole.new is not None
    known = {link.name: _share(link, old) for link in old.links}
    links = []
    for link in new.links:
        share, carried = _share(link, new), capacity(link)
        if share is not None and carried is not None:
            links.append(LinkRow(link.name, int(carried), price_on(link, new), share, known.get(link.name)))
    return Bandwidth(rows, whole, tuple(links))


def _share(link: BoardLink, system: System) -> Fraction | None:
    """Return the largest share of a link that its telemetry takes, in %; None where its capacity is not known."""
    carried = capacity(link)
    return price_on(link, system).high * _ALL / carried if carried else None


def bandwidth_changes(found: Bandwidth, new: System, old: System, threshold: Fraction) -> Iterator[Change]:
    """One for each link that carries less than is sent; one where the sum grew or fell by ``threshold`` percent."""
    places = {link.name: link.spec.place for link in new.links}
    for link in found.links:
        if link.is_overloaded:
            before = None if link.share_before is None else f"{float(link.share_before):.1f} % of it"
            said = f"{float(link.share):.1f} % of it"
            effect = f"at most {link.taken} of {link.capacity} bytes/s: frames come late, or not at all"
            where = places[link.name]
            yield changed(OVERLOADED, f"link.{link.name}", before, said, (where, where), effect, rows=(link.name,))
    growth = found.growth
    if not found.is_changed or (growth is not None and abs(growth) < threshold):
        return
    names = {row.name for row in found.rows if row.old != row.new}
    words = [f"{row.name} {row.old or 0} -> {row.new or 0}" for row in found.rows if row.old != row.new]
    shares = [f"{float(link.share):.1f} % of {link.name}" for link in found.links]
    effect = "; ".join([f"bytes/s: {', '.join(words)}", *([f"now at most {', '.join(shares)}"] if shares else [])])
    yield changed(
        BANDWIDTH,
        "bandwidth",
        f"{found.whole.old} bytes/s",
        f"{found.whole.new} bytes/s{'' if growth is None else f' ({float(growth):+.1f} %)'}",
        (_streams(old), _streams(new)),
        effect,
        messages=sorted({table.wire.name for system in (old, new) for table in system.messages if table.name in names}),
        rows=[row.name for row in found.rows if row.old != row.new],
    )


def order_changes(found: Bandwidth, old: System, new: System) -> Iterator[Change]:
    """One where streams of both versions stand in another order; a question where a link cannot carry them all."""
    before, after = ([name for name in system.streams if _is_used(name, old, new)] for system in (old, new))
    if before == after:
        return
    moved = next(name for name, known in zip(after, before, strict=True) if name != known)
    full = [link.name for link in found.links if link.share > _ALL]
    change = changed(
        STREAM_ORDER,
        "order of streams",
        ", ".join(before),
        ", ".join(after),
        (old.streams[moved].spec.place, new.streams[moved].spec.place),
        "the first ones go before the others where not all finds room",
        rows=before,
    )
    yield replace(change, doubt=f"whether {after[-1]} may be left out on {', '.join(full)}") if full else change


def _is_used(name: str, *systems: System) -> bool:
    """Return whether all of several versions have a stream, and messages that belong to it."""
    return all(
        name in system.streams and any(each.stream and each.stream.name == name for each in system.messages)
        for system in systems
    )


def _streams(system: System) -> Place:
    return next((stream.spec.place for stream in system.streams.values()), system.spec.project.place)


def _prices(system: System) -> dict[str, Range]:
    """Bytes per second of what is streamed by default, the chosen generations only."""
    prices = {message.name: message_price(message, system).whole for message in sent_messages(system)}
    return {name: price for name, price in prices.items() if price != NOTHING}
