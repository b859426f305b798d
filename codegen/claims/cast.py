"""Casts in code that make the value for unknown of a real one: "(voltage * 1000.0) as u16", "(int16_t)(amps * 100)"."""

import re
from collections.abc import Iterator

from codegen.claims.field_notes import cells
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.model.dialect.dialect import WireField, WireMessage
from codegen.model.dialect.literals import LIMITS
from codegen.pattern import pattern
from codegen.source import Place

RULE = Rule(
    "claim-cast-to-sentinel",
    "Code in a document converts a quantity with a cast whose result can be the value that means unknown: Rust's 'as' "
    "saturates at the ends of the type, C's cast wraps or worse, and both pass every value in between. Limit the value "
    "beside the sentinel first.",
)

_SCALED = r"\((?P<what>[^()]{1,80}?(?:\([^()]{0,40}\)[^()]{0,40}?)?)\*\s*\d{1,9}(?:\.\d{1,6})?f?\s*\)"
_RUST = pattern(rf"{_SCALED}\s*as\s+(?P<type>(?P<sign>[ui])(?P<bits>8|16|32))\b")
_C = pattern(rf"\(\s*(?P<type>(?P<sign>u?)int(?P<bits>8|16|32)_t)\s*\)\s*{_SCALED}")
_LIMITED = pattern(r"\b(?:f?min|f?max|clamp|constrain\w*)\s*\(", re.IGNORECASE)
_BOUND = pattern(r"\b(?:let\s+(?:mut\s+)?|(?:const\s+)?u?int\d\d?_t\s+)(?P<name>\w+)\s*(?::\s*\w+\s*)?=\s*$")
_MEMBER = pattern(r"(?P<name>[a-z]\w*)(?:\[[^\]]{0,20}\])?\s*[:=]\s*$")
_USE = pattern(r"(?<!\w)(?P<member>[a-z]\w*)(?:\[[^\]]{0,20}\])?\s*[:=]\s*(?P<name>\w+)\b")
_NAME = pattern(r"[a-z]\w*")

_Cast = re.Match[str]


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every cast of a scaled quantity that goes into a field with such a value."""
    for code in reading.prose.code:
        members: dict[str, list[str]] | None = None
        for line in code.lines:
            for found in _casts(line.text):
                members = _members(code) if members is None else members
                names = _assigned(line.text[: found.start()], members)
                place = line.place._replace(column=line.place.column + found.start())
                yield from _cast(reading, found, names, place)
    for passage in reading.prose.passages:
        if passage.kind is PassageKind.ROW:
            for found in _casts(passage.text):
                yield from _cast(reading, found, _first_cell(passage), passage.place_at(found.start()))


def _casts(text: str) -> Iterator[_Cast]:
    if "*" in text and (" as " in text or "_t" in text):
        yield from _RUST.finditer(text)
        yield from _C.finditer(text)


def _members(code: CodeBlock) -> dict[str, list[str]]:
    """The members that are set to a name somewhere in a block, by that name."""
    members: dict[str, list[str]] = {}
    for line in code.lines:
        for found in _USE.finditer(line.text):
            members.setdefault(found["name"], []).append(found["member"])
    return members


def _assigned(before: str, members: dict[str, list[str]]) -> list[str]:
    """The names that the value of a cast goes to: the one that it is bound to, and members that are set to that."""
    bound = _BOUND.search(before[-80:])
    if bound is not None:
        return [bound["name"], *members.get(bound["name"], ())]
    member = _MEMBER.search(before[-80:])
    return [member["name"]] if member else []


def _first_cell(row: Passage) -> list[str]:
    own = cells(row)
    found = _NAME.match(own[0][0].strip()) if own else None
    return [found[0]] if found else []


def _cast(reading: Reading, found: _Cast, names: list[str], place: Place) -> Iterator[Diagnostic]:
    holder = _field(reading, names, place.line)
    if holder is None or _LIMITED.search(found["what"]):
        return
    message, field = holder
    is_unsigned, is_rust = found["sign"] == "u", not found["type"].endswith("_t")
    kind = f"{'U' if is_unsigned else ''}INT{found['bits']}"
    low, high = LIMITS[f"{kind}_MIN"], LIMITS[f"{kind}_MAX"]
    sentinels = {value for value in field.sentinel.values if value is not None} if field.sentinel else set()
    hit = sorted(value for value in sentinels if low <= value <= high)
    if not hit:
        return
    name, value = f"{message.name}.{field.name}", int(hit[0])
    how = f"saturates at {value}" if is_rust and value in (low, high) else f"can be {value}"
    text = f"the cast to {found['type']} {how}, which means unknown in {name}"
    beside = value + 1 if value == low else value - 1
    words = f"as {found['type']} {value}"
    hint = f"limit real values to {beside}" if value in (low, high) else f"send {beside} for a real {value}"
    yield reading.found(RULE, place, words, text, hint)


def _field(reading: Reading, names: list[str], line: int) -> tuple[WireMessage, WireField] | None:
    for message in reading.named_near(line):
        for name in names:
            field = message.field(name)
            if field is not None:
                return message, field
    return None
