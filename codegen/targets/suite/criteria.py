"""The criteria that the checks of the program show: only those that the specification names for their aspects.

A check knows aspects such as ``control.grid``, and no number of any document: ``criteria:`` at the sections of the
specification says which criterion asks for each. A check of an aspect that nobody names is run, and is no evidence.
"""

from collections.abc import Iterator, Mapping

from codegen.model.failsafe import Failsafe
from codegen.model.program import Program
from codegen.model.system import System
from codegen.model.vehicle import Citation
from codegen.targets.suite.facts.failsafes import pairs

_Cited = tuple[str, Citation]


def check_criteria(system: System, program: Program) -> dict[str, tuple[str, ...]]:
    """Return by aspect, ``section.aspect``, the criteria that its checks show."""
    found: dict[str, dict[str, None]] = {}
    for aspect, citation in _cited(system, program):
        found.setdefault(aspect, {})[str(citation)] = None
    return {aspect: tuple(criteria) for aspect, criteria in sorted(found.items())}


def _cited(system: System, program: Program) -> Iterator[_Cited]:
    for section, aspects in program.aspects.items():
        yield from _named(section, aspects)
    yield from _of_commands(program)
    for failsafe in program.failsafes:
        yield from _of_failsafe(failsafe)
    for failsafe in pairs(system, program):
        yield from _of_pair(failsafe)
        yield from _named("pair", program.aspects.get("arming", {}))
    for name, _, conversion in system.measured():
        component = system.components[name]
        yield from _named("component", component.aspects)
        yield from _named("reading", conversion.channel.aspects)
        for quantity in component.quantities.values():
            yield from _named("quantity", quantity.aspects)
    for stream in system.streams.values():
        if stream.citation is not None:
            yield f"streams.{'fixed' if stream.parameter is None else 'rate'}", stream.citation
    for generations in system.generations:
        yield from _named("generations", generations.aspects)
    for message in system.messages:
        yield from _named("message", message.aspects)


def _of_commands(program: Program) -> Iterator[_Cited]:
    for command in program.commands:
        if command.citation is not None:
            yield "command.done", command.citation
        yield from _named("command", command.aspects)
    for mode in program.modes:
        if mode.citation is not None:
            yield "mode.change", mode.citation


def _of_failsafe(failsafe: Failsafe) -> Iterator[_Cited]:
    yield from _named("failsafe", failsafe.aspects)
    for level in failsafe.levels:
        if level.citation is not None:
            yield from ((f"failsafe.{condition.sense.value}", level.citation) for condition in level.conditions)


def _of_pair(failsafe: Failsafe) -> Iterator[_Cited]:
    """Yield what the checks of two levels show, which are left out for other failsafes."""
    yield from _named("pair", failsafe.aspects)
    for aspect, level in zip(("first", "second"), failsafe.levels, strict=True):
        if level.citation is not None:
            yield f"pair.{aspect}", level.citation


def _named(section: str, aspects: Mapping[str, Citation]) -> Iterator[_Cited]:
    return ((f"{section}.{aspect}", citation) for aspect, citation in aspects.items())
