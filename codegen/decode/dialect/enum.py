"""``<enum>`` and ``<entry>`` of a dialect file."""

from codegen.decode.dialect.element import LIFECYCLE, ElementReader, one_line
from codegen.diagnostics import Rule
from codegen.load.xml_tree import XmlElement
from codegen.model.dialect.dialect import CommandParameter, EnumDefinition, EnumEntry
from codegen.model.dialect.literals import entry_value

BAD_ENTRY_VALUE = Rule(
    "enum-entry-value",
    "The value of an enum entry is a decimal number without leading zeros, 0x..., 0b... or 2**n, and fits in 64 bits.",
)
EMPTY_ENUM = Rule(
    "enum-without-entries",
    "An enum without entries gives a field no value to take. Add entries or remove the enum.",
    remedy='add <entry value="0" name="..."/>, or remove the enum',
)

_ENUM_ATTRIBUTES = frozenset({"name", "bitmask"})
_ENUM_CHILDREN = frozenset({*LIFECYCLE, "description", "entry"})
_ENTRY_ATTRIBUTES = frozenset(
    {
        "name",
        "value",
        "hasLocation",
        "hasAltitudeOnly",
        "isDestination",
        "missionOnly",
        "mission",
        "fence",
        "rally",
        "command",
    }
)
_ENTRY_CHILDREN = frozenset({*LIFECYCLE, "description", "param"})


def decode_enum(element: XmlElement, read: ElementReader) -> EnumDefinition | None:
    """The enum, without the entries that cannot be read; None if it has no usable name.

    An entry without a value takes the largest value so far plus one, the first one 1, as mavgen does.
    """
    read.expect(element, _ENUM_ATTRIBUTES, _ENUM_CHILDREN)
    name = read.name(element)
    is_bitmask = read.boolean(element, "bitmask")
    entries: list[EnumEntry] = []
    highest = 0
    written = [child for child in element.children if child.tag == "entry"]
    for child in written:
        entry = _entry(child, highest + 1, read)
        if entry is not None:
            entries.append(entry)
            highest = max(highest, entry.value)
    if not written:
        read.report.add(EMPTY_ENUM, read.place(element), f"the enum {name or ''}".rstrip() + " has no entries")
    lifecycle = read.lifecycle(element)
    if name is None:
        return None
    return EnumDefinition(name, tuple(entries), is_bitmask, read.description(element), read.place(element), lifecycle)


def _entry(element: XmlElement, next_value: int, read: ElementReader) -> EnumEntry | None:
    read.expect(element, _ENTRY_ATTRIBUTES, _ENTRY_CHILDREN)
    name = read.name(element)
    lifecycle = read.lifecycle(element)
    text = element.attributes.get("value")
    value = next_value if text is None else entry_value(text)
    if value is None:
        message = f"{text!r} is not a value that an entry can have"
        read.report.add(BAD_ENTRY_VALUE, read.place(element), message, "write a number such as 4, 0x04, 0b100 or 2**2")
    if name is None or value is None:
        return None
    return EnumEntry(
        name,
        value,
        read.description(element),
        read.place(element),
        lifecycle,
        is_implicit=text is None,
        parameters=tuple(_parameter(child, read) for child in element.children if child.tag == "param"),
        traits=tuple(item for item in element.attributes.items() if item[0] not in ("name", "value")),
    )


def _parameter(element: XmlElement, read: ElementReader) -> CommandParameter:
    attributes = tuple(item for item in element.attributes.items() if item[0] != "index")
    index = element.attributes.get("index", "")
    return CommandParameter(index, attributes, one_line(element.text), read.place(element))
