"""Recognises the columns of a document's table by their headings, in any order and case."""

from collections.abc import Iterator, Mapping
from enum import Enum

from codegen.diagnostics import Diagnostic, Rule
from codegen.load.markdown_table import Cell, Row
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

COLUMN_TWICE = Rule(
    "column-twice",
    "Two columns of a table have headings of one meaning, such as Value and Source, so that nobody can tell which one "
    "holds the answer. Rename the one that does not.",
)

COLUMN_FACTOR = Rule(
    "column-factor",
    "The heading of a column of values says that the numbers below it are multiplied, such as `Value (x 10)`. What "
    "goes out cannot be told from them.",
    remedy="write the numbers as they go out, or each with its unit, and leave the factor out of the heading",
)

_ADDITION = pattern(r"\(([^)]*)\)|\[([^\]]*)\]|\bin\s+(\S+)\s*$")
_FACTOR = pattern(r"(?i)(?:[x\u00d7*/\u00f7]|\b(?:times|by))\s*\d|\d\s*[x\u00d7*]|\b1e[-+]?\d|\b10\s*\^")


class Role(Enum):
    """The role of a column: the property of a field that it states."""

    FIELD = "field"
    VALUE = "value"
    TYPE = "type"
    UNIT = "unit"
    UNKNOWN = "unknown"
    NOTES = "notes"


_HEADINGS: Mapping[Role, tuple[str, ...]] = {
    Role.FIELD: ("field", "field name", "message field", "mavlink field", "name", "member", "fields"),
    Role.VALUE: (
        *("value source", "source of value", "value", "source", "data source", "field value", "content"),
        *("populated from", "populated with", "filled from", "filled with", "comes from", "set to", "population"),
    ),
    Role.TYPE: ("type", "data type", "wire type", "field type", "mavlink type"),
    Role.UNIT: ("unit", "units", "unit on the wire", "wire unit"),
    Role.UNKNOWN: (
        *("unknown", "if unknown", "when unknown", "unknown value", "value if unknown", "sentinel", "sentinel value"),
        *("invalid", "invalid value", "not available"),
    ),
    Role.NOTES: ("notes", "note", "remark", "remarks", "comment", "comments", "description", "meaning", "rationale"),
}
"""The headings by their meaning, in small letters; of two in one table the one that comes first here counts more."""


_MESSAGE = pattern(r"[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)*(?: fields?)?")
"""A message may stand for its fields: | HEARTBEAT | Value |."""


def unit_of(heading: str) -> str:
    """Return the unit that a heading states for the numbers below it, as in "Value [A]" or "Value in A", or nothing."""
    said = _ADDITION.search(heading)
    unit = next(filter(None, said.groups()), "").strip() if said else ""
    return unit if Unit.parse(unit) is not None else ""


def column_roles(header: Row) -> tuple[dict[Role, int], tuple[Diagnostic, ...]]:
    """The index of the column for each role, and the headings that cannot be told apart.

    A more telling heading wins: "Value source" over "Value", "Field" over "Name". The name of a
    message is a heading of its fields.
    """
    named = [_plain(cell.text) for cell in header.cells]
    known = {name for headings in _HEADINGS.values() for name in headings}
    named = [
        "field" if name not in known and _MESSAGE.fullmatch(cell.text.strip()) else name
        for name, cell in zip(named, header.cells, strict=True)
    ]
    roles: dict[Role, int] = {}
    findings = []
    for role, headings in _HEADINGS.items():
        found = sorted((headings.index(name), index) for index, name in enumerate(named) if name in headings)
        if not found:
            continue
        (rank, index), others = found[0], found[1:]
        roles[role] = index
        if others and others[0][0] == rank:
            first, second = header.cells[index], header.cells[others[0][1]]
            message, hint = f"two columns are called {second.text!r}", "rename one of them"
            if role is Role.FIELD:
                hint = "make a table of each: only the first is read"
            if second.text != first.text:
                message = f"two columns, {first.text!r} and {second.text!r}, have the same meaning"
            findings.append(
                Diagnostic(second.place, COLUMN_TWICE, message, hint, ((first.place, "the first is here"),))
            )
    if Role.VALUE in roles:
        findings.extend(_multiplied(header.cells[roles[Role.VALUE]]))
    return roles, tuple(findings)


def _multiplied(heading: Cell) -> Iterator[Diagnostic]:
    said = _ADDITION.search(heading.text)
    if said is not None and not unit_of(heading.text) and _FACTOR.search(said[0]):
        yield Diagnostic(heading.place, COLUMN_FACTOR, f"{heading.text!r} leaves open what its numbers are on the wire")


def _plain(heading: str) -> str:
    """The heading in small letters, without what stands in brackets, its unit, and marks at its ends."""
    if unit_of(heading):
        heading = _ADDITION.sub(" ", heading)
    return " ".join(pattern(r"\([^)]*\)|\[[^\]]*\]").sub(" ", heading).casefold().strip(" :*?.").split())
