"""A cell that says what goes into a field becomes an answer, or a finding with a proposal; never a guess."""

import json
import re
from dataclasses import replace

from codegen.diagnostics import Report, Rule, did_you_mean
from codegen.importing.answer import UNREAD, Reading, Sources, Target, field_answer
from codegen.importing.number import carries, has_entries, read_entry, read_number, stated_number, unknown_answer
from codegen.importing.quantity import field_unit, likely_quantity, read_quantity
from codegen.importing.remark import remarked
from codegen.load.expression import quantity_path, read_product
from codegen.load.markdown_table import Cell
from codegen.model.dialect.dialect import Kind
from codegen.model.dialect.literals import same_number
from codegen.model.units.nearest_unit import worded_unit
from codegen.model.units.unit import read_measure

DOCUMENT_EMPTY = Rule(
    "document-empty",
    "A document names a field and says nothing about its value.",
    remedy="say what goes into the field, `unknown` if nothing does",
)
DOCUMENT_AMBIGUOUS = Rule(
    "document-ambiguous",
    "A document leaves open what goes into a field ('-1 or estimate', 'optional', 'to be defined'). A table has one "
    "answer; decide, and write it into the document.",
    remedy="decide, and write the one answer into the document",
)
DOCUMENT_PROSE = Rule(
    "document-prose",
    "What goes into a field is said in words that could mean more than one thing. A cell that is read holds a number, "
    "an entry of an enum, a limit such as UINT16_MAX, a quantity, a product of a quantity and numbers, or the answer "
    "as the population tables write it, in code: `{state: battery.voltage}`.",
    remedy="write the answer in code, such as `{state: component.quantity}`, or a number",
)

_OPEN = re.compile(
    r"\b(?:or|either|optional(?:ly)?|tb[dca]|maybe|perhaps|possibly|undecided|to be (?:defined|decided))\b"
)
_NOT_DECIDED = re.compile(
    r"(?:still )?(?:to be (?:confirmed|clarified|determined|agreed|checked)|pending|proposed|proposal|draft|preliminary"
    r"|provisional|tentative|placeholder)"
)
_QUESTION = re.compile(r"\?\s*$|^\?+$")
_NUMBER = r"[-+\u2212]?(?:0[xX][0-9a-fA-F]{1,16}|\d{1,20}(?:\.\d{1,20})?(?:[eE][-+]?\d{1,2})?)"
_ATOM = re.compile(
    rf"(?P<head>{_NUMBER}(?![\w.])|[uif]\d{{1,2}}::(?:MAX|MIN|NAN)"
    r"|(?:[Nn]ot|[Nn]o) (?:available|known|measured|provided)\b|[A-Za-z_]\w*(?![\w.\[(:]|->)|[Nn]/[Aa])"
    r"\s*(?:\((?P<inner>[^()]*(?:\([^()]*\)[^()]*)*)\)|(?:=|:|,|;|[-\u2013\u2014]\s)\s*(?P<after>.*))?",
    re.DOTALL,
)
_LEADING = re.compile(rf"{_NUMBER}(?=\s*(?:[(;:,]|$))")
_IN_BRACKETS = re.compile(rf"({_NUMBER})\s*\(([^()]*)\)")
_BEHIND = re.compile(rf"({_NUMBER})\s*[=:,;\u2013\u2014-]\s*([^\W\d_]+|[^\s\d]+$)", re.DOTALL)
_SHORTEST_WORD = 4
"""A shorter one, such as min and a, may be a remark, unless nothing else stands there."""
_FURTHER = re.compile(rf"(?<![\w.-])(?:(?:section|chapter|criterion|page|table|figure) )?({_NUMBER})(?![\w.]*\w)")
_DECIMAL_COMMA = re.compile(r"(?<![\w.,])([-+\u2212]?\d{1,20}),(\d{1,20})(?![\w,]*\d)")
_UNKNOWN = re.compile(
    r"\b(?:unknown|unavailable|unset|unused|invalid"
    r"|(?:not|no) (?:provided|known|available|measured|used|supported|set))\b",
    re.IGNORECASE,
)
_UNKNOWN_HEADS = ("unknown", "unavailable", "unset", "invalid", "n/a", "none")
_REMARK = re.compile(r"\s*\([^()]*\)$")
_DOTTED = re.compile(r"\b[A-Za-z_]\w+(?:(?:\.|::|->)[A-Za-z_]\w+)+")
_FOOTNOTE = re.compile(r"\s?\[\^[^\]\s]{1,40}\]")
_LIST = re.compile(rf"[\[{{(]\s*({_NUMBER})((?:\s*,\s*\1)*)\s*[\])}}]")
_WORD = re.compile(r"[A-Za-z_]\w*")
_RUST = re.compile(r"([uif])(\d{1,2})::(MAX|MIN|NAN)")


def read_value(cell: Cell, target: Target, sources: Sources, report: Report) -> Reading:
    """Return what ``cell`` says about ``target``; everything that keeps it from
    being an answer is reported at its place.
    """
    text = _FOOTNOTE.sub("", cell.text.strip())
    if not text or text in ("-", "\u2013", "\u2014"):
        hint = _hint(_proposals(cell, target, sources))
        report.add(DOCUMENT_EMPTY, cell.place, f"nothing is said about the value of {target.name}", hint)
        return UNREAD
    if cell.codes and text == cell.codes[0].strip() and text.startswith("{"):
        place = cell.place._replace(column=cell.place.column + len(cell.written) - len(cell.written.lstrip("` ")))
        answer = field_answer(text, place, report)
        if answer is None or not has_entries(answer, cell, target, sources, report):
            return UNREAD
        measure = read_measure(answer.constant) if isinstance(answer.constant, str) else None
        if measure is not None and not carries(measure, str(answer.constant), cell.place, target, report):
            return UNREAD
        return Reading(text, is_whole=True)
    outside = re.sub(r"\([^()]*\)", " ", text).casefold()
    in_brackets = re.findall(r"\(([^()]*)\)", text)
    if _OPEN.search(outside) or _QUESTION.search(text) or any(_is_open(each) for each in in_brackets):
        return _ambiguous(cell, target, sources, report)
    if in_brackets and _says_another(text.partition("(")[0].strip(), in_brackets[-1], target):
        return _prose(cell, target, sources, report)
    if (listed := _LIST.fullmatch(text)) is not None and target.count > 1 == target.count - listed[2].count(","):
        text = listed[1] if same_number(stated_number(listed[1], target), target.sentinel) else text
    reading = _read_atom(text, cell, target, sources, report) or _read_product(text, cell, target, sources, report)
    return reading or _prose(cell, target, sources, report)


def leaves_open(note: Cell) -> bool:
    """Return whether a cell with notes says nothing but that its row is not decided: TBD, ?, to be defined."""
    return _is_open(note.text)


def _is_open(text: str) -> bool:
    text = text.strip().casefold()
    bare = text.rstrip(".!")
    return any((_QUESTION.fullmatch(text), _OPEN.fullmatch(bare), _NOT_DECIDED.fullmatch(bare)))


def in_unit(cell: Cell, unit: str, target: Target) -> Cell:
    """Return a cell whose number has the unit that its column's heading states, where that is another than the field's.

    The number that stands for unknown stays as it is, and so does one of a field without a unit, such as an entry's.
    """
    field, found = target.field, _LEADING.match(cell.text)
    is_own = unit == field.definition.units and field.multiplier == 1
    if not unit or not found or not field.definition.units or is_own:
        return cell
    if _with_unit(cell.text) != cell.text or not _is_remark(cell.text, found[0], target):
        return cell
    if target.sentinel is not None and same_number(stated_number(found[0], target), target.sentinel):
        return cell
    return replace(cell, text=f"{found[0]} {unit}{cell.text[found.end() :]}")


def _read_atom(text: str, cell: Cell, target: Target, sources: Sources, report: Report) -> Reading | None:
    """A number, a limit, an entry or a word for unknown, with a remark behind it; None if the text is none of these."""
    measured = _with_unit(text)
    amount = _REMARK.sub("", measured)
    measure = read_measure(amount) if target.field.definition.units else None
    if measure is not None:
        return Reading(f"{{constant: {amount}}}") if carries(measure, amount, cell.place, target, report) else UNREAD
    match = _ATOM.fullmatch(text)
    if match is None or measured != text:
        return None
    head, remark = match["head"], match["inner"] or match["after"] or ""
    if match["after"] and not (_is_remark(match["after"], head, target) and _names_no_source(match, sources)):
        return None
    head = _RUST.sub(_limit_of_rust, head).replace("\u2212", "-")
    says_unknown = _UNKNOWN.search(remark) is not None
    if _is_unknown(head):
        return unknown_answer(remark, cell, target, sources, report)
    if head in sources.parameters:
        return Reading(f"{{parameter: {head}}}")
    if target.field.type.kind is Kind.CHAR and cell.codes:
        return Reading(f"{{constant: {json.dumps(cell.codes[0])}}}")
    return read_entry(head, remark, cell, target, sources, report) or read_number(
        head, remark, says_unknown, cell, target, sources, report
    )


def _with_unit(text: str) -> str:
    """Return a number with the unit that stands behind it as a remark does, 10 (V) or 54: degrees; others as it is."""
    match = _IN_BRACKETS.match(text)
    if match is not None:
        rest = text[match.end() :]
    else:
        match = _BEHIND.match(text)
        rest = ""
        if match is None or (match.end() != len(text) and len(match[2]) < _SHORTEST_WORD):
            return text
    unit = worded_unit(match[2])
    return text if unit is None else f"{match[1]} {unit.name}{rest}"


def _is_remark(after: str, head: str, target: Target) -> bool:
    """Return whether nothing behind a number is another one: a range, a list, or the digits behind a decimal comma."""
    further = (found for found in _FURTHER.finditer(after) if found[0] == found[1])
    number = stated_number(head, target)
    return number is None or all(stated_number(found[1], target) == number for found in further)


def _is_unknown(head: str) -> bool:
    return head.casefold() in _UNKNOWN_HEADS or (" " in head and _UNKNOWN.fullmatch(head) is not None)


def _names_no_source(match: re.Match[str], sources: Sources) -> bool:
    """Return whether no quantity or parameter stands behind a number: 20 - tank.air is no 20 with a remark."""
    if _is_unknown(match["head"]):
        return True
    names = _DOTTED.findall(match["after"])
    known = sources.quantities
    paths = {quantity_path(name) for name in names}
    is_source = bool(names) if known is None else not paths.isdisjoint(known)
    return not is_source and not any(word in sources.parameters for word in _WORD.findall(match["after"]))


def _says_another(text: str, remark: str, target: Target) -> bool:
    """Return whether nothing but another number stands in brackets behind a number: 5 (6), 50 (0.4 m) in centimetres.

    The same one in another form, 255 (0xFF), says it again, and what has words is a remark.
    """
    said, again = (_on_wire(each, target) for each in (text, remark.strip()))
    return said is not None and again is not None and not same_number(said, again)


def _on_wire(text: str, target: Target) -> int | float | None:
    """The number that a text states, in the steps of the field: by itself, or with a unit that fits."""
    measure, unit = read_measure(text), field_unit(target)
    if measure is None or unit is None:
        return stated_number(text, target)
    number = measure.in_unit(unit)
    return None if number is None else int(number) if number.denominator == 1 else float(number)


def _limit_of_rust(match: re.Match[str]) -> str:
    letter, bits, end = match.groups()
    return "NaN" if letter == "f" else f"{'U' if letter == 'u' else ''}INT{bits}_{end}"


def _read_product(text: str, cell: Cell, target: Target, sources: Sources, report: Report) -> Reading | None:
    """A quantity, perhaps multiplied and cast, with a remark in brackets or none."""
    product, remark = read_product(text), _REMARK.search(text)
    if product is None and remark is not None and (bare := read_product(text[: remark.start()])) is not None:
        product = remarked(bare, remark[0].strip(" ()"), target, sources)
    return None if product is None else read_quantity(product, cell, target, sources, report)


def _ambiguous(cell: Cell, target: Target, sources: Sources, report: Report) -> Reading:
    proposals = _proposals(cell, target, sources)
    message = f"{cell.text!r} leaves open what goes into {target.name}"
    report.add(DOCUMENT_AMBIGUOUS, cell.place, message, _hint(proposals))
    return Reading(proposal=proposals[0] if proposals else None)


def _prose(cell: Cell, target: Target, sources: Sources, report: Report) -> Reading:
    quantity = likely_quantity(cell.text, target, sources)
    hint = "name the quantity, `{state: component.quantity}`, or write the number"
    if comma := _DECIMAL_COMMA.search(cell.text):
        hint = f"write a decimal point: {comma[1]}.{comma[2]}, or a whole number without a comma: {comma[1]}{comma[2]}"
    elif quantity is not None:
        hint = f"if it is meant, `{quantity}`"
    elif sources.quantities and len(cell.text.split()) == 1:
        hint = did_you_mean(cell.text, sources.quantities) or hint
    report.add(DOCUMENT_PROSE, cell.place, f"{cell.text!r} does not say what goes into {target.name}", hint)
    return Reading(proposal=quantity)


def _proposals(cell: Cell, target: Target, sources: Sources) -> list[str]:
    """Return what people may choose from: unknown, if the dialect has a sentinel, and
    the quantity that the words suggest.
    """
    found = [] if target.sentinel is None else ["unknown"]
    quantity = likely_quantity(cell.text, target, sources)
    return found if quantity is None else [*found, quantity]


def _hint(proposals: list[str]) -> str | None:
    if not proposals:
        return None
    return "answer with " + " or ".join(f"`{proposal}`" for proposal in proposals)
