"""Comments in blocks of JSON and YAML, each with the field that it stands beside."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

from codegen.claims.parts.led import led_by
from codegen.claims.parts.sentence import Sentence, Term, Vocabulary
from codegen.claims.parts.terms import read_sentence
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock
from codegen.pattern import pattern

_COMMENT = pattern(r"\s*(?:#|//)\s?")
_TRAILING = pattern(r"\s(?:#|//).*$")
_UNUSED = pattern(r"[\w.-]+: (?:\.\.\.|.* # )")
"""A comment that is an entry which is not in use, with a comment of its own: "type: ...  # line 9"."""
_NEXT = pattern(r"\s*(?:-\s|\{|\[\[)")
"""A line that begins another entry, which the comment above it is about."""
_OF_FIELD = pattern(r"^\s*-?\s*[\"']?(?:field|source|name|from|key|path|signal|value|when|topic)[\"']?\s*[:=]")


def data_comments(code: CodeBlock, words: Vocabulary) -> Iterator[tuple[Line, int, Sentence, bool]]:
    """Yield each comment: its first line, where its words begin there, its terms, and whether it is behind the field.

    One that names nothing is led by the field of its line, of the line before it if that tells of one, or else of the
    line behind it.
    """
    lines, first = code.lines, 0
    while first < len(lines):
        if _COMMENT.match(lines[first].text) is None:
            yield from _behind(lines[first], words)
            first += 1
            continue
        end = first
        while end < len(lines) and _COMMENT.match(lines[end].text) is not None:
            end += 1
        lead = _COMMENT.match(lines[first].text)
        assert lead is not None
        text = " ".join(_COMMENT.sub("", line.text, count=1).strip() for line in lines[first:end])
        first, begin = end, first
        if _UNUSED.match(text):
            continue
        sentence = read_sentence(
            text, 0, len(text), tuple((at, at + len(name)) for at, name in _names(text, words)), words
        )
        names = [] if _is_told(sentence) else _beside(lines, begin, end, words)
        yield lines[begin], lead.end(), led_by(names, sentence) if names else sentence, False


def _behind(line: Line, words: Vocabulary) -> Iterator[tuple[Line, int, Sentence, bool]]:
    """Yield the comment behind the only field of a line, led by it."""
    comment = _TRAILING.search(line.text)
    names = _fields_of(line.text, words) if comment is not None else []
    if comment is None or len(names) != 1:
        return
    start = comment.start() + len(comment[0]) - len(comment[0].lstrip(" #/"))
    text = line.text[start:]
    sentence = read_sentence(text, 0, len(text), (), words)
    is_of_else = "Q" in sentence.marked or _SUBJECT.search(sentence.marked) is not None
    if not _is_told(sentence) and not is_of_else:
        yield line, start, led_by(names, sentence), True


_SUBJECT = pattern(r"\b[a-z]+s (?:arrive|come|are|go|have)\b|\b(?:we|our|they)\b")
"""Words of a comment that is about other things than the field of its line."""


def _is_told(sentence: Sentence) -> bool:
    return any(term.letter in "FPM" for term in sentence.terms.values())


def _names(text: str, words: Vocabulary) -> Iterator[tuple[int, str]]:
    """The names of fields in backticks: there, everyday words are names, too."""
    for found in pattern(r"`(\w+)`").finditer(text):
        if found[1] in words.fields:
            yield found.start(1), found[1]


def _beside(lines: Sequence[Line], first: int, end: int, words: Vocabulary) -> list[Term]:
    """The field of the line before a comment, where that is told there, or of the line behind it; empty for several."""
    before = lines[first - 1].text if first else ""
    behind = lines[end].text if end < len(lines) else ""
    is_within = _OF_FIELD.match(before) is not None and not _NEXT.match(behind)
    for text in (before if is_within else "", behind):
        names = _fields_of(text, words)
        if len(names) == 1:
            return names
    return []


def _fields_of(line: str, words: Vocabulary) -> list[Term]:
    """The fields that a line names before its comment."""
    stated = _TRAILING.sub("", line)
    sentence = read_sentence(stated, 0, len(stated), ((0, len(stated)),), words)
    return [replace(term, start=0, end=0) for term in sentence.terms.values() if term.letter == "F"]
