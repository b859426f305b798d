"""The spelling of a message's function in machine code, by MicroPython's viper emitter."""

import struct
from collections.abc import Iterable

from codegen.model.answers.answer import Elements
from codegen.model.answers.scaling import FloatParts
from codegen.model.code.payload_code import LONGEST_RUN, indented
from codegen.model.code.storage import is_small
from codegen.model.vehicle import Quantity
from codegen.targets.firmware.messages.payload import SpelledCode, byte_of, escaped, literal, real_about
from codegen.targets.firmware.messages.turns import Turns, placed
from codegen.targets.firmware.words import Block
from codegen.targets.imports import LINE_LENGTH, in_brackets

_POINTERS = {1: "wire", 2: "wire16", 4: "wire32"}
"""The pointers to the payload, by the size of what each of them writes."""


class MachineCode(SpelledCode):
    """Viper: pointers in place of objects. A link's buffer is of all messages, so each byte is written each time."""

    __slots__ = ()

    def subscript(self, component: str, place: str) -> str:
        """Return a word of the block, by a pointer to it."""
        return f"{component}[{place}]"

    def number_of(self, word: str) -> str:
        """64-bit interpreters do not extend the sign of a word that they read."""
        self.uses.add("sign")
        return f"({word} ^ sign) - sign"

    def unknown(self) -> str:
        """A word as it is read, without its sign extended: most of those that are looked at are known."""
        self.uses.add("unknown")
        return "unknown"

    def put(
        self, offset: int, size: int, value: int | str, *, always: bool = True, turns: Turns | None = None
    ) -> list[str]:
        """Put a number in one piece if its place is a multiple of the size; the smaller Cortex-M insist on that.

        A 0 that is known at build time is left to what is cleared, which is fewer and larger pieces.
        """
        if turns is not None:
            starts = range(offset, offset + turns.size * turns.count, turns.size)
            self.written |= {at for start in starts for at in range(start, start + size)}
        elif value == 0 and (always or offset % size) and self.written.isdisjoint(range(offset, offset + size)):
            return []
        elif always:
            self.written |= set(range(offset, offset + size))
        is_aligned = offset % size == 0 and (turns is None or turns.size % size == 0)
        if is_aligned and size in _POINTERS:
            self.uses.add(_POINTERS[size])
            return [f"{_POINTERS[size]}[{placed(offset, size, turns)}] = {value}"]
        return self._by_bytes(offset, size, value, turns)

    def got(self, offset: int, size: int) -> str:
        """Two bytes in one piece, where they begin at an even place."""
        if size == 2 and offset % 2 == 0:
            self.uses.add("wire16")
            return f"wire16[{offset // 2}]"
        self.uses.add("wire")
        return SpelledCode.got(self, offset, size)

    def store_two(self, covers: Elements, place: str, value: str) -> list[str]:
        """Store a number of two bytes in one piece, where the field begins at an even place."""
        start = covers.offset
        self.written |= self.bytes_of(covers)
        if start % 2 == 0:
            self.uses.add("wire16")
            return [f"wire16[{start // 2} + {place}] = {value}" if start else f"wire16[{place}] = {value}"]
        self.uses.add("wire")
        return [f"wire[{start} + 2 * {place}] = {value}", f"wire[{start + 1} + 2 * {place}] = {value} >> 8"]

    def flags(self, covers: Elements, mask: int, conditional: list[tuple[int, Quantity]]) -> list[str]:
        """Put flags in one number, or where small integers do not carry it in numbers of 16 bits."""
        bits = 8 * covers.field.type.size
        every = mask
        for value, _ in conditional:
            every |= value
        width = bits if bits < 32 or is_small(every) else 16
        lines: list[str] = []
        for shift in range(0, bits, width):
            part = (1 << width) - 1
            terms = [(value >> shift & part, quantity) for value, quantity in conditional if value >> shift & part]
            lines += self._part(covers, shift, width, mask >> shift & part, terms)
        return lines

    def _part(
        self, covers: Elements, shift: int, width: int, mask: int, terms: list[tuple[int, Quantity]]
    ) -> list[str]:
        lines = [f"flags = {mask:#x}" if mask else "flags = 0"] if terms else []
        read = ""
        for value, quantity in terms:
            source, condition = self.condition(quantity)
            if source and source != read:
                lines.append(f"value = {source}")
                read = source
            lines += [f"if {condition}:", f"    flags |= {value:#x}"]
        written = "flags" if terms else mask
        for at in range(covers.count):
            offset = covers.offset + at * covers.field.type.size + shift // 8
            lines += self.put(offset, width // 8, written)
        return lines

    def _by_bytes(self, offset: int, size: int, value: int | str, turns: Turns | None) -> list[str]:
        if size == 8:
            low = self.put(offset, 4, value if isinstance(value, str) else _signed(value, 4), always=False, turns=turns)
            if not isinstance(value, str):
                return [*low, *self.put(offset + 4, 4, -1 if value < 0 else 0, always=False, turns=turns)]
            high = self.put(offset + 4, 4, -1, always=False, turns=turns)
            none = self.put(offset + 4, 4, 0, always=False, turns=turns) or self._by_bytes(offset + 4, 4, 0, turns)
            return [*low, f"if {value} < 0:", *indented(high), "else:", *indented(none)]
        known = literal(value)
        shown = value if str(value).isidentifier() else f"({value})"
        if size == 4 and offset % 2 == 0 and (turns is None or turns.size % 2 == 0):
            self.uses.add("wire16")
            halves = [placed(at, 2, turns) for at in (offset, offset + 2)]
            if known is not None:
                return [f"wire16[{half}] = {known >> 16 * n & 0xFFFF}" for n, half in enumerate(halves)]
            return [f"wire16[{halves[0]}] = {value}", f"wire16[{halves[1]}] = {shown} >> 16"]
        self.uses.add("wire")
        places = [placed(offset + n, 1, turns) for n in range(size)]
        if known is not None:
            return [f"wire[{place}] = {known >> 8 * n & 0xFF}" for n, place in enumerate(places)]
        return [f"wire[{place}] = {f'{shown} >> {8 * n}' if n else value}" for n, place in enumerate(places)]

    def store_at(self, covers: Elements, place: str, value: str) -> list[str]:
        """Store a number by a pointer of the type; into fields that are not aligned byte by byte."""
        start, size = covers.field.offset, covers.field.type.size
        self.written |= self.bytes_of(covers)
        if start % size == 0 and size in (1, 2, 4):
            name = {1: "wire", 2: "wire16", 4: "wire32"}[size]
            self.uses.add(name)
            return [f"{name}[{start // size} + {place}] = {value}" if start else f"{name}[{place}] = {value}"]
        self.uses.add("wire")
        lines = [f"at = {start} + {size} * {place}"]
        return [*lines, *(f"wire[at{f' + {n}' if n else ''}] = {byte_of(value, n)}" for n in range(size))]

    def fill(self, covers: Elements, value: int | float, first: int = 0) -> list[str]:
        """Write two elements of 16 bits in one piece, where both are alike in that: it takes half as long."""
        if covers.field.type.size != 2 or covers.count - first > LONGEST_RUN or value not in {0xFFFF, -1}:
            return super().fill(covers, value, first)
        at, lines = first, []
        while at < covers.count:
            is_pair = at + 1 < covers.count and (covers.offset + 2 * at) % 4 == 0
            lines += self.put(covers.offset + 2 * at, 4, -1) if is_pair else self.store(covers, value, at)
            at += 2 if is_pair else 1
        return lines

    def rest(self, covers: Elements, value: int) -> list[str]:
        """Zeros are what is cleared."""
        if value == 0:
            self.written -= self.bytes_of(covers)
            return []
        return super().rest(covers, value)

    def put_float(
        self, covers: Elements, value: str, divisor: int, unknown: float | None, element: str = ""
    ) -> list[str]:
        """Put a whole number at first: one call makes floats of all of them at the end, since calls are dear.

        A float that is not aligned, or one beside an ``unknown`` that reads as such a number, is made on the side.
        """
        bits = 0 if unknown is None else struct.unpack("<i", struct.pack("<f", unknown))[0]
        if covers.offset % 4 or 0 < abs(bits) < 1 << 30 or bits == -1 << 31:
            self._use_side()
            made = ["side = ptr32(_FLOAT)", f"side[0] = {value}", *self._floats("int(side)", [(0, divisor)])]
            return [*made, *self._copied_from_side(covers, element)]
        turns = self.turns(covers, element)
        self.floats += [(covers.offset + 4 * at, divisor) for at in range(turns.count if turns else 1)]
        return self.put(covers.offset, 4, value, turns=turns)

    def ending(self) -> list[str]:
        """Floats of the whole numbers."""
        if not self.floats:
            return []
        shown = ", ".join(f"that at {at} / {divisor}" for at, divisor in self.floats)
        return ["", f"# As floats, each whole number divided: {shown}.", *self._floats("int(wire)", self.floats)]

    def _floats(self, at: str, floats: list[tuple[int, int]]) -> list[str]:
        self.uses.add("put_float")
        data = struct.pack(f"<{len(floats) + 1}I", *(offset // 4 | divisor << 6 for offset, divisor in floats), 0)
        literal = "".join(map(escaped, data))
        lines = in_brackets("    put_floats", f'{at}, b"{literal}"', "").removeprefix("    ").split("\n    ")
        if len(literal) < LINE_LENGTH - 24:
            return lines
        pieces = [f'    b"{"".join(map(escaped, data[start : start + 16]))}"' for start in range(0, len(data), 16)]
        return ["put_floats(", f"    {at},", *pieces[:-1], f"{pieces[-1]},", ")"]

    def _use_side(self) -> None:
        self.texts["_FLOAT"] = "bytearray(8)"

    def _copied_from_side(self, covers: Elements, element: str = "") -> list[str]:
        self.written |= self.bytes_of(covers)
        turns, size = self.turns(covers, element), covers.field.type.size
        if turns is None:
            return self.copied(covers, "_FLOAT", size)
        self.uses.add("wire")
        places = (placed(covers.offset + n, 1, turns) for n in range(size))
        return ["text = ptr8(_FLOAT)", *(f"wire[{place}] = text[{n}]" for n, place in enumerate(places))]

    def put_real(self, covers: Elements, factor: FloatParts, element: str = "") -> list[str]:
        """Put a float by the function for it, byte by byte."""
        self.uses.add("put_real")
        self.written |= self.bytes_of(covers)
        place = placed(covers.offset, 1, self.turns(covers, element))
        at = f"int(wire) + {place}" if place != "0" else "int(wire)"
        data = struct.pack("<IIH2B", *real_about(covers, factor))
        return [f'put_real({at}, value, b"{"".join(map(escaped, data))}")']

    def now(self) -> str:
        """Asked for where it is needed."""
        self.uses.add("clock")
        return "int(ticks_ms())"

    def head(self, about: tuple[str, ...]) -> tuple[str, str]:
        """The same function makes frames and payloads: what builds a message stands in for the link."""
        return f"def {self._name(about)}", ", ".join(("link", "state", *(f"{value}: int" for value in about)))

    def call(self, about: tuple[str, ...]) -> tuple[str, str]:
        """Return the call with the message in place of a link."""
        return f"    {self._name(about)}", ", ".join(("_stand_in(message)", "state", *about))

    def _name(self, about: tuple[str, ...]) -> str:
        return f"{self.message}_frame" if about else f"encode_{self.message}"

    def tick(self, clock: Block) -> str:
        """Return the call that ticks a clock, by the address of its block."""
        return f"tick(int(words) + 4 * {clock.base_constant})"

    def reach(self, component: str, instance: str) -> str:
        """A pointer."""
        base = self._base(component, instance)
        return (
            f"{component} = ptr32(int(words) + 4 * ({base}))"
            if instance
            else f"{component} = ptr32(int(words) + 4 * {base})"
        )

    def sources(self) -> list[str]:
        """The words of the state and the parameters."""
        words = ["words = ptr32(int(state.words_at))"] if self.words else []
        return words + [f"{name} = int(state.parameters.{name})" for name in self.parameters]

    def pointers(self) -> list[str]:
        """Return the lines of the pointers to the payload as larger numbers, of the sign's bit and an unknown word."""
        lines = [f"wire{bits} = ptr{bits}(wire)" for bits in (16, 32) if f"wire{bits}" in self.uses]
        if self.uses & {"sign", "unknown"}:
            lines.append("bit = 1")
        if "sign" in self.uses:
            lines.append("sign = bit << 31")
        if "unknown" in self.uses:
            lines.append(f"unknown = {'sign' if 'sign' in self.uses else 'bit << 31'} | bit << 30")
        return lines

    def copied(self, covers: Elements, source: str, length: int) -> list[str]:
        """Return the lines that copy a text, by a pointer to the constant."""
        self.uses.add("wire")
        at = f"{covers.offset} + place" if covers.offset else "place"
        return [
            f"text = ptr8({source})",
            "place = 0",
            f"while place < {length}:",
            f"    wire[{at}] = text[place]",
            "    place += 1",
        ]

    def cleared(self, length: int) -> list[str]:
        """Word by word, the last one whole: the end of the payload is looked for by words."""
        words = sorted({at // 4 for at in set(range(-(-length // 4) * 4)) - self.written})
        if not words:
            return []
        self.uses.add("wire32")
        lines = ["# What nothing below writes is 0."]
        for first, last in _runs(words):
            if last - first < 8:
                lines += [f"wire32[{at}] = 0" for at in range(first, last + 1)]
            else:
                lines += [f"place = {first}", f"while place < {last + 1}:", "    wire32[place] = 0", "    place += 1"]
        return lines


def _signed(value: int, size: int) -> int:
    """The number of so many bytes with the same low bits."""
    return struct.unpack("<i", struct.pack("<I", value & 0xFFFFFFFF))[0] if size == 4 else value


def _runs(numbers: Iterable[int]) -> list[tuple[int, int]]:
    """Numbers that follow one another, as first and last."""
    runs: list[tuple[int, int]] = []
    for number in numbers:
        if runs and runs[-1][1] == number - 1:
            runs[-1] = (runs[-1][0], number)
        else:
            runs.append((number, number))
    return runs
