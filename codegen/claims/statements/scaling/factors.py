"""Factors by which the numbers of fields are said to be scaled: "divided by 100 for degrees", "degrees times 10^7"."""

import re
from collections.abc import Iterator
from fractions import Fraction
from functools import partial

from codegen.claims.parts.span import Span
from codegen.claims.reading import Reading
from codegen.claims.rules import SCALING, as_sure
from codegen.claims.statements.fields import Said, claimed, number
from codegen.claims.statements.scaling.field_units import described_units, is_same_unit, of_field, shown_units
from codegen.diagnostics import Diagnostic
from codegen.load.prose import PassageKind
from codegen.model.dialect.dialect import WireField
from codegen.model.units.unit import Unit, conversion
from codegen.pattern import pattern

_FACTOR = pattern(
    r"\b(?P<how>divid\w*|multipl\w*)\b[^.;|]{0,40}?\b(?:by|with) (?P<number>N)[,:]?"
    r"(?: (?:for|to get|to give|gives?|is|makes?|to obtain|into|to|if you want|yields?|->|=|turns it into|results in"
    r"|and rounds?(?: it| them)? to(?: whole| full)?"
    r"|and you (?:have|get)|you get)(?: (?:the|an?|whole|value|it|in|get|as|values|number|angle|height|altitude"
    r"|speed))*(?: (?:[a-z-]+ ){1,4}?in)?)? (?P<unit>U)",
    needs="divid|multipl",
)
_SIGN = pattern(
    r"(?<!U )(?<!U)(?P<how>[/*\u00d7\u00f7]|\btimes\b) ?(?P<number>N)"
    r"(?: ?(?:=|gives?|is|->|\u2192|for|to|in|makes|[#(|]|//))+ ?(?:in )?(?P<unit>U)"
)
_COMMENTED = pattern(
    r"\)* ?(?P<how>[/*]) ?\(?(?P<number>N)[)\]}]*[;,]? *(?://|#"
    r"|/\*) ?(?:[a-zVEP ,;:()-]{0,40}[ ,(])??(?P<unit>U)(?=\s*(?:[,.;)]|\*/|$|[a-z]))"
)
"""A factor of code whose result the comment behind it tells the unit of."""
_WANTED = pattern(
    r"\b(?:to get|to give|to obtain|for|to have|in order to get) (?:the )?(?:[a-z]+ in )?(?P<unit>U),?"
    r" (?:you )?(?:(?:can |have to |must )?(?:divide|multiply) )?(?:the |field )*$"
)
_EQUATION = pattern(r"\b(?:value |height |number )?in (?P<unit>U) ?= ?(?:the )?$")
_BY = pattern(r"\b(?P<how>divid\w*|multipl\w*)\b[^.;|]{0,20}? (?:by|with) (?P<number>N)")
_SCALE = pattern(
    r"\b(?:scaled? (?:by|with)|scaling(?: factor)?(?: of| is|:)?|scale(?: factor)?(?: of| is|:)?|factor(?: of| is"
    r"|:)?|multiplied by|times|[*\u00d7x]) (?P<number>N)(?!\s?[./%\w])"
)


def factors(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """A factor between the number and another unit, which the unit of the dialect has to make the same."""
    span, text = said.span, said.span.text
    start = said.end
    lead = re.search(
        r"\b(?:divid|multipl)\w* (?:the |both |all )?(?:fields? |values? (?:of )?)?$",
        text[max(said.before, said.start - 40) : said.start],
    )
    if lead is not None:
        start = max(said.before, said.start - 40) + lead.start()
    elif pattern(r"\b(?:divid|multipl)\w*\b[^.;]{0,25}$").search(text[max(said.before, said.start - 40) : said.start]):
        return
    yield from _named_factor(reading, said)
    wanted = _WANTED.search(text, max(said.before, said.start - 40), said.start)
    wanted = wanted or _EQUATION.search(text, max(said.before, said.start - 40), said.start)
    for form in (_FACTOR, _SIGN, *((_COMMENTED,) if span.is_code else ())) if wanted is None else (_BY, _APPLIED):
        found = form.match(text, said.end, said.until) if form is _COMMENTED else form.search(text, start, said.until)
        if (
            found is None
            or found.end() <= said.end
            or re.search(r"\bnot\b|n't|wrong|\bif you\b|\bremainder\b|\bmodulo\b|\brest\b", text[start : found.start()])
        ):
            continue
        value = number(span.sentence.term(found.start("number")))
        unit = span.sentence.term((wanted or found).start("unit")).value
        if not value or not isinstance(unit, Unit):
            continue
        is_division = found["how"].startswith("divid") or found["how"] in ("/", "\u00f7")
        stated = 1 / Fraction(value) if is_division else Fraction(value)
        one = claimed(reading, said, found.start(), partial(turns, unit=unit, stated=stated))
        is_turned = form in (_SIGN, _COMMENTED) or _comes_from(span, (said.end, found.start()), unit, stated)
        if one is not None and not (is_turned and _is_raw(unit, one.field)):
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
        r"\bnot\b|n't|wrong|\bour\b|\bwe\b|\bby us\b|=|\bremainder\b|\bmodulo\b|\brest\b|dths? $|\btenths? $",
        text[said.end : found.start()],
    ):
        value = number(span.sentence.term(found.start("number")))
        is_power = value is not None and value >= 10 and str(value).strip("0") == "1"
        one = claimed(reading, said, found.start(), lambda field: has_scale(field, value)) if is_power else None
        if one is not None:
            shown = text_of(span, found)
            words = f"{one.name} is in {shown_units(one.field)}, which {shown} does not agree with"
            yield reading.found(
                as_sure(SCALING, is_sure=one.is_sure), span.place(found.start()), f"{one.name} {shown}", words
            )


def _comes_from(span: Span, bounds: tuple[int, int], unit: Unit, stated: Fraction) -> bool:
    """Return whether a unit before a factor is made another one by it: "the sensor has mm/s, divided by 1000 m/s"."""
    given = (term.value for _, term in span.sentence.within(*bounds, "U"))
    turned = (conversion(each, unit) for each in given if isinstance(each, Unit))
    return any(each is not None and each.ratio == stated for each in turned)


def _is_raw(unit: Unit, field: WireField) -> bool:
    """Return whether the unit behind a factor is the field's own: another value is then scaled to it, not the field."""
    own = Unit.parse(field.definition.units)
    return own is not None and is_same_unit(own, unit)


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
_CALLED = pattern(r"(?<![\w.])[a-z][a-z0-9]*(?:_[a-z0-9]+)*?(?:_(?P<snake>[a-zA-Z]+)|(?P<camel>[A-Z][a-z]+))(?![\w(])")
_APPLIED = pattern(r"(?: \||\)| as T| as f64)* ?(?P<how>[/*]) ?(?P<number>N)(?: ?[|;,)\]}]|$)")


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
    one = claimed(reading, said, found.start(), lambda field: turns(field, unit, stated))
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


def turns(field: WireField, unit: Unit, stated: Fraction) -> bool:
    """Return whether the number of a field times a factor is one in a unit, or the two cannot be compared."""
    own = Unit.parse(field.definition.units)
    turned = conversion(own, of_field(unit, field)) if own is not None else None
    if turned is None or turned.ratio is None:
        return True
    return stated in (turned.ratio, turned.ratio * field.multiplier)


_LEAST = 1000
"""The least factor by which a description scales: "10" may be the beginning of a power."""
_STEPS = pattern(
    r"(?:.*E(?P<tens>\d)|(?P<prefix>[mcdu])(?:deg|degC|m|m/s|V|A|Ah|rad|rad/s|s|%|gauss|Pa|W|T|G)|.*\*(?P<factor>\d+))"
)


def has_scale(field: WireField, value: float | Fraction | None) -> bool:
    """Return whether a number is the factor between a field's unit and the same one without a prefix."""
    found = _STEPS.fullmatch(field.definition.units or "")
    if found is None:
        told = described_units(field)
        return (
            not told
            or value is None
            or value < _LEAST
            or any(1 / unit.scale == value or unit.scale == value for unit in told)
        )
    if found["tens"]:
        return value == Fraction(10) ** int(found["tens"])
    if found["factor"]:
        return value == int(found["factor"])
    return value == {"m": 1000, "c": 100, "d": 10, "u": 1000000}[found["prefix"]]
