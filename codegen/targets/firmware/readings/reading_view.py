"""Views of state_viper.py and state_plain.py: what is done with each reading of a component."""

from collections.abc import Iterable

from codegen.frozen import dataclass
from codegen.model.code.payload_code import indented
from codegen.model.vehicle import Reading
from codegen.targets.firmware.messages.payload import SpelledCode
from codegen.targets.firmware.messages.payload_machine import MachineCode
from codegen.targets.firmware.messages.payload_plain import PlainReading
from codegen.targets.firmware.readings.board import ReaderView
from codegen.targets.firmware.readings.reading import WAITING, changed, expires, expiry, known, taken
from codegen.targets.firmware.readings.sum_words import counted
from codegen.targets.firmware.readings.summing import summed
from codegen.targets.firmware.words import ConstantView, Layout


@dataclass(frozen=True, slots=True)
class ReadingView:
    """The functions of one reading of a component: what takes readings, and, of the first one, what forgets old ones.

    ``name`` is that of the reading.

    ``start`` is where the first one stands in the state, in bytes, ``size`` how many words each takes. ``declared`` are
    the statements that the code for one instance needs before it, ``is_read`` is the condition that one is read, "" for
    always, ``is_set`` the one that code sets it in place of the board, "" for never, ``asked`` the count that the board
    is asked for, and ``turn`` what is done with it; ``changed`` are the statements for its trend, and ``summed`` those
    for sums, where they have a function of their own.
    """

    name: str
    component: str
    instances: int
    start: str
    size: str
    declared: tuple[str, ...]
    is_read: str
    is_set: str
    count: str
    asked: str
    measured: str
    citation: str
    turn: tuple[str, ...]
    summed: tuple[str, ...]
    changed: tuple[str, ...]
    expiry: tuple[str, ...]
    stale_after: str


@dataclass(frozen=True, slots=True)
class ReadingsView:
    """A module: the constants of the words that readings are about, and the functions of each of them.

    ``samplers`` are the readings whose samples it takes, too.
    """

    constants: tuple[ConstantView, ...]
    readings: tuple[ReadingView, ...]
    samplers: tuple[ReaderView, ...] = ()
    waiting: int = WAITING


def readings_view(
    layout: Layout, readings: Iterable[Reading], samplers: tuple[ReaderView, ...] = (), *, machine_code: bool
) -> ReadingsView:
    """The view of the module of some readings, in machine code or in plain Python."""
    views = []
    constants: list[ConstantView] = []
    words: dict[str, set[str]] = {}
    for reading in readings:
        component = reading.component
        code: SpelledCode = (MachineCode if machine_code else PlainReading)(layout, component.name)
        old = expiry(component.readings, code, "now_ms") if reading.is_first and expires(component) else []
        old_pointers = code.pointers()
        code.uses.clear()  # the other function begins
        name, block = component.name, layout.blocks[component.name]
        several = component.instances > 1
        asked = f"board.read_{reading.name}_adc({'instance' if several else ''})"
        is_read = _is_read(reading, code)
        change = changed(reading, code)
        turn = _turn(reading, code, asked, is_read) if machine_code else _take(reading, code)
        views.append(
            ReadingView(
                name=reading.name,
                component=name,
                instances=component.instances,
                start=f"4 * ({block.base_constant} + {block.size_constant} * first)"
                if several
                else f"4 * {block.base_constant}",
                size=block.size_constant,
                declared=(*code.pointers(), *_clock(turn)),
                is_read=is_read,
                is_set=code.word(name, reading.word("is_set")) if reading.quantity.derivation.represented else "",
                count=code.word(name, reading.word("count")),
                asked=asked,
                measured=reading.quantity.name,
                citation=str((component.citation if reading.is_first else reading.quantity.citation) or name),
                turn=tuple(turn),
                summed=() if machine_code else tuple(summed(reading, code)),
                changed=() if machine_code else tuple(change),
                expiry=tuple(indented([*old_pointers, *old])),
                stale_after=reading.quantity.cited("stale_after"),
            )
        )
        words.setdefault(name, set()).update(code.words[name])
    for name, used in words.items():
        block = layout.blocks[name]
        if machine_code:
            constants.append(ConstantView(block.base_constant, block.base))
            constants += [ConstantView(block.size_constant, block.size)] if block.component.instances > 1 else []
        constants += layout.constants(name, used, in_array=False)
    return ReadingsView(tuple(constants), tuple(views), samplers)


def _is_read(reading: Reading, code: SpelledCode) -> str:
    """The condition that an instance is read; "" for always."""
    component = reading.component
    if reading.is_conditional:
        return code.word(component.name, reading.word("is_read"))
    return code.word(component.name, component.enabled.attribute) if component.enabled else ""


def _clock(turn: list[str]) -> list[str]:
    """The time, where a statement of the turn needs it."""
    return ["now_ms = int(ticks())"] if any("now_ms" in line for line in turn) else []


def _turn(reading: Reading, code: SpelledCode, asked: str, is_read: str) -> list[str]:
    """One turn of the loop in machine code: ask for a count, unless it stands there already, and take it over."""
    count = code.word(reading.component.name, reading.word("count"))
    asking = "not is_alone"
    if reading.quantity.derivation.represented:
        asking += f" and not {code.word(reading.component.name, reading.word('is_set'))}"
    lines = [f"if {asking}:", f"    {count} = {WAITING}", f"    {count} = int({asked})"]
    lines += taken(reading, code)
    if change := changed(reading, code):
        lines += ["", f"if {known(reading, code)}:", *indented(change)]
    lines += ["", "if is_alone:", "    return told", "if told:", "    return told | instance << 4"]
    return [f"if is_alone or {is_read}:", *indented(lines)] if is_read else lines


def _take(reading: Reading, code: SpelledCode) -> list[str]:
    """Take a count over in plain Python; the trend has a function of its own: one of many variables needs heap."""
    name, owner = reading.name, reading.component.name
    lines = taken(reading, code, [f"_sum_{name}({owner}, value, now_ms)"] if counted(reading) else [])
    if changed(reading, code):
        lines += [f"if {known(reading, code)}:", f"    _change_{name}({owner})"]
    return [*lines, "return told"]
