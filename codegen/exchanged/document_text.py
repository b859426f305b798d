"""An imported document as Markdown, in the form of requirement documents, and read back before it is believed."""

import re
from collections.abc import Iterator
from textwrap import wrap

from codegen.decode.requirement import decode_requirement
from codegen.diagnostics import Report
from codegen.exchanged.arranged import Arranged, ArrangedCriterion
from codegen.exchanged.stated import UNREADABLE_TEXT
from codegen.exchanged.xhtml import written
from codegen.load.markdown import parse_markdown

WIDTH = 120
"""Columns of a line."""


def document_text(document: Arranged, status: str, source: str, report: Report) -> str | None:
    """The Markdown of a document; None, after findings, where it would not say what was imported.

    ``status`` is that of documents whose file states none, ``source`` the name of the file.
    """
    for width in (WIDTH, 0):  # where a line of a paragraph would begin a list, it is not broken
        text = "\n".join(_lines(document, status, source, width)) + "\n"
        found = Report()
        read = decode_requirement(parse_markdown(text, document.place.file), found)
        if read is not None and not found.has_errors:
            texts = {one.number: one.text for one in read.criteria}
            wrong = [each for each in document.criteria if texts.get(each.number) != _said(each)]
            if not wrong and (read.id, read.title, len(read.criteria)) == (
                document.id,
                document.title,
                len(document.criteria),
            ):
                return text
    messages = [each.message for each in found]
    place = wrong[0].place if read is not None and not messages and wrong else document.place
    what = messages[0] if messages else "its text reads otherwise in Markdown"
    report.add(UNREADABLE_TEXT, place, f"{document.id} cannot be written: {what}")
    return None


def file_name(document: Arranged) -> str:
    """``FR-00068-battery-status-telemetry.md``."""
    words = re.sub(r"[^a-z0-9]+", "-", document.title.lower()).strip("-")[:60].rstrip("-")
    return f"{document.id}-{words}.md" if words else f"{document.id}.md"


def _lines(document: Arranged, status: str, source: str, width: int) -> Iterator[str]:
    facts = document.facts
    yield f"# {document.id} | {written(document.title, document.title).markdown}"
    yield from ("", "## Metadata", "")
    yield f"- Status: {_plainly(facts.get('status') or status)}"
    if facts.get("aliases"):
        yield f"- Aliases: {facts['aliases']}"
    if facts.get("refers_to"):
        yield from ("", "## Links", "", f"- Refers to: {facts['refers_to']}")
    if document.criteria:
        yield from ("", "## Acceptance Criteria", "")
        before = 0
        for each in document.criteria:
            if each.number > before + 1:  # a list of its own, or pages would count on from the one before
                yield from ("", _gap(document.id, before + 1, each.number - 1), "")
            yield from _item(f"{each.number}. ", _marked(each), width)
            before = each.number
    yield from _bench(document.criteria, width)
    yield from ("", "## Source", "")
    yield from _item("- ", f"Imported from `{source}`, where it is called `{document.source}`.", width)
    for each in document.criteria:
        if each.source != f"{document.id}.{each.number}":
            yield from _item("- ", f"Criterion {each.number} is called `{each.source}` there.", width)


def _gap(document: str, first: int, last: int) -> str:
    """A comment for the numbers that no criterion has."""
    names = f"{document}.{first} is" if first == last else f"{document}.{first} to {document}.{last} are"
    return f"<!-- {names} not in the file -->"


def _bench(criteria: tuple[ArrangedCriterion, ...], width: int) -> Iterator[str]:
    """Yield what a host cannot show: criteria of which the same is said share an item."""
    said: dict[str, list[int]] = {}
    for each in criteria:
        if each.bench:
            said.setdefault(each.bench, []).append(each.number)
    if said:
        yield from ("", "## What a host cannot show", "")
    for text, numbers in said.items():
        *first, last = map(str, numbers)
        named = f"Criteria {', '.join(first)} and {last}" if first else f"Criterion {last}"
        yield from _item("- ", f"{named}: {_plainly(text)}", width)


def _item(mark: str, text: str, width: int) -> list[str]:
    """An item of a list, its further lines below its text."""
    indent = " " * len(mark)
    if not width:
        return [f"{mark}{text}"]
    return wrap(
        text,
        width,
        initial_indent=mark,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _marked(each: ArrangedCriterion) -> str:
    return each.text.markdown + _clause(each)


def _said(each: ArrangedCriterion) -> str:
    """The text as the document is read."""
    return each.text.plain + _clause(each)


def _clause(each: ArrangedCriterion) -> str:
    return f" (depends on {', '.join(each.depends_on)})" if each.depends_on else ""


def _plainly(text: str) -> str:
    return written(text, text).markdown
