"""A Markdown text as its readers see it: passages without markup and blocks of code, each character with its place.

What is said about a text is looked for in these passages: a line end, a code span or an escape in the middle of a
statement does not hide it, and its place is still that of the source.
"""

import os
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from enum import Enum

from codegen.frozen import dataclass
from codegen.load.markdown_blocks import Block, BlockKind, Line, parse_blocks
from codegen.pattern import pattern
from codegen.source import Place

# Lengths are bounded and repetitions possessive, so that a hostile text costs no more than an honest one.
_TARGET = r"\([^()\s]{0,900}+(?:\([^()\s]{0,200}+\)[^()\s]{0,200}+)?(?:[ \t]{1,9}+\"[^\"]{0,200}+\")?\)"
_MARK = pattern(
    r"(?P<code>(?<!`)(?P<ticks>`{1,3})(?!`)(?P<inner>[^`]{1,1000}+)(?P=ticks)(?!`))"
    r"|(?P<escape>\\)[!-/:-@\[-`{-~]"
    rf"|(?P<link>!?\[(?P<label>[^\[\]]{{0,300}}+)\](?P<target>{_TARGET}))"
    r"|(?P<address><?https?://[^\s<>|)]{1,2000}+>?)"
    r"|(?P<emphasis>(?<![\w)*])\*{1,3}(?=[^\s*])|(?<=[^\s*])\*{1,3}(?![\w(*]))"
)
_DISCUSSION = pattern(r"/(?:pull|issues|commit|discussions|merge_requests)/")
_SENTENCE_END = pattern(r"[.!?;](?=\s)|\|")
_DELIMITER_ROW = pattern(r"(?=[^|]{0,99}\|)[ \t]*+\|?(?:[ \t]*+:?-++:?[ \t]*+(?:\||$))+[ \t]*")
_WINDOW = 400
"""The distance from a place within which a sentence is looked for, in characters."""


class PassageKind(Enum):
    """The kind of a passage in its document."""

    HEADING = "heading"
    TEXT = "text"
    ITEM = "item"
    ROW = "row"


@dataclass(frozen=True, slots=True)
class Passage:
    """A heading, a paragraph, an item of a list or a row of a table, on one line and without marks.

    ``anchors`` are offsets in ``text``, increasing, each with the place of its character; up to the next one the
    characters follow each other in the source, too. ``codes`` are the bounds of code spans, ``level`` is 1 to 6 for a
    heading, else 0.
    """

    kind: PassageKind
    text: str
    anchors: tuple[tuple[int, Place], ...]
    codes: tuple[tuple[int, int], ...] = ()
    level: int = 0

    @property
    def place(self) -> Place:
        """Return where it begins."""
        return self.anchors[0][1]

    @property
    def last_line(self) -> int:
        """Return the number of the line in which it ends."""
        return self.anchors[-1][1].line

    def place_at(self, offset: int) -> Place:
        """The place of the character at an offset in ``text``."""
        start, place = self.anchors[max(bisect_right(self.anchors, offset, key=lambda anchor: anchor[0]) - 1, 0)]
        return place._replace(column=place.column + offset - start)

    def sentence(self, start: int, end: int) -> tuple[int, int]:
        """The bounds of the sentence, or the cell, around a part of ``text``."""
        low, high = max(start - _WINDOW, 0), min(end + _WINDOW, len(self.text))
        ends = [found.end() for found in _SENTENCE_END.finditer(self.text, low, start)]
        following = _SENTENCE_END.search(self.text, end, high)
        return (ends[-1] if ends else low), (following.start() if following else high)


@dataclass(frozen=True, slots=True)
class CodeBlock:
    """A block of code; ``language`` is the first word after its fence, in lower case."""

    language: str
    lines: tuple[Line, ...]

    @property
    def place(self) -> Place:
        """Return where the first line of code begins."""
        return self.lines[0].place

    @property
    def last_line(self) -> int:
        """Return the number of the last line of code."""
        return self.lines[-1].place.line

    @property
    def text(self) -> str:
        """The lines in one text."""
        return "\n".join(line.text for line in self.lines)


@dataclass(frozen=True, slots=True)
class Prose:
    """A document in its order; each row of a table is a passage of its own. ``path`` is absolute."""

    path: str
    parts: tuple[Passage | CodeBlock, ...]

    @property
    def passages(self) -> Iterator[Passage]:
        """The parts that are text."""
        return (part for part in self.parts if isinstance(part, Passage))

    @property
    def code(self) -> Iterator[CodeBlock]:
        """The parts that are code."""
        return (part for part in self.parts if isinstance(part, CodeBlock))


def read_prose(text: str, path: str) -> Prose:
    """The document of a text; every text is Markdown. Places count from 1 and name the absolute form of ``path``."""
    return Prose(os.path.abspath(path), tuple(part for block in parse_blocks(text, path) for part in _parts(block)))


def _parts(block: Block) -> Iterator[Passage | CodeBlock]:
    if block.kind is BlockKind.CODE:
        yield CodeBlock(block.info.partition(" ")[0].lower(), block.lines)
        return
    kind = PassageKind.HEADING if block.kind is BlockKind.HEADING else PassageKind.TEXT
    if kind is PassageKind.TEXT and block.depth:
        kind = PassageKind.ITEM
    table = next((index for index, line in enumerate(block.lines) if _DELIMITER_ROW.fullmatch(line.text)), 0)
    lines = block.lines[: table - 1] if table else block.lines
    if lines:
        yield _passage(kind, lines, block.level)
    for line in block.lines[max(table - 1, 0) :] if table else ():
        if _DELIMITER_ROW.fullmatch(line.text) is None:
            yield _passage(PassageKind.ROW, [line])


def _passage(kind: PassageKind, lines: Sequence[Line], level: int = 0) -> Passage:
    pieces: list[str] = []
    anchors: list[tuple[int, Place]] = []
    codes: list[tuple[int, int]] = []
    length = 0
    for line in lines:
        for start, end, is_code in _kept(line.text, 0, len(line.text)):
            codes += [(length, length + end - start)] if is_code else []
            anchors.append((length, line.place._replace(column=line.place.column + start)))
            pieces.append(line.text[start:end])
            length += end - start
        pieces.append(" ")
        length += 1
    return Passage(kind, "".join(pieces).rstrip(), tuple(anchors) or ((0, lines[0].place),), tuple(codes), level)


def _kept(text: str, low: int, high: int) -> Iterator[tuple[int, int, bool]]:
    """The parts of ``text`` between two positions that readers see, and whether they are code.

    Of links to discussions nothing is seen.
    """
    seen = low
    for mark in _MARK.finditer(text, low, high):
        yield seen, mark.start(), False
        seen = mark.end()
        if mark["code"]:
            yield *mark.span("inner"), True
        elif mark["escape"]:
            seen = mark.end("escape")  # what is escaped is text, unless it begins a mark itself
            yield seen, seen + 1, False
            seen = mark.end()
        elif mark["link"] and not _DISCUSSION.search(mark["target"]):
            yield from _kept(text, *mark.span("label"))
    yield seen, high, False
