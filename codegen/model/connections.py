"""The connections to the pins of the board: inputs of the converter, UARTs of links, buses and sensors."""

from collections.abc import Iterator

from codegen.frozen import dataclass
from codegen.model.system import System
from codegen.model.vehicle import Component, Parameter, Reading
from codegen.source import Place


@dataclass(frozen=True, slots=True)
class Connection:
    """A connection to a pin: ``owner`` in words, its place, and the ``others``, pins that could be taken instead.

    ``parameter`` is the key or the parameter that says the pin, ``named`` where a quantity names its ADC channel. What
    ``rests`` is switched off by the default of the parameter ``switch``: its pin may be shared, and is no good one to
    move to. An input of the converter has its ``reading`` and which ``instance`` it is, anything else the name of the
    link or the sensor, ``device``; ``bus`` is what several of these share.
    """

    gpio: int
    owner: str
    place: Place
    others: frozenset[int]
    parameter: str
    named: Place | None = None
    switch: str = ""
    reading: Reading | None = None
    instance: int = 0
    device: str = ""
    bus: str = ""

    @property
    def rests(self) -> bool:
        """Return whether nothing is read there by default."""
        return bool(self.switch)


def connections(system: System) -> Iterator[Connection]:
    """All of them, inputs of the converter first; none without a board."""
    yield from _converter(system)
    yield from _links(system)
    yield from _sensors(system)


def _converter(system: System) -> Iterator[Connection]:
    """The inputs of each instance; one channel may serve several components."""
    seen: set[tuple[str, int]] = set()
    for reading in system.readings():
        component, quantity, channel = reading.component, reading.quantity, reading.conversion.channel
        name = component.name
        assert system.board is not None
        assert system.board.adc is not None
        inputs = system.board.adc.pins & system.board.free
        for number, gpio in enumerate(system.gpios(component, channel)):
            is_shared = not number and (channel.name, gpio) in seen
            if is_shared:
                continue
            switch = _is_off(system, component, number) or _is_unread(system, reading, number)
            if not switch:
                seen.add((channel.name, gpio))
            written = system.spec.board.instances.get(name, ())
            place = written[number].place if number < len(written) else component.spec.place
            owner = f"{name} {number + 1}" if component.instances > 1 else name
            owner = owner if reading.is_first else f"{quantity.name} of {owner}"
            parameter = "" if channel.pin is None else _own(channel.pin, number)
            named = quantity.spec.at("adc")
            yield Connection(gpio, owner, place, inputs, parameter, named, switch, reading, number)


def _links(system: System) -> Iterator[Connection]:
    for link in system.links:
        uart = None if system.board is None or link.spec.uart is None else system.board.uarts.get(link.spec.uart)
        if uart is None or system.board is None:
            continue
        for key, pin, pins in (("tx", link.spec.tx, uart.tx), ("rx", link.spec.rx, uart.rx)):
            if pin is not None:
                owner, free = f"{key} of {link.name}", pins & system.board.free
                yield Connection(pin, owner, link.spec.at(key), free, key, device=link.name)


def _sensors(system: System) -> Iterator[Connection]:
    """The pins of sensors; the lines of a bus once."""
    seen: set[tuple[int, str]] = set()
    for source in system.sources.values():
        for pin in source.pins():
            if pin.shared and (pin.gpio, pin.shared) in seen:
                continue
            seen.add((pin.gpio, pin.shared))
            place = source.polling.spec.at(pin.key)
            owner = f"{pin.key} of {source.name}"
            yield Connection(pin.gpio, owner, place, pin.choices, pin.key, device=source.name, bus=pin.shared)


def _is_off(system: System, component: Component, number: int) -> str:
    """The parameter that switches an instance off by default; empty where it is on."""
    switch = component.switch
    return "" if switch is None or _default(system, switch, number) != 0 else _own(switch, number)


def _is_unread(system: System, reading: Reading, number: int) -> str:
    """The parameter whose default decides that the channel is not read; empty where it is."""
    represented, channel = reading.quantity.derivation.represented, reading.conversion.channel
    if represented and _default(system, represented.parameter, number) == represented.steps:
        return _own(represented.parameter, number)
    if channel.when is None:
        return ""
    switch, steps = channel.when
    return "" if _default(system, switch, number) == steps else _own(switch, number)


def _default(system: System, parameter: Parameter, number: int) -> int:
    """The default that a parameter has for an instance, in steps."""
    return system.parameters.get(_own(parameter, number), parameter).default


def _own(parameter: Parameter, number: int) -> str:
    """The name that a parameter has for an instance."""
    return parameter.siblings[number] if parameter.siblings else parameter.name
