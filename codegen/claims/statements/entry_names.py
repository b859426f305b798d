"""Entries by their names beside a number: "ENTRY (3)", "3 is ENTRY", "ENTRY, which is 3"."""

import re
from collections.abc import Iterator

from codegen.claims.enum_names import entry_values
from codegen.claims.parts.span import Span, head_of
from codegen.claims.reading import Reading
from codegen.claims.rules import ENTRY_VALUE, as_sure
from codegen.claims.statements.fields import number
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_NAMED = (
    pattern(
        r"(?P<name>V)(?: ?(?:\(|=|:|\||->|\u2192|[;,)]+ *(?://|#|/\*)) ?|,? (?:(?:which|that|it) )?(?:is|has|equals"
        r"|as)(?: the)?(?: value| number| bit| code"
        r"| mask| command| cmd)*(?: of)? |,? \(?(?:command|value|number|code|cmd)(?: id)?(?: is)? |, i\.?e\.?,?"
        r" )(?P<value>N)(?![\w.]\d| ?(?:bytes|hz|%)|\s?[-+*/] ?N)"
    ),
    pattern(r"(?<!, )(?P<name>V), (?P<value>N)(?=\s*(?:[.;)]|$|, (?:for|as|in|is)\b))"),
    pattern(r"(?P<value>N)(?: is| means| for| =|:)? (?:an? |the )?(?:[a-z]+|P)(?: (?:[a-z]+|P)){0,4} \((?P<name>V)\)"),
    pattern(
        r"(?P<value>N)(?: ?(?:\(|=|:|\||->|\u2192|,|\u2013|-) ?| |,? (?:is|means|stands for|for|that is|which is"
        r"|this is"
        r"|meaning|i\.e\.|names)(?: the)? )(?P<name>V)(?! ?[=(:|] ?N)(?! ?(?:\||\+|&|and|plus) ?V)"
    ),
)
_AFTER_NAME = pattern(r"V(?: ?[(=:,]? ?| is | has )$")
_VALUE_HEAD = pattern(
    r"^$|value|numbers?\b|\bnum\b|\bno\.?$|\bids?\b|\bcodes?\b|\bbits?\b|\bdec|\bhex|\bmask|#|wire|entry|content"
    r"|source|sent|example|meaning|enum|default|is\b",
    re.IGNORECASE,
)
_NUMBER_FIRST = pattern(r"(?:^|[^V\s,]|\bor|\band),? ?N ?[=:]? ?V,? ?(?:and |or )?$")
_LIST = 24


_ROW = pattern(r"V (?:(?:is|has|=) )?N(?:(?:, (?:and )?| and )V (?:(?:is|has|=) )?N){2,30}")


def _listed(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "NAME is 0, NAME 2, NAME 3 and NAME 4", of which most are right."""
    for found in _ROW.finditer(span.text) if not span.is_code else ():
        terms = [*span.sentence.within(*found.span(), "VN")]
        told = [(name.written, at, term) for (_, name), (at, term) in zip(terms[::2], terms[1::2], strict=True)]
        own = entry_values(reading.enums)
        wrong = [(name, at, term) for name, at, term in told if own.get(name, number(term)) != number(term)]
        for name, at, term in wrong if 2 * len(wrong) < len(told) else ():
            text = f"{name} is {own[name]}, not {term.written}"
            yield reading.found(as_sure(ENTRY_VALUE, is_sure=False), span.place(at), f"{name} {term.written}", text)


def named(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Entries by their names, or by the end of their names, beside a number."""
    if "V" not in span.text:
        return
    yield from _listed(reading, span)
    values = entry_values(reading.enums)
    for form in _NAMED:
        for found in form.finditer(span.text):
            if (
                form is _NAMED[-1]
                and not _begins_with_number(span, found.start())
                and _AFTER_NAME.search(span.text, max(found.start() - 12, 0), found.start())
            ):
                continue  # "FIRST 1, SECOND 2"
            if span.is_code and not span.is_comment and _CHOICE.search(span.text, 0, found.start() + 1):
                continue
            if _is_beside_by_chance(span, *sorted((found.start("name"), found.start("value")))):
                continue
            name = span.sentence.term(found.start("name")).written
            yield from _value(reading, span, name, values.get(name), found)
    if span.is_code and not span.is_comment:
        comment = pattern(r"(?:#|//|/\*) ?(?:M |(?:[a-z_]+|[FP]): ?)?(?P<name>V)\b").search(span.text)
        stated = pattern(r"^(?:[^#/]*?[=:( ])? ?(?P<value>N)[,;)]*\s*(?=(?:#|//|/\*))").search(span.text)
        if comment is not None and stated is not None and len(list(span.sentence.within(0, comment.start(), "N"))) == 1:
            name = span.sentence.term(comment.start("name")).written
            yield from _value(reading, span, name, values.get(name), stated)


def _is_beside_by_chance(span: Span, low: int, high: int) -> bool:
    """Return whether a comma only divides a name and a number: arguments of a call, elements of a list of code.

    A pair in brackets of its own, ``{NAME, 3}``, and a line of comma-separated values belong together.
    """
    text = span.text
    if text[low + 1 : high].strip() != ",":
        return False
    if _CALLED.search(text, 0, low) or _IN_LIST.search(text, 0, low) or pattern(r", [NQSV]\b").match(text[high + 1 :]):
        return True
    if not span.is_code or span.is_comment:
        return False
    is_pair = pattern(r"(?<![\w)\]])[({\[] ?$").search(text[:low]) and pattern(r" ?[)}\]]").match(text[high + 1 :])
    is_table = span.language in _OF_VALUES and not pattern(r"[({\[]").search(text)
    return not (is_pair or is_table)


_CHOICE = pattern(r"\?[^?:;]*[NV]$")
"""The first of two values of which a condition chooses one: "ok ? 0 : NAME"."""
_CALLED = pattern(r"[\w\])>]\((?:[^()]|\([^()]*\))*$")
"""The open parenthesis of a call."""
_IN_LIST = pattern(r"\b[NQSV], $")
"""A longer list, of which nobody can tell what belongs to what: "3, NAME, 0"."""
_OF_VALUES = ("", "csv", "tsv", "text", "txt")


def _begins_with_number(span: Span, offset: int) -> bool:
    """Return whether a list has its numbers first: "1 FIRST, 2 SECOND"."""
    return _NUMBER_FIRST.search(span.text, max(offset - _LIST, 0), offset) is not None


def _value(reading: Reading, span: Span, name: str, own: int | None, found: "re.Match[str]") -> Iterator[Diagnostic]:
    stated = number(span.sentence.term(found.start("value")))
    is_bit = span.text[max(found.start("value") - 4, 0) : found.start("value")] == "bit "
    if is_bit and stated is not None and stated != own and 0 <= stated < 32:
        stated = 1 << int(stated)
    before = span.text[max(found.start("value") - 24, 0) : found.start("value")]
    if (
        own is None
        or stated is None
        or stated == own
        or stated < 0 <= own  # a value of one of its parameters: "NAME has -1 for no change"
        or re.search(
            r"\b(?:component|system|(?<!command )id|param\w*|than|after|about|least|most|up to|channel|instance"
            r"|see|section"
            r"|chapter|not) ?$|[+*<>-] ?$",
            before[:-1] if before.endswith(" ") else before,
        )
    ):
        return
    at = found.start("value")
    cell = span.text[span.text.rfind("|", 0, at) + 1 : (span.text + "|").index("|", at)].strip()
    is_apart = "|" in found[0] and cell != "N"
    if span.kind is PassageKind.ROW and "|" in found[0] and (is_apart or not _VALUE_HEAD.search(head_of(span, at))):
        return
    written = span.sentence.term(found.start("value")).written
    text = f"{name} is {own}, not {written}"
    yield reading.found(ENTRY_VALUE, span.place(found.start("value")), f"{name} {written}", text)
