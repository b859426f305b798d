"""Claims about fields: type, length, unit, factor, value for unknown, extension, enum, place on the wire."""

import re
from collections.abc import Callable, Collection, Iterator
from fractions import Fraction

from codegen.claims.parts.sentence import NamedField, StatedType, Term
from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.statements.subjects import About, about
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField
from codegen.once import once
from codegen.pattern import pattern

_JOIN = r"(?:,? (?:and|or|to|through|as well as) |, ?| ?/ ?| ?& ?| ?\+ ?| ?\.\.\.? ?| ?\u2026 ?| ?[-\u2013] ?)"
_GROUP = pattern(rf"[FP](?:{_JOIN}[FP])*")
_BEGINS = pattern(
    r"[\s|*#/>.!<-]*(?:(?:the |a |field |fields |its |both |column |member |new |pub |let |mut |const |readonly "
    r"|public |private )*)"
)
_SUBJECT = pattern(
    r"\)?(?: (?:field|fields|value|values|member|members))?(?: of M)?[,]? (?:is|are|has|have|holds?|counts?"
    r"|comes?|stands?|takes?|uses)\b"
)


_SENTENCE = pattern(r"[.!?:] (?:the )?$")
_FIELD_CELL = pattern(r"\|\s*(?:M ?)?F(?: ?[,/&] ?F)*(?: ?\([^|]*\))?\s*(?=\||$)")
_MEMBER = pattern(r"[a-z_]\.$")
"""Before the name of a member of another thing, ``T_wb.q``."""
_OF_ANOTHER = pattern(r"\b(?:to|of|from|above|over|behind|below|for|at|on|by) the $")
"""Before an everyday word that tells more of another thing: "the distance to the target is ..."."""
_EXCEPT = pattern(
    r"\b(?:all but|except(?: for)?|apart from|other than|besides|unlike|other messages [^.]{0,20}) (?:the )?$",
    needs="all but|apart|besides|except|other messages|other than|unlike",
)


_CONTRAST = pattern(
    r"\b(?:where|while|whereas|unlike|but|as) (?:in )?(?:the|its|their|that) (?:(?!and\b)[a-z]+ ){0,2}?"
    r"(?:ones?|others?|latter|former)\b",
    needs="former|latter|one|other",
)
"""A clause about another thing of the same name: "`lat_int` is an integer where the local one has a float"."""


@dataclass(frozen=True, slots=True)
class Said:
    """One or several fields that a text tells of: their offsets, and the bounds of the words that follow them."""

    span: Span
    names: tuple[int, ...]
    start: int
    end: int
    until: int
    before: int

    @property
    def is_listed(self) -> bool:
        """Return whether the part is an item, a row or a comment, in which a comma ends a statement."""
        return self.span.kind in (PassageKind.ITEM, PassageKind.ROW) or self.span.is_code


@once
def said_of_fields(span: Span) -> tuple[Said, ...]:
    """Every group of names of fields in a part, with what is said of it."""
    return tuple(_said(span))


def _said(span: Span) -> Iterator[Said]:
    groups = [found for found in _GROUP.finditer(span.text) if _is_name(span, found)]
    groups = [found for found in groups if not _TURNED_INTO.search(span.text, max(found.start() - 6, 0), found.start())]
    groups = [found for found in groups if span.is_code or not _MEMBER.search(span.text, 0, found.start())]
    groups = [found for found in groups if not _EXCEPT.search(span.text, max(found.start() - 40, 0), found.start())]
    for index, found in enumerate(groups):
        following = groups[index + 1].start() if index + 1 < len(groups) else len(span.text)
        until = max(min(span.end_of(found.end()), following, found.end() + 400), found.end())
        if is_data(span):  # what belongs to a field ends with its braces
            until = min(
                until,
                (span.text[found.end() : until] + "}").index("}") + found.end()
                if "{" not in span.text[found.end() : until]
                else until,
            )
        other = _CONTRAST.search(span.text, found.end(), until) if not span.is_code else None
        until = other.start() if other is not None else until
        names = tuple(offset for offset in range(found.start(), found.end()) if span.text[offset] in "FP")
        before = groups[index - 1].end() if index else 0
        yield Said(span, names, found.start(), found.end(), until, before)


def _is_name(span: Span, found: "re.Match[str]") -> bool:
    """Return whether a group names fields: an everyday word that happens to be a name needs more around it."""
    text = span.text
    if "F" in found[0]:
        again = _FIELD_CELL.search(text, found.end()) if span.kind is PassageKind.ROW else None
        names = {term.written for _, term in span.sentence.within(*again.span(), "F")} if again is not None else set()
        return span.sentence.term(found.start()).written not in names
    if found[0].count("P") >= _SEVERAL and not span.is_code and span.kind is not PassageKind.ROW:
        return True  # "x, y, z": several such words in a row
    lead = _BEGINS.match(text)
    begins = lead is not None and lead.end() >= found.start()
    behind = text[found.end() : found.end() + 3].lstrip(" ")[:1]
    if span.is_code:
        return (
            begins
            or behind in (":", "=", ";", ",")
            or text[max(found.start() - 40, 0) : found.start()].endswith(("T ", "T", ": ", "# ", "// "))
        )
    if span.kind is PassageKind.ROW and _FIELD_CELL.search(text, found.end()):
        return False  # the other side of a mapping
    if span.kind is PassageKind.ROW:
        return text[max(found.start() - 40, 0) : found.start()].rstrip().endswith("|") or begins
    if begins and span.kind is PassageKind.ITEM and behind in ("", "(", ":", ",", "=", "-", "\u2013", "\u2014", "["):
        return True
    if len(found[0]) > 3 and pattern(r" (?:are )?(?:all )?in U").match(text[found.end() : found.end() + 14]):
        return True
    is_first = begins or _SENTENCE.search(text, max(found.start() - 8, 0), found.start()) is not None
    if is_first and span.kind is PassageKind.TEXT and _SUBJECT.match(text, found.end()):
        return True
    before = text[max(found.start() - 40, 0) : found.start()]
    is_called = before.endswith((" field ", "the ", "its ", "field ")) and not _OF_ANOTHER.search(before)
    if _LIMITED.match(text, found.end()):
        return True
    return bool(is_called and _SUBJECT.match(text, found.end())) or text[found.end() : found.end() + 6] in (
        " field",
        " array",
    )


_TURNED_INTO = pattern(r"[FP] ?(?:\u2192|->|=>) ?$")
"""Before the name that a field has elsewhere: "`uas_id` -> `id`"."""
_LIMITED = pattern(r" (?:of |is |has )?(?:at most|up to|no more than) N (?:bytes|characters|chars|elements|entries)\b")
"""Behind a word that is the name of an array."""
_SEVERAL = 3
"""Everyday words that are names of fields, and hardly anything else where so many stand together."""


def each_about(reading: Reading, said: Said) -> list[tuple[int, About]]:
    """The fields of a group with their messages; those that no message has are left out."""
    found = [(offset, about(reading, said.span, offset)) for offset in said.names]
    return [(offset, one) for offset, one in found if one is not None]


def claimed(reading: Reading, said: Said, offset: int, fits: Callable[[WireField], bool]) -> About | None:
    """Return a named field that a claim is wrong for: the last one, or any where all are meant; else None."""
    found = each_about(reading, said)
    gap = said.span.text[said.end : offset] if offset >= said.end else ""
    is_of_all = len(said.names) > 1 and re.match(
        r"\s*(?:[:|(\[=\u2013-]|\)? ?(?:are|both|all|each|have|hold)\b|# )", gap
    )
    if is_of_all and gap.strip() == "(" and pattern(r"\band\b").search(said.span.text[said.start : said.end]):
        is_of_all = None  # "`a` and `b` (uint32)" may be said of the last one only
    for at, one in found if is_of_all else found[-1:]:
        if at in said.names and one.is_wrong(fits):
            return one
    return None


def made_of(text: str, words: Collection[str]) -> bool:
    """Return whether every word of a text is in a set."""
    return all(word in words for word in pattern(r"[A-Za-z]+").findall(text))


def number(term: Term) -> int | float | Fraction | None:
    """The number of a term."""
    return term.value if isinstance(term.value, int | float | Fraction) else None


def stated_type(term: Term) -> StatedType:
    """The type of a term."""
    assert isinstance(term.value, StatedType)
    return term.value


def named(term: Term) -> NamedField:
    """The name of a field that a term is."""
    assert isinstance(term.value, NamedField)
    return term.value
