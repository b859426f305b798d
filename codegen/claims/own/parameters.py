"""Claims of a project's own documents about its parameters: defaults, ranges, steps, types, places in the list."""

import re
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import groupby

from codegen.claims.field_notes import cells
from codegen.claims.reading import Reading
from codegen.diagnostics import Diagnostic, Rule
from codegen.load.prose import Passage, PassageKind
from codegen.model.stated_parameter import StatedParameter
from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import conversion, decimal
from codegen.pattern import pattern

PARAMETER = Rule(
    "claim-parameter",
    "A document says another default, range, step, type or place of a parameter than parameters.yaml has, or another "
    "number of parameters. Correct the one that is out of date.",
    remedy="write what parameters.yaml has, or change it there",
)

_NAME = pattern(r"(?<![\w-])[A-Z][A-Z0-9]*(?:_[A-Z0-9]+)+(?![\w-])")
_NUMBER = r"-?\d+(?:\.\d+)?"
_UNIT = r"(?: ?(?P<unit>[A-Za-z%][A-Za-z0-9/%]{0,8})\b)?"
_TO = r"(?: to | ?\.\.\.? ?| ?\u2013 ?)"
_BEHIND = {
    "default": (
        pattern(rf"\bdefaults?(?: is| of|:|,)? (?:GPIO )?(?P<number>{_NUMBER})(?![\w.]\d|\w){_UNIT}"),
        pattern(rf"\bis (?P<number>{_NUMBER}){_UNIT} by default\b"),
        pattern(rf", (?P<number>{_NUMBER}){_UNIT} by default\b"),
    ),
    "step": (pattern(rf"\bsteps? of (?P<number>{_NUMBER})(?![\w.]\d|\w){_UNIT}"),),
}
_RANGE = pattern(rf"\brange(?: is| of|:|,)?(?: from)? (?P<low>{_NUMBER}){_TO}(?P<high>{_NUMBER})(?![\w.]\d|\w){_UNIT}")
_DIRECT = pattern(rf"(?:,| is| \(|:)(?: from)? ?(?P<low>{_NUMBER}){_TO}(?P<high>{_NUMBER})(?![\w.]\d|\w){_UNIT}")
_BEFORE = pattern(r"\bdefault of (?:the )?$")
_FIRST = pattern(rf"(?:,| is| of) (?P<number>{_NUMBER})(?![\w.]\d|\w){_UNIT}")
_COUNT = pattern(r"\b(?:all|the|list of(?: the)?)(?: all)? (?P<count>\d{1,4}) parameters\b", re.IGNORECASE)
_HEADS = {
    "index": pattern(r"index|number|no\.", re.IGNORECASE),
    "default": pattern(r"default", re.IGNORECASE),
    "minimum": pattern(r"min(?:imum)?", re.IGNORECASE),
    "maximum": pattern(r"max(?:imum)?", re.IGNORECASE),
    "step": pattern(r"steps?|increment", re.IGNORECASE),
    "range": pattern(r"range", re.IGNORECASE),
    "type": pattern(r"type", re.IGNORECASE),
}
_CELL = pattern(rf"(?P<number>{_NUMBER}){_UNIT}")
_SPAN = pattern(rf"(?P<low>{_NUMBER}) ?(?:to|\u2013|-|\.\.) ?(?P<high>{_NUMBER}){_UNIT}")
_TYPE = pattern(r"(?:MAV_PARAM_TYPE_)?(?P<type>U?INT(?:8|16|32)|REAL32)\b.*", re.IGNORECASE)


def check(reading: Reading) -> Iterator[Diagnostic]:
    """Every passage and every table that names a parameter."""
    if not reading.reference.parameters:
        return
    for kind, run in groupby(reading.prose.passages, lambda passage: passage.kind):
        passages = list(run)
        if kind is PassageKind.ROW:
            yield from _table(reading, passages)
        for passage in passages:
            yield from _counts(reading, passage)
            yield from _sentences(reading, passage)


def _counts(reading: Reading, passage: Passage) -> Iterator[Diagnostic]:
    systems = reading.reference.systems
    facts = (each for facts in reading.reference.parameters.values() for each in facts)
    counts = sorted({len(each.parameters) for each in systems} if systems else {each.count for each in facts})
    for found in _COUNT.finditer(passage.text):
        if int(found["count"]) not in counts:
            text = f"there are {' or '.join(map(str, counts))} parameters, not {found['count']}"
            yield reading.found(PARAMETER, passage.place_at(found.start("count")), found[0], text)


def _sentences(reading: Reading, passage: Passage) -> Iterator[Diagnostic]:
    """Yield findings for wrong facts behind the name of a parameter, up to the next one or the end of the sentence."""
    named = [found for found in _NAME.finditer(passage.text) if found[0] in reading.reference.parameters]
    for place, found in enumerate(named):
        facts = reading.reference.parameters[found[0]]
        _, end = passage.sentence(found.start(), found.end())
        until = min(end, named[place + 1].start()) if place + 1 < len(named) else end
        for fact, forms in _BEHIND.items():
            stated = next((each for form in forms if (each := form.search(passage.text, found.end(), until))), None)
            if stated is not None:
                yield from _compared(reading, passage, facts, fact, stated, "number")
        span = _RANGE.search(passage.text, found.end(), until) or _DIRECT.match(passage.text, found.end(), until)
        if span is not None:
            yield from _compared(reading, passage, facts, "minimum", span, "low")
            yield from _compared(reading, passage, facts, "maximum", span, "high")
        if _BEFORE.search(passage.text, max(found.start() - 24, 0), found.start()):
            stated = _FIRST.match(passage.text, found.end(), until)
            if stated is not None:
                yield from _compared(reading, passage, facts, "default", stated, "number")


def _table(reading: Reading, rows: Sequence[Passage]) -> Iterator[Diagnostic]:
    """Columns of a table with the names of parameters in one of them."""
    heads = [text.strip() for text, _ in cells(rows[0])]
    columns = {index: fact for index, head in enumerate(heads) for fact, form in _HEADS.items() if form.fullmatch(head)}
    for row in rows[1:]:
        own = cells(row)
        name = next((text.strip() for text, _ in own if text.strip() in reading.reference.parameters), None)
        for index, fact in columns.items() if name is not None and len(own) == len(heads) else ():
            facts = reading.reference.parameters[name or ""]
            text, offset = own[index]
            yield from _cell(reading, row, facts, fact, text.strip(), offset)


def _cell(
    reading: Reading, row: Passage, facts: Sequence[StatedParameter], fact: str, text: str, offset: int
) -> Iterator[Diagnostic]:
    if fact == "type":
        found = _TYPE.fullmatch(text)
        if found is not None and all(each.type.lower() != found["type"].lower() for each in facts):
            words = f"{facts[0].name} is {facts[0].type}, not {found['type']}"
            yield reading.found(PARAMETER, row.place_at(offset), f"{facts[0].name} {text}", words)
        return
    if fact == "range":
        span = _SPAN.fullmatch(row.text, offset, offset + len(text))
        if span is not None:
            yield from _compared(reading, row, facts, "minimum", span, "low")
            yield from _compared(reading, row, facts, "maximum", span, "high")
        return
    found = _CELL.fullmatch(row.text, offset, offset + len(text))
    if found is not None:
        yield from _compared(reading, row, facts, fact, found, "number")


def _compared(
    reading: Reading,
    passage: Passage,
    facts: Sequence[StatedParameter],
    fact: str,
    found: "re.Match[str]",
    group: str,
) -> Iterator[Diagnostic]:
    """A number beside what each program has; one of another dimension is about something else."""
    number = Fraction(found[group])
    unit = worded_unit(found["unit"]) if found["unit"] else None
    for each in facts:
        turned = conversion(unit, each.unit) if unit is not None and unit != each.unit else None
        stated = number if turned is None or not turned.ratio else number * turned.ratio
        if unit is not None and unit.dimension and unit != each.unit and turned is None:
            return
        if stated == getattr(each, fact):
            return
    first = facts[0]
    own = getattr(first, fact)
    shown = own if isinstance(own, int) else f"{decimal(own)} {first.unit.name}".strip()
    text = f"{first.name} has the {fact} {shown}, not {found[group]}"
    yield reading.found(PARAMETER, passage.place_at(found.start(group)), f"{first.name} {fact} {found[group]}", text)
