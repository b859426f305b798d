"""The programs that a document is about, and what these say of the parameters and rates that it may state."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Protocol, TypeVar

from codegen.model.stated_parameter import StatedParameter
from codegen.model.system import System
from codegen.model.vehicle import Citation, Parameter

_Fact = TypeVar("_Fact")


def programs_about(systems: Sequence[System], document: str) -> tuple[System, ...]:
    """The programs that the document with this path is about, in their order.

    These are the ones in whose specification it is, and of several those in which anything answers to it. All of them
    where it belongs to none, as a page of the documentation does.
    """
    readers = tuple(system for system in systems if system.has_document(document)) or tuple(systems)
    return tuple(system for system in readers if _cites(system, document)) or readers


def stated_rates(systems: Sequence[System], document: str = "") -> dict[str, tuple[Fraction, ...]]:
    """Return by message the rates in Hz of its streams, until somebody changes them; without those never sent.

    Of a message those tables count that the document is about: what answers to it, else those of its programs.
    """
    found: dict[str, list[tuple[System, bool, Fraction]]] = {}
    for system in systems:
        for message in system.messages:
            if message.stream is not None and message.stream.default_rate:
                asked = _is_in(document, message.citation, message.stream.citation, *message.aspects.values())
                found.setdefault(message.wire.name, []).append((system, asked, message.stream.default_rate))
    about = programs_about(systems, document)
    return {name: tuple(sorted(set(_meant(facts, about)))) for name, facts in found.items()}


def stated_parameters(systems: Sequence[System], document: str = "") -> dict[str, tuple[StatedParameter, ...]]:
    """Return by name each program's parameter, in the order of the programs: those that the document is about."""
    found: dict[str, list[tuple[System, bool, StatedParameter]]] = {}
    for system in systems:
        for index, name in enumerate(sorted(system.parameters)):
            parameter = system.parameters[name]
            stated = _stated(parameter, index, len(system.parameters))
            found.setdefault(name, []).append((system, _is_in(document, parameter.citation), stated))
    about = programs_about(systems, document)
    return {name: tuple(_meant(facts, about)) for name, facts in found.items()}


def _stated(parameter: Parameter, index: int, count: int) -> StatedParameter:
    default, low, high = (step * parameter.step for step in (parameter.default, parameter.minimum, parameter.maximum))
    return StatedParameter(
        name=parameter.name,
        unit=parameter.unit,
        default=default,
        minimum=low,
        maximum=high,
        step=parameter.step,
        type=parameter.spec.type.value.upper(),
        index=index,
        count=count,
    )


def _meant(facts: Sequence[tuple[System, bool, _Fact]], about: Sequence[System]) -> Iterable[_Fact]:
    """The facts that answer to a document, else those of the programs that it is ``about``, else all."""
    answering = [fact for _, is_asked, fact in facts if is_asked]
    own = [fact for system, _, fact in facts if any(system is each for each in about)]
    return answering or own or [fact for _, _, fact in facts]


def _cites(system: System, document: str) -> bool:
    return any(_is_in(document, citation) for citation in _citations(system))


def _is_in(document: str, *citations: Citation | None) -> bool:
    return any(each is not None and each.requirement.place.file == document for each in citations)


class _Asked(Protocol):
    """A part of a program that criteria ask for."""

    @property
    def citation(self) -> Citation | None: ...

    @property
    def aspects(self) -> Mapping[str, Citation]: ...


def _citations(system: System) -> Iterator[Citation | None]:
    """Everything that parts of a program answer to."""
    yield from (parameter.citation for parameter in system.parameters.values())
    yield from (stream.citation for stream in system.streams.values())
    yield from (link.citation for link in system.links)
    for part in _parts(system):
        yield from (part.citation, *part.aspects.values())
    if system.program is not None:
        yield from system.program.cited.values()
        for aspects in system.program.aspects.values():
            yield from aspects.values()


def _parts(system: System) -> Iterator[_Asked]:
    yield from system.messages
    yield from system.receptions
    yield from system.generations
    yield from system.channels.values()
    yield from (source.polling for source in system.sources.values())
    for component in system.components.values():
        yield component
        yield from component.quantities.values()
    if system.program is not None:
        yield from system.program.failsafes
        yield from system.program.commands
