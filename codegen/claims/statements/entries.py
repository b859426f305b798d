"""Values that are said to be entries of an enum: "0 = none, 3 = 3D fix", "bit 2: charging", ``FIX_3D = 3``."""

import re
from collections.abc import Iterator, Sequence
from itertools import groupby

from codegen.claims import ruled_out
from codegen.claims.enum_names import entry_values
from codegen.claims.parts.span import Span
from codegen.claims.parts.spans import spans
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import DENIED, MISTAKEN, OWN, REPLACED, SUPPOSED
from codegen.claims.rules import ENTRY_VALUE, as_sure
from codegen.claims.statements.entry_names import named
from codegen.claims.statements.fields import number, said_of_fields
from codegen.claims.statements.meaning import meaning
from codegen.claims.statements.subjects import about
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import EnumDefinition, EnumEntry
from codegen.once import once
from codegen.pattern import pattern

_WORD = (
    r"(?!(?:and|or|but|with|to|from|of|as|at|which|that|so|then"
    r"|per)\b)(?:\dd )?[a-zPUCV][a-z0-9PUCV /'+-]{0,44}?(?: \([a-zPUC -]{2,24}\))?"
)
_ENDS = r"(?=\s*(?:[,.;:)|\]}]|$|\*/|\band\b|\bor\b|N|\bbut\b|\bwhile\b|\bbit\b|[-\u2013\u2014] ))"
_PAIRS = (
    pattern(
        rf"(?P<bit>\bbit )?(?<![-+*/.\w<>])(?P<value>N)\)? ?(?:=>?|:|->|\u2192|\||\(|\u2013|\u2014|-)? ?(?:(?:is"
        rf"|are|for|means|stands for|says|marks|was|treated as|an?|the|when|if|it is|tells(?: that)?|being|signals"
        rf"|denotes|indicates|value N[,:]?)\b ?|,? (?:which|that) (?=is|means|marks|stands|says))*"
        rf"(?P<words>{_WORD}){_ENDS}"
    ),
    pattern(
        r"(?P<words>(?:\dd )?[a-zPUCV][a-zPUCV-]{0,20}(?: [a-zPUCV-]{1,20}){0,3}) ?(?:[(=:|]|->|\u2192|is"
        r"|has(?: the)? value|bit)+ ?(?P<bit>\bbit )?(?P<value>N)(?=\s*(?:[),.;|\]}]|$|\*/|\band\b))"
    ),
)
_ALONE = pattern(rf"[\s:=]{{0,4}}(?P<value>N), (?P<words>{_WORD}){_ENDS}", needs="N,")
_QUOTED = pattern(r"[\"'\u201c\u201d]")
_NOT = ruled_out.words(
    DENIED[:2], REPLACED[:1], MISTAKEN[:1], SUPPOSED[:1], OWN[:1], r"\bown\b", r"\bfirst\b", r"\bversion\b", r"\bper\b"
)
_RESPECTIVELY = pattern(r"(?:N(?:, N)*,? and|N,) $")
"""Before the last of several values: "2 and 4 are horizontal and vertical velocity"."""
_IN_TURN = pattern(r" and N\)")
"""Behind the first of two values in parentheses, one for each of two things: "float and fixed RTK (5 and 6)"."""
_FEWEST = 2
_CONSTANT = pattern(
    r"^\s*(?:#define|(?:pub |export |static |public |constexpr |final |val |private )*(?:const|let|var|int"
    r"|uint8_t|u8|val|static)?(?: (?:u?int\d+_t|int))?)\s*"
    r"(?P<name>[A-Za-z][A-Za-z0-9_]{1,80})(?:\s*:\s*\w+)?\s*(?:=|\s|\()\s*\(?(?P<value>0x[0-9a-fA-F]{1,8}|\d{1,8}"
    r"|1 ?<< ?\d{1,2})\)?\s*[;,)]?\s*(?://.*|/\*.*|#.*)?$"
)


@dataclass(frozen=True, slots=True)
class _Subject:
    """A field or an enum whose values are told, by its name, and its enum."""

    name: str
    enum: EnumDefinition


def check(reading: Reading, parts: Sequence[Span]) -> Iterator[Diagnostic]:
    """Every value of an enum in a document."""
    above: Span | None = None
    for is_list, run in groupby(
        parts, lambda span: span.kind in (PassageKind.ITEM, PassageKind.ROW) and not span.is_code
    ):
        spans = list(run)
        if is_list:
            subject = _subject(reading, above, spans) if above is not None else None
            for span in spans:
                yield from named(reading, span)
                own = list(_said(reading, span))
                yield from own
                if subject is not None and not _fields(reading, span):
                    yield from _values(reading, span, subject, 0, len(span.text))
                elif subject is None and not own:
                    yield from _unnamed(reading, span)
            continue
        for span in spans:
            yield from named(reading, span)
            yield from _said(reading, span)
            if not _fields(reading, span):
                yield from _unnamed(reading, span)
        above = spans[-1]


def _fields(reading: Reading, span: Span) -> list[_Subject]:
    """The fields with an enum that a part names."""
    found = []
    for said in said_of_fields(span):
        one = about(reading, span, said.names[-1])
        enum = reading.enums.get(one.field.definition.enum or "") if one is not None else None
        if one is not None and enum is not None:
            found.append(_Subject(one.name, enum))
    return found


def _said(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    for said in said_of_fields(span):
        one = about(reading, span, said.names[-1])
        enum = reading.enums.get(one.field.definition.enum or "") if one is not None else None
        if one is not None and enum is not None:
            others = {other.definition.enum for other in one.others} - {enum.name, None}
            if not others:
                yield from _values(reading, span, _Subject(one.name, enum), said.end, said.until)
                yield from _only(reading, span, enum, said.end, said.until)


def _only(reading: Reading, span: Span, enum: EnumDefinition, low: int, high: int) -> Iterator[Diagnostic]:
    """The only number and the only entry of a cell, an item or a clause about a field: "24 by default, down (NAME)"."""
    stop = re.compile(r"[|;]|\.\s").search(span.text, low, high)
    high = stop.start() if stop is not None and span.text[low : stop.start()].strip() else high
    numbers = [at for at, _ in span.sentence.within(low, high, "NQ")]
    entries = [term for _, term in span.sentence.within(low, high, "VCEMFT")]
    if len(numbers) != 1 or len(entries) != 1 or _NOT.search(span.text, low, high) or span.is_code:
        return
    value, entry = number(span.sentence.term(numbers[0])), enum.entry(entries[0].written)
    if value is None or entry is None or entry.value == value or not _TOLD_FIRST.fullmatch(span.text, low, numbers[0]):
        return
    written = span.sentence.term(numbers[0]).written
    text = f"{enum.name}: {entry.name} is {entry.value}, not {written}"
    yield reading.found(as_sure(ENTRY_VALUE, is_sure=False), span.place(numbers[0]), f"{entry.name} {written}", text)


_TOLD_FIRST = pattern(r"[\s|:=(,]*(?:(?:is|has|always|must be|set to|fixed at|the|value|to|as|=)[\s:]*){0,4}")


def _enums_named(span: Span) -> list[str]:
    """Return the enums that a part names, without those that it says its values are not of."""
    named = span.sentence.within(0, len(span.text), "E")
    return [str(term.value) for at, term in named if not _NO_ENUM.search(span.text, max(at - 20, 0), at)]


_NO_ENUM = pattern(r"\b(?:not|no|never|nor) (?:an? |any |the |from |of |in )*$")


def _subject(reading: Reading, above: Span, spans: Sequence[Span]) -> _Subject | None:
    """Return the subject of the values of a list or a table: the field or enum named above, or the best fit."""
    fields = _fields(reading, above)
    if fields:
        return fields[-1]
    named = [reading.enums[name] for name in _enums_named(above)]
    if named:
        return _Subject(named[-1].name, named[-1])
    topic = spans[0].topic
    subjects = [each for message in topic.around[:4] for each in _of_message(reading, message.name)]
    return _most_right(subjects, [pair for span in spans for pair in _pairs(span, 0, len(span.text))])


def _of_message(reading: Reading, name: str) -> list[_Subject]:
    message = reading.messages[name]
    pairs = [(f"{name}.{field.name}", reading.enums.get(field.definition.enum or "")) for field in message.fields]
    return [_Subject(called, enum) for called, enum in pairs if enum is not None]


_Pair = tuple[int, str, int]
"""A value, the words beside it, and the offset of the value."""


def _pairs(span: Span, low: int, high: int) -> list[_Pair]:
    found: list[_Pair] = []
    for form in _PAIRS if span.text.find("N", low, high) >= 0 else ():
        position = low
        while (each := form.search(span.text, position, high)) is not None:
            value = number(span.sentence.term(each.start("value")))
            position = max(each.end("words") if form is _PAIRS[0] else each.end(), position + 1)
            if value is None or value != int(value) or value < 0:
                continue
            words = "".join(
                span.sentence.terms[at].written if at in span.sentence.terms else span.text[at]
                for at in range(each.start("words"), each.end("words"))
            )
            is_bit = (
                each["bit"] is not None or span.text[max(each.start("value") - 4, 0) : each.start("value")] == "bit "
            )
            found.append((1 << int(value) if is_bit and value < 32 else int(value), words, each.start("value")))
    return found


def _alone(span: Span, low: int, high: int) -> list[_Pair]:
    """ "`type`: 1, light beacon"."""
    found = _ALONE.match(span.text, low, high)
    value = number(span.sentence.term(found.start("value"))) if found is not None else None
    if found is None or value is None or value != int(value):
        return []
    return [(int(value), span.source_text(found.start("words"), found.end("words")), found.start("value"))]


def _most_right(subjects: Sequence[_Subject], pairs: Sequence[_Pair]) -> _Subject | None:
    """The enum that most pairs are right about: half of them at least, and two."""
    for subject in subjects:
        known = meaning(subject.enum)
        right = len({value for value, words, _ in pairs if known.is_named(value, words)})
        if right >= _FEWEST and 2 * right >= len({offset for _, _, offset in pairs}):
            return subject
    return None


def _unnamed(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Values of a field or an enum that the sentence names otherwise: "NAME answers 0 (accepted), 1 (denied)"."""
    enums = [_Subject(name, reading.enums[name]) for name in _enums_named(span)]
    for subject in enums[-1:]:
        yield from _values(reading, span, subject, 0, len(span.text))
        return
    pairs = _pairs(span, 0, len(span.text))
    if len(pairs) <= _FEWEST:
        return
    topic = span.topic
    own = [name for _, name in span.named(0, len(span.text))]
    names = own or [message.name for message in (*topic.above, *topic.headings)[:2]]
    likely = _most_right([each for name in names[:2] for each in _of_message(reading, name)], pairs)
    if likely is not None:
        yield from _values(reading, span, likely, 0, len(span.text))


def _values(reading: Reading, span: Span, subject: _Subject, low: int, high: int) -> Iterator[Diagnostic]:
    known = meaning(subject.enum)
    told: set[int] = set()
    for value, words, offset in _as_meant(subject, span, [*_alone(span, low, high), *_pairs(span, low, high)]):
        before = span.text[max(low, offset - 30) : offset]
        if (
            offset in told
            or _RESPECTIVELY.search(before)
            or _IN_TURN.match(span.text, offset + 1)
            or _NUMBERED.search(before)
            or _NOT.search(pattern(r"[,.;(]").split(before)[-1])
        ):
            continue
        meant = known.meant_otherwise(value, words)
        if meant is not None and not _is_sum(subject.enum, value, meant.value):
            told.add(offset)
            yield _finding(reading, span, subject, meant, value, offset, words)


_NUMBERED = pattern(r"\b(?:param(?:eter)?s?(?: number)?|offset)[:=]? ?$")
"""Before the number of a parameter, ``param: 4``, or of a byte, ``offset: 4``, which is no value of an entry."""


def _is_sum(enum: EnumDefinition, value: int, part: int) -> bool:
    """Return whether a value has several flags set, and one of them is that of the entry that is meant."""
    values = [entry.value for entry in enum.entries]
    is_of_flags = max(values) > _FEWEST and all(not each & (each - 1) for each in values)
    return is_of_flags and bool(value & (value - 1)) and bool(value & part)


def _as_meant(subject: _Subject, span: Span, pairs: list[_Pair]) -> list[_Pair]:
    """Return the pairs of a list with "bit" in it in the reading that has the fewest wrong ones.

    "bit 1 healthy, 2 retracted, 4 moving" gives values, "bits: 0 healthy, 1 retracted" gives their places.
    """
    if len(pairs) < _FEWEST or not pattern(r"\bbits?\b").search(span.text):
        return pairs
    known = meaning(subject.enum)
    raw = [(int(number(span.sentence.term(at)) or 0), words, at) for _, words, at in pairs]
    shifted = [(1 << value, words, at) for value, words, at in raw if 0 <= value < _BITS]
    readings = (pairs, raw, *((shifted,) if len(shifted) == len(raw) else ()))
    return min(
        readings, key=lambda each: sum(known.meant_otherwise(value, words) is not None for value, words, _ in each)
    )


_BITS = 64


def _finding(
    reading: Reading, span: Span, subject: _Subject, meant: EnumEntry, value: int, offset: int, words: str
) -> Diagnostic:
    at = next((entry for entry in subject.enum.entries if entry.value == value), None)
    text = f"{subject.name}: {meant.name} is {meant.value}, not {value}"
    hint = f"{value} is {at.name}" if at else None
    rule = as_sure(ENTRY_VALUE, is_sure=meaning(subject.enum).is_sure(meant, words) or span.is_code)
    return reading.found(rule, span.place(offset), f"{subject.name} {value} {words.strip()}", text, hint)


_HEAD = pattern(r"\s*(?:[a-z]+ )*(?:enum|class)\b")
_HEAD_OR_NOTE = pattern(r"\b(?:enum|class)\b")


def constants(reading: Reading, parts: Sequence[Span]) -> Iterator[Diagnostic]:
    """Constants of code and members of its enums, whose names end as those of entries do."""
    scope: _Subject | None = None
    declared_as = ""  # the enum whose members come up to the next brace, whatever comments name
    for span in parts:
        if not span.is_code:
            scope = None
            continue
        named = [str(term.value) for _, term in span.sentence.within(0, len(span.text), "E")]
        is_within = scope is not None and scope.name == declared_as
        is_head = (_HEAD.match if is_within else _HEAD_OR_NOTE.search)(span.text) is not None
        if named and (is_head or (span.is_comment and not is_within)):
            scope = _Subject(named[-1], reading.enums[named[-1]])
            declared_as = named[-1] if is_head and not span.is_comment else declared_as
            continue
        declared = pattern(r"\b(?:enum|class)(?: class)? (?P<name>[a-z_]\w*|[PMCE])").search(span.text)
        if declared is not None:
            called = _enum_called(reading, span, declared)
            scope = called or (scope if "enum" in declared[0] else None)
            declared_as = scope.name if scope is not None else ""
            continue
        declared_as = "" if span.text.lstrip().startswith("}") else declared_as
        if span.text.lstrip().startswith("}") or re.match(
            r"\s*(?:struct|def|fn|pub fn|impl|void|int main)\b", span.text
        ):
            scope = None
        found = _CONSTANT.match(_source(span)) if scope is not None else None
        if found is None or scope is None:
            continue
        name = found["name"]
        value = 1 << int(found["value"].partition("<<")[2]) if "<<" in found["value"] else int(found["value"], 0)
        meant = meaning(scope.enum).meant_otherwise(value, _words(name), is_name=True)
        if meant is not None and entry_values(reading.enums).get(name.upper()) != value:
            yield _finding(reading, span, scope, meant, value, _offset(span), name)


def _offset(span: Span) -> int:
    return next((at for at, _ in span.sentence.within(0, len(span.text), "N")), 0)


def _source(span: Span) -> str:
    terms = span.sentence.terms
    return "".join(terms[at].written if at in terms else character for at, character in enumerate(span.text))


def _words(name: str) -> str:
    return pattern(r"(?<=[a-z0-9])(?=[A-Z])").sub(" ", name).replace("_", " ").lower()


def _enum_called(reading: Reading, span: Span, found: "re.Match[str]") -> _Subject | None:
    written = (
        span.sentence.terms[found.start("name")].written
        if found.start("name") in span.sentence.terms
        else found["name"]
    )
    joined = written.replace("_", "").lower()
    for name, enum in reading.enums.items():
        bare = name.replace("_", "").lower()
        if joined in (bare, bare.removeprefix("mav")):
            return _Subject(name, enum)
    return None


def is_borne_out(reading: Reading, span: Span, name: str, field: str | None) -> bool:
    """Return whether most values of a part, or of the list that it belongs to, are right for the enum of a subject.

    ``name`` is that of the enum, or of the message whose ``field`` has it.
    """
    message = reading.messages.get(name)
    found = message.field(field) if message is not None and field is not None else None
    enum = reading.enums.get((found.definition.enum or "") if found is not None else name)
    if enum is None:
        return False
    known, run = _borne_out(reading), _lists(reading).get(id(span), (span,))
    for parts in ((span,), run):
        key = (id(parts[0]), len(parts), enum.name)
        if key not in known:
            known[key] = _is_mostly_right(parts, enum)
        if known[key]:
            return True
    return False


def _is_mostly_right(parts: Sequence[Span], enum: EnumDefinition) -> bool:
    pairs = [pair for part in parts for pair in _pairs(part, 0, len(part.text))]
    right = {value for value, words, _ in pairs if meaning(enum).is_named(value, words)}
    wrong = [value for value, words, _ in pairs if meaning(enum).meant_otherwise(value, words) is not None]
    return len(right) >= _FEWEST and len(right) >= len(wrong)


@once
def _borne_out(_: Reading) -> dict[tuple[int, int, str], bool]:
    """Return the results for lists of a document so far, by the id of their first part, length and enum."""
    return {}


@once
def _lists(reading: Reading) -> dict[int, tuple[Span, ...]]:
    """By the identity of each item and row those that follow each other without a break, itself among them."""
    found: dict[int, tuple[Span, ...]] = {}
    for kind, run in groupby(spans(reading), lambda span: (span.kind, span.is_code)):
        if kind[0] in (PassageKind.ITEM, PassageKind.ROW):
            parts = tuple(run)
            found.update(dict.fromkeys(map(id, parts), parts))
    return found
