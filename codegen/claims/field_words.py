"""What sentences and lists say of a field: its type, its length, and whether it is an extension."""

import re
from collections.abc import Iterator

from codegen.claims.about import Said, said_of_fields
from codegen.claims.field_units import plain_units, said_units
from codegen.claims.reading import Reading
from codegen.claims.structure import RULE as TYPE
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import PassageKind

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
    """Everything that is said of a field by its name, its unit included."""
    yield from plain_units(reading)
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
        yield from said_units(reading, said, declared)
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
_SHORT = re.compile(
    r"[\s(:=,\u2013\u2014-]*(?:(?:is|are|as|an?|of)\s+)*(?P<short>[uif](?:8|16|32|64)|float(?:32|64))\b"
)


def _spelled(reading: Reading, said: Said) -> Iterator[Diagnostic]:
    """ "A 16-bit unsigned integer", "a signed byte", "u32": what is said is compared, the size and the sign."""
    text, field = said.passage.text, said.field
    found = short = _SHORT.match(text, said.end, said.until)
    if found is not None:
        bits, own_sign = int(found["short"].lstrip("uifloat")), {"u": "u", "i": "", "f": "f"}[found["short"][0]]
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
