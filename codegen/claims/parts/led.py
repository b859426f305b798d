"""Fields that a heading names, or a question: they are the subject of the next paragraph."""

from dataclasses import replace

from codegen.claims.parts.sentence import Sentence, Term
from codegen.pattern import pattern

_ONLY_NAMES = pattern(
    r"[^a-zA-Z]*(?:N\)? )?(?:the )?(?:fields? )?(?P<names>[FP](?:(?:, ?| and | ?/ ?"
    r"| ?& ?)[FP])*)(?: fields?)?(?: ?\(.*\)"
    r"|:? T(?:\W|U)*)?[^a-zA-Z]*"
)
_QUESTION = pattern(
    r"(?:[^?]*[.!?] )?(?:[^a-zA-Z]*)(?:what|how|which|why)\b[^.?!]{0,60}?(?P<names>F(?:(?:, ?| and )F)*)[^.?!]{0,24}\?"
)


def names_leading(sentence: Sentence, *, is_heading: bool) -> list[Term]:
    """Return the names of fields that a heading consists of, or that a question is about."""
    found = (_ONLY_NAMES if is_heading else _QUESTION).fullmatch(sentence.marked.strip())
    if found is None or (is_heading and set(sentence.marked) & set("MEVC")):
        return []
    return [term for _, term in sentence.within(0, len(sentence.marked), "FP")]


def led_by(names: list[Term], sentence: Sentence) -> Sentence:
    """Return a text with the names that lead it before it: "`alt`: int32_t, mm above the sea"."""
    if not sentence.at:
        return sentence
    first = sentence.at[0]
    marked = ", ".join("F" for _ in names) + ": "
    terms = {3 * index: replace(term, letter="F", start=first, end=first) for index, term in enumerate(names)}
    terms |= {offset + len(marked): term for offset, term in sentence.terms.items()}
    at = (first,) * len(marked) + sentence.at
    return Sentence(marked + sentence.marked, at, terms, tuple(terms))
