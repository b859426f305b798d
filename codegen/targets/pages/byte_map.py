"""The byte map of a frame: drawings of at most eight bytes each, which flow into as many lines as a window needs.

Coordinates are in the units of a drawing, which are CSS pixels: it is not scaled, so that its text stays readable.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence

from codegen.frozen import dataclass
from codegen.model.dialect.dialect import EnumDefinition, WireField
from codegen.model.system import PopulatedMessage, System
from codegen.targets.pages.example_state import ExampleState
from codegen.targets.pages.frame import SIGNATURE, Part, SentFrame, packed, sent_frame
from codegen.targets.pages.value_text import elements_of, is_unknown, kind_of, type_code, value_text
from codegen.targets.suite.expected import expected_fields

CELL = 30
"""Width of a byte."""
BLOCK = 8
"""Bytes of a payload in one drawing."""
_HEIGHT, _HEIGHT_OF_PARTS = 78, 56
_HEX = 48
"""The height of a byte's text, which is higher where a letter stands under it."""
_LETTER = 6.6
"""Width of a letter of a name, at most; of the word for extensions in all."""
_EXTENSIONS = 64


@dataclass(frozen=True, slots=True)
class Word:
    """A text of a drawing, centred at ``x``."""

    x: float
    text: str


@dataclass(frozen=True, slots=True)
class Piece:
    """An element, or what of it lies in one drawing. ``style`` has the classes of its cell, ``title`` tells of it."""

    x: float
    width: float
    style: str
    is_unknown: bool
    title: str
    bytes: tuple[Word, ...]
    letters: tuple[Word, ...]
    hex_y: int
    offset: str


@dataclass(frozen=True, slots=True)
class Label:
    """The name of a field over its bytes, or its number in the table where that has no room; ``type`` stands below."""

    middle: float
    text: str
    type: str
    type_x: float


@dataclass(frozen=True, slots=True)
class Cut:
    """The bytes of a drawing that are not sent."""

    x: float
    width: float


@dataclass(frozen=True, slots=True)
class Boundary:
    """The boundary at which the extensions begin, with the place of the word for it."""

    x: float
    word_x: float
    anchor: str


@dataclass(frozen=True, slots=True)
class Block:
    """One drawing."""

    caption: str
    caption_x: float
    caption_anchor: str
    width: float
    height: int
    style: str
    labels: tuple[Label, ...]
    pieces: tuple[Piece, ...]
    cut: Cut | None
    boundary: Boundary | None


@dataclass(frozen=True, slots=True)
class ByteMap:
    """A frame in one state: its header, its payload and what follows each begin a line.

    ``facts`` are sentences on its length, ``frame`` its bytes in hex.
    """

    id: str
    state: str
    summary: str
    facts: tuple[str, ...]
    lines: tuple[tuple[Block, ...], ...]
    frame: str


@dataclass(frozen=True, slots=True)
class _Element:
    """An element of the payload; ``number`` is its field's in the table."""

    field: WireField
    number: int
    start: int
    data: bytes
    style: str
    is_unknown: bool
    type: str
    title: str
    is_text: bool


def byte_map(
    message: PopulatedMessage, state: ExampleState, numbers: Mapping[tuple[str, int], int], system: System, name: str
) -> ByteMap:
    """The map of ``message`` in a state; ``numbers`` has the row of the table for each field and element."""
    values = expected_fields(message, state.known)
    frame = sent_frame(message, values, system)
    elements = [
        element
        for field in message.wire.fields
        if field.offset < len(frame.payload)
        for element in _elements(field, values[field.name], numbers, system.dialect.enums)
    ]
    boundary = message.wire.base_length if message.wire.base_length < len(frame.payload) else None
    trailer = [_parts("checksum", (frame.checksum,), "frame")]
    if system.spec.project.protocol == 2:
        trailer += _signature()
    return ByteMap(
        id=name,
        state=state.label,
        summary=f"{message.name}, {state.label}: {frame.sent} of {len(frame.payload)} bytes of payload are sent",
        facts=_facts(message, frame, system),
        lines=(tuple(_header(frame)), tuple(_payload(elements, frame, boundary)), tuple(trailer)),
        frame=frame.data.hex(" "),
    )


def _facts(message: PopulatedMessage, frame: SentFrame, system: System) -> tuple[str, ...]:
    whole, size = len(frame.payload), len(frame.data)
    if system.spec.project.protocol == 1:
        extensions = message.wire.length - whole
        left = f"; the {_count(extensions)} of extensions are not sent" if extensions else ""
        return (f"Payload {_count(whole)}, which MAVLink 1 never cuts{left}.", f"Frame {_count(size)}.")
    cut = whole - frame.sent
    dropped = f"the last {_count(cut)} {'are' if cut > 1 else 'is'} zero and not sent" if cut else "all are sent"
    return (
        f"Payload {_count(whole)}; {dropped}.",
        f"Frame {_count(size)}, {_count(size + sum(size for _, size in SIGNATURE))} with a signature.",
    )


def _count(number: int) -> str:
    return f"{number} byte{'' if number == 1 else 's'}"


def _elements(
    field: WireField,
    value: int | float | str | list[int | float],
    numbers: Mapping[tuple[str, int], int],
    enums: Mapping[str, EnumDefinition],
) -> Iterator[_Element]:
    values = elements_of(value)
    is_text = isinstance(values[0], str)
    size = field.size if is_text else field.type.size
    data = packed(field, value)
    style, code = kind_of(field, enums), type_code(field, enums)
    for index, one in enumerate(values):
        start = index * size
        unknown = is_unknown(field, index, value)
        label = f"{field.name}[{index}]" if field.is_array and not is_text else field.name
        first, last = field.offset + start, field.offset + start + size - 1
        where = f"byte {first}" if first == last else f"bytes {first} to {last}"
        said = value_text(field, one, enums)
        meaning = f"unknown, as {said}" if unknown else said
        shown = f" {data[start : start + size].hex(' ')}" if size <= BLOCK else ""
        yield _Element(
            field=field,
            number=numbers[field.name, 0 if is_text else index],
            start=first,
            data=data[start : start + size],
            style=style,
            is_unknown=unknown,
            type=code,
            title=f"{label}, {field.type.name}, {where}:{shown} = {meaning}",
            is_text=is_text,
        )


def _payload(elements: Sequence[_Element], frame: SentFrame, boundary: int | None) -> Iterator[Block]:
    length = len(frame.payload)
    for start in range(0, length, BLOCK):
        end = min(start + BLOCK, length)
        inside = [element for element in elements if element.start < end and element.start + len(element.data) > start]
        cut = max(start, frame.sent)
        mark = _boundary(boundary - start) if boundary is not None and start <= boundary < end else None
        is_right = mark is not None and mark.x < 2 * CELL
        yield Block(
            caption=f"{start} to {end - 1}" if end - start > 1 else str(start),
            caption_x=(end - start) * CELL if is_right else 1,
            caption_anchor="end" if is_right else "start",
            width=(end - start) * CELL + 2,
            height=_HEIGHT,
            style="payload",
            labels=tuple(_labels(inside, start, end)),
            pieces=tuple(_piece(element, start, end) for element in inside),
            cut=Cut((cut - start) * CELL + 1, (end - cut) * CELL) if cut < end else None,
            boundary=mark,
        )


def _boundary(byte: int) -> Boundary:
    x = byte * CELL + 1
    has_room = x + _EXTENSIONS < BLOCK * CELL
    return Boundary(x, x + 4 if has_room else x - 4, "start" if has_room else "end")


def _piece(element: _Element, start: int, end: int) -> Piece:
    first, last = max(element.start, start), min(element.start + len(element.data), end)
    data = element.data[first - element.start : last - element.start]
    letters = [
        Word(_centre(first - start + index), chr(byte))
        for index, byte in enumerate(data)
        if element.is_text and 32 < byte < 127
    ]
    return Piece(
        x=(first - start) * CELL + 1,
        width=len(data) * CELL,
        style=element.style,
        is_unknown=element.is_unknown,
        title=element.title,
        bytes=tuple(Word(_centre(first - start + index), f"{byte:02x}") for index, byte in enumerate(data)),
        letters=tuple(letters),
        hex_y=_HEX if not letters else _HEX - 5,
        offset=str(first),
    )


def _labels(elements: Iterable[_Element], start: int, end: int) -> Iterator[Label]:
    """One label over all elements of a field that have one row in the table."""
    runs: dict[int, list[_Element]] = {}
    for element in elements:
        runs.setdefault(element.number, []).append(element)
    for number, run in runs.items():
        first = max(run[0].start, start)
        last = min(run[-1].start + len(run[-1].data), end)
        width = (last - first) * CELL
        name = run[0].field.name
        text = name if len(name) * _LETTER <= width - 4 else str(number)
        x = (first - start) * CELL + 1
        yield Label(x + width / 2, text, run[0].type, x + 2)


def _centre(byte: int) -> float:
    return byte * CELL + CELL / 2 + 1


def _header(frame: SentFrame) -> Iterator[Block]:
    *first, number = frame.header
    yield _parts("header", first, "frame")
    yield _parts("message id", [number], "frame")


def _signature() -> list[Block]:
    parts = [Part(name, bytes(size), "only in a signed frame") for name, size in SIGNATURE]
    return [_parts("if signed", parts[:2], "signed-frame"), _parts("if signed", parts[2:], "signed-frame")]


def _parts(caption: str, parts: Sequence[Part], style: str) -> Block:
    """The drawing of a header's or trailer's fields."""
    labels, pieces = [], []
    at = 0
    is_shown = style != "signed-frame"
    for part in parts:
        size = len(part.data)
        x, width = at * CELL + 1, size * CELL
        labels.append(Label(x + width / 2, part.name, "", 0))
        shown = [f"{byte:02x}" if is_shown else "" for byte in part.data]
        pieces.append(
            Piece(
                x=x,
                width=width,
                style="frame",
                is_unknown=False,
                title=f"{part.name}, {_count(size)}: {part.meaning}",
                bytes=tuple(Word(_centre(at + index), word) for index, word in enumerate(shown) if word),
                letters=(),
                hex_y=_HEX,
                offset="",
            )
        )
        at += size
    return Block(caption, 1, "start", at * CELL + 2, _HEIGHT_OF_PARTS, style, tuple(labels), tuple(pieces), None, None)
