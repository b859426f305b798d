"""One dialect file: its XML tree becomes definitions, in XML order and as written."""

from codegen.decode.dialect.element import ElementReader
from codegen.decode.dialect.enum import decode_enum
from codegen.decode.dialect.message import decode_message
from codegen.diagnostics import Report, Rule
from codegen.load.xml_tree import XmlElement
from codegen.model.dialect.dialect import UNNUMBERED, DialectFile, Include, MessageDefinition
from codegen.model.dialect.literals import bounded_number

NOT_A_DIALECT = Rule(
    "dialect-root",
    "The root element of a MAVLink dialect is <mavlink>. Check that the path names the intended file.",
    unreadable=True,
    remedy="give the XML of a dialect, which begins with <mavlink>",
)
BAD_VERSION = Rule(
    "dialect-version",
    "<version> and <dialect> hold one number from 0 to 255.",
)
EMPTY_INCLUDE = Rule(
    "dialect-include-empty",
    "An <include> holds the path of another dialect file, relative to the file it stands in.",
    remedy="write <include>common.xml</include>, or remove it",
)
DUPLICATE_MESSAGE = Rule(
    "message-duplicate",
    "Two messages of a file have the same id, or the same name, be it in capitals or in small letters: pages and "
    "functions are called by it. Rename or renumber one; the second is not read.",
    remedy="rename or renumber one of the two, or remove the second",
)

_ROOT_ATTRIBUTES = frozenset({"file"})
_ROOT_CHILDREN = frozenset({"include", "version", "dialect", "enums", "messages"})


def decode_dialect_file(root: XmlElement, path: str, report: Report) -> DialectFile:
    """The definitions of one file; ``path`` is absolute.

    What cannot be read is reported at its place and left out, so that the rest can still be checked. Source: MAVLink's
    XML schema, and mavgen where the schema is silent.
    """
    read = ElementReader(path, report)
    if root.tag != "mavlink":
        report.add(NOT_A_DIALECT, read.place(root), f"the root element is <{root.tag}>, not <mavlink>")
        return DialectFile(path, None, None, (), (), ())
    read.expect(root, _ROOT_ATTRIBUTES, _ROOT_CHILDREN)
    enums = [decode_enum(element, read) for element in _grouped(root, "enums", "enum", read)]
    messages = [decode_message(element, read) for element in _grouped(root, "messages", "message", read)]
    return DialectFile(
        path=path,
        version=_number(root, "version", read),
        number=_number(root, "dialect", read),
        includes=_includes(root, read),
        enums=tuple(enum for enum in enums if enum is not None),
        messages=_distinct([message for message in messages if message is not None], report),
    )


def _grouped(root: XmlElement, group: str, tag: str, read: ElementReader) -> list[XmlElement]:
    """All ``tag`` elements within the ``group`` elements below the root."""
    groups = [child for child in root.children if child.tag == group]
    for element in groups:
        read.expect(element, frozenset(), {tag})
    return [child for element in groups for child in element.children if child.tag == tag]


def _number(root: XmlElement, tag: str, read: ElementReader) -> int | None:
    """The number that ``<version>`` or ``<dialect>`` holds; the last one counts, as in mavgen."""
    number = None
    for element in root.children:
        if element.tag == tag:
            number = bounded_number(element.text, 255)
            if number is None:
                message = f"<{tag}> holds {element.text.strip()!r}"
                read.report.add(BAD_VERSION, read.place(element), message, "write a number from 0 to 255")
    return number


def _includes(root: XmlElement, read: ElementReader) -> tuple[Include, ...]:
    includes = []
    for element in root.children:
        if element.tag != "include":
            continue
        path = element.text.strip()
        if path:
            includes.append(Include(path, read.place(element)))
        else:
            read.report.add(EMPTY_INCLUDE, read.place(element), "the <include> names no file")
    return tuple(includes)


def _distinct(messages: list[MessageDefinition], report: Report) -> tuple[MessageDefinition, ...]:
    by_name: dict[str, MessageDefinition] = {}
    by_id: dict[int, MessageDefinition] = {}
    for message in messages:
        if first := by_name.get(message.name.lower()):
            problem = f"there is a second message {message.name}"
            problem += "" if first.name == message.name else f", as {first.name}"
        elif message.id != UNNUMBERED and (first := by_id.get(message.id)):
            problem = f"{message.name} has the id {message.id} of {first.name}"
        else:
            by_name[message.name.lower()] = by_id[message.id] = message
            continue
        report.add(DUPLICATE_MESSAGE, message.place, problem, related=[(first.place, "the first one")])
    return tuple(by_name.values())
