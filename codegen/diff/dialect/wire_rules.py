"""The kinds of change that a dialect can go through, each with what it means for receivers of the other version."""

from codegen.diagnostics import Severity
from codegen.diff.change import BOTH, Area, ChangeRule, Notice, Victim

WARNING = Severity.WARNING


def _wire(name: str, explanation: str, notice: Notice, *breaks: Victim) -> ChangeRule:
    severity = Severity.ERROR if breaks else WARNING
    return ChangeRule(name, explanation, severity, area=Area.WIRE, notice=notice, breaks=breaks)


def _meaning(name: str, explanation: str, *breaks: Victim) -> ChangeRule:
    """Return what the bytes mean: nothing on the wire tells."""
    severity = Severity.ERROR if breaks else WARNING
    return ChangeRule(name, explanation, severity, area=Area.BEHAVIOUR, notice=Notice.SILENT, breaks=breaks)


def _text(name: str, explanation: str) -> ChangeRule:
    return ChangeRule(name, explanation, WARNING, area=Area.DOCUMENTATION)


MESSAGE_REMOVED = _wire(
    "message-removed",
    "A message is in the dialect no more. Receivers of the old version wait for it in vain; those of the new one pass "
    "over its id.",
    Notice.UNKNOWN_ID,
    *BOTH,
)
MESSAGE_ADDED = _wire(
    "message-added",
    "A message is new in the dialect. Receivers of the old version pass over its id, unless the id was another "
    "message's.",
    Notice.UNKNOWN_ID,
)
MESSAGE_RENAMED = _wire(
    "message-renamed",
    "A message keeps its id and its fields but not its name. The name is part of CRC_EXTRA: frames of the other "
    "version are dropped.",
    Notice.NOTICED,
    *BOTH,
)
MESSAGE_ID = _wire(
    "message-id-changed",
    "A message has another id. Receivers of the other version do not know the id, or take it for another message's, "
    "which CRC_EXTRA then shows.",
    Notice.UNKNOWN_ID,
    *BOTH,
)
FIELD_REMOVED = _wire(
    "field-removed",
    "A field is gone. Of a base field CRC_EXTRA tells. Of an extension nothing tells: receivers of the old version "
    "read zeros there, and extensions behind it from the wrong bytes.",
    Notice.NOTICED,
    *BOTH,
)
FIELD_ADDED = _wire(
    "field-added",
    "A base field is new: CRC_EXTRA differs, and receivers of the other version drop the frames.",
    Notice.NOTICED,
    *BOTH,
)
EXTENSION_ADDED = _wire(
    "extension-added",
    "An extension field is new. CRC_EXTRA does not cover extensions. At the end that is how messages may grow: "
    "receivers of the old version pass over it, those of the new version read zeros from an old sender. Before "
    "other extensions it moves them, and nothing tells.",
    Notice.SILENT,
)
FIELD_RENAMED = _wire(
    "field-renamed",
    "A field keeps its type and its bytes but not its name. The names of base fields are part of CRC_EXTRA; those of "
    "extensions are not, and code that reads them by name no longer compiles.",
    Notice.NOTICED,
    *BOTH,
)
FIELD_TYPE = _wire(
    "field-type-changed",
    "A field has another type, or another number of elements. Of base fields CRC_EXTRA tells; of extensions nothing "
    "does.",
    Notice.NOTICED,
    *BOTH,
)
FIELD_ORDER = _wire(
    "field-order-changed",
    "Fields follow each other in another order on the wire. Base fields are sorted by the size of their elements, and "
    "their order is part of CRC_EXTRA; extensions go as they are written, and nothing tells of their order.",
    Notice.NOTICED,
    *BOTH,
)
BOUNDARY = _wire(
    "extension-boundary-moved",
    "A field became an extension, or an extension a base field: it moves in the payload, and CRC_EXTRA covers it no "
    "longer, or now does.",
    Notice.NOTICED,
    *BOTH,
)
CRC_EXTRA = _wire(
    "crc-extra-changed",
    "The byte that closes the checksum differs, so a receiver of the other version drops every frame of the message. "
    "It comes of the message's name and of the names, types and order of its base fields.",
    Notice.NOTICED,
    *BOTH,
)
LAYOUT = _wire(
    "payload-layout-changed",
    "Fields lie at other bytes, or the payload is longer or shorter, though the fields themselves are the same.",
    Notice.SILENT,
    *BOTH,
)
ENUM_REMOVED = _wire(
    "enum-removed",
    "An enum is gone; what its numbers meant is no longer written down.",
    Notice.SILENT,
)
ENUM_ADDED = _wire("enum-added", "An enum is new; nothing that was there before changes with it.", Notice.NONE)
ENTRY_REMOVED = _wire(
    "enum-entry-removed",
    "A value of an enum means nothing any more; who is of the old version still sends and expects it.",
    Notice.SILENT,
    Victim.NEW_STATION,
)
ENTRY_ADDED = _wire(
    "enum-entry-added",
    "An enum has one more value; receivers of the old version may meet a number that they do not know.",
    Notice.SILENT,
)
ENTRY_VALUE = _wire(
    "enum-entry-value-changed",
    "An entry has another number. Both versions read each other's number as something else, and nothing tells.",
    Notice.SILENT,
    *BOTH,
)
ENTRY_RENAMED = _wire(
    "enum-entry-renamed",
    "A number has another name. Where that is a respelling, the bytes mean the same, and only code and tables that use "
    "the old name no longer work. Where name and description are those of another thing, both versions read each "
    "other's number as that. Where neither is clear, a person has to judge.",
    Notice.SILENT,
    *BOTH,
)
DIALECT_VERSION = _wire(
    "dialect-version-changed",
    "The number of the dialect, which heartbeats carry, has changed.",
    Notice.SILENT,
)

FIELD_UNITS = _meaning(
    "field-units-changed",
    "The unit of a field has changed. The bytes look the same and are believed: a receiver of the other version is "
    "wrong by the factor between the units.",
    *BOTH,
)
FIELD_SENTINEL = _meaning(
    "field-sentinel-changed",
    "The value that means unknown has changed. A receiver of the other version takes unknown for a measurement, or a "
    "measurement for unknown.",
    *BOTH,
)
FIELD_SPECIAL = _meaning(
    "field-special-value-changed",
    "Corrections say otherwise which numbers of a field leave things as they were, or say that there is no value. "
    "What a table takes otherwise by that is told of the table.",
)
FIELD_MULTIPLIER = _meaning(
    "field-multiplier-changed",
    "The multiplier of a field has changed: a receiver of the other version is wrong by a factor.",
    *BOTH,
)
FIELD_ENUM = _meaning(
    "field-enum-changed",
    "The numbers of a field are those of another enum, or of none.",
    *BOTH,
)
FIELD_BITMASK = _meaning(
    "field-display-changed",
    "A field is a set of bits where it was a number, or the reverse: displays read it differently.",
)
FIELD_INSTANCE = _meaning(
    "field-instance-changed",
    "Another field, or none, tells apart what the messages are about: receivers of the other version mix up, or split, "
    "what belongs together.",
    *BOTH,
)
FIELD_RANGE = _meaning(
    "field-range-changed",
    "The smallest or largest value of a field has changed. Where all of it is on another scale, each number means "
    "another value; where it is narrower, who is of the other version may send what is refused.",
)
FIELD_INCREMENT = _meaning(
    "field-increment-changed",
    "The step that values of a field keep to has changed; who is of the other version may refuse what is between.",
)
FIELD_DEFAULT = _meaning(
    "field-default-changed",
    "The value that a field has where nobody sets it has changed: the bytes are the same and count as another value.",
)
FIELD_MEANING = _meaning(
    "field-meaning-changed",
    "The description of a field says the opposite of what it said, or another thing of a number that it names: the "
    "bytes are believed and mean something else. Or it may be so, and a person has to judge.",
    *BOTH,
)
MESSAGE_MEANING = _meaning(
    "message-meaning-changed",
    "The description of a message says that its fields are measured from something else: other axes, another height, "
    "another clock. Or one phrase in it is another while all else stays, and a person has to judge.",
    *BOTH,
)
ENTRY_MEANING = _meaning(
    "enum-entry-meaning-changed",
    "An entry keeps its name and its number, but its description says the opposite, or tells of something else: both "
    "versions read each other's number as another thing. Or it may be so, and a person has to judge.",
    *BOTH,
)
ENUM_BITMASK = _meaning(
    "enum-bitmask-changed",
    "The entries of an enum are bits where they were numbers, or the reverse.",
)
COMMAND_PARAMETER = _meaning(
    "command-parameter-changed",
    "A parameter of a command is new, gone, or has another meaning, unit or range. Commands carry seven numbers "
    "without names: nothing tells, and the vehicle does something else than the operator meant.",
    *BOTH,
)
ENTRY_TRAITS = _meaning(
    "enum-entry-traits-changed",
    "A command is said to have a location or a destination, or no longer: ground stations then encode and show its "
    "parameters differently.",
)
CORRECTED = _meaning(
    "corrected-attribute-changed",
    "An attribute of the dialect that a correction sets has become another one, and the correction still holds: what "
    "is sent stays as it was, although the dialect says something else than when the correction was made. A person has "
    "to judge whether it is still right.",
)

LIFECYCLE = _text(
    "lifecycle-changed",
    "A message, enum or entry became work in progress, deprecated or superseded, or is no longer.",
)
DESCRIPTION = _text(
    "description-changed",
    "The description of a message, a field, an enum, an entry or a parameter of a command says something else.",
)
PRINT_FORMAT = _text("print-format-changed", "Tools print a field in another format, such as hexadecimal.")
