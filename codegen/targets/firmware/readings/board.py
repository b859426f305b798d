"""View of board.py: how each measured component is read."""

from collections.abc import Mapping

from codegen.frozen import dataclass
from codegen.model.board_model import MOST_BITS, BoardModel
from codegen.model.program import BoardLink, LinkKind
from codegen.model.spec.board import AdcSpec
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, Reading
from codegen.targets.firmware.families import family_lines
from codegen.targets.firmware.readings.measured_view import FurtherView, further_view
from codegen.targets.imports import either_import, import_lines
from codegen.targets.naming import parameter_attribute, parameter_expression, prose, quoted


@dataclass(frozen=True, slots=True)
class ReaderView:
    """The ADC channel of one reading, whose name is ``component``, and what the mock calls its ``input``.

    ``shift`` turns the 16 bits of read_u16() into counts.

    ``spare_bits`` are the bits of the mocked converter that a count leaves out, ``pin`` is the attribute of the
    parameter that has the pin. ``pins`` are the lines that find the GPIO numbers by instance, None for one left
    alone, and ``called`` the literal of what texts call an input, with {} for the number of the instance.
    """

    component: str
    input: str
    several: bool
    gpio: int
    gpios: tuple[int, ...]
    pin: str | None
    pins: tuple[str, ...]
    called: str
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
    """The board, its links, and all its readers: the ``first`` of each component, and modules of the ``further`` ones.

    ``hardware`` is its name with that of the microcontroller, ``opened`` the expression that opens an input.

    ``head`` are the lines above the class, with an empty one behind the imports and behind the constants. ``adc_pins``
    are the GPIO numbers that the converter measures, ``watchdog`` the lines that tell the mock what the
    board's watchdog can do, ``mocks`` modules that stand in for further hardware on a host.
    """

    board: str
    hardware: str
    readers: tuple[ReaderView, ...]
    first: tuple[ReaderView, ...]
    opened: str
    further: tuple[FurtherView, ...]
    head: tuple[str, ...]
    links: tuple[LinkView, ...]
    has_pins: bool
    adc_pins: tuple[int, ...]
    watchdog: str = ""
    mocks: tuple[str, ...] = ()


def board_view(system: System) -> BoardView:
    """The view of the whole module."""
    readers = reader_views(system)
    first = tuple(each for each, reading in zip(readers, system.readings(), strict=True) if reading.is_first)
    links = tuple(_link(link, system.board) for link in system.links)
    has_pins = any(_pin_parameters(system))
    head = (*_imports(first, links, has_pins=has_pins), *_readings(system, first), *_families(system))
    return BoardView(
        board=prose(system.board.name if system.board else system.board_name),
        hardware=prose(system.board_name),
        readers=readers,
        first=first,
        opened=system.board.adc.opened if system.board and system.board.adc else "",
        further=tuple(further_view(reading, "parameters") for reading in system.readings() if not reading.is_first),
        head=head if first else head[:-1],  # without readings nothing stands between the imports and the class
        links=links,
        has_pins=has_pins,
        adc_pins=tuple(sorted(system.board.adc.pins & system.board.free)) if system.board and system.board.adc else (),
        watchdog=_watchdog(system),
    )


def _watchdog(system: System) -> str:
    watchdog = system.board.watchdog if system.board else None
    if watchdog is None:
        return ""
    timeouts = f"machine.watchdog_range_ms = ({watchdog.shortest_ms}, {watchdog.longest_ms})"
    return f"{timeouts}\nmachine.cause_of_restart = {watchdog.spec.restart}"


def _imports(readers: tuple[ReaderView, ...], links: tuple[LinkView, ...], *, has_pins: bool) -> tuple[str, ...]:
    """Return what the module imports to read and to open its links, with an empty
    line behind it; nothing without both.
    """
    modules = ["machine"] if readers else []
    names = [(link.module, link.function) for link in links]
    names += [("adc_inputs", "AdcInputs")] if readers else []
    if has_pins:
        names.append(("parameters", "Parameters"))
    return (*import_lines(modules, names), "") if modules or names else ()


def _readings(system: System, readers: tuple[ReaderView, ...]) -> tuple[str, ...]:
    """The import of what makes the functions that take readings, with an empty line behind it."""
    names = sorted(f"{reader.component}_reading" for reader in readers)
    return (*either_import("samples", names, machine_code=system.spec.project.machine_code), "") if names else ()


def _families(system: System) -> tuple[str, ...]:
    """The parameters that have the pin of each instance and that switch it on, with an empty line behind them."""
    lines = family_lines(parameter for parameter in _pin_parameters(system) if parameter.siblings)
    return (*lines, "") if lines else ()


def _pin_parameters(system: System) -> tuple[Parameter, ...]:
    """The parameters that have a pin or that switch it on, once each."""
    used: dict[str, Parameter] = {}
    for reading in system.readings():
        channel = reading.conversion.channel
        deciding = channel.when[0] if channel.when else None
        represented = reading.quantity.derivation.represented
        setting = represented.parameter if represented else None
        switches = (channel.pin, _switch(reading.component), deciding, setting) if reading.is_first else (deciding,)
        used |= {each.name: each for each in switches if each}
    return tuple(used.values())


def _switch(component: Component) -> Parameter | None:
    """The parameter that switches one of several instances on: the pin of one that is off is left alone."""
    return component.switch if component.instances > 1 else None


def plain_readers(system: System) -> tuple[ReaderView, ...]:
    """The readers that the tests of whole components are about, in their order: see component_facts.py."""
    plain = {reading.name for reading in system.readings() if reading.is_plain}
    return tuple(reader for reader in reader_views(system) if reader.component in plain)


def reader_views(system: System) -> tuple[ReaderView, ...]:
    """The readers of all readings, in their order."""
    return tuple(reader_view(reading, place, system) for place, reading in enumerate(system.readings()))


def adc_input(reading: str, place: int) -> str:
    """Return what the mock calls the input of a reading: the first of all has the short name."""
    return "adc" if place == 0 else f"{reading}_adc"


def reader_view(reading: Reading, place: int, system: System) -> ReaderView:
    component, channel = reading.component, reading.conversion.channel
    name, several = reading.name, component.instances > 1
    title = f"{component.name} {{}}" if several else f"the {component.name}"
    return ReaderView(
        component=name,
        input=adc_input(name, place),
        several=several,
        gpio=channel.gpio,
        gpios=system.gpios(component, channel),
        pin=parameter_attribute(channel.pin.name) if channel.pin else None,
        pins=_pins(reading),
        called=quoted(title if reading.is_first else f"{title}'s {reading.quantity.name}"),
        shift=16 - channel.bits,
        spare_bits=MOST_BITS - channel.bits,
        full_scale=channel.full_scale,
        samples=channel.samples,
        half=channel.samples // 2,
        read_limit_us=channel.read_limit_us,
        citation=channel.cited("samples"),
        cited={aspect: channel.cited(aspect) for aspect in AdcSpec.ASPECTS},
    )


def _is_on(reading: Reading) -> str:
    """The condition with which an instance is read; "" for always."""
    component, when = reading.component, reading.conversion.channel.when
    switch = _switch(component)
    conditions = []
    if when is not None:
        conditions.append(f"{parameter_expression(when[0], 'parameters')} == {when[1]}")
    represented = reading.quantity.derivation.represented
    others = [] if switch is None or (when is not None and when[0] is switch) else [(switch, 0)]
    others += [(represented.parameter, represented.steps)] if represented is not None else []
    for parameter in {each.name: each for each, _ in others}.values():
        steps = [str(own) for each, own in others if each is parameter]
        test = f"not in ({', '.join(steps)})" if len(steps) > 1 else f"!= {steps[0]}"
        conditions.append(f"{parameter_expression(parameter, 'parameters')} {test}")
    return " and ".join(conditions)


def _pins(reading: Reading) -> tuple[str, ...]:
    """Return what finds the GPIO numbers by instance; None for one whose pin may be somebody else's."""
    component, channel = reading.component, reading.conversion.channel
    gpio = parameter_expression(channel.pin, "parameters") if channel.pin else str(channel.gpio)
    on = _is_on(reading)
    if component.instances == 1:
        return (f"pins = [{gpio} if {on} else None]" if on else f"pins = [{gpio}]",)
    if not on:
        return (f"pins = [{gpio} for instance in range({component.instances})]",)
    return (
        f"pins = [None] * {component.instances}",
        f"for instance in range({component.instances}):",
        f"    if {on}:  # else its pin may be somebody else's",
        f"        pins[instance] = {gpio}",
    )


def _link(link: BoardLink, board: BoardModel | None) -> LinkView:
    spec = link.spec
    name = quoted(link.name)
    citation = str(link.citation or "")
    if link.kind is LinkKind.UART:
        tells_pins = board is not None and board.tells_uart_pins
        pins = (f"tx={spec.tx}", f"rx={spec.rx}") if tells_pins else ()
        arguments = (name, f"{spec.uart}", *pins, f"baud={spec.baud}", f"size={spec.buffer}")
        return LinkView("serial_port", "open_uart" if tells_pins else "open_fixed_uart", arguments, citation)
    if link.kind is LinkKind.USB:
        return LinkView("serial_port", "open_usb", (name, f"size={spec.buffer}"), citation)
    wifi = (f"credentials={quoted(spec.credentials or '')}", f"retry_ms={link.retry_ms}")
    if link.kind is LinkKind.UDP:
        udp = (name, quoted(spec.to or ""), f"{spec.udp}", f"local_port={spec.local_port}", *wifi, "log=self._log")
        return LinkView("udp_port", "UdpPort", udp, citation)
    tcp = (*wifi, f"timeout_ms={link.timeout_ms}", "log=self._log")
    if link.kind is LinkKind.TCP_SERVER:
        server = (name, f"{spec.tcp_server}", f"backlog={spec.tcp_backlog}", *tcp)
        return LinkView("tcp_server", "TcpServer", server, citation)
    return LinkView("tcp_client", "TcpClient", (name, quoted(spec.to or ""), f"{spec.tcp_client}", *tcp), citation)
