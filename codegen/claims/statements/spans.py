"""The parts of a document in which statements stand, each with the messages that it may be about."""

import re
from bisect import bisect_left
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from itertools import groupby

from codegen.claims.reading import Reading
from codegen.claims.statements.aligned import aligned_items, csv_rows
from codegen.claims.statements.cells import said_before
from codegen.claims.statements.led import led_by, names_leading
from codegen.claims.statements.pronouns import with_names
from codegen.claims.statements.sentence import NamedField, Sentence, Term, Vocabulary
from codegen.claims.statements.terms import read_sentence
from codegen.frozen import dataclass
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.once import once
from codegen.source import Place

_NO_CODE = (
    *("text", "txt", "plain", "console", "sh", "bash", "shell", "shell-session", "log", "output"),
    *("markdown", "md", "diff", "csv", "xml", "html", "mermaid"),
)
"""Blocks that are no declarations: what programs print, and what is quoted; XML is read as definitions."""
_DATA = ("json", "json5", "jsonc", "yaml", "yml", "toml")
_BREAK = re.compile(
    r"(?<!\be\.g)(?<!\bi\.e)(?<!\bca)(?<!\bno)(?<!\bapprox)(?<!\bmax)(?<!\bmin)(?<!\bresp)(?<!\bincl)[.!?;](?=\s|$)"
)
_GOES_ON = re.compile(r"\s*(?:it|its|they|their|that|this|the unit|unit|units|unknown|the value|in U|U\b|[NS] )\b")
_FIELDS = re.compile(
    r"\b(?:fields|u?int(?:8|16|32|64)(?:_t)?|float|type)\b[\"']?\s*:|:\s*[\"']?(?:u?int(?:8|16|32|64)(?:_t)?|float)\b"
)
_KEYED = re.compile(r"^\s*[\"']?[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+[\"']?\s*:\s*\d", re.MULTILINE)
_DEFINED = re.compile(r"[FP](?:,? (?:and )?[FP])* : ")
"""A definition list, which is a paragraph for Markdown."""
_LONG_NAME = re.compile(r"\b[A-Z][A-Z0-9]{1,30}(?:_[A-Z0-9]{1,30}){2}")
_FIRST_NAME = re.compile(r"[\s|*-]*(?P<name>[a-z][a-z0-9_]*)(?=\s*(?:$|[|:(=\u2013-]|\[))")
_CELL = re.compile(r"(?:^|\|)[\s*-]*([a-z]\w*)(?=[\s|:(=\[,\u2013-]|$)")
_ENOUGH = 3
"""Names that have to begin items or rows before most of them have to be fields."""
_COMPARED = re.compile(
    r"\b(?:unlike|as in|like in|as with|as for|like|than in|compared (?:to|with)|instead of|not in) (?:the )?$"
)
_COMMENT = re.compile(r"\s*(?://|/\*|\*(?!\w)|#(?!\s*(?:define|include|if|endif|pragma))|--|;|<!--)")
_DECLARES = re.compile(r"^\s*(?:///?|//!|/\*\*?|\*|#)\s?")


_WINDOW = 400
"""How far a sentence is looked for around a place, in characters."""
_MOST = 20
"""So many messages that are named before a part are remembered."""


@lru_cache(maxsize=16)
def _ends(text: str) -> tuple[int, ...]:
    """Where the sentences of a text end."""
    return tuple(found.start() for found in _BREAK.finditer(text))


@dataclass(frozen=True, slots=True)
class Topic:
    """The messages that the surroundings of a part name, each group with the nearest one first."""

    above: tuple[WireMessage, ...]
    headings: tuple[WireMessage, ...]
    earlier: tuple[WireMessage, ...]
    document: tuple[WireMessage, ...]

    @property
    def around(self) -> tuple[WireMessage, ...]:
        """All of them, by how near they are."""
        found = (*self.above, *self.headings, *self.earlier)
        return tuple({message.name: message for message in reversed(found)}.values())[::-1]


@dataclass(frozen=True, slots=True)
class Span:
    """A passage, a line of code or a block of data: its terms, and the messages that it may be about.

    ``kind`` is that of a passage; ``language`` is that of a block of code, else empty.
    """

    sentence: Sentence
    kind: PassageKind
    topic: Topic
    place_at: Callable[[int], Place]
    language: str = ""
    is_code: bool = False
    is_comment: bool = False
    heads: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """The short text with the terms as capital letters."""
        return self.sentence.marked

    def place(self, offset: int) -> Place:
        """The place of a character of the short text."""
        return self.place_at(self.sentence.source(offset))

    def bounds(self, offset: int) -> tuple[int, int]:
        """The sentence around a character of the short text; not farther than a window."""
        ends = _ends(self.text)
        place = bisect_left(ends, offset)
        low = ends[place - 1] + 1 if place else 0
        high = ends[place] if place < len(ends) else len(self.text)
        return max(low, offset - _WINDOW), min(high, offset + _WINDOW)

    def end_of(self, offset: int) -> int:
        """How far a statement reaches that begins at a character: its sentence, and those that go on about it."""
        _, high = self.bounds(offset)
        is_row = self.kind is PassageKind.ROW or self.is_code
        if not is_row and self._has_other_subject(offset):
            return high
        if is_row or self.kind is PassageKind.ITEM or _DEFINED.match(self.text):
            return len(self.text)
        while high < len(self.text) and _GOES_ON.match(self.text, high + 1):
            _, high = self.bounds(high + 1)
        return high

    def _has_other_subject(self, offset: int) -> bool:
        """Whether the sentence around a name is about another one, which a pronoun after it stands for."""
        low, _ = self.bounds(offset)
        first = next((at for at, _ in self.sentence.within(low, offset, "F")), None)
        is_same = first is None or re.fullmatch(r"[F ,/&+]|F(?:(?:, | and | or | to | ?[/&+] ?)F)*", self.text[first:offset])
        return not is_same and re.match(r"[^a-zA-Z]*(?:the )?F", self.text[low:offset]) is not None

    def source_text(self, low: int, high: int) -> str:
        """The words of the source that a part of the short text stands for."""
        terms = self.sentence.terms
        return "".join(terms[at].written if at in terms else self.text[at] for at in range(low, high))

    def named(self, low: int, high: int) -> Iterator[tuple[int, str]]:
        """The messages that are named between two characters, with their offsets; none of a comparison."""
        for offset, term in self.sentence.within(low, high, "MF"):
            value = term.value
            if _COMPARED.search(self.text, max(offset - 20, 0), offset):
                continue
            if isinstance(value, str):
                yield offset, value
            elif isinstance(value, NamedField) and value.message is not None:
                yield offset, value.message


def is_data(span: Span) -> bool:
    """Whether it is a block of JSON or YAML."""
    return span.language in _DATA


def head_of(span: Span, offset: int) -> str:
    """The heading of the column in which a character of a row stands."""
    column = span.text.count("|", 0, offset) - span.text.lstrip().startswith("|")
    return span.heads[column] if column < len(span.heads) else ""


@once
def vocabulary(reading: Reading) -> Vocabulary:
    """The names that are terms in a document: fields only of messages that it names."""
    named = {name for _, name in reading.sightings}
    return Vocabulary(
        messages=reading.messages,
        enums=reading.enums,
        entries={entry.name for enum in reading.enums.values() for entry in enum.entries},
        fields=frozenset(field.name for name in named for field in reading.messages[name].fields),
    )


@once
def spans(reading: Reading) -> tuple[Span, ...]:
    """All parts of a document, in order; none of one that names no message."""
    is_about_enums = any(_LONG_NAME.search(part.text) for part in reading.prose.parts)
    return tuple(_spans(reading)) if reading.sightings or is_about_enums else ()


def _spans(reading: Reading) -> Iterator[Span]:
    words = vocabulary(reading)
    headings: list[tuple[int, tuple[WireMessage, ...]]] = []
    earlier: list[WireMessage] = []
    above: tuple[WireMessage, ...] = ()
    heads: tuple[str, ...] = ()
    document = tuple(reading.messages[name] for name in dict.fromkeys(name for _, name in reading.sightings))
    previous: PassageKind | None = None
    leading: list[Term] = []
    is_foreign = is_foreign_section = False
    others = _other_lists(reading, words)
    for part in reading.prose.parts:
        named = _named(reading, part)
        if isinstance(part, Passage) and part.kind is PassageKind.HEADING:
            headings = [each for each in headings if each[0] < part.level]
            headings.append((part.level, named))
            is_foreign = not named and _is_foreign(reading, part)
            is_foreign_section = is_foreign and _NUMBERED.search(part.text) is not None
            earlier, above = [], ()
        elif isinstance(part, Passage) and part.kind is PassageKind.TEXT:
            is_foreign = not named and (
                _is_foreign(reading, part) or (is_foreign and not headings) or is_foreign_section
            )
        inside = tuple(message for _, group in reversed(headings) for message in group)
        topic = (
            Topic((), (), (), ())
            if is_foreign or id(part) in others or (not named and _is_foreign_item(reading, part))
            else Topic(above, inside, tuple(earlier), document)
        )
        if isinstance(part, CodeBlock):
            yield from _code(reading, part, topic, words)
        else:
            sentence = read_sentence(part.text, 0, len(part.text), part.codes, words)
            is_head = part.kind is PassageKind.ROW and previous is not PassageKind.ROW
            if is_head:
                heads = tuple(cell.strip() for cell in part.text.strip().strip("|").split("|"))
            yield Span(sentence, part.kind, topic, part.place_at, heads=heads if part.kind is PassageKind.ROW else ())
            for said in said_before(sentence, heads) if part.kind is PassageKind.ROW and not is_head else ():
                yield Span(said, PassageKind.ITEM, topic, part.place_at)
            if part.kind is not PassageKind.ROW and (written_out := with_names(sentence)) is not None:
                yield Span(written_out, part.kind, topic, part.place_at)
            if part.kind in (PassageKind.TEXT, PassageKind.ITEM) and leading:
                yield Span(led_by(leading, sentence), PassageKind.ITEM, topic, part.place_at)
            leading = names_leading(sentence, is_heading=part.kind is PassageKind.HEADING)
            if part.kind in (PassageKind.TEXT, PassageKind.HEADING) and named:
                above = named
            previous = part.kind
        if isinstance(part, CodeBlock):
            previous = None
        for message in reversed(named):
            if message in earlier:
                earlier.remove(message)
            earlier.insert(0, message)
        del earlier[_MOST:]


def _other_lists(reading: Reading, words: Vocabulary) -> frozenset[int]:
    """Rows and items of runs of which at most half of the names at the beginning are fields: they list other things."""
    found: set[int] = set()
    for kind, run in groupby(reading.prose.parts, lambda part: getattr(part, "kind", None)):
        if kind in (PassageKind.ROW, PassageKind.ITEM):
            parts = [part for part in run if isinstance(part, Passage)]
            begun = [part for part in parts if _FIRST_NAME.match(part.text)]
            known = sum(not words.fields.isdisjoint(_CELL.findall(part.text)) for part in begun)
            if len(begun) >= _ENOUGH and 2 * known <= len(begun):
                found |= {id(part) for part in parts}
    return frozenset(found)


def _is_foreign(reading: Reading, part: Passage) -> bool:
    """Whether a heading or a caption is about a message that the dialect does not have."""
    text = part.text.strip()
    found = _CALLED.match(text) if part.kind is PassageKind.HEADING else _CAPTION.search(text)
    name = found["name"] if found is not None else ""
    known = vocabulary(reading)
    return bool(name) and name not in known.messages and name not in known.enums and name not in known.entries


def _is_foreign_item(reading: Reading, part: Passage | CodeBlock) -> bool:
    """Whether an item is about a message of another kind, such as one of a log: "the log, message `IMU`"."""
    found = _ITEM.search(part.text) if isinstance(part, Passage) and part.kind is PassageKind.ITEM else None
    known = vocabulary(reading)
    return found is not None and found["name"] not in known.messages and found["name"] not in known.enums


_ITEM = re.compile(r"\b[Mm]essage (?P<name>[A-Z][A-Z0-9_]{2,})\b(?=[.,;:]|$)")
_NUMBERED = re.compile(r"[(#,]\s*(?:id )?#?\d+\b")
"""A heading with an id: its whole section is about a message, and not about a parameter."""
_CALLED = re.compile(
    r"(?:\d[\d.]* )?(?:Message |The message )?(?P<name>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+)\b(?=\s*(?:$|[(:,#\u2013-]))"
)
_CAPTION = re.compile(r"(?:^|\b[Mm]essage )(?P<name>[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+)\b[^.]{0,60}:$")


def _named(reading: Reading, part: Passage | CodeBlock) -> tuple[WireMessage, ...]:
    if isinstance(part, Passage):
        return reading.named(part)
    low = bisect_left(reading.sightings, (part.place.line, ""))
    high = bisect_left(reading.sightings, (part.lines[-1].place.line + 1, ""))
    names = dict.fromkeys(name for _, name in reversed(reading.sightings[low:high]))
    return tuple(reading.messages[name] for name in names)


def _code(reading: Reading, code: CodeBlock, topic: Topic, words: Vocabulary) -> Iterator[Span]:
    near = _named(reading, code)
    for item in aligned_items(code, words.fields):
        sentence = read_sentence(item.text, 0, len(item.text), item.codes, words)
        yield Span(sentence, item.kind, replace(topic, above=near or topic.above), item.place_at)
    heads: tuple[str, ...] = ()
    for row in csv_rows(code, words.fields):
        heads = heads or tuple(cell.strip() for cell in row.text.strip("| ").split("|"))
        sentence = read_sentence(row.text, 0, len(row.text), row.codes, words)
        yield Span(sentence, row.kind, replace(topic, above=near or topic.above), row.place_at, heads=heads)
    if heads or code.language in _NO_CODE or any(line.text.lstrip().startswith("<") for line in code.lines[:3]):
        return
    if code.language in _DATA or (not code.language and all(_MAPPING.match(line.text) for line in code.lines)):
        span = _block(code, topic, words)
        if any(span.named(0, len(span.text))) or _KEYED.search(code.text) or _FIELDS.search(code.text):
            yield span
        return
    first = bisect_left(reading.sightings, (code.place.line, ""))
    note: list[Line] = []
    for line in code.lines:
        last = bisect_left(reading.sightings, (line.place.line + 1, ""))
        near = [reading.messages[name] for _, name in reading.sightings[max(first, last - _MOST) : last]]
        own = Topic((*reversed(near), *topic.above), topic.headings, topic.earlier, topic.document)
        is_comment = _COMMENT.match(line.text) is not None
        sentence = _line(line, words)
        if is_comment:
            yield Span(sentence, PassageKind.TEXT, own, _places([line]), code.language, is_code=True, is_comment=True)
            has_name = any(term.letter in "FM" for term in sentence.terms.values())
            note = [] if has_name else [*note, line]
            continue
        yield Span(sentence, PassageKind.TEXT, own, _places([line]), code.language, is_code=True)
        if note and line.text.strip():  # what stands above a member is said of it
            joined = " ".join(_DECLARES.sub("", each.text).replace("*/", "").strip() for each in note)
            name = re.search(r"\b[A-Za-z_]\w*\s*[?:;=\[]", line.text)
            if name is not None and len(note) < 4:
                text = f"{name[0][:-1].strip()}: {joined}"
                shift = len(text) - len(joined)
                yield Span(
                    read_sentence(text, 0, len(text), ((0, shift),), words),
                    PassageKind.ITEM,
                    own,
                    _above(note[0], shift),
                    code.language,
                    True,
                    True,
                )
            note = []


def _above(line: Line, shift: int) -> Callable[[int], Place]:
    lead = _DECLARES.match(line.text)
    start = lead.end() if lead else 0
    return lambda offset: line.place._replace(column=line.place.column + start + max(offset - shift, 0))


def _line(line: Line, words: Vocabulary) -> Sentence:
    return read_sentence(line.text, 0, len(line.text), ((0, len(line.text)),), words)


def _places(lines: Sequence[Line]) -> Callable[[int], Place]:
    starts: list[int] = []
    length = 0
    for line in lines:
        starts.append(length)
        length += len(line.text) + 1

    def place_at(offset: int) -> Place:
        index = max((index for index, start in enumerate(starts) if start <= offset), default=0)
        place = lines[index].place
        return place._replace(column=place.column + offset - starts[index])

    return place_at


_MAPPING = re.compile(r"\s*(?:$|#|-?\s*[\w.]+:(?:\s|$))")
_COMMENTED = re.compile(r"^[ \t]*#.*$", re.MULTILINE)


def _block(code: CodeBlock, topic: Topic, words: Vocabulary) -> Span:
    """A block of JSON or YAML as one part: what belongs to a field follows its name."""
    text = _COMMENTED.sub(lambda found: " " * len(found[0]), code.text)
    sentence = read_sentence(text, 0, len(text), ((0, len(text)),), words)
    return Span(sentence, PassageKind.ITEM, topic, _places(code.lines), code.language, is_code=True)
