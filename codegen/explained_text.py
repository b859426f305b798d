"""How ``codegen explain`` prints citations, facts and tables."""

from collections.abc import Iterable, Sequence

from codegen.model.vehicle import Citation


def cited(citation: Citation | None) -> str:
    """The criterion with its text and its place; nothing for none."""
    if citation is None:
        return ""
    text = citation.criterion.text if citation.criterion else citation.requirement.title
    place = citation.criterion.place if citation.criterion else citation.requirement.place
    return f"{citation}: {text}  ({place.shown()})"


def facts(titled: Iterable[tuple[str, str]]) -> list[str]:
    """A line for each title with a text."""
    return [f"{name:<12} {text}" for name, text in titled if text]


def columns(rows: Sequence[tuple[str, ...]]) -> list[str]:
    """Columns as wide as their widest cell."""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in rows]
