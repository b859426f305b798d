"""The lines of code in which statements stand, and the blocks of data."""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from codegen.claims.enclosing import types_around, types_below
from codegen.claims.parts.aligned import aligned_items, csv_rows
from codegen.claims.parts.data_comments import data_comments
from codegen.claims.parts.sentence import Sentence, Vocabulary
from codegen.claims.parts.span import DATA, Span, Topic, is_compared
from codegen.claims.parts.terms import read_sentence
from codegen.claims.reading import Reading
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock, PassageKind
from codegen.model.dialect.dialect import WireMessage
from codegen.pattern import pattern
from codegen.source import Place

_NO_CODE = (
    *("text", "txt", "plain", "console", "sh", "bash", "shell", "shell-session", "log", "output"),
    *("markdown", "md", "diff", "csv", "xml", "html", "mermaid"),
)
"""Blocks that are no declarations: what programs print, and what is quoted; XML is read as definitions."""
_FIELDS = pattern(
    r"\b(?:fields|u?int(?:8|16|32|64)(?:_t)?|float|type)\b[\"']?\s*:|:\s*[\"']?(?:u?int(?:8|16|32|64)(?:_t)?|float)\b"
)
_KEYED = pattern(r"^\s*[\"']?[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+[\"']?\s*:\s*\d", re.MULTILINE)
_COMMENT = pattern(r"\s*(?://|/\*|\*(?!\w)|#(?!\s*(?:define|include|if|endif|pragma))|--|;|<!--)")
_DECLARES = pattern(r"^\s*(?:///?|//!|/\*\*?|\*|#)\s?")
_MOST = 20
"""So many messages that are named before a part are remembered."""


def named_in(reading: Reading, code: CodeBlock) -> tuple[WireMessage, ...]:
    """Return the messages that a block of code names, each once, the last one first."""
    low = bisect_left(reading.sightings, (code.place.line, ""))
    high = bisect_left(reading.sightings, (code.last_line + 1, ""))
    names = dict.fromkeys(name for _, name in reversed(reading.sightings[low:high]))
    return tuple(reading.messages[name] for name in names)


def code_spans(reading: Reading, code: CodeBlock, topic: Topic, words: Vocabulary) -> Iterator[Span]:
    """Yield the lines of a block of code, or the whole of one of data, each with the messages named before it."""
    near_block = named_in(reading, code)
    for item in aligned_items(code, words.fields):
        sentence = read_sentence(item.text, 0, len(item.text), item.codes, words)
        yield Span(sentence, item.kind, replace(topic, above=near_block or topic.above), item.place_at)
    heads: tuple[str, ...] = ()
    for row in csv_rows(code, words.fields):
        heads = heads or tuple(cell.strip() for cell in row.text.strip("| ").split("|"))
        sentence = read_sentence(row.text, 0, len(row.text), row.codes, words)
        yield Span(sentence, row.kind, replace(topic, above=near_block or topic.above), row.place_at, heads=heads)
    if heads or code.language in _NO_CODE or any(line.text.lstrip().startswith("<") for line in code.lines[:3]):
        return
    if code.language in DATA or (not code.language and all(_MAPPING.match(line.text) for line in code.lines)):
        yield from _data(reading, code, topic, words)
        return
    first = bisect_left(reading.sightings, (code.place.line, ""))
    note: list[Line] = []
    below = types_below(reading, code)
    for line, around in zip(code.lines, types_around(reading, code), strict=True):
        last = bisect_left(reading.sightings, (line.place.line + 1, ""))
        sighted = reading.sightings[max(first, last - _MOST) : last]
        near = [
            reading.messages[name] for at, name in sighted if at < line.place.line or not _only_compared(line, name)
        ]
        near += [] if around is None else [around]  # what comments of members name besides is another message
        own = Topic((*reversed(near), *topic.above), topic.headings, topic.earlier, topic.document)
        if line.place.line in below:
            own = _of_type_below(reading, own, line, *below[line.place.line])
        is_comment = _COMMENT.match(line.text) is not None or (not code.language and _is_prose(line.text))
        sentence = _line(line, words)
        if is_comment:
            yield Span(sentence, PassageKind.TEXT, own, _places([line]), code.language, is_code=True, is_comment=True)
            has_name = any(term.letter in "FM" for term in sentence.terms.values())
            note = [] if has_name else [*note, line]
            continue
        yield Span(sentence, PassageKind.TEXT, own, _places([line]), code.language, is_code=True)
        if note and line.text.strip():  # what stands above a member is said of it
            told = [_told(each) for each in note]
            joined = " ".join(each.text for each in told)
            name = pattern(r"\b[A-Za-z_]\w*\s*[?:;=\[]").search(line.text)
            if name is not None and len(note) < 4:
                text = f"{name[0][:-1].strip()}: {joined}"
                shift = len(text) - len(joined)
                yield Span(
                    read_sentence(text, 0, len(text), ((0, shift),), words),
                    PassageKind.ITEM,
                    own,
                    _above(told, shift),
                    code.language,
                    True,
                    True,
                )
            note = []


def _of_type_below(reading: Reading, own: Topic, line: Line, first: int, below: WireMessage | None) -> Topic:
    """The messages that a comment above a type may be about: that of the type, or those that the comment names."""
    if below is not None:
        return replace(own, above=(below, *own.above))
    low, high = (bisect_left(reading.sightings, (at, "")) for at in (first, line.place.line + 1))
    return own if low < high or not own.above else Topic((), (), (), ())


def _only_compared(line: Line, name: str) -> bool:
    """Return whether a line names a message only to compare with it: "float here, unlike NAME"."""
    at = line.text.find(name)
    return at >= 0 and is_compared(line.text.lower(), at)


def _data(reading: Reading, code: CodeBlock, topic: Topic, words: Vocabulary) -> Iterator[Span]:
    """A block of JSON or YAML as one part, and its comments, each with the field that it stands beside."""
    span = _block(code, topic, words)
    if any(span.named(0, len(span.text))) or _KEYED.search(code.text) or _FIELDS.search(code.text):
        yield span
    for line, start, sentence, is_behind in data_comments(code, words) if _ANY_COMMENT.search(code.text) else ():
        own = replace(topic, above=_near(reading, code, line) or topic.above)
        kind = PassageKind.ITEM if is_behind else PassageKind.TEXT
        yield Span(sentence, kind, own, _above_from(line, start), code.language, is_code=True, is_comment=True)


def _near(reading: Reading, code: CodeBlock, line: Line) -> tuple[WireMessage, ...]:
    """The messages of the lines around a comment: that of the next line, or else the last one before it."""
    at = next((at for at, each in enumerate(code.lines) if each is line), 0)
    while at < len(code.lines) and _OWN_LINE.match(code.lines[at].text):
        at += 1
    behind = code.lines[at].place.line if at < len(code.lines) else line.place.line
    low = bisect_left(reading.sightings, (code.place.line, ""))
    found = reading.sightings[low : bisect_left(reading.sightings, (behind + 1, ""))]
    return tuple(reading.messages[name] for _, name in reversed(found[-_MOST:]))


def _above_from(line: Line, start: int) -> Callable[[int], Place]:
    return lambda offset: line.place._replace(column=line.place.column + start + offset)


_OWN_LINE = pattern(r"\s*(?:#|//)")
_ANY_COMMENT = pattern(r"(?:^|\s)(?:#|//)", re.MULTILINE)


def _is_prose(line: str) -> bool:
    """Return whether a line of a block without a language is one of a text, as in a message of a commit."""
    return _NO_CODE_IN.fullmatch(line) is not None and len(_WORD.findall(line)) >= _FEWEST


_NO_CODE_IN = pattern(r"[^;{}=<>|\[\]]*")
_WORD = pattern(r"(?<![\w.])[a-z]{2,}(?![\w(])")
_FEWEST = 4
"""Words in small letters that make a line a sentence."""


def _told(line: Line) -> Line:
    """Return what a comment says, without its marks."""
    text = _DECLARES.sub("", line.text).replace("*/", "")
    start = len(line.text) - len(_DECLARES.sub("", line.text)) + len(text) - len(text.lstrip())
    return Line(text.strip(), line.place._replace(column=line.place.column + start))


def _above(told: Sequence[Line], shift: int) -> Callable[[int], Place]:
    """Return the place of a character of what comments say, with ``shift`` characters before it."""
    place_at = _places(told)
    return lambda offset: place_at(max(offset - shift, 0))


def _line(line: Line, words: Vocabulary) -> Sentence:
    return read_sentence(line.text, 0, len(line.text), ((0, len(line.text)),), words)


def _places(lines: Sequence[Line]) -> Callable[[int], Place]:
    starts: list[int] = []
    length = 0
    for line in lines:
        starts.append(length)
        length += len(line.text) + 1

    def place_at(offset: int) -> Place:
        index = bisect_right(starts, offset) - 1
        place = lines[index].place
        return place._replace(column=place.column + offset - starts[index])

    return place_at


_MAPPING = pattern(r"\s*(?:$|#|-?\s*[\w.]+:(?:\s|$))")
_COMMENTED = pattern(r"^[ \t]*#.*$", re.MULTILINE)


def _block(code: CodeBlock, topic: Topic, words: Vocabulary) -> Span:
    """A block of JSON or YAML as one part: what belongs to a field follows its name."""
    text = _COMMENTED.sub(lambda found: " " * len(found[0]), code.text)
    sentence = read_sentence(text, 0, len(text), ((0, len(text)),), words)
    return Span(sentence, PassageKind.ITEM, topic, _places(code.lines), code.language, is_code=True)
