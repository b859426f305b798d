"""Comments on lines of their own in blocks of JSON and YAML, each with the message and the field that it stands beside."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from codegen.claims.parts.led import led_by
from codegen.claims.parts.sentence import Sentence, Term, Vocabulary
from codegen.claims.parts.terms import read_sentence
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock

_COMMENT = re.compile(r"\s*(?:#|//)\s?")
_TRAILING = re.compile(r"\s(?:#|//).*$")
_OF_FIELD = re.compile(r"^\s*-?\s*[\"']?(?:field|source|name|from|key|path|signal|value|when|topic)[\"']?\s*[:=]")


def data_comments(code: CodeBlock, words: Vocabulary) -> Iterator[tuple[Line, int, Sentence, bool]]:
    """Yield each comment: its first line, where its words begin there, its terms, and whether a name leads it.

    One that names nothing is led by the field of the line before it, if that tells of one, or else of the line behind it.
    """
    lines, first = code.lines, 0
    while first < len(lines):
        if _COMMENT.match(lines[first].text) is None:
            first += 1
            continue
        end = first
        while end < len(lines) and _COMMENT.match(lines[end].text) is not None:
            end += 1
        lead = _COMMENT.match(lines[first].text)
        assert lead is not None
        text = " ".join(_COMMENT.sub("", line.text, count=1).strip() for line in lines[first:end])
        sentence = read_sentence(text, 0, len(text), tuple((at, at + len(name)) for at, name in _names(text, words)), words)
        names = [] if _is_told(sentence) else _beside(lines, first, end, words)
        yield lines[first], lead.end(), led_by(names, sentence) if names else sentence, bool(names)
        first = end


def _is_told(sentence: Sentence) -> bool:
    return any(term.letter in "FPM" for term in sentence.terms.values())


def _names(text: str, words: Vocabulary) -> Iterator[tuple[int, str]]:
    """The names of fields in backticks: there, everyday words are names, too."""
    for found in re.finditer(r"`(\w+)`", text):
        if found[1] in words.fields:
            yield found.start(1), found[1]


def _beside(lines: Sequence[Line], first: int, end: int, words: Vocabulary) -> list[Term]:
    """The field of the line before a comment, where that is told there, or of the line behind it; empty for several."""
    before = lines[first - 1].text if first else ""
    behind = lines[end].text if end < len(lines) else ""
    for text in (before if _OF_FIELD.match(before) else "", behind):
        stated = _TRAILING.sub("", text)
        sentence = read_sentence(stated, 0, len(stated), ((0, len(stated)),), words)
        names = [term for term in sentence.terms.values() if term.letter == "F"]
        if len(names) == 1:
            return [replace(names[0], start=0, end=0)]
    return []
