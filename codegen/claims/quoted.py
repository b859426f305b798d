"""Definitions in the XML of a document: messages, enums, and fields and entries quoted without their message."""

from collections.abc import Iterator

from codegen.decode.dialect.element import ElementReader
from codegen.decode.dialect.enum import decode_enum
from codegen.decode.dialect.message import decode_message
from codegen.diagnostics import Report
from codegen.frozen import dataclass
from codegen.load.prose import CodeBlock
from codegen.load.xml_tree import XmlElement, parse_xml
from codegen.model.dialect.dialect import EnumDefinition, FieldDefinition, MessageDefinition

_TAGS = ("<message", "<enum", "<field")
_ROOT = "<mavlink>"
_LANGUAGES = ("xml", "html", "")


@dataclass(frozen=True, slots=True)
class Quoted:
    """The definitions of one block of code, or of a document, with their places in it."""

    messages: tuple[MessageDefinition, ...] = ()
    enums: tuple[EnumDefinition, ...] = ()
    fields: tuple[FieldDefinition, ...] = ()

    def __add__(self, other: "Quoted") -> "Quoted":
        """The definitions of both, in this order."""
        return Quoted(self.messages + other.messages, self.enums + other.enums, self.fields + other.fields)


def quoted_definitions(code: CodeBlock) -> Quoted:
    """The definitions of a block; none where it is no well-formed XML, as it need not be in a document."""
    text = code.text
    if code.language not in _LANGUAGES or not any(tag in text for tag in _TAGS):
        return Quoted()
    file = code.place.file
    root = parse_xml(f"{_ROOT}\n{text}\n</mavlink>", file, Report())
    if root is None:
        return Quoted()
    placed = _placed(root, code)
    read = ElementReader(file, Report())
    messages = [decode_message(element, read) for element in _outermost(placed, "message")]
    enums = [decode_enum(element, read) for element in _outermost(placed, "enum")]
    loose = tuple(element for element in _outermost(placed, "field") if element)
    holder = XmlElement("message", {"id": "0", "name": "_"}, "", loose, 1, 1)
    held = decode_message(holder, read) if loose else None
    return Quoted(
        tuple(message for message in messages if message is not None),
        tuple(enum for enum in enums if enum is not None),
        held.fields if held else (),
    )


def _placed(element: XmlElement, code: CodeBlock) -> XmlElement:
    """``element`` with the places of the document: its first line is that of the root, which is not written there."""
    index = min(max(element.line - 2, 0), len(code.lines) - 1)
    start = code.lines[index].place
    children = tuple(_placed(child, code) for child in element.children)
    return element._replace(children=children, line=start.line, column=start.column + element.column - 1)


def _outermost(element: XmlElement, tag: str) -> Iterator[XmlElement]:
    """The elements with a tag; fields only outside of messages."""
    for child in element.children:
        if child.tag == tag:
            yield child
        elif child.tag not in ("message", "enum"):
            yield from _outermost(child, tag)
