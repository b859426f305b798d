"""Markdown as headings, sections and list items that know their lines (CommonMark, read by markdown-it)."""

import hashlib
import html
import os
import re
from collections.abc import Callable
from dataclasses import replace
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
_HTML_TAG = pattern(r"<!--.*?-->|<[^>]*>", re.DOTALL)
_CODE = ("fence", "code_block")
_LAYOUT = pattern(r"[*`\\]|(?<!\w)_+|_+(?!\w)|(?<=---)-+|[ \t]+(?=\|)|(?<=\|)[ \t]+")
"""Marks of emphasis and code, blanks beside the bars of tables, and the widths of the lines below their heads."""
_BLOCKS_OF_TEXT = ("inline", "fence", "code_block", "html_block")


@dataclass(frozen=True, slots=True)
class Item:
    """One item of a list. ``number`` is as written (None for a bullet), ``depth`` 0 for the outermost list.

    ``text`` is plain: without markup, and without the check box that may lead it; what blocks inside say that are no
    paragraphs is not in it. ``whole`` is all that CommonMark has in the item, lists, code and quotations included, with
    ``-`` or the number in front of each item inside. ``begins_list`` marks the first one of its list: what numbers the
    others are shown with follows from its own.
    """

    text: str
    number: int | None
    depth: int
    place: Place
    whole: str
    begins_list: bool


@dataclass(frozen=True, slots=True)
class Section:
    """A heading of level 1 or 2 with the list items below it, those below deeper headings included.

    ``stray`` are the places of text that follows an item and belongs to none, the first one behind each item; what
    stands below a heading introduces the items behind it, and is not among them. ``deeper`` are the headings of other
    levels in it, with their places.
    """

    title: str
    level: int
    place: Place
    items: tuple[Item, ...]
    stray: tuple[Place, ...] = ()
    deeper: tuple[tuple[str, Place], ...] = ()


@dataclass(frozen=True, slots=True)
class Document:
    """One Markdown file; what stands before the first heading is in no section.

    ``said`` is a fingerprint of all that it says: lines that are broken otherwise, blanks outside of code and marks of
    emphasis do not count in it.
    """

    path: str
    sections: tuple[Section, ...]
    said: str


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
        return Document(self._path, tuple(sections), self._said())

    def _said(self) -> str:
        found = hashlib.sha256()
        for token in self._tokens:
            text = token.content if token.type in _CODE else " ".join(_LAYOUT.sub("", token.content).split())
            found.update(f"{token.type} {token.tag} {token.info} {text}\n".encode("utf-8", "surrogatepass"))
        return found.hexdigest()

    def _section(self, start: int, end: int) -> Section:
        heading = self._tokens[start]
        title = read_inline(self._tokens[start + 1].content).text
        read = _Items(self._place)
        for index in range(start + 3, end):
            read.take(self._tokens[index], in_heading=self._tokens[index - 1].type == "heading_open")
        return Section(
            title,
            int(heading.tag[1]),
            self._place(heading),
            items=tuple(read.items),
            stray=tuple(read.stray),
            deeper=tuple(read.deeper),
        )

    def _place(self, token: "Token") -> Place:
        line = token.map[0] if token.map else 0
        written = self._lines[line] if line < len(self._lines) else ""
        return Place(self._path, line + 1, len(written) - len(written.lstrip()) + 1)


class _Opened:
    """An item that has not ended: its position among the items, its paragraphs, and all that is in it."""

    def __init__(self, position: int) -> None:
        self.position = position
        self.paragraphs: list[str] = []
        self.pieces: list[str] = []


class _Items:
    """The items of a section in the order of the document, those of lists in block quotes left out."""

    def __init__(self, place_of: "Callable[[Token], Place]") -> None:
        self.items: list[Item] = []
        self.stray: list[Place] = []
        self.deeper: list[tuple[str, Place]] = []
        self._place_of = place_of
        self._opened: list[_Opened] = []
        self._quotes = 0
        self._begins_list = False
        self._begins_item = False
        self._follows_item = False

    def take(self, token: "Token", *, in_heading: bool) -> None:
        """Go on by one token; ``in_heading`` tells that it is the text of a heading."""
        if token.type in ("blockquote_open", "blockquote_close"):
            self._quotes += token.nesting
        elif token.type in ("bullet_list_open", "ordered_list_open"):
            self._begins_list = True
        elif token.type == "heading_open" and not self._opened:
            self._follows_item = False
        elif token.type == "list_item_open":
            self._open(token)
        elif token.type == "list_item_close" and not self._quotes:
            self._close()
        elif token.type in _BLOCKS_OF_TEXT:
            self._read(token, in_heading=in_heading)

    def _open(self, token: "Token") -> None:
        number = int(token.info) if token.info else None
        for each in self._opened:
            each.pieces.append("-" if number is None else f"{number}.")
        self._begins_item = True
        if not self._quotes:
            begun = Item("", number, len(self._opened), self._place_of(token), "", self._begins_list)
            self._opened.append(_Opened(len(self.items)))
            self.items.append(begun)
        self._begins_list = False

    def _close(self) -> None:
        read = self._opened.pop()
        text, whole = (" ".join(filter(None, pieces)) for pieces in (read.paragraphs, read.pieces))
        self.items[read.position] = replace(self.items[read.position], text=text, whole=whole)
        self._follows_item = not self._opened
        self._begins_list = False

    def _read(self, token: "Token", *, in_heading: bool) -> None:
        written = _CHECK_BOX.sub("", token.content) if self._begins_item else token.content
        self._begins_item = False
        is_paragraph = token.type == "inline"
        text = read_inline(written).text if is_paragraph else " ".join(_shown(token).split())
        for each in self._opened:
            each.pieces.append(text)
        if self._opened and is_paragraph and not self._quotes:
            self._opened[-1].paragraphs.append(text)
        elif in_heading and not self._quotes:
            self.deeper.append((text, self._place_of(token)))
        elif not self._opened and text and self._follows_item and not in_heading:
            self.stray.append(self._place_of(token))
            self._follows_item = False  # what comes right behind it is the same fault


def _shown(token: "Token") -> str:
    """Return what a page shows of a block of code or HTML: of HTML no tags and no comments."""
    return html.unescape(_HTML_TAG.sub(" ", token.content)) if token.type == "html_block" else token.content
