"""What sentences and lists say of the unit of a field, and of the factor by which it is scaled."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.about import Said
from codegen.claims.reading import Reading, between
from codegen.claims.sentinel import UNIT
from codegen.claims.unit_claim import is_same_unit
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import PassageKind
from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import Unit, conversion, unit_named

SCALING = Rule(
    "claim-scaling",
    "A document says that the number of a field is to be multiplied or divided by another factor than its unit in the "
    "dialect has. Whoever follows it is wrong by that factor. Correct it.",
)
_UNIT = r"[A-Za-z%\u00b5\u00b0][A-Za-z0-9/%^*\u00b2\u00b3]{0,18}"
_LONG = (
    r"(?:nano|micro|milli|centi|deci|hecto|kilo)?"
    r"(?:degrees Celsius|volts?|amps?|amperes?|met(?:re|er)s?|degrees?|radians?"
    r"|seconds?|grams?|pascals?|bytes|bits|percent|watts?|joules?|gauss|knots)(?: per (?:second|hour|minute))?"
)
_IN_UNIT = re.compile(
    rf"\b(?:in|(?:reported|given|expressed|sent|coded|encoded) as) (?:whole |full )?"
    rf"(?P<unit>{_LONG}|{_UNIT}(?: per [a-z]{{1,9}})?)"
    r"(?=\s*(?:[,.;:)(|]|$|if\b|and\b|for\b|above\b|below\b|since\b"
    r"|before\b|at\b|from\b|as\b|over\b|\u2013|\u2014))"
)
_HOLDS = re.compile(
    rf"\s*(?:holds?|uses?|counts?|carries|contains?|are|is|gives?)(?: whole)? (?P<unit>{_LONG})\b(?! of\b)"
)
_BESIDE = re.compile(
    rf"[`\s]*(?:[(\[](?:in |[^()\[\]]{{1,40}}?, )?(?P<unit>{_UNIT})[)\]]"
    rf"|: (?P<alone>{_LONG}|{_UNIT})(?=\s*(?:[.,;]|$)))"
)
_HAS_UNIT = re.compile(rf"[^.;]{{0,20}}?\bunit(?: is|:| of)? (?P<unit>{_UNIT})(?=\s*(?:[,.;:)(|]|$|and\b))")
_AT_END = re.compile(rf"(?:,[^.;,]{{0,40}}){{0,2}}, (?P<unit>{_UNIT})\.?\s*$")
_UNIT_OF = re.compile(r"\bunit of (?:the )?(?:field )?$", re.IGNORECASE)
_OF_WHICH = re.compile(rf"(?: of [A-Z_0-9]+)? is (?:the )?(?P<unit>{_LONG}|{_UNIT})\b")
_BEFORE = re.compile(rf"\bin (?P<unit>{_LONG}|{_UNIT}) \((?:field )?$")
_BEHIND_TYPE = re.compile(rf"[\s)]*[,:;(]\s*(?P<unit>{_UNIT})(?=\s*(?:[,.;:)(|]|$|\u2013))")
_SCALED = re.compile(
    r"\btimes\b|multipl|divid|scal|convert|\bshown?\b|\bdisplay|\bplot|\bafter\b|\bwe\b|\bour\b|\b1e-?\d"
    r"|\bE\d|10\^|\bx ?1|\bnot\b"
    r"|\blog\b|\bstore|/ ?1|\* ?1|tenth|\bchanged?\b|\bfrom an?\b|hundredth|thousandth|\binto\b|\bwrong",
    re.IGNORECASE,
)
_NEAR = 12
"""Characters behind a unit in which words may say that the value is scaled."""
_VERB = len("multiplied ")
"""Characters before the name of a field in which ``divide`` may stand."""
_NUMBER = r"(?P<number>\d{1,3}(?:[ ,]?\d{3})*(?:\.\d+)?(?:[eE]-?\d{1,2})?|10\^\d{1,2})"
_FACTOR = re.compile(
    rf"\b(?P<how>divid\w*|multipl\w*)(?: it| them| the value| [a-z]\w{{0,60}})? (?:by|with) {_NUMBER}"
    rf"(?: (?:for|to get|gives?|is|makes?)(?: (?:the|a|an|whole)\b)? ?(?P<unit>{_UNIT}))",
    re.IGNORECASE,
)
_TIMES = re.compile(rf"\bin (?P<unit>{_UNIT}) (?:times|\*|x) {_NUMBER}(?![\w])", re.IGNORECASE)
_AND = r",? and |, |/"
_PLAIN = re.compile(
    rf"\b(?P<names>[a-z][a-z0-9_]{{2,30}}(?:(?:{_AND})[a-z][a-z0-9_]{{1,30}}){{0,6}})(?: angles?| rates?| values?)?"
    rf"(?: are| is| as| given| all)* in (?P<unit>{_UNIT})(?=\s*(?:[,.;:)]|$|and\b|at\b|for\b))"
)
_PLAIN_BESIDE = re.compile(rf"(?<![\w.])(?P<names>[a-z][a-z0-9_]{{1,30}}) [(\[](?P<unit>{_UNIT})[)\]]")
_PARTS = re.compile(
    rf"\b(?:in|counts|holds|of|as) (?P<part>tenths|hundredths|thousandths) of (?:an? )?(?P<unit>{_UNIT})", re.IGNORECASE
)
_SHARES = {"tenths": 10, "hundredths": 100, "thousandths": 1000}


def said_units(reading: Reading, said: Said, declared: "re.Match[str] | None") -> Iterator[Diagnostic]:
    """The unit and the factor that are said of a field; ``declared`` is its type, where that stands behind its name."""
    yield from _units(reading, said, declared)
    yield from _scalings(reading, said)


def _units(reading: Reading, said: Said, declared: "re.Match[str] | None") -> Iterator[Diagnostic]:
    """The first unit that is named; none where the sentence is about a value that was scaled."""
    own = Unit.parse(said.field.definition.units)
    text = said.passage.text
    if own is None:
        return
    end = declared.end() if declared else said.end
    is_listed = declared is not None or said.passage.kind is PassageKind.ITEM
    low = max(said.start - 40, 0)
    places = (
        _BEFORE.search(text, low, said.start),
        _OF_WHICH.match(text, said.end, said.until) if _UNIT_OF.search(text, low, said.start) else None,
        _BESIDE.match(text, said.end, said.until),
        _HOLDS.match(text, said.end, said.until),
        _AT_END.match(text, said.end, said.until),
        _HAS_UNIT.match(text, said.end, said.until),
        _IN_UNIT.search(text, said.end, said.until),
        _BEHIND_TYPE.match(text, end, said.until) if is_listed else None,
    )
    for found in filter(None, places):
        group = "alone" if found.groupdict().get("alone") else "unit"
        stated = worded_unit(found[group])
        if stated is None:
            continue
        is_scaled = _SCALED.search(text, said.end, min(max(found.end(), said.end) + _NEAR, said.until))
        if not is_scaled and stated != NO_UNIT and not is_same_unit(stated, own):
            place = said.passage.place_at(found.start(group))
            text = f"{said.name} is in {said.field.definition.units}, not {found[group]}"
            yield reading.found(UNIT, place, f"{said.name} in {found[group]}", text)
        return


def plain_units(reading: Reading) -> Iterator[Diagnostic]:
    """ "ATTITUDE gives roll, pitch and yaw in degrees": names without marks, behind the message that has them all."""
    for passage, mentions in reading.passages_with_messages():
        for found in (*_PLAIN.finditer(passage.text), *_PLAIN_BESIDE.finditer(passage.text)):
            low, high = passage.sentence(found.start(), found.end())
            named = between(mentions, low, found.start())
            message = reading.messages[named[-1].name] if named else None
            fields = [message.field(name) for name in re.split(_AND, found["names"])] if message else []
            unit = worded_unit(found["unit"])
            first = fields[0] if fields else None
            own = Unit.parse(first.definition.units) if first else None
            if message is None or None in fields or unit is None or first is None or own is None:
                continue
            if not is_same_unit(unit, own) and not _SCALED.search(passage.text, low, high):
                text = f"{message.name}.{first.name} is in {first.definition.units}, not {found['unit']}"
                place = passage.place_at(found.start("unit"))
                yield reading.found(UNIT, place, f"{message.name}.{first.name} in {found['unit']}", text)


NO_UNIT = Unit("", (), Fraction(1))


def _scalings(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """A factor between the number and another unit, which that of the dialect has to make the same."""
    own = Unit.parse(said.field.definition.units)
    text = said.passage.text
    for form in (_FACTOR, _TIMES, _PARTS) if own else ():
        start = max(said.start - _VERB, 0) if form is _FACTOR else said.end
        found = form.search(text, start, said.until)
        unit = worded_unit(found["unit"]) if found and found.end() > said.end else None
        if found is None or unit is None or own is None:
            continue
        if unit.name == "deg" and own.dimension == unit_named("degC").dimension:
            unit = unit_named("degC")
        turned = conversion(own, unit)  # a number in `own` becomes one in `unit` by this factor
        if turned is None or turned.ratio is None:
            continue
        if form is _FACTOR:
            number = _number(found["number"])
            stated = 1 / number if found["how"].lower().startswith("divid") else number
        else:
            stated = 1 / (_number(found["number"]) if form is _TIMES else Fraction(_SHARES[found["part"].lower()]))
        if stated != turned.ratio:
            units = said.field.definition.units
            words = f"{said.name} is in {units}, which {found[0].strip()} does not agree with"
            yield reading.found(SCALING, said.passage.place_at(found.start()), f"{said.name} {found[0]}", words)
        return


def _number(written: str) -> Fraction:
    text = written.replace(" ", "").replace(",", "")
    return Fraction(10) ** int(text.partition("^")[2]) if "^" in text else Fraction(text)
