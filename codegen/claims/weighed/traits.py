"""Traits that speak for a statement, or against it: its place, the words between, the subject of its sentence."""

from codegen.claims.parts.span import head_of
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import (
    ASKED,
    CHANGED,
    COMPARED,
    CONDITIONAL,
    CONVERTED,
    DENIED,
    MISTAKEN,
    OWN,
    PAST,
    PROPOSED,
    REPLACED,
    SHOWN,
    SUPPOSED,
    TEMPORARY,
    is_aside,
    is_denial,
    words,
)
from codegen.claims.weighed.clauses import clause
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import Statement
from codegen.claims.weighed.pairs import Pair, is_line
from codegen.claims.weighed.words import words_beside, words_between
from codegen.load.prose import PassageKind
from codegen.once import once
from codegen.pattern import pattern

_SENTENCE = {
    "denied": words(DENIED),
    "conditional": words(CONDITIONAL),
    "replaced": words(REPLACED),
    "past": words(PAST),
    "changed": words(CHANGED),
    "mistaken": words(MISTAKEN),
    "supposed": words(SUPPOSED),
    "proposed": words(PROPOSED),
    "own": words(OWN),
    "shown": words(SHOWN),
    "converted": words(CONVERTED),
    "compared": words(COMPARED),
    "temporary": words(TEMPORARY),
    "asked": words(ASKED),
    "scaling": pattern(
        r"\b(?:tenths?|hundredths?|thousandths?|fifths?|steps? of|times|twice|half|divid\w*|multipl\w*|scaled?|factor"
        r"|converts?|converted)\b"
    ),
    "of a device": pattern(
        r"\b(?:reports?|delivers?|outputs?|gives|sensor|driver|device|receiver|frame bytes|register|datagram|nmea|ais"
        r"|ros|from the|their|its own)\b"
    ),
    "demanded": pattern(r"\b(?:shall|must|has to|have to)\b"),
}
"""Words of a whole sentence, by the trait that they give it."""
_ON_THE_WIRE = pattern(r"\b(?:here|on the wire|on the link|in mavlink|field)\b")
_VERB = pattern(r"\b(?:is|are|has|have|comes?|goes|counts?|holds?|takes?)\b")
_AND = pattern(r"\b(?:and|but|while)\b")
_IDLE = pattern(
    r"\b(?:is|are|in|a|an|the|as|of|to|be|shall|must|has|have|its|it|value|values|field|with|for|by|at|both|given|sent"
    r"|unit|units|measured|on|or|this|that|when|if|sets?|counts?)\b"
)
_DENIED = pattern(r"(?:\b(?:no|not|never|without)|n't)(?: [a-z]+){0,2} $")
_SIGN = pattern(r"[*/+\u00d7\u00f7=]")
_WORD = pattern(r"\w+")
_LETTER = pattern(r"[A-Za-z]")
_SMALL = pattern(r"[a-z]")
_MESSAGE_FIRST = pattern(r"[\s|*-]*M\b")
_REMARKS = pattern(r"note|comment|remark|meaning|description|text|requirement|rule|what")
_SOURCES = pattern(r"source|input|from|their|sensor|device|nmea|bus|register|gives|raw")
_DATA = ("json", "yaml", "yml", "toml")
_DENYING = ("denied", "conditional")
"""Traits that say nothing against a value for unknown."""


def around(reading: Reading, pair: Pair, kind: str) -> frozenset[str]:
    """Return the traits of a pair by all that stands around it, for a statement of some kind."""
    found = [*_form(pair), *_tie(reading, pair), *_between(pair), *_said(pair, kind)]
    column = _column(pair) if pair.span.kind is PassageKind.ROW else ()
    words_there = words_beside(pair.span, pair.at, pair.low, pair.high) | words_between(pair.gap)
    return frozenset([pair.side, *found, *column]) | words_there


def around_statement(statement: Statement) -> frozenset[str]:
    """Return the traits of a statement by the form of its part and the sense of the words around it."""
    found = [*_form(statement), *_said(statement, statement.kind)]
    column = _column(statement) if statement.span.kind is PassageKind.ROW else ()
    words_there = words_beside(statement.span, statement.at, statement.low, statement.high)
    return frozenset([*found, *column]) | words_there


def _form(pair: Pair | Statement) -> tuple[str, ...]:
    """The form of the part."""
    span, length = pair.span, pair.high - pair.low
    return traits(
        code=span.is_code and not span.is_comment,
        comment=span.is_comment,
        row=span.kind is PassageKind.ROW,
        item=span.kind is PassageKind.ITEM,
        paragraph=span.kind is PassageKind.TEXT and not span.is_code,
        data=span.language in _DATA,
        short=length < 60,
        long=length > 160,
        message_first=_MESSAGE_FIRST.match(span.text),
    )


def _tie(reading: Reading, pair: Pair) -> tuple[str, ...]:
    """The ties of the name to a field of one message."""
    span, one = pair.span, pair.one
    named = [name for _, name in span.named(pair.low, pair.high)]
    holders, messages = _holders(reading).get(one.field.name, 1), len(_named(reading))
    headings, above = span.topic.headings, span.topic.above
    return traits(
        word=pair.is_word,
        name=pair.named.letter == "F",
        sure=one.is_sure,
        loose=pair.is_loose,
        only_holder=holders <= 1,
        only_message=messages == 1,
        many_messages=messages >= 4,
        message_in_sentence=one.message.name in named,
        another_message=any(name != one.message.name for name in named),
        heading=bool(headings) and headings[0].name == one.message.name,
        above=bool(above) and above[0].name == one.message.name,
        nothing_above=not headings and not above,
        qualified=getattr(pair.named.value, "message", None) is not None,
    )


@once
def _named(reading: Reading) -> tuple[str, ...]:
    """The messages that a document names."""
    return tuple(dict.fromkeys(name for _, name in reading.sightings))


@once
def _holders(reading: Reading) -> dict[str, int]:
    """The number of messages of a document that have a field, by its name."""
    found: dict[str, int] = {}
    for message in _named(reading):
        for field in reading.messages[message].fields:
            found[field.name] = found.get(field.name, 0) + 1
    return found


def _between(pair: Pair) -> tuple[str, ...]:
    """The words, the names and the marks between a name and a term."""
    gap, text = pair.gap, pair.span.text
    many = len(_WORD.findall(gap))
    return traits(
        beside=many <= 1,
        near=many <= 3,
        not_far=many <= 7,
        far=many > 12,
        field_between=pair.several == 1 and any(letter in gap for letter in "FP"),
        several_fields=pair.several > 1,
        message_between="M" in gap,
        name_between=any(letter in gap for letter in "CEV"),
        unit_between=any(letter in gap for letter in "UTQ"),
        number_between=any(letter in gap for letter in "NS"),
        bar="|" in gap,
        comma="," in gap,
        semicolon=";" in gap,
        colon=":" in gap,
        parenthesis="(" in gap,
        full_stop=". " in gap,
        arrow="\u2192" in gap or "->" in gap,
        conjunction=_AND.search(gap),
        only_links=not _SMALL.search(_IDLE.sub("", gap)),
        verb=_VERB.search(gap),
        arithmetic=_SIGN.search(gap),
        denied_before=_DENIED.search(pair.before(30)),
        first=not _LETTER.search(text[pair.low : pair.name].replace("the", "")),
    )


def _said(pair: Pair | Statement, kind: str) -> tuple[str, ...]:
    """The sense of the words of the sentence, and of those of the clause."""
    span, sentence = pair.span, pair.sentence
    low, high = clause(span.text, pair.at, pair.low, pair.high)
    here = span.text[low:high]
    of_sentence = [name for name, form in _SENTENCE.items() if form.search(sentence)]
    if kind == "sentinel":
        of_sentence = [name for name in of_sentence if name not in _DENYING]
    is_question = not is_line(span) and span.text[pair.high : pair.high + 1] == "?"
    return (
        *of_sentence,
        *traits(
            question_behind="?" in span.text[pair.at : pair.high + 3],
            question=is_question or "?" in here,
            answer=not is_line(span) and span.text[max(pair.low - 1, 0) : pair.low] == "?",
            scaling_in_clause=_SENTENCE["scaling"].search(here),
            on_the_wire=_ON_THE_WIRE.search(here),
            of_a_device_in_clause=_SENTENCE["of a device"].search(here),
            aside=is_aside(sentence) or is_denial(sentence),
            same_clause=low <= pair.name < high,
        ),
    )


def _column(pair: Pair | Statement) -> tuple[str, ...]:
    """The sense of the heading of a column."""
    head = head_of(pair.span, pair.at).lower()
    return traits(
        column_of_remarks=_REMARKS.search(head),
        column_of_units="unit" in head,
        column_of_types="type" in head,
        column_of_sources=_SOURCES.search(head),
    )
