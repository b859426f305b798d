"""Prints the citations, facts and tables of ``codegen explain``."""

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


def columns(rows: Sequence[tuple[str, ...]], *, numbers: int = 0, is_ruled: bool = False) -> list[str]:
    """Return lines with columns as wide as their widest cell, the first ``numbers`` of them to the right.

    ``is_ruled``: a line is drawn below the first row, which is the heading.
    """
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    aligned = [str.rjust] * numbers + [str.ljust] * (len(widths) - numbers)
    if is_ruled:
        rows = [rows[0], tuple("-" * width for width in widths), *rows[1:]]
    return ["  ".join(map(lambda align, *cell: align(*cell), aligned, row, widths)).rstrip() for row in rows]
