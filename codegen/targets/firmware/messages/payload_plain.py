"""The spelling of a message's function in plain Python, for ports without machine code."""

from codegen.model.answers.answer import Elements
from codegen.model.answers.scaling import FloatParts
from codegen.model.code.payload_code import indented
from codegen.model.vehicle import Quantity
from codegen.targets.firmware.messages.payload import SpelledCode, byte_of, real_about
from codegen.targets.firmware.messages.turns import Turns, placed
from codegen.targets.firmware.words import Block


class PlainCode(SpelledCode):
    """Plain Python: bytes, and numbers that are positive where they are written. Nothing else writes the payload.

    So what is always 0 stays so. Locals are few: MicroPython puts those of larger functions on the heap at every call.
    """

    __slots__ = ()

    def subscript(self, component: str, place: str) -> str:
        """Counted from where the block begins: of several instances a variable, or else a constant."""
        block = self.layout.blocks[component]
        return f"words[{component if block.component.instances > 1 else block.base_constant} + {place}]"

    def number_of(self, word: str) -> str:
        """An array knows signs."""
        return word

    def put(
        self, offset: int, size: int, value: int | str, *, always: bool = True, turns: Turns | None = None
    ) -> list[str]:
        """Byte by byte."""
        if always and turns is None:
            self.written |= set(range(offset, offset + size))
        places = [placed(offset + n, 1, turns) for n in range(size)]
        if isinstance(value, int):
            return [f"wire[{place}] = {value >> 8 * n & 0xFF}" for n, place in enumerate(places)]
        return [f"wire[{place}] = {byte_of(value, n)}" for n, place in enumerate(places)]

    def store_at(self, covers: Elements, place: str, value: str) -> list[str]:
        """Byte by byte, too."""
        start, size = covers.field.offset, covers.field.type.size
        if size == 1:
            return [f"wire[{start} + {place}] = {byte_of(value, 0)}"]
        at = f"{size} * {place}"
        return [f"wire[{at}{f' + {start + n}' if start + n else ''}] = {byte_of(value, n)}" for n in range(size)]

    def store_two(self, covers: Elements, place: str, value: str) -> list[str]:
        """Byte by byte."""
        at = [f"2 * {place}" if not start else f"{start} + 2 * {place}" for start in (covers.offset, covers.offset + 1)]
        return [f"wire[{at[0]}] = {byte_of(value, 0)}", f"wire[{at[1]}] = {byte_of(value, 1)}"]

    def flags(self, covers: Elements, mask: int, conditional: list[tuple[int, Quantity]]) -> list[str]:
        """Bit by bit in the payload itself."""
        lines, read = self.fill(covers, mask), ""
        for bits, quantity in conditional:
            source, condition = self.condition(quantity)
            if source and source != read:
                lines.append(f"value = {source}")
                read = source
            lines += [f"if {condition}:", *indented(self._set(covers, bits))]
        return lines

    def _set(self, covers: Elements, bits: int) -> list[str]:
        size = covers.field.type.size
        places = [
            (covers.offset + at * size + n, bits >> 8 * n & 0xFF) for at in range(covers.count) for n in range(size)
        ]
        return [f"wire[{place}] |= {part:#x}" for place, part in places if part]

    def put_float(
        self,
        covers: Elements,
        value: str,
        divisor: int,
        unknown: float | None,  # noqa: ARG002
        element: str = "",
    ) -> list[str]:
        """Put a float by the function for it."""
        self.uses.add("put_float")
        return [f"put_float(wire, {placed(covers.offset, 1, self.turns(covers, element))}, {value}, {divisor})"]

    def put_real(self, covers: Elements, factor: FloatParts, element: str = "") -> list[str]:
        """Put a float by the function for it."""
        self.uses.add("put_real")
        place = placed(covers.offset, 1, self.turns(covers, element))
        return [f"put_real(wire, {place}, value, {real_about(covers, factor)})"]

    def now(self) -> str:
        """Return what ``value`` is at first."""
        return "value"

    def head(self, about: tuple[str, ...]) -> tuple[str, str]:
        """The payload and the words; what is found in ``place`` is a variable for loops."""
        return f"def write_{self.message}", ", ".join(("value", "place", "wire", "words", *about, *self.parameters))

    def call(self, about: tuple[str, ...]) -> tuple[str, str]:
        """Return the call with the time, and with the parameters that the message reads."""
        parameters = (f"state.parameters.{name}" for name in self.parameters)
        given = ("time.ticks_ms()", "0", "message.wire", "state.words", *about, *parameters)
        return f"    write_{self.message}", ", ".join(given)

    def finished(self) -> list[str]:
        """The payload."""
        return ["", "return wire"]

    def tick(self, clock: Block) -> str:
        """Return the call that ticks a clock, by the place of its block."""
        return f"tick(words, {clock.base_constant})"

    def reach(self, component: str, instance: str) -> str:
        """A number; none where the component is the only one."""
        several = self.layout.blocks[component].component.instances > 1
        return f"{component} = {self._base(component, instance)}" if several else ""

    def copied(self, covers: Elements, source: str, length: int) -> list[str]:
        """Return the lines that copy a text by index: a slice would be made on the heap."""
        at = f"{covers.offset} + place" if covers.offset else "place"
        return ["place = 0", f"while place < {length}:", f"    wire[{at}] = {source}[place]", "    place += 1"]


class PlainReading(PlainCode):
    """Plain Python, in functions that are given the words of one instance."""

    __slots__ = ()

    def subscript(self, component: str, place: str) -> str:
        """The words are those of the component."""
        return f"{component}[{place}]"
