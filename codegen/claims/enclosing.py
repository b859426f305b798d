"""The type that encloses a line of code: whether a member there is one of a message, or of somebody's own type."""

import re

from codegen.claims.reading import Reading
from codegen.load.prose import CodeBlock
from codegen.once import once
from codegen.source import Place

_TYPE = re.compile(
    r"\b(?:struct|class|interface|type|impl|union|message)\s+(?:__attribute__\S*\s+)?(?P<name>[A-Za-z_]\w*)"
    r"|\}\s*(?P<behind>[A-Za-z_]\w*)\s*;"
)
_CLOSED = re.compile(r"\s*\}")
_PARTS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
_AROUND = frozenset(("mavlink", "msg", "message", "t", "data", "struct", "payload", "packet", "wire", "fields"))
"""Words of a type's name besides those of its message."""
_UPPER = 60
"""How many lines around a member its type is looked for."""


def is_of_type(reading: Reading, place: Place, message: str) -> bool:
    """Whether the type around a line bears the name of a message, in whatever way a language spells it."""
    for code in _blocks_at(reading, place.line):
        lines = code.lines
        index = place.line - lines[0].place.line
        for line in reversed(lines[max(index - _UPPER, 0) : index + 1]):
            found = _TYPE.search(line.text)
            if found is not None and found["name"]:
                return is_named(found["name"], message)
            if line.place.line < place.line and _CLOSED.match(line.text):
                return False
            if "{" in line.text and "typedef" in line.text:
                break
        for line in lines[index : index + _UPPER]:
            found = re.match(r"\s*\}\s*(?P<name>\w+)", line.text)
            if found is not None:
                return is_named(found["name"], message)
    return False


def _blocks_at(reading: Reading, line: int) -> tuple[CodeBlock, ...]:
    return _blocks(reading).get(line, ())


@once
def _blocks(reading: Reading) -> dict[int, tuple[CodeBlock, ...]]:
    """The block of code by each of its lines."""
    return {line.place.line: (code,) for code in reading.prose.code for line in code.lines}


def is_named(name: str, message: str) -> bool:
    """Whether the name of a type is that of a message, as "GpsRawInt" or "mavlink_gps_raw_int_t"."""
    parts = [part.lower() for part in _PARTS.findall(name)]
    own = "".join(part for part in parts if part not in _AROUND)
    plain = message.replace("_", "").lower()
    return own == plain or "".join(parts) == plain


_MEMBER = re.compile(
    r"\s*(?:(?:pub|public|private|readonly|const)\s+)*(?:(?P<first>[A-Za-z_]\w*)\??\s*:\s*[^:=]"
    r"|(?:unsigned\s+)?[A-Za-z_]\w*\s+(?P<last>[A-Za-z_]\w*)\s*(?:\[[^\]]*\])?\s*;)"
)


def members_of_type(reading: Reading, place: Place) -> tuple[str, ...]:
    """The names of the members of the type that is declared around a line; none outside of types."""
    for code in _blocks_at(reading, place.line):
        lines = code.lines
        index = place.line - lines[0].place.line
        first = index
        while (
            first > max(index - _UPPER, 0)
            and not _TYPE.search(lines[first].text)
            and not _CLOSED.match(lines[first - 1].text)
        ):
            first -= 1
        if not _TYPE.search(lines[first].text):
            return ()
        names = []
        for line in lines[first + 1 : first + 2 * _UPPER]:
            if _CLOSED.match(line.text):
                break
            found = _MEMBER.match(line.text)
            if found is not None:
                names.append(found["first"] or found["last"])
        return tuple(names)
    return ()
