"""The page on bandwidth: what each message costs, and how much of each link that is."""

from collections.abc import Sequence
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.price import (
    Range,
    capacity,
    frame_size,
    price_at,
    price_on,
    sent_messages,
    signature_on,
    total,
)
from codegen.model.program import BoardLink
from codegen.model.spec.spec import Generation
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.summaries.generations import COUNTED, COUNTED_V1
from codegen.targets.origin import Origin
from codegen.targets.pages.bars import Amount, Chart, chart
from codegen.targets.pages.budget import Cost, beyond_version_1, costs, whole_at_default
from codegen.targets.pages.navigation import Navigation, message_path, navigation


@dataclass(frozen=True, slots=True)
class CostRow:
    """A row of the table: a message, its frame in both versions of MAVLink, its rates and what they cost."""

    stream: str
    message: str
    href: str
    frame: str
    frame_v1: str
    rate: str
    default: str
    every: str
    fastest_rate: str
    fastest: str
    is_sent: bool


@dataclass(frozen=True, slots=True)
class Total:
    """The last row of the table: the sum of what is sent, at the default rates, with every instance on, at most."""

    default: str
    every: str
    fastest: str


@dataclass(frozen=True, slots=True)
class BandwidthPage:
    """The page, ready to print. ``notes`` are sentences on what is counted."""

    project: str
    origin: Origin
    navigation: Navigation
    facts: tuple[tuple[str, str], ...]
    charts: tuple[Chart, ...]
    rows: tuple[CostRow, ...]
    total: Total
    has_idle: bool
    has_several: bool
    notes: tuple[str, ...]


def bandwidth_page(system: System, origin: Origin) -> BandwidthPage:
    """The page of a program."""
    found = costs(system)
    sent = [cost for cost in found if cost.is_sent]
    default, fastest = total(cost.default.whole for cost in sent), total(cost.fastest.whole for cost in sent)
    charts = [
        *(_link(link, carried, sent, system) for link in system.links if (carried := capacity(link)) is not None),
        chart(
            "streams",
            "By stream, at the default rates",
            "Bytes per second until a parameter or a ground station changes the rate.",
            "bytes/s",
            _streams(sent),
        ),
        chart(
            "default",
            "By message, at the default rates",
            "The same for each message.",
            "bytes/s",
            [_amount(cost, cost.default.whole, cost.rate) for cost in sent if cost.rate],
        ),
        chart(
            "fastest",
            "By message, at the fastest rates",
            "At the highest rates that parameters and ground stations can set, with what is sent on request.",
            "bytes/s",
            [_amount(cost, cost.fastest.whole, cost.fastest_rate) for cost in sent if cost.fastest_rate],
        ),
    ]
    if system.generations:
        charts.append(_generations(system))
    is_v2 = system.spec.project.protocol == 2
    return BandwidthPage(
        project=system.spec.project.project,
        origin=origin,
        navigation=navigation(system, "bandwidth.html"),
        facts=(
            ("At the default rates", f"{default} bytes/s"),
            ("At the fastest rates", f"{fastest} bytes/s"),
            *((f"Link {link.name}", _carries(link)) for link in system.links),
        ),
        charts=tuple(charts),
        rows=tuple(_row(cost) for cost in found),
        total=Total(str(default), str(total(total(cost.default.by_instance) for cost in sent)), str(fastest)),
        has_idle=any(not cost.is_sent for cost in found),
        has_several=any(not all(cost.default.is_on) for cost in found),
        notes=(COUNTED if is_v2 else COUNTED_V1, "A UART carries a tenth of its baud rate in bytes each second."),
    )


def _carries(link: BoardLink) -> str:
    carried = capacity(link)
    if carried is None:
        return f"{link.kind.words}, no limit known"
    return f"{link.kind.words}, {decimal(carried)} bytes/s"


def _link(link: BoardLink, carried: Fraction, sent: Sequence[Cost], system: System) -> Chart:
    """Return how much of a link the telemetry takes, with the signatures of one that is signed."""
    default, fastest = price_on(link, system), _fastest_on(link, sent, system)
    words = (("at the default rates", default), ("at the fastest rates", fastest))
    amounts = []
    for label, amount in words:
        share = amount.times(100 / carried)
        is_over = share.high > 100
        note = f"{amount} bytes/s{', more than the link carries' if is_over else ''}"
        amounts.append(Amount(label, share, f"{share} %", "", note, "over" if is_over else ""))
    return chart(
        f"link-{link.name}",
        f"Of what {link.name} carries",
        f"{_carries(link)} at {link.spec.baud} baud; the whole width is all that it carries"
        + (", and each frame is signed." if signature_on(link, system) else "."),
        "%",
        amounts,
        Fraction(100),
    )


def _fastest_on(link: BoardLink, sent: Sequence[Cost], system: System) -> Range:
    protocol, signature = system.spec.project.protocol, signature_on(link, system)
    return total(price_at(cost.fastest_rate, cost.message, system, protocol, signature).whole for cost in sent)


def _streams(sent: Sequence[Cost]) -> list[Amount]:
    """Return what each stream takes, with its messages."""
    by_stream: dict[str, list[Cost]] = {}
    for cost in sent:
        if cost.message.stream is not None:
            by_stream.setdefault(cost.message.stream.name, []).append(cost)
    amounts = []
    for name, members in by_stream.items():
        amount = total(cost.default.whole for cost in members)
        messages = ", ".join(cost.message.name for cost in members)
        amounts.append(Amount(name, amount, str(amount), note=f"{decimal(members[0].rate)} Hz: {messages}"))
    return amounts


def _amount(cost: Cost, amount: Range, rate: Fraction) -> Amount:
    stream = cost.message.stream.name if cost.message.stream else "on request"
    each = f", {cost.message.pages} pages" if cost.message.pages > 1 else ""
    return Amount(
        label=cost.message.name,
        amount=amount,
        value=str(amount),
        href=message_path(cost.message.name),
        note=f"{stream}, {decimal(rate)} Hz{each}",
    )


def _generations(system: System) -> Chart:
    """Return the chart of all that is streamed, with each choice and in each version of MAVLink."""
    names = " and ".join(generations.component.name for generations in system.generations)
    setters = ", ".join(generations.parameter.name for generations in system.generations if generations.parameter)
    amounts = [_choice(choice, protocol, system) for choice in Generation for protocol in (2, 1)]
    chosen = f" {setters} chooses." if setters else ""
    return chart(
        "generations",
        f"Generations of {names} messages, and versions of MAVLink",
        f"Everything that is streamed at the default rates.{chosen}",
        "bytes/s",
        amounts,
    )


def _choice(choice: Generation, protocol: int, system: System) -> Amount:
    amount = whole_at_default(system, choice, protocol)
    missing = beyond_version_1(sent_messages(system, choice)) if protocol == 1 else ()
    is_default = protocol == system.spec.project.protocol and all(
        generations.default is choice for generations in system.generations
    )
    note = f"without {', '.join(missing)}: ids above 255" if missing else "as it is shipped" if is_default else ""
    return Amount(f"{choice.value}, MAVLink {protocol}", amount, str(amount), "", note, "" if protocol == 2 else "idle")


def _row(cost: Cost) -> CostRow:
    message = cost.message
    instances = range(message.instances)
    return CostRow(
        stream=message.stream.name if message.stream else "on request",
        message=message.name,
        href=message_path(message.name),
        frame=_sizes([frame_size(message, instance, 2) for instance in instances]),
        frame_v1="" if message.wire.id > 255 else _sizes([frame_size(message, instance, 1) for instance in instances]),
        rate=decimal(cost.rate) if cost.rate else "",
        default=str(cost.default.whole) if cost.rate else "",
        every=str(total(cost.default.by_instance)) if cost.rate else "",
        fastest_rate=decimal(cost.fastest_rate) if cost.fastest_rate else "",
        fastest=str(cost.fastest.whole) if cost.fastest_rate else "",
        is_sent=cost.is_sent,
    )


def _sizes(sizes: Sequence[Range]) -> str:
    return " / ".join(dict.fromkeys(map(str, sizes)))
