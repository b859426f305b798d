"""Units that are said of fields, and the factors by which their numbers are scaled."""

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.parts.span import Span, head_of, is_data
from codegen.claims.reading import Reading
from codegen.claims.ruled_out import (
    CHANGED,
    COMPARED,
    CONDITIONAL,
    CONVERTED,
    DENIED,
    MISTAKEN,
    OWN,
    PAST,
    REPLACED,
    SHOWN,
    SUPPOSED,
    words,
)
from codegen.claims.rules import UNIT, as_sure
from codegen.claims.statements.columns.scaled import factor_beside
from codegen.claims.statements.fields import Said, claimed, said_of_fields
from codegen.claims.statements.scaling.factors import factors, turns
from codegen.claims.statements.scaling.field_units import has_unit, shown_units
from codegen.claims.statements.scaling.keyed_factors import is_after_factor, keyed_factors
from codegen.claims.statements.scaling.own_units import is_told_behind
from codegen.claims.statements.subjects import about
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit, unit_named
from codegen.pattern import pattern

_PLACE = pattern(
    r"(?:\b(?:in|as|how many|(?:number|amount|count|T) of|counts|count|hold|use|carry|contain|give|measure|report"
    r"|units? (?:is|are|of|was)|units?:?|counts?|holds?|uses?|carries|contains?|gives?|measures?"
    r"|reports?|measured in|is|are|be|both|in an? [a-z]+ as)"
    r"(?: (?:whole|full|plain|integer|the|an?|steps of|units of|multiples of|always))*"
    r"|[(\[|:,=#*/\u2013\u2014-](?: ?(?:whole|full|plain|integer))?"
    r"|\bT|\"|^)\s*$"
)
_IS_SHORT = pattern(
    r"\s*(?:[,.;:)\]|}(]|\*/|$|(?:and|if|when|since|for|or|above|below|from|at|over|as|with|relative|positive|per"
    r"|but|because|while|on|of|to|up|too|also|clockwise|counter|a?msl|agl|into|after|behind|before|in|where|which|like"
    r"|by|east|north|along|under|until|within|then|not|so|are|is|until|now|already|relative|wide|rms)\b|[-\u2013\u2014])"
)
_NOT = words(
    DENIED, REPLACED, PAST[:3], CHANGED, MISTAKEN[:1], SUPPOSED, CONDITIONAL, OWN[:1], OWN[2:4], CONVERTED,
    COMPARED[:2],
    SHOWN[:5], r"\bfrom an? T(?! to an? T in )", r"\bbecause\b", r"\bafter\b", r"\bevery\b",
    r"\blimited\b", r"\bstep\b", r"\bhelps?\b",
    r"\berror", r"\baccura", r"\bresol", r"\btimeout\b", r"\bneed", r"/ ?N|\* ?N", r"\bcomputed", r"\bfrom U",
    r"\bsteps\b(?! of)", r"\btimes\b", r"\bbetween\b", r"\bfeed", r"\bread(?:ing)?s? as\b", r"\byou get\b", r"\btake",
    r"\b(?:and|while|whereas|but) (?:the|its|all|both|their) ", r"(?<!^)[,;] the (?!unit|value|field|number)\w",
    r"^; the (?!unit|value|field|number)[a-z]+ (?:is|are)\b",
)  # fmt: skip
_SCALED_AFTER = pattern(
    r"[^.;|]{0,3}(?:times\b|from the (?:start|beginning|end)|x ?N|\* ?N|/ ?N|after|by us|in our|on (?:the|our)"
    r" (?:screen|display)|here\b|is wrong"
    r"|was wrong|\?|, which is wrong)"
)
ELSEWHERE = pattern(
    r" (?:in|on|at|by|for|from) (?:(?:the |an? )?(?:ais|n2k|nmea(?: N)?|ubx|j1939|can|ros|pgn|rtcm|i2c|s\.?bus"
    r"|sensor|device|driver|datagram|bus|receiver)\b|(?:the )?(?!M)[a-z0-9.-]{2,16}(?: [a-z0-9.-]{1,12})?,"
    r" (?:[a-z]+ ){0,4}(?:here\b|in M|in mavlink|on the (?:wire|link)))"
)
"""Behind the unit of another thing: "degrees in AIS, hundredths here"."""
_GAP_LONG = 90
_NUMBERED = pattern(r"((?://[/!<]*|/\*[*!<]*|#) ?)(?:offset |byte |bytes )?(?:N(?:\.\.\.?N|-N)?[:,] )")
"""A comment that begins with a place on the wire, "/* 16: rad */"."""


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every unit and every factor of a part."""
    for said in said_of_fields(span):
        yield from _compared(reading, said)
        found = [*keyed_factors(reading, said)] or list(factors(reading, said))
        yield from found or _unit(reading, said)
    yield from _steps(reading, span)


_LEVEL = pattern(
    r"(?: (?:of|in) M)? (?:(?:is|falls|drops|goes|gets|rises|sinks|climbs|stays) )?(?:below|under|above|over) (?P<at>N)"
    r" (?:bytes|octets)\b",
    needs="above N|below N|over N|under N",
)


def _compared(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """ "If `txbuf` falls below 20 bytes" of a field in percent."""
    found = _LEVEL.match(said.span.text, said.end)
    one = about(reading, said.span, said.names[-1]) if found is not None else None
    if found is None or one is None or not one.field.definition.units:
        return
    if all(
        (Unit.parse(each.definition.units) or _BYTES).dimension != _BYTES.dimension for each in (one.field, *one.others)
    ):
        place, claim = said.span.place(found.start("at")), f"{one.name} in bytes"
        yield reading.found(as_sure(UNIT, is_sure=False), place, claim, f"{one.name} {_own(one.field)}, not bytes")


_BYTES = unit_named("bytes")


def _steps(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """ "0.1 °C" in a column of units: that much is one."""
    if span.kind is not PassageKind.ROW:
        return
    for offset, term in span.sentence.within(0, len(span.text), "Q"):
        cell = _CELL.search(span.text, max(span.text.rfind("|", 0, offset), 0))
        names = [said for said in said_of_fields(span) if said.end <= offset]
        if (
            cell is None
            or not names
            or not _UNIT_HEAD.search(head_of(span, offset))
            or not isinstance(term.value, tuple)
        ):
            continue
        amount, unit = term.value
        if not amount or not isinstance(unit, Unit) or not unit.dimension or span.text.count("Q") > _OTHERS:
            continue
        step = Unit(term.written, unit.dimension, unit.scale * Fraction(amount), unit.pi, unit.zero)
        one = claimed(reading, names[0], offset, partial(has_unit, unit=step))
        if one is not None and Unit.parse(one.field.definition.units) is not None:
            text = f"{one.name} {_own(one.field)}, not {term.written}"
            yield reading.found(as_sure(UNIT, is_sure=False), span.place(offset), f"{one.name} in {term.written}", text)


_CELL = pattern(r"\|\s*Q\s*(?=\||$)")
_UNIT_HEAD = pattern(r"\bunits?\b|\bresolution|\blsb\b|\bscal", re.IGNORECASE)
_OTHERS = 1
"""Amounts of a row of which one is a unit."""


def _unit(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """The first unit that is said of the names."""
    span, text = said.span, said.span.text
    before = _before(said)
    if before is not None:
        yield from _found(reading, said, before)
        return
    for offset, _ in span.sentence.within(said.end, said.until, "U"):
        gap, behind = _NUMBERED.sub(r"\1", text[said.end : offset]), text[offset + 1 :]
        if _is_of_else(said, _STORED.sub(" is in ", gap), behind) or (";" in gap and "N" in gap):
            return
        is_column = gap == " " and (
            span.is_comment or span.kind is PassageKind.ITEM
        )  # "heading, target_heading    deg"
        gap = _STORED.sub(" is in ", gap)
        if (
            not (_PLACE.search(gap) or is_column)
            or not _IS_SHORT.match(behind)
            or len(gap) > _GAP_LONG
            or _is_own(span, offset)
            or ELSEWHERE.match(behind)
            or is_after_factor(said, offset)
        ):
            continue
        if len(said.names) > 1 and pattern(r"U(?:,? and |, ?| ?/ ?)U").match(text[offset:]):
            yield from _each(reading, said, offset)
        else:
            yield from _found(reading, said, offset)
        return


_STORED = pattern(r"^ (?:is|are) stored in (?=(?:whole |plain )?$)")
"""Between a field and its unit: so it is on the wire."""


def _before(said: Said) -> int | None:
    """The offset of a unit in front of the names: "in deg/s (`xgyro`, `ygyro`)", "unit of `alt`"."""
    text = said.span.text
    before = _UNIT_OF.search(text, max(said.before, said.start - 30), said.start)
    is_held = text[said.start - 1 : said.start] == "(" and text[said.end : said.end + 1] == ")"
    held = pattern(r"U \($").search(text[max(said.before, said.start - 4) : said.start]) if is_held else None
    return text.rindex("U", 0, said.start) if held is not None or (before and "U" in before[0]) else None


_UNIT_OF = pattern(r"\b(?:units? of|U (?:in|for|of)|unit for) (?:the )?(?:fields? )?$")


def _is_of_else(said: Said, gap: str, behind: str) -> bool:
    """Return whether the words behind names are no longer about their unit."""
    if _NOT.search(_last_clause(gap)) or _SCALED_AFTER.match(behind):
        return True
    if _REPORTED.search(gap) and _TURNED.match(behind):
        return True
    if "}" in gap and not said.span.is_code:
        return True  # `{"yaw": 90}`, degrees: a key of somebody's own data
    is_factor = said.span.is_code and "N" in gap and "[" not in gap and not is_data(said.span)
    names_other = "M" in pattern(r"(?:#|//|/\*) M[,:]").sub("", gap).replace("of M", "").replace("in M", "").replace(
        "from M", ""
    )
    return is_factor or names_other or ("Q" in gap and not said.is_listed)


def _is_own(span: Span, offset: int) -> bool:
    """Return whether a unit belongs to a computation in code, to a column about something else, or is a key's name."""
    if is_data(span):
        return (
            span.text[offset + 1 : offset + 2] == ":"
            or _SHOWN_KEY.search(span.text, max(offset - 24, 0), offset) is not None
        )
    if span.is_code and not span.is_comment and not span.sentence.term(offset).is_quoted:
        return pattern(r"#|//|/\*|;|--").search(span.text[:offset]) is None
    return span.kind is PassageKind.ROW and _OWN_COLUMN.search(head_of(span, offset)) is not None


_REPORTED = pattern(
    r"\b(?:the|an?|its|our) (?:[a-z-]+ ){1,3}(?:reports?|sends?|gives?|delivers?|outputs?|measures?|counts?|has|uses?"
    r"|speaks?|works)(?: in| whole| plain)* $"
)
_TURNED = pattern(r"[^.;|]{0,60}\b(?:divid|multipl|convert|scale[sd]?\b|turn(?:s|ed) (?:it|that|them|this) into)")
"""Behind the unit that something else has: what is done to get the field from it."""
_SHOWN_KEY = pattern(r"\b(?:suffix|label|display\w*|shown\w*|format|to|output\w*|title|caption) ?[:=] ?$")
"""Before the unit of what is shown of a field."""
_OWN_COLUMN = pattern(
    r"\bour|shown|display|\bapp\b|csv|\blog|convert|\bafter|\bnew\b|\bsi\b|scaled|topic|\bros\b|\bpage|output"
    r"|exported|screen|column",
    re.IGNORECASE,
)


def _each(reading: Reading, said: Said, offset: int) -> list[Diagnostic]:
    """ "`a`, `b`: floats (m and m/s)": as many units as names."""
    listed = pattern(r"U(?:(?:,? and |, ?| ?/ ?)U)+").match(said.span.text[offset : said.until])
    if listed is None or listed[0].count("U") != len(said.names):
        return []
    units = [at for at, _ in said.span.sentence.within(offset, offset + listed.end(), "U")]
    found = []
    for name, at in zip(said.names, units, strict=True):
        one, unit = about(reading, said.span, name), said.span.sentence.term(at).value
        if one is not None and isinstance(unit, Unit) and one.is_wrong(partial(has_unit, unit=unit)):
            written = said.span.sentence.term(at).written
            text = f"{one.name} is in {one.field.definition.units}, not {written}"
            found.append(
                reading.found(as_sure(UNIT, is_sure=one.is_sure), said.span.place(at), f"{one.name} in {written}", text)
            )
    return found


def _last_clause(gap: str) -> str:
    """Return the words from the last pronoun on: "it is in cm" of "is divided by 1000, although it is in cm"."""
    return _PRONOUN.split(gap)[-1]


_PRONOUN = pattern(
    r"\b(?:although|but|and|because|since|while|as|:|;)? ?(?:it|they|which|that|this)(?=(?: field| one)? (?:is"
    r"|are|has|comes?|counts?)\b)"
    r"|\b(?:because|since|as) its(?= in $)"
)


def _found(reading: Reading, said: Said, offset: int) -> Iterator[Diagnostic]:
    term = said.span.sentence.term(offset)
    unit = term.value
    assert isinstance(unit, Unit)
    if _AS_TYPE.search(said.span.text, max(offset - 12, 0), offset) and term.written in ("byte", "bytes"):
        return
    factor = factor_beside(said.span, offset)
    one = claimed(
        reading,
        said,
        offset,
        lambda field: has_unit(field, unit) or (factor is not None and turns(field, unit, factor)),
    )
    if one is not None and one.message.field(term.written) is not None:
        return  # a field that is called as a unit is, in a list of names
    if one is not None and not is_told_behind(said.span, offset, one.field, said.names):
        text = f"{one.name} {_own(one.field)}, not {term.written}"
        yield reading.found(
            as_sure(UNIT, is_sure=one.is_sure), said.span.place(offset), f"{one.name} in {term.written}", text
        )


_AS_TYPE = pattern(r"\b(?:is|are) (?:a |single |one |both )?$")
"""Before "bytes": it is the type that is told."""


def _own(field: WireField) -> str:
    return f"is in {units}" if (units := shown_units(field)) else "has no unit"
