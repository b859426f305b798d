"""Casts in code that turn a real value into the one that means unknown: "(voltage * 1000.0) as u16"."""

import re
from collections.abc import Iterator

from codegen.claims.field_notes import cells
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.model.dialect import WireField, WireMessage
from codegen.model.literals import LIMITS
from codegen.source import Place

RULE = Rule(
    "claim-cast-to-sentinel",
    "Code in a document converts a quantity with a cast whose result can be the value that means unknown: Rust's 'as' "
    "saturates at the ends of the type, and passes every value in between. Limit the value beside the sentinel first.",
)

_CAST = re.compile(
    r"\((?P<what>[^()]{1,80}?(?:\([^()]{0,40}\)[^()]{0,40}?)?)\*\s*(?P<scale>\d{1,9}(?:\.\d{1,6})?)\s*\)\s*as\s+"
    r"(?P<type>(?P<sign>[ui])(?P<bits>8|16|32))\b"
)
_LIMITED = re.compile(r"\b(?:min|max|clamp)\s*\(")
_LET = re.compile(r"\blet\s+(?:mut\s+)?(?P<name>\w+)\s*(?::\s*\w+\s*)?=\s*$")
_MEMBER = re.compile(r"(?P<name>[a-z]\w*)(?:\[[^\]]{0,20}\])?\s*[:=]\s*$")
_NAME = re.compile(r"[a-z]\w*")


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every cast of a scaled quantity that goes into a field with such a value."""
    for code in reading.prose.code:
        for line in code.lines:
            for found in _CAST.finditer(line.text):
                names = _assigned(line.text[: found.start()], code)
                place = line.place._replace(column=line.place.column + found.start())
                yield from _cast(reading, found, names, place)
    for passage in reading.prose.passages:
        if passage.kind is PassageKind.ROW:
            for found in _CAST.finditer(passage.text):
                yield from _cast(reading, found, _first_cell(passage), passage.place_at(found.start()))


def _assigned(before: str, code: CodeBlock) -> list[str]:
    """The names that the value of a cast goes to: the one that it is bound to, and members that are set to that."""
    member = _MEMBER.search(before)
    bound = _LET.search(before)
    if bound is None:
        return [member["name"]] if member else []
    use = re.compile(rf"(?<![\w.])([a-z]\w*)(?:\[[^\]]{{0,20}}\])?\s*[:=]\s*{re.escape(bound['name'])}\b")
    return [bound["name"], *(found[1] for line in code.lines for found in use.finditer(line.text))]


def _first_cell(row: Passage) -> list[str]:
    own = cells(row)
    found = _NAME.match(own[0][0].strip()) if own else None
    return [found[0]] if found else []


def _cast(reading: Reading, found: "re.Match[str]", names: list[str], place: Place) -> Iterator[Diagnostic]:
    holder = _field(reading, names, place.line)
    if holder is None or _LIMITED.search(found["what"]):
        return
    message, field = holder
    kind = f"{'U' if found['sign'] == 'u' else ''}INT{found['bits']}"
    low, high = LIMITS[f"{kind}_MIN"], LIMITS[f"{kind}_MAX"]
    sentinels = {value for value in field.sentinel.values if value is not None} if field.sentinel else set()
    hit = sorted(value for value in sentinels if low <= value <= high)
    if not hit:
        return
    name, value = f"{message.name}.{field.name}", int(hit[0])
    how = f"saturates at {value}" if value in (low, high) else f"can be {value}"
    text = f"the cast to {found['type']} {how}, which means unknown in {name}"
    beside = value - 1 if value == high else value + 1 if value == low else value - 1
    words = f"as {found['type']} {value}"
    yield reading.found(RULE, place, words, text, f"a real value goes out as {beside} at the nearest")


def _field(reading: Reading, names: list[str], line: int) -> tuple[WireMessage, WireField] | None:
    for message in reading.named_near(line):
        for name in names:
            field = message.field(name)
            if field is not None:
                return message, field
    return None
