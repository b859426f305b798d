"""Numbers that a function in machine code puts into a payload: in the largest pieces that the Cortex-M takes."""

import re
import struct
from types import SimpleNamespace
from typing import Any

import pytest

from codegen.model.dialect.dialect import Kind
from codegen.targets.firmware.messages.payload_machine import MachineCode
from codegen.targets.firmware.messages.turns import Turns


def code(layout: Any = None, message: str = "one") -> MachineCode:
    return MachineCode(layout, message)


def put(lines: list[str], **names: int) -> bytes:
    """The payload after the lines, run over bytes that were something else before."""
    wire = bytearray(b"\xaa" * 64)
    pointers = {"wire": wire, "wire16": memoryview(wire).cast("H"), "wire32": memoryview(wire).cast("I")}
    stored = r"(wire(\d*)\[.*\]) = (.*)"
    masked = [re.sub(stored, r"\1 = (\3) & ((1 << (int('0\2') or 8)) - 1)", line) for line in lines]
    exec("\n".join(masked), {**pointers, **names})  # noqa: S102
    return bytes(wire)


@pytest.mark.parametrize("size", [1, 2, 4, 8])
@pytest.mark.parametrize("offset", [0, 1, 2, 3, 4, 8])
@pytest.mark.parametrize("value", [1, 0x1234, -1, -2])
@pytest.mark.parametrize("is_named", [True, False])
def test_a_number_stands_in_its_bytes_and_in_no_others(offset: int, size: int, value: int, is_named: bool) -> None:
    """Known at build time or not, with all its sign; every pointer that the lines need is asked for."""
    if value == 0x1234 and size == 1:
        value = 0x12
    own = code()
    lines = own.put(offset, size, "value" if is_named else value)
    wire = put(lines, value=value)
    expected = struct.pack("<q", value)[:size]
    assert wire == b"\xaa" * offset + expected + b"\xaa" * (64 - offset - size)
    assert own.uses == {line.strip().partition("[")[0] for line in lines if "wire" in line}
    assert own.written == set(range(offset, offset + size))


@pytest.mark.parametrize(
    ("offset", "size", "pieces"), [(4, 4, 1), (2, 4, 2), (3, 4, 4), (2, 2, 1), (3, 2, 2), (0, 1, 1)]
)
def test_it_is_in_the_largest_pieces_of_which_its_place_is_a_multiple(offset: int, size: int, pieces: int) -> None:
    assert len(code().put(offset, size, "value")) == pieces


def test_a_zero_is_left_to_what_is_cleared_but_over_other_bytes() -> None:
    """Where something was written before, the zero is, too; what is not always written clears itself in one piece."""
    own = code()
    assert own.put(4, 4, 0) == []
    assert own.put(3, 2, 0, always=False) == []
    assert own.put(4, 2, 0, always=False) == ["wire16[2] = 0"]
    assert own.put(7, 1, 5) == ["wire[7] = 5"]
    assert own.put(4, 4, 0) == ["wire32[1] = 0"]
    assert own.put(2, 2, 0) == []
    assert own.put(8, 2, 0) == []


def test_two_bytes_are_read_in_one_piece_at_an_even_place() -> None:
    even, odd, four = code(), code(), code()
    assert (even.got(6, 2), even.uses) == ("wire16[3]", {"wire16"})
    assert odd.got(7, 2) != "wire16[3]"
    assert odd.uses == {"wire"}
    four.got(4, 4)
    assert four.uses == {"wire"}


def test_the_constant_of_a_text_has_a_name_that_no_place_has() -> None:
    """The names of places come from the state: one may be that of the message with its field."""
    covers: Any = SimpleNamespace(field=SimpleNamespace(name="text"))
    block = SimpleNamespace(
        base_constant="_BASE",
        size_constant="_ONE_TEXT_",
        offsets=("text", "text__"),
        constant=lambda name: f"_ONE_{name}".upper(),
    )
    layout = SimpleNamespace(blocks={"one": block})
    assert code(layout)._text_constant(covers) == "_ONE_TEXT___"
    assert code(SimpleNamespace(blocks={}))._text_constant(covers) == "_ONE_TEXT"
    assert code(layout, "two")._text_constant(covers) == "_TWO_TEXT"


@pytest.mark.parametrize(
    ("offset", "size", "apart", "line", "written"),
    [
        (4, 2, 2, "wire16[2 + at] = value", {4, 5, 6, 7, 8, 9}),
        (4, 2, 4, "wire16[2 + 2 * at] = value", {4, 5, 8, 9, 12, 13}),
        (0, 4, 4, "wire32[at] = value", set(range(12))),
        (3, 1, 3, "wire[3 + 3 * at] = value", {3, 6, 9}),
    ],
)
def test_a_loop_writes_each_element_at_its_place(
    offset: int, size: int, apart: int, line: str, written: set[int]
) -> None:
    """In one piece where the first one and the steps allow it; what is written is known to be."""
    own = code()
    assert own.put(offset, size, "value", turns=Turns("at", apart, 3)) == [line]
    assert own.written == written
    halves = ["wire16[2 + 3 * at] = value", "wire16[3 + 3 * at] = value >> 16"]
    assert code().put(4, 4, "value", turns=Turns("at", 6, 3)) == halves
    assert len(code().put(2, 4, "value", turns=Turns("at", 4, 3))) == 2
    assert len(code().put(4, 4, "value", turns=Turns("at", 5, 3))) == 4


def test_a_word_that_can_be_negative_keeps_its_sign() -> None:
    """Also where an interpreter of 64 bits reads 32 without it."""
    own = code()
    text = own.number_of("word")
    assert own.uses == {"sign"}
    for value in (-(1 << 30), -1, 0, 1, (1 << 30) - 1):
        assert eval(text, {"word": value & 0xFFFFFFFF, "sign": 1 << 31}) == value  # noqa: S307


@pytest.mark.parametrize("bits", [32, 64])
@pytest.mark.parametrize("reads_signs", [True, False])
def test_an_unknown_word_is_found_as_it_is_read(bits: int, reads_signs: bool) -> None:
    """On a board, where a word has its sign, and on a host, where 32 bits are read without it."""

    def kept(number: int) -> int:
        """What a register of so many bits holds."""
        return ((number & (1 << bits) - 1) ^ 1 << bits - 1) - (1 << bits - 1)

    own = code()
    if reads_signs:
        own.number_of("word")
    condition = f"word == {own.unknown()}"
    names: dict[str, int] = {}
    for line in own.pointers():
        name, _, value = line.partition(" = ")
        names[name] = kept(eval(value, names.copy()))  # noqa: S307
    for number in (-(1 << 30), 0, 1, -1, (1 << 30) - 1, -(1 << 30) + 1):
        word = kept(number & 0xFFFFFFFF)
        assert eval(condition, {**names, "word": word}) == (number == -(1 << 30))  # noqa: S307


@pytest.mark.parametrize("offset", [0, 2, 4, 10, 11])
@pytest.mark.parametrize("count", [1, 2, 3, 10])
@pytest.mark.parametrize(("value", "first"), [(0xFFFF, 0), (0xFFFF, 1), (-1, 0), (-1, 1), (7, 0)])
def test_elements_that_are_alike_are_written_two_at_once(offset: int, count: int, value: int, first: int) -> None:
    """Where both stand in one aligned word: each gets its bytes, nothing beside them is written."""
    wire_type = SimpleNamespace(size=2, kind=Kind.UNSIGNED)
    covers: Any = SimpleNamespace(field=SimpleNamespace(type=wire_type), offset=offset, count=count, first=0)
    own = code()
    lines = own.fill(covers, value, first)
    written = put(lines)
    start, end = offset + 2 * first, offset + 2 * count
    assert written == b"\xaa" * start + struct.pack("<H", value & 0xFFFF) * (count - first) + b"\xaa" * (64 - end)
    assert own.written == set(range(start, end))
    pairs = (end // 4 * 4 - -(-start // 4) * 4) // 4 if value != 7 and offset % 2 == 0 else 0
    assert sum("wire32" in line for line in lines) == max(pairs, 0)
