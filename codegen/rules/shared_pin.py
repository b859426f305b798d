"""Pins that are used twice: by inputs of the converter, by UARTs, by buses and by sensors."""

from collections.abc import Iterator, Mapping

from codegen.diagnostics import Diagnostic, Rule
from codegen.frozen import dataclass
from codegen.model.system import System
from codegen.model.vehicle import AdcChannel, Component, Parameter
from codegen.source import Place

RULE = Rule(
    "shared-pin",
    "Two parts are connected to the same pin: two instances of a component, so that both show one value, two UARTs, "
    "sensors, or a UART and an input of the converter. Only devices on one bus share its lines. Give each a pin of its "
    "own, an instance by a parameter for_each instance and the defaults in board.yaml, or switch one off by default.",
)


@dataclass(frozen=True, slots=True)
class _Use:
    """What is connected to a pin: ``owner`` in words, where that is written, the pins that could be taken instead.

    What ``rests`` is switched off by default: its pin may be shared, and is no good one to move to.
    """

    gpio: int
    owner: str
    place: Place
    others: frozenset[int]
    parameter: str
    named: Place | None = None
    rests: bool = False


def check(system: System) -> Iterator[Diagnostic]:
    """Every pin in use, with what is switched on by default."""
    known = [*_converter(system), *_links(system), *_sensors(system)]
    uses = [use for use in known if not use.rests]
    resting = {use.gpio: use.owner for use in known if use.rests}
    taken = {use.gpio for use in uses}
    owners: dict[int, _Use] = {}
    for use in uses:
        first = owners.setdefault(use.gpio, use)
        if first is use:
            continue
        free = sorted(use.others - taken, key=lambda gpio: (gpio in resting, gpio))
        taken |= set(free[:1])  # so that no two hints name the same pin
        related = [(first.place, f"{first.owner} takes it here")]
        related += [] if use.named is None else [(use.named, "the ADC channel is named here")]
        message = f"{first.owner} and {use.owner} are both on GPIO {use.gpio}"
        yield Diagnostic(use.place, RULE, message, _hint(use, free, resting, system), tuple(related))


def _hint(use: _Use, free: list[int], resting: Mapping[int, str], system: System) -> str:
    assert system.board is not None
    if not free:
        return f"no other pin of the {system.board.name} that could take its place is free"
    hint = f"{use.parameter}: {free[0]}" if use.parameter else f"GPIO {free[0]} is free"
    return f"{hint}, as long as {resting[free[0]]} is switched off" if free[0] in resting else hint


def _converter(system: System) -> Iterator[_Use]:
    """The inputs of each instance; one channel may serve several components."""
    seen: set[tuple[str, int]] = set()
    for name, quantity, conversion in system.measured():
        component = system.components[name]
        channel = conversion.channel
        assert system.board is not None
        assert system.board.adc is not None
        inputs = system.board.adc.pins & system.board.free
        for number, gpio in enumerate(system.gpios(component, channel)):
            is_shared = not number and (channel.name, gpio) in seen
            if is_shared:
                continue
            rests = _is_off(system, component, number) or _is_unread(system, channel, number)
            if not rests:
                seen.add((channel.name, gpio))
            written = system.spec.board.instances.get(name, ())
            place = written[number].place if number < len(written) else component.spec.place
            owner = f"{name} {number + 1}" if component.instances > 1 else name
            owner = owner if quantity is component.readings[0].quantity else f"{quantity.name} of {owner}"
            parameter = _parameter(channel.pin, number)
            yield _Use(gpio, owner, place, inputs, parameter, quantity.spec.at("adc"), rests)


def _links(system: System) -> Iterator[_Use]:
    for link in system.links:
        uart = None if system.board is None or link.spec.uart is None else system.board.uarts.get(link.spec.uart)
        if uart is None or system.board is None:
            continue
        for key, pin, pins in (("tx", link.spec.tx, uart.tx), ("rx", link.spec.rx, uart.rx)):
            if pin is not None:
                yield _Use(pin, f"{key} of {link.name}", link.spec.at(key), pins & system.board.free, key)


def _sensors(system: System) -> Iterator[_Use]:
    """The pins of sensors; the lines of a bus once."""
    seen: set[tuple[int, str]] = set()
    for source in system.sources.values():
        for pin in source.pins():
            if pin.shared and (pin.gpio, pin.shared) in seen:
                continue
            seen.add((pin.gpio, pin.shared))
            place = source.polling.spec.at(pin.key)
            yield _Use(pin.gpio, f"{pin.key} of {source.name}", place, pin.choices, pin.key)


def _is_off(system: System, component: Component, number: int) -> bool:
    """Whether an instance is switched off by default."""
    switch = component.switch
    if switch is None:
        return False
    own = switch.siblings[number] if switch.siblings else switch.name
    return system.parameters.get(own, switch).default == 0


def _is_unread(system: System, channel: AdcChannel, number: int) -> bool:
    """Whether the channel is not read with the default of the parameter that decides it."""
    if channel.when is None:
        return False
    switch, steps = channel.when
    own = switch.siblings[number] if switch.siblings else switch.name
    return system.parameters.get(own, switch).default != steps


def _parameter(pin: Parameter | None, number: int) -> str:
    """The parameter whose default is the pin of an instance."""
    if pin is None:
        return ""
    return pin.siblings[number] if pin.siblings else pin.name
