"""View of the module of a reading behind the first of its component."""

import dataclasses

from codegen.frozen import dataclass
from codegen.model.system import System
from codegen.model.vehicle import Parameter, Reading
from codegen.targets.firmware.families import FamilyView, family_view
from codegen.targets.firmware.readings.board import BoardView, ReaderView
from codegen.targets.firmware.readings.estimates import EstimateView, estimate_views
from codegen.targets.firmware.readings.measured_view import (
    MeasuredView,
    TellView,
    measured_view,
    read_words,
    texts_of,
    unreadable,
)
from codegen.targets.firmware.readings.sum_words import fulls
from codegen.targets.firmware.words import ConstantView, Layout
from codegen.targets.imports import either_import


@dataclass(frozen=True, slots=True)
class FurtherModuleView:
    """The module that connects further inputs and reads them in turns: ``count`` and ``failures`` are words of these.

    ``estimates`` follow what it measures; ``told`` is what is logged.
    """

    title: str
    name: str
    component: str
    instances: int
    imports: tuple[str, ...]
    constants: tuple[ConstantView, ...]
    families: tuple[FamilyView, ...]
    measured: MeasuredView
    reader: ReaderView
    has_parameters: bool
    count: str
    failures: str
    estimates: tuple[EstimateView, ...]
    told: tuple[TellView, ...]
    unreadable: str


def further_module_view(reading: Reading, board: BoardView, system: System, layout: Layout) -> FurtherModuleView:
    """The view of the module."""
    component, block = reading.component, layout.blocks[reading.component.name]
    measured = measured_view(reading, block, "parameters")
    set_up = (*measured.set_up, *read_words(reading, block, "parameters"))
    count, failures = (block.constant(reading.word(word)) for word in ("count", "failures"))
    used = {count, failures, *(word for word, _ in set_up)}
    estimates = tuple(estimate_views(reading, block))
    for estimate in estimates:
        used |= {estimate.word, measured.word, *((estimate.gone,) if estimate.gone else ())}
    used |= {block.constant(word) for word in block.offsets if any(block.constant(word) in text for _, text in set_up)}
    readers = [f"{reading.name}_reading", f"read_{reading.name}"]
    return FurtherModuleView(
        title=f"The {reading.quantity.name} of the {component.name}",
        name=reading.name,
        component=component.name,
        instances=component.instances,
        imports=either_import(reading.name, readers, machine_code=system.spec.project.machine_code),
        constants=tuple(
            ConstantView(block.constant(word), at) for word, at in block.offsets.items() if block.constant(word) in used
        ),
        families=tuple(family_view(parameter) for parameter in _families(reading)),
        measured=dataclasses.replace(measured, set_up=set_up),
        reader=next(reader for reader in board.readers if reader.component == reading.name),
        has_parameters=board.has_pins,
        count=count,
        failures=failures,
        estimates=estimates,
        told=tuple(texts_of(reading, measured)),
        unreadable=unreadable(component, reading.quantity.name),
    )


def _families(reading: Reading) -> list[Parameter]:
    """The families of which it reads the parameter of each instance, once each."""
    channel = reading.conversion.channel
    used = [factor for factor in reading.conversion.factors if isinstance(factor, Parameter)]
    used += [
        each for each in (channel.pin, channel.when[0] if channel.when else None, reading.component.switch) if each
    ]
    used += fulls(reading).values()
    return list({parameter.name: parameter for parameter in used if parameter.siblings}.values())
