"""The common part of both spellings of a message's function: in machine code, and in plain Python."""

import struct
from dataclasses import dataclass, field

from codegen.model.answers.answer import Elements
from codegen.model.answers.scaling import FloatParts
from codegen.model.code.clock import CLOCK
from codegen.model.code.letters import words_of
from codegen.model.code.payload_code import UNKNOWN, PayloadCode, indented
from codegen.model.code.storage import SMALL_INT_MAX
from codegen.model.dialect.dialect import Kind
from codegen.model.vehicle import Parameter, Quantity
from codegen.targets.firmware.messages.turns import Turns
from codegen.targets.firmware.words import Block, Layout, differ
from codegen.targets.naming import parameter_attribute


@dataclass(slots=True)
class SpelledCode(PayloadCode):
    """The common base of both spellings; it notes the needs of a function while that is spelled."""

    layout: Layout
    message: str
    uses: set[str] = field(default_factory=set)
    words: dict[str, set[str]] = field(default_factory=dict)
    parameters: dict[str, Parameter] = field(default_factory=dict)
    texts: dict[str, str] = field(default_factory=dict)
    written: set[int] = field(default_factory=set)
    floats: list[tuple[int, int]] = field(default_factory=list)

    def word(self, component: str, name: str, element: str = "") -> str:
        """A word of a component, as it stands in the array."""
        self.words.setdefault(component, set()).add(name)
        constant = self.layout.blocks[component].constant(name)
        return self.subscript(component, f"{constant} + {element}" if element else constant)

    def subscript(self, component: str, place: str) -> str:
        """The word at a place of the component's block."""
        raise NotImplementedError

    def number_of(self, word: str) -> str:
        """A word that can be negative."""
        raise NotImplementedError

    def read(self, quantity: Quantity, element: str = "") -> str:
        """The word, with its sign."""
        return self.number_of(self.word(quantity.component, quantity.attribute, element))

    def is_unknown(self, quantity: Quantity, element: str = "") -> str:
        """Return the condition that a quantity is unknown, by its first word."""
        word = self.word(quantity.component, quantity.attribute, _first(quantity, element))
        return f"{word} == {self.unknown()}"

    def is_known(self, quantity: Quantity, element: str = "") -> str:
        """Return the condition that a quantity is known, by its first word."""
        word = self.word(quantity.component, quantity.attribute, _first(quantity, element))
        return f"{word} != {self.unknown()}"

    def unknown(self) -> str:
        """Return what a word that is read equals while it is unknown: an expression."""
        return UNKNOWN

    def half(self, quantity: Quantity, at: int, element: str = "") -> str:
        """The word, which has no sign."""
        place = " + ".join(filter(None, (_first(quantity, element), str(at) if at else "")))
        return self.word(quantity.component, quantity.attribute, place)

    def clock_half(self, word: str, at: int) -> str:
        """The word."""
        self.uses.add("tick")
        return self.word(CLOCK, word, str(at) if at else "")

    def ticking(self) -> list[str]:
        """The statements that let the clocks go on to now, where the function reads one."""
        if "tick" not in self.uses:
            return []
        return ["", "# The clocks go on to now.", self.tick(self.layout.blocks[CLOCK])]

    def tick(self, clock: Block) -> str:
        """The call of that function."""
        raise NotImplementedError

    def is_set(self, quantity: Quantity) -> str:
        """The word."""
        return self.word(quantity.component, quantity.attribute)

    def limit(self, quantity: Quantity) -> str:
        """A number, or the instance's own word."""
        limits = quantity.derivation.own_limits
        if not differ(limits):
            return str(limits[0]) if limits else ""
        return self.number_of(self.word(quantity.component, f"{quantity.name}_limit"))

    def floor(self, quantity: Quantity) -> str:
        """Return the expression for the floor, which has to be reached, too; empty where a quantity has none."""
        floors = quantity.derivation.own_floors
        if not differ(floors):
            return str(floors[0]) if floors else ""
        return self.number_of(self.word(quantity.component, f"{quantity.name}_floor"))

    def count(self, quantity: Quantity) -> str:
        """A number, or the instance's own word."""
        counts = quantity.elements or ()
        if not differ(counts):
            return str(counts[0])
        return self.word(quantity.component, f"{quantity.attribute}_count")

    def number(self, component: str) -> str:
        """The word that was set at the start."""
        return self.word(component, "number")

    def parameter(self, parameter: Parameter) -> str:
        """An argument of the function."""
        name = parameter_attribute(parameter.name)
        self.parameters[name] = parameter
        return name

    def condition(self, quantity: Quantity) -> tuple[str, str]:
        """Return the expression that ``value`` has to be read from (empty: none), and a boolean's condition."""
        if quantity.derivation.follows is None:
            return "", self.is_set(quantity)
        followed = self.layout.blocks[quantity.component].component.quantities[quantity.derivation.follows]
        return self.read(followed), quantity.derivation.holds(self.limit(quantity), self.floor(quantity))

    def store(
        self,
        covers: Elements,
        value: int | float | str,
        at: int = 0,
        *,
        element: str = "",
        always: bool = True,
        over: bool = False,
    ) -> list[str]:
        """An expression as it is; a number as one that the spelling can write."""
        size, turns = covers.field.type.size, self.turns(covers, element)
        offset = covers.offset + at * size
        if over:
            return self._put_halves(offset, min(size, 2), list(map(_hex, _halves(covers, value))), turns)
        if isinstance(value, str):
            return self.put(offset, size, value, always=always, turns=turns)
        if self.is_plain(covers, value):
            return self.put(offset, size, int(value), always=always, turns=turns)
        halves = _halves(covers, value)
        return [
            line
            for n, half in enumerate(halves)
            for line in self.put(offset + 2 * n, 2, half, always=always, turns=turns)
        ]

    def copy(self, covers: Elements, halves: list[str], *, signed: bool, element: str = "") -> list[str]:
        """Half by half; a wider element is filled with the sign."""
        size, offset, turns = covers.field.type.size, covers.offset, self.turns(covers, element)
        if size == 1:
            return self.put(offset, 1, halves[0], turns=turns)
        lines = self._put_halves(offset, 2, halves[: size // 2], turns)
        more = size // 2 - len(halves)
        if more <= 0:
            return lines
        behind = offset + 2 * len(halves)
        zeros = self._put_halves(behind, 2, ["0x0"] * more, turns)
        if not signed:
            return [*lines, *zeros]
        ones = self._put_halves(behind, 2, ["0xFFFF"] * more, turns)
        return [*lines, f"if {halves[-1]} < 0x8000:", *indented(zeros), "else:", *indented(ones)]

    def _put_halves(self, offset: int, size: int, halves: list[str], turns: Turns | None) -> list[str]:
        return [line for n, half in enumerate(halves) for line in self.put(offset + 2 * n, size, half, turns=turns)]

    def turns(self, covers: Elements, element: str) -> Turns | None:
        """The loop over the covered elements in which ``element`` is one of them; None without it."""
        return Turns(element, covers.field.type.size, covers.count) if element else None

    def copy_half(self, covers: Elements, at: int, value: str) -> list[str]:
        """Return the lines that copy a half as two bytes, or one."""
        return self.put(covers.offset + 2 * at, min(covers.field.type.size, 2), value)

    def is_written(self, covers: Elements, value: int) -> str:
        """Half by half, the low one first, which differs most often."""
        halves = enumerate(_halves(covers, value))
        size = min(covers.field.type.size, 2)
        return " and ".join(f"{self.got(covers.offset + 2 * n, size)} == {_hex(half)}" for n, half in halves)

    def got(self, offset: int, size: int) -> str:
        """One or two bytes that have been written at an offset of the payload: an expression."""
        if size == 1:
            return f"wire[{offset}]"
        return f"(wire[{offset}] | wire[{offset + 1}] << 8)"

    def put(
        self, offset: int, size: int, value: int | str, *, always: bool = True, turns: Turns | None = None
    ) -> list[str]:
        """Write a whole number of so many bytes at an offset of the payload, or in a loop from there on."""
        raise NotImplementedError

    def bytes_of(self, covers: Elements) -> set[int]:
        """The offsets of the bytes that are covered."""
        return set(range(covers.offset, covers.offset + covers.count * covers.field.type.size))

    def text(self, covers: Elements, value: str | tuple[str, ...]) -> list[str]:
        """Return the lines that copy a text from a constant; if there are several, each is as long as the longest."""
        values = (value,) if isinstance(value, str) else value
        data = [text.encode() for text in values]
        length = max(map(len, data))
        if not length:
            return []
        name = self._text_constant(covers)
        literals = [f'b"{"".join(map(escaped, one.ljust(length, bytes(1))))}"' for one in data]
        self.texts[name] = literals[0] if len(literals) == 1 else f"({', '.join(literals)})"
        return self.copied(covers, name if len(literals) == 1 else f"{name}[instance]", length)

    def letters(self, covers: Elements, quantity: Quantity, *, forgotten: bool) -> list[str]:
        """Word by word, of two bytes each; ``value`` is how many go out. A text can be cut where a character begins."""
        end = min(quantity.length, covers.count)
        is_cut = end < quantity.length or end == 1
        whole = words_of(end) if 2 * words_of(end) <= covers.count else end // 2
        words, lines = str(whole), []
        if is_cut:
            letter = f"{self._letters(quantity, 'place >> 1')} >> ((place & 1) << 3)"
            lines = [f"place = {end}", f"while ({letter}) & 0xC0 == 0x80:  # amid a character", "    place -= 1"]
            lines.append("value = place")
            words = "value >> 1"
        elif forgotten:
            lines = [f"value = {whole}"]
            words = "value"
        if forgotten:
            lines += [f"if {self.is_unknown(quantity)}:", "    value = 0"]
        two = [*self.store_two(covers, "place", self._letters(quantity, "place")), "place += 1"]
        lines += ["place = 0", f"while place < {words}:", *indented(two)]
        zeros = self.rest(covers, 0)
        if zeros and (is_cut or forgotten):
            lines += ["place *= 2", *zeros]
        if is_cut:
            one = self.store_at(covers, "value", self._letters(quantity, "value >> 1"))
            lines += ["if value & 1:", *indented(["value -= 1", *one])]
        elif 2 * whole < end:
            one = self.put(covers.offset + end - 1, 1, self._letters(quantity, str(whole)))
            lines += ["if value:", *indented(one)] if forgotten else one
        self.rest(covers, 0)  # so that all of it is cleared, whatever of it was written
        return lines

    def _letters(self, quantity: Quantity, place: str) -> str:
        """The word of a text with two of its bytes."""
        return self.word(quantity.component, quantity.attribute, f"({place})" if " " in place else place)

    def store_two(self, covers: Elements, place: str, value: str) -> list[str]:
        """Write 16 bits into the two bytes of a field that begin at twice ``place``."""
        raise NotImplementedError

    def chip(self, covers: Elements) -> list[str]:
        """Return the lines that copy the chip's number from a constant, made when the module is imported."""
        name = self._text_constant(covers)
        count = covers.field.count
        self.uses.add("chip")
        self.texts[name] = f"(hexlify(machine.unique_id()) + bytes({count}))[:{count}]"
        return self.copied(covers, name, count)

    def _text_constant(self, covers: Elements) -> str:
        """A name that no place of a word has."""
        name = f"_{self.message}_{covers.field.name}".upper()
        taken = {
            constant
            for block in self.layout.blocks.values()
            for constant in (block.base_constant, block.size_constant, *map(block.constant, block.offsets))
        }
        while name in taken:
            name += "_"
        return name

    def copied(self, covers: Elements, source: str, length: int) -> list[str]:
        """Copy so many bytes of a constant into the field."""
        raise NotImplementedError

    def now(self) -> str:
        """The time in ms: an expression."""
        raise NotImplementedError

    def head(self, about: tuple[str, ...]) -> tuple[str, str]:
        """The head of the function, up to its arguments and these; ``about`` are the instance and the page."""
        raise NotImplementedError

    def call(self, about: tuple[str, ...]) -> tuple[str, str]:
        """Return how the builder of the message calls the function, as ``head`` has it."""
        raise NotImplementedError

    def reach(self, component: str, instance: str) -> str:
        """The statement that says where the words of a component's instance begin."""
        raise NotImplementedError

    def sources(self) -> list[str]:
        """The statements that take from the state what the function is not given."""
        return []

    def pointers(self) -> list[str]:
        """The statements that make the variables which spelling has turned out to need."""
        return []

    def ending(self) -> list[str]:
        """Return what is left to do once all fields are written."""
        return []

    def finished(self) -> list[str]:
        """Return the statements that report a message as not withheld; none where the template has them."""
        return []

    def cleared(self, length: int) -> list[str]:  # noqa: ARG002  in plain Python nobody else writes the payload
        """Zeros into the bytes of the payload that nothing writes at each call."""
        return []

    def _base(self, component: str, instance: str) -> str:
        block = self.layout.blocks[component]
        return f"{block.base_constant} + {block.size_constant} * {instance}" if instance else block.base_constant


def _halves(covers: Elements, value: float | str) -> tuple[int, ...]:
    """The halves of a number as the field carries it; of a field of one byte that."""
    assert not isinstance(value, str)
    wire_type = covers.field.type
    if wire_type.kind is Kind.FLOAT:
        data = struct.pack(f"<{wire_type.code}", value)
    else:
        data = (int(value) & (1 << 8 * wire_type.size) - 1).to_bytes(wire_type.size, "little")
    return tuple(data) if len(data) == 1 else struct.unpack(f"<{len(data) // 2}H", data)


def _first(quantity: Quantity, element: str) -> str:
    """Return how many words the place of an element lies behind that of the first one; an expression."""
    words = quantity.storage.words
    return f"{words} * {element}" if element and words > 1 else element


def real_about(covers: Elements, factor: FloatParts) -> tuple[int, int, int, int, int]:
    """Return what ``put_real`` of the firmware wants to know: numerator, divisor, exponent, and two counts of bits and
    bytes.

    The exponent is that of the wire for a quotient whose highest bit counts 2 ** 59; so many bits of it are found at
    once as keep what is divided below 2 ** 30.
    """
    size = covers.field.type.size
    room = SMALL_INT_MAX.bit_length() - factor.divisor.bit_length()
    bits = max(each for each in (1, 3, 5, 15) if each <= room)
    return factor.numerator, factor.divisor, 59 + factor.power + (1023 if size == 8 else 127), bits, size


def escaped(byte: int) -> str:
    """A byte in a literal of bytes."""
    text = chr(byte)
    return text if text.isprintable() and text not in '"\\' and byte < 128 else f"\\x{byte:02x}"


def literal(value: int | str) -> int | None:
    """The number that an expression is, where it is known now."""
    if isinstance(value, int):
        return value
    return int(value, 0) if value.lstrip("-").isdigit() or value.startswith("0x") else None


def byte_of(value: str, number: int) -> str:
    """A byte of an expression, which may be a literal."""
    number_known = literal(value)
    if number_known is not None:
        return str(number_known >> 8 * number & 0xFF)
    shown = value if value.isidentifier() else f"({value})"
    return f"{shown} >> {8 * number} & 0xFF" if number else f"{shown} & 0xFF"


def _hex(half: int) -> str:
    return f"0x{half:X}" if half > 9 else str(half)
