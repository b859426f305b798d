"""Claims of a project's own documents about its parameters: defaults, ranges, steps, types, places in the list."""

import re
from collections.abc import Iterator, Sequence
from difflib import get_close_matches
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
_NUMBER = r"-?\d+(?:\.\d+|,\d{1,2}(?![\d,]))?"
_WORD = r"(?:%|[A-Za-z\u00b0\u00b5][A-Za-z0-9/%\u00b0]{0,15})"
_UNIT = rf"(?![\w.]\d|\w)(?: ?(?P<unit>{_WORD})(?![\w%]))?"
_TO = r"(?: to | ?\.\.\.? ?| ?\u2026 ?| ?\u2013 ?)"
_ENDS = rf"(?P<low>{_NUMBER})(?: ?(?P<low_unit>(?!to\b){_WORD}))?{_TO}(?P<high>{_NUMBER}){_UNIT}"
_BEHIND = {
    "default": (
        pattern(rf"\bdefaults?(?: value)?(?: is| of| to|:| =|,)? (?:GPIO )?(?P<number>{_NUMBER}){_UNIT}"),
        pattern(rf"\bis (?P<number>{_NUMBER}){_UNIT} by default\b"),
        pattern(rf", (?P<number>{_NUMBER}){_UNIT} by default\b"),
    ),
    "step": (pattern(rf"\bsteps? of (?P<number>{_NUMBER}){_UNIT}"),),
}
_RANGE = pattern(rf"\brange(?: is| of|:| =|,)?(?: from)? {_ENDS}")
_DIRECT = pattern(rf"(?:,| is| \(|:)(?: from)? ?{_ENDS}")
_LEAD = r"(?:[,;:(]|\band|\bwith an?|\bis) ?"
_IS = "(?: value| size)?(?: is| of|:| =|,)?"
_IN_FURTHER_WORDS = {
    "range": (
        pattern(rf"\brange(?: is| of|:| =|,)? (?P<low>{_NUMBER}) ?- ?(?P<high>{_NUMBER}){_UNIT}"),
        pattern(
            rf"\brange(?: is| of|:| =|,)? \[(?P<low>{_NUMBER}) ?[,;] ?(?P<high>{_NUMBER})\](?: ?(?P<unit>{_WORD}))?"
        ),
        pattern(
            rf"{_LEAD}between (?P<low>{_NUMBER})(?: ?(?P<low_unit>(?!and\b){_WORD}))? and (?P<high>{_NUMBER}){_UNIT}"
        ),
        pattern(rf"{_LEAD}from {_ENDS}"),
    ),
    "step": (pattern(rf"{_LEAD}(?:step|increment){_IS} (?P<number>{_NUMBER}){_UNIT}"),),
    "minimum": (pattern(rf"{_LEAD}min(?:\.|imum)?{_IS} (?P<number>{_NUMBER}){_UNIT}"),),
    "maximum": (pattern(rf"{_LEAD}max(?:\.|imum)?{_IS} (?P<number>{_NUMBER}){_UNIT}"),),
}
"""Words that may be about something else: the unit behind the number has to fit the parameter, or none may follow."""
_FACTS_ALONE = pattern(
    rf"(?i)(?>[\s,;:()=|]|\b(?:is|it|can|may|be|set|to|of|the|an?|and|with|by|default|defaults|value|range|from|between|steps?"
    rf"|increment|settable|adjustable|min(?:imum)?|max(?:imum)?)\b\.?|\bin [a-z]+|{_NUMBER}(?: ?{_WORD})?)*+"
)
_NO_UNIT = pattern(r"\s*(?:[.,;:)\]]|$|(?:and|by|with)\b)")
_BEFORE = pattern(r"\bdefault of (?:the )?$")
_FIRST = pattern(rf"(?:,| is| of) (?P<number>{_NUMBER}){_UNIT}")
_COUNT = pattern(r"\b(?:all|the|list of(?: the)?)(?: all)? (?P<count>\d{1,4}) parameters\b", re.IGNORECASE)
_HEADS = {
    "index": pattern(r"index|number|no\.", re.IGNORECASE),
    "default": pattern(r"default(?: value)?", re.IGNORECASE),
    "minimum": pattern(r"min(?:\.|imum)?(?: value)?", re.IGNORECASE),
    "maximum": pattern(r"max(?:\.|imum)?(?: value)?", re.IGNORECASE),
    "step": pattern(r"steps?(?: size)?|increment", re.IGNORECASE),
    "range": pattern(r"range", re.IGNORECASE),
    "type": pattern(r"type", re.IGNORECASE),
    "unit": pattern(r"units?", re.IGNORECASE),
}
_CELL = pattern(rf"(?P<number>{_NUMBER}){_UNIT}")
_SPAN = pattern(rf"(?P<low>{_NUMBER}) ?(?:to|\u2013|-|\.\.\.?|\u2026) ?(?P<high>{_NUMBER}){_UNIT}")
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
            if (stated := _first(forms, passage.text, found.end(), until)) is not None:
                yield from _compared(reading, passage, facts, fact, stated, "number")
            elif fact in _IN_FURTHER_WORDS:
                yield from _in_further_words(reading, passage, facts, fact, (found.end(), until))
        span = _RANGE.search(passage.text, found.end(), until) or _DIRECT.match(passage.text, found.end(), until)
        if span is not None:
            yield from _compared_ends(reading, passage, facts, span)
        else:
            for fact in ("range", "minimum", "maximum"):
                yield from _in_further_words(reading, passage, facts, fact, (found.end(), until))
        if _BEFORE.search(passage.text, max(found.start() - 24, 0), found.start()):
            stated = _FIRST.match(passage.text, found.end(), until)
            if stated is not None:
                yield from _compared(reading, passage, facts, "default", stated, "number")


def _first(forms: Sequence["re.Pattern[str]"], text: str, start: int, end: int) -> "re.Match[str] | None":
    return next((each for form in forms if (each := form.search(text, start, end))), None)


def _in_further_words(
    reading: Reading, passage: Passage, facts: Sequence[StatedParameter], fact: str, span: tuple[int, int]
) -> Iterator[Diagnostic]:
    """Yield findings for a fact in further words, which nothing but other facts of the parameter may stand before."""
    found = _first(_IN_FURTHER_WORDS[fact], passage.text, *span)
    if found is None or not _FACTS_ALONE.fullmatch(passage.text, span[0], found.start()):
        return
    unit = worded_unit(found["unit"]) if found["unit"] else None
    if unit is None and not _NO_UNIT.match(passage.text, found.start("unit") if found["unit"] else found.end()):
        return
    if fact == "range":
        yield from _compared_ends(reading, passage, facts, found)
    else:
        yield from _compared(reading, passage, facts, fact, found, "number")


def _compared_ends(
    reading: Reading, passage: Passage, facts: Sequence[StatedParameter], found: "re.Match[str]", unit: str = ""
) -> Iterator[Diagnostic]:
    for fact, group in (("minimum", "low"), ("maximum", "high")):
        yield from _compared(reading, passage, facts, fact, found, group, unit)


def _table(reading: Reading, rows: Sequence[Passage]) -> Iterator[Diagnostic]:
    """Columns of a table with the names of parameters in one of them."""
    heads = [text.strip() for text, _ in cells(rows[0])]
    columns = {index: fact for index, head in enumerate(heads) for fact, form in _HEADS.items() if form.fullmatch(head)}
    known = reading.reference.parameters
    named: dict[str, int] = {}
    others: list[tuple[str, Passage, int, int]] = []
    for row in rows[1:]:
        own = cells(row)
        at = next((index for index, (text, _) in enumerate(own) if text.strip() in known), None)
        if at is None:
            others += [(text.strip(), row, at, offset) for at, (text, offset) in enumerate(own)]
            continue
        name = own[at][0].strip()
        named[name] = at
        if len(own) == len(heads):
            yield from _row(reading, row, known[name], [(fact, *own[index]) for index, fact in columns.items()])
    for name, row, at, offset in others if columns else ():
        near = get_close_matches(name, known, n=1, cutoff=0.8) if at in named.values() and _NAME.fullmatch(name) else ()
        if near and near[0] not in named:
            text = f"there is no parameter {name}"
            yield reading.found(PARAMETER, row.place_at(offset), name, text, f"did you mean {near[0]}?")


def _row(
    reading: Reading, row: Passage, facts: Sequence[StatedParameter], own: Sequence[tuple[str, str, int]]
) -> list[Diagnostic]:
    """Return what the cells of a row say otherwise; a unit that explains all of it is the one that is told."""
    units = [(text.strip(), offset) for fact, text, offset in own if fact == "unit" and text.strip()]
    unit, offset = units[0] if len(units) == 1 else ("", 0)

    def told(unit: str) -> list[Diagnostic]:
        return [
            finding
            for fact, text, offset in own
            if fact != "unit"
            for finding in _cell(reading, row, facts, fact, text.strip(), offset, unit)
        ]

    found, worded = told(unit), worded_unit(unit) if unit else None
    is_other = worded is not None and conversion(worded, facts[0].unit) is None
    if unit and (is_other or (found and len(told("")) < len(found))):
        text = f"{facts[0].name} is in {facts[0].unit.name or 'no unit'}, not in {unit}"
        return [reading.found(PARAMETER, row.place_at(offset), f"{facts[0].name} {unit}", text), *told("")]
    return found


def _cell(
    reading: Reading,
    row: Passage,
    facts: Sequence[StatedParameter],
    fact: str,
    text: str,
    offset: int,
    unit: str,
) -> list[Diagnostic]:
    """Return what a cell says otherwise; ``unit`` is that of the row, for numbers that have none of their own."""
    if fact == "type":
        found = _TYPE.fullmatch(text)
        if found is not None and all(each.type.lower() != found["type"].lower() for each in facts):
            words = f"{facts[0].name} is {facts[0].type}, not {found['type']}"
            return [reading.found(PARAMETER, row.place_at(offset), f"{facts[0].name} {text}", words)]
        return []
    if fact == "range":
        span = _SPAN.fullmatch(row.text, offset, offset + len(text))
        return [] if span is None else list(_compared_ends(reading, row, facts, span, unit))
    found = _CELL.fullmatch(row.text, offset, offset + len(text))
    return [] if found is None else list(_compared(reading, row, facts, fact, found, "number", unit))


def _compared(
    reading: Reading,
    passage: Passage,
    facts: Sequence[StatedParameter],
    fact: str,
    found: "re.Match[str]",
    group: str,
    of_row: str = "",
) -> Iterator[Diagnostic]:
    """A number beside what each program has; one of another dimension is about something else."""
    number = Fraction(found[group].replace(",", "."))
    groups = found.groupdict()
    written = (groups.get("low_unit") if group == "low" else None) or groups["unit"] or of_row
    unit = worded_unit(written) if written else None
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
    said = found[group] if unit is None or unit == first.unit else f"{found[group]} {written}"
    text = f"{first.name} has the {fact} {shown}, not {said}"
    yield reading.found(PARAMETER, passage.place_at(found.start(group)), f"{first.name} {fact} {found[group]}", text)
