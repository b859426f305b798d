"""Units that are said of fields, and the factors by which their numbers are scaled."""

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.reading import Reading
from codegen.claims.rules import SCALING, UNIT, as_sure
from codegen.claims.statements.fields import Said, claimed, number, said_of_fields
from codegen.claims.statements.spans import Span, about, is_data
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit, conversion, unit_named

_PLACE = re.compile(
    r"(?:\b(?:in|as|units? (?:is|are|of|was)|units?:?|counts?|holds?|uses?|carries|contains?|gives?|measures?"
    r"|reports?|measured in|is|are|be)"
    r"(?: (?:whole|full|plain|integer|the|an?|steps of|units of|multiples of|always))*|[(\[|:,=#*/\u2013\u2014-]"
    r"|\bT|\"|^)\s*$"
)
_IS_SHORT = re.compile(
    r"\s*(?:[,.;:)\]|}(]|\*/|$|(?:and|if|when|since|for|or|above|below|from|at|over|as|with|relative|positive|per"
    r"|but|because|while|on|of|to|up)\b|[-\u2013\u2014])"
)
_NOT = re.compile(
    r"\bnot\b|n't\b|divid|multipl|convert|\bshow|display|\bplot|\blogs?\b|\bour\b|\bwe\b|\bmy\b|rather|instead"
    r"|\bwas\b|\bwere\b"
    r"|\bchanged?\b|\bfrom an? T(?! to an? T in )"
    r"|\buntil\b|\bscaled|\binto\b|becomes?\b|\bwrong|\bold\b|\bstor|round|\bthan\b"
    r"|\bprint|\bwould\b|\bcould\b|\bbecause\b|\bafter\b"
    r"|\bif\b|\bwhen\b|\bevery\b|\blimit|\bstep\b|\berror|\baccura|\bresol|\btimeout\b|\bneed|/ ?N|\* ?N"
    r"|\bcomputed|\bfrom U|\bsteps\b(?! of)|\btimes\b|\bbetween\b|\bfeed|\bread(?:ing)?s? as\b"
    r"|\b(?:and|while|whereas|but) (?:the|its|all|both|their) |, the \w|\byou get\b|\bwrote\b|\btake|\blike\b"
    r"|\bunlike\b|\bour"
)
_SCALED_AFTER = re.compile(
    r"[^.;|]{0,3}(?:times\b|from the (?:start|beginning|end)|x ?N|\* ?N|/ ?N|after|by us|in our|on (?:the|our) (?:screen|display)|here\b|is wrong"
    r"|was wrong|\?|, which is wrong)"
)
_GAP_LONG = 90
_FACTOR = re.compile(
    r"\b(?P<how>divid\w*|multipl\w*)\b[^.;|]{0,40}?\b(?:by|with) (?P<number>N)[,:]?"
    r"(?: (?:for|to get|gives?|is|makes?|to obtain|into|to|if you want|yields?|->|=|turns it into|results in"
    r"|and you (?:have|get)|you get)(?: (?:the|an?|whole|value|it|in|get|as|values|number|angle|height|altitude"
    r"|speed))*)? (?P<unit>U)"
)
_SIGN = re.compile(
    r"(?<!U )(?<!U)(?P<how>[/*\u00d7\u00f7]|\btimes\b) ?(?P<number>N)"
    r"(?: ?(?:=|gives?|is|->|\u2192|for|to|in|makes|[#(|]|//))+ ?(?:in )?(?P<unit>U)"
)
_WANTED = re.compile(
    r"\b(?:to get|to obtain|for|to have|in order to get) (?:the )?(?:[a-z]+ in )?(?P<unit>U),? (?:the |field )*$"
)
_EQUATION = re.compile(r"\b(?:value |height |number )?in (?P<unit>U) ?= ?(?:the )?$")
_BY = re.compile(r"\b(?P<how>divid\w*|multipl\w*)\b[^.;|]{0,20}? (?:by|with) (?P<number>N)")
_SCALE = re.compile(
    r"\b(?:scaled? (?:by|with)|scaling(?: factor)?(?: of| is|:)?|scale(?: factor)?(?: of| is|:)?|factor(?: of| is"
    r"|:)?|multiplied by|times|[*\u00d7x]) (?P<number>N)(?!\s?[./%\w])"
)


def check(reading: Reading, span: Span) -> Iterator[Diagnostic]:
    """Every unit and every factor of a part."""
    for said in said_of_fields(span):
        found = list(_factor(reading, said))
        yield from found or _unit(reading, said)


def of_field(unit: Unit, field: WireField) -> Unit:
    """The unit as the words for it are meant of a field: degrees of a temperature are degrees Celsius."""
    own = Unit.parse(field.definition.units)
    if own is not None and own.dimension == unit_named("degC").dimension and unit.name.startswith(("deg", "C")):
        return Unit(
            unit.name,
            own.dimension,
            unit.scale / (1 if unit.name.startswith("deg") else unit_named("C").scale),
            0,
            unit_named("degC").zero,
        )
    if own is not None and own.dimension == unit_named("gauss").dimension and unit.name in ("G", "mG"):
        return unit_named("gauss" if unit.name == "G" else "mgauss")
    return unit


def is_same_unit(one: Unit, other: Unit) -> bool:
    """Whether numbers in either are the same."""
    return (one.dimension, one.scale, one.pi) == (other.dimension, other.scale, other.pi)


_UNITLESS = re.compile(r"\bunitless\b|\bdimensionless\b", re.IGNORECASE)


def has_unit(field: WireField, unit: Unit) -> bool:
    """Whether a unit is that of a field; also where either has none to compare."""
    own = Unit.parse(field.definition.units)
    stated = of_field(unit, field)
    if own is None and stated.dimension and _UNITLESS.search(field.definition.description):
        return False
    if own is None or not stated.dimension:
        return True
    if field.multiplier != 1:
        finer = Unit(own.name, own.dimension, own.scale * field.multiplier, own.pi, own.zero)
        if is_same_unit(stated, finer):
            return True
    return is_same_unit(stated, own)


def _unit(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """The first unit that is said of the names."""
    span, text = said.span, said.span.text
    before = _before(said)
    if before is not None:
        yield from _found(reading, said, before)
        return
    for offset, _ in span.sentence.within(said.end, said.until, "U"):
        gap, behind = text[said.end : offset], text[offset + 1 :]
        if _is_of_else(said, gap, behind) or (";" in gap and "N" in gap):
            return
        is_column = span.is_comment and gap == " " and not behind.strip()  # "# heading, target_heading    deg"
        if (
            not (_PLACE.search(gap) or is_column)
            or not _IS_SHORT.match(behind)
            or len(gap) > _GAP_LONG
            or _is_own(span, offset)
        ):
            continue
        if len(said.names) > 1 and re.match(r"U(?:,? and |, ?| ?/ ?)U", text[offset:]):
            yield from _each(reading, said, offset)
        else:
            yield from _found(reading, said, offset)
        return


def _before(said: Said) -> int | None:
    """The offset of a unit in front of the names: "in deg/s (`xgyro`, `ygyro`)", "unit of `alt`"."""
    text = said.span.text
    before = _UNIT_OF.search(text, max(said.before, said.start - 30), said.start)
    is_held = text[said.start - 1 : said.start] == "(" and text[said.end : said.end + 1] == ")"
    held = re.search(r"U \($", text[max(said.before, said.start - 4) : said.start]) if is_held else None
    return text.rindex("U", 0, said.start) if held is not None or (before and "U" in before[0]) else None


_UNIT_OF = re.compile(r"\b(?:units? of|U (?:in|for|of)|unit for) (?:the )?(?:fields? )?$")


def _is_of_else(said: Said, gap: str, behind: str) -> bool:
    """Whether what follows names is no longer about their unit."""
    if _NOT.search(_last_clause(gap)) or _SCALED_AFTER.match(behind):
        return True
    is_factor = said.span.is_code and "N" in gap and "[" not in gap and not is_data(said.span)
    names_other = "M" in re.sub(r"(?:#|//|/\*) M[,:]", "", gap).replace("of M", "").replace("in M", "").replace(
        "from M", ""
    )
    return is_factor or names_other or ("Q" in gap and not said.is_listed)


def _is_own(span: Span, offset: int) -> bool:
    """Whether a unit is what code computes, what a column of another thing holds, or the name of a key."""
    if is_data(span):
        return span.text[offset + 1 : offset + 2] == ":"
    if span.is_code and not span.is_comment and not span.sentence.term(offset).is_quoted:
        return re.search(r"#|//|/\*|;|--", span.text[:offset]) is None
    return span.kind is PassageKind.ROW and _OWN_COLUMN.search(head_of(span, offset)) is not None


_OWN_COLUMN = re.compile(
    r"\bour|shown|display|\bapp\b|csv|\blog|convert|\bafter|\bnew\b|\bsi\b|scaled|topic|\bros\b|\bpage|output"
    r"|exported|screen|column",
    re.IGNORECASE,
)


def head_of(span: Span, offset: int) -> str:
    """The heading of the column in which a character of a row stands."""
    column = span.text.count("|", 0, offset) - span.text.lstrip().startswith("|")
    return span.heads[column] if column < len(span.heads) else ""


def _each(reading: Reading, said: Said, offset: int) -> list[Diagnostic]:
    """ "`a`, `b`: floats (m and m/s)": as many units as names."""
    listed = re.match(r"U(?:(?:,? and |, ?| ?/ ?)U)+", said.span.text[offset : said.until])
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
    """What is said by a pronoun after something else: "is divided by 1000, although it is in cm"."""
    return _PRONOUN.split(gap)[-1]


_PRONOUN = re.compile(
    r"\b(?:although|but|and|because|since|while|as|:|;)? ?(?:it|they|which|that|this)(?=(?: field| one)? (?:is"
    r"|are|has|comes?|counts?)\b)"
)


def _found(reading: Reading, said: Said, offset: int) -> Iterator[Diagnostic]:
    term = said.span.sentence.term(offset)
    unit = term.value
    assert isinstance(unit, Unit)
    one = claimed(reading, said, offset, lambda field: has_unit(field, unit))
    if one is not None:
        text = f"{one.name} {_own(one.field)}, not {term.written}"
        yield reading.found(
            as_sure(UNIT, is_sure=one.is_sure), said.span.place(offset), f"{one.name} in {term.written}", text
        )


def _own(field: WireField) -> str:
    return f"is in {field.definition.units}" if field.definition.units else "has no unit"


def _factor(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """A factor between the number and another unit, which the unit of the dialect has to make the same."""
    span, text = said.span, said.span.text
    start = said.end
    lead = re.search(
        r"\b(?:divid|multipl)\w* (?:the |both |all )?(?:fields? |values? (?:of )?)?$",
        text[max(said.before, said.start - 40) : said.start],
    )
    if lead is not None:
        start = max(said.before, said.start - 40) + lead.start()
    elif re.search(r"\b(?:divid|multipl)\w*\b[^.;]{0,25}$", text[max(said.before, said.start - 40) : said.start]):
        return
    yield from _named_factor(reading, said)
    wanted = _WANTED.search(text, max(said.before, said.start - 40), said.start)
    wanted = wanted or _EQUATION.search(text, max(said.before, said.start - 40), said.start)
    for form in (_FACTOR, _SIGN) if wanted is None else (_BY, _APPLIED):
        found = form.search(text, start, said.until)
        if (
            found is None
            or found.end() <= said.end
            or re.search(r"\bnot\b|n't|wrong|\bif you\b", text[start : found.start()])
        ):
            continue
        value = number(span.sentence.term(found.start("number")))
        unit = span.sentence.term((wanted or found).start("unit")).value
        if not value or not isinstance(unit, Unit):
            continue
        is_division = found["how"].startswith("divid") or found["how"] in ("/", "\u00f7")
        stated = 1 / Fraction(value) if is_division else Fraction(value)
        one = claimed(reading, said, found.start(), partial(_turns, unit=unit, stated=stated))
        if one is not None:
            shown = text_of(span, found)
            words = f"{one.name} is in {one.field.definition.units}, which {shown} does not agree with"
            yield reading.found(
                as_sure(SCALING, is_sure=one.is_sure), span.place(found.start()), f"{one.name} {shown}", words
            )
        return
    found = _SCALE.search(text, said.end, said.until)
    if found is not None and span.kind is PassageKind.ROW and "Q" in text[: said.start]:
        return  # what is in steps of 0.1 deg in another format is turned into the field
    if found is not None and not re.search(
        r"\bnot\b|n't|wrong|\bour\b|\bwe\b|\bby us\b|=", text[said.end : found.start()]
    ):
        value = number(span.sentence.term(found.start("number")))
        is_power = value is not None and value >= 10 and str(value).strip("0") == "1"
        one = claimed(reading, said, found.start(), lambda field: _has_scale(field, value)) if is_power else None
        if one is not None:
            shown = text_of(span, found)
            words = f"{one.name} is in {one.field.definition.units}, which {shown} does not agree with"
            yield reading.found(
                as_sure(SCALING, is_sure=one.is_sure), span.place(found.start()), f"{one.name} {shown}", words
            )


_SUFFIXES = {
    **{name: name for name in ("km", "cm", "mm", "m", "deg", "rad", "ms", "us", "mV", "mA", "hPa", "V", "A", "s")},
    "v": "V",
    "a": "A",
    "mv": "mV",
    "ma": "mA",
    "mps": "m/s",
    "kmh": "km/h",
    "kph": "km/h",
    "percent": "%",
    "pct": "%",
    "hpa": "hPa",
    "c": "degC",
    "celsius": "degC",
    "meters": "m",
    "metres": "m",
    "degrees": "deg",
    "volts": "V",
    "amps": "A",
    "seconds": "s",
    "millis": "ms",
    "radians": "rad",
}
_CALLED = re.compile(
    r"(?<![\w.])[a-z][a-z0-9]*(?:_[a-z0-9]+)*?(?:_(?P<snake>[a-zA-Z]+)|(?P<camel>[A-Z][a-z]+))(?![\w(])"
)
_APPLIED = re.compile(r"(?: \||\)| as T| as f64)* ?(?P<how>[/*]) ?(?P<number>N)(?: ?[|;,)\]}]|$)")


def _named_factor(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """``altMetres = r.alt / 100`` and ``| mcu_c | MCU_STATUS.temperature | / 10 |``: a name tells the unit."""
    span = said.span
    found = _APPLIED.match(span.text, said.end, said.until + 1)
    if found is None or not (span.is_code or span.kind is PassageKind.ROW):
        return
    source = span.source_text(0, said.start)
    names = list(_CALLED.finditer(source))
    suffix = next(
        (
            (each["snake"] or each["camel"].lower())
            for each in names
            if (each["snake"] or each["camel"].lower()) in _SUFFIXES
        ),
        None,
    )
    unit = Unit.parse(_SUFFIXES[suffix]) if suffix is not None else None
    value = number(span.sentence.term(found.start("number")))
    if unit is None or not value:
        return
    stated = 1 / Fraction(value) if found["how"] == "/" else Fraction(value)
    one = claimed(reading, said, found.start(), lambda field: _turns(field, unit, stated))
    if one is not None:
        shown = f"{found['how']} {span.sentence.term(found.start('number')).written}"
        words = f"{one.name} is in {one.field.definition.units}, which {shown} does not make {unit.name}"
        yield reading.found(as_sure(SCALING, is_sure=one.is_sure), span.place(said.start), f"{one.name} {shown}", words)


def text_of(span: Span, found: "re.Match[str]") -> str:
    """The words of the source that a match over the short text stands for."""
    terms = span.sentence.terms
    return "".join(
        terms[at].written if at in terms else span.text[at] for at in range(found.start(), found.end())
    ).strip()


def _turns(field: WireField, unit: Unit, stated: Fraction) -> bool:
    own = Unit.parse(field.definition.units)
    turned = conversion(own, of_field(unit, field)) if own is not None else None
    if turned is None or turned.ratio is None:
        return True
    return stated in (turned.ratio, turned.ratio * field.multiplier)


_STEPS = re.compile(
    r"(?:.*E(?P<tens>\d)|(?P<prefix>[mcdu])(?:deg|degC|m|m/s|V|A|Ah|rad|rad/s|s|%|gauss|Pa|W|T|G)|.*\*(?P<factor>\d+))"
)


def _has_scale(field: WireField, value: float | Fraction | None) -> bool:
    """Whether a number is the factor of a field's unit over the one without a prefix."""
    found = _STEPS.fullmatch(field.definition.units or "")
    if found is None:
        return True
    if found["tens"]:
        return value == Fraction(10) ** int(found["tens"])
    if found["factor"]:
        return value == int(found["factor"])
    return value == {"m": 1000, "c": 100, "d": 10, "u": 1000000}[found["prefix"]]
