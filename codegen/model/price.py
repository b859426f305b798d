"""The price of messages on a link: bytes of frames, and bytes per second at the default rates of their streams.

Counted are whole frames of MAVLink 2, which cuts the zeros at the end of a payload, without a signature, but for what
is said of a single link; a MAVLink 1 frame is never cut, and has no extensions. What depends on the state makes a
range, from 0 where the message may be withheld. Requests and announcements are not counted.
"""

from collections.abc import Iterable
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.program import BoardLink, LinkKind
from codegen.model.spec.spec import Generation
from codegen.model.system import Generations, PopulatedMessage, System
from codegen.model.vehicle import Component, by_instance
from codegen.once import once

HEAD_V1 = 8
HEAD_V2 = 12
"""Bytes of a frame beside its payload, with the checksum. Source: MAVLink's guide to the serialization of packets."""

SIGNATURE = 13
"""Bytes that a signature adds to a frame of MAVLink 2: the number of the link, a timestamp, and the hash."""

BITS_OF_A_BYTE = 10
"""Bits that a UART takes for a byte: a start bit, eight of data, a stop bit."""


@dataclass(frozen=True, slots=True)
class Range:
    """The smallest and the largest of what may come: bytes of a frame, or bytes per second."""

    low: Fraction
    high: Fraction

    def __add__(self, other: "Range") -> "Range":
        """The range of a sum."""
        return Range(self.low + other.low, self.high + other.high)

    def times(self, factor: Fraction) -> "Range":
        """The range of a multiple."""
        return Range(self.low * factor, self.high * factor)

    def __str__(self) -> str:
        """``96`` or ``94 to 96.5``, rounded to a tenth."""
        low, high = (f"{float(value):.1f}".removesuffix(".0") for value in (self.low, self.high))
        return low if low == high else f"{low} to {high}"


NOTHING = Range(Fraction(0), Fraction(0))


def frame_size(message: PopulatedMessage, instance: int, protocol: int) -> Range:
    """Bytes of one frame about an instance (from 0) of a message: as its table answers it, whatever the state is."""
    if protocol == 1:
        whole = Fraction(HEAD_V1 + message.wire.base_length)
        return Range(whole, whole)
    return _frame_sizes(message)[instance]


def sent_sizes(systems: Iterable[System]) -> dict[str, Range]:
    """Return by name the bytes of the frames of each message that any program sends."""
    sent: dict[str, Range] = {}
    for system in systems:
        protocol = system.spec.project.protocol
        for message in system.messages:
            sizes = [frame_size(message, instance, protocol) for instance in range(message.instances)]
            name = message.wire.name
            sizes += [sent[name]] if name in sent else []
            sent[name] = Range(min(size.low for size in sizes), max(size.high for size in sizes))
    return sent


@once
def _frame_sizes(message: PopulatedMessage) -> tuple[Range, ...]:
    """The same in MAVLink 2, about each instance."""
    return tuple(_frame_size(message, instance) for instance in range(message.instances))


def _frame_size(message: PopulatedMessage, instance: int) -> Range:
    surely, maybe = 1, 1  # a payload keeps its first byte
    for answer in message.answers:
        start = answer.covers.offset
        least, most = answer.used_bytes(*_numbers(message, instance))
        surely = max(surely, start + least if least else 0)
        maybe = max(maybe, start + most if most else 0)
    return Range(Fraction(HEAD_V2 + surely), Fraction(HEAD_V2 + max(surely, maybe)))


def _numbers(message: PopulatedMessage, instance: int) -> tuple[int, int]:
    """The least and the largest number of an instance in messages: a parameter may have that of the first one."""
    first = message.component.first_number if message.component else None
    return (instance, instance) if first is None else (instance + first.minimum, instance + first.maximum)


def on_by_default(component: Component | None, system: System) -> tuple[bool, ...]:
    """Return whether each instance of a component is measured, and so reported, by default."""
    switch = component.switch if component else None
    count = component.instances if component else 1
    if switch is None:
        return (True,) * count
    return tuple(each.default != 0 for each in by_instance(switch, system.parameters, count))


@dataclass(frozen=True, slots=True)
class Price:
    """The cost of one message in bytes per second, about each instance; ``is_on`` tells which are on by default."""

    by_instance: tuple[Range, ...]
    is_on: tuple[bool, ...]

    @property
    def whole(self) -> Range:
        """All instances that are on by default."""
        return total(each for each, is_on in zip(self.by_instance, self.is_on, strict=True) if is_on)


def total(ranges: Iterable[Range]) -> Range:
    """The sum of ranges."""
    found = NOTHING
    for each in ranges:
        found += each
    return found


def default_rate(message: PopulatedMessage) -> Fraction:
    """Return how often a message is sent, in Hz; 0 without a stream."""
    return message.stream.default_rate if message.stream else Fraction(0)


def message_price(message: PopulatedMessage, system: System) -> Price:
    """Return what a message costs while its generation is chosen."""
    return price_at(default_rate(message), message, system, system.spec.project.protocol)


def price_at(rate: Fraction, message: PopulatedMessage, system: System, protocol: int, signature: int = 0) -> Price:
    """Return what a message costs at a rate in Hz, in frames of MAVLink 1 or 2, each with so many bytes more."""
    frames, more = rate * message.pages, Range(Fraction(signature), Fraction(signature))
    found = [(frame_size(message, instance, protocol) + more).times(frames) for instance in range(message.instances)]
    if message.withheld_for:
        found = [Range(Fraction(0), each.high) for each in found]
    return Price(
        by_instance=tuple(found),
        is_on=on_by_default(message.component, system),
    )


def sent_messages(system: System, choice: Generation | None = None) -> tuple[PopulatedMessage, ...]:
    """The messages that are streamed with a choice of generations, or with the default of each."""
    left_out = {
        name
        for generations in system.generations
        for name in (*generations.old, *generations.new)
        if name not in generations.names(choice or generations.default)
    }
    return tuple(message for message in system.messages if message.name not in left_out)


def chosen(generations: Generations, choice: Generation, system: System) -> tuple[PopulatedMessage, ...]:
    """The messages that are sent with a choice, in the order in which they are listed."""
    messages = {message.name: message for message in system.messages}
    return tuple(messages[name] for name in generations.names(choice) if name in messages)


def price(generations: Generations, choice: Generation, system: System) -> Range:
    """Bytes per second of all messages that are streamed with a choice."""
    return total(message_price(message, system).whole for message in chosen(generations, choice, system))


def signature_on(link: BoardLink, system: System) -> int:
    """Return how many bytes the signature adds to each frame on a link."""
    access = system.program.access if system.program else None
    return SIGNATURE if access is not None and link.name in access.signed else 0


def price_on(link: BoardLink, system: System) -> Range:
    """Bytes per second of all messages that are streamed by default, as a link carries them."""
    protocol, signature = system.spec.project.protocol, signature_on(link, system)
    return total(
        price_at(default_rate(message), message, system, protocol, signature).whole for message in sent_messages(system)
    )


def capacity(link: BoardLink) -> Fraction | None:
    """Bytes per second that a link carries each way; None where none is known: over Wi-Fi, USB."""
    if link.kind is LinkKind.UART and link.spec.baud is not None:
        return Fraction(link.spec.baud, BITS_OF_A_BYTE)
    return None
