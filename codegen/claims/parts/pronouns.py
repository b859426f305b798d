"""Sentences that go on about a field without its name: "it is in mm", "both are int64", "set it to 36000 if ...".

A reader puts the name for the pronoun, and so does this: a pronoun of the next sentence becomes the term that the
sentence before it is about, so that every form of statement finds it there.
"""

import re
from collections.abc import Iterator
from dataclasses import replace

from codegen.claims.parts.sentence import NamedField, Sentence, Term
from codegen.pattern import pattern

_JOIN = r"(?:,? (?:and|or|to) |, ?| ?/ ?| ?& ?)"
_GROUP = pattern(rf"F(?:{_JOIN}F)*")
_BREAK = pattern(r"(?<!\be\.g)(?<!\bi\.e)(?<!\bca)(?<!\bapprox)(?<!\bmax)(?<!\bmin)[.!?](?=\s|$)")
_ONE = (
    r"\bit\b(?! is (?:\w+ )?(?:that|possible|important|easy|necessary|better|enough|not the)\b)"
    r"|(?<=divide )(?:the )?(?:raw )?(?:value|number|byte|field|count|it)\b|(?<=multiply )(?:the )?(?:raw )?(?:value"
    r"|number|byte|field|count|it)\b"
    r"|\bthe (?:latter|last one)\b|\b(?:that|this) one\b"
    r"|\b(?:the|this|that) (?:field|value|unit|number|array|list|text|string)(?= (?:is|has|comes?|goes|runs|counts?"
    r"|holds?|carries|ends|stays|reads|stands)\b)"
)
_MANY = r"\b(?:they|them|both|these|all (?:of them|three|four))\b(?! F)"
_PRONOUN = pattern(rf"(?P<one>{_ONE})|(?P<many>{_MANY})")
_FACTOR = pattern(r"\b(?:divide|multiply) $")
_OBJECT = pattern(r"\b(?:set|sets|fill|fills|leave|leaves|write|writes|send|sends|put|puts) $")
_LEAD = pattern(r"[^a-zA-Z]*(?:[a-z']{1,12} ){0,2}|.*[,:] (?:(?:and|but|so|then|otherwise|else|where|when|if) )?")
_NO_SUBJECT = pattern(
    r"\b(?:with|without|of|to|for|from|by|in|on|at|than|as|into|like|before|after|times|use|see|read|reads) $"
)
_OTHER_TERMS = frozenset("FMEVC")
_AT_LEAST_TWO = 2
_LATTER = pattern(r"the (?:latter|last one)")
_FAR = 200
"""The greatest distance back to the last name, in characters."""


def with_names(sentence: Sentence) -> Sentence | None:
    """Return a text in which pronouns are the names that they stand for; None where there are none, or it is open."""
    if "F" not in sentence.marked or not (_PRONOUN.search(sentence.marked) or _THE_FIELD.search(sentence.marked)):
        return None
    puts = list(_meant(sentence))
    return _with(sentence, puts) if puts else None


def _meant(sentence: Sentence) -> Iterator[tuple[int, int, list[Term]]]:
    """The bounds of each pronoun with the names that it stands for."""
    text, low = sentence.marked, 0
    before: list[Term] = []
    while low < len(text):
        found = _BREAK.search(text, low)
        high = found.start() if found is not None else len(text)
        letters = {term.letter for _, term in sentence.within(low, high, "FMEVC")}
        pronoun = next((each for each in _PRONOUN.finditer(text, low, high) if _is_subject(text, low, each)), None)
        if pronoun is not None and _LATTER.match(pronoun[0]):
            last = [term for _, term in sentence.within(max(low - _FAR, 0), low, "F")][-1:]
            yield from ((pronoun.start(), pronoun.end(), last),) if last else ()
            before = last
        elif not letters & _OTHER_TERMS:
            if pronoun is None or not _agrees(pronoun, before):
                before = before if pronoun is not None else []
            else:
                yield pronoun.start(), pronoun.end(), before
        else:
            yield from _same_sentence(sentence, low, high)
            before = _subject(sentence, low, high)
        low = high + 1


def _is_subject(text: str, low: int, pronoun: "re.Match[str]") -> bool:
    """Return whether a pronoun is the subject of its sentence or clause, or the object that has to be filled."""
    lead = text[low : pronoun.start()]
    return (
        _FACTOR.search(lead) is not None
        or _OBJECT.search(lead) is not None
        or (_LEAD.fullmatch(lead) is not None and not _NO_SUBJECT.search(lead))
    )


def _same_sentence(sentence: Sentence, low: int, high: int) -> Iterator[tuple[int, int, list[Term]]]:
    """ "Set `interval` to 5000, the field is in ms"."""
    names = [(at, term) for at, term in sentence.within(low, high, "FMEVC")]
    found = _THE_FIELD.search(sentence.marked, low, high)
    if found is None or len(names) != 1 or names[0][1].letter != "F" or found.start() < names[0][0]:
        return
    yield found.start("what"), found.end("what"), [names[0][1]]


_THE_FIELD = pattern(
    r"[,;\u2013\u2014(] ?(?:and |but |because |since |as )?(?P<what>the (?:field|unit)) (?=is|counts|holds|has)",
    needs="the field|the unit",
)


def _agrees(pronoun: "re.Match[str]", before: list[Term]) -> bool:
    """Return whether a pronoun, singular or plural, agrees with the number of names before it."""
    if pronoun["one"]:
        is_raw = pattern(r"\b(?:divide|multiply) $").search(pronoun.string[: pronoun.start()]) is not None
        return len(before) == 1 or (is_raw and bool(before))
    if pronoun["many"] == "both":
        return len(before) == _AT_LEAST_TWO
    return len(before) >= _AT_LEAST_TWO or any(_is_of_many(term) for term in before)


def _is_of_many(term: Term) -> bool:
    return isinstance(term.value, NamedField) and term.value.name.endswith("s")


def _subject(sentence: Sentence, low: int, high: int) -> list[Term]:
    """The names that a sentence is about: its only ones, or those that it begins with."""
    groups = list(_GROUP.finditer(sentence.marked, low, high))
    begins = groups and not pattern(r"[a-z]{3,}[^a-z]+[a-z]{3,}").search(sentence.marked[low : groups[0].start()])
    if len(groups) != 1 and not begins:
        return []
    return [term for _, term in sentence.within(*groups[0].span(), "F")]


def _with(sentence: Sentence, puts: list[tuple[int, int, list[Term]]]) -> Sentence:
    """The text with names put in the place of words."""
    marked: list[str] = []
    at: list[int] = []
    terms: dict[int, Term] = {}
    position = 0

    def keep(low: int, high: int) -> None:
        for offset in range(low, high):
            if offset in sentence.terms:
                terms[len(marked)] = sentence.terms[offset]
            marked.append(sentence.marked[offset])
            at.append(sentence.at[offset])

    for start, end, names in puts:
        keep(position, start)
        for index, term in enumerate(names):
            if index:
                marked += " & "
                at += [sentence.at[start]] * 3
            terms[len(marked)] = replace(term, start=sentence.at[start], end=sentence.at[end - 1] + 1)
            marked.append("F")
            at.append(sentence.at[start])
        position = end
    keep(position, len(sentence.marked))
    return Sentence("".join(marked), tuple(at), terms, tuple(terms))
