"""Candidates: what may be said and contradicts the dialect, each with what speaks for that it is said."""

from collections import defaultdict
from collections.abc import Iterator

from codegen.claims.elsewhere import is_elsewhere
from codegen.claims.evidence import FIRM, evidence_of
from codegen.claims.known_names import near_fields
from codegen.claims.parts.span import Span, head_of
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import is_aside, is_denial, is_excepted, is_own_column
from codegen.claims.rules import NO_FIELD, as_sure
from codegen.claims.weighed.blocks import numbered_blocks
from codegen.claims.weighed.compared import compared
from codegen.claims.weighed.comparison import Comparison, traits
from codegen.claims.weighed.entities.read import statements
from codegen.claims.weighed.entities.statement import Statement
from codegen.claims.weighed.names import strangers
from codegen.claims.weighed.pairs import ATOMS, Pair, pairs
from codegen.claims.weighed.senses import senses
from codegen.claims.weighed.traits import around, around_statement
from codegen.diagnostics import Diagnostic, did_you_mean
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.once import once


@dataclass(frozen=True, slots=True)
class Candidate:
    """A finding that is not said yet: of which kind, about which field, and what speaks for it or against it.

    ``field`` is empty where it is about the message as a whole, or about a command.
    """

    kind: str
    message: str
    field: str
    written: str
    finding: Diagnostic
    traits: frozenset[str]


@dataclass(frozen=True, slots=True)
class _Met:
    """A pair with what is compared, in a list, a table or a block of code that has a number."""

    block: int
    pair: Pair
    comparison: Comparison


def candidates(reading: Reading) -> Iterator[Candidate]:
    """Yield all candidates of a document."""
    met = list(_met(reading))
    agreeing: dict[tuple[int, str], set[object]] = defaultdict(set)
    differing: dict[tuple[int, str], set[object]] = defaultdict(set)
    for each in met:
        group = agreeing if each.comparison.is_right else differing
        group[each.block, each.comparison.kind].add((id(each.pair.span), each.pair.at))
    for each in met:
        if not each.comparison.is_right:
            key = each.block, each.comparison.kind
            yield from _candidate(reading, each, len(agreeing[key]), len(differing[key]))
    yield from _names(reading)
    yield from _statements(reading)


def _met(reading: Reading) -> Iterator[_Met]:
    for block, span in numbered_blocks(spans(reading)):
        if any(letter in span.text for letter in "FP"):
            for pair, comparison in _compared(reading, span):
                yield _Met(block, pair, comparison)


def _compared(reading: Reading, span: Span) -> Iterator[tuple[Pair, Comparison]]:
    """Yield what is compared in a part."""
    if any(letter in span.text for letter in ATOMS):
        for pair in pairs(reading, span):
            yield from ((pair, comparison) for comparison in compared(reading, pair))
    yield from senses(reading, span)


def _candidate(reading: Reading, met: _Met, agreeing: int, differing: int) -> Iterator[Candidate]:
    """The candidate of a pair; none of what is said elsewhere, or called wrong."""
    pair, compared_with = met.pair, met.comparison
    if _is_aside(pair):
        return
    place, one, written = (
        pair.span.place(pair.at),
        pair.one,
        pair.term.written if pair.at in pair.span.sentence.terms else "",
    )
    rule = as_sure(compared_with.rule, is_sure=False)
    finding = reading.found(rule, place, f"{one.name} {written} weighed", compared_with.text)
    if place.line in _called_wrong(reading) or is_elsewhere(reading, finding):
        return
    tied = evidence_of(reading, finding)
    others = (*_agreement(agreeing, differing), *traits(tied=tied in FIRM))
    found = around(reading, pair, compared_with.kind) | {*compared_with.traits, *others, f"by {tied.value}"}
    yield Candidate(compared_with.kind, one.message.name, one.field.name, written, finding, found)


def _is_aside(pair: Pair) -> bool:
    """Return whether a column or a sentence is about other things than the messages of the dialect."""
    span = pair.span
    if is_excepted(span.text, pair.name):
        return True
    if span.kind is PassageKind.ROW:
        return is_own_column(head_of(span, pair.at))
    return not (span.is_code and not span.is_comment) and (is_aside(pair.sentence) or is_denial(pair.sentence))


def _names(reading: Reading) -> Iterator[Candidate]:
    """The candidates of names that no message of the document has a field of."""
    rule = as_sure(NO_FIELD, is_sure=False)
    for each in strangers(reading):
        text = f"{each.message.name} has no field {each.name}"
        hint = did_you_mean(each.name, [field.name for field in each.message.fields])
        finding = reading.found(rule, each.place, f"{each.message.name} {each.name}", text, hint)
        if each.place.line not in _called_wrong(reading) and not is_elsewhere(reading, finding):
            near = near_fields(each.name, each.message)
            yield Candidate("no field", each.message.name, each.name, near[0] if near else "", finding, each.traits)


def _statements(reading: Reading) -> Iterator[Candidate]:
    """The candidates of numbers of messages, of entries, parameters and the like."""
    for each, agreeing, differing in statements(reading):
        yield from _of_statement(reading, each, agreeing, differing)


def _of_statement(reading: Reading, each: Statement, agreeing: int, differing: int) -> Iterator[Candidate]:
    """The candidate of a statement; none of what is said elsewhere, or called wrong."""
    span, place = each.span, each.span.place(each.at)
    is_own = span.kind is PassageKind.ROW and is_own_column(head_of(span, each.at))
    if is_own or is_excepted(span.text, each.at):
        return
    rule = as_sure(each.rule, is_sure=False)
    finding = reading.found(rule, place, f"{each.message} {each.field} {each.written} weighed", each.text)
    if place.line in _called_wrong(reading) or is_elsewhere(reading, finding):
        return
    found = around_statement(each) | {*each.traits, *_agreement(agreeing, differing)}
    yield Candidate(each.kind, each.message, each.field, each.written, finding, found)


@once
def _called_wrong(reading: Reading) -> frozenset[int]:
    """The lines of what the document itself calls wrong."""
    return reading.quoted_as_wrong


def _agreement(agreeing: int, differing: int) -> tuple[str, ...]:
    """The traits of how many in the same block agree with the dialect, and how many do not."""
    return traits(
        others_agree=agreeing,
        several_agree=agreeing >= 3,
        several_differ=differing >= 3,
        most_agree=agreeing >= differing,
        nearly_all_agree=agreeing >= 4 * differing,
    )
