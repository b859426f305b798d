"""Fields that a document quotes or defines: against the dialect, and against what it says elsewhere."""

from collections.abc import Iterator

from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Report, Rule, Severity
from codegen.model.dialect.dialect import FieldDefinition, WireField, WireMessage
from codegen.pattern import pattern
from codegen.resolve.dialect.sentinel import sentinel_of

FIELD = Rule(
    "claim-field",
    "The XML of a document quotes a field of the dialect with another type, array length, unit, enum or sentinel than "
    "the dialect has. Whoever decodes by the document decodes wrongly. Correct the quotation.",
    remedy="quote the field as the dialect has it, or correct the dialect in a corrections file",
)
TWICE = Rule(
    "claim-defined-twice",
    "A document defines a message twice with different types of the same fields. Such messages have different "
    "CRC_EXTRA, and receivers of one drop the other. Say which one holds, or give the other another name.",
    remedy="say which of the definitions holds, or give one of them another name",
)
COUNT = Rule(
    "claim-count",
    "The texts of a message in a document give two numbers of the same things, such as cells, of which only one is the "
    "length of the array. Correct the other. "
    "It is likely, not certain: the text may be about something else than the array.",
    Severity.WARNING,
    remedy="write the length of the array, or waive it if other things are counted",
)

_COUNTED = pattern(r"\b(?:more than|up to|at most|every|of|for) (\d{1,3}) ([a-z]{3,20})\b")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every message and field of the document's XML."""
    shipped = reading.reference.dialect
    for message in reading.proposed:
        known = shipped.messages.get(message.name)
        if known is not None and known.definition.place.file not in shipped.overlays:
            yield from _differences(reading, message.definition.fields, known)
        yield from _counts(reading, message)
    for field in reading.quoted.fields:
        yield from _quotation(reading, field)
    yield from _twice(reading)


def _quotation(reading: Reading, field: FieldDefinition) -> Iterator[Diagnostic]:
    """A field without its message: of the messages that the document names and that have it, one has to agree."""
    holders = [message for message in reading.named_near(field.place.line) if message.field(field.name)]
    outside = [message for message in holders if message.definition.place.file != reading.prose.path]
    found = [list(_differences(reading, (field,), message)) for message in outside]
    if found and all(found):
        yield from found[0]


def _differences(reading: Reading, fields: tuple[FieldDefinition, ...], known: WireMessage) -> Iterator[Diagnostic]:
    for quoted in fields:
        field = known.field(quoted.name)
        if field is None:
            continue
        stated = list(_stated_otherwise(quoted, field, reading))
        if stated:
            text = f"{known.name}.{field.name} {' and '.join(stated)}"
            related = [(field.definition.place, "it is defined here")]
            words = f"{known.name}.{field.name} {typed(quoted)} {quoted.invalid} {quoted.units} {quoted.enum}"
            yield reading.found(FIELD, quoted.place, words, text, None, related)


def _stated_otherwise(quoted: FieldDefinition, field: WireField, reading: Reading) -> Iterator[str]:
    """Yield the dialect's value and the written one, in words, for each attribute of the quotation that differs."""
    definition = field.definition
    if (quoted.type, quoted.length) != (definition.type, definition.length):
        yield f"is {typed(definition)}, not {typed(quoted)}"
    if quoted.units and definition.units and quoted.units != definition.units:
        yield f"is in {definition.units}, not {quoted.units}"
    if quoted.enum and definition.enum and quoted.enum != definition.enum:
        yield f"is of the enum {definition.enum}, not {quoted.enum}"
    if quoted.invalid:
        own = sentinel_of(quoted, field.type, reading.enums.get(quoted.enum or ""), quoted.place, Report())
        if own is None:
            yield f"cannot be {quoted.invalid}" + _in_words(field)
        elif field.sentinel is not None and repr(own.values) != repr(field.sentinel.values):
            yield f"is unknown when it is {field.sentinel.written}, not {quoted.invalid}"


def _in_words(field: WireField) -> str:
    """The sentinel of the dialect, by the attribute or by the text that names a value first."""
    if field.sentinel is not None:
        return f", and is unknown when it is {field.sentinel.written}"
    words = pattern(r"(?<![\w.-])(-?\d+|U?INT\d+_M(?:IN|AX)): [^.]*\bnot\b").search(field.definition.description)
    return f" (its text says {words[1]} for unknown)" if words else ""


def _twice(reading: Reading) -> Iterator[Diagnostic]:
    first: dict[str, WireMessage] = {}
    for message in reading.proposed:
        earlier = first.setdefault(message.name, message)
        if earlier is message:
            continue
        differing = [
            (field, other)
            for field in message.definition.fields
            for other in earlier.definition.fields
            if field.name == other.name and typed(field) != typed(other)
        ]
        if differing:
            told = [f"{field.name} {typed(field)} here, {typed(other)} there" for field, other in differing]
            text = f"{message.name} is defined a second time: {'; '.join(told)}"
            related = [(other.place, f"{other.name} is {typed(other)} here") for _, other in differing]
            words = f"{message.name} {'; '.join(told)}"
            yield reading.found(TWICE, differing[0][0].place, words, text, None, related)


def _counts(reading: Reading, message: WireMessage) -> Iterator[Diagnostic]:
    """Numbers of the same things in the texts of one message, where one of them is the length of an array."""
    lengths = {field.count: field for field in message.fields if field.is_array}
    texts = [(message.definition.description, message.definition.place)]
    texts += [(field.description, field.place) for field in message.definition.fields]
    counted = [(int(found[1]), found[2], place) for text, place in texts for found in _COUNTED.finditer(text)]
    for number, noun, place in counted:
        agreed = [(other, where) for other, same, where in counted if same == noun and other in lengths]
        if number in lengths or not agreed:
            continue
        length, where = agreed[0]
        text = f"{message.name}: {number} {noun} here, but {lengths[length].name} has {length}"
        related = [(where, f"{length} {noun} here")]
        yield reading.found(COUNT, place, f"{message.name} {number} {noun}", text, None, related)


def typed(field: FieldDefinition) -> str:
    """The type as XML writes it: ``uint16_t[10]``."""
    return field.type if field.length is None else f"{field.type}[{field.length}]"
