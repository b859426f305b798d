"""Values that a field is said to have while nothing is known: "without a sensor `alt` is 0", "not known? send -1".

Whatever the words: a sentence that says that something is absent, with one value tied to these words and one field that
it is about, says which value stands for unknown there.
"""

from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.parts.sentence import NamedField
from codegen.claims.parts.span import Span, is_data
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import MISTAKEN, PAST, PROPOSED, REPLACED, words
from codegen.claims.rules import SENTINEL, as_sure
from codegen.claims.statements.fields import number, said_of_fields
from codegen.claims.statements.subjects import About, about
from codegen.claims.statements.unknown import NOTHING, is_unknown
from codegen.claims.unknown_value import described_failures, unknown_values
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.pattern import pattern

_THING = (
    r"(?:sensor|data|fix|gps|estimate|measurement|value|reading|module|receiver|input|signal|device|source|monitor|fan"
    r"|aid|temperature|information|idea|clock|time|probe|thermometer|thermistor|homing|encoder|echo|dop|counter|antenna|compass"
    r"|transponder|camera|estimator|beacon|tracker|gauge|meter|reference)"
)
_ABSENT = pattern(
    rf"\b{NOTHING}|\b(?:no|without an?|without|without any|lacks an?|has no) (?:[a-z]+ ){{0,2}}{_THING}s?\b"
    r"|\b(?:got|gets|had|finds?|sees?|receives?) no [a-z]+|\b(?:loses?|lost) (?:its|the|their|track)\b"
    r"|\bno (?:known |valid |own )?(?:values?|echo|lock|uid|number)\b"
    rf"|\b(?:lacks?|has no) an? |\b(?:fails?|failed|broken|defective|unplugged|disconnected)\b"
    r"|\bnothing\b|\b(?:cannot|can't|do not|don't|does not|doesn't|did not) (?:yet )?(?:fill|know|measure|tell|have"
    r"|report|see|provide|exist)\b"
    r"|\buntil (?:an? |the )?[a-z]+ is (?:known|there|available)|\bno [a-z]+ (?:is|are|on|in|at|was|has been)\b"
    r"|\b(?:has|have|is|was) not (?:yet )?(?:been )?(?:[a-z]+ )?(?:reported|measured|fitted|connected|computed|set"
    r"|seen|received)\b"
)
_TOLD = pattern(
    r"unknown|invalid|\bmarks?\b|sentinel|no data|not (?:known|available|measured|valid)|n't know|not know|unused"
    r"|unavailable"
    r"|missing|absent|\bcannot\b|nothing is|no sensor|\bwithout (?:any |an? )?(?:measurement|sensor|data|value"
    r"|estimate|probe|thermometer|thermistor|receiver|fix|homing|encoder|reference)|\bno (?:fix|echo|lock|reading"
    r"|dop|known [a-z]+)\b|does(?: not|n't)|until a|\bno (?:known |valid )?value\b|\blo(?:st|ses?) (?:its"
    r"|the) reference|there (?:is|are) no |\bfail|\bbroken"
)
_NEGATED = pattern(r"(?:\bnot|\bnever|n't|\bcannot) (?:[a-z]+ ){0,3}$|\brather than $|\bno longer [a-z ]{0,20}$")
_RULED_OUT = words(
    PAST, MISTAKEN, PROPOSED, REPLACED[:1], r"\bnot (?:N|S)\b", r"\bour\b", r"\bignor(?:es|ing)\b", r"\bnever\b",
    r"\bdefault\b", r"\bstart(?:s|ed)? (?:at|with)\b",
    r"\b(?:do not|don't|must not|should not|not to) (?:send|use|set|fill|write|treat|put|take)",
)  # fmt: skip
_USED = pattern(
    r"(?:N (?:to|and|or) |N, or |(?<!value) of |\b(?:than|above|below|over|under|least|most|about|until|version|param"
    r"|channels?|bytes?|bit|page|section"
    r"|element|index|number|first|last|within|every|by|times|plus|minus) |[<>\u2264\u2265+*/x-] ?|[NQ] ?|\.\."
    r"|\[)$"
)
_NO_VALUE = pattern(
    r" ?(?:[-+*/\u00d7%]|[NS]\b|\.\.|to N|bytes|times|hz|Q|U\b|of (?:the|these|them|all)|or more|or less"
    r"|[a-z]+s (?:of|are|in)\b|\]|(?:elements|cells|motors|sensors|channels|servos|entries|slots|sectors|cores"
    r"|antennas|receivers)\b)"
)
_GAP = pattern(r"[.;|]|[MEVCTUQ]|\b(?:but|while|whereas|otherwise|however)\b")
_OF_MESSAGE = pattern(r" (?:of|in|from) M\b|;? *(?://|#|/\*)(?: M:?)?")
_FAR = 70
_GIVEN_TO = pattern(r" (?:as|for) (?:the |an? )?[FP]\b")
"""Behind a value, the name of the field that has it: "`a` is in hPa. INT16_MAX as temperature: not available"."""
_QUESTION = pattern(r"\? (?:then|so|in that case|send|use|set|fill|it|write|put|F|N|S)\b")
_SMALL = (0, 1)
"""Numbers that a field may really have while something else is unknown."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every value that a sentence about something unknown gives a field."""
    for low, high in _sentences(span):
        words_for = [
            found
            for found in _ABSENT.finditer(span.text, low, high)
            if not _NEGATED.search(span.text, max(low, found.start() - 30), found.start())
        ]
        clear = [found for found in words_for if found[0] != "empty"]  # "255 unknown, 0 empty" tells two states
        absent = [(found.start(), found.end()) for found in clear or words_for]
        if not absent or _RULED_OUT.search(span.text, low, high):
            continue
        values = [
            (at, number(term)) for at, term in span.sentence.within(low, high, "NS") if _is_value(span.text, low, at)
        ]
        told = [*_told(span, low, high, absent, [at for at, _ in values])]
        states = {place for _, _, tied in told for place in tied}  # "0 unknown, 1 invalid": one of them may be right
        for group, at, _ in told:
            one = about(reading, span, group)
            if one is not None and not any(_is_right(one, value, is_tied=place in states) for place, value in values):
                yield from _found(reading, span, one, at, (low, high))


def _sentences(span: Span) -> Iterator[tuple[int, int]]:
    """The sentences of a part, a question with its answer; an item, a row and a line are one."""
    if is_data(span):
        return
    if span.kind is PassageKind.ROW or span.is_code:
        yield 0, len(span.text)
        return
    low = 0
    while low < len(span.text):
        _, high = span.bounds(low)
        if _QUESTION.match(span.text, high):
            _, high = span.bounds(high + 1)
        yield low, high
        low = max(high + 1, low + 1)


def _is_value(text: str, low: int, at: int) -> bool:
    """Return whether a number may be a value of a field, and no amount, place or end of a range."""
    return not _USED.search(text[max(low, at - 14) : at].removesuffix("(")) and not _NO_VALUE.match(text, at + 1)


def _told(
    span: Span, low: int, high: int, absent: list[tuple[int, int]], values: list[int]
) -> Iterator[tuple[int, int, list[int]]]:
    """The names of fields, each with the value that the words for absence are tied to, and all that may be."""
    names = [said.names[-1] for said in said_of_fields(span) if low <= said.start < high] or _carried(span, low, high)
    taken: set[int] = set()
    for start, end in absent:
        tied = [at for at in values if at not in taken and _is_tied(span.text, at, start, end)]
        if not tied or not names:
            continue
        at = min(tied, key=lambda value: start - value if value < start else value - end)
        given = _GIVEN_TO.match(span.text, at + 1)
        before = [name for name in names if name < at] if given is None else [given.end() - 1]
        behind = [name for name in names if name > at and not _GAP.search(span.text, at + 1, name)]
        name = before[-1] if before else next(iter(behind), None)
        if name is not None and not _is_element(span, name):
            taken.add(at)
            yield name, at, tied


def _carried(span: Span, low: int, high: int) -> list[int]:
    """The field that the sentences before one are about: the only one of the passage so far, and of no other thing."""
    before = [said for said in said_of_fields(span) if said.start < low]
    if _OF_SEVERAL.match(span.text, low):
        return []
    low_before, _ = span.bounds(max(low - 2, 0))
    last = [said for said in before if said.start >= low_before]
    if (
        len(last) == 1
        and len(last[0].names) == 1
        and _IT.search(span.text, low, high)
        and _BEGINS.fullmatch(span.text, low_before, last[0].start)
    ):
        before = last
    names = {span.sentence.term(said.names[-1]).written for said in before}
    if len(names) != 1 or any(len(said.names) > 1 for said in before):
        return []
    of = _OF_IT.match(span.text, before[-1].end)
    others = [at for at, _ in span.sentence.within(of.end() if of is not None else before[-1].end, high, "MEVC")]
    return [] if others or low - before[-1].end > _CARRIED else [before[-1].names[-1]]


_OF_IT = pattern(r" (?:of|in) (?:the )?M\b")
_IT = pattern(r"\b(?:it|there|this|the field)\b")
_BEGINS = pattern(r"[^a-zA-Z]*(?:the )?(?:field )?")
_OF_SEVERAL = pattern(
    r"\s*(?:the|both|all|these|those) (?:(?:N|[a-z]+) ){0,2}[a-z]{3,}s\b[^.;]*?\b(?:are|have|use|carry|hold)\b"
)
"""The beginning of a sentence about several things, which no single field is: "the two temperatures are ..."."""
_CARRIED = 250
"""The greatest distance over which a text stays about a field, in characters."""


def _is_tied(text: str, at: int, start: int, end: int) -> bool:
    """Return whether a value and words for absence belong together: near, and with nothing of another kind between."""
    if start <= at < end:
        return True
    low, high = (at + 1, start) if at < start else (end, at)
    gap = _OF_MESSAGE.sub(" ", text[low:high].replace("? ", " ", 1)).replace("i.e.", "ie").removeprefix(" while")
    return high - low <= _FAR and not _GAP.search(gap) and not pattern(r"[NS]").search(gap)


def _is_right(one: About, value: float | Fraction | None, *, is_tied: bool) -> bool:
    """Return whether a value stands for unknown in a field; a small one elsewhere may be there by chance."""
    if value is None or (float(value) in _SMALL and not is_tied):
        return False
    return not one.is_wrong(partial(is_unknown, value=float(value)))


def _found(reading: Reading, span: Span, one: About, at: int, sentence: tuple[int, int]) -> Iterator[Diagnostic]:
    term = span.sentence.term(at)
    value, known = number(term), unknown_values(one.field)
    if value is None or known is None or one.field.definition.enum:
        return
    if not one.is_wrong(partial(is_unknown, value=float(value))):
        return
    if known[1] == "negative" and "negative" in span.text[slice(*sentence)]:
        return
    if value in described_failures(one.field) and _FAILS.search(span.text, *sentence):
        return
    is_told = _TOLD.search(span.text, *sentence) is not None
    if float(value) in _SMALL and not is_told:
        return
    text = f"{one.name} is unknown when it is {known[1]}, not {term.written}"
    yield reading.found(as_sure(SENTINEL, is_sure=one.is_sure), span.place(at), f"{one.name} {term.written}", text)


_FAILS = pattern(r"\bfail|\blost\b|\bloses?\b|\bbroken\b")


def _is_element(span: Span, offset: int) -> bool:
    value = span.sentence.term(offset).value
    return isinstance(value, NamedField) and value.elements is not None
