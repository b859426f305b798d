"""Explains corrections of fields and of parameters of commands: what is set, the grounds, and where both stand."""

from collections.abc import Iterator

from codegen.diagnostics import Report
from codegen.load.files import DISK
from codegen.model.dialect.dialect import AttributeCorrection, Dialect, Standing
from codegen.source import Place

_LONGEST = 40
"""Most lines of XML that a description takes."""


def correction_facts(dialect: Dialect, owner: str, part: str) -> list[tuple[str, str]]:
    """Title and text of what is said about corrections of a field, or of a parameter of a command; may be empty."""
    return [fact for correction in dialect.corrections_of(owner, part) for fact in _facts(correction)]


def _facts(correction: AttributeCorrection) -> Iterator[tuple[str, str]]:
    before = "nothing" if correction.before is None else repr(correction.before)
    change = f"{correction.attribute}: {correction.text or 'none'} in place of {before}  ({correction.place.shown()})"
    match correction.standing:
        case Standing.APPLIED:
            yield "corrected", change
        case Standing.REFUSED:
            assert correction.refusal is not None
            reason, place = correction.refusal
            yield "refused", change
            yield "because", f"{' '.join(reason.split())}  ({place.shown()})"
        case Standing.OUTDATED:
            yield "not used", change
            yield "because", f"the dialect no longer says {correction.grounds!r}"
            return
    if correction.stated is not None:
        yield "in words", f'"{correction.grounds}"  ({line_of(correction.grounds, correction.stated).shown()})'
    else:
        yield "reason", correction.grounds
        yield "stated in", correction.source


def line_of(words: str, element: Place) -> Place:
    """The line of the XML on which ``words`` begin that stand in the description of the element; else the element's."""
    text = DISK.read_text(element.file, Report())
    lines = [] if text is None else text.splitlines()[element.line - 1 : element.line - 1 + _LONGEST]
    for index, line in enumerate(lines):
        start = " ".join(line.split())
        found = " ".join(" ".join(lines[index:]).split()).find(words)
        if 0 <= found < len(start):
            return Place(element.file, element.line + index)
    return element
