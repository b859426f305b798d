"""XML as a tree whose elements know where they stand; whatever is wrong with a file becomes a diagnostic.

Dialects and requirements come from other people: nothing outside the file is ever fetched, and a file that declares a
document type is refused before it is parsed, so that no entity is ever expanded.
"""

import codecs
import os
import re
from collections.abc import Iterator, Mapping
from contextlib import suppress
from typing import TYPE_CHECKING, NamedTuple

from codegen.diagnostics import Report, Rule
from codegen.load.files import Files
from codegen.load.text import decode_text
from codegen.pattern import pattern
from codegen.source import Place

if TYPE_CHECKING:
    from lxml import etree

XML_DOCTYPE = Rule(
    "xml-doctype",
    "What is read here needs no document type, and one can make a reader fetch other files or fill the memory. "
    "Remove the <!DOCTYPE> and write entities as plain text.",
    unreadable=True,
)
XML_ENCODING = Rule(
    "xml-encoding",
    "The XML declaration names an encoding that is not supported or that the bytes contradict. Save the file as UTF-8.",
    unreadable=True,
)
XML_SYNTAX = Rule(
    "xml-syntax",
    "The file is not well-formed XML, so nothing of it can be used. Correct the first place that is named.",
    unreadable=True,
    remedy="close or escape what stands there: &amp; for &, &lt; for <, and one element around all",
)

_ENCODINGS = frozenset({"utf-8", "ascii", "iso8859-1", "iso8859-15", "cp1252"})
_UTF16_MARKS = (codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)
_DECLARED_ENCODING = re.compile(rb"""<\?xml[^>]{0,200}?\bencoding\s*=\s*["']([A-Za-z][\w.\-]*)["']""")
# Possessive: whatever stands before the root is walked over once. libxml2 skips a second byte order mark, so this does.
_PROLOGUE = pattern(r"(?:[\s\ufeff]+|<\?.*?\?>|<!--.*?-->)*+", re.DOTALL)
# In well-formed XML a "<" outside of these three opens or closes an element.
_MARKUP = pattern(r"<(?:!--.*?-->|!\[CDATA\[.*?\]\]>|\?.*?\?>|[^/!?])", re.DOTALL)
_PLACE_IN_MESSAGE = pattern(r", line \d+, column \d+$")


class XmlElement(NamedTuple):
    """One element: its tag, attributes, own text (without that of its children) and children.

    ``line`` and ``column`` are those of its ``<``. A tuple rather than a dataclass: a dialect has thousands.
    """

    tag: str
    attributes: Mapping[str, str]
    text: str
    children: tuple["XmlElement", ...]
    line: int
    column: int


class MixedElement(NamedTuple):
    """One element with its content in the order of the file: texts, and elements between them.

    ``tag`` is without its namespace. ``line`` and ``column`` are those of its ``<``.
    """

    tag: str
    attributes: Mapping[str, str]
    content: "tuple[str | MixedElement, ...]"
    line: int
    column: int

    @property
    def children(self) -> "tuple[MixedElement, ...]":
        """The elements of the content."""
        return tuple(each for each in self.content if isinstance(each, MixedElement))


def place_of(element: XmlElement | MixedElement, path: str) -> Place:
    """The place of the ``<`` that opens ``element`` of the file ``path`` (absolute)."""
    return Place(path, element.line, element.column)


def read_xml(
    path: str, files: Files, report: Report, asked_at: Place | None = None, most: int | None = None
) -> XmlElement | None:
    """The root element of an XML file, or None after a diagnostic.

    ``asked_at`` is the place that names the file; a missing or unreadable file is reported there. Comments and
    processing instructions are left out; line ends are normalised as XML says. A file of more bytes than
    ``most`` counts as a mistake.
    """
    data = files.read_bytes(path, report, asked_at, most)
    return None if data is None else parse_xml_bytes(data, path, report)


def parse_xml_bytes(data: bytes, path: str, report: Report) -> XmlElement | None:
    """The root element of what the file ``path`` holds, or None after a diagnostic."""
    text = _decoded(data, path, report)
    return None if text is None else parse_xml(text, path, report)


def parse_xml(text: str, path: str, report: Report) -> XmlElement | None:
    """The root element of XML ``text``, or None after a diagnostic placed in ``path``."""
    text = _with_lf(text)
    root = _parsed(text, path, report)
    return None if root is None else _tree(root, text)


def read_mixed_xml(path: str, files: Files, report: Report, most: int | None = None) -> MixedElement | None:
    """Read XML like :func:`read_xml`, for files that mix texts and elements, as XHTML does."""
    data = files.read_bytes(path, report, None, most)
    text = None if data is None else _decoded(data, path, report)
    if text is None:
        return None
    text = _with_lf(text)
    root = _parsed(text, path, report)
    return None if root is None else _mixed(root, iter(_start_tags(text)))


def _with_lf(text: str) -> str:
    return text.replace("\r\n", "\n").replace("\r", "\n") if "\r" in text else text


def _parsed(text: str, path: str, report: Report) -> "etree._Element | None":
    file = os.path.abspath(path)
    prologue = _PROLOGUE.match(text)
    end = prologue.end() if prologue else 0
    if text.startswith("<!DOCTYPE", end):
        place = Place(file, text.count("\n", 0, end) + 1, end - (text.rfind("\n", 0, end) + 1) + 1)
        report.add(XML_DOCTYPE, place, "a document type is declared", "remove the <!DOCTYPE> declaration")
        return None
    if not text.strip():
        report.add(
            XML_SYNTAX, Place(file), "the file is empty", hint="name the file that is meant: this one holds nothing"
        )
        return None
    from lxml import etree  # noqa: PLC0415  most runs know what the files say

    parser = etree.XMLParser(
        encoding="utf-8",
        resolve_entities=False,
        no_network=True,
        load_dtd=False,
        huge_tree=False,
        remove_comments=True,
        remove_pis=True,
    )
    try:
        root = etree.fromstring(text.encode("utf-8", "surrogatepass"), parser)
    except etree.XMLSyntaxError as problem:
        # lxml gives the first problem; what follows it is mostly its consequence.
        line, column = problem.position
        message = _PLACE_IN_MESSAGE.sub("", problem.msg or "not well-formed XML")
        report.add(XML_SYNTAX, Place(file, max(line or 1, 1), max(column, 1)), message)
        return None
    return root


def _decoded(data: bytes, path: str, report: Report) -> str | None:
    """The text of the file in the encoding that its byte order mark or its declaration names (default: UTF-8)."""
    place = Place(os.path.abspath(path))
    if data.startswith(_UTF16_MARKS):
        encoding = "utf-16"
    else:
        declared = None if data.startswith(codecs.BOM_UTF8) else _DECLARED_ENCODING.match(data)
        encoding = declared[1].decode("ascii") if declared else "utf-8"
        with suppress(LookupError):
            encoding = codecs.lookup(encoding).name
        if encoding not in _ENCODINGS:
            report.add(XML_ENCODING, place, f"the file declares the encoding {encoding}", "save the file as UTF-8")
            return None
    if encoding == "utf-8":
        return decode_text(data, path, report)
    try:
        return data.decode(encoding)
    except UnicodeDecodeError as problem:
        before = data[: problem.start].decode(encoding, "replace")
        line, column = before.count("\n") + 1, len(before) - (before.rfind("\n") + 1) + 1
        message = f"byte 0x{data[problem.start]:02x} does not belong to the encoding {encoding}"
        report.add(XML_ENCODING, Place(place.file, line, column), message, "save the file as UTF-8")
        return None


def _tree(root: "etree._Element", text: str) -> XmlElement:
    """``root`` as located elements.

    libxml2 knows only the line where a start tag ends, and none exactly above 65535; so the places are taken from the
    text, whose start tags come in the same order as the elements.
    """
    places = iter(_start_tags(text))

    def located(element: "etree._Element") -> XmlElement:
        line, column = next(places, (element.sourceline, 1))
        own_text = element.text or ""
        children = []
        if len(element):
            for child in element:
                children.append(located(child))
                own_text += child.tail or ""
        # items() is a list and attrib an object with a life of its own, which takes longer.
        return XmlElement(str(element.tag), dict(element.items()), own_text, tuple(children), line, column)  # type: ignore[arg-type]

    return located(root)


def _mixed(element: "etree._Element", places: Iterator[tuple[int, int]]) -> MixedElement:
    """An element as a located one; ``places`` are those of the start tags from its own on."""
    line, column = next(places, (element.sourceline, 1))
    content: list[str | MixedElement] = [element.text] if element.text else []
    for child in element:
        content.append(_mixed(child, places))
        if child.tail:
            content.append(child.tail)
    return MixedElement(str(element.tag).rpartition("}")[2], dict(element.items()), tuple(content), line, column)  # type: ignore[arg-type]


def _start_tags(text: str) -> list[tuple[int, int]]:
    """Line and column of every start tag of well-formed XML, in order."""
    places = []
    line, line_start, seen = 1, 0, 0
    for markup in _MARKUP.finditer(text):
        start = markup.start()
        if text[start + 1] in "!?":
            continue
        breaks = text.count("\n", seen, start)
        if breaks:
            line += breaks
            line_start = text.rfind("\n", seen, start) + 1
        seen = start
        places.append((line, start - line_start + 1))
    return places
