"""Missing answers are put into the text of a population table; everything else stays as it is, byte for byte."""

import re
from collections.abc import Mapping, Sequence

from codegen.diagnostics import Report, Rule
from codegen.frozen import dataclass
from codegen.importing.comparison import Compared, Verdict
from codegen.importing.table_text import answer_line
from codegen.load.yaml_tree import MappingNode, ScalarNode, YamlNode, parse_yaml
from codegen.model.dialect.dialect import WireMessage
from codegen.source import Place

MERGE_FORM = Rule(
    "merge-form",
    "Answers can be put only into a table with 'fields:' on a line of its own and each field on a line below it. "
    "Write the fields on lines of their own, or add the missing ones by hand.",
    remedy="write 'fields:' on a line of its own, and each field on a line below it",
)

_LINE_END = re.compile(r"\r\n?|\n")


@dataclass(frozen=True, slots=True)
class Merged:
    """The new text of a table, and the labels that were added to it in their order."""

    text: str
    added: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Lines:
    """A text in lines: ``texts`` without their ends, ``ends`` what ends each of them (empty behind the last)."""

    texts: tuple[str, ...]
    ends: tuple[str, ...]


def merge(
    text: str, path: str, message: WireMessage, compared: Sequence[Compared], document: str, report: Report
) -> Merged | None:
    """The text of a table with the answers that only the document has, each behind the field that precedes it.

    None, after a finding, if the form of the table does not allow it.
    """
    missing = [row for row in compared if row.verdict is Verdict.ONLY_DOCUMENT and row.document is not None]
    if not missing:
        return Merged(text, ())
    places = _field_places(text, path, report)
    if places is None:
        return None
    lines = _lines(text)
    order = {field.name: index for index, field in enumerate(message.definition.fields)}
    indent = min(place.column for place in places.values()) - 1
    behind: dict[int, list[str]] = {}
    for row in missing:
        assert row.document is not None
        line = " " * indent + answer_line(row.document, document).strip()
        behind.setdefault(_position(row, places, order, lines.texts, indent), []).append(line)
    merged = _inserted(lines, behind)
    if not _holds(merged, path, places, [row.target.label for row in missing]):
        report.add(
            MERGE_FORM, next(iter(places.values())), "the fields are written in a form that nothing can be added to"
        )
        return None
    return Merged(merged, tuple(row.target.label for row in missing))


def _field_places(text: str, path: str, report: Report) -> dict[str, Place] | None:
    """The place of each key of ``fields``; None, after a finding, unless they begin lines of one indentation."""
    found = Report()
    keys = _fields_of(parse_yaml(text, path, found))
    report.extend(found)
    if keys is None:
        report.add(MERGE_FORM, Place(path), "the table has no fields that something can be added to")
        return None
    lines = _LINE_END.split(text)
    for key in keys:
        if lines[key.place.line - 1][: key.place.column - 1].strip():
            report.add(MERGE_FORM, key.place, f"{key.text} does not begin its line")
            return None
    return {key.text: key.place for key in keys}


def _fields_of(root: YamlNode | None) -> list[ScalarNode] | None:
    entries = root.entries if isinstance(root, MappingNode) else ()
    fields = next((value for key, value in entries if key.text == "fields"), None)
    return [key for key, _ in fields.entries] if isinstance(fields, MappingNode) and fields.entries else None


def _position(
    row: Compared, places: Mapping[str, Place], order: Mapping[str, int], lines: Sequence[str], indent: int
) -> int:
    """The number of lines before the new one: those up to the end of the last field that precedes it in the dialect."""
    wanted = (order[row.target.field.name], row.target.first)
    before = [place for key, place in places.items() if _rank(key, order) < wanted]
    if not before:
        return min(place.line for place in places.values()) - 1 - _comments_above(lines, places)
    return _end(max(before).line, lines, indent)


def _rank(key: str, order: Mapping[str, int]) -> tuple[int, int]:
    name, _, index = key.partition("[")
    first = re.match(r"\d+", index)
    return order.get(name, -1), int(first[0]) if first else 0


def _comments_above(lines: Sequence[str], places: Mapping[str, Place]) -> int:
    """Return how many lines of comment stand right above the first field: they belong to it."""
    first = min(place.line for place in places.values()) - 1
    count = 0
    while lines[first - 1 - count].lstrip().startswith("#"):
        count += 1
    return count


def _end(start: int, lines: Sequence[str], indent: int) -> int:
    """The number of the last line of the entry that begins in line ``start``: what is indented further is in it."""
    end = start
    for number in range(start + 1, len(lines) + 1):
        text = lines[number - 1]
        if text.strip() and len(text) - len(text.lstrip(" ")) <= indent:
            break
        if text.strip():
            end = number
    return end


def _lines(text: str) -> _Lines:
    parts = re.split(r"(\r\n?|\n)", text)
    return _Lines(tuple(parts[::2]), (*parts[1::2], ""))


def _inserted(lines: _Lines, behind: Mapping[int, Sequence[str]]) -> str:
    """The text with new lines behind lines by number; they end as the others do."""
    end = next((end for end in lines.ends if end), "\n")
    pieces: list[str] = []
    for number in range(len(lines.texts) + 1):
        if number:
            has_end = lines.ends[number - 1]
            pieces.append(lines.texts[number - 1] + (has_end or (end if number in behind else "")))
        pieces.extend(line + end for line in behind.get(number, ()))
    return "".join(pieces)


def _holds(merged: str, path: str, before: Mapping[str, Place], added: Sequence[str]) -> bool:
    """Return whether the merged text is a table with exactly the fields of before and the added ones."""
    found = Report()
    keys = _fields_of(parse_yaml(merged, path, found))
    return keys is not None and not found.has_errors and sorted(key.text for key in keys) == sorted([*before, *added])
