"""UARTs, buses and addresses that two parts take, though only one can have them."""

from collections.abc import Iterator
from fractions import Fraction

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.quantities.source_kind import Source
from codegen.model.system import System
from codegen.model.units.unit import decimal
from codegen.source import Place

RULE = Rule(
    "shared-port",
    "Two parts take what only one can have: a UART, by a link to ground stations or a sensor; an address on an I2C "
    "bus; or one bus is said to be on different pins, or to have different clocks, of which the last that is set up "
    "would count for all. Give each its own, and let all sensors of a bus say the frequency of the slowest.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every sensor against the links and the sensors before it."""
    owners: dict[str, tuple[str, Place]] = {}
    clocks: dict[str, tuple[int, Source, Place]] = {}
    lines: dict[str, tuple[int, Source, Place]] = {}
    for link in system.links:
        if link.spec.uart is not None:
            owners[f"UART {link.spec.uart}"] = link.name, link.spec.at("uart")
    for source in system.sources.values():
        spec = source.polling.spec
        for port, key in ((source.port, "uart"), (source.place, "address")):
            if not port:
                continue
            place = spec.at(f"keys.{key}" if f"keys.{key}" in spec.places else key)  # of an own driver
            owner, first = owners.setdefault(port, (source.name, place))
            if first is not place:
                message = f"{owner} and {source.name} both take {port}"
                hint = f"give {source.name} another {'UART' if key == 'uart' else 'address'}"
                yield Diagnostic(place, RULE, message, hint, ((first, f"{owner} takes it here"),))
        yield from _other_clock(source, clocks)
        for pin in source.pins():
            if not pin.shared:
                continue
            place = spec.at(pin.key)
            gpio, other, first = lines.setdefault(pin.shared, (pin.gpio, source, place))
            if gpio != pin.gpio:
                message = f"{pin.shared} is GPIO {gpio} for {other.name}, and GPIO {pin.gpio} for {source.name}"
                hint = f"{pin.key}: {gpio}"
                yield Diagnostic(place, RULE, message, hint, ((first, f"{other.name} says it here"),))


def _other_clock(source: Source, clocks: dict[str, tuple[int, Source, Place]]) -> Iterator[Diagnostic]:
    """Yield that a bus has had another clock for a sensor before, at the sensor that wants the faster one."""
    if source.clock is None:
        return
    bus, frequency, key = source.clock
    place = source.polling.spec.at(key)
    slower, other, there = clocks.setdefault(bus, (frequency, source, place))
    faster = source
    if frequency < slower:
        clocks[bus] = (frequency, source, place)
        slower, frequency, other, faster, there, place = frequency, slower, source, other, place, there
    if slower != frequency:
        message = f"{bus} runs at {_shown(slower)} for {other.name}, and at {_shown(frequency)} for {faster.name}"
        related = ((there, f"{other.name} says it here"),)
        yield Diagnostic(place, RULE, message, f"frequency: {_shown(slower)}", related)


def _shown(frequency: int) -> str:
    return f"{decimal(Fraction(frequency, 1000))} kHz"
