"""Lines of code and of comments that are a table without its rules: names in one column, what is said in the next.

    /*   distances[]     64 bins of uint16_t, centimetres      size   uint32   bytes      size;uint32_t;bytes
     *                   one without a measurement is 0  */

Each of its lines is an item about the field that it begins with, with the lines that go on below its second column.
"""

import re
from collections.abc import Collection, Iterator

from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock, Passage, PassageKind
from codegen.pattern import pattern
from codegen.source import Place

_LEAD = r"\s*(?://[/!]?|/\*\*?|\*(?!/)|#(?!\w)|--)?\s*"
_ENTRY = pattern(
    rf"^(?P<lead>{_LEAD})(?P<name>[A-Za-z_]\w*)(?:\[\d*\])?(?P<gap>\s{{2,}}|\t+|\s*;)(?P<rest>[^\s=;({{].*?)\s*(?:\*/)?$"
)
_ALONE = pattern(rf"^(?P<lead>{_LEAD})(?P<name>[A-Za-z_]\w*),\s*$")
_GOES_ON = pattern(rf"^(?P<lead>{_LEAD})(?P<rest>\S.*?)\s*(?:\*/)?$")
_TYPE = pattern(r"\b(?:u?int(?:8|16|32|64)(?:_t)?|[ui](?:8|16|32|64)|float|double|char|\d+[ -]bit)\b")
_BETWEEN = pattern(r"\s{2,}|\t+|\s*;\s*")
_FEWEST = 3
"""Lines that begin with a field before a block is such a table."""
_TYPED = 2
"""Lines of them that name a type."""


def aligned_items(code: CodeBlock, fields: Collection[str]) -> Iterator[Passage]:
    """Yield the lines of a block that are rows about fields, each as an item "name: what is said, ..."."""
    entries = [(index, _ENTRY.match(line.text)) for index, line in enumerate(code.lines)]
    rows = [(index, found) for index, found in entries if found is not None and _is_row(found)]
    own = [(index, found) for index, found in rows if found["name"] in fields]
    typed = sum(_TYPE.search(found["rest"]) is not None for _, found in own)
    if len(own) < _FEWEST or 2 * len(own) <= len(rows) or typed < _TYPED:
        return
    starts = {index for index, found in entries if found is not None}
    for index, found in own:
        yield _item(code.lines, index, found, starts, fields)


def csv_rows(code: CodeBlock, fields: Collection[str]) -> Iterator[Passage]:
    """Yield the lines of a block of values between commas, the first of which has the heads, as rows of a table."""
    lines = [line for line in code.lines if line.text.strip()]
    if len(lines) <= _FEWEST or not _HEADS.fullmatch(lines[0].text):
        return
    mark = ";" if ";" in lines[0].text else ","
    many = lines[0].text.count(mark)
    named = sum(not set(line.text.replace(" ", "").split(mark)).isdisjoint(fields) for line in lines[1:])
    if many < _TYPED or any(line.text.count(mark) < many for line in lines) or 2 * named < len(lines):
        return
    for line in lines:
        text = "| " + " | ".join(cell.strip() for cell in line.text.split(mark, many)) + " |"
        anchors, start, at = [(0, line.place)], 0, 0
        for cell in line.text.split(mark, many):
            at = text.index("|", at) + 2
            anchors.append((at, _at(line, start + len(cell) - len(cell.lstrip()))))
            start += len(cell) + 1
        yield Passage(PassageKind.ROW, text, tuple(anchors), ())


_HEADS = pattern(r"\s*[a-z][a-z _]*(?:[,;]\s*[a-z][a-z _()/]*){2,}", re.IGNORECASE)


def _is_row(found: "re.Match[str]") -> bool:
    """Return whether a line is a row of a table, and no statement of a language such as ``return   x;``."""
    is_comment = bool(found["lead"].strip())
    return is_comment or not found["rest"].endswith((";", "{", "(")) or ";" in found["gap"]


def _item(
    lines: tuple[Line, ...], index: int, found: "re.Match[str]", starts: Collection[int], fields: Collection[str]
) -> Passage:
    text = ""
    anchors: list[tuple[int, Place]] = []
    codes: list[tuple[int, int]] = []
    for above in range(index - 1, max(index - 4, -1), -1):
        alone = _ALONE.match(lines[above].text)
        if alone is None or alone["name"] not in fields:
            break
        codes.append((len(text), len(text) + len(alone["name"])))
        anchors.append((len(text), _at(lines[above], alone.start("name"))))
        text += alone["name"] + ", "
    codes.append((len(text), len(text) + len(found["name"])))
    anchors.append((len(text), _at(lines[index], found.start("name"))))
    text += found["name"] + ": "
    position = found.start("rest")
    for gap in (*_BETWEEN.finditer(lines[index].text, position, found.end("rest")), None):
        end = gap.start() if gap is not None else found.end("rest")
        anchors.append((len(text), _at(lines[index], position)))
        text += lines[index].text[position:end] + ", "
        position = gap.end() if gap is not None else end
    text = text.removesuffix(", ")
    for below in range(index + 1, len(lines)):
        more = _GOES_ON.match(lines[below].text)
        if more is None or below in starts or more.start("rest") < found.start("rest") - 1:
            break
        text += " "
        anchors.append((len(text), _at(lines[below], more.start("rest"))))
        text += more["rest"]
    return Passage(PassageKind.ITEM, text, tuple(anchors), tuple(codes))


def _at(line: Line, column: int) -> Place:
    return line.place._replace(column=line.place.column + column)
