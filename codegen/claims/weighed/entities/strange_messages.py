"""Names in capitals that are those of no message, and that begin as one does, or stand where one would."""

from collections.abc import Iterator, Mapping

from codegen.claims.known_names import Names, is_unknown, names_of
from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.unknown_names import NO_MESSAGE
from codegen.claims.weighed.comparison import traits
from codegen.claims.weighed.entities.statement import Statement, piece
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import Dialect
from codegen.once import once
from codegen.pattern import pattern

_ID = pattern(r"[` ]*\((?:id |#|message )?N\)")
_CALLED = pattern(r"\b(?:messages?|msg|packets?)\b")
_SENT = pattern(
    r"\b(?:sends?|sent|stream\w*|request\w*|answer\w*|repl(?:y|ies|ied)|receiv\w*|publish\w*|subscrib\w*|emit\w*|broadcast\w*"
    r"|decod\w*|handl\w*|arriv\w*|carries|contains|reports?|chopped into|became of|listen\w*)\b"
)
_ELSE = pattern(
    r"\b(?:param\w*|macro|constant|define|topic|enum|entry|flag|bit|option|setting|variable|command|register)s?\b"
)
_BESIDE = pattern(
    r"\b(?:macro|constant|define|topic|enum|entry|flag|bit|option|setting|variable|command|param\w*|function)s? $"
)
"""Before the name of something else."""
_LEAD = 14
_LEAST = 2


def strange_messages(reading: Reading, span: Span) -> Iterator[Statement]:
    """Yield the names in capitals of a part that may be meant for messages."""
    if not reading.sightings:
        return
    names = _names(reading)
    document = _document(reading)
    for at, term in span.sentence.within(0, len(span.text), "C"):
        name = term.written
        words = name.split("_")
        if len(words) < _LEAST or not is_unknown(name, names) or name.startswith(("MAVLINK_MSG", "MSG_")):
            continue
        starts = _starts(reading.reference.dialect)
        kin = starts.get("_".join(words[:2]), ()) or starts.get(words[0], ())
        if not kin:
            continue
        low, high = piece(span, at)
        if _BESIDE.search(span.text, max(low, at - _LEAD), at):
            continue
        near = max(kin, key=lambda each: len(set(each.split("_")) & set(words)) - abs(len(each) - len(name)) / 100)
        text = span.text[low:high]
        found = traits(
            two_words_in_common=tuple(words[:2]) == tuple(near.split("_")[:2]),
            most_words_in_common=len(set(near.split("_")) & set(words)) >= len(words) - 1,
            like_one_of_the_document=near in document,
            family_of_document=any(each.startswith(f"{words[0]}_") for each in document),
            id_behind=_ID.match(span.text, at + 1),
            called=_CALLED.search(text),
            sent=_SENT.search(text),
            called_beside=_CALLED.search(span.text, max(low, at - 14), min(high, at + 14)),
            called_something_else=_ELSE.search(text),
            other_message=any(span.sentence.within(low, high, "M")),
            longer_than_near=name.startswith(f"{near}_"),
            shorter=near.startswith(f"{name}_"),
            digits=any(character.isdigit() for character in name),
            code_=span.is_code and not span.is_comment,
            first=at - low < 6,
            row_=span.kind is PassageKind.ROW,
            many=len(kin) > 8,
        )
        yield Statement(
            "no message", NO_MESSAGE, span, at, low, high, near, "", False, f"there is no message {name}", "", found
        )


@once
def _names(reading: Reading) -> Names:
    """The names that the document may mean."""
    return names_of(reading)


@once
def _document(reading: Reading) -> frozenset[str]:
    """The messages that the document names."""
    return frozenset(name for _, name in reading.sightings)


@once
def _starts(dialect: Dialect) -> Mapping[str, tuple[str, ...]]:
    """The messages by their first word, and by their first two."""
    found: dict[str, list[str]] = {}
    for name in dialect.messages:
        words = name.split("_")
        for start in {words[0], "_".join(words[:2])}:
            found.setdefault(start, []).append(name)
    return {start: tuple(those) for start, those in found.items()}
