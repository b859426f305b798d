"""Views of the functions that go from the payload of a received message to the words of the state.

The statements are the same in machine code and in plain Python, which do without allocating alike: numbers are taken
from bytes as halves of 16 bits, and what is beyond a limit is found before a number of more than 30 bits comes up.
``counts`` are those of a Reception, see templates/firmware/program/reception.py.
"""

import math
from collections.abc import Iterator
from fractions import Fraction

from codegen.frozen import dataclass
from codegen.model.code.halves import beyond, equal
from codegen.model.code.payload_code import UNKNOWN, indented
from codegen.model.code.statements import scaled, tested
from codegen.model.code.storage import HALF, SMALL_INT_MAX, Storage
from codegen.model.code.two_steps import in_one_step, in_two_steps
from codegen.model.program import RECEIVED
from codegen.model.reception import ReceivedField, Reception
from codegen.model.spec.receive import Sender
from codegen.model.system import System
from codegen.model.vehicle import QuantityKind
from codegen.targets.firmware.messages.provisos import broken
from codegen.targets.firmware.messages.wire_numbers import Machine, Plain, bare, number_of
from codegen.targets.firmware.words import ConstantView, Layout, age_word
from codegen.targets.imports import either_import, import_lines
from codegen.targets.naming import class_names

FIELDS = 16
"""The place at which the counts of the fields begin."""
_OWN = 3
"""The place of the vehicle's system and component."""
_MASK = f"0x{SMALL_INT_MAX:X}"
_TOP = 0x8000


@dataclass(frozen=True, slots=True)
class TakeView:
    """One table: its function, and what its Reception is made with. ``call`` is "None" or a name in quotes.

    ``lines`` are plain Python. In machine code ``admitted`` leaves what its sender may not send, ``machine_lines`` do
    the same as ``lines``, and ``has_halves`` and ``makes_wholes`` tell what they use.
    """

    name: str
    message: str
    citation: str
    class_name: str
    function: str
    fields: str
    sender: str
    call: str
    admitted: tuple[str, ...]
    lines: tuple[str, ...]
    machine_lines: tuple[str, ...]
    has_halves: bool
    makes_wholes: bool


@dataclass(frozen=True, slots=True)
class ReceivingView:
    """The modules: constants of the state's words, and the tables in the order of their ids.

    ``makes_wholes``: of floats. ``is_shared``: a message has several tables.
    ``kinds`` are the classes of the messages that are received for them alone.
    """

    imports: tuple[str, ...]
    either: tuple[str, ...]
    is_shared: bool
    constants: tuple[ConstantView, ...]
    makes_wholes: bool
    kinds: tuple[str, ...]
    takes: tuple[TakeView, ...]


def receiving_view(system: System, layout: Layout) -> ReceivingView:
    """The view of receiving.py, and of the functions beside it."""
    classes = class_names(wire.name for wire in system.wires)
    places: dict[str, int] = {}
    takes = tuple(_take(table, classes[table.wire.name], layout, places) for table in system.receptions)
    machine_code = system.spec.project.machine_code
    senders = {("reception", take.sender) for take in takes}
    is_shared = len({take.class_name for take in takes}) < len(takes)
    names = ["Reception", "rarely", *(["Several"] if is_shared else [])]
    return ReceivingView(
        imports=import_lines(["messages"], [("message", "keep"), *(("reception", name) for name in names), *senders]),
        either=either_import(
            "receiving", sorted([*(take.function for take in takes), "taker"]), machine_code=machine_code
        ),
        is_shared=is_shared,
        constants=tuple(ConstantView(name, place) for name, place in sorted(places.items(), key=lambda each: each[1])),
        makes_wholes=any(makes_whole(taken) for table in system.receptions for taken in table.fields),
        kinds=tuple(classes[name] for name in received_beside(system)),
        takes=takes,
    )


def _take(table: Reception, class_name: str, layout: Layout, places: dict[str, int]) -> TakeView:
    lines = _lines(table, Plain(), layout, places)
    machine_lines = _lines(table, Machine(), layout, places)
    labels = [f'"{taken.label}"' for taken in table.fields]
    return TakeView(
        name=table.name,
        message=table.title,
        citation=str(table.citation),
        class_name=class_name,
        function=f"take_{table.name.lower()}",
        fields=f"({', '.join(labels)}{',' if len(labels) == 1 else ''})",
        sender=table.spec.sender.value.upper(),
        call=f'"{call_name(table)}"' if table.spec.call else "None",
        admitted=tuple(_admitted(table)),
        lines=lines,
        machine_lines=machine_lines,
        has_halves=any("halves[" in line for line in machine_lines),
        makes_wholes=any(makes_whole(taken) for taken in table.fields),
    )


def _lines(table: Reception, code: Plain, layout: Layout, places: dict[str, int]) -> tuple[str, ...]:
    lines = list(_conditions(table, code))
    for number, taken in enumerate(table.fields, 1):
        lines += ["", *_Statements(taken, number, code, layout, places).lines()]
    lines += ["return counts[0]" if not table.spec.call else "return counts[0] if counts[0] else -1"]
    return tuple(f"    {line}" if line else "" for line in lines)


def makes_whole(taken: ReceivedField) -> bool:
    """Return whether a whole number is made of a float."""
    return not taken.is_text and not taken.field.type.is_integer and taken.quantity.storage is Storage.SMALL


def received_beside(system: System) -> tuple[str, ...]:
    """The messages of the tables that are received for nobody else, by name."""
    program = system.program
    others = (*RECEIVED, *(program.received_besides if program else ()))
    names = dict.fromkeys(table.wire.name for table in system.receptions)
    return tuple(name for name in names if name not in others)


def call_name(table: Reception) -> str:
    """Return what is called of the user's vehicle: ``received_rc_channels_override``."""
    return f"received_{table.name.lower()}"


def _admitted(table: Reception) -> Iterator[str]:
    """Leave what somebody else sends than may, in machine code; receiving_plain.py.j2 has the same for all tables."""
    if table.spec.sender is Sender.GROUND_STATION:
        yield "names = ptr8(int(counts[8]) | int(counts[9]) << 32)"
        yield "at = 0"
        yield "while at < counts[5] and names[at + 1] != link[23] >> 8:  # the system stands in the high byte"
        yield "    at += 2"
        yield "if at == counts[5]:"
        yield "    return 0"
    elif table.spec.sender is Sender.OWN_SYSTEM:
        yield "if link[23] >> 8 != counts[3]:"
        yield "    return 0"
    if table.has_extensions:
        yield "counts[2] = link[3] + 10 - link[4]  # what its header has less than that of MAVLink 2"


def _conditions(table: Reception, code: Plain) -> Iterator[str]:
    """Leave what is for another vehicle, and what another table, or nobody, is for; count what is taken."""
    places = [(field.offset, at) for at, field in enumerate(table.targets, _OWN) if field is not None]
    others = [f"wire[{offset}] and wire[{offset}] != counts[{at}]" for offset, at in places]
    if others:
        yield f"if {_any(others)}:"
        yield "    counts[0] = -1  # for somebody else"
        yield "    return 0"
    if table.conditions:
        tests = " or ".join(f"{number_of(field, field.offset, code)} != {number}" for field, number in table.conditions)
        yield f"if {tests}:"
        yield "    counts[0] = -1  # not for this table"
        yield "    return 0"
    yield "counts[0] = 0"
    yield f"counts[1] = counts[1] + 1 & {_MASK}"


def _any(tests: list[str]) -> str:
    return tests[0] if len(tests) == 1 else " or ".join(f"({test})" for test in tests)


class _Statements:
    """The statements of one field, the ``number``-th of its table; ``places`` collects the words that they name."""

    def __init__(self, taken: ReceivedField, number: int, code: Plain, layout: Layout, places: dict[str, int]) -> None:
        self._taken = taken
        self._number = number
        self._code = code
        self._layout = layout
        self._places = places

    def lines(self) -> list[str]:
        taken, quantity = self._taken, self._taken.quantity
        units = f" [{taken.field.unit_text}]" if taken.field.unit_text else ""
        kept = f" [{quantity.stored.name}]" if quantity.stored.name and quantity.stored.name != units[2:-1] else ""
        comment = f"# {taken.label}{units}: {quantity.path}{kept} ({taken.citation})"
        if taken.is_text:
            return [comment, *self._text()]
        # Of a number of several halves `value` is the highest, which is looked at most.
        halves = self._halves(taken.offset) if self._is_long else []
        read = bare(halves.pop()) if halves else number_of(taken.field, taken.offset, self._code)
        before = [f"value = {read}"]
        tests = [*self._unknown(halves), *self._beyond(halves)]
        store = [*self._store(halves), *self._renewed()]
        if not tests:
            return [comment, *before, *store]
        lines: list[str] = []
        for condition, remark, inner in tests:
            lines += [*tested("elif" if lines else "if", condition, remark), *indented(inner)]
        return [comment, *before, *lines, "else:", *indented(store)]

    # places

    def _word(self, attribute: str, at: int = 0) -> str:
        quantity = self._taken.quantity
        block = self._layout.blocks[quantity.component]
        name = block.constant(attribute)
        self._places[name] = self._layout.places(quantity.component, attribute)[0]
        return f"words[{name} + {at}]" if at else f"words[{name}]"

    def _halves(self, offset: int) -> list[str]:
        """The halves of a number on the wire, the low one first."""
        return [self._code.half(offset + 2 * at) for at in range(self._taken.field.type.size // 2)]

    @property
    def _is_long(self) -> bool:
        """Return whether the number has several halves."""
        return self._taken.field.type.size > 2

    @property
    def _wire_storage(self) -> Storage:
        return Storage(self._taken.field.type.code)

    # tests

    def _unknown(self, halves: list[str]) -> Iterator[tuple[str, str, list[str]]]:
        """Yield what sets no value: it makes the quantity unknown, or leaves it, as all of it does a boolean."""
        taken = self._taken
        is_boolean = taken.quantity.kind is QuantityKind.BOOLEAN
        forget = ["pass"] if is_boolean else [f"{self._word(taken.quantity.attribute)} = {UNKNOWN}"]
        if taken.is_extension:
            yield "counts[2]", "MAVLink 1 does not have it", ["pass"] if taken.is_kept_by_absence else forget
        if taken.provisos:
            no_value = ["pass"] if taken.is_kept_otherwise else forget
            yield broken(taken.provisos, self._code), "others say that it is no value", no_value
        if not taken.field.type.is_integer:
            exponent = 0x7F80 if taken.field.type.size == 4 else 0x7FF0
            kept = ["pass"] if taken.is_kept_by_nan else forget
            yield f"value & 0x{exponent:X} == 0x{exponent:X}", "NaN, or infinite", kept
        for numbers, remark, inner in (
            (taken.unchanged, "left as it was", ["pass"]),
            (taken.absent, "there is none", forget),
        ):
            ways = [self._equal(number, halves) for number in numbers if math.isfinite(number)]
            if ways:
                yield _any(ways) if self._is_long else " or ".join(ways), remark, inner
        sentinel = taken.sentinel
        if sentinel is None or not math.isfinite(sentinel) or (sentinel in taken.absent and taken.speaks_for_itself):
            return
        if taken.speaks_for_itself:
            yield self._equal(sentinel, halves), "unknown", forget
        else:
            said = (self._said(taken.field.offset + each * taken.field.type.size, sentinel) for each in taken.speaking)
            yield " and ".join(said), "unknown", forget

    def _said(self, offset: int, number: float) -> str:
        """The condition that an element of the array, at ``offset``, is a number."""
        if self._is_long:
            return equal(self._halves(offset), Fraction(number), self._wire_storage)
        return f"{number_of(self._taken.field, offset, self._code)} == {number}"

    def _equal(self, number: float, halves: list[str]) -> str:
        """The condition that its own number is one that sets no value."""
        if self._is_long:
            return equal([*halves, "value"], Fraction(number), self._wire_storage)
        return f"value == {number}"

    def _beyond(self, halves: list[str]) -> Iterator[tuple[str, str, list[str]]]:
        """Yield what is not taken."""
        taken, field = self._taken, self._taken.field
        low, high = taken.low, taken.high
        least, most = Fraction(field.type.minimum), Fraction(field.type.maximum)
        if not field.type.is_integer:
            least, most = (Fraction(end) for end in self._wire_storage.limits)
        below, above = low if low > least else None, high if high < most else None
        if self._is_long:
            condition = beyond([*halves, "value"], below, above, self._wire_storage)
        else:
            tests = [(sign, limit) for sign, limit in (("<", below), (">", above)) if limit is not None]
            condition = " or ".join(f"value {sign} {limit}" for sign, limit in tests)
        if condition:
            refuse = [f"counts[0] = {self._number}", self._counted()]
            yield condition, "not plausible", refuse

    def _counted(self) -> str:
        at = FIELDS - 1 + self._number
        return f"counts[{at}] = counts[{at}] + 1 & {_MASK}"

    # what is kept

    def _store(self, halves: list[str]) -> list[str]:
        """``halves`` are those below the highest one."""
        taken, quantity = self._taken, self._taken.quantity
        word, storage = quantity.attribute, quantity.storage
        if quantity.kind is QuantityKind.BOOLEAN:
            is_set = " or ".join(f"{half} != 0" for half in ("value", *halves))
            return [f"{self._word(word)} = 1 if {is_set} else 0"]
        if storage is not Storage.SMALL:
            kept = self._extended(halves, storage.halves)
            return [f"{self._word(word, at)} = {half}" for at, half in enumerate(kept)]
        if not taken.field.type.is_integer:
            return self._code.whole(self._word(word), halves[0], taken.factor)
        lines = []
        value = "value"
        if halves:
            # A value within the limits is a number of 30 bits: the halves above its two only have its sign.
            top = bare(halves[1]) if len(halves) > 1 else "value"
            top = f"(({top}) ^ 0x{_TOP:X}) - 0x{_TOP:X}".replace("(value)", "value") if taken.low < 0 else top
            value = f"({top}) << {HALF} | {halves[0]}".replace("(value)", "value")
        if taken.factor != 1:
            lines = [f"value = {value}"] if halves else []
            lines += self._converted()
            value = "value"
        return [*lines, f"{self._word(word)} = {value}"]

    def _converted(self) -> list[str]:
        """Return what turns ``value`` into what is kept, without what negative numbers need where there are none."""
        taken = self._taken
        most, rounding = max(abs(taken.low), abs(taken.high)), taken.spec.rounding
        if in_one_step(taken.factor, most):
            lines = scaled(taken.factor, rounding)
            return [lines[-1].strip()] if taken.low >= 0 else lines
        steps = in_two_steps(taken.factor, most)
        assert steps is not None, taken.label
        return steps.lines(rounding, has_negative=taken.low < 0)

    def _extended(self, halves: list[str], count: int) -> Iterator[str]:
        """Yield as many halves as are kept, the sign in those that the wire does not have."""
        wire = [*(bare(half) for half in halves), "value" if self._is_long else "value & 0xFFFF"]
        negative = f"value & 0x{_TOP:X} != 0" if self._is_long else "value < 0"
        for at in range(count):
            yield wire[at] if at < len(wire) else f"0xFFFF if {negative} else 0" if self._taken.low < 0 else "0"

    def _renewed(self) -> list[str]:
        """The time until which the value is believed; sums beyond 30 bits would allocate."""
        quantity = self._taken.quantity
        if not quantity.ages:
            return []
        after_ms = quantity.trust.stale_after_ms
        assert after_ms is not None
        return [f"{self._word(age_word(quantity))} = now_ms - {SMALL_INT_MAX - after_ms + 1} & {_MASK}"]

    def _text(self) -> list[str]:
        """Characters up to the first NUL, two to a word; what is not ASCII is not taken."""
        taken, quantity = self._taken, self._taken.quantity
        count, start = taken.field.count, taken.offset
        place = self._word(quantity.attribute)
        letter = f"wire[{start} + value]"
        at, name = f"wire[{start} + 2 * at]", place.removeprefix("words[").removesuffix("]")
        store = [
            "at = 0",
            f"while at < {quantity.words}:",
            f"    words[{name} + at] = {at} if 2 * at < value else 0",
            "    if 2 * at + 1 < value:",
            f"        words[{name} + at] = {at} | wire[{start + 1} + 2 * at] << 8",
            "    at += 1",
            *self._renewed(),
        ]
        is_cut = f"value < {count} and {letter}"
        tests: list[tuple[str, str, list[str]]] = []
        if taken.is_extension:
            tests.append(("counts[2]", "MAVLink 1 does not have it", [f"{place} = {UNKNOWN}"]))
        if taken.provisos:
            no_value = ["pass"] if taken.is_kept_otherwise else [f"{place} = {UNKNOWN}"]
            tests.append((broken(taken.provisos, self._code), "others say that it is no value", no_value))
        tests.append((is_cut, "not ASCII", [f"counts[0] = {self._number}", self._counted()]))
        if taken.sentinel is not None:
            tests.append(("value == 0", "unknown", [f"{place} = {UNKNOWN}"]))
        lines = ["value = 0", f"while {is_cut} and {letter} < 0x80:", "    value += 1"]
        for number, (condition, remark, inner) in enumerate(tests):
            lines += [*tested("elif" if number else "if", condition, remark), *indented(inner)]
        return [*lines, "else:", *indented(store)]
