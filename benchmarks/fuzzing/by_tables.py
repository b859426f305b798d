"""Faults of Markdown: tables, headings, numbers of criteria, code, and marks that somebody has to pair."""

import random
import re

from fuzzing.by_bytes import by_bytes
from fuzzing.hostile import AMOUNTS, EVERYTHING, NAMES, NUMBERS, TEXTS

_NUMBER = re.compile(r"\d+(?:\.\d+)?")
_MARKS = (
    "|",
    "`",
    "```",
    "~~~",
    "*",
    "_",
    "[",
    "](",
    "<",
    ">",
    "#",
    "- ",
    "1. ",
    "\\",
    "&",
    "|---|",
    "<!--",
    "$$",
    "    ",
    "\t",
)

_LONG = 1000
"""Characters of what is not written thousands of times: faults of one file follow each other, up to eight of them."""


def by_tables(data: bytes, lot: random.Random) -> bytes:
    """Return the file with one fault."""
    try:
        text = data.decode()
    except UnicodeDecodeError:
        return by_bytes(data, lot)
    kinds = (_cell, _cell, _cells, _row, _number, _number, _heading, _marks, _deep, _wide, _criterion, _word)
    return lot.choice(kinds)(text, lot).encode("utf-8", "surrogatepass")


def _rows(lines: list[str]) -> list[int]:
    return [index for index, line in enumerate(lines) if line.count("|") > 1]


def _drawn_row(lines: list[str], lot: random.Random) -> int:
    return lot.choice(_rows(lines) or range(len(lines)))


def _cell(text: str, lot: random.Random) -> str:
    """Put something else into a cell."""
    lines = text.split("\n")
    at = _drawn_row(lines, lot)
    cells = lines[at].split("|")
    other = lot.choice(lines[_drawn_row(lines, lot)].split("|"))
    cells[lot.randrange(len(cells))] = f" {lot.choice((lot.choice(EVERYTHING), lot.choice(AMOUNTS), other))} "
    lines[at] = "|".join(cells)
    return "\n".join(lines)


def _cells(text: str, lot: random.Random) -> str:
    """Add cells to a row, or leave some out."""
    lines = text.split("\n")
    at = _drawn_row(lines, lot)
    cells = lines[at].split("|")
    place = lot.randrange(len(cells))
    cell = lot.choice(cells)
    cells[place : place + lot.randrange(3)] = [cell] * lot.choice((0, 1, 3, 2000 if len(cell) < _LONG else 2))
    lines[at] = "|".join(cells)
    return "\n".join(lines)


def _row(text: str, lot: random.Random) -> str:
    """Leave a row out, write it again, once or thousands of times, or break the line below the head."""
    lines = text.split("\n")
    at = _drawn_row(lines, lot)
    new = (
        [],
        [lines[at]] * 2,
        [lines[at]] * (5000 if len(lines[at]) < _LONG else 3),
        [re.sub(r"-+", lot.choice(("", ":", "- -", "=")), lines[at])],
        [f"> {lines[at]}"],
    )
    lines[at : at + 1] = lot.choice(new)
    return "\n".join(lines)


def _number(text: str, lot: random.Random) -> str:
    spans = [found.span() for found in _NUMBER.finditer(text)]
    if not spans:
        return _marks(text, lot)
    start, end = lot.choice(spans)
    return text[:start] + lot.choice((*NUMBERS, "-" + text[start:end], text[start:end] + "0", "9" * 5000)) + text[end:]


def _heading(text: str, lot: random.Random) -> str:
    lines = text.split("\n")
    places = [index for index, line in enumerate(lines) if line.startswith("#")] or [0]
    at = lot.choice(places)
    other = lines[lot.choice(places)]
    lines[at : at + 1] = lot.choice(
        ([], [lines[at], lines[at]], [other], ["#" + lines[at]], [lines[at].lstrip("# ")], ["# " + lot.choice(NAMES)])
    )
    return "\n".join(lines)


def _marks(text: str, lot: random.Random) -> str:
    """Write marks that nothing closes, a few or thousands."""
    at = lot.choice((0, len(text), lot.randrange(len(text) + 1)))
    return text[:at] + lot.choice(_MARKS) * lot.choice((1, 1, 2, 60, 3000)) + text[at:]


def _deep(text: str, lot: random.Random) -> str:
    """Write a list, or a quotation, that is nested deeply."""
    deep = lot.choice((5, 90, 400))
    kind = lot.randrange(3)
    if kind == 0:
        return text + "\n" + ">" * deep + " x | y\n" + ">" * deep + " --- | ---\n"
    if kind == 1:
        return text + "\n" + "".join(f"{'  ' * level}- x\n" for level in range(deep))
    return text + "\n" + "- " * deep + "x\n"


def _wide(text: str, lot: random.Random) -> str:
    """Add a table with very many columns, or with very long cells."""
    columns, cell = lot.choice(((3000, "x"), (3, "x" * 100_000), (40, "`0x" + "f" * 500 + "`"), (5, "1" * 3000)))
    row = f"|{cell}" * columns + "|\n"
    return text + "\n\n" + row + "|---" * columns + "|\n" + row * 3


def _criterion(text: str, lot: random.Random) -> str:
    """Give a criterion another number."""
    spans = [found.span(1) for found in re.finditer(r"(?m)^(\d+)\. ", text)]
    if not spans:
        return _heading(text, lot)
    start, end = lot.choice(spans)
    return (
        text[:start]
        + lot.choice(("0", "1", "-1", "999999999", "9" * 50, "1.1", "a", "01", text[start:end] * 2))
        + text[end:]
    )


def _word(text: str, lot: random.Random) -> str:
    """Put something else in place of a word."""
    spans = [found.span() for found in re.finditer(r"\S+", text)]
    if not spans:
        return lot.choice(TEXTS)
    start, end = lot.choice(spans)
    other = lot.choice(spans)
    return text[:start] + lot.choice((text[slice(*other)], lot.choice(EVERYTHING))) + text[end:]
