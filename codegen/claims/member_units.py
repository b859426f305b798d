"""Units that code gives members of messages, in comments beside or above them, and factors that it scales them by."""

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction

from codegen.claims.field_units import SCALING
from codegen.claims.reading import Reading
from codegen.claims.unit_claim import unit_claim
from codegen.diagnostics import Diagnostic
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock
from codegen.model.dialect.dialect import WireMessage
from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import Unit, conversion

_UNIT = r"[A-Za-z%\u00b5\u00b0][A-Za-z0-9/%^*\u00b2\u00b3]{0,18}"
_ABOVE = re.compile(r"^\s*(?:///?|/\*\*?|\*|#)\s*(?P<text>[^*]{1,120}?)\s*(?:\*/)?\s*$")
_BESIDE = re.compile(r"(?://|/\*|#)[/*!<]*\s*(?P<text>.{1,160}?)\s*(?:\*/)?\s*$")
_BRACKETS = re.compile(rf"^\[(?P<unit>{_UNIT})\]")
_FIRST = re.compile(rf"(?P<unit>{_UNIT})(?=\s*(?:[,;(]|$))")
_LAST = re.compile(rf"(?:^|,\s|\bin |\()(?P<unit>{_UNIT})\)?\.?$")
_MEMBER = re.compile(
    r"^\s*(?:pub |readonly |public |const |self\.)*(?:(?P<field>[a-z][a-z0-9_]{0,60})\??\s*:\s*\[?\w+"
    r"|(?:u?int(?:8|16|32|64)(?:_t)?|float(?:32|64)?|double|char)\s+(?P<declared>[a-z][a-z0-9_]{0,60})\b)"
)
_READ = re.compile(
    r"(?<![\w.])(?P<variable>[a-z]\w{0,60})\.(?P<field>[a-z]\w{0,60})\b(?!\s*\()"
    r"(?:\s*(?P<how>[*/])\s*(?P<number>1[eE]-?\d{1,2}|\d{1,8}(?:\.\d{1,8})?))?\)?\s*[;,]?\s*(?:#|//)\s*"
    rf"(?:in )?(?P<unit>{_UNIT})\s*$"
)
_MEMBER_READ = (
    r"(?P<variable>[a-z]\w{0,60})\.(?P<field>[a-z]\w{0,60})\b(?!\s*[(.])"
    r"(?:\s*(?P<how>[*/])\s*(?P<number>1[eE]-?\d{1,2}|\d{1,8}(?:\.\d{1,8})?))?"
)
_SUFFIXED = re.compile(
    rf"\b\w{{1,40}}_(?P<unit>km|cm|mm|m|deg|rad|v|mv|a|ma|s|ms|us|mps|kmh|percent|pct|hpa)[\"']?\]?\s*[:=]\s*(?:float\()?{_MEMBER_READ}"
    r"\)?\s*[,;]?\s*(?:#.*|//.*)?$"
)
_SUFFIXES = {
    **{name: name for name in ("km", "cm", "mm", "m", "deg", "rad", "s", "ms", "us")},
    "v": "V",
    "mv": "mV",
    "a": "A",
    "ma": "mA",
    "mps": "m/s",
    "kmh": "km/h",
    "percent": "%",
    "pct": "%",
    "hpa": "hPa",
}
_SHOWN = re.compile(rf"\{{{_MEMBER_READ}(?::[^{{}}]{{0,12}})?\}} ?(?P<unit>{_UNIT})(?=[\"',;.) ])")
_TUPLE = re.compile(
    r"[\"'](?P<message>[A-Z][A-Z0-9_]{2,60})[\"'],\s*[\"'](?P<field>[a-z]\w{0,60})[\"']\)?\s*[,:]\s*[\"'](?P<unit>[^\"']{1,16})[\"']"
)
_TAKEN = re.compile(r"^\s*(?P<variable>\w+)\s*=\s*.*\btype\s*=\s*[\"'](?P<message>[A-Z][A-Z0-9_]{2,60})[\"']")
_NESTED = re.compile(r"[\"'](?P<message>[A-Z][A-Z0-9_]{2,60})[\"']\s*:\s*\{(?P<inner>[^{}]{1,400})\}")
_NAMED = re.compile(r"^\s*[\"']?(?P<message>[A-Z][A-Z0-9_]{2,60})[\"']?\s*[:=]\s*\{?\s*$")
_VALUE = re.compile(
    r"^\s+-?\s*[\"']?(?P<key>[a-z]\w{0,60})[\"']?:\s*(?:[\"']?(?P<value>[^\s\"',#{}]{1,18})[\"']?\s*,?\s*(?:#.*)?)?$"
)
_OBJECT = re.compile(
    r"[\"']?message[\"']?:\s*[\"']?(?P<message>[A-Z][A-Z0-9_]{2,60})[\"']?,\s*[\"']?field[\"']?:\s*[\"']?(?P<field>[a-z]\w{0,60})"
    r"[\"']?,\s*[\"']?units?[\"']?:\s*[\"']?(?P<unit>[^\s\"',}]{1,18})"
)
_PAIR = re.compile(r"[\"'](?P<field>[a-z]\w{0,60})[\"']\s*:\s*[\"'](?P<unit>[^\"']{1,16})[\"']")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every block of code."""
    for code in reading.prose.code:
        yield from _members(reading, code)
        yield from _reads(reading, code)
        yield from _keys(reading, code)
        for line in code.lines:
            yield from _nested(reading, line)


def _members(reading: Reading, code: CodeBlock) -> Iterator[Diagnostic]:
    """Declarations of a struct or an interface, each with the comment beside it, or else the one above it."""
    found: list[tuple[str, Line, re.Match[str]]] = []
    above: tuple[Line, re.Match[str]] | None = None
    for line in code.lines:
        member = _MEMBER.match(line.text)
        beside = _BESIDE.search(line.text)
        if member is None:
            comment = _ABOVE.match(line.text)
            above = (line, comment) if comment is not None else None
            continue
        name = member["field"] or member["declared"]
        if beside is not None:
            found.append((name, line, beside))
        elif above is not None:
            found.append((name, *above))
        above = None
    about = reading.message_with([name for name, _, _ in found], code.place.line) if len(found) > 1 else None
    for name, line, comment in found if about else ():
        text = comment["text"]
        places = filter(None, (_BRACKETS.match(text), _FIRST.match(text), _LAST.search(text)))
        stated = next((each for each in places if worded_unit(each["unit"]) is not None), None)
        if stated is not None and about is not None:
            yield from _unit(reading, about, name, stated["unit"], line, comment.start("text") + stated.start("unit"))


def _reads(reading: Reading, code: CodeBlock) -> Iterator[Diagnostic]:
    """``alt = msg.alt / 1000  # m``: the unit behind it is that of the number once it is scaled."""
    taken = [each for line in code.lines if (each := _TAKEN.match(line.text))]
    variables = {
        each["variable"]: reading.messages[each["message"]] for each in taken if each["message"] in reading.messages
    }
    for line in code.lines:
        for found in _READ.finditer(line.text):
            message = variables.get(found["variable"]) or _only(reading, variables)
            if message is not None:
                yield from _read(reading, message, found, line, found["unit"])
    yield from _converted(reading, code, variables)


def _only(reading: Reading, variables: Mapping[str, WireMessage]) -> WireMessage | None:
    """The message that a document is about, where it names one only and code asks for none by its name."""
    names = {name for _, name in reading.sightings}
    return reading.messages[names.pop()] if len(names) == 1 and not variables else None


def _read(
    reading: Reading, message: WireMessage, found: "re.Match[str]", line: Line, written: str | None
) -> Iterator[Diagnostic]:
    field = message.field(found["field"])
    own = Unit.parse(field.definition.units) if field else None
    if field is None or own is None or written is None:
        return
    if found["how"] is None:
        yield from _unit(reading, message, field.name, written, line, found.start("unit"))
        return
    unit = worded_unit(written)
    turned = conversion(own, unit) if unit is not None else None
    number = Fraction(found["number"])
    if turned is None or not turned.ratio or not number:
        return
    stated = 1 / number if found["how"] == "/" else number
    if stated != turned.ratio:
        name = f"{message.name}.{field.name}"
        place = line.place._replace(column=line.place.column + found.start("variable"))
        factor = f"{found['how']} {found['number']}"
        words = f"{name} is in {field.definition.units}, which {factor} does not make {written}"
        yield reading.found(SCALING, place, f"{name} {found[0]}", words)


def _converted(reading: Reading, code: CodeBlock, variables: Mapping[str, WireMessage]) -> Iterator[Diagnostic]:
    """``alt_m = msg.alt / 100`` and ``f"{msg.alt / 100} m"``: the name or the text around it says the unit."""
    for line in code.lines:
        for form in (_SUFFIXED, _SHOWN):
            for found in form.finditer(line.text):
                message = variables.get(found["variable"]) or _only(reading, variables)
                if message is not None:
                    unit = _SUFFIXES.get(found["unit"].lower()) if form is _SUFFIXED else found["unit"]
                    yield from _read(reading, message, found, line, unit)


def _keys(reading: Reading, code: CodeBlock) -> Iterator[Diagnostic]:
    """YAML: units below names of messages, as values of fields or of their key ``unit``; JSON: objects in a line."""
    message: WireMessage | None = None
    field = ""
    for line in code.lines:
        named = _NAMED.match(line.text)
        if named is not None:
            message, field = reading.messages.get(named["message"]), ""
            continue
        found = _VALUE.match(line.text) if message is not None else None
        if found is not None and message is not None:
            name = field if found["key"] in ("unit", "units") else found["key"]
            if found["value"]:
                yield from _unit(reading, message, name, found["value"], line, found.start("value"))
            elif message.field(found["key"]):
                field = found["key"]
        for each in (*_OBJECT.finditer(line.text), *_TUPLE.finditer(line.text)):
            about = reading.messages.get(each["message"])
            if about is not None:
                yield from _unit(reading, about, each["field"], each["unit"], line, each.start("unit"))


def _nested(reading: Reading, line: Line) -> Iterator[Diagnostic]:
    for found in _NESTED.finditer(line.text):
        message = reading.messages.get(found["message"])
        for pair in _PAIR.finditer(line.text, found.start("inner"), found.end("inner")) if message else ():
            if message is not None:
                yield from _unit(reading, message, pair["field"], pair["unit"], line, pair.start("unit"))


def _unit(
    reading: Reading, message: WireMessage, name: str, written: str, line: Line, offset: int
) -> Iterator[Diagnostic]:
    yield from unit_claim(reading, message, name, written, line.place._replace(column=line.place.column + offset))
