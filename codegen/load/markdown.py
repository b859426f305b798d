"""Markdown as headings, sections and list items that know their lines (CommonMark, read by markdown-it)."""

import os
from functools import cache
from itertools import pairwise
from typing import TYPE_CHECKING

from codegen.frozen import dataclass
from codegen.load.markdown_blocks import block_tokens, read_inline
from codegen.pattern import pattern
from codegen.source import Place

if TYPE_CHECKING:
    from markdown_it.token import Token

_LINE_END = pattern(r"\r\n?|\n")
_CHECK_BOX = pattern(r"^\[[ xX]\]\s+")


@dataclass(frozen=True, slots=True)
class Item:
    """One item of a list. ``number`` is as written (None for a bullet), ``depth`` 0 for the outermost list.

    ``text`` is plain: without markup, and without the check box that may lead it; items of lists inside are not in it.
    """

    text: str
    number: int | None
    depth: int
    place: Place


@dataclass(frozen=True, slots=True)
class Section:
    """A heading of level 1 or 2 with the list items below it, those below deeper headings included."""

    title: str
    level: int
    place: Place
    items: tuple[Item, ...]


@dataclass(frozen=True, slots=True)
class Document:
    """One Markdown file; what stands before the first heading is not in it."""

    path: str
    sections: tuple[Section, ...]


@cache
def parse_markdown(text: str, path: str) -> Document:
    """The document of a text; every text is Markdown. Places count from 1 and name the absolute form of ``path``.

    Kept for the further programs of a project, which read the documents of their base again.
    """
    return _Reader(text, os.path.abspath(path)).document()


class _Reader:
    """Walks over the tokens once."""

    def __init__(self, text: str, path: str) -> None:
        self._path = path
        self._lines = _LINE_END.split(text)
        self._tokens = block_tokens(text)

    def document(self) -> Document:
        starts = [
            index
            for index, token in enumerate(self._tokens)
            if token.type == "heading_open" and token.level == 0 and token.tag in ("h1", "h2")
        ]
        sections = [self._section(start, end) for start, end in pairwise([*starts, len(self._tokens)])]
        return Document(self._path, tuple(sections))

    def _section(self, start: int, end: int) -> Section:
        heading = self._tokens[start]
        title = read_inline(self._tokens[start + 1].content).text
        return Section(title, int(heading.tag[1]), self._place(heading), tuple(self._items(start, end)))

    def _items(self, start: int, end: int) -> list[Item]:
        """The items between two tokens in the order of the document, those of lists in block quotes left out."""
        items: list[Item] = []
        opened: list[tuple[int, list[str]]] = []  # position in items, paragraphs
        quotes = 0
        for token in self._tokens[start:end]:
            quotes += token.nesting if token.type.startswith("blockquote") else 0
            if quotes:
                continue
            if token.type == "list_item_open":
                number = int(token.info) if token.info else None
                opened.append((len(items), []))
                items.append(Item("", number, len(opened) - 1, self._place(token)))
            elif token.type == "inline" and opened:
                opened[-1][1].append(token.content)
            elif token.type == "list_item_close":
                position, paragraphs = opened.pop()
                bare = items[position]
                if paragraphs:
                    paragraphs[0] = _CHECK_BOX.sub("", paragraphs[0])
                text = " ".join(read_inline(paragraph).text for paragraph in paragraphs)
                items[position] = Item(text, bare.number, bare.depth, bare.place)
        return items

    def _place(self, token: "Token") -> Place:
        line = token.map[0] if token.map else 0
        written = self._lines[line] if line < len(self._lines) else ""
        return Place(self._path, line + 1, len(written) - len(written.lstrip()) + 1)
