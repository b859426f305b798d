"""Patterns are those of the standard library, compiled later; texts in which they are found have what they need."""

import re
import re._constants as kinds
import re._parser as parser
from collections.abc import Iterable, Iterator
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest

import codegen
from codegen import pattern as patterns
from codegen.pattern import _Pattern, pattern

PACKAGE = Path(codegen.__file__).parent

MOST = 64
"""So many texts are written out of which a piece of an expression finds each."""

EXPRESSION = r"\b(?P<what>crc|seed)\b"


def written_out(part: Any, flags: int) -> set[str] | None:
    """Return all that a piece of an expression finds; None where that is too much or cannot be told."""
    kind, of = part
    if kind in (kinds.AT, kinds.ASSERT, kinds.ASSERT_NOT):
        return {""}
    if kind is kinds.LITERAL:
        return {letter(of, flags)}
    if kind is kinds.IN:
        is_listed = all(each is kinds.LITERAL for each, _ in of)
        return {letter(code, flags) for _, code in of} if is_listed else None
    if kind is kinds.SUBPATTERN and not of[1] and not of[2]:
        return run_together(of[3], flags)
    if kind is kinds.BRANCH:
        found = [run_together(branch, flags) for branch in of[1]]
        return None if None in found else set[str]().union(*(each for each in found if each is not None))
    if kind in (kinds.MAX_REPEAT, kinds.MIN_REPEAT) and of[1] == 1:
        body = run_together(of[2], flags)
        return None if body is None else body if of[0] else {*body, ""}
    return None


def letter(code: int, flags: int) -> str:
    return chr(code).casefold() if flags & re.IGNORECASE else chr(code)


def run_together(parts: Iterable[Any], flags: int) -> set[str] | None:
    """Return all that pieces find which follow one another."""
    texts = {""}
    for part in parts:
        found = written_out(part, flags)
        if found is None or len(texts) * len(found) > MOST:
            return None
        texts = {text + each for text in texts for each in found}
    return texts


def runs(parts: list[Any], flags: int) -> Iterator[set[str]]:
    """Yield what is found by pieces that follow one another and can be written out, wherever they begin and end."""
    for start in range(len(parts)):
        for end in range(start + 1, len(parts) + 1):
            found = run_together(parts[start:end], flags)
            if found is None:
                break
            yield found


def is_needed(parts: Iterable[Any], words: list[str], flags: int) -> bool:
    """Return whether every text in which an expression is found has one of the words."""
    parts = list(parts)
    if any(all(any(word in text for word in words) for text in texts) for texts in runs(parts, flags)):
        return True
    return any(is_needed_by(part, words, flags) for part in parts)


def is_needed_by(part: Any, words: list[str], flags: int) -> bool:
    kind, of = part
    if kind is kinds.BRANCH:
        return all(is_needed(branch, words, flags) for branch in of[1])
    if kind in (kinds.MAX_REPEAT, kinds.MIN_REPEAT):
        return of[0] > 0 and is_needed(of[2], words, flags)
    if kind is kinds.SUBPATTERN:
        return not of[1] and not of[2] and is_needed(of[3], words, flags)
    return kind is kinds.ASSERT and is_needed(of[1], words, flags)


def patterns_in(value: object) -> Iterator[_Pattern]:
    """Yield the patterns of a module, or of what one of its names stands for."""
    if isinstance(value, _Pattern):
        yield value
    elif isinstance(value, tuple | list):
        for each in value:
            yield from patterns_in(each)
    elif isinstance(value, dict):
        yield from patterns_in(list(value.values()))


def patterns_of_modules() -> list[tuple[str, _Pattern]]:
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        if "pattern(" in path.read_text(encoding="utf-8") and path.stem != "pattern":
            name = ".".join(("codegen", *path.relative_to(PACKAGE).with_suffix("").parts)).removesuffix(".__init__")
            for value in vars(import_module(name)).values():
                found.update({id(each): (name, each) for each in patterns_in(value)})
    return list(found.values())


def test_what_a_pattern_needs_is_in_every_text_in_which_it_is_found() -> None:
    """Protects findings: a pattern with a word that its texts may lack would be silent until it is compiled."""
    known = [(name, each) for name, each in patterns_of_modules() if each._words]
    written = sum(path.read_text(encoding="utf-8").count(' needs="') for path in PACKAGE.rglob("*.py"))
    assert len(known) >= written > 0
    for name, each in known:
        expression, words = each._expression, each._words
        flags = re.compile(expression, each._flags).flags
        assert is_needed(parser.parse(expression, flags), words, flags), f"{name}: {expression} without {words}"


@pytest.mark.parametrize(
    ("expression", "words"),
    [
        (r"crc|seed", "crc"),
        (r"(?:the )?crc", "the"),
        (r"(?i:crc)", "crc"),
        (r"(?!crc)c", "crc"),
        (r"(?:seed)*c", "seed"),
        (r"se[a-z]d", "seed"),
        (r"sizes?", "sizes"),
    ],
)
def test_a_word_that_a_text_may_lack_is_noticed(expression: str, words: str) -> None:
    """Protects the test above from agreeing to everything."""
    assert not is_needed(parser.parse(expression), words.split("|"), 0)


@pytest.mark.parametrize("needs", ["", "crc|seed"])
@pytest.mark.parametrize("text", ["A CRC of the frame", "the crc, the Seed and the crc", "seed", "nothing", ""])
def test_a_pattern_answers_as_the_compiled_one(text: str, needs: str) -> None:
    """Protects what callers rely on: whatever is asked first, and within bounds, the answer is that of ``re``."""
    compiled = re.compile(EXPRESSION, re.IGNORECASE)

    def late() -> "re.Pattern[str]":
        return pattern(EXPRESSION, re.IGNORECASE, needs=needs)

    for name in ("search", "match", "fullmatch"):
        for bounds in ((), (2,), (2, 8), (0, 4)):
            found = getattr(late(), name)(text, *bounds)
            expected = getattr(compiled, name)(text, *bounds)
            assert (found and found.span("what")) == (expected and expected.span("what")), (name, bounds)
    assert late().findall(text) == compiled.findall(text)
    assert [each.span() for each in late().finditer(text)] == [each.span() for each in compiled.finditer(text)]
    assert late().sub("x", text) == compiled.sub("x", text)
    assert late().split(text) == compiled.split(text)


def test_a_pattern_has_the_attributes_of_the_compiled_one() -> None:
    compiled, late = re.compile(EXPRESSION, re.IGNORECASE), pattern(EXPRESSION, re.IGNORECASE)
    for name in ("pattern", "flags", "groups", "groupindex"):
        assert getattr(late, name) == getattr(compiled, name), name
    with pytest.raises(AttributeError, match="scanner"):
        getattr(late, "scanner")  # noqa: B009  mypy knows that compiled ones have it


def test_a_pattern_is_compiled_once_and_only_for_a_text_with_a_word_that_it_needs(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Protects the time of a check after an edit, most of which would go into compiling."""
    compiled = []

    def noted(expression: str, flags: int) -> "re.Pattern[str]":
        compiled.append(expression)
        return re.compile(expression, flags)

    monkeypatch.setattr(patterns, "compiled", noted)
    pattern.cache_clear()
    late = pattern(EXPRESSION, re.IGNORECASE, needs="crc|seed")
    assert late.search("a size") is None
    assert compiled == []
    assert late.search("a CRC") is not None
    assert late.search("a Seed") is not None
    assert compiled == [EXPRESSION]
    assert pattern(EXPRESSION, re.IGNORECASE, needs="crc|seed") is late
