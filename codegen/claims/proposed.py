"""Messages and enums that the XML of a document proposes: what cannot work as it is written."""

from collections.abc import Iterator

from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule, Severity
from codegen.model.dialect.dialect import KnownMessage, WireMessage
from codegen.resolve.dialect.wire import MAX_PAYLOAD
from codegen.rules.overlay_text import contradicting_text

PAYLOAD = Rule(
    "claim-unsendable-message",
    "The XML of a document defines a message whose payload is longer than the 255 bytes that fit into a frame, so it "
    "can never be sent. Shorten an array, use smaller types, or divide the message.",
)
FLAG = Rule(
    "claim-flag-of-several-bits",
    "The XML of a document gives a flag of a bitmask more than one bit. Setting it sets the flags of those bits, too. "
    "A flag is a power of two.",
)
SENTINEL = Rule(
    "claim-text-contradicts-invalid",
    "In the XML of a document, the text of a field names one value for unknown, and its attribute invalid another. "
    "Generators follow the attribute, people the text. Correct the one that is wrong.",
)
TAKEN = Rule(
    "claim-id-taken",
    "The XML of a document defines a message with an id, or a name, that a dialect uses for another message. Receivers "
    "with that dialect take it for theirs. Choose a free id. "
    "It is likely, not certain: both may never meet on one link.",
    Severity.WARNING,
)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every message and enum that the document defines."""
    for message in reading.proposed:
        yield from _payload(reading, message)
        yield from _sentinels(reading, message)
        yield from _taken(reading, message)
    yield from _flags(reading)


def _payload(reading: Reading, message: WireMessage) -> Iterator[Diagnostic]:
    if message.length <= MAX_PAYLOAD:
        return
    sizes: dict[int, int] = {}
    for field in message.fields:
        sizes[field.size] = sizes.get(field.size, 0) + 1
    sum_of = " + ".join(f"{count} * {size}" if count > 1 else str(size) for size, count in sizes.items())
    text = f"{message.name} has a payload of {sum_of} = {message.length} bytes, and a frame carries {MAX_PAYLOAD}"
    place = message.definition.place
    yield reading.found(PAYLOAD, place, f"{message.name} {message.length}", text, _remedy(message))


def _remedy(message: WireMessage) -> str:
    """Return the advice for a message that is too long: the elements of its longest array that fit, or to divide it."""
    longest = max(message.fields, key=lambda field: field.size)
    room = (MAX_PAYLOAD - message.length + longest.size) // longest.type.size
    if longest.is_array and room > 0:
        return f"{longest.name} has room for {room} elements of {longest.type.size} bytes"
    return "divide the message"


def _sentinels(reading: Reading, message: WireMessage) -> Iterator[Diagnostic]:
    for field in message.fields:
        stated = contradicting_text(field)
        if stated is not None and field.sentinel is not None:
            text = f"{message.name}.{field.name}: the text says {stated}, the attribute {field.sentinel.written}"
            words = f"{message.name}.{field.name} {stated} {field.sentinel.written}"
            yield reading.found(SENTINEL, field.definition.place, words, text, "correct the text or the attribute")


def _taken(reading: Reading, message: WireMessage) -> Iterator[Diagnostic]:
    number = message.id
    if number < 0:
        return
    own = (other for other in reading.reference.dialect.messages.values())
    known = [KnownMessage(other.id, other.name, other.definition.place) for other in own]
    for other in (*known, *reading.reference.listed):
        if other.id == number and other.name != message.name:
            related = [(other.place, f"{other.name} is {other.id} here")]
            words = f"{message.name} {number}"
            text = f"{message.name} has the id {number} of {other.name}"
            yield reading.found(TAKEN, message.definition.place, words, text, "choose a free id", related)
            return


def _flags(reading: Reading) -> Iterator[Diagnostic]:
    fields = [*(field for message in reading.quoted.messages for field in message.fields), *reading.quoted.fields]
    masks = {field.enum for field in fields if field.is_bitmask}
    for enum in reading.quoted.enums:
        if not (enum.is_bitmask or enum.name in masks):
            continue
        for entry in enum.entries:
            if entry.value & (entry.value - 1):
                shared = [other for other in enum.entries if other is not entry and other.value & entry.value]
                bits = entry.value.bit_count()
                text = f"{entry.name} is 0x{entry.value:X}: {bits} bits" + (", those of others too" if shared else "")
                words = f"{entry.name} {entry.value}"
                hint = "a flag is a power of two"
                related = [(other.place, f"{other.name} has one of them") for other in shared[:1]]
                yield reading.found(FLAG, entry.place, words, text, hint, related)
