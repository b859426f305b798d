"""Views of state_viper.py and state_plain.py: what is done with each reading of a component."""

from codegen.frozen import dataclass
from codegen.model.payload_code import indented
from codegen.model.system import System
from codegen.model.vehicle import Component
from codegen.targets.firmware.payload import SpelledCode
from codegen.targets.firmware.payload_machine import MachineReading
from codegen.targets.firmware.payload_plain import PlainReading
from codegen.targets.firmware.reading import changed, expires, expiry, taken
from codegen.targets.firmware.words import ConstantView, Layout, measured_of

WAITING = -2
"""The count of an instance that has not been read yet."""


@dataclass(frozen=True, slots=True)
class ReadingView:
    """The functions of one component: what reads it, what takes a reading over, and what forgets an old one;
    ``changed`` are the statements for its trend.

    ``count`` is the word of what was counted, ``read`` are the statements for one instance.
    """

    component: str
    instances: int
    count: str
    read: tuple[str, ...]
    count_constant: str
    measured: str
    citation: str
    taken: tuple[str, ...]
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
        code: SpelledCode = (MachineReading if machine_code else PlainReading)(layout, component.name)
        old = expiry(component, code, "now_ms", "age") if expires(component) else []
        old_pointers = code.pointers()
        body, change = taken(component, code), changed(component, code)
        views.append(
            ReadingView(
                component=component.name,
                instances=component.instances,
                read=tuple(_read(component, code, machine_code=machine_code)),
                count=code.word(component.name, "count"),
                count_constant=layout.blocks[component.name].constant("count"),
                measured=measured.name,
                citation=str(component.citation or component.name),
                taken=tuple(indented([*code.pointers(), *body])),
                changed=tuple(indented(change)),
                expiry=tuple(indented([*old_pointers, *old])),
                stale_after=measured.cited("stale_after"),
            )
        )
        constants += layout.constants(component.name, code.words[component.name], in_array=False)
    return ReadingsView(tuple(constants), tuple(views))


def _read(component: Component, code: SpelledCode, *, machine_code: bool) -> list[str]:
    """Read one instance and take the count over, if it is measured at all."""
    name, several = component.name, component.instances > 1
    counted = f"board.read_{name}_adc({'instance' if several else ''})"
    failures = f"board.{name}_failures{'[instance]' if several else ''}"
    count = code.word(name, "count")
    if machine_code:
        lines = [f"count = int({counted})", f"if {failures}:", "    count = -1", f"{count} = count"]
        lines.append(f"told = int(take_{name}(every[instance], now_ms))")
    else:
        lines = [
            f"count = {counted}",
            f"{count} = -1 if {failures} else count",
            f"told = take_{name}({name}, time.ticks_ms())",
        ]
    lines += ["if told:", f"    state.tell_{name}(told, instance)"]
    if component.enabled is None:
        return lines
    return [f"if {code.word(name, component.enabled.attribute)}:", *indented(lines)]
