"""Fields that data name beside their message, and that it does not have: ``message: WIND, field: wind_speed``."""

import re
from collections.abc import Iterator

from codegen.claims.known_names import Names
from codegen.claims.parts.span import DATA
from codegen.claims.reading import Reading
from codegen.claims.unknown_fields import no_field
from codegen.diagnostics import Diagnostic
from codegen.load.markdown_blocks import Line
from codegen.load.prose import CodeBlock
from codegen.model.dialect.dialect import WireMessage
from codegen.pattern import pattern

_MESSAGE = pattern(r"\b(?:message|msg|mavlink)[\"']?\s*[:=]\s*[\"']?(?P<message>[A-Z][A-Z0-9_]{2,60})\b")
_FIELD = pattern(r"(?<![\w.])(?:field|member|attribute)[\"']?\s*[:=]\s*[\"']?(?P<field>[a-zA-Z]\w{0,60})\b(?!\.)")
_PATH = pattern(
    r"[:=]\s*[\"']?(?P<message>[A-Z][A-Z0-9_]{2,60})\.(?P<field>[a-z]\w{1,60})(?:\[\d*\])?[\"']?\s*(?:[,}#/]|$)"
)
_ENTRY = pattern(r"^\s*-\s|[{}]|^\s*\[\[|^[^\s\[].*:\s*$")
"""A line that begins or ends an entry: an item of YAML, a brace, a table of TOML, a key without indentation."""


def keyed_fields(reading: Reading, code: CodeBlock, names: Names) -> Iterator[Diagnostic]:
    """Every field of a block of data that the message of its entry lacks."""
    if code.language not in DATA or not any(_FIELD.search(line.text) or _PATH.search(line.text) for line in code.lines):
        return
    message: WireMessage | None = None
    for line in code.lines:
        if _ENTRY.search(line.text):
            message = None
        stated = _MESSAGE.search(line.text)
        message = names.messages.get(stated["message"]) if stated is not None else message
        found = _FIELD.search(line.text)
        if found is not None and message is not None:
            yield from _found(reading, line, found, message, names)
        path = _PATH.search(line.text)
        if path is not None and (own := names.messages.get(path["message"])) is not None:
            yield from _found(reading, line, path, own, names)


def _found(
    reading: Reading, line: Line, found: "re.Match[str]", message: WireMessage, names: Names
) -> Iterator[Diagnostic]:
    if message.field(found["field"]) is None and message.name not in names.followed:
        place = line.place._replace(column=line.place.column + found.start("field"))
        yield no_field(reading, place, message, found["field"])
