"""View of board.py: how each measured component is read."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.board_spec import AdcSpec
from codegen.model.program import BoardLink, LinkKind
from codegen.model.system import System
from codegen.model.vehicle import AdcChannel, Component, Parameter
from codegen.targets.families import FamilyView, family_view
from codegen.targets.naming import parameter_attribute, parameter_expression, prose, quoted


@dataclass(frozen=True, slots=True)
class ReaderView:
    """The ADC channel of one component: ``shift`` turns the 16 bits of read_u16() into counts.

    ``spare_bits`` are the bits of the 12 bit converter that a count leaves out, ``pin`` is the attribute of the
    parameter that has the pin.
    """

    component: str
    instances: int
    several: bool
    gpio: int
    gpios: tuple[int, ...]
    pin: str | None
    gpio_expression: str
    switch_expression: str | None
    shift: int
    spare_bits: int
    full_scale: int
    samples: int
    half: int
    read_limit_us: int | None
    citation: str
    cited: Mapping[str, str]


@dataclass(frozen=True, slots=True)
class LinkView:
    """A link: ``function`` of a module opens it with ``arguments``."""

    module: str
    function: str
    arguments: tuple[str, ...]
    citation: str


@dataclass(frozen=True, slots=True)
class BoardView:
    """The board, its readers and its links."""

    board: str
    mcu: str
    readers: tuple[ReaderView, ...]
    families: tuple[FamilyView, ...]
    links: tuple[LinkView, ...]
    imports: tuple[tuple[str, tuple[str, ...]], ...]
    is_timed: bool
    has_pins: bool


def board_view(system: System) -> BoardView:
    """The view of the whole module."""
    readers = [
        _reader(system.components[component], conversion.channel, system)
        for component, _, conversion in system.measured()
    ]
    links = tuple(_link(link) for link in system.links)
    is_timed = any(reader.read_limit_us is not None for reader in readers)
    return BoardView(
        board=prose(system.spec.board.board),
        mcu=prose(system.spec.board.mcu),
        readers=tuple(readers),
        families=_families(system),
        links=links,
        imports=_imports(links),
        is_timed=is_timed,
        has_pins=any(reader.pin or reader.switch_expression for reader in readers),
    )


def _families(system: System) -> tuple[FamilyView, ...]:
    """The parameters that have the pin of each instance and that switch it on, once each."""
    used: dict[str, Parameter] = {}
    for name, _, conversion in system.measured():
        pin = conversion.channel.pin
        used |= {each.name: each for each in (pin, _switch(system.components[name])) if each and each.siblings}
    return tuple(family_view(parameter) for parameter in used.values())


def _switch(component: Component) -> Parameter | None:
    """The parameter that switches one of several instances on: the pin of one that is off is left alone."""
    return component.switch if component.instances > 1 else None


def _reader(component: Component, channel: AdcChannel, system: System) -> ReaderView:
    switch = _switch(component)
    return ReaderView(
        component=component.name,
        instances=component.instances,
        several=component.instances > 1,
        gpio=channel.gpio,
        gpios=system.gpios(component, channel),
        pin=parameter_attribute(channel.pin.name) if channel.pin else None,
        gpio_expression=parameter_expression(channel.pin, "parameters") if channel.pin else str(channel.gpio),
        switch_expression=parameter_expression(switch, "parameters") if switch else None,
        shift=16 - channel.bits,
        spare_bits=12 - channel.bits,
        full_scale=channel.full_scale,
        samples=channel.samples,
        half=channel.samples // 2,
        read_limit_us=channel.read_limit_us,
        citation=channel.cited("samples"),
        cited={aspect: channel.cited(aspect) for aspect in AdcSpec.ASPECTS},
    )


def _imports(links: tuple[LinkView, ...]) -> tuple[tuple[str, tuple[str, ...]], ...]:
    """What the module imports to open its links: the names of each module."""
    modules = sorted({link.module for link in links})
    return tuple(
        (module, tuple(sorted({each.function for each in links if each.module == module}))) for module in modules
    )


def _link(link: BoardLink) -> LinkView:
    spec = link.spec
    name = quoted(link.name)
    citation = str(link.citation or "")
    if link.kind is LinkKind.UART:
        arguments = (name, f"{spec.uart}", f"tx={spec.tx}", f"rx={spec.rx}", f"baud={spec.baud}", f"size={spec.buffer}")
        return LinkView("serial_port", "open_uart", arguments, citation)
    if link.kind is LinkKind.USB:
        return LinkView("serial_port", "open_usb", (name, f"size={spec.buffer}"), citation)
    udp = (
        name,
        quoted(spec.to or ""),
        f"{spec.udp}",
        f"local_port={spec.local_port}",
        f"credentials={quoted(spec.credentials or '')}",
        f"retry_ms={link.retry_ms}",
        "log=self._log",
    )
    return LinkView("udp_port", "UdpPort", udp, citation)
