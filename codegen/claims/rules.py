"""The rules of what documents say of messages, their fields, and the entries of enums."""

from dataclasses import replace
from functools import cache

from codegen.diagnostics import Rule, Severity

MESSAGE_ID = Rule(
    "claim-message-id",
    "A document gives a message another id than its definition has, in the dialect or in the XML of the document "
    "itself. Correct the one that is wrong.",
    remedy="write the id that the dialect has, or quote the XML in which it is another",
)
CRC_EXTRA = Rule(
    "claim-crc-extra",
    "A document gives a message another CRC_EXTRA than its name and its base fields have. Either the number is wrong, "
    "or it belongs to another layout of the message: receivers with one drop the frames of the other.",
    remedy="write the CRC_EXTRA of the dialect, or quote the XML of the other layout",
)
SIZE = Rule(
    "claim-message-size",
    "A document gives a message another size than its fields have. Meant may be the payload without or with "
    "extensions, or a whole frame of MAVLink 1 or 2, signed or not; the stated number is none of them. Correct it, and "
    "what was computed from it.",
    remedy="write one of these sizes, or quote the XML of the message that is meant",
)
ENTRY_VALUE = Rule(
    "claim-enum-value",
    "A document gives an entry of an enum another value than the dialect has. Correct it: the value is what is sent.",
    remedy="write the value that the dialect has, or quote the XML in which it is another",
)
TYPE = Rule(
    "claim-struct",
    "A struct that a document shows for a message has another type, array length or order of fields than the message, "
    "or, where it names the message by id, lacks a base field or has one too many. The order may be that of the XML or "
    "that of the wire; extensions may be left out.",
    remedy="write types, lengths and order as the message has them, or quote the XML that is meant",
)
SENTINEL = Rule(
    "claim-sentinel",
    "A document names another value for unknown than the dialect has for the field, or one that the field cannot "
    "carry. Receivers go by the dialect, and take the value for a real one. Correct it.",
    remedy="write the sentinel of the dialect, or state another one in a corrections file",
)
UNIT = Rule(
    "claim-unit",
    "A document gives a field another unit than the dialect has. Whoever follows it is wrong by a power of ten, or "
    "more. Correct it.",
    remedy="write the unit of the dialect, or correct it in a corrections file",
)
SCALING = Rule(
    "claim-scaling",
    "A document says that the number of a field is to be multiplied or divided by another factor than its unit in the "
    "dialect has. Whoever follows it is wrong by that factor. Correct it.",
    remedy="write the factor of the field's unit, or correct the unit in a corrections file",
)
RANGE = Rule(
    "claim-range",
    "A document says that the numbers of a field end where those of another type do, or where a turn ends in another "
    "unit. Whoever follows it cuts values that can be sent, or waits for some that cannot. Correct it.",
    remedy="write where its numbers end, or set minValue and maxValue in a corrections file",
)
PARAMETER = Rule(
    "claim-command-parameter",
    "A document gives a parameter of a command another number, or another unit, than the dialect has. What is sent in "
    "its place is taken for something else. Correct it.",
    remedy="write the number and the unit that the dialect has, or correct it in a corrections file",
)
EXTENSION = Rule(
    "claim-extension",
    "A document calls a base field an extension, or the other way round. Extensions come behind all other fields, do "
    "not count for CRC_EXTRA, and are not sent in MAVLink 1. Correct it.",
    remedy="call it what it is in the dialect, or quote the XML that is meant",
)
ORDER = Rule(
    "claim-wire-order",
    "A document gives another order of the fields on the wire than the message has: the largest types come first, "
    "fields of one size stay as they are, extensions come behind all others. Correct it.",
    remedy="write the order on the wire, or quote the XML that is meant",
)
OFFSET = Rule(
    "claim-offset",
    "A document gives a field another place in the payload than it has on the wire: the largest types come first, and "
    "extensions behind all others. Correct it.",
    remedy="write the byte at which it begins on the wire, or quote the XML that is meant",
)
ENUM_OF = Rule(
    "claim-enum-of-field",
    "A document says that a field has another enum than the dialect gives it, in which its numbers mean something "
    "else. Correct it.",
    remedy="write the enum of the dialect, or set another one in a corrections file",
)
SENSE = Rule(
    "claim-sense",
    "A document says that a field counts the other way than its description says, or from another level or first "
    "number: up for down, above home for above sea level. Whoever follows it takes every value for another one. "
    "Correct it. It is likely, not certain: the words may be about what somebody makes of the field.",
    Severity.WARNING,
    remedy="write it as the dialect says, or waive it if the words are about something else",
)


NO_FIELD = Rule(
    "claim-no-field",
    "A document names a field that its message does not have, and that looks like one that it has. Correct the name. "
    "It is likely, not certain: another system may have a field of that name.",
    Severity.WARNING,
    remedy="write the name as the dialect has it, or waive it if another system has this field",
)


@cache
def as_sure(rule: Rule, *, is_sure: bool) -> Rule:
    """The rule of a finding whose subject is named, or, where another one may be meant, that of a likely one."""
    return rule if is_sure else replace(rule, severity=Severity.WARNING)
