"""Claims about the range of a field's numbers: "`cog` ends at 65535", "from 0 to 35999", "at most 327.67 m/s"."""

import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

from codegen.claims.described_range import range_of
from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import DENIED, MISTAKEN, OWN, PAST, PROPOSED, REPLACED, SHOWN, words
from codegen.claims.rules import RANGE, as_sure
from codegen.claims.statements.fields import Said, number, said_of_fields
from codegen.claims.statements.scaling.field_units import has_unit, on_the_wire
from codegen.claims.statements.subjects import About, about
from codegen.diagnostics import Diagnostic
from codegen.frozen import dataclass
from codegen.model.dialect.dialect import WireField
from codegen.model.dialect.literals import LIMITS
from codegen.model.units.unit import Unit, unit_named
from codegen.pattern import pattern

_TOP = pattern(
    r"\b(?:(?:can|could|will|may|must)(?: ?not|not|n't)? (?:be|go|get|exceed|hold|carry|count|reach|have|show|tell|say)"
    r"(?: (?:more|larger|greater|higher|bigger|further|values|numbers|up|beyond|above|over))*(?: than| to| at most)?"
    r"|cannot (?:be|go|get|exceed|hold|carry|count|reach)"
    r"(?: (?:more|larger|greater|higher|bigger|further|beyond|above|over|values))*(?: than)?"
    r"|ends? at|stops? at|(?:is |are )?limited to|(?:is |are )?capped at|clips? at|saturates? at|tops? out at|runs? to"
    r"|wraps?(?: around)? (?:at|after)|overflows?(?: (?:at|after|above|beyond))?|rolls over (?:at|after)"
    r"|goes? up to|goes only to|counts? (?:up )?to|reaches|at most|no more than|never (?:more|larger|higher"
    r"|above)(?: than)?"
    r"|(?:largest|greatest|highest|biggest|maximum|max|top|full) (?:possible )?(?:value|number|reading|count)?(?:"
    r" of M?F)?"
    r"|maximum|max\.?|upper (?:limit|end|bound)|limit|(?:values|numbers|anything) (?:above|over|beyond)|\u2264|<=)"
    r"(?: (?:of|in|for) (?:the )?(?:field )?[MF])*(?: in M)?"
    r"(?: (?:that )?(?:M )?F (?:can|could|may) (?:show|hold|carry|have|tell|reach))?(?: (?:is|at|of|being|only))*"
    r"[ :=]*(?P<value>[NQ])"
)
_UP_TO = pattern(
    r"(?:\bup to [NQ](?= (?:can|could|may|fit|fits|(?:is|are) possible)\b)"
    r"|\b(?:enough for|values|numbers|readings) up to [NQ])",
    needs="up to",
)
_OVER = pattern(
    r"\b(?:anything|values|numbers|nothing|a value|more than|what is) (?:above|over|beyond|larger than|greater"
    r" than)? ?(?P<value>[NQ])"
    r" (?:does not|do not|cannot|will not|doesn't|don't|can't|never) (?:fit|go|be|get) (?:into|in|stored in|sent"
    r" in|held by)? ?(?:the )?(?:field )?$"
)
_SPAN = pattern(
    r"(?P<low>[NQ]) ?(?:U ?)?(?:\.\.\.?| ?\u2026 ?| ?[-\u2013] ?| to | and | through | up to )(?:about"
    r" )?(?P<value>[NQ])"
)
_RANGE = pattern(
    r"\b(?:accepts?|takes?|allows?|holds?|carries|supports|from|between|range|ranges|values?|goes|runs|valid"
    r"|allowed|covers|scale|in|is|are|has|have) |[(\[:,|=]"
    r" ?$|^ ?$"
)
_RULED_OUT = words(
    DENIED[1:2], REPLACED, PAST, OWN, MISTAKEN, PROPOSED, SHOWN, r"\bshould\b", r"\bpulse", r"\bbytes?\b", r"\belement",
    r"\bscaled", r"\bdivid", r"\bmap(?:ped|s)?\b", r"\bsensor\b", r"\btypical", r"\bnormal",
)  # fmt: skip
_NOT_ONE = pattern(r"\bnot\b(?! (?:be|go|get|exceed|hold|carry|count|reach|more|larger))")
_TOPS = tuple(sorted({value for name, value in LIMITS.items() if name.endswith("_MAX")}))
_BOTTOMS = tuple(sorted({value for name, value in LIMITS.items() if name.endswith("_MIN") and value < 0}))
_CAN_SHOW = pattern(r"\b(?:can|could|may) show\b")
"""Words for the range of a field: it can show no more than it carries."""
_FAR = 90
_UNITS_BEHIND = pattern(r" ?U\b")


@dataclass(frozen=True, slots=True)
class _End:
    """A number of a range in a part: where it stands, and its unit if it has one."""

    offset: int
    value: Fraction
    unit: Unit | None
    is_wrapped: bool = False


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every end of a range that is said of one field."""
    for said in said_of_fields(span):
        one = about(reading, span, said.names[-1])
        if one is None or one.field.definition.enum:
            continue
        found = list(_said(reading, said, one)) if one.field.type.is_integer else []
        yield from found or _described(reading, said, one)
    yield from _beyond(reading, span)


_BEYOND = pattern(
    r"\b(?:more|anything|values?|numbers?|whatever is|what is) (?:is )?(?:than|above|over|beyond|larger than|greater"
    r" than)"
    r" (?P<value>[NQ]) (?:cannot|can not|can never|cant|will not|wont|does not|do not|doesnt|dont) (?:be"
    r" (?:represented|sent"
    r"|told|coded|encoded|expressed|reported|carried)|fit)\b(?: (?:into|in) (?:the )?(?:field )?(?P<name>F))?"
)


_CANNOT = pattern(r"(?:not|cant|wont|doesnt|dont|never) (?:be|fit)\b")


def _beyond(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "More than 255 cannot be represented", of the field behind it or of the one that the passage is about."""
    for found in _BEYOND.finditer(span.text) if _CANNOT.search(span.text) else ():
        before = [said for said in said_of_fields(span) if said.end <= found.start()]
        named = [said for said in said_of_fields(span) if found["name"] and found.start("name") in said.names]
        is_one = len({span.sentence.term(said.names[-1]).written for said in before}) == 1
        said = next(iter(named or (before[-1:] if is_one else [])), None)
        one = about(reading, span, said.names[-1]) if said is not None else None
        end = _end(span, found.start("value"))
        if said is None or one is None or end is None or not one.field.type.is_integer or one.field.definition.enum:
            continue
        low, _ = span.bounds(found.start())
        if _RULED_OUT.search(span.text, low, found.start()) is None and _is_wrong(one, end, is_top=True):
            yield _finding(reading, said, one, end, is_top=True, is_sure=False)


def _said(reading: Reading, said: Said, one: About) -> Iterator[Diagnostic]:
    span, text = said.span, said.span.text
    low = max(said.before, said.start - 40)
    lead = _OVER.search(text, low, said.start)
    for found, is_certain in (
        (_TOP.search(text, low, said.until) or _UP_TO.search(text, said.end, said.until), True),
        (_SPAN.search(text, said.end, said.until), False),
    ):
        if found is None or (found.end() <= said.end and found["value"] is None):
            continue
        at = found.start("value") if "value" in found.re.groupindex else found.end() - 1
        if (at < said.end and found is not lead) or at - said.end > _FAR:
            continue
        gap = _CAN_SHOW.sub("", text[low:at])
        if (
            _RULED_OUT.search(gap)
            or _NOT_ONE.search(gap)
            or re.search(_ends(said), text[said.end : found.start()].strip(" |"))
        ):
            continue
        if not is_certain and not _RANGE.search(text[said.end : found.start()]):
            continue
        end = _end(span, at)
        if end is None:
            continue
        end = replace(end, is_wrapped=pattern(r"wrap|overflow|roll").search(found[0]) is not None)
        lower = _end(span, found.start("low")) if not is_certain else None
        if end.unit is None and any(
            _is_of_other(term.value, one) for _, term in span.sentence.within(said.end, said.until, "U")
        ):
            continue
        wrong = next(
            (each for each in (end, lower) if each is not None and _is_wrong(one, each, is_top=each is end)), None
        )
        if wrong is not None:
            yield _finding(reading, said, one, wrong, is_top=wrong is end, is_sure=is_certain)
            return


def _described(reading: Reading, said: Said, one: About) -> Iterator[Diagnostic]:
    """ "From 0 to 100" of a field whose description gives another range."""
    span, text = said.span, said.span.text
    found = _SPAN.search(text, said.end, said.until)
    told = [range_of(field) for field in (one.field, *one.others)]
    if found is None or any(each is None for each in told) or found.start() - said.end > _FAR:
        return
    gap = text[said.end : found.start()].replace(" of M", "")
    if _RULED_OUT.search(gap) or _NOT_ONE.search(gap) or not _RUNS.search(gap) or re.search(r"[|;]|\.\s|[MEVC]", gap):
        return
    low, high = (_end(span, found.start(group)) for group in ("low", "value"))
    if low is None or high is None or high.unit is not None or _UNITS_BEHIND.match(text, found.end()):
        return
    if any(each is not None and (low.value in each or high.value in each[1:]) and high.value in each for each in told):
        return
    best = told[0]
    if best is None or low.value not in (best[0], 0, 1) or high.value in (best[1], *_TOPS):
        return
    if best[1] in _TURNS and high.value == best[1] - 1:
        return  # the last step before a full turn, which is none
    if best[1] and float(high.value) / best[1] > _SCALED:
        return  # the description has it in another unit
    written = span.sentence.term(high.offset).written
    words = f"{one.name} goes from {best[0]:g} to {best[1]:g}, not to {written}"
    yield reading.found(as_sure(RANGE, is_sure=False), span.place(high.offset), f"{one.name} to {written}", words)


_TURNS = (360, 3600, 36000)
_SCALED = 50
"""So many times as much is the same in a smaller unit."""
_RUNS = pattern(
    r"\b(?:runs?|goes|ranges?|between|from|is|are|range|scale|scaled|accepts?|takes?|values?|number)\b[^,]*$"
    r"|^ ?[(:,] ?$"
)


def _is_of_other(unit: object, one: About) -> bool:
    """Return whether a named unit is another one than that of the field: the number may be in that unit."""
    return isinstance(unit, Unit) and not has_unit(one.field, unit)


def _ends(said: Said) -> str:
    """Return the pattern that ends a statement; within an item a semicolon does not."""
    return r"\||\.\s" if said.is_listed else r"[|;]|\.\s"


def _end(span: Span, offset: int) -> _End | None:
    term = span.sentence.term(offset)
    if term.letter == "Q":
        assert isinstance(term.value, tuple)
        value, unit = term.value
        return _End(offset, value, unit) if value is not None and unit is not None and unit.dimension else None
    value = number(term)
    behind = _UNITS_BEHIND.match(span.text, offset + 1)
    unit = span.sentence.term(behind.end() - 1).value if behind is not None else None
    if value is None or isinstance(value, float):
        return None
    return _End(offset, Fraction(value), unit if isinstance(unit, Unit) else None)


def _raw(field: WireField, end: _End) -> Fraction | None:
    """The end as a number on the wire; None where its unit is none of the field."""
    own = Unit.parse(field.definition.units)
    if end.unit is None:
        return end.value
    return None if own is None else on_the_wire(field, end.value, end.unit, own)


def _is_wrong(one: About, end: _End, *, is_top: bool) -> bool:
    """Return whether an end is that of another type, or of a full turn in another unit, and none of the field."""
    return all(_is_other(field, end, is_top=is_top) for field in (one.field, *one.others))


def _is_other(field: WireField, end: _End, *, is_top: bool) -> bool:
    raw = _raw(field, end)
    if raw is None:
        return False
    off = Fraction(2) if end.unit is None else abs(raw) / 200 + 1
    own = field.type.maximum if is_top else field.type.minimum
    stated = [field.definition.maximum, field.definition.minimum]
    if is_top and raw > own + (0 if end.unit is None and not end.is_wrapped else off):
        return True
    if abs(raw - own) <= off or any(
        text is not None and abs(Fraction(text) - raw) <= off for text in stated if _is_number(text)
    ):
        return False
    ends = _TOPS if is_top else _BOTTOMS
    if any(abs(raw - each) <= off and each > _LEAST for each in ends if is_top):
        return not _is_told(field, end)
    if not is_top and any(abs(raw - each) <= 1 for each in ends):
        return raw < own
    return is_top and end.unit is None and _is_turn(field, raw)


_LEAST = 100
"""A maximum of a type that is no number of anything else."""


def _is_told(field: WireField, end: _End) -> bool:
    """Return whether the field's description names the number."""
    return re.search(rf"(?<!\d){end.value}(?!\d)", field.definition.description) is not None


def _is_number(text: str | None) -> bool:
    return text is not None and pattern(r"-?\d{1,12}(?:\.\d{1,9})?").fullmatch(text) is not None


def _is_turn(field: WireField, raw: Fraction) -> bool:
    """Return whether a number is a full or half turn, but in another power of ten than the field's unit has."""
    own = Unit.parse(field.definition.units)
    degrees = unit_named("deg")
    if own is None or own.dimension != degrees.dimension or own.pi:
        return False
    for turn in (360, 180, 90):
        whole = turn / own.scale
        if any(whole - step <= raw <= whole for step in (1, 1 / own.scale)) or whole == raw:
            return False
    digits = str(int(raw)).rstrip("0")
    return raw >= _TURN and digits in ("36", "18", "3599", "35999", "359", "359999", "1799", "17999", "179")


_TURN = 100


def _finding(reading: Reading, said: Said, one: About, end: _End, *, is_top: bool, is_sure: bool) -> Diagnostic:
    field, span = one.field, said.span
    written = span.sentence.term(end.offset).written
    most = field.type.maximum if is_top else field.type.minimum
    own = Unit.parse(field.definition.units)
    turn = own is not None and is_top and _is_turn(field, _raw(field, end) or Fraction(0))
    what = "maximum" if is_top else "minimum"
    if turn and own is not None:
        text = f"{one.name} is in {field.definition.units}: a full turn is {int(360 / own.scale)}, not {written}"
    else:
        unit = f" {field.unit_text}" if field.unit_text else ""
        text = f"{one.name} is {field.type.name}: its {what} is {most}{unit}, not {written}"
    rule = as_sure(RANGE, is_sure=is_sure and one.is_sure)
    return reading.found(rule, span.place(end.offset), f"{one.name} {what} {written}", text)
