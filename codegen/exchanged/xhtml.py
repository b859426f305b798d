"""XHTML, in which ReqIF has texts, as Markdown; what Markdown's lines of prose cannot say is a finding."""

import re
from collections.abc import Iterator

from codegen.diagnostics import Report
from codegen.exchanged.stated import UNREADABLE_TEXT, Formatted
from codegen.load.markdown_blocks import read_inline
from codegen.load.markup_style import said_otherwise
from codegen.load.xml_tree import MixedElement, place_of

_PLAIN = {"div", "p", "span", "a", "u", "ins", "big", "small", "abbr", "acronym", "cite", "dfn", "address"}
_PARAGRAPHS = {"div", "p", "br", "address"}
_MARKS = {"b": "**", "strong": "**", "i": "*", "em": "*"}
_CODE = {"code", "tt", "samp", "kbd", "var"}
_SPECIAL = re.compile(r"[\\`*_\[\]<>&!]")
_BEGINNING = re.compile(r"^(\d+)([.)])(?=\s|$)|^([-+#>=|~]|\[(?=[ xX]\]))")


def formatted(element: MixedElement, path: str, report: Report) -> Formatted | None:
    """The content of an element; None, after findings, where it holds what cannot be written as a line of prose."""
    faults = Report()
    _check_attributes(element, path, faults)
    pieces = list(_pieces(element, path, faults))
    report.extend(faults)
    if faults.has_errors:
        return None
    markdown = " ".join("".join(mark for mark, _ in pieces).split())
    return written(markdown, " ".join("".join(plain for _, plain in pieces).split()))


def written(markdown: str, plain: str) -> Formatted:
    """The text with the marks that it has, where a reader sees ``plain`` then, or else without any."""
    for form in (_begun(plain), _begun(markdown)) if markdown == plain else (_begun(markdown), _begun(plain)):
        if read_inline(form).text == plain:
            return Formatted(form, plain)
    return Formatted(_begun(_SPECIAL.sub(r"\\\g<0>", plain)), plain)


def _begun(text: str) -> str:
    """A line that begins no list, heading, quotation or box to be checked, whatever its first character."""
    return _BEGINNING.sub(lambda found: f"{found[1]}\\{found[2]}" if found[1] else f"\\{found[3]}", text, count=1)


def _pieces(element: MixedElement, path: str, report: Report) -> Iterator[tuple[str, str]]:
    """Yield what stands in an element in pieces, each as Markdown and as a reader sees it."""
    for each in element.content:
        if isinstance(each, str):
            yield each, each
            continue
        _check_attributes(each, path, report)
        inner = list(_pieces(each, path, report))
        plain = "".join(text for _, text in inner)
        if each.tag in _PARAGRAPHS:
            yield " ", " "
        if each.tag in _MARKS and plain.strip():
            mark = _MARKS[each.tag]
            text = "".join(text for text, _ in inner)
            lead, tail = text[: len(text) - len(text.lstrip())], text[len(text.rstrip()) :]
            yield f"{lead}{mark}{text.strip()}{mark}{tail}", plain
        elif each.tag in _CODE and plain.strip() and "`" not in plain:
            yield f"`{plain}`", plain
        elif each.tag in _PLAIN or each.tag in _MARKS or each.tag in _CODE or each.tag == "br":
            yield from inner
        else:
            message = f"<{each.tag}> cannot be written into a line of prose"
            report.add(UNREADABLE_TEXT, place_of(each, path), message, "put it into words there")
        if each.tag in _PARAGRAPHS:
            yield " ", " "


def _check_attributes(element: MixedElement, path: str, report: Report) -> None:
    """Refuse words that an attribute strikes, raises, hides or turns: as plain text they would say otherwise."""
    found = said_otherwise(element.attributes)
    if found is not None:
        message = f"<{element.tag}> with the {found} says something else than its plain text"
        report.add(UNREADABLE_TEXT, place_of(element, path), message, "put it into words there")
