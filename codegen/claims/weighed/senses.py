"""Ways, levels and orders in the reach of a field's name, without what a rule asks of the words between."""

from collections.abc import Iterator

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import SENSE
from codegen.claims.statements.fields import said_of_fields
from codegen.claims.statements.senses.stated import told_of
from codegen.claims.statements.senses.words import Sense, has_other_way, levels, signs
from codegen.claims.weighed.comparison import Comparison
from codegen.claims.weighed.pairs import Pair, bounds, field_at, is_line

_FAR = 250
"""The greatest distance of such words from the name of their field, in characters."""


def senses(reading: Reading, span: Span) -> Iterator[tuple[Pair, Comparison]]:
    """Yield each way of counting behind the names of fields whose descriptions tell of it."""
    for said in said_of_fields(span):
        end = said.until if is_line(span) else span.end_of(said.end)
        pieces = _pieces(span, said.end, min(end, said.end + _FAR))
        words = "".join(pieces).lower()
        found = [*signs(words), *levels(words)]
        field = field_at(reading, span, said.names[-1]) if found else None
        if field is None:
            continue
        one, is_loose = field
        known = told_of(one.message, one.field)
        for sense in found:
            own = known.get(sense.axis)
            others = [other.pole for each in one.others if (other := told_of(one.message, each).get(sense.axis))]
            if own is None or has_other_way(sense, words) or (own.pole != sense.pole and sense.pole in others):
                continue
            at = said.end + _piece(pieces, sense.start)
            low, high = bounds(span, at)
            pair = Pair(span, said.names[-1], one, at, low, high, "before", len(said.names), is_loose, is_word=False)
            yield pair, _compared(pair, own, sense)


def _compared(pair: Pair, own: Sense, sense: Sense) -> Comparison:
    text = f'{pair.one.name}: the dialect says "{own.words}", not "{sense.words}"'
    return Comparison("sense", SENSE, own.pole == sense.pole, text, (f"of {sense.axis}",))


def _pieces(span: Span, low: int, high: int) -> list[str]:
    terms = span.sentence.terms
    return [terms[at].written if at in terms else span.text[at] for at in range(low, high)]


def _piece(pieces: list[str], offset: int) -> int:
    """The number of the piece in which a character stands."""
    end = 0
    for place, piece in enumerate(pieces):
        end += len(piece)
        if offset < end:
            return place
    return max(len(pieces) - 1, 0)
