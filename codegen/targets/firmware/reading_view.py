"""Views of state_viper.py and state_plain.py: what is done with each reading of a component."""

from codegen.frozen import dataclass
from codegen.model.payload_code import indented
from codegen.model.system import System
from codegen.model.vehicle import Component
from codegen.targets.firmware.payload import SpelledCode
from codegen.targets.firmware.payload_machine import MachineCode
from codegen.targets.firmware.payload_plain import PlainReading
from codegen.targets.firmware.reading import WAITING, changed, expires, expiry, known, taken
from codegen.targets.firmware.words import ConstantView, Layout, measured_of


@dataclass(frozen=True, slots=True)
class ReadingView:
    """The functions of one component: what reads it, what takes a reading over, and what forgets an old one.

    ``start`` is where the first one stands in the state, in bytes, ``size`` how many words each takes. ``declared`` are
    the statements that the code for one instance needs before it, ``is_read`` is the condition that one is read, "" for
    always, ``asked`` the count that the board is asked for, and ``turn`` what is done with it; ``changed`` are the
    statements for its trend where they have a function of their own.
    """

    component: str
    instances: int
    start: str
    size: str
    declared: tuple[str, ...]
    is_read: str
    count: str
    asked: str
    measured: str
    citation: str
    turn: tuple[str, ...]
    changed: tuple[str, ...]
    expiry: tuple[str, ...]
    stale_after: str


@dataclass(frozen=True, slots=True)
class ReadingsView:
    """The module: the constants of the words that readings are about, and the functions of each component."""

    constants: tuple[ConstantView, ...]
    readings: tuple[ReadingView, ...]
    waiting: int = WAITING


def readings_view(system: System, layout: Layout, *, machine_code: bool) -> ReadingsView:
    """The view of the module in machine code, or in plain Python."""
    views = []
    constants: list[ConstantView] = []
    for component in system.components.values():
        measured = measured_of(component)
        if measured is None:
            continue
        code: SpelledCode = (MachineCode if machine_code else PlainReading)(layout, component.name)
        old = expiry(component, code, "now_ms", "age") if expires(component) else []
        old_pointers = code.pointers()
        name, enabled, block = component.name, component.enabled, layout.blocks[component.name]
        several = component.instances > 1
        asked = f"board.read_{name}_adc({'instance' if several else ''})"
        is_read = code.word(name, enabled.attribute) if enabled else ""
        change = changed(component, code)
        turn = _turn(component, code, asked, is_read) if machine_code else _take(component, code)
        views.append(
            ReadingView(
                component=name,
                instances=component.instances,
                start=f"4 * ({block.base_constant} + {block.size_constant} * first)"
                if several
                else f"4 * {block.base_constant}",
                size=block.size_constant,
                declared=(*code.pointers(), *_clock(turn)),
                is_read=is_read,
                count=code.word(name, "count"),
                asked=asked,
                measured=measured.name,
                citation=str(component.citation or name),
                turn=tuple(turn),
                changed=() if machine_code else tuple(change),
                expiry=tuple(indented([*old_pointers, *old])),
                stale_after=measured.cited("stale_after"),
            )
        )
        if machine_code:
            constants.append(ConstantView(block.base_constant, block.base))
            constants += [ConstantView(block.size_constant, block.size)] if several else []
        constants += layout.constants(name, code.words[name], in_array=False)
    return ReadingsView(tuple(constants), tuple(views))


def _clock(turn: list[str]) -> list[str]:
    """The time, where a statement of the turn needs it."""
    return ["now_ms = int(ticks())"] if any("now_ms" in line for line in turn) else []


def _turn(component: Component, code: SpelledCode, asked: str, is_read: str) -> list[str]:
    """One turn of the loop in machine code: ask for a count, unless it stands there already, and take it over."""
    count = code.word(component.name, "count")
    lines = ["if first >= 0:", f"    {count} = {WAITING}", f"    {count} = int({asked})"]
    lines += taken(component, code)
    if change := changed(component, code):
        lines += ["", f"if {known(component, code)}:", *indented(change)]
    lines += ["", "if first < 0:", "    return told", "if told:", "    return told | instance << 4"]
    return [f"if first < 0 or {is_read}:", *indented(lines)] if is_read else lines


def _take(component: Component, code: SpelledCode) -> list[str]:
    """Take a count over in plain Python; the trend has a function of its own: one of many variables needs heap."""
    lines = taken(component, code)
    if changed(component, code):
        lines += [f"if {known(component, code)}:", f"    _change_{component.name}({component.name})"]
    return [*lines, "return told"]
