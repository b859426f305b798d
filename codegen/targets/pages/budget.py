"""The cost of telemetry: bytes per second of every message, and of all together, beside the capacity of links."""

from collections.abc import Iterable
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.price import Price, Range, default_rate, price_at, sent_messages, total
from codegen.model.spec.spec import Generation
from codegen.model.system import PopulatedMessage, System


@dataclass(frozen=True, slots=True)
class Cost:
    """One message: rates in Hz, and what it costs at them; ``is_sent`` is false for a generation not chosen."""

    message: PopulatedMessage
    rate: Fraction
    fastest_rate: Fraction
    default: Price
    fastest: Price
    is_sent: bool


def costs(system: System) -> tuple[Cost, ...]:
    """Every message, in the order of streams.yaml; those on request come last."""
    order = {name: index for index, name in enumerate(system.streams)}
    messages = sorted(system.messages, key=lambda message: order[message.stream.name] if message.stream else len(order))
    sent = {message.name for message in sent_messages(system)}
    return tuple(_cost(message, system, is_sent=message.name in sent) for message in messages)


def _cost(message: PopulatedMessage, system: System, *, is_sent: bool) -> Cost:
    protocol = system.spec.project.protocol
    rate, fastest = default_rate(message), fastest_rate(message, system)
    return Cost(
        message=message,
        rate=rate,
        fastest_rate=fastest,
        default=price_at(rate, message, system, protocol),
        fastest=price_at(fastest, message, system, protocol),
        is_sent=is_sent,
    )


def fastest_rate(message: PopulatedMessage, system: System) -> Fraction:
    """The highest rate in Hz that a parameter or a ground station can set."""
    if message.stream is not None:
        return message.stream.fastest
    return system.program.fastest if system.program else Fraction(0)


def whole_at_default(system: System, choice: Generation | None = None, protocol: int | None = None) -> Range:
    """Bytes per second of everything that is streamed; what MAVLink 1 has no room for in its id is left out of it."""
    version = protocol or system.spec.project.protocol
    return total(
        price_at(default_rate(message), message, system, version).whole
        for message in sent_messages(system, choice)
        if version == 2 or message.wire.id <= 255
    )


def beyond_version_1(messages: Iterable[PopulatedMessage]) -> tuple[str, ...]:
    """The names of streamed messages whose id does not fit the one byte that MAVLink 1 has for it."""
    return tuple(message.name for message in messages if message.stream and message.wire.id > 255)
