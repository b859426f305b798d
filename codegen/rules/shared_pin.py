"""Pins that are used twice: by inputs of the converter, by UARTs, by buses and by sensors."""

from collections.abc import Iterator, Mapping

from codegen.diagnostics import Diagnostic, Rule
from codegen.model.connections import Connection, connections
from codegen.model.system import System

RULE = Rule(
    "shared-pin",
    "Two parts are connected to the same pin: two instances of a component, so that both show one value, two UARTs, "
    "sensors, or a UART and an input of the converter. Only devices on one bus share its lines. Give each a pin of its "
    "own, an instance by a parameter for_each instance and the defaults in board.yaml, or switch one off by default.",
)


def check(system: System) -> Iterator[Diagnostic]:
    """Every pin in use, with what is switched on by default."""
    known = [*connections(system)]
    uses = [use for use in known if not use.rests]
    resting = {use.gpio: use.owner for use in known if use.rests}
    taken = {use.gpio for use in uses}
    owners: dict[int, Connection] = {}
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


def _hint(use: Connection, free: list[int], resting: Mapping[int, str], system: System) -> str:
    assert system.board is not None
    if not free:
        return f"no other pin of the {system.board.name} that could take its place is free"
    hint = f"{use.parameter}: {free[0]}" if use.parameter else f"GPIO {free[0]} is free"
    return f"{hint}, as long as {resting[free[0]]} is switched off" if free[0] in resting else hint
