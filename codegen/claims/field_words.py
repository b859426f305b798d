"""What sentences, lists and tables say of a field: its type, its length, its unit, its scaling, and its place."""

import re
from collections.abc import Iterator
from fractions import Fraction

from codegen.claims.about import Said, said_of_fields
from codegen.claims.reading import Reading, between
from codegen.claims.sentinel import UNIT
from codegen.claims.structure import RULE as TYPE
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import PassageKind
from codegen.model.nearest_unit import worded_unit
from codegen.model.unit import Unit, conversion, unit_named

SCALING = Rule(
    "claim-scaling",
    "A document says that the number of a field is to be multiplied or divided by another factor than its unit in the "
    "dialect has. Whoever follows it is wrong by that factor. Correct it.",
)
EXTENSION = Rule(
    "claim-extension",
    "A document calls a base field an extension, or the other way round. Extensions come behind all other fields, do "
    "not count for CRC_EXTRA, and are not sent in MAVLink 1. Correct it.",
)

_TYPE = r"(?P<type>u?int(?:8|16|32|64)(?:_t)?|float|double|char)"
_DECLARED = re.compile(
    rf"[\s(:=,|\u2013\u2014-]*(?:(?:is|are|as|an?|of|type|the field|=)\s+)*{_TYPE}(?![\w])"
    rf"(?:\s?\[\s?(?P<length>\d{{1,3}})\s?\])?"
    r"(?P<array> array)?"
)
_UNIT = r"[A-Za-z%\u00b5\u00b0][A-Za-z0-9/%^*\u00b2\u00b3]{0,18}"
_IN_UNIT = re.compile(
    rf"\bin (?:whole |full )?(?P<unit>{_UNIT}(?: per [a-z]{{1,9}})?)"
    r"(?=\s*(?:[,.;:)(|]|$|if\b|and\b|for\b|above\b|below\b|since\b"
    r"|before\b|at\b|from\b|as\b|over\b|\u2013|\u2014))"
)
_BESIDE = re.compile(rf"[`\s]*[(\[](?:in )?(?P<unit>{_UNIT})[)\]]")
_HAS_UNIT = re.compile(rf"[^.;]{{0,20}}?\bunit(?: is|:| of)? (?P<unit>{_UNIT})(?=\s*(?:[,.;:)(|]|$|and\b))")
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
    rf"(?: (?:for|to get|gives?|is|makes?)(?: (?:the|a|an|whole))? ?(?P<unit>{_UNIT}))",
    re.IGNORECASE,
)
_TIMES = re.compile(rf"\bin (?P<unit>{_UNIT}) (?:times|\*|x) {_NUMBER}(?![\w])", re.IGNORECASE)
_AND = r",? and |, |/"
_PLAIN = re.compile(
    rf"\b(?P<names>[a-z][a-z0-9_]{{2,30}}(?:(?:{_AND})[a-z][a-z0-9_]{{1,30}}){{0,6}})(?: angles?| rates?| values?)?"
    rf"(?: are| is| as| given| all)* in (?P<unit>{_UNIT})(?=\s*(?:[,.;:)]|$|and\b|at\b|for\b))"
)
_PARTS = re.compile(
    rf"\b(?:in|counts|holds|of|as) (?P<part>tenths|hundredths|thousandths) of (?:an? )?(?P<unit>{_UNIT})", re.IGNORECASE
)
_SHARES = {"tenths": 10, "hundredths": 100, "thousandths": 1000}
_NUMBERS = {"two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8, "ten": 10, "twelve": 12}
_COUNT = rf"(?:\d{{1,3}}|{'|'.join(_NUMBERS)})"
_ELEMENTS = re.compile(
    rf"\barray (?:with|of) (?P<exact>{_COUNT}) (?:entries|elements|values|floats|numbers)\b"
    rf"|\b(?:all|up to|at most) (?:its |the )?(?P<most>{_COUNT}) "
    r"(?:entries|elements|values|floats|numbers|sectors|characters|places)\b",
    re.IGNORECASE,
)
_IS_EXTENSION = re.compile(
    r"[\s,]*(?:is|are)(?: all| both)? (?P<no>not )?(?:an? )?(?:(?:MAVLink ?2 )?extensions?|extension fields?)\b",
    re.IGNORECASE,
)
_IS_BASE = re.compile(r"[\s,]*(?:is|are) (?:an? )?base fields?\b", re.IGNORECASE)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Everything that is said of a field by its name."""
    yield from _plain(reading)
    for said in said_of_fields(reading):
        if said.passage.kind is PassageKind.ROW:
            continue  # tables are read by their columns
        declared = _DECLARED.match(said.passage.text, said.end, said.until)
        if declared is not None:
            yield from _types(reading, said, declared)
        else:
            yield from _spelled(reading, said)
        if not said.is_joined:
            yield from _lengths(reading, said)
        yield from _units(reading, said, declared)
        yield from _scalings(reading, said)
        yield from _extensions(reading, said)


def _lengths(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """ "An array with four entries", "all 36 sectors", "up to 64 floats": the elements of an array."""
    found = _ELEMENTS.search(said.passage.text, said.end, said.until) if said.field.is_array else None
    if found is None:
        return
    written = found["exact"] or found["most"]
    number = _NUMBERS.get(written.lower()) or int(written)
    if number != said.field.count:
        text = f"{said.name} has {said.field.count} elements, not {written}"
        yield reading.found(TYPE, said.passage.place_at(found.start()), f"{said.name} {found[0]}", text)


_SIGNS = {"unsigned": "u", "signed": ""}
_SPELLED = re.compile(
    r"[\s(:=,\u2013\u2014-]*(?:(?:is|are|as|an?|type|stored as|sent as|the field)\s+)*(?:(?P<sign>unsigned|signed) )?"
    r"(?:(?P<bits>8|16|32|64)(?:[ -]bits?|bits?)\b|(?P<byte>byte))(?: (?P<after>unsigned|signed))?"
    r"(?: (?P<kind>integers?|ints?|numbers?|words?|floats?|values?))?\b",
    re.IGNORECASE,
)
_SHORT = re.compile(r"[\s(:=,\u2013\u2014-]*(?:(?:is|are|as|an?|of)\s+)*(?P<short>[uif](?:8|16|32|64))\b")


def _spelled(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """ "A 16-bit unsigned integer", "a signed byte", "u32": what is said is compared, the size and the sign."""
    text, field = said.passage.text, said.field
    found = short = _SHORT.match(text, said.end, said.until)
    if found is not None:
        bits, own_sign = int(found["short"][1:]), {"u": "u", "i": "", "f": "f"}[found["short"][0]]
        sign: str | None = own_sign
    else:
        found = _SPELLED.match(text, said.end, said.until)
        if found is None:
            return
        bits = int(found["bits"] or 8)
        said_sign = (found["sign"] or found["after"] or "").lower()
        is_float = (found["kind"] or "").lower().startswith("float")
        sign = "f" if is_float else _SIGNS.get(said_sign)
        if found["byte"] and sign is None:
            return
    if said.is_joined or field.type.name == "char" or (field.is_array and short is None):
        return
    own = "f" if field.type.name in ("float", "double") else "u" if field.type.name.startswith("u") else ""
    if bits != 8 * field.type.size or (sign is not None and sign != own):
        written = found[0].strip(" (:=,-")
        place = said.passage.place_at(found.start())
        yield reading.found(TYPE, place, f"{said.name} {written}", f"{said.name} is {field.type.name}, not {written}")


def _types(reading: Reading, said: Said, found: "re.Match[str]") -> Iterator[Diagnostic]:
    field = said.field
    name = found["type"]
    stated = f"{name}_t" if name[-1].isdigit() else name
    length = int(found["length"]) if found["length"] else None
    own = f"{field.type.name}[{field.count}]" if field.is_array else field.type.name
    written = stated if length is None else f"{stated}[{length}]"
    if said.is_joined and not found[0].lstrip().startswith((":", "(", "are")):
        return  # of several names the last one alone may be meant
    is_right = stated == field.type.name and (length is None or (field.is_array and length == field.count))
    if not is_right:
        place = said.passage.place_at(found.start("type"))
        yield reading.found(TYPE, place, f"{said.name} {written}", f"{said.name} is {own}, not {written}")


def _units(reading: Reading, said: Said, declared: "re.Match[str] | None") -> Iterator[Diagnostic]:
    """The first unit that is named; none where the sentence is about a value that was scaled."""
    own = Unit.parse(said.field.definition.units)
    text = said.passage.text
    if own is None:
        return
    end = declared.end() if declared else said.end
    is_listed = declared is not None or said.passage.kind is PassageKind.ITEM
    places = (
        _BESIDE.match(text, said.end, said.until),
        _HAS_UNIT.match(text, said.end, said.until),
        _IN_UNIT.search(text, said.end, said.until),
        _BEHIND_TYPE.match(text, end, said.until) if is_listed else None,
    )
    found = next((each for each in places if each is not None and worded_unit(each["unit"]) is not None), None)
    stated = worded_unit(found["unit"]) if found else None
    if found is not None and _SCALED.search(text, said.end, min(found.end() + _NEAR, said.until)):
        return
    if found is None or stated is None or stated == NO_UNIT or _is_same(stated, own):
        return
    place = said.passage.place_at(found.start("unit"))
    unit = said.field.definition.units
    yield reading.found(
        UNIT, place, f"{said.name} in {found['unit']}", f"{said.name} is in {unit}, not {found['unit']}"
    )


def _plain(reading: Reading) -> Iterator[Diagnostic]:
    """ "ATTITUDE gives roll, pitch and yaw in degrees": names without marks, behind the message that has them all."""
    for passage, mentions in reading.passages_with_messages():
        for found in _PLAIN.finditer(passage.text):
            low, high = passage.sentence(found.start(), found.end())
            named = between(mentions, low, found.start())
            message = reading.messages[named[-1].name] if named else None
            fields = [message.field(name) for name in re.split(_AND, found["names"])] if message else []
            unit = worded_unit(found["unit"])
            first = fields[0] if fields else None
            own = Unit.parse(first.definition.units) if first else None
            if message is None or None in fields or unit is None or first is None or own is None:
                continue
            if not _is_same(unit, own) and not _SCALED.search(passage.text, low, high):
                text = f"{message.name}.{first.name} is in {first.definition.units}, not {found['unit']}"
                place = passage.place_at(found.start("unit"))
                yield reading.found(UNIT, place, f"{message.name}.{first.name} in {found['unit']}", text)


NO_UNIT = Unit("", (), Fraction(1))


def _is_same(one: Unit, other: Unit) -> bool:
    return (one.dimension, one.scale, one.pi) == (other.dimension, other.scale, other.pi)


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


def _extensions(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    is_extension = said.field.definition.is_extension
    for form, stated in ((_IS_EXTENSION, True), (_IS_BASE, False)):
        found = form.match(said.passage.text, said.end, said.until)
        if found is None:
            continue
        claimed = stated != bool(found.groupdict().get("no"))
        if claimed != is_extension:
            kind = "an extension" if is_extension else "a base field"
            place = said.passage.place_at(said.start)
            yield reading.found(EXTENSION, place, f"{said.name} {found[0]}", f"{said.name} is {kind}")
