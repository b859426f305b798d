"""Sentences as a reader of the field sees them: names, types, units and numbers are terms, all else is words.

A sentence becomes a short text in which each term is one capital letter and each word is in small letters, so that a
form of speech is one pattern over it: "`vel` is a uint16_t in cm/s" is ``F is a T in U``.

    M message   F field   P word that is a field's name   E enum   V entry   C other name in capitals
    T type      L number of elements   U unit   Q number with a unit   N number   S name of a number, UINT16_MAX
"""

import re
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from fractions import Fraction

from codegen.claims.parts.sentence import NamedField, Sentence, StatedType, Term, Vocabulary
from codegen.claims.parts.spelled_names import camel, in_snake, other_ends
from codegen.claims.parts.worded_units import finer, unit_of_words, worded_unit
from codegen.model.dialect.literals import named_number
from codegen.model.dialect.wire_types import SPELLINGS
from codegen.model.units.unit import Unit
from codegen.pattern import pattern

_SCALAR = r"u?int(?:8|16|32|64)(?:_t)?|[ui](?:8|16|32|64)|f(?:32|64)|float(?:32|64)?|double|char"
_ORDER = ["one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"]
_ORDER += ["thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen", "twenty"]
NUMBER_WORDS: Mapping[str, int] = {"zero": 0, **{word: index for index, word in enumerate(_ORDER, 1)}}
_PREFIX = r"(?:(?i:pico|nano|micro|milli|centi|deci|hecto|kilo|mega|giga)[- ]?)?"
_LONG_UNIT = (
    r"(?i:degrees?\scelsius|degrees?\sfahrenheit|fahrenheit|miles|nautical\smiles"
    r"|volts?|amps?|amperes?|met(?:re|er)s?|deg(?:ree)?s?|radians?|hertz|seconds?|minutes?|hours?"
    r"|grams?|kelvin|celsius|feet|inches|per\smille|revolutions\sper\sminute|milli[- ]g|pascals?|teslas?|percent"
    r"|watts?|joules?|gauss|knots?|newtons?|lit(?:re|er)s?)"
)
_SYMBOL = r"[A-Za-z%\u00b5\u00b0](?:[A-Za-z0-9%\u00b5\u00b0\u00b2\u00b3]|[/*^](?=[A-Za-z0-9])){0,18}+"
_POWER = r"(?:1[eE]-?\d{1,2}|10\s?(?:\^|\*\*)\s?-?\d{1,2}|10{0,2}(?:[ ,\u00a0\u202f]000)+(?!\d)|10+(?![\d.]|[ ,]000))"
_POWERS: Mapping[str, int] = {"hundred": 100, "thousand": 1000, "million": 10**6}
_TERM = pattern(
    rf"""
    (?P<constant>(?<![\w.])(?:U?INT(?:8|16|32|64)_M(?:AX|IN)|NaN|NAN|[ui](?:8|16|32|64)::M(?:AX|IN)
      |float\(['"]nan['"]\)|0x[fF]{{2,16}})(?!\w))
  | (?P<qualified>(?<![\w.])(?P<of>[A-Z][A-Z0-9_]{{2,60}})(?:\.|::
      |->)(?P<member>[A-Za-z]\w{{0,60}})(?:\[\d{{0,3}}\])?(?![\w(]))
  | (?P<capitals>(?<![\w.-])[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+(?![\w-])|(?<![\w.-])[A-Z][A-Z0-9]{{2,}}(?![\w-]))
  | (?P<array>\[\s?(?P<inner>{_SCALAR})\s?;\s?(?P<held>\d{{1,4}})\s?\])
  | (?P<elements>(?<![\w.,-])(?P<some>\d{{1,4}}|{"|".join(_ORDER)})[ ](?:[x\u00d7][ ])?(?P<sort>floats|doubles
      |(?:(?<=x[ ])|(?<=\u00d7[ ]))(?:float|double)|u?int(?:8|16|32
      |64)(?:_t)?s?|(?:un)?signed[ ]bytes))\b
  | (?P<spelled>(?<![\w.-])(?:(?P<sign>unsigned|signed)[ ,]+)?(?P<bits>8|16|32
      |64)[ -]?bits?\b(?:[ ](?P<after>unsigned|signed)\b)?(?:[ ](?P<kind>integers?|ints?|numbers?|words?
      |floats?|values?|counters?)\b)?)
  | (?P<byte>(?<![\w.-])(?P<bytesign>unsigned|signed)[ ](?:byte|char)\b)
  | (?P<type>(?<![\w.])(?P<scalar>{_SCALAR})(?:s\b)?(?![\w(])(?:[ ]?\[[ ]?(?P<length>\d{{1,4}})[ ]?\])?)
  | (?P<quantity>(?<![\w.,-])[-+]?\d{{1,12}}(?:,\d{{3}}){{0,3}}(?:\.\d{{1,9}})?[ \u00a0]?
      (?!f\b)(?P<in>{_PREFIX}{_LONG_UNIT}\b(?:\s{{1,9}}(?:per|a)\s{{1,9}}second\b)?
      |{_SYMBOL}(?![\w/]))(?![ ]?(?:[*\u00d7]|times\b)[ ]?1))
  | (?P<scaled>(?<![\w.])(?P<scaledunit>{_PREFIX}{_LONG_UNIT}|{_SYMBOL})\s?(?:times|multiplied\sby|scaled\sby
      |[*\u00d7x])\s?(?P<by>{_POWER})(?!\w|\.\d))
  | (?P<units>(?<![\w.])(?P<share>tenths?|hundredths?|thousandths?
      |millionths?|tens|hundreds|thousands)\sof\s(?:an?\s)?(?P<whole>{_PREFIX}{_LONG_UNIT}(?:\s(?:per|/)\s(?:second|minute|hour))?
      |{_SYMBOL})\b)
  | (?P<long>(?<![\w.-]){_PREFIX}{_LONG_UNIT}(?:(?:\s{{1,9}}(?:per|a)\s{{1,9}}|/)(?:second|sec|minute|hour
      |s)\b(?:\s(?:squared|per\ssecond))?)?(?!\w))
  | (?P<power>(?<![\w.]){_POWER}[ ](?P<small>{_LONG_UNIT}|{_SYMBOL})(?![\w/]))
  | (?P<number>(?:(?<![\w.])|(?<=\d\.\.)|(?<=\.\.\.))[-\u2212+]?(?:0[xX][0-9a-fA-F]{{1,16}}
      |1[ ]?<<[ ]?\d{{1,2}}|\d{{1,3}}(?:,\d{{3}})+(?!\d)|[1-9]\d{{0,2}}(?:[ \u00a0\u202f]\d{{3}})+(?![\w,.]\d|\w|[ ]\d)
      |\d{{1,20}}(?:\.\d{{1,12}})?(?:[eE]-?\d{{1,2}})?)(?:(?<=\.\d)f|(?<=\.\d\d)f|\.f)?(?![\w]|\.\d))
  | (?P<many>(?<![\w-])(?:(?P<times>an?|{"|".join(_ORDER)}|\d{{1,3}})[ ])?(?P<of_many>hundred|thousand
      |million)(?![\w-]))
  | (?P<name>(?<![\w$-])(?<!\.\.)[A-Za-z_][A-Za-z0-9_]*(?:\[(?:\d{{0,3}}(?:\s?(?:\.\.\.?|-
      |:)\s?\d{{1,3}})?)\])?(?![\w(]))
  | (?P<symbol>(?<![\w.])[%\u00b5\u00b0][A-Za-z0-9/]{{0,10}})
    """,
    re.VERBOSE,
)
_PLAIN_NUMBER = pattern(
    r"[-+]?(?:0[xX][0-9a-fA-F]{1,16}|\d{1,12}(?:,\d{3}){0,3}(?:\.\d{1,12})?(?:[eE]-?\d{1,2})?)(?!\w|\.\d)"
)
_WORD = pattern(r"\w+")
_RUN = pattern(r"\s+|[^\s\"'`]+")
"""Runs of what a short text keeps of words: blanks, and all but quotation marks."""
_PLACE = pattern(
    r"(?:\w\.[A-Za-z]\w{0,4}:(?:\d{1,6}[:,-])?"
    r"|\b(?:lines?|pages?|steps?|issues?|tickets?|commits?) #?(?:\d{1,6}(?: ?[-\u2013,] ?| to | and ))?)$",
    re.IGNORECASE,
)
"""Before the number of a line or the like: "gimbal.cpp:102", "line 102", "lines 102 to 110", "step 7"."""
_PLACE_ALONE = pattern(r"(?:^|[\s(`]):$")
"""The same without its file, if a colon follows: ":102: NAME"."""
_PLACE_MOST = 30
_EMPHASIZED = pattern(r"[A-Za-z](?:\*{1,2}|__?)$")
"""Before the rest of a word whose beginning is in bold: "**nano**seconds"."""
_FILLING = pattern(r" bytes?\b|-(?:terminated|filled|padded|bytes?)\b")
"""Behind "zero" where it is what a byte is, and not how many there are."""
_SHARES: Mapping[str, int | Fraction] = {
    "tenth": 10,
    "hundredth": 100,
    "thousandth": 1000,
    "millionth": 1000000,
    "ten": Fraction(1, 10),
    "hundred": Fraction(1, 100),
    "thousand": Fraction(1, 1000),
}
_COMPOUND = pattern(rf"{_SYMBOL}(?:/[A-Za-z][A-Za-z0-9^]{{0,6}}){{0,2}}")
_SHORT_UNITS = frozenset((
    "m", "s", "A", "V", "g", "h", "K", "G", "N", "J", "W", "C", "T", "l", "L", "us", "min", "bits", "bit", "bytes",
    "byte", "in", "a", "rad", "knots", "x",
))  # fmt: skip
"""Units that are as often a word or a name: they are read only where a unit has to stand."""
_UNIT_PLACE = pattern(
    r"(?:\b(?:in|how many|units?|units? (?:is|of|are)|as|unit:|get|gets|gives?|yields?|obtain|N for|N to|carries|uses"
    r"|F(?: (?:of|in) M)? (?:is|are))[ :]|[(\[|:,=#*/>\u2192]|^|U,? (?:and|or) |[FP] [-\u2013\u2014] )\s?['\"]?$"
)
_UNIT_END = pattern(
    r"['\"]?\s*(?:[,.;)\]|}=]|\*/|$|(?:and|if|when|since|for|or|above|below|from|at|over|as|with|per|are|you)\b"
    r"|[-\u2013\u2014(] ?)"
)


def read_sentence(text: str, low: int, high: int, codes: Sequence[tuple[int, int]], words: Vocabulary) -> Sentence:
    """The terms of a part of a text; ``codes`` are the bounds of its code spans."""
    marked: list[str] = []
    at: list[int] = []
    terms: dict[int, Term] = {}

    def plain(start: int, end: int) -> None:
        for run in _RUN.finditer(text, start, end):
            begun, ended = run.span()
            if not text[begun].isspace():
                marked.extend(map(str.lower, run[0]))
                at.extend(range(begun, ended))
            elif marked and marked[-1] != " ":
                marked.append(" ")
                at.append(begun)

    position = low
    while (found := _TERM.search(text, position, high)) is not None:
        plain(position, found.start())
        position = found.start()
        term = _term(found, codes, words, "".join(marked[-_BEFORE:]), text, high)
        if term is None:
            end = found.end() if found.lastgroup in ("name", "capitals") else found.start() + 1
            if found["name"] and "[" in found["name"]:
                end = found.start() + found["name"].index("[")  # the number of elements of something else
            end = max(end, found.start() + 1)
            if found["name"] is None and found["capitals"] is None:
                word = _WORD.match(text, found.start(), high)
                end = word.end() if word else end
            plain(found.start(), end)
            position = end
            continue
        for each in (term, *other_ends(term, text, high, words)):
            plain(position, each.start)  # the stroke between two ends
            terms[len(marked)] = each
            marked.append(each.letter)
            at.append(each.start)
            position = each.end
    plain(position, high)
    return Sentence("".join(marked), tuple(at), terms, tuple(terms))


_BEFORE = 24
"""Characters before a term by which it may be told what it is."""
_Made = tuple[str, object]
"""The letter and the value of a term."""


def _term(
    found: "re.Match[str]", codes: Sequence[tuple[int, int]], words: Vocabulary, before: str, text: str, high: int
) -> Term | None:
    """The term of a match; None for what is only words here."""
    start, end = found.span()
    if (found["number"] or found["quantity"]) and _is_place(text, start):
        return None
    if found["long"] and _EMPHASIZED.search(text, max(start - _PLACE_MOST, 0), start):
        return None
    if found["name"]:
        return _name(found, codes, words, before, text, high)
    if found["quantity"] and _of_quantity(found) is None:
        number = _PLAIN_NUMBER.match(text, start, high)
        value = _number(number[0]) if number is not None else None
        return None if number is None or value is None else Term("N", value, number[0], start, number.end())
    if found["power"] and _of_unit(found, before) is None:
        written = found["power"][: -len(found["small"])].rstrip()  # a number before a word
        return Term("N", _number(written), written, start, start + len(written))
    made = _of_capitals(found, words) or _of_type(found) or _of_unit(found, before) or _of_number(found)
    return None if made is None else Term(*made, found[0], start, end, _is_quoted(text, start, end))


def _is_place(text: str, start: int) -> bool:
    """Return whether a number is that of a line in a file, of a page, a step or an issue."""
    before = text[max(start - _PLACE_MOST, 0) : start]
    if _PLACE.search(before):
        return True
    return _PLACE_ALONE.search(before) is not None and pattern(r"\d+:").match(text[start : start + 8]) is not None


def _of_capitals(found: "re.Match[str]", words: Vocabulary) -> _Made | None:
    """The message, enum, entry or field that a name in capitals is."""
    written = found[0]
    if found["qualified"] and found["of"] in words.messages:
        return "F", NamedField(found["member"], found["of"])
    if not found["capitals"]:
        return None
    known = (("M", words.messages), ("E", words.enums), ("V", words.entries))
    letter = next((letter for letter, names in known if written in names), None)
    if letter is None and written in words.fields:
        return "F", NamedField(written)
    if letter is None and "_" in written and "CRC" not in written:
        letter = "C"
    return None if letter is None else (letter, written)


def _of_type(found: "re.Match[str]") -> _Made | None:
    """The type that a spelling of any language, or words for one, are."""
    stated: StatedType | None = None
    if found["array"]:
        stated = _scalar(found["inner"], int(found["held"]))
    elif found["elements"] and found["sort"].endswith("bytes"):
        stated = StatedType(None, 8, found["sort"][0].replace("s", "i"), _count(found["some"]))
    elif found["elements"]:
        stated = _scalar(found["sort"].rstrip("s"), _count(found["some"]))
    elif found["spelled"]:
        said = (found["sign"] or found["after"] or "").lower()
        is_float = (found["kind"] or "").lower().startswith("float")
        stated = StatedType(None, int(found["bits"]), "f" if is_float else _SIGNS.get(said))
    elif found["byte"]:
        stated = StatedType(None, 8, _SIGNS[found["bytesign"]])
    elif found["type"]:
        stated = _scalar(found["scalar"], int(found["length"]) if found["length"] else None)
    return None if stated is None else ("T", stated)


_SIGNS = {"unsigned": "u", "signed": "i"}


def _of_unit(found: "re.Match[str]", before: str) -> _Made | None:
    """The unit that words or symbols are, with what was done to the number."""
    unit: Unit | None = None
    if found["scaled"] and found["scaledunit"] == "T" and not _TESLA_PLACE.search(before):
        return None
    if found["scaled"]:
        whole, power = unit_of_words(found["scaledunit"]), _number(found["by"])
        unit = finer(whole, max(power, 1 / power)) if whole is not None and power else None
    elif found["units"]:
        whole = unit_of_words(found["whole"])
        unit = finer(whole, _SHARES[found["share"].rstrip("s")]) if whole is not None else None
    elif found["long"] and _is_unit_word(found["long"].lower(), before):
        unit = unit_of_words(found["long"])
    elif found["power"]:
        whole, power = unit_of_words(found["small"]), _number(found["power"][: -len(found["small"])])
        is_scaled = whole is not None and whole.dimension and power not in (None, 0, 1)
        unit = finer(whole, max(power, 1 / power)) if is_scaled and whole is not None and power else None
    elif found["symbol"]:
        unit = worded_unit(found[0])
    return None if unit is None else ("U", unit)


def _is_unit_word(word: str, before: str) -> bool:
    """Return whether a word is a unit by the words before it: in "the second one" and "a few seconds" it is none."""
    if word in ("second", "minute", "hour", "degree", "meter", "metre", "deg", "degs"):
        return (
            re.search(
                r"\b(?:in|of|unit:?|get|gives?|yields?|obtain|N for|N to) ?$|[(\[,:|#*/=] ?$|U (?:and|or) $", before
            )
            is not None
        )
    return word != "seconds" or not pattern(r"\b(?:few|some|several|many|of|every|wait|after) $").search(before)


def _of_quantity(found: "re.Match[str]") -> Unit | None:
    """The unit of a number; None where what follows it is none, or bytes."""
    if found["in"] == "a" or found["in"].lower() in ("x", "e", "in", "bytes", "byte", "b", "bits", "bit"):
        return None
    return worded_unit(found["in"])


def _of_number(found: "re.Match[str]") -> _Made | None:
    if found["constant"]:
        return "S", constant_value(found[0])
    if found["quantity"]:
        return "Q", (_number(pattern(r"[^\d.,+-]").split(found[0])[0]), _of_quantity(found))
    value = _number(found[0]) if found["number"] else None
    return None if value is None else ("N", value)


def _name(
    found: "re.Match[str]", codes: Sequence[tuple[int, int]], words: Vocabulary, before: str, text: str, high: int
) -> Term | None:
    start, end, written = found.start(), found.end(), found[0]
    name, _, rest = written.partition("[")
    index = bisect_right(codes, (start, len(text))) - 1
    is_code = index >= 0 and end <= codes[index][1]
    if name in words.fields:
        held = _INDEX.fullmatch(rest) if rest else None
        value = NamedField(name, None, int(held[1]) if held else None)
        is_name = (
            is_code or "_" in name or any(character.isdigit() for character in name) or name[1:].lower() != name[1:]
        )
        if is_name:
            return Term("F", value, written, start, end)
    unit = None if is_code and name in words.fields else _symbol(start, before, text, high)
    if unit is not None:
        return unit
    if name in words.fields:
        return Term("P", NamedField(name), written, start, end)
    if name.lower() in words.fields and name[1:].islower() and len(name) > 2:
        return Term("P", NamedField(name.lower()), written, start, end)
    for field in in_snake(name) if is_code else ():
        if field in words.fields:
            return Term("F", NamedField(field), written, start, end)
    is_filling = written.lower() == "zero" and _FILLING.match(text, end) is not None
    if written.lower() in NUMBER_WORDS and written.lower() != "one" and not is_filling:
        return Term("N", Fraction(NUMBER_WORDS[written.lower()]), written, start, end)
    return camel(name, start, end, words)


def _symbol(start: int, before: str, text: str, high: int) -> Term | None:
    """The symbol of a unit; one that is a word as often has to stand where a unit does."""
    if text[max(start - 1, 0) : start] == "/":
        return None  # what something is divided by, "ft/min", where the unit before it is not known
    if _VARIABLE.match(text, start, start + 40):
        return None  # the variable of a member, "g.lat"
    unit = _COMPOUND.match(text, start, high)
    stated = worded_unit(unit[0]) if unit is not None else None
    rate = _PER_SECOND.match(text, unit.end(), high) if unit is not None and "/" not in unit[0] else None
    if unit is not None and rate is not None and (each := worded_unit(f"{unit[0]}/s")) is not None:
        return Term("U", each, text[start : rate.end()], start, rate.end())
    if unit is None or stated is None or not stated.dimension or text[unit.end() : unit.end() + 1].isalnum():
        return None
    if unit[0] == "T" and not _TESLA_PLACE.search(before):
        return None  # a time or a temperature of a formula
    if len(unit[0]) == 1 and _is_quoted(text, start, unit.end()) and _ASSIGNED.search(before):
        return None  # a text of code
    is_short = unit[0] in _SHORT_UNITS or unit[0].lower() in _ENGLISH or len(unit[0]) == 1
    is_value = text[unit.end() : unit.end() + 1] == "\n" and _UNIT_KEY.search(before) is not None
    if is_short and not (is_value or (_UNIT_PLACE.search(before) and _UNIT_END.match(text, unit.end(), high))):
        return None
    return Term("U", stated, unit[0], start, unit.end(), is_quoted=_is_quoted(text, start, unit.end()))


_VARIABLE = pattern(r"\w+(?:\.|->)[A-Za-z_]")
_ASSIGNED = pattern(r"(?<!unit)(?<!unit )(?<!units)(?<!units )(?<!=)= ?$")
"""Before a letter between quotation marks that is a value: the direction "N"."""
_TESLA_PLACE = pattern(r"(?:\b(?:in|as|to|gets?|gives?|N for|units?(?: (?:is|of|are))?):? ?|[(\[|] ?|U,? (?:and|or) )$")
"""Before a lone "T" that is a unit."""
_INDEX = pattern(r"(\d{1,3})\]")
_UNIT_KEY = pattern(r"\bunits? ?[:=] ?$")
"""Before the value of a key of YAML, which ends with its line."""
_PER_SECOND = pattern(r"\sper\ssecond\b")
_ENGLISH = frozenset((
    "a", "s", "x", "bar", "min", "rev", "pix", "hour", "day", "kn", "kt", "bit", "bits", "byte", "bytes", "second",
    "minute", "degree", "meter", "metre", "gram", "ton", "sec", "turn", "turns",
))  # fmt: skip


def _is_quoted(text: str, start: int, end: int) -> bool:
    return start > 0 and text[start - 1] in "\"'" and text[end : end + 1] in ("'", '"')


def constant_value(written: str) -> int | float | None:
    """The number of a name such as ``UINT16_MAX``, ``u16::MAX`` or ``NaN``, or of digits."""
    if "nan" in written.lower():
        return float("nan")
    if written[:2].lower() == "0x":
        return int(written, 16)
    rust = pattern(r"([ui])(\d+)::M(AX|IN)").fullmatch(written)
    if rust:
        return named_number(f"{'U' if rust[1] == 'u' else ''}INT{rust[2]}_M{rust[3]}")
    return named_number(written)


def _scalar(written: str, length: int | None) -> StatedType:
    """The type of a spelling in any language."""
    spelled = {"f32": "float", "float32": "float", "f64": "double", "float64": "double"}.get(written, written)
    name = SPELLINGS.get(spelled) or (f"{spelled}_t" if spelled[-1].isdigit() else spelled)
    bits = {"float": 32, "double": 64, "char": 8}.get(name) or int(pattern(r"\D").sub("", name) or 0)
    sign = "f" if name in ("float", "double") else None if name == "char" else name[0]
    return StatedType(name, bits, sign, length)


def _count(written: str) -> int:
    return NUMBER_WORDS.get(written.lower()) or int(written)


def _number(written: str) -> Fraction | None:
    text = pattern(r"[ ,\u00a0\u202f]").sub("", written).replace("\u2212", "-").replace("**", "^").lstrip("+")
    if text[:2].lower() == "0x":
        return Fraction(int(text, 16))
    if "<<" in text:
        return Fraction(1 << int(text.partition("<<")[2]))
    text = text.removesuffix("f").removesuffix(".")  # 100.0f of C
    if "^" in text:
        base, _, power = text.partition("^")
        return Fraction(base) ** int(power)
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        return None
