"""The blocks of a Markdown text in reading order: headings, paragraphs and code, every line with its place.

Tables are not blocks of CommonMark: their lines are those of a paragraph, which ``markdown_table`` reads.
"""

import os
from collections.abc import Iterator, Sequence
from enum import Enum
from functools import cache, lru_cache
from typing import TYPE_CHECKING

from codegen.frozen import dataclass
from codegen.load.markup_style import attributes_of, said_otherwise
from codegen.pattern import pattern
from codegen.source import Place

if TYPE_CHECKING:
    from markdown_it import MarkdownIt
    from markdown_it.token import Token

_LINE_END = pattern(r"\r\n?|\n")
_TAG = pattern(r"(?i)<(/?(?:br|sup|sub|del|s|strike))\b")
_TAGS = {"br": " ", "sup": "^", "/sup": "", "sub": "_", "/sub": ""}
"""The text in place of a tag: without it two numbers, or one and its exponent, would be one. Others are not seen."""
_STRUCK = "~~"
"""As Markdown writes it: what is struck is not what is said."""
_MARKUP = pattern(r"[\\`*_\[\]<>&!]")
_CODE_TOKENS = ("fence", "code_block")


class BlockKind(Enum):
    """The kind of a block of lines."""

    HEADING = "heading"
    PARAGRAPH = "paragraph"
    CODE = "code"


@dataclass(frozen=True, slots=True)
class Line:
    """One line of a block, without the marks of the lists and quotes around it; ``place`` is its first character."""

    text: str
    place: Place


@dataclass(frozen=True, slots=True)
class Block:
    """A run of lines. ``level`` is 1 to 6 for a heading, else 0; ``info`` is the language of a fence.

    ``depth`` counts the lists that hold the block, 0 outside of lists; ``begins_item`` marks the first paragraph of an
    item.
    """

    kind: BlockKind
    lines: tuple[Line, ...]
    level: int = 0
    depth: int = 0
    begins_item: bool = False
    info: str = ""

    @property
    def place(self) -> Place:
        """Return where the block begins."""
        return self.lines[0].place

    @property
    def written(self) -> str:
        """The lines as they stand, in one text."""
        return "\n".join(line.text for line in self.lines)


@dataclass(frozen=True, slots=True)
class Inline:
    """Inline markup as a reader sees it: ``text`` on one line without marks, ``codes`` what stands in code spans."""

    text: str
    codes: tuple[str, ...] = ()


@cache
def parse_blocks(text: str, path: str) -> tuple[Block, ...]:
    """The blocks of a text that have lines; every text is Markdown, and of HTML blocks the tables are read.

    Places count from 1 and name the absolute form of ``path``.
    """
    return tuple(_blocks(block_tokens(text), _LINE_END.split(text), os.path.abspath(path)))


@lru_cache(maxsize=4)  # a document is read for its criteria, and then for what it says of fields
def block_tokens(text: str) -> tuple["Token", ...]:
    """The tokens of a text. Inline markup is read only where its text is wanted, by ``read_inline``."""
    return tuple(_markdown().disable("inline").parse(text))


@cache
def _inline_markdown() -> "MarkdownIt":
    return _markdown()


def _markdown() -> "MarkdownIt":
    from markdown_it import MarkdownIt  # noqa: PLC0415  most runs know what the documents say

    return MarkdownIt("commonmark")


@lru_cache(maxsize=4096)
def read_inline(written: str) -> Inline:
    """The text and the code spans of a piece of inline markup."""
    if _MARKUP.search(written) is None:
        return Inline(" ".join(written.split()))
    pieces: list[str] = []
    codes: list[str] = []
    for token in _inline_markdown().parseInline(written):
        _collect(token.children or [], pieces, codes)
    return Inline(" ".join("".join(pieces).split()), tuple(codes))


def _blocks(tokens: Sequence["Token"], lines: Sequence[str], path: str) -> Iterator[Block]:
    depth = 0
    begins_item = False
    read = 0
    for index, token in enumerate(tokens):
        if token.map is not None and token.map[0] < read:
            continue  # it is in a table of HTML with an empty line, at which Markdown ends a block of HTML
        if token.type == "html_block" and token.map is not None and "<table" in token.content.lower():
            read = _end_of_tables(lines, token.map)
            yield from _html_tables(lines, token.map[0], read, path, depth)
        elif token.type in ("bullet_list_open", "ordered_list_open", "bullet_list_close", "ordered_list_close"):
            depth += token.nesting
        elif token.type == "list_item_open":
            begins_item = True
        elif token.type in _CODE_TOKENS and token.map is not None:
            begins_item = False
            first = token.map[0] + (token.type == "fence")
            found = _located(token.content.removesuffix("\n"), first, lines, path)
            if token.content:
                yield Block(BlockKind.CODE, found, depth=depth, info=token.info.strip())
        elif token.type == "inline" and token.map is not None:
            opening = tokens[index - 1]
            found = _located(token.content, token.map[0], lines, path)
            if opening.type == "heading_open":
                yield Block(BlockKind.HEADING, found, level=int(opening.tag[1]), depth=depth)
            else:
                yield Block(BlockKind.PARAGRAPH, found, depth=depth, begins_item=begins_item)
            begins_item = False


def _end_of_tables(lines: Sequence[str], rows: Sequence[int]) -> int:
    """Return the number of the line behind tables of HTML: they go on behind an empty line until they are closed."""
    ends = (number for number in range(rows[1], len(lines) + 1) if "</table" in lines[number - 1].lower())
    return next(ends, len(lines))


def _html_tables(lines: Sequence[str], first: int, end: int, path: str, depth: int) -> Iterator[Block]:
    """The tables in some lines of HTML, as Markdown would have them."""
    from codegen.load.html_tables import tables_of  # noqa: PLC0415  few documents have any

    for rows in tables_of(lines[first:end]):
        found = tuple(Line(row.text, Place(path, first + row.line + 1, row.column + 1)) for row in rows)
        yield Block(BlockKind.PARAGRAPH, found, depth=depth)


def _located(content: str, first: int, lines: Sequence[str], path: str) -> tuple[Line, ...]:
    """The lines of a block's content, each with its place; ``first`` is the index of its first line in the file."""
    found = []
    for index, text in enumerate(content.split("\n"), first):
        raw = lines[index] if index < len(lines) else ""
        # The marks of lists and quotes stand before the text, and a heading may be closed by marks behind it.
        start = raw.rfind(text.strip()) if text.strip() else len(raw)
        indent = len(text) - len(text.lstrip()) if text.strip() else 0
        found.append(Line(text, Place(path, index + 1, max(start - indent, 0) + 1)))
    return tuple(found)


def _collect(tokens: Sequence["Token"], pieces: list[str], codes: list[str]) -> None:
    for token in tokens:
        if token.type in ("softbreak", "hardbreak"):
            pieces.append(" ")
        elif token.type == "code_inline":
            pieces.append(token.content)
            codes.append(token.content)
        elif token.type in ("text", "text_special"):
            pieces.append(token.content)
        elif token.type == "image":
            pieces.append(f"![{token.content}]")
        elif token.type == "html_inline" and (tag := _TAG.match(token.content)):
            pieces.append(_TAGS.get(tag[1].lower(), _STRUCK))
        elif token.type == "html_inline" and said_otherwise(attributes_of(token.content)) is not None:
            pieces.append(_STRUCK)
        elif token.children:
            _collect(token.children, pieces, codes)
