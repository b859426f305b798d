"""Sentences as a reader of the field sees them: names, types, units and numbers are terms, all else is words.

A sentence becomes a short text in which each term is one capital letter and each word is in small letters, so that a
form of speech is one pattern over it: "`vel` is a uint16_t in cm/s" is ``F is a T in U``.

    M message   F field   P word that is a field's name   E enum   V entry   C other name in capitals
    T type      L number of elements   U unit   Q number with a unit   N number   S name of a number, UINT16_MAX
"""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Collection, Iterator, Mapping, Sequence
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import EnumDefinition, WireMessage
from codegen.model.dialect.literals import named_number
from codegen.model.dialect.wire_types import SPELLINGS
from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import Unit

_SCALAR = r"u?int(?:8|16|32|64)(?:_t)?|[ui](?:8|16|32|64)|f(?:32|64)|float(?:32|64)?|double|char"
_ORDER = ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"]
NUMBER_WORDS: Mapping[str, int] = {word: index for index, word in enumerate(_ORDER, 1)}
_PREFIX = r"(?:(?:nano|micro|milli|centi|deci|hecto|kilo|mega)[- ]?)?"
_LONG_UNIT = (
    r"(?:degrees? celsius|volts?|amps?|amperes?|met(?:re|er)s?|deg(?:ree)?s?|radians?|hertz|seconds?|minutes?|hours?"
    r"|grams?|kelvin|celsius|pascals?|teslas?|percent|watts?|joules?|gauss|knots?|newtons?|lit(?:re|er)s?)"
)
_TOKEN = r"[A-Za-z%\u00b5\u00b0](?:[A-Za-z0-9%\u00b5\u00b0\u00b2\u00b3]|[/*^](?=[A-Za-z0-9])){0,18}+"
_POWER = r"(?:1[eE]-?\d{1,2}|10\s?(?:\^|\*\*)\s?-?\d{1,2}|10+(?![\d.]))"
_TERM = re.compile(
    rf"""
    (?P<constant>(?<![\w.])(?:U?INT(?:8|16|32|64)_M(?:AX|IN)|NaN|NAN|[ui](?:8|16|32|64)::M(?:AX|IN)|float\(['"]nan['"]\)|0x[fF]{{2,16}})(?!\w))
  | (?P<qualified>(?<![\w.])(?P<of>[A-Z][A-Z0-9_]{{2,60}})(?:\.|::|->)(?P<member>[A-Za-z]\w{{0,60}})(?:\[\d{{0,3}}\])?(?![\w(]))
  | (?P<capitals>(?<![\w.-])[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+(?![\w-])|(?<![\w.-])[A-Z][A-Z0-9]{{3,}}(?![\w-]))
  | (?P<array>\[\s?(?P<inner>{_SCALAR})\s?;\s?(?P<held>\d{{1,4}})\s?\])
  | (?P<elements>(?<![\w.,-])(?P<some>\d{{1,4}}|{"|".join(_ORDER)})[ ](?P<sort>floats|doubles|u?int(?:8|16|32|64)(?:_t)?s?|(?:un)?signed[ ]bytes))\b
  | (?P<spelled>(?<![\w.-])(?:(?P<sign>unsigned|signed)[ ,]+)?(?P<bits>8|16|32|64)[ -]?bits?\b(?:[ ](?P<after>unsigned|signed)\b)?(?:[ ](?P<kind>integers?|ints?|numbers?|words?|floats?|values?|counters?)\b)?)
  | (?P<byte>(?<![\w.-])(?P<bytesign>unsigned|signed)[ ](?:byte|char)\b)
  | (?P<type>(?<![\w.])(?P<scalar>{_SCALAR})(?:s\b)?(?![\w(])(?:[ ]?\[[ ]?(?P<length>\d{{1,4}})[ ]?\])?)
  | (?P<quantity>(?<![\w.,-])[-+]?\d{{1,12}}(?:,\d{{3}}){{0,3}}(?:\.\d{{1,9}})?[ \u00a0]?(?P<in>{_PREFIX}{_LONG_UNIT}\b(?:\s(?:per|a)\ssecond\b)?|{_TOKEN}(?![\w/]))(?![ ]?(?:[*\u00d7]|times\b)[ ]?1))
  | (?P<scaled>(?<![\w.])(?P<scaledunit>{_PREFIX}{_LONG_UNIT}|{_TOKEN})\s?(?:times|multiplied\sby|scaled\sby|[*\u00d7x])\s?(?P<by>{_POWER})(?!\w|\.\d))
  | (?P<units>(?<![\w.])(?P<share>tenths?|hundredths?|thousandths?|millionths?)\sof\s(?:an?\s)?(?P<whole>{_PREFIX}{_LONG_UNIT}(?:\s(?:per|/)\s(?:second|minute|hour))?|{_TOKEN})\b)
  | (?P<long>(?<![\w.-]){_PREFIX}{_LONG_UNIT}(?:(?:\s(?:per|a)\s|/)(?:second|sec|minute|hour|s)\b(?:\s(?:squared|per\ssecond))?)?(?!\w))
  | (?P<power>(?<![\w.]){_POWER}[ ](?P<small>{_LONG_UNIT}|{_TOKEN})(?![\w/]))
  | (?P<number>(?<![\w.])[-\u2212+]?(?:0[xX][0-9a-fA-F]{{1,16}}|\d{{1,3}}(?:,\d{{3}})+(?!\d)|\d{{1,20}}(?:\.\d{{1,12}})?(?:[eE]-?\d{{1,2}})?)(?![\w]|\.\d))
  | (?P<name>(?<![\w$-])(?<!\.\.)[A-Za-z_][A-Za-z0-9_]*(?:\[(?:\d{{0,3}}(?:\s?(?:\.\.\.?|-|:)\s?\d{{1,3}})?)\])?(?![\w(]))
  | (?P<symbol>(?<![\w.])[%\u00b5\u00b0][A-Za-z0-9/]{{0,10}})
    """,
    re.VERBOSE,
)
_PLAIN_NUMBER = re.compile(
    r"[-+]?(?:0[xX][0-9a-fA-F]{1,16}|\d{1,12}(?:,\d{3}){0,3}(?:\.\d{1,12})?(?:[eE]-?\d{1,2})?)(?!\w|\.\d)"
)
_SHARES = {"tenth": 10, "hundredth": 100, "thousandth": 1000, "millionth": 1000000}
_COMPOUND = re.compile(rf"{_TOKEN}(?:/[A-Za-z][A-Za-z0-9^]{{0,6}}){{0,2}}")
_SHORT_UNITS = frozenset(
    [
        "m",
        "s",
        "A",
        "V",
        "g",
        "h",
        "K",
        "G",
        "N",
        "J",
        "W",
        "C",
        "T",
        "l",
        "L",
        "us",
        "min",
        "bits",
        "bit",
        "bytes",
        "byte",
        "in",
        "a",
        "rad",
        "knots",
        "x",
    ]
)
"""What is a word or a name as often as a unit: only where a unit has to stand."""
_UNIT_PLACE = re.compile(
    r"(?:\b(?:in|units?|units? (?:is|of|are)|as|unit:)[ :]|[(\[|:,=#*/]|^|U,? (?:and|or) )\s?['\"]?$"
)
_UNIT_END = re.compile(
    r"['\"]?\s*(?:[,.;)\]|}]|\*/|$|(?:and|if|when|since|for|or|above|below|from|at|over|as|with|per)\b"
    r"|[-\u2013\u2014(] ?)"
)


@dataclass(frozen=True, slots=True)
class Term:
    """One term: its letter, what it stands for, its text, and where it stands in the source text."""

    letter: str
    value: object
    written: str
    start: int
    end: int
    is_quoted: bool = False


@dataclass(frozen=True, slots=True)
class NamedField:
    """A name of a field, and the message that is named with it, ``MESSAGE.field``."""

    name: str
    message: str | None = None
    elements: int | None = None


@dataclass(frozen=True, slots=True)
class StatedType:
    """A type: ``bits`` and ``sign`` (u, i or f, or None where it is not said), ``name`` as XML writes it, ``length``."""

    name: str | None
    bits: int
    sign: str | None
    length: int | None = None


@dataclass(frozen=True, slots=True)
class Vocabulary:
    """The names that are terms in a document."""

    messages: Mapping[str, WireMessage]
    enums: Mapping[str, EnumDefinition]
    entries: Collection[str]
    fields: frozenset[str]


@dataclass(frozen=True, slots=True)
class Sentence:
    """A text with its terms: ``marked`` is the short text, ``at`` the offset in the source of each of its characters."""

    marked: str
    at: tuple[int, ...]
    terms: Mapping[int, Term]
    offsets: tuple[int, ...]

    def term(self, offset: int) -> Term:
        """The term whose letter stands at an offset of ``marked``."""
        return self.terms[offset]

    def within(self, start: int, end: int, letters: str) -> Iterator[tuple[int, Term]]:
        """The terms with one of some letters between two offsets of ``marked``, each with its offset."""
        low = bisect_left(self.offsets, start)
        for offset in self.offsets[low : bisect_left(self.offsets, end)]:
            if self.terms[offset].letter in letters:
                yield offset, self.terms[offset]

    def plain(self) -> "Sentence":
        """The same without words that are names of fields: where only messages are spoken of, they are words."""
        if "P" not in self.marked:
            return self
        marked: list[str] = []
        at: list[int] = []
        terms: dict[int, Term] = {}
        for offset, letter in enumerate(self.marked):
            term = self.terms.get(offset)
            if term is not None and letter == "P":
                marked += term.written.lower()
                at += range(term.start, term.start + len(term.written))
                continue
            if term is not None:
                terms[len(marked)] = term
            marked.append(letter)
            at.append(self.at[offset])
        return Sentence("".join(marked), tuple(at), terms, tuple(terms))

    def source(self, offset: int) -> int:
        """The offset in the source of a character of ``marked``."""
        return self.at[min(offset, len(self.at) - 1)] if self.at else 0


def read_sentence(text: str, low: int, high: int, codes: Sequence[tuple[int, int]], words: Vocabulary) -> Sentence:
    """The terms of a part of a text; ``codes`` are the bounds of its code spans."""
    marked: list[str] = []
    at: list[int] = []
    terms: dict[int, Term] = {}

    def plain(start: int, end: int) -> None:
        for index in range(start, end):
            character = text[index]
            if character.isspace():
                if not marked or marked[-1] == " ":
                    continue
                character = " "
            elif character in "\"'`":
                continue
            marked.append(character.lower())
            at.append(index)

    position = low
    while (found := _TERM.search(text, position, high)) is not None:
        plain(position, found.start())
        term = _term(found, codes, words, "".join(marked[-24:]), text, high)
        if term is None:
            end = found.end() if found.lastgroup in ("name", "capitals") else found.start() + 1
            end = max(end, found.start() + 1)
            if found["name"] is None and found["capitals"] is None:
                word = re.compile(r"\w+").match(text, found.start(), high)
                end = word.end() if word else end
            plain(found.start(), end)
            position = end
            continue
        terms[len(marked)] = term
        marked.append(term.letter)
        at.append(term.start)
        position = term.end
    plain(position, high)
    return Sentence("".join(marked), tuple(at), terms, tuple(terms))


def _term(
    found: "re.Match[str]", codes: Sequence[tuple[int, int]], words: Vocabulary, before: str, text: str, high: int
) -> Term | None:
    """The term of a match; None for what is only words here."""
    start, end, written = found.start(), found.end(), found[0]

    def made(letter: str, value: object, until: int = end) -> Term:
        return Term(letter, value, text[start:until], start, until, _is_quoted(text, start, until))

    if found["constant"]:
        return made("S", constant_value(written))
    if found["qualified"]:
        if found["of"] in words.messages:
            return made("F", NamedField(found["member"], found["of"]))
        return None
    if found["capitals"]:
        if written in words.messages:
            return made("M", written)
        if written in words.enums:
            return made("E", written)
        if written in words.entries:
            return made("V", written)
        return made("C", written) if "_" in written and "CRC" not in written else None
    if found["array"]:
        return made("T", _scalar(found["inner"], int(found["held"])))
    if found["elements"]:
        some = found["some"]
        sort = found["sort"].rstrip("s") if not found["sort"].endswith("bytes") else ""
        base = (
            _scalar(sort, _count(some))
            if sort
            else StatedType(None, 8, "u" if found["sort"][0] == "u" else "i", _count(some))
        )
        return made("T", base)
    if found["spelled"]:
        if not (found["sign"] or found["after"] or found["kind"]):
            return made("T", StatedType(None, int(found["bits"]), None))
        said = (found["sign"] or found["after"] or "").lower()
        kind = (found["kind"] or "").lower()
        sign = "f" if kind.startswith("float") else {"unsigned": "u", "signed": "i"}.get(said)
        return made("T", StatedType(None, int(found["bits"]), sign))
    if found["byte"]:
        return made("T", StatedType(None, 8, "u" if found["bytesign"] == "unsigned" else "i"))
    if found["type"]:
        return made("T", _scalar(found["scalar"], int(found["length"]) if found["length"] else None))
    if found["quantity"]:
        unit = worded_unit(found["in"]) if found["in"] not in ("x", "a", "b", "e", "in") else None
        if unit is None or found["in"].lower() in ("bytes", "byte", "b", "bits", "bit"):
            number = _PLAIN_NUMBER.match(text, start, high)
            return None if number is None else made("N", _number(number[0]), number.end())
        return made("Q", (_number(re.split(r"[^\d.,+-]", written)[0]), unit))
    if found["scaled"]:
        unit = _unit(found["scaledunit"])
        return None if unit is None else made("U", _times(unit, found["by"]))
    if found["units"]:
        unit = _unit(found["whole"])
        return None if unit is None else made("U", _finer(unit, _SHARES[found["share"].rstrip("s")]))
    if found["long"]:
        unit = _unit(found["long"])
        is_single = found["long"].lower() in ("second", "minute", "hour", "degree", "meter", "metre", "deg", "degs")
        if unit is None or (is_single and not re.search(r"\b(?:in|of|unit:?) ?$|[(\[,:|#*/=] ?$", before)):
            return None
        if found["long"].lower() == "seconds" and re.search(
            r"\b(?:few|some|several|many|of|every|wait|after) $", before
        ):
            return None
        return made("U", unit)
    if found["power"]:
        unit = _unit(found["small"])
        power = _number(found["power"].split()[0])
        if unit is None or not unit.dimension or power == 1:
            return None
        return made("U", _finer(unit, power if power > 1 else 1 / power))
    if found["number"]:
        value = _number(written)
        return None if value is None else made("N", value)
    if found["symbol"]:
        unit = worded_unit(written)
        return made("U", unit) if unit is not None else None
    return _name(found, codes, words, before, text, high)


def _name(
    found: "re.Match[str]", codes: Sequence[tuple[int, int]], words: Vocabulary, before: str, text: str, high: int
) -> Term | None:
    start, end, written = found.start(), found.end(), found[0]
    name, _, rest = written.partition("[")
    index = bisect_right(codes, (start, len(text))) - 1
    is_code = index >= 0 and end <= codes[index][1]
    if name in words.fields:
        held = re.fullmatch(r"(\d{1,3})\]", rest)
        value = NamedField(name, None, int(held[1]) if held else None)
        is_name = (
            is_code or "_" in name or any(character.isdigit() for character in name) or name[1:].lower() != name[1:]
        )
        if is_name:
            return Term("F", value, written, start, end)
    unit = _COMPOUND.match(text, start, high)
    if unit is not None and (not is_code or name not in words.fields):
        stated = worded_unit(unit[0]) if not unit[0].islower() or len(unit[0]) < 9 else _unit(unit[0])
        after = unit.end()
        if stated is not None and stated.dimension and not text[after : after + 1].isalnum():
            is_short = unit[0] in _SHORT_UNITS or unit[0].lower() in _ENGLISH or len(unit[0]) == 1
            is_place = _UNIT_PLACE.search(before) and _UNIT_END.match(text, after, high)
            if not is_short or is_place:
                return Term("U", stated, unit[0], start, after, is_quoted=_is_quoted(text, start, after))
    if name in words.fields:
        return Term("P", NamedField(name), written, start, end)
    if name.lower() in words.fields and name[1:].islower() and len(name) > 2:
        return Term("P", NamedField(name.lower()), written, start, end)
    if written.lower() in NUMBER_WORDS and written.lower() != "one":
        return Term("N", Fraction(NUMBER_WORDS[written.lower()]), written, start, end)
    if name[:1].isupper() and sum(character.isupper() for character in name) > 1 and "_" not in name:
        spelled = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).upper()
        if "_" in spelled and spelled in words.messages:
            return Term("M", spelled, written, start, end)
    return None


_ENGLISH = frozenset(
    [
        "a",
        "s",
        "x",
        "bar",
        "min",
        "rev",
        "pix",
        "hour",
        "day",
        "kn",
        "kt",
        "bit",
        "bits",
        "byte",
        "bytes",
        "second",
        "minute",
        "degree",
        "meter",
        "metre",
        "gram",
        "ton",
        "sec",
    ]
)


def _is_quoted(text: str, start: int, end: int) -> bool:
    return start > 0 and text[start - 1] in "\"'" and text[end : end + 1] in ("'", '"')


def constant_value(written: str) -> int | float | None:
    """The number of a name such as ``UINT16_MAX``, ``u16::MAX`` or ``NaN``, or of digits."""
    if "nan" in written.lower():
        return float("nan")
    if written[:2].lower() == "0x":
        return int(written, 16)
    rust = re.fullmatch(r"([ui])(\d+)::M(AX|IN)", written)
    if rust:
        return named_number(f"{'U' if rust[1] == 'u' else ''}INT{rust[2]}_M{rust[3]}")
    return named_number(written)


def _scalar(written: str, length: int | None) -> StatedType:
    """The type of a spelling in any language."""
    spelled = {"f32": "float", "float32": "float", "f64": "double", "float64": "double"}.get(written, written)
    name = SPELLINGS.get(spelled) or (f"{spelled}_t" if spelled[-1].isdigit() else spelled)
    bits = {"float": 32, "double": 64, "char": 8}.get(name) or int(re.sub(r"\D", "", name) or 0)
    sign = "f" if name in ("float", "double") else None if name == "char" else name[0]
    return StatedType(name, bits, sign, length)


def _count(written: str) -> int:
    return NUMBER_WORDS.get(written.lower()) or int(written)


def _number(written: str) -> Fraction | None:
    text = written.replace(",", "").replace("\u2212", "-").replace("**", "^").replace(" ", "").lstrip("+")
    if text[:2].lower() == "0x":
        return Fraction(int(text, 16))
    if "^" in text:
        base, _, power = text.partition("^")
        return Fraction(base) ** int(power)
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        return None


def _unit(written: str) -> Unit | None:
    """The unit of words: "centi degrees", "metres per second squared", "deg C"."""
    text = " ".join(written.replace("-", " ").split())
    text = re.sub(r"\b(nano|micro|milli|centi|deci|hecto|kilo|mega) ", r"\1", text)
    text = re.sub(r"/(?:sec|second)\b", " per second", text)
    squared = re.sub(r" (?:a|per) second (?:squared|per second)$", "", text)
    if squared != text:
        inner = worded_unit(squared)
        return Unit.parse(f"{inner.name}/s/s") if inner is not None else None
    return worded_unit(text) or worded_unit(text.replace(" a ", " per ")) or worded_unit(text.lower())


def _times(unit: Unit, written: str) -> Unit | None:
    power = _number(written)
    return None if not power else _finer(unit, power if power >= 1 else 1 / power)


def _finer(unit: Unit, parts: int | Fraction) -> Unit:
    """The unit of which ``parts`` are one of another."""
    return Unit(f"{unit.name}/{parts}", unit.dimension, unit.scale / Fraction(parts), unit.pi, unit.zero)
