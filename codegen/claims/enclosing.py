"""The type that encloses a line of code: whether a member there is one of a message, or of somebody's own type."""

import re
from collections.abc import Iterator, Mapping

from codegen.claims.reading import Reading, parts_at, snake
from codegen.load.prose import CodeBlock
from codegen.model.dialect.dialect import WireMessage
from codegen.once import once
from codegen.pattern import pattern
from codegen.source import Place

_TYPE = pattern(
    r"\b(?:struct|class|interface|type|impl|union|message|extension)\s+(?:__attribute__\S*\s+)?(?P<name>(?!__attribute__)[A-Za-z_]\w*)"
)
_CLOSED = pattern(r"\s*\}")
_PARTS = pattern(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
_AROUND = frozenset(("mavlink", "msg", "message", "t", "data", "struct", "payload", "packet", "wire", "fields"))
"""Words of a type's name besides those of its message."""
_ALIKE = 4
"""So many letters of two words make one short for the other."""
_UPPER = 60
"""The most lines above or below a member in which its type is looked for."""


_COMMENT = pattern(r"//|/\*|^\s*\*|#\s|<!--")


def _declared(line: str) -> "re.Match[str] | None":
    """Match the declaration of a type; the words of a comment, "message unit", are none."""
    found = _TYPE.search(line)
    return None if found is None or _COMMENT.search(line, 0, found.start()) else found


_OF_LIBRARY = pattern(r"^(?:mavlink_)?(?:msg_)?|^MVMessage(?=[A-Z])|(?<=[a-z0-9])_t$")
"""Around the name of a message in the name of a type: "msg_altitude", "mavlink_altitude_t", "MVMessageAltitude"."""


def _message_of(reading: Reading, declared: "re.Match[str]") -> WireMessage | None:
    """Return the message whose name a declared type bears, word by word."""
    plain = _OF_LIBRARY.sub("", declared["name"])
    return reading.messages.get(plain) or reading.messages.get(snake(plain).upper())


def types_around(reading: Reading, code: CodeBlock) -> Iterator[WireMessage | None]:
    """Yield for each line of code the message whose name the type around it bears, word by word; None for none."""
    around = None
    for line in code.lines:
        found = _declared(line.text)
        if found is not None:
            around = _message_of(reading, found)
        yield around
        if line.text.startswith("}"):
            around = None


def types_below(reading: Reading, code: CodeBlock) -> Mapping[int, tuple[int, WireMessage | None]]:
    """Return for each comment right above the declaration of a type, by lines: its first line, and the type's message.

    None stands for a type whose name is that of no message.
    """
    found: dict[int, tuple[int, WireMessage | None]] = {}
    comment: list[int] = []
    for line in code.lines:
        if _COMMENT.match(line.text):
            comment.append(line.place.line)
            continue
        if _ATTRIBUTE.match(line.text):
            continue
        declared = _declared(line.text) if comment else None
        if declared is not None:
            message = _message_of(reading, declared)
            found.update((at, (comment[0], message)) for at in comment)
        comment = []
    return found


_ATTRIBUTE = pattern(r"\s*(?:@\w|#\[|\[\w)")
"""A line between a comment and the type that it is about."""


def is_of_type(reading: Reading, place: Place, message: str) -> bool:
    """Return whether the type around a line bears the name of a message, in whatever way a language spells it."""
    name = _type_around(reading, place)
    return name is not None and is_named(name, message)


def is_of_other_type(reading: Reading, place: Place, message: str) -> bool:
    """Return whether the name of the type around a line has no word of a message."""
    name = _type_around(reading, place)
    own = message.lower().split("_")
    return name is not None and not any(word[:_ALIKE] == other[:_ALIKE] for word in _words(name) for other in own)


def is_beside_type(reading: Reading, place: Place, message: str) -> bool:
    """Return whether another type than the one around a line bears the name of a message."""
    name = _type_around(reading, place)
    if name is None or is_named(name, message):
        return False
    return any(is_named(other, message) for other in _types(reading))


def _type_around(reading: Reading, place: Place) -> str | None:
    """The name of the type that is declared around a line."""
    for code in _blocks_at(reading, place.line):
        lines, index = code.lines, place.line - code.place.line
        for line in reversed(lines[max(index - _UPPER, 0) : index + 1]):
            found = _declared(line.text)
            if found is not None and found["name"]:
                return found["name"]
            if line.place.line < place.line and _CLOSED.match(line.text):
                return None
            if "{" in line.text and "typedef" in line.text:
                break
        for line in lines[index : index + _UPPER]:
            found = _BEHIND.match(line.text)
            if found is not None:
                return found["name"]
    return None


_BEHIND = pattern(r"\s*\}\s*(?P<name>[A-Za-z_]\w*)\s*;")


@once
def _types(reading: Reading) -> tuple[str, ...]:
    """The names of all types that the code of a document declares."""
    found = (_declared(line.text) or _BEHIND.match(line.text) for code in reading.prose.code for line in code.lines)
    return tuple(each["name"] for each in found if each is not None and each["name"])


def _words(name: str) -> set[str]:
    return {part.lower() for part in _PARTS.findall(name)} - _AROUND


def _blocks_at(reading: Reading, line: int) -> Iterator[CodeBlock]:
    return (part for part in parts_at(reading, line) if isinstance(part, CodeBlock))


def is_named(name: str, message: str) -> bool:
    """Return whether the name of a type means a message, as "GpsRawInt" or "mavlink_gps_raw_int_t" do."""
    parts = [part.lower() for part in _PARTS.findall(name)]
    own = "".join(part for part in parts if part not in _AROUND)
    plain = message.replace("_", "").lower()
    return own == plain or "".join(parts) == plain


_MEMBER = pattern(
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
            and not _declared(lines[first].text)
            and not _CLOSED.match(lines[first - 1].text)
        ):
            first -= 1
        if not _declared(lines[first].text):
            return ()
        names = []
        for line in lines[first + 1 : first + 2 * _UPPER]:
            if _CLOSED.match(line.text):
                break
            found = _MEMBER.match(line.text)
            if found is not None:
                names.append((found["first"] or found["last"]).rstrip("_"))
        return tuple(names)
    return ()
